/* Compute active/paml: active particles in polishing, found in a simulation of particles, pad, wafer and slurry. */
#include <math.h>

#include "math/exactsum.h"
#include "particle/particles.h"
#include "wall/squeeze.h"

#include "base/banned.h"

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

struct count {
	double all, active;
	double force, most; /* sum and largest of those that squeeze active particles */
};

static enum ts_status count(struct ts_instance *self, const struct tsim *sim, struct count *out)
{
	struct ts_squeeze *s = self->state;
	struct ts_exactsum sum = ts_exactsum_start();

	*out = (struct count){ .all = 0 };
	TS_TRY(ts_squeeze_find_forces(self, s));
	for (size_t i = 0; i < sim->particles->n; i++) {
		double force = ts_squeeze_force(s, i);

		out->all += ts_in_group(sim->particles, i, self->group);
		out->active += force > 0;
		ts_exactsum_add(&sum, force);
		out->most = fmax(out->most, force);
	}
	out->force = ts_exactsum_value(&sum);
	return TS_OK;
}

static enum ts_status eval_active(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct count c;

	TS_TRY(count(self, sim, &c));
	out->data[0] = c.active;
	return TS_OK;
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct count c;

	TS_TRY(count(self, sim, &c));
	out->data[0] = out->data[1] = c.all;
	out->data[2] = c.active;
	out->data[3] = c.active > 0 ? c.force / c.active : 0;
	out->data[4] = c.force;
	out->data[5] = c.most;
	return TS_OK;
}

static const char *const names[] = { "all", "eligible", "active", "mean_force", "force", "most" };

static const struct ts_value values[] = {
	{ "active", "-", "number of active particles", TS_SCALAR, 1, NULL, eval_active },
	{ "numbers", "-, -, -, force, force, force",
	  "number of particles in the gap, of those eligible, and of the active ones; mean force that "
	  "squeezes an active particle (0 if there is none), sum of these forces, the largest of them",
	  TS_VECTOR, 6, names, eval_numbers },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_SQUEEZE_ARGS(struct state, squeeze),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_active_paml)
const struct ts_style ts_compute_active_paml = {
	.name = "active/paml",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Active particles in chemical-mechanical polishing: particle-augmented mixed lubrication",
	.doc = "Number of abrasive particles that are pressed between a pad and a wafer in a simulation of "
	       "the particles: contact laws, the motion of the pad or the wafer, and the drag of the slurry "
	       "decide which are. Both walls press on an active particle at once with more than the "
	       "`threshold`; the force of a wall is the sum of the normal forces of its contacts with the "
	       "particle. A particle that the fluid merely drags along a surface is pressed by the drag, of "
	       "the order of 6 pi mu a U: the threshold should be larger than that.\n\n"
	       "All particles of the group are in the gap, and all of them are eligible. Values are those of "
	       "the last force computation: average them over time (fix ave/time).\n\n"
	       "Related: compute active/pml, compute active/pi, compute squeeze/atom, fix insert/gap, fix "
	       "wear/zhao/chang/contact.",
	.example = "fix pad all wall/gran model hertz tangential history primitive type 2 zplane 0.0\n"
		   "fix wafer all wall/gran model hertz tangential history primitive type 3 zplane 5e-7 "
		   "shear x 0.4\n"
		   "compute paml all active/paml pad wafer threshold 1e-8\n"
		   "fix mean all ave/time 1 1000 1000 c_paml c_paml[4] file active.txt",
	.cite = "E. J. Terrell, C. F. Higgs III, J. Tribol. 131 (2009) 012201",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
