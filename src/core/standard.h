/* Computes that stand for the temperature and the pressure of the keywords temp, press, pxx ...
 * (thermo_modify temp, press). */
#ifndef TS_CORE_STANDARD_H
#define TS_CORE_STANDARD_H

#include "core/sim.h"

/* Makes the compute stand for the keyword; NULL: none. It must give a number of this unit. */
enum ts_status ts_standard_set(struct tsim *sim, enum ts_standard which, const struct ts_word *id);
/* Its number, or with k >= 0 the k-th of its vector; *replaced is false where no compute stands for it. */
enum ts_status ts_standard_value(struct tsim *sim, enum ts_standard which, int k, bool *replaced,
				 double *out);

#endif
