/* Arguments common to several commands and fixes of the fluid. */
#ifndef TS_FLOW_FLOW_ARGUMENTS_H
#define TS_FLOW_FLOW_ARGUMENTS_H

#include "core/sim.h"

/* Reads three numbers or v_NAMEs; strings go to the arena. */
enum ts_status ts_flow_read_vector(struct tsim *sim, const char *what, struct ts_words words,
				   const struct ts_place *where, struct ts_arena *arena,
				   struct ts_number out[3]);
/* An error if the third of these words, read into `vector`, is not 0 in a grid of one cell along z: nothing flows along z there. */
enum ts_status ts_flow_refuse_depth(struct tsim *sim, const char *what, struct ts_words words,
				    const struct ts_number vector[3]);
/* Reads `x NAME` and so on: internal variables that receive coordinates. */
enum ts_status ts_flow_read_set(struct tsim *sim, const char *what, struct ts_words words,
				const struct ts_place *where, struct ts_arena *arena, const char *out[3]);
/* Sets these variables to the coordinates x. */
enum ts_status ts_flow_set_coordinates(struct tsim *sim, const char *const set[3], const double x[3],
				       const struct ts_place *where);

#endif
