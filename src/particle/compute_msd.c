/* Compute msd: mean squared displacement. */
#include "group/group_motion.h"
#include "particle/group_moments.h"
#include "particle/reference.h"

#include "math/vec3.h"

#include "base/banned.h"

struct msd {
	bool com, average;
	struct ts_reference start;
	double centre[3]; /* saved: centre of mass when the compute was defined */
	int64_t samples;  /* saved: number of samples in the mean positions */
	int64_t last;	  /* saved: step of the last sample */
	struct tsim *sim;
};

static void unwrapped_position(const struct ts_instance *self, const struct tsim *sim, size_t i,
			       double now[3])
{
	(void)self;
	ts_unwrapped(sim, i, now);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct msd *s = self->state;

	s->sim = sim;
	if (s->start.started)
		return TS_OK;
	if (ts_sim_has_box(sim))
		ts_group_centre(sim, self->group, s->centre);
	s->last = -1;
	return ts_reference_init(self, sim, &s->start, unwrapped_position);
}

static enum ts_status store_new_references(struct ts_instance *self, struct tsim *sim)
{
	ts_reference_add(sim, &((struct msd *)self->state)->start);
	return TS_OK;
}

/* Displacement of particle i minus drift, the displacement of the centre of mass (0 without `com`). */
static void displacement(const struct tsim *sim, const struct msd *s, const double drift[3], size_t i,
			 double d[3])
{
	ts_unwrapped(sim, i, d);
	ts_sub(d, ts_reference_of(sim, &s->start, i), d);
	ts_sub(d, drift, d);
}

struct msd_context {
	const struct msd *s;
	double drift[3];
};

static void squared_displacement_terms(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct msd_context *t = context;
	double d[3];

	displacement(sim, t->s, t->drift, i, d);
	for (int k = 0; k < 3; k++)
		term[k] = d[k] * d[k];
	term[3] = term[0] + term[1] + term[2];
	term[4] = 1;
}

/* Updates the reference to the mean position: x0 += (x - drift - x0) / (samples + 1), once per step. */
static void update_mean_positions(struct ts_instance *self, const double drift[3])
{
	struct msd *s = self->state;
	struct tsim *sim = s->sim;

	if (s->last == sim->clock.step)
		return;
	s->last = sim->clock.step;
	s->samples++;
	for (size_t i = 0; i < sim->particles->n; i++) {
		double d[3];

		displacement(sim, s, drift, i, d);
		ts_axpy(1.0 / (double)(s->samples + 1), d, ts_reference_of(sim, &s->start, i));
	}
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct msd *s = self->state;
	struct msd_context context = { s, { 0 } };
	double sum[5];

	ts_reference_add(s->sim, &s->start);
	if (s->com) {
		ts_group_centre(sim, self->group, context.drift);
		ts_sub(context.drift, s->centre, context.drift);
	}
	if (s->average)
		update_mean_positions(self, context.drift);
	ts_group_sum(sim, self->group, 5, squared_displacement_terms, &context, sum);
	for (int k = 0; k < 4; k++)
		out->data[k] = sum[4] > 0 ? sum[k] / sum[4] : 0;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_reference_archive(a, sim, &((struct msd *)self->state)->start);
}

static const char *const names[] = { "x", "y", "z", "total", NULL };
static const struct ts_value values[] = {
	{ "msd", "length^2", "mean squared displacement in x, y, z, and their sum", TS_VECTOR, 4, names,
	  eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct msd, centre),
	TS_SAVE_I64(struct msd, samples),
	TS_SAVE_I64(struct msd, last),
	TS_SAVED_ROWS_END,
};

static const struct ts_arg args[] = {
	TS_BOOL("com", struct msd, com, .flags = TS_STATEFUL, .fallback = "no",
		.help = "subtract the displacement of the centre of mass of the group"),
	TS_BOOL("average", struct msd, average, .flags = TS_STATEFUL, .fallback = "no",
		.help = "measure from the mean position so far instead of the first one"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_msd)
const struct ts_style ts_compute_msd = {
	.name = "msd",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_OWN | TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Mean squared displacement",
	.doc = "Mean of (x - x0)^2 over the particles of the group. x0 is the position when the compute was "
	       "defined, or when the particle was inserted if that was later. Positions are unwrapped. "
	       "Reference positions are written to restart files.\n\n"
	       "With `average yes` x0 is the mean of all positions at which the compute has been evaluated "
	       "so far, one per step.",
	.example = "compute msd all msd com yes\nthermo_style custom step c_msd[4]",
	.args = args,
	.state_size = sizeof(struct msd),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = store_new_references, [TS_STAGE_SETUP] = store_new_references },
};
