#include "base/clones.h"
TS_UNROLLED

#include <math.h>
#include <string.h>

#include "base/four.h"
#include "base/parallel.h"
#include "math/quaternion.h"
#include "math/vec3.h"
#include "particle/columns.h"
#include "particle/orientation.h"
#include "particle/particles.h"

#include "base/banned.h"

static const char NAME[] = "orientation";

static const struct ts_column *find_column(const struct ts_particles *p)
{
	for (size_t k = TS_NCOLUMN_BUILTIN; k < p->ncolumns; k++)
		if (p->column[k].width == 4 && !strcmp(p->column[k].name, NAME))
			return &p->column[k];
	return NULL;
}

static enum ts_status add_column(struct tsim *sim, size_t *index)
{
	static const double unit[4] = { 1, 0, 0, 0 };
	struct ts_particles *p = sim->particles;
	bool known = find_column(p);

	TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE)));
	TS_TRY(ts_particles_add_column(sim, NAME, 4, TS_COL_NAMED | TS_COL_COPIED, index));
	if (known)
		return TS_OK;
	TS_TRY(ts_particles_column_initial(sim, *index, unit));
	ts_particles_fill_initial(&p->column[*index], 0, p->n);
	return TS_OK;
}

enum ts_status ts_orientation_need(struct tsim *sim)
{
	size_t index;

	return add_column(sim, &index);
}

double (*ts_orientation(const struct tsim *sim))[4]
{
	const struct ts_column *c = find_column(sim->particles);

	return c ? c->data : NULL;
}

void ts_orientation_of(const struct tsim *sim, size_t i, double q[4])
{
	double(*all)[4] = ts_orientation(sim);

	for (int k = 0; k < 4; k++)
		q[k] = all ? all[i][k] : k == 0;
}

/* Rotations q of particles, and half the angles that they turn by in a step. */
struct turns {
	double half[4][TS_BATCH]; /* the fourth is not used */
	double q[4][TS_BATCH];
} __attribute__((aligned(64)));

/* Squares of half the angles that are small: cos(a) and sin(a)/a are their series in x = a^2, to rounding. */
#define SMALL 0.02

TS_INLINE double cosine_of(double x)
{
	return 1 - x * (1. / 2 - x * (1. / 24 - x * (1. / 720 - x * (1. / 40320 - x * (1. / 3628800)))));
}

TS_INLINE double sine_of(double x)
{
	return 1 - x * (1. / 6 - x * (1. / 120 - x * (1. / 5040 - x * (1. / 362880))));
}

TS_INLINE double square_of(const struct turns *b, size_t k)
{
	return b->half[0][k] * b->half[0][k] + b->half[1][k] * b->half[1][k] + b->half[2][k] * b->half[2][k];
}

TS_INLINE void turn(struct turns *b, size_t k, double cosine, double sine)
{
	const double by[4] = { cosine, sine * b->half[0][k], sine * b->half[1][k], sine * b->half[2][k] };
	const double old[4] = { b->q[0][k], b->q[1][k], b->q[2][k], b->q[3][k] };
	double q[4], norm;

	ts_quaternion_multiply(by, old, q);
	/* |q| - 1 is a rounding error: one step of Newton for 1/|q| */
	norm = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
	for (int c = 0; c < 4; c++)
		b->q[c][k] = norm * q[c];
}

TS_INLINE void turn_batch(struct turns *b, size_t n)
{
	double largest = 0;

#pragma omp simd reduction(max : largest)
	for (size_t k = 0; k < n; k++) {
		double x = square_of(b, k);

		largest = x > largest ? x : largest;
	}
	if (!(largest < SMALL)) {
		for (size_t k = 0; k < n; k++) {
			double x = square_of(b, k), angle = sqrt(x);

			if (x < SMALL)
				turn(b, k, cosine_of(x), sine_of(x));
			else
				turn(b, k, cos(angle), sin(angle) / angle);
		}
		return;
	}
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		double x = square_of(b, k);

		turn(b, k, cosine_of(x), sine_of(x));
	}
}

struct turning {
	double dt;
	double (*omega)[3], (*q)[4];
};

/* Particles from .. from + n - 1, n at most TS_BATCH; lanes behind the last repeat it. */
TS_INLINE void advance_batch(const struct turning *t, size_t from, size_t n)
{
	struct turns b;

	for (size_t at = 0; at < n; at += 4) {
		ts_four half[4], q[4];

		for (size_t k = 0; k < 4; k++) {
			size_t i = from + (at + k < n ? at + k : n - 1);

			half[k] = 0.5 * t->dt * TS_FOUR_LOAD(t->omega[i]);
			q[k] = TS_FOUR_LOAD(t->q[i]);
		}
		ts_four_columns(half, b.half, at);
		ts_four_columns(q, b.q, at);
	}
	turn_batch(&b, n);
	for (size_t at = 0; at < n; at += 4) {
		ts_four q[4];

		ts_four_rows((const double(*)[TS_BATCH])b.q, at, q);
		for (size_t k = 0; k < 4 && at + k < n; k++)
			*(ts_four_anywhere *)t->q[from + at + k] = q[k];
	}
}

TS_CLONES static void advance(void *context, size_t from, size_t to)
{
	const struct turning *t = context;

	for (size_t i = from; i < to; i += TS_BATCH)
		advance_batch(t, i, to - i < TS_BATCH ? to - i : TS_BATCH);
}

void ts_orientation_advance(struct tsim *sim)
{
	struct turning t = { sim->clock.dt, sim->particles->omega, ts_orientation(sim) };

	if (t.q && t.omega)
		ts_parallel(ts_team(sim, sim->particles->n), sim->particles->n, advance, &t);
}

void ts_orientation_turn(const struct tsim *sim, size_t i, const double axis[3], double angle)
{
	double(*all)[4] = ts_orientation(sim), sine = sin(angle / 2);
	const double turn[4] = { cos(angle / 2), sine * axis[0], sine * axis[1], sine * axis[2] };
	double q[4];

	if (!all)
		return;
	ts_quaternion_multiply(turn, all[i], q);
	memcpy(all[i], q, sizeof q);
}

enum ts_status ts_orientation_archive(struct tsim *sim, struct ts_archive *archive)
{
	size_t index;

	TS_TRY(add_column(sim, &index));
	return ts_particles_archive_column(archive, sim, NAME, index);
}
