/* Pair and bond styles of a restart file that the script has not defined again: as in LIGGGHTS and LAMMPS, a run has those of the
 * file. */
#ifndef TS_CORE_RESTORED_MODELS_H
#define TS_CORE_RESTORED_MODELS_H

#include "core/sim.h"

/* Called before the plan of a run is compiled. Tells in the log what it defines, and what is not defined again. */
enum ts_status ts_restore_models(struct tsim *sim);

#endif
