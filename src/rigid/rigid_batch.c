#include "base/clones.h"
TS_UNROLLED

#include <string.h>

#include "base/four.h"
#include "math/rigid_turn.h"
#include "rigid/rigid_batch.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

/* Bodies are copied to columns of numbers, one for each of the first numbers of struct ts_body. */
#define INDEX(field) (offsetof(struct ts_body, field) / sizeof(double))
enum {
	LANES = TS_BATCH,
	FIRST_CHANGED = INDEX(q),
	END_CHANGED = INDEX(force),
	NUMBERS = (INDEX(external) + 3) / 4 * 4
};

struct lanes {
	double of[NUMBERS][LANES];
	double m[9][LANES]; /* rotation matrices */
} __attribute__((aligned(64)));

TS_INLINE struct ts_body *body_of(const struct ts_rigid *r, size_t from, size_t n, size_t k)
{
	return &r->body[r->order[from + (k < n ? k : n - 1)]];
}

/* Lanes behind the last body repeat it. */
TS_INLINE void load_bodies(const struct ts_rigid *r, size_t from, size_t n, struct lanes *l)
{
	for (size_t at = 0; at < n; at += 4)
		for (size_t c = 0; c < NUMBERS; c += 4) {
			ts_four row[4];

			for (size_t k = 0; k < 4; k++)
				row[k] = TS_FOUR_LOAD((const double *)body_of(r, from, n, at + k) + c);
			ts_four_columns(row, &l->of[c], at);
		}
}

/* Stores orientations, positions and velocities. */
TS_INLINE void store_bodies(const struct lanes *l, size_t from, size_t n, struct ts_rigid *r)
{
	_Static_assert((END_CHANGED - FIRST_CHANGED) % 4 == 0, "blocks of four");
	for (size_t at = 0; at < n; at += 4)
		for (size_t c = FIRST_CHANGED; c < END_CHANGED; c += 4) {
			ts_four row[4];

			ts_four_rows(&l->of[c], at, row);
			for (size_t k = 0; k < 4 && at + k < n; k++)
				*(ts_four_anywhere *)((double *)body_of(r, from, n, at + k) + c) = row[k];
		}
}

#define LOAD3(l, field, k)                                                                           \
	{                                                                                            \
		(l)->of[INDEX(field)][k], (l)->of[INDEX(field) + 1][k], (l)->of[INDEX(field) + 2][k] \
	}

TS_INLINE void set3(struct lanes *l, size_t column, size_t k, const double v[3])
{
	l->of[column][k] = v[0];
	l->of[column + 1][k] = v[1];
	l->of[column + 2][k] = v[2];
}

TS_INLINE void set_matrix(struct lanes *l, size_t k, const double q[4])
{
	double m[3][3];

	ts_quaternion_matrix(q, m);
	for (int a = 0; a < 3; a++)
		for (int b = 0; b < 3; b++)
			l->m[3 * a + b][k] = m[a][b];
}

/* ts_body_kick, and with `move` ts_body_move */
TS_INLINE void advance_lane(struct lanes *l, size_t k, double h, double dt, bool move)
{
	const double inertia[3] = LOAD3(l, inertia, k), force[3] = LOAD3(l, force, k),
		     torque[3] = LOAD3(l, torque, k), mass = l->of[INDEX(mass)][k];
	double q[4] = { l->of[INDEX(q)][k], l->of[INDEX(q) + 1][k], l->of[INDEX(q) + 2][k],
			l->of[INDEX(q) + 3][k] };
	double x[3] = LOAD3(l, x, k), v[3] = LOAD3(l, v, k), spin[3] = LOAD3(l, spin, k), omega[3];

	for (int a = 0; a < 3; a++) {
		v[a] += h * force[a] / mass;
		spin[a] += h * torque[a];
	}
	ts_rigid_omega(q, inertia, spin, omega);
	if (move) {
		ts_axpy(dt, v, x);
		ts_rigid_advance_orientation(inertia, spin, omega, dt, q);
		for (int a = 0; a < 4; a++)
			l->of[INDEX(q) + (size_t)a][k] = q[a];
		set3(l, INDEX(x), k, x);
		set_matrix(l, k, q);
	}
	set3(l, INDEX(v), k, v);
	set3(l, INDEX(spin), k, spin);
	set3(l, INDEX(omega), k, omega);
}

/* Bodies order[from] .. order[from + n - 1], n at most LANES: half kick, drift, and rotation matrices. */
TS_CLONES static void begin_lanes(struct ts_rigid *r, size_t from, size_t n, double dt, struct lanes *l)
{
	load_bodies(r, from, n, l);
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		advance_lane(l, k, 0.5 * dt, dt, true);
	store_bodies(l, from, n, r);
}

/* Half kick with the new forces. */
TS_CLONES static void end_lanes(struct ts_rigid *r, size_t from, size_t n, double dt, struct lanes *l)
{
	load_bodies(r, from, n, l);
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		advance_lane(l, k, 0.5 * dt, dt, false);
	store_bodies(l, from, n, r);
}

/* Rotation matrices. */
TS_CLONES static void make_matrices(const struct ts_rigid *r, size_t from, size_t n, struct lanes *l)
{
	load_bodies(r, from, n, l);
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		const double q[4] = { l->of[INDEX(q)][k], l->of[INDEX(q) + 1][k], l->of[INDEX(q) + 2][k],
				      l->of[INDEX(q) + 3][k] };

		set_matrix(l, k, q);
	}
}

TS_INLINE void matrix_of_lane(const struct lanes *l, size_t k, double m[3][3])
{
	for (int a = 0; a < 3; a++)
		for (int b = 0; b < 3; b++)
			m[a][b] = l->m[3 * a + b][k];
}

/* Sets velocities of the members; their positions are up to date. */
static void set_member_velocities(struct tsim *sim, size_t b, double m[3][3])
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_body *body = &r->body[b];
	struct ts_particles *p = sim->particles;
	double arm[3], turn[3];

	for (size_t k = r->start[b]; k < r->start[b + 1]; k++) {
		size_t i = (size_t)r->member[k];

		ts_rotate(m, p->body_x[i], arm);
		ts_cross(body->omega, arm, turn);
		ts_add(body->v, turn, p->v[i]);
		memcpy(p->omega[i], body->omega, sizeof body->omega);
	}
}

static void sum_forces(struct tsim *sim, size_t b, double m[3][3])
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_particles *p = sim->particles;
	struct ts_body *body = &r->body[b];
	double force[3], torque[3] = { 0 }, arm[3], turn[3];

	memcpy(force, body->external, sizeof force);
	for (size_t k = r->start[b]; k < r->start[b + 1]; k++) {
		size_t i = (size_t)r->member[k];

		ts_rotate(m, p->body_x[i], arm);
		ts_cross(arm, p->f[i], turn);
		ts_add(force, p->f[i], force);
		ts_add(turn, p->torque[i], turn);
		ts_add(torque, turn, torque);
	}
	for (int k = 0; k < 3; k++) {
		body->force[k] = force[k] * body->free[k];
		body->torque[k] = torque[k] * body->free[3 + k];
	}
}

void ts_rigid_sum_forces(struct tsim *sim, size_t b)
{
	double m[3][3];

	ts_quaternion_matrix(sim->rigid->body[b].q, m);
	sum_forces(sim, b, m);
}

/* Bodies are stored in the order of their ids, but processed in the order of their members in memory. */
static void prefetch_bodies(const struct ts_rigid *r, size_t from)
{
	for (size_t k = from; k < from + LANES && k < r->ordered; k++)
		for (size_t line = 0; line < sizeof *r->body; line += 64)
			__builtin_prefetch((const char *)&r->body[r->order[k]] + line, 1);
}

void ts_rigid_begin_bodies(struct tsim *sim, size_t from, size_t to)
{
	struct ts_rigid *r = sim->rigid;

	for (; from < to; from += LANES) {
		size_t n = to - from < LANES ? to - from : LANES;
		struct lanes l;

		begin_lanes(r, from, n, sim->clock.dt, &l);
		prefetch_bodies(r, from + LANES);
		for (size_t k = 0; k < n; k++) {
			size_t b = (size_t)r->order[from + k];
			double m[3][3];

			matrix_of_lane(&l, k, m);
			ts_rigid_place_rotated(sim, &r->body[b], m, r->member + r->start[b],
					       r->start[b + 1] - r->start[b]);
		}
	}
}

void ts_rigid_end_bodies(struct tsim *sim, size_t from, size_t to)
{
	struct ts_rigid *r = sim->rigid;

	for (; from < to; from += LANES) {
		size_t n = to - from < LANES ? to - from : LANES;
		struct lanes l;
		double m[3][3];

		make_matrices(r, from, n, &l);
		prefetch_bodies(r, from + LANES);
		for (size_t k = 0; k < n; k++) {
			matrix_of_lane(&l, k, m);
			sum_forces(sim, (size_t)r->order[from + k], m);
		}
		end_lanes(r, from, n, sim->clock.dt, &l);
		for (size_t k = 0; k < n; k++) {
			matrix_of_lane(&l, k, m);
			set_member_velocities(sim, (size_t)r->order[from + k], m);
		}
	}
}
