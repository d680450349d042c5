/* Properties of materials by name, as `fix property/global` gives them: one number, one for each
 * particle type, or one for each pair of types. */
#ifndef TS_MATERIAL_PROPERTY_H
#define TS_MATERIAL_PROPERTY_H

#include "core/sim.h"

enum ts_property_kind {
	TS_PROPERTY_SCALAR,
	TS_PROPERTY_VECTOR, /* numbers of any meaning */
	TS_PROPERTY_TYPE,
	TS_PROPERTY_PAIR, /* columns x columns, symmetric */
	TS_PROPERTY_MATRIX
};

/* First member of the state of fix property/global. */
struct ts_property {
	const char *name;
	int kind;
	double *value;
	size_t n, columns;
};

/* NULL: nobody gave it. */
const struct ts_property *ts_property_find(const struct tsim *sim, const char *name,
					   const struct ts_instance **by);

/* Whether it was given: `if property_NAME` asks. */
bool ts_property_given(const struct tsim *sim, const char *name);

/* The property of one type (b = 0) or a pair of types, counted from 1, or of all (a = b = 0). One
 * number is the same for all.
 * An error names who needs it and how it is given. */
enum ts_status ts_property_value(struct tsim *sim, const char *name, int a, int b, const char *who,
				 const struct ts_place *where, double *out);

/* Where that value is written, for messages about it. */
const struct ts_place *ts_property_place(const struct tsim *sim, const char *name, int a, int b);

#endif
