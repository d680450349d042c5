/* The columns of numbers that the user keeps with fix property/atom. */
#ifndef TS_PARTICLE_USER_COLUMNS_H
#define TS_PARTICLE_USER_COLUMNS_H

#include "particle/particles.h"

enum { TS_MOST_USER_COLUMNS = 64 };

/* First member of the state of the fix. */
struct ts_user_columns {
	size_t column[TS_MOST_USER_COLUMNS], n; /* columns of the particles */
	size_t width;				/* numbers in all of them */
	const char *title;			/* of their section in data files; NULL: not written */
};

/* Of a fix of this style; an error says that another was named. */
enum ts_status ts_user_columns_of(struct tsim *sim, const struct ts_word *id, const char *what,
				  const struct ts_user_columns **out);
/* All numbers of particle i, column after column. */
void ts_user_columns_get(const struct ts_particles *p, const struct ts_user_columns *columns, size_t i,
			 double *value);
void ts_user_columns_set(struct ts_particles *p, const struct ts_user_columns *columns, size_t i,
			 const double *value);

#endif
