#include "rigid/mass_moments.h"

#include "base/clones.h"
#include "base/inline.h"
#include "math/vec3.h"

#include "base/banned.h"

/* Without bodies, in most scenes, nothing is looked up. */
TS_INLINE void place(const struct tsim *sim, size_t i, double x[3])
{
	if (sim->rigid->n)
		ts_rigid_share_place(sim, i, x);
	else
		ts_unwrapped(sim, i, x);
}

TS_INLINE const double *velocity(const struct tsim *sim, size_t i)
{
	return sim->rigid->n ? ts_rigid_share_velocity(sim, i) : sim->particles->v[i];
}

void ts_mass_moment(const struct tsim *sim, size_t i, double term[4])
{
	place(sim, i, term);
	term[3] = sim->particles->mass[i];
	ts_scale(term[3], term, term);
}

void ts_mass_momentum(const struct tsim *sim, size_t i, double term[4])
{
	term[3] = sim->particles->mass[i];
	ts_scale(term[3], velocity(sim, i), term);
}

TS_INLINE void arm(const struct tsim *sim, size_t i, const double c[3], double d[3])
{
	place(sim, i, d);
	ts_sub(d, c, d);
}

void ts_mass_angular_momentum(const struct tsim *sim, size_t i, const double c[3], double term[3])
{
	double d[3], own[3];

	arm(sim, i, c, d);
	ts_cross(d, velocity(sim, i), term);
	ts_scale(sim->particles->mass[i], term, term);
	if (!sim->rigid->n)
		return;
	ts_rigid_share_spin(sim, i, own);
	ts_add(term, own, term);
}

void ts_mass_inertia(const struct tsim *sim, size_t i, const double c[3], double term[6])
{
	double d[3], own[6], m = sim->particles->mass[i];

	arm(sim, i, c, d);
	term[0] = m * (d[1] * d[1] + d[2] * d[2]);
	term[1] = m * (d[0] * d[0] + d[2] * d[2]);
	term[2] = m * (d[0] * d[0] + d[1] * d[1]);
	term[3] = -m * d[0] * d[1];
	term[4] = -m * d[0] * d[2];
	term[5] = -m * d[1] * d[2];
	if (!sim->rigid->n)
		return;
	ts_rigid_share_inertia(sim, i, own);
	for (int k = 0; k < 6; k++)
		term[k] += own[k];
}

/* Of a clump with moments of inertia I about its centre of mass, the integral of (x_a - X_a) (x_b - X_b) over its mass is
 * (1 trace I / 2 - I)_ab. */
void ts_mass_second_moment(const struct tsim *sim, size_t i, const double c[3], double term[6])
{
	double d[3], own[6], m = sim->particles->mass[i];

	arm(sim, i, c, d);
	for (int k = 0; k < 6; k++)
		term[k] = m * d[ts_tensor_row[k]] * d[ts_tensor_column[k]];
	if (!sim->rigid->n)
		return;
	ts_rigid_share_inertia(sim, i, own);
	for (int k = 0; k < 6; k++)
		term[k] = term[k] - own[k] + (k < 3 ? (own[0] + own[1] + own[2]) / 2 : 0);
}

/* ---- blocks of particles: loops over columns, which are vectorised */

TS_INLINE void places(const struct tsim *sim, size_t from, size_t n, double x[3][TS_TERM_BLOCK])
{
	double own[3];

	for (size_t i = 0; i < n; i++) {
		place(sim, from + i, own);
		for (int d = 0; d < 3; d++)
			x[d][i] = own[d];
	}
}

TS_INLINE void arms(const struct tsim *sim, size_t from, size_t n, const double c[3],
		    double d[3][TS_TERM_BLOCK])
{
	places(sim, from, n, d);
	for (int k = 0; k < 3; k++)
		for (size_t i = 0; i < n; i++)
			d[k][i] -= c[k];
}

TS_INLINE void velocities(const struct tsim *sim, size_t from, size_t n, double v[3][TS_TERM_BLOCK])
{
	for (size_t i = 0; i < n; i++) {
		const double *own = velocity(sim, from + i);

		for (int d = 0; d < 3; d++)
			v[d][i] = own[d];
	}
}

TS_INLINE void multiply_by_mass(const struct tsim *sim, size_t from, size_t n, double (*term)[TS_TERM_BLOCK])
{
	const double *m = sim->particles->mass + from;

	for (size_t i = 0; i < n; i++)
		term[3][i] = m[i];
	for (int d = 0; d < 3; d++)
		for (size_t i = 0; i < n; i++)
			term[d][i] *= m[i];
}

void ts_mass_moment_terms(const struct tsim *sim, size_t from, size_t n, const void *context,
			  double (*term)[TS_TERM_BLOCK])
{
	(void)context;
	places(sim, from, n, term);
	multiply_by_mass(sim, from, n, term);
}

void ts_mass_momentum_terms(const struct tsim *sim, size_t from, size_t n, const void *context,
			    double (*term)[TS_TERM_BLOCK])
{
	(void)context;
	velocities(sim, from, n, term);
	multiply_by_mass(sim, from, n, term);
}

/* Adds what clumps have about their own centres of mass. */
static void add_shares(const struct tsim *sim, size_t from, size_t n, size_t width,
		       void (*share)(const struct tsim *sim, size_t i, double *own),
		       double (*term)[TS_TERM_BLOCK])
{
	double own[6];

	for (size_t i = 0; i < n && sim->rigid->n; i++) {
		share(sim, from + i, own);
		for (size_t k = 0; k < width; k++)
			term[k][i] += own[k];
	}
}

TS_CLONES static void angular_momenta(const double *m, size_t n, double (*d)[TS_TERM_BLOCK],
				      double (*v)[TS_TERM_BLOCK], double (*term)[TS_TERM_BLOCK])
{
	for (int k = 0; k < 3; k++) {
		const int a = (k + 1) % 3, b = (k + 2) % 3;

		for (size_t i = 0; i < n; i++)
			term[k][i] = m[i] * (d[a][i] * v[b][i] - d[b][i] * v[a][i]);
	}
}

void ts_mass_angular_momentum_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
				    double (*term)[TS_TERM_BLOCK])
{
	double d[3][TS_TERM_BLOCK], v[3][TS_TERM_BLOCK];

	arms(sim, from, n, centre, d);
	velocities(sim, from, n, v);
	angular_momenta(sim->particles->mass + from, n, d, v, term);
	add_shares(sim, from, n, 3, ts_rigid_share_spin, term);
}

TS_CLONES static void inertias(const double *m, size_t n, double (*d)[TS_TERM_BLOCK],
			       double (*term)[TS_TERM_BLOCK])
{
	for (size_t i = 0; i < n; i++) {
		double x = d[0][i], y = d[1][i], z = d[2][i];

		term[0][i] = m[i] * (y * y + z * z);
		term[1][i] = m[i] * (x * x + z * z);
		term[2][i] = m[i] * (x * x + y * y);
		term[3][i] = -m[i] * x * y;
		term[4][i] = -m[i] * x * z;
		term[5][i] = -m[i] * y * z;
	}
}

void ts_mass_inertia_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
			   double (*term)[TS_TERM_BLOCK])
{
	double d[3][TS_TERM_BLOCK];

	arms(sim, from, n, centre, d);
	inertias(sim->particles->mass + from, n, d, term);
	add_shares(sim, from, n, 6, ts_rigid_share_inertia, term);
}

void ts_mass_second_moment_terms(const struct tsim *sim, size_t from, size_t n, const void *centre,
				 double (*term)[TS_TERM_BLOCK])
{
	double d[3][TS_TERM_BLOCK], own[6];

	arms(sim, from, n, centre, d);
	ts_group_tensor_terms(sim->particles->mass + from, n, d, term);
	for (size_t i = 0; i < n && sim->rigid->n; i++) {
		ts_rigid_share_inertia(sim, from + i, own);
		for (int k = 0; k < 6; k++)
			term[k][i] = term[k][i] - own[k] + (k < 3 ? (own[0] + own[1] + own[2]) / 2 : 0);
	}
}
