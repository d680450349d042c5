/* Material properties by name, given by `fix property/global`: one number, one per atom type, or one
 * per pair of atom types. */
#ifndef TS_MATERIAL_PROPERTY_H
#define TS_MATERIAL_PROPERTY_H

#include "core/sim.h"

enum ts_property_kind {
	TS_PROPERTY_SCALAR,
	TS_PROPERTY_VECTOR, /* list of numbers */
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

/* Property of this name and the fix that gives it; NULL: not given. */
const struct ts_property *ts_property_find(const struct tsim *sim, const char *name,
					   const struct ts_instance **by);

/* Whether the property is given by a fix or a material file: `if property_NAME`. */
bool ts_property_given(const struct tsim *sim, const char *name);

/* Value for one atom type (b = 0), a pair of types, or for all (a = b = 0); types are counted from 1. A
 * scalar applies to all types. The error message names `who` requires it and how to give it. */
enum ts_status ts_property_value(struct tsim *sim, const char *name, int a, int b, const char *who,
				 const struct ts_place *where, double *out);

/* Place in the script or file of that value, for error messages. */
const struct ts_place *ts_property_place(const struct tsim *sim, const char *name, int a, int b);

#endif
