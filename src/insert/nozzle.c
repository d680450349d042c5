#include "insert/nozzle.h"

#include "math/constants.h"
#include "math/vec3.h"

#include "base/banned.h"

static const double CUT = 3; /* truncation of the Gaussian cone, in standard deviations */

void ts_nozzle_orient(struct ts_nozzle *n, const double direction[3])
{
	double least[3] = { 0 };
	int k = 0;

	ts_scale(1 / ts_norm(direction), direction, n->axis);
	for (int d = 1; d < 3; d++)
		k = fabs(n->axis[d]) < fabs(n->axis[k]) ? d : k;
	least[k] = 1;
	ts_cross(least, n->axis, n->side[0]);
	ts_scale(1 / ts_norm(n->side[0]), n->side[0], n->side[0]);
	ts_cross(n->axis, n->side[0], n->side[1]);
}

double ts_nozzle_widest(const struct ts_nozzle *n)
{
	return n->cone == TS_CONE_GAUSSIAN ? CUT * n->angle : n->angle;
}

/* from + along axis + across (cos(turn) side[0] + sin(turn) side[1]) */
static void add_polar(const struct ts_nozzle *n, double along, double across, double turn, double x[3])
{
	ts_axpy(along, n->axis, x);
	ts_axpy(across * cos(turn), n->side[0], x);
	ts_axpy(across * sin(turn), n->side[1], x);
}

void ts_nozzle_draw_point(const struct ts_nozzle *n, double margin, struct ts_minstd *random, double x[3])
{
	double outer = n->outer - margin, inner = n->inner > 0 ? n->inner + margin : 0;
	double u = ts_minstd_uniform(random), turn = 2 * TS_PI * ts_minstd_uniform(random);

	ts_scale(1, n->centre, x);
	add_polar(n, 0, sqrt(inner * inner + u * (outer * outer - inner * inner)), turn, x);
}

/* Angle whose density is proportional to sin(t) exp(-(t/s)^2/2): a Rayleigh deviate, truncated, is accepted
 * with the probability sin(t)/t. */
static double draw_gaussian_angle(double s, struct ts_minstd *random)
{
	double t;

	do
		t = s * sqrt(-2 * log1p(-ts_minstd_uniform(random) * -expm1(-0.5 * CUT * CUT)));
	while (ts_minstd_uniform(random) * t > sin(t));
	return t;
}

void ts_nozzle_draw_direction(const struct ts_nozzle *n, struct ts_minstd *random, double out[3])
{
	double half = sin(0.5 * n->angle), rise, t;

	ts_scale(0, n->axis, out);
	if (n->cone == TS_CONE_LINEAR || !(n->angle > 0)) {
		ts_scale(1, n->axis, out);
	} else if (n->cone == TS_CONE_UNIFORM) { /* the cosine is uniform */
		rise = ts_minstd_uniform(random) * 2 * half * half;
		add_polar(n, 1 - rise, sqrt(rise * (2 - rise)), 2 * TS_PI * ts_minstd_uniform(random), out);
	} else {
		t = draw_gaussian_angle(n->angle, random);
		add_polar(n, cos(t), sin(t), 2 * TS_PI * ts_minstd_uniform(random), out);
	}
}

void ts_nozzle_linear_direction(const struct ts_nozzle *n, const double x[3], double out[3])
{
	double across[3];

	ts_sub(x, n->centre, across);
	ts_scale(1, n->axis, out);
	ts_axpy(tan(n->angle) / n->outer, across, out);
	ts_scale(1 / ts_norm(out), out, out);
}
