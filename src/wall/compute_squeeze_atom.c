/* Compute squeeze/atom: the forces with which two walls squeeze particles. */
#include "particle/particles.h"
#include "wall/squeeze.h"

#include "base/banned.h"

enum { COLUMNS = 3 };

struct state {
	struct ts_squeeze squeeze;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_squeeze_init(self, sim, self->state);
}

static void fini(struct ts_instance *self)
{
	ts_squeeze_release(self->state);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_squeeze *s = self->state;

	TS_TRY(ts_squeeze_find_forces(self, s));
	TS_TRY(ts_table_resize(out, sim->particles->n, COLUMNS));
	for (size_t i = 0; i < sim->particles->n; i++) {
		double *row = out->data + i * COLUMNS;

		row[0] = ts_squeeze_force(s, i);
		row[1] = s->force[i][0];
		row[2] = s->force[i][1];
	}
	return TS_OK;
}

static const char *const columns[] = { "squeeze", "first", "second" };

static const struct ts_value values[] = {
	{ "forces", "force, force, force",
	  "force that squeezes the particle, 0 if it is not squeezed; normal force of the first and of the "
	  "second wall; 0 for particles outside the group",
	  TS_PERATOM, COLUMNS, columns, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_SQUEEZE_ARGS(struct state, squeeze),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_squeeze_atom)
const struct ts_style ts_compute_squeeze_atom = {
	.name = "squeeze/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Particles squeezed between two walls",
	.doc = "A particle of the group is squeezed if both walls press on it at once with more than the "
	       "`threshold`. The force of a wall is the sum of the normal forces of its contacts with the "
	       "particle, in the last force computation; the smaller of both forces squeezes the "
	       "particle.\n\n"
	       "Walls with `impact exact` are refused.\n\n"
	       "Related: compute active/paml, compute wall/gran/local, fix wall/gran.",
	.example = "fix floor all wall/gran model hertz primitive type 1 zplane 0.0\n"
		   "fix lid all wall/gran model hertz primitive type 1 zplane 0.01\n"
		   "compute nip all squeeze/atom floor lid threshold 1e-9\n"
		   "dump d all custom 100 nip.dump id x y z c_nip[1]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
