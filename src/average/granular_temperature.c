#include "average/granular_temperature.h"

#include <math.h>
#include <string.h>

#include "particle/group_moments.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

const char *const ts_granular_motions[] = { "translation", "rotation", NULL };
const char *const ts_granular_weights[] = { "number", "mass", NULL };
const char *const ts_granular_means[] = { "none", "uniform", "linear/x", "linear/y", "linear/z", NULL };

static int axis_of(const struct ts_granular *g)
{
	return g->mean >= TS_GRANULAR_LINEAR_X ? g->mean - TS_GRANULAR_LINEAR_X : -1;
}

/* Velocity, or angular velocity times sqrt(I/m): its square is then twice the energy of rotation per mass. */
static void velocity_of(const struct tsim *sim, const struct ts_granular *g, size_t i, double u[3])
{
	const struct ts_particles *p = sim->particles;
	double arm = sqrt(ts_inertia_factor(sim)) * p->radius[i];

	for (int d = 0; d < 3; d++)
		u[d] = g->motion == TS_GRANULAR_TRANSLATION ? p->v[i][d]
		       : p->omega			    ? arm * p->omega[i][d]
							    : 0;
}

void ts_granular_term(const struct tsim *sim, size_t i, const struct ts_granular *granular, int pass,
		      const struct ts_granular_field *field, double term[TS_GRANULAR_WIDTH])
{
	const struct ts_particles *p = sim->particles;
	double w = granular->weight == TS_GRANULAR_MASS ? p->mass[i] : 1, from = 0, u[3];
	int axis = axis_of(granular);

	memset(term, 0, TS_GRANULAR_WIDTH * sizeof *term);
	velocity_of(sim, granular, i, u);
	if (axis >= 0)
		from = p->x[i][axis] - (pass > 1 ? field->at : 0);
	for (int d = 0; pass > 1 && d < 3; d++)
		u[d] -= field->mean[d] + (pass > 2 ? field->slope[d] * from : 0);
	if (pass < 3) {
		for (int d = 0; d < 3; d++)
			term[d] = w * (pass == 1 ? u[d] : u[d] * from);
		term[3] = w * (pass == 1 ? from : from * from);
		term[4] = w;
		term[5] = 1;
		return;
	}
	for (int k = 0; k < 6; k++)
		term[k] = w * u[ts_tensor_row[k]] * u[ts_tensor_column[k]];
}

void ts_granular_enter(const struct ts_granular *granular, int pass, const double sum[TS_GRANULAR_WIDTH],
		       struct ts_granular_field *field)
{
	if (pass == 1) {
		memset(field, 0, sizeof *field);
		field->weight = sum[4];
		field->count = sum[5];
		if (!(field->weight > 0))
			return;
		field->at = sum[3] / field->weight;
	}
	for (int d = 0; d < 3; d++)
		if (pass == 1)
			field->mean[d] = granular->mean == TS_GRANULAR_NONE ? 0 : sum[d] / field->weight;
		else
			field->slope[d] = sum[3] > 0 && axis_of(granular) >= 0 ? sum[d] / sum[3] : 0;
}

void ts_granular_result(const struct tsim *sim, const struct ts_granular *granular,
			const struct ts_granular_field *field, const double sum[TS_GRANULAR_WIDTH],
			double out[TS_GRANULAR_COLUMNS])
{
	static const double fitted[] = { 0, 1, 2, 2, 2 }; /* numbers found for each component; by mean */
	double n = field->count, p = fitted[granular->mean], factor = 0;
	bool disc = sim->dimension == 2;

	if (n > p)
		factor = (granular->unbiased ? n / (n - p) : 1) / field->weight;
	for (int k = 0; k < 6; k++)
		out[1 + k] = factor * sum[k];
	out[0] = disc && granular->motion == TS_GRANULAR_ROTATION ? out[3]
		 : disc						  ? (out[1] + out[2]) / 2
								  : (out[1] + out[2] + out[3]) / 3;
	out[7] = n;
}
