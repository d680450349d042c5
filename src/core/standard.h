/* Computes that replace the temperature and the pressure of the thermo keywords temp, press, pxx ...
 * (thermo_modify temp, press). */
#ifndef TS_CORE_STANDARD_H
#define TS_CORE_STANDARD_H

#include "core/sim.h"

/* Makes a compute replace the keyword; id NULL: none. It must have a scalar output of this unit. */
enum ts_status ts_standard_set(struct tsim *sim, enum ts_standard which, const struct ts_word *id);
/* The scalar of the compute, or with k >= 0 the k-th component of its vector; *replaced is false if there
 * is none. */
enum ts_status ts_standard_value(struct tsim *sim, enum ts_standard which, int k, bool *replaced,
				 double *out);

#endif
