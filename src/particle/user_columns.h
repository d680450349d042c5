/* The columns defined by fix property/atom. */
#ifndef TS_PARTICLE_USER_COLUMNS_H
#define TS_PARTICLE_USER_COLUMNS_H

#include "particle/particles.h"

enum { TS_MOST_USER_COLUMNS = 64 };

/* First member of the state of the fix. */
struct ts_user_columns {
	size_t column[TS_MOST_USER_COLUMNS], n; /* n indices in particles->column */
	size_t width;				/* numbers per particle in all columns */
	const char *title;			/* section title in data files; NULL: not written */
};

/* Finds the columns of the fix with this ID; fails if it is not a fix property/atom. */
enum ts_status ts_user_columns_of(struct tsim *sim, const struct ts_word *id, const char *what,
				  const struct ts_user_columns **out);
/* Reads or writes the `width` numbers of particle i, column after column. */
void ts_user_columns_get(const struct ts_particles *p, const struct ts_user_columns *columns, size_t i,
			 double *value);
void ts_user_columns_set(struct ts_particles *p, const struct ts_user_columns *columns, size_t i,
			 const double *value);

#endif
