/* Shared by the dumps of surfaces (meshes, height fields): outputs with a row for each element of a surface, written as
 * arrays of a VTK file. */
#ifndef TS_DUMP_DUMP_SURFACE_H
#define TS_DUMP_DUMP_SURFACE_H

#include "core/ref_list.h"
#include "core/sim.h"

struct ts_dump_surface_inputs {
	struct ts_words names;	 /* words of the line that name outputs: f_ID[k], f_ID[*], c_ID[k] ... */
	struct ts_ref_list list; /* the outputs */
	struct ts_table values;	 /* one of them: a row for each element */
};

/* Whether the dump writes the surface of the fix `by`. */
typedef bool ts_dump_surface_writes_fn(const struct ts_instance *self, const struct ts_instance *by);

/* In init: finds the outputs; fails if one is about a surface that the dump does not write. */
enum ts_status ts_dump_surface_find(struct ts_instance *self, struct tsim *sim,
				    ts_dump_surface_writes_fn *writes, struct ts_dump_surface_inputs *in);
/* The fix of the surface that output k is about. */
const struct ts_instance *ts_dump_surface_of(const struct ts_dump_surface_inputs *in, size_t k);
/* Evaluates output k into in->values; fails unless it has a row for each of these elements. */
enum ts_status ts_dump_surface_eval(struct tsim *sim, struct ts_dump_surface_inputs *in, size_t k,
				    size_t elements);
void ts_dump_surface_release(struct ts_dump_surface_inputs *in);

#endif
