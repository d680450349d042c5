#include "limits/lanczos.h"

#include <math.h>

#include "base/alloc.h"
#include "law/granular_limit.h"
#include "math/rng.h"
#include "math/vec3.h"

#include "base/banned.h"

enum { ROUNDS = 18, TIMES = 3, SMALL = 400 };

void ts_lanczos_clear(struct ts_lanczos *linkage)
{
	linkage->nbodies = linkage->nlinks = 0;
}

void ts_lanczos_release(struct ts_lanczos *linkage)
{
	ts_free(linkage->body);
	ts_free(linkage->link);
	ts_free(linkage->u);
	ts_free(linkage->f);
	ts_free(linkage->basis);
	ts_free(linkage->momentum);
	*linkage = (struct ts_lanczos){ 0 };
}

/* Motion at the point of contact and difference of the rotations, as a sees b. */
static void relative(const struct ts_lanczos *m, const struct ts_link *l, double move[3], double turn[3])
{
	const int end[2] = { l->a, l->b };

	for (int d = 0; d < 3; d++)
		move[d] = turn[d] = 0;
	for (int e = 0; e < 2; e++) {
		double sign = e ? -1 : 1, lift[3];

		if (end[e] < 0)
			continue;
		ts_cross(m->u[end[e]] + 3, l->arm[e], lift);
		ts_axpy(sign, m->u[end[e]], move);
		ts_axpy(sign, lift, move);
		ts_axpy(sign, m->u[end[e]] + 3, turn);
	}
}

/* f += (ck C + kk K) u of one link on its a. */
static void add_link(struct ts_lanczos *m, const struct ts_link *l, bool slip, double kk, double ck)
{
	double move[3], turn[3], force[3], torque[3], normal = kk * l->k[0] + ck * l->c[0];
	double across = slip ? kk * l->k[1] + ck * l->c[1] : 0;
	double rolling = slip ? kk * l->k[2] + ck * l->c[2] : 0;

	relative(m, l, move, turn);
	ts_scale(across, move, force);
	ts_axpy((normal - across) * ts_dot(move, l->n), l->n, force);
	ts_cross(l->arm[0], force, torque);
	ts_axpy(rolling, turn, torque);
	ts_axpy(-rolling * ts_dot(turn, l->n), l->n, torque);
	ts_add(m->f[l->a], force, m->f[l->a]);
	ts_add(m->f[l->a] + 3, torque, m->f[l->a] + 3);
}

static void apply(struct ts_lanczos *m, bool slip, double kk, double ck)
{
	for (size_t i = 0; i < m->nbodies; i++)
		for (int d = 0; d < 6; d++)
			m->f[i][d] = 0;
	for (size_t k = 0; k < m->nlinks; k++)
		add_link(m, &m->link[k], slip, kk, ck);
}

static double product(const struct ts_lanczos *m)
{
	double sum = 0;

	for (size_t i = 0; i < m->nbodies; i++)
		for (int d = 0; d < 6; d++)
			sum += m->u[i][d] * m->f[i][d];
	return sum;
}

/* u = M^-1 f. */
static void respond(struct ts_lanczos *m)
{
	for (size_t i = 0; i < m->nbodies; i++) {
		const struct ts_lanczos_body *b = &m->body[i];

		for (int d = 0; d < 3; d++) {
			m->u[i][d] = b->inverse_mass * m->f[i][d];
			m->u[i][3 + d] = ts_dot(b->inverse_inertia[d], m->f[i] + 3);
		}
	}
}

/* y += s x, of all bodies */
static void add(size_t n, double s, double (*x)[6], double (*y)[6])
{
	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 6; d++)
			y[i][d] += s * x[i][d];
}

/* ---- the method of Lanczos ---- */

struct lanczos {
	double diagonal[ROUNDS], beside[ROUNDS + 1]; /* of the matrix that A is in the basis */
	int n;
};

/* The forces in f become the next member of the basis; false: nothing is left of them. */
static bool take(struct ts_lanczos *m, struct lanczos *l)
{
	size_t n = m->nbodies, at = (size_t)l->n * n;
	double size;

	respond(m);
	size = sqrt(fmax(product(m), 0));
	l->beside[l->n] = size;
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

/* Something that has a part along every mode. */
static void begin(struct ts_lanczos *m)
{
	struct ts_rng rng = ts_rng_start(2385, m->nlinks);

	for (size_t i = 0; i < m->nbodies; i++)
		for (int d = 0; d < 6; d++)
			m->f[i][d] = ts_rng_uniform(&rng) - 0.5;
}

/* Largest number of the small matrix, by its powers; its vector. */
static void small_vector(const struct lanczos *l, double y[ROUNDS])
{
	for (int k = 0; k < l->n; k++)
		y[k] = 1;
	for (int round = 0; round < SMALL; round++) {
		double z[ROUNDS], size = 0;

		for (int k = 0; k < l->n; k++) {
			z[k] = l->diagonal[k] * y[k] + (k ? l->beside[k] * y[k - 1] : 0) +
			       (k + 1 < l->n ? l->beside[k + 1] * y[k + 1] : 0);
			size += z[k] * z[k];
		}
		for (int k = 0; k < l->n; k++)
			y[k] = size > 0 ? z[k] / sqrt(size) : 0;
	}
}

/* From the forces in f: the fastest motion into u, with u M u = 1, and M u into f. */
static void fastest(struct ts_lanczos *m, bool slip, double kk, double ck)
{
	size_t n = m->nbodies;
	struct lanczos l = { .n = 0 };
	double y[ROUNDS];

	while (l.n < ROUNDS && take(m, &l)) {
		size_t at = (size_t)(l.n - 1) * n;

		apply(m, slip, kk, ck);
		l.diagonal[l.n - 1] = product(m);
		add(n, -l.diagonal[l.n - 1], m->momentum + at, m->f);
		if (l.n > 1)
			add(n, -l.beside[l.n - 1], m->momentum + at - n, m->f);
	}
	small_vector(&l, y);
	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 6; d++)
			m->u[i][d] = m->f[i][d] = 0;
	for (int k = 0; k < l.n; k++) {
		add(n, y[k], m->basis + (size_t)k * n, m->u);
		add(n, y[k], m->momentum + (size_t)k * n, m->f);
	}
}

/* ---- */

static int most_moved(const struct ts_lanczos *m)
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

enum ts_status ts_lanczos_limit(struct ts_lanczos *linkage, bool slip, double near, double *limit, int *worst)
{
	size_t n = linkage->nbodies;
	double stiffness, damping, before;

	*limit = near;
	if (TS_GROW(linkage->u, linkage->u_capacity, n) != TS_OK ||
	    TS_GROW(linkage->f, linkage->f_capacity, n) != TS_OK ||
	    TS_GROW(linkage->basis, linkage->basis_capacity, ROUNDS * n) != TS_OK ||
	    TS_GROW(linkage->momentum, linkage->momentum_capacity, ROUNDS * n) != TS_OK)
		return TS_NOMEM;
	begin(linkage);
	for (int time = 0; time < TIMES; time++) {
		fastest(linkage, slip, 1, 2 / *limit);
		before = *limit;
		apply(linkage, slip, 0, 1);
		damping = product(linkage);
		apply(linkage, slip, 1, 0);
		stiffness = product(linkage);
		*limit = ts_oscillator_limit(stiffness, damping, 1, false);
		*worst = most_moved(linkage);
		if (!(damping > 0) || !isfinite(*limit) || fabs(*limit - before) < 1e-3 * *limit)
			break;
	}
	return TS_OK;
}
