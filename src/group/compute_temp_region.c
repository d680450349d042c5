/* Compute temp/region: temperature of the particles in a region. */
#include "group/temperature.h"
#include "region/region.h"

#include "base/banned.h"

struct temp_region {
	struct ts_freedom freedom; /* first: see group/temperature.h */
	struct ts_instance *region;
};

static void terms_in_region(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct temp_region *c = context;
	const struct ts_particles *p = sim->particles;
	const bool in = ts_region_contains(c->region, p->x[i]);

	for (int k = 0; k < 6; k++)
		term[k] = in ? p->mass[i] * p->v[i][ts_tensor_row[k]] * p->v[i][ts_tensor_column[k]] : 0;
	term[6] = in;
}

static enum ts_status find_sums(struct ts_instance *self, const struct tsim *sim, double sum[7])
{
	struct temp_region *c = self->state;

	TS_TRY(ts_region_update(c->region, (struct tsim *)sim));
	ts_group_sum(sim, self->group, 7, terms_in_region, c, sum);
	return TS_OK;
}

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct temp_region *c = self->state;
	double sum[7];

	TS_TRY(find_sums(self, sim, sum));
	out->data[0] = ts_temperature(sim, sum, &c->freedom);
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double sum[7];

	TS_TRY(find_sums(self, sim, sum));
	return ts_temperature_write_tensor(sum, out);
}

static const struct ts_arg args[] = {
	TS_REGION("region", struct temp_region, region, .flags = TS_POSITIONAL,
		  .help = "particles outside are excluded"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "temperature", "temperature", "temperature of the particles in the region", TS_SCALAR, 1, NULL,
	  eval_temperature },
	{ "tensor", "energy", "kinetic tensor: sum of m v_a v_b", TS_VECTOR, 6, ts_tensor_names,
	  eval_tensor },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_temp_region)
const struct ts_style ts_compute_temp_region = {
	.name = "temp/region",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature of the particles in a region",
	.doc = "As compute temp for the N particles of the group that are in the region at the time of "
	       "evaluation. A degree of freedom of each axis is subtracted, as there, or what "
	       "`compute_modify "
	       "ID extra M` says.",
	.example = "compute mouth all temp/region outlet",
	.args = args,
	.state_size = sizeof(struct temp_region),
	.values = values,
	.modify = ts_freedom_modify,
};
