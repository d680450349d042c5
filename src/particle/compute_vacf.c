/* Compute vacf: velocity autocorrelation function. */
#include "particle/group_moments.h"
#include "particle/reference.h"

#include "base/banned.h"

struct vacf {
	struct ts_reference start;
	struct tsim *sim;
};

static void store_velocity(const struct ts_instance *self, const struct tsim *sim, size_t i, double now[3])
{
	(void)self;
	for (int d = 0; d < 3; d++)
		now[d] = sim->particles->v[i][d];
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct vacf *s = self->state;

	s->sim = sim;
	return ts_reference_init(self, sim, &s->start, store_velocity);
}

static enum ts_status store_new_references(struct ts_instance *self, struct tsim *sim)
{
	ts_reference_add(sim, &((struct vacf *)self->state)->start);
	return TS_OK;
}

static void velocity_product_terms(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const double *v0 = ts_reference_of(sim, context, i);

	for (int d = 0; d < 3; d++)
		term[d] = sim->particles->v[i][d] * v0[d];
	term[3] = term[0] + term[1] + term[2];
	term[4] = 1;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct vacf *s = self->state;
	double sum[5];

	TS_TRY(store_new_references(self, s->sim));
	ts_group_sum(sim, self->group, 5, velocity_product_terms, &s->start, sum);
	for (int k = 0; k < 4; k++)
		out->data[k] = sum[4] > 0 ? sum[k] / sum[4] : 0;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_reference_archive(a, sim, &((struct vacf *)self->state)->start);
}

static const char *const names[] = { "x", "y", "z", "total", NULL };
static const struct ts_value values[] = {
	{ "vacf", "velocity^2", "mean of v v0 in x, y, z, and their sum", TS_VECTOR, 4, names, eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_vacf)
const struct ts_style ts_compute_vacf = {
	.name = "vacf",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_OWN | TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Velocity autocorrelation function",
	.doc = "Mean of the product v v0 over the particles of the group. v0 is the velocity when the "
	       "compute was defined, or when the particle was inserted if that was later. Reference "
	       "velocities are written to restart files.",
	.example = "compute memory all vacf\nfix series all vector 10 c_memory[4]",
	.state_size = sizeof(struct vacf),
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_BUILD] = store_new_references, [TS_STAGE_SETUP] = store_new_references },
};
