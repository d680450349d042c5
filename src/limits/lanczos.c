#include "limits/lanczos.h"

#include <math.h>

#include "base/alloc.h"
#include "law/granular_limit.h"
#include "math/rng.h"
#include "math/vec3.h"

#include "base/banned.h"

enum { LANCZOS_STEPS = 18, DAMPING_ITERATIONS = 8, POWER_STEPS = 400 };

void ts_lanczos_clear(struct ts_lanczos *network)
{
	network->nbodies = network->nlinks = 0;
}

void ts_lanczos_release(struct ts_lanczos *network)
{
	ts_free(network->body);
	ts_free(network->link);
	ts_free(network->u);
	ts_free(network->f);
	ts_free(network->basis);
	ts_free(network->momentum);
	*network = (struct ts_lanczos){ 0 };
}

/* Relative motion at the contact point and relative rotation, of a with respect to b. */
static void relative_motion(const struct ts_lanczos *m, const struct ts_link *l, double move[3],
			    double turn[3])
{
	const int end[2] = { l->a, l->b };

	for (int d = 0; d < 3; d++)
		move[d] = turn[d] = 0;
	for (int e = 0; e < 2; e++) {
		double sign = e ? -1 : 1, lever_velocity[3];

		if (end[e] < 0)
			continue;
		ts_cross(m->u[end[e]] + 3, l->arm[e], lever_velocity);
		ts_axpy(sign, m->u[end[e]], move);
		ts_axpy(sign, lever_velocity, move);
		ts_axpy(sign, m->u[end[e]] + 3, turn);
	}
}

/* Adds (ck C + kk K) u of one link to the forces of its body a. */
static void add_link(struct ts_lanczos *m, const struct ts_link *l, bool slip, double kk, double ck)
{
	double move[3], turn[3], force[3], torque[3],
		normal = kk * l->k[TS_LINK_NORMAL] + ck * l->c[TS_LINK_NORMAL];
	double tangential =
		slip || l->bonded ? kk * l->k[TS_LINK_TANGENTIAL] + ck * l->c[TS_LINK_TANGENTIAL] : 0;
	double rolling = slip || l->bonded ? kk * l->k[TS_LINK_ROLLING] + ck * l->c[TS_LINK_ROLLING] : 0;
	double twisting = l->bonded ? kk * l->k[TS_LINK_TWISTING] + ck * l->c[TS_LINK_TWISTING] : 0;

	relative_motion(m, l, move, turn);
	ts_scale(tangential, move, force);
	ts_axpy((normal - tangential) * ts_dot(move, l->n), l->n, force);
	ts_cross(l->arm[0], force, torque);
	ts_axpy(rolling, turn, torque);
	ts_axpy((twisting - rolling) * ts_dot(turn, l->n), l->n, torque);
	ts_add(m->f[l->a], force, m->f[l->a]);
	ts_add(m->f[l->a] + 3, torque, m->f[l->a] + 3);
}

static void compute_forces(struct ts_lanczos *m, bool slip, double kk, double ck)
{
	for (size_t i = 0; i < m->nbodies; i++)
		for (int d = 0; d < 6; d++)
			m->f[i][d] = (ck * m->body[i].drag[d / 3] + (d < 3 ? kk * m->body[i].spring[d] : 0)) *
				     m->u[i][d];
	for (size_t k = 0; k < m->nlinks; k++)
		add_link(m, &m->link[k], slip, kk, ck);
}

static double scalar_product(const struct ts_lanczos *m)
{
	double sum = 0;

	for (size_t i = 0; i < m->nbodies; i++)
		for (int d = 0; d < 6; d++)
			sum += m->u[i][d] * m->f[i][d];
	return sum;
}

/* u = M^-1 f */
static void divide_by_mass(struct ts_lanczos *m)
{
	for (size_t i = 0; i < m->nbodies; i++) {
		const struct ts_lanczos_body *b = &m->body[i];

		for (int d = 0; d < 3; d++) {
			m->u[i][d] = b->inverse_mass * m->f[i][d];
			m->u[i][3 + d] = ts_dot(b->inverse_inertia[d], m->f[i] + 3);
		}
	}
}

/* y += s x, for all bodies */
static void add_scaled(size_t n, double s, double (*x)[6], double (*y)[6])
{
	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 6; d++)
			y[i][d] += s * x[i][d];
}

/* ---- the method of Lanczos ---- */

struct tridiagonal {
	/* diagonal and off-diagonal of M^-1 (kk K + ck C) in the basis */
	double diagonal[LANCZOS_STEPS], off_diagonal[LANCZOS_STEPS + 1];
	int n;
};

/* Orthonormalised, M^-1 f becomes the next vector of the basis; false: it vanishes. */
static bool extend_basis(struct ts_lanczos *m, struct tridiagonal *l)
{
	size_t n = m->nbodies, at = (size_t)l->n * n;
	double size;

	divide_by_mass(m);
	size = sqrt(fmax(scalar_product(m), 0));
	l->off_diagonal[l->n] = size;
	if (!(size > 1e-7 * (l->n ? fabs(l->diagonal[l->n - 1]) : 0)))
		return false;
	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 6; d++) {
			m->basis[at + i][d] = m->u[i][d] /= size;
			m->momentum[at + i][d] = m->f[i][d] / size;
		}
	l->n++;
	return true;
}

/* Random forces, which excite every mode. */
static void set_random_forces(struct ts_lanczos *m)
{
	struct ts_rng rng = ts_rng_start(2385, m->nlinks);

	for (size_t i = 0; i < m->nbodies; i++)
		for (int d = 0; d < 6; d++)
			m->f[i][d] = ts_rng_uniform(&rng) - 0.5;
}

/* Eigenvector of the largest eigenvalue of the tridiagonal matrix, by power iteration. */
static void largest_eigenvector(const struct tridiagonal *l, double y[LANCZOS_STEPS])
{
	for (int k = 0; k < l->n; k++)
		y[k] = 1;
	for (int round = 0; round < POWER_STEPS; round++) {
		double z[LANCZOS_STEPS], size = 0;

		for (int k = 0; k < l->n; k++) {
			z[k] = l->diagonal[k] * y[k] + (k ? l->off_diagonal[k] * y[k - 1] : 0) +
			       (k + 1 < l->n ? l->off_diagonal[k + 1] * y[k + 1] : 0);
			size += z[k] * z[k];
		}
		for (int k = 0; k < l->n; k++)
			y[k] = size > 0 ? z[k] / sqrt(size) : 0;
	}
}

/* Starting from the forces in f: the fastest mode u, normalised to u M u = 1, and f = M u. */
static void find_fastest_mode(struct ts_lanczos *m, bool slip, double kk, double ck)
{
	size_t n = m->nbodies;
	struct tridiagonal l = { .n = 0 };
	double y[LANCZOS_STEPS];

	while (l.n < LANCZOS_STEPS && extend_basis(m, &l)) {
		size_t at = (size_t)(l.n - 1) * n;

		compute_forces(m, slip, kk, ck);
		l.diagonal[l.n - 1] = scalar_product(m);
		add_scaled(n, -l.diagonal[l.n - 1], m->momentum + at, m->f);
		if (l.n > 1)
			add_scaled(n, -l.off_diagonal[l.n - 1], m->momentum + at - n, m->f);
	}
	largest_eigenvector(&l, y);
	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 6; d++)
			m->u[i][d] = m->f[i][d] = 0;
	for (int k = 0; k < l.n; k++) {
		add_scaled(n, y[k], m->basis + (size_t)k * n, m->u);
		add_scaled(n, y[k], m->momentum + (size_t)k * n, m->f);
	}
}

/* ---- the limit ---- */

static int most_moving_body(const struct ts_lanczos *m)
{
	double most = 0;
	int at = 0;

	for (size_t i = 0; i < m->nbodies; i++) {
		double work = 0;

		for (int d = 0; d < 6; d++)
			work += m->u[i][d] * m->f[i][d];
		if (work > most) {
			most = work;
			at = (int)i;
		}
	}
	return at;
}

enum ts_status ts_lanczos_limit(struct ts_lanczos *network, bool slip, double near, double *limit, int *worst)
{
	size_t n = network->nbodies;
	double mass, stiffness, damping, before;

	*limit = near;
	if (TS_GROW(network->u, network->u_capacity, n) != TS_OK ||
	    TS_GROW(network->f, network->f_capacity, n) != TS_OK ||
	    TS_GROW(network->basis, network->basis_capacity, LANCZOS_STEPS * n) != TS_OK ||
	    TS_GROW(network->momentum, network->momentum_capacity, LANCZOS_STEPS * n) != TS_OK)
		return TS_NOMEM;
	set_random_forces(network);
	for (int time = 0; time < DAMPING_ITERATIONS; time++) {
		find_fastest_mode(network, slip, 1, 2 / *limit);
		before = *limit;
		mass = scalar_product(network); /* 1, unless the basis has lost its orthogonality */
		compute_forces(network, slip, 0, 1);
		damping = scalar_product(network);
		compute_forces(network, slip, 1, 0);
		stiffness = scalar_product(network);
		*limit = ts_oscillator_limit(stiffness, damping, mass, false);
		*worst = most_moving_body(network);
		if (!(damping > 0) || !isfinite(*limit) || fabs(*limit - before) < 1e-3 * *limit)
			break;
	}
	return TS_OK;
}
