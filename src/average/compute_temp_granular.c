/* Compute temp/granular: granular temperature of a group. */
#include "average/granular_temperature.h"
#include "particle/group_moments.h"

#include "base/banned.h"

struct state {
	struct ts_granular granular;
};

struct pass {
	const struct ts_granular *granular;
	const struct ts_granular_field *field;
	int number;
};

static void term_of_pass(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct pass *pass = context;

	ts_granular_term(sim, i, pass->granular, pass->number, pass->field, term);
}

static void evaluate(const struct ts_instance *self, const struct tsim *sim, double out[TS_GRANULAR_COLUMNS])
{
	const struct state *s = self->state;
	struct ts_granular_field field = { 0 };
	double sum[TS_GRANULAR_WIDTH];

	for (int k = 1; k <= 3; k++) {
		struct pass pass = { &s->granular, &field, k };

		ts_group_sum(sim, self->group, TS_GRANULAR_WIDTH, term_of_pass, &pass, sum);
		if (k < 3)
			ts_granular_enter(&s->granular, k, sum, &field);
	}
	ts_granular_result(sim, &s->granular, &field, sum, out);
}

static enum ts_status eval_temperature(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double result[TS_GRANULAR_COLUMNS];

	evaluate(self, sim, result);
	out->data[0] = result[0];
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double result[TS_GRANULAR_COLUMNS];

	evaluate(self, sim, result);
	for (int k = 0; k < 6; k++)
		out->data[k] = result[1 + k];
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "temperature", "velocity^2", "granular temperature", TS_SCALAR, 1, NULL, eval_temperature },
	{ "tensor", "velocity^2", "mean of u'_a u'_b", TS_VECTOR, 6, ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

static const struct ts_arg args[] = { TS_GRANULAR_ROWS(struct state, granular), TS_ARGS_END };

TS_STYLE(compute, ts_style, ts_compute_temp_granular)
const struct ts_style ts_compute_temp_granular = {
	.name = "temp/granular",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Granular temperature",
	.doc = "The granular temperature is the mean square of the velocity fluctuations per direction,\n\n"
	       "    T = <|u - <u>|^2> / D\n\n"
	       "in velocity^2, for D dimensions: per mass and without k_B. <> is the mean over the particles "
	       "of the group, which count alike or by mass. c_ID[k] is the tensor of the fluctuations, <u'_a "
	       "u'_b> with u' = u - <u>, for ab = xx, yy, zz, xy, xz, yz; T is the mean of its diagonal.\n\n"
	       "`mean` chooses the mean velocity: that of the group (`uniform`), 0 (`none`), or for a "
	       "sheared flow the straight line <u>(y) = a + b y with the least squares (`linear/y`; likewise "
	       "x, z). Coordinates are those within the box.\n\n"
	       "With `motion rotation` u is the angular velocity times sqrt(I/m), that is sqrt(0.4) r omega "
	       "for spheres (sqrt(0.5) r omega for discs, which rotate about z only, D = 1): T is then the "
	       "rotational granular temperature I <|omega - <omega>|^2>/(3 m), equal to the translational "
	       "one where energy is equally distributed. It is 0 if no style of the script makes particles "
	       "rotate.\n\n"
	       "The mean found from N particles takes up p of N degrees of freedom of each direction (p = 1 "
	       "for uniform, 2 for linear), so that T by its definition is too small by (N - p)/N on "
	       "average; `unbiased yes` corrects this. T is 0 where no fluctuation is defined, for N <= p: "
	       "of a single particle, or of none. Spheres of clumps count one by one. Sums are exact and "
	       "rounded once.",
	.example = "compute T grains temp/granular\n"
		   "compute T grains temp/granular mean linear/y unbiased yes\n"
		   "compute Trot grains temp/granular motion rotation",
	.cite = "C. K. K. Lun, S. B. Savage, D. J. Jeffrey, N. Chepurniy, J. Fluid Mech. 140 (1984) 223",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
};
