/* Access to the scalar fields that fixes transport with the fluid, by name: f_ID. */
#ifndef TS_FLOW_TRANSPORTED_SCALARS_H
#define TS_FLOW_TRANSPORTED_SCALARS_H

#include "core/name_list.h"
#include "flow/fluid.h"

/* Reads a list of words, each a name of the table (ts_name_list_read) or f_ID of a fix that transports a
 * scalar, whose index is TS_FLOW_SCALAR. */
enum { TS_FLOW_SCALAR = -1 };
enum ts_status ts_flow_read_names(struct tsim *sim, const char *what, struct ts_arena *arena,
				  struct ts_words words, const void *table, size_t stride,
				  struct ts_name_list *out);

/* A scalar field at centres, ghosts set, and on which faces of the grid its value is given: it is the mean of the values on
 * both sides. */
struct ts_flow_scalar {
	const double *value;
	bool given[3][2];
};
/* The present one of the fix f_ID. */
enum ts_status ts_flow_scalar_field(struct tsim *sim, const char *what, const struct ts_word *word,
				    struct ts_flow_scalar *out);
/* The next fix that transports a scalar, *k as in ts_sim_next_of; NULL at the end. */
struct ts_instance *ts_flow_next_scalar(const struct tsim *sim, size_t *k);

#endif
