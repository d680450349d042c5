#include "base/clones.h"
TS_UNROLLED

#include "base/four.h"
#include "box/domain.h"
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
	double m[12]
		[LANES]; /* rotation matrices: m[4 * b + a] is element a of column b; m[4 * b + 3] is 0, as denormal numbers
				 * that nobody reads take time, too */
} __attribute__((aligned(64)));

TS_INLINE struct ts_body *body_of(const struct ts_rigid *r, size_t from, size_t n, size_t k)
{
	return &r->body[r->order[from + (k < n ? k : n - 1)]];
}

/* The first numbers of each body. Lanes behind the last body repeat it. */
TS_INLINE void load_bodies(const struct ts_rigid *r, size_t from, size_t n, size_t numbers, struct lanes *l)
{
	for (size_t at = 0; at < n; at += 4) {
		const struct ts_body *body[4];

		for (size_t k = 0; k < 4; k++)
			body[k] = body_of(r, from, n, at + k);
		for (size_t c = 0; c < numbers; c += 4) {
			ts_four row[4];

			for (size_t k = 0; k < 4; k++)
				row[k] = TS_FOUR_LOAD((const double *)body[k] + c);
			ts_four_columns(row, &l->of[c], at);
		}
	}
}

/* Stores orientations, positions and velocities. */
TS_INLINE void store_bodies(const struct lanes *l, size_t from, size_t n, struct ts_rigid *r)
{
	_Static_assert(INDEX(force) % 4 == 0 && (END_CHANGED - FIRST_CHANGED) % 4 == 0, "blocks of four");
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
	for (int b = 0; b < 3; b++) {
		for (int a = 0; a < 3; a++)
			l->m[4 * b + a][k] = m[a][b];
		l->m[4 * b + 3][k] = 0;
	}
}

/* ts_body_kick, twice if a step ends and the next one begins, and with `move` ts_body_move */
TS_INLINE void advance_lane(struct lanes *l, size_t k, double h, double dt, bool twice, bool move)
{
	const double inertia[3] = LOAD3(l, inertia, k), force[3] = LOAD3(l, force, k),
		     torque[3] = LOAD3(l, torque, k), mass = l->of[INDEX(mass)][k];
	double q[4] = { l->of[INDEX(q)][k], l->of[INDEX(q) + 1][k], l->of[INDEX(q) + 2][k],
			l->of[INDEX(q) + 3][k] };
	double x[3] = LOAD3(l, x, k), v[3] = LOAD3(l, v, k), spin[3] = LOAD3(l, spin, k), omega[3];

	for (int a = 0; a < 3; a++) {
		double dv = h * force[a] / mass, dspin = h * torque[a];

		v[a] = twice ? v[a] + dv + dv : v[a] + dv;
		spin[a] = twice ? spin[a] + dspin + dspin : spin[a] + dspin;
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

/* Rotation matrices. */
TS_INLINE void set_matrices(struct lanes *l, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		const double q[4] = { l->of[INDEX(q)][k], l->of[INDEX(q) + 1][k], l->of[INDEX(q) + 2][k],
				      l->of[INDEX(q) + 3][k] };

		set_matrix(l, k, q);
	}
}

TS_INLINE void advance_lanes(struct lanes *l, size_t n, double dt, bool twice, bool move)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		advance_lane(l, k, 0.5 * dt, dt, twice, move);
}

/* ---- members, one after the other: a row holds x, y, z and a number without meaning */

/* Columns of the rotation matrices of four bodies. */
struct four_matrices {
	ts_four column[3][4];
};

TS_INLINE void load_matrices(const struct lanes *l, size_t at, struct four_matrices *m)
{
	for (int b = 0; b < 3; b++)
		ts_four_rows(&l->m[4 * b], at, m->column[b]);
}

/* m x, added in the order of ts_rotate */
#define ROTATED(m, k, x) \
	((m)->column[0][k] * (x)[0] + (m)->column[1][k] * (x)[1] + (m)->column[2][k] * (x)[2])
#define YZX(a) TS_FOUR_SHUFFLE(a, a, 1, 2, 0, 3)
#define ZXY(a) TS_FOUR_SHUFFLE(a, a, 2, 0, 1, 3)
#define CROSS(a, b) (YZX(a) * ZXY(b) - ZXY(a) * YZX(b))

/* Position, unless it is up to date, and velocities of the members of body order[turn]; x, v, omega: its own. */
TS_INLINE void set_members(struct tsim *sim, size_t turn, const struct four_matrices *m, size_t k,
			   const ts_four *x, const ts_four *v, const ts_four *omega)
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_box *box = &sim->domain->box;
	const ts_four length = { ts_box_length(box, 0), ts_box_length(box, 1), ts_box_length(box, 2), 0 };
	struct ts_particles *p = sim->particles;

	for (size_t at = r->row_start[turn]; at < r->row_start[turn + 1]; at++) {
		size_t i = (size_t)r->row[at];
		const int32_t *image = p->image[i];
		ts_four arm = ROTATED(m, k, p->body_x[i]), velocity = *v + CROSS(*omega, arm), place;

		ts_four_store(&velocity, 3, p->v[i]);
		ts_four_store(omega, 3, p->omega[i]);
		if (!x)
			continue;
		place = *x + arm - (ts_four){ image[0], image[1], image[2], 0 } * length;
		ts_four_store(&place, 3, p->x[i]);
	}
}

/* Of the bodies of all lanes. */
TS_INLINE void set_all_members(struct tsim *sim, const struct lanes *l, size_t from, size_t n, bool positions)
{
	for (size_t at = 0; at < n; at += 4) {
		struct four_matrices m;
		ts_four x[4], v[4], omega[4];

		load_matrices(l, at, &m);
		ts_four_rows(&l->of[INDEX(x)], at, x);
		ts_four_rows(&l->of[INDEX(v)], at, v);
		ts_four_rows(&l->of[INDEX(omega)], at, omega);
		for (size_t k = 0; k < 4 && at + k < n; k++)
			set_members(sim, from + at + k, &m, k, positions ? &x[k] : NULL, &v[k], &omega[k]);
	}
}

/* Force and torque on body order[turn]; the body keeps those that hold it in its constrained directions, too. */
TS_INLINE void sum_forces(struct tsim *sim, size_t turn, const struct four_matrices *m, size_t k,
			  ts_four *force, ts_four *torque)
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_particles *p = sim->particles;
	struct ts_body *body = &r->body[r->order[turn]];

	*force = TS_FOUR_LOAD(body->external);
	*torque = (ts_four){ 0 };
	for (size_t at = r->row_start[turn]; at < r->row_start[turn + 1]; at++) {
		size_t i = (size_t)r->row[at];
		ts_four arm = ROTATED(m, k, p->body_x[i]), f = TS_FOUR_LOAD(p->f[i]);

		*force += f;
		*torque += CROSS(arm, f) + TS_FOUR_LOAD(p->torque[i]);
	}
	ts_four_store(force, 3, body->force);
	ts_four_store(torque, 3, body->torque);
	*force *= TS_FOUR_LOAD(body->free);
	*torque *= TS_FOUR_LOAD(body->free + 3);
}

/* Of the bodies of all lanes, also into the lanes. */
TS_INLINE void sum_all_forces(struct tsim *sim, size_t from, size_t n, struct lanes *l)
{
	_Static_assert(INDEX(torque) == INDEX(force) + 3 && INDEX(torque) + 3 < NUMBERS, "columns of four");
	for (size_t at = 0; at < n; at += 4) {
		struct four_matrices m;
		ts_four force[4] = { { 0 } }, torque[4] = { { 0 } };

		load_matrices(l, at, &m);
		for (size_t k = 0; k < 4 && at + k < n; k++)
			sum_forces(sim, from + at + k, &m, k, &force[k], &torque[k]);
		ts_four_columns(force, &l->of[INDEX(force)], at);
		ts_four_columns(torque, &l->of[INDEX(torque)], at);
	}
}

/* ---- a batch of bodies: order[from] .. order[from + n - 1], n at most LANES */

/* What accelerates the bodies. */
TS_INLINE void hold_constrained(const struct ts_rigid *r, size_t from, size_t n, struct lanes *l)
{
	for (size_t k = 0; k < n; k++)
		for (size_t c = 0; c < 6; c++)
			l->of[INDEX(force) + c][k] *= r->body[r->order[from + k]].free[c];
}

/* Half kick and drift. */
TS_CLONES static void begin_batch(struct tsim *sim, size_t from, size_t n)
{
	struct lanes l;

	load_bodies(sim->rigid, from, n, NUMBERS, &l);
	hold_constrained(sim->rigid, from, n, &l);
	advance_lanes(&l, n, sim->clock.dt, false, true);
	store_bodies(&l, from, n, sim->rigid);
	set_all_members(sim, &l, from, n, true);
}

/* Forces and torques are summed anew. */
TS_INLINE void load_with_forces(struct tsim *sim, size_t from, size_t n, struct lanes *l)
{
	load_bodies(sim->rigid, from, n, INDEX(force), l);
	set_matrices(l, n);
	sum_all_forces(sim, from, n, l);
}

/* Half kick with the new forces; with `begin` also half kick and drift of the next step. */
TS_INLINE void finish_batch(struct tsim *sim, size_t from, size_t n, bool begin)
{
	struct lanes l;

	load_with_forces(sim, from, n, &l);
	advance_lanes(&l, n, sim->clock.dt, begin, begin);
	store_bodies(&l, from, n, sim->rigid);
	set_all_members(sim, &l, from, n, begin);
}

TS_CLONES static void end_batch(struct tsim *sim, size_t from, size_t n)
{
	finish_batch(sim, from, n, false);
}

/* Both, between which nobody looks at the members. */
TS_CLONES static void end_and_begin_batch(struct tsim *sim, size_t from, size_t n)
{
	finish_batch(sim, from, n, true);
}

TS_CLONES static void sum_batch(struct tsim *sim, size_t from, size_t n)
{
	struct lanes l;

	load_with_forces(sim, from, n, &l);
}

/* Bodies are stored in the order of their ids, but processed in the order of their members in memory. */
static void prefetch_bodies(const struct ts_rigid *r, size_t from)
{
	for (size_t k = from; k < from + LANES && k < r->ordered; k++)
		for (size_t line = 0; line < sizeof *r->body; line += 64)
			__builtin_prefetch((const char *)&r->body[r->order[k]] + line, 1);
}

static void in_batches(struct tsim *sim, size_t from, size_t to,
		       void (*work)(struct tsim *sim, size_t from, size_t n))
{
	for (; from < to; from += LANES) {
		prefetch_bodies(sim->rigid, from + LANES);
		work(sim, from, to - from < LANES ? to - from : LANES);
	}
}

void ts_rigid_begin_bodies(struct tsim *sim, size_t from, size_t to)
{
	in_batches(sim, from, to, begin_batch);
}

void ts_rigid_end_bodies(struct tsim *sim, size_t from, size_t to)
{
	in_batches(sim, from, to, end_batch);
}

void ts_rigid_end_and_begin_bodies(struct tsim *sim, size_t from, size_t to)
{
	in_batches(sim, from, to, end_and_begin_batch);
}

void ts_rigid_sum_forces(struct tsim *sim, size_t from, size_t to)
{
	in_batches(sim, from, to, sum_batch);
}
