#include "rigid/mass_moments.h"

#include "math/vec3.h"
#include "particle/group_moments.h"

#include "base/banned.h"

void ts_mass_moment(const struct tsim *sim, size_t i, double term[4])
{
	ts_rigid_share_place(sim, i, term);
	term[3] = sim->particles->mass[i];
	ts_scale(term[3], term, term);
}

void ts_mass_momentum(const struct tsim *sim, size_t i, double term[4])
{
	term[3] = sim->particles->mass[i];
	ts_scale(term[3], ts_rigid_share_velocity(sim, i), term);
}

static void arm(const struct tsim *sim, size_t i, const double c[3], double d[3])
{
	ts_rigid_share_place(sim, i, d);
	ts_sub(d, c, d);
}

void ts_mass_angular_momentum(const struct tsim *sim, size_t i, const double c[3], double term[3])
{
	double d[3], own[3];

	arm(sim, i, c, d);
	ts_cross(d, ts_rigid_share_velocity(sim, i), term);
	ts_scale(sim->particles->mass[i], term, term);
	ts_rigid_share_spin(sim, i, own);
	ts_add(term, own, term);
}

void ts_mass_inertia(const struct tsim *sim, size_t i, const double c[3], double term[6])
{
	double d[3], own[6], m = sim->particles->mass[i];

	arm(sim, i, c, d);
	ts_rigid_share_inertia(sim, i, own);
	term[0] = m * (d[1] * d[1] + d[2] * d[2]);
	term[1] = m * (d[0] * d[0] + d[2] * d[2]);
	term[2] = m * (d[0] * d[0] + d[1] * d[1]);
	term[3] = -m * d[0] * d[1];
	term[4] = -m * d[0] * d[2];
	term[5] = -m * d[1] * d[2];
	for (int k = 0; k < 6; k++)
		term[k] += own[k];
}

/* Of a clump with moments of inertia I about its centre of mass, the integral of (x_a - X_a) (x_b - X_b) over its mass is
 * (1 trace I / 2 - I)_ab. */
void ts_mass_second_moment(const struct tsim *sim, size_t i, const double c[3], double term[6])
{
	double d[3], own[6], m = sim->particles->mass[i];

	arm(sim, i, c, d);
	ts_rigid_share_inertia(sim, i, own);
	for (int k = 0; k < 6; k++)
		term[k] = m * d[ts_tensor_row[k]] * d[ts_tensor_column[k]] - own[k] +
			  (k < 3 ? (own[0] + own[1] + own[2]) / 2 : 0);
}
