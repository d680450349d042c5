/* What ranks send each other of a fluid of which each has planes and what is near its particles (flow/fluid_near.h). */
#ifndef TS_FLOW_NEAR_EXCHANGE_H
#define TS_FLOW_NEAR_EXCHANGE_H

#include "flow/fluid.h"

/* All ranks call these two, for n fields. What ranks have added to their own cells comes to those that compute the planes, and with
 * `near_too` to those with particles there. */
enum ts_status ts_fluid_near_gather(struct ts_fluid *fluid, double *const *field, size_t n, bool near_too);
/* What ranks have computed comes to those with particles near it, with all ghosts. */
enum ts_status ts_fluid_near_spread(struct ts_fluid *fluid, double *const *field, size_t n);

/* Sets the ghosts of a centred field near the particles of this rank: zero gradient at faces that are not periodic. */
void ts_fluid_near_fill_centred(const struct ts_fluid *fluid, double *field);
/* Count what they send of so many fields, and send nothing (rank/rehearsal.h). */
void ts_fluid_near_count_gather(struct ts_fluid *fluid, size_t fields, bool near_too);
void ts_fluid_near_count_spread(struct ts_fluid *fluid, size_t fields);

#endif
