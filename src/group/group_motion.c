#include "group/group_motion.h"

#include "math/vec3.h"
#include "particle/group_moments.h"
#include "rigid/mass_moments.h"

#include "base/banned.h"

/* The inertia tensor I is singular, particles on a line, if det I is below this fraction of (trace I)^3. */
static const double SINGULAR = 1e-12;

static void mass_weighted_mean(const struct tsim *sim, int group, ts_terms_fn *terms, double out[3])
{
	double sum[4];

	ts_group_sum_blocks(sim, group, 4, terms, NULL, sum);
	for (int d = 0; d < 3; d++)
		out[d] = sum[3] > 0 ? sum[d] / sum[3] : 0;
}

void ts_group_centre(const struct tsim *sim, int group, double x[3])
{
	mass_weighted_mean(sim, group, ts_mass_moment_terms, x);
}

void ts_group_velocity(const struct tsim *sim, int group, double v[3])
{
	mass_weighted_mean(sim, group, ts_mass_momentum_terms, v);
}

void ts_group_spin(const struct tsim *sim, int group, double centre[3], double omega[3])
{
	double l[3], t[6], a[3], b[3], c[3], bc[3], ca[3], ab[3], det, trace;

	ts_group_centre(sim, group, centre);
	ts_group_sum_blocks(sim, group, 3, ts_mass_angular_momentum_terms, centre, l);
	ts_group_sum_blocks(sim, group, 6, ts_mass_inertia_terms, centre, t);
	trace = t[0] + t[1] + t[2];
	a[0] = t[0], a[1] = b[0] = t[3], a[2] = c[0] = t[4];
	b[1] = t[1], b[2] = c[1] = t[5], c[2] = t[2];
	ts_cross(b, c, bc);
	ts_cross(c, a, ca);
	ts_cross(a, b, ab);
	det = ts_dot(a, bc);
	for (int k = 0; k < 3; k++) {
		if (det > SINGULAR * trace * trace * trace) /* inverse by cofactors */
			omega[k] = (bc[k] * l[0] + ca[k] * l[1] + ab[k] * l[2]) / det;
		else /* on a line along e: I = (1 - e e) trace/2 */
			omega[k] = trace > 0 ? 2 * l[k] / trace : 0;
	}
}
