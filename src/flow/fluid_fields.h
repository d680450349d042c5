/* All fields of a fluid that is solved for, and of the fixes that take part in its steps, by what ranks that have it in planes do
 * with them. */
#ifndef TS_FLOW_FLUID_FIELDS_H
#define TS_FLOW_FLUID_FIELDS_H

#include "flow/projection.h"

enum ts_fluid_fields_use {
	TS_FIELDS_NEAR = 1,  /* a rank has it in its planes and near its particles, others in its planes */
	TS_FIELDS_STEP = 2,  /* computed in each step, and read near particles after it */
	TS_FIELDS_PLACE = 4, /* read near particles, or added to there, before the next step */
	TS_FIELDS_SUM = 8,   /* particles add to it */
	TS_FIELDS_LASTING =
		16 /* the next step, or a restart file, needs it; the others are made anew in each step */
};

enum { TS_FIELDS_MOST = 128 };

/* Lists the fields with one of these uses, those with none of them if `without`; returns their number. Fields that are not
 * used are left out. */
size_t ts_fluid_fields_list(struct ts_projection *projection, const struct tsim *sim, unsigned uses,
			    bool without, double *field[TS_FIELDS_MOST]);

#endif
