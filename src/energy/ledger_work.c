/* Work of each cause in a kick, from the velocities before and after it. */
#include <string.h>

#include "energy/ledger.h"
#include "math/rigid_turn.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

/* Relative tolerance: a velocity change that differs from s F/m by more is not only a kick. */
static const double kick_tolerance = 1e-9;

static double body_rotation(const struct ts_body *b)
{
	double omega[3];

	ts_rigid_omega(b->q, b->inertia, b->spin, omega);
	return 0.5 * ts_dot(b->spin, omega);
}

static double body_energy(const struct ts_body *b)
{
	return 0.5 * b->mass * ts_dot(b->v, b->v) + body_rotation(b);
}

/* Of several ranks that have members of a body, that of the first one counts it. It has none if they were deleted after
 * bodies were checked. */
static bool counts_body(const struct tsim *sim, size_t b)
{
	const struct ts_rigid *rigid = sim->rigid;

	return rigid->start[b] < rigid->start[b + 1] &&
	       (size_t)rigid->member[rigid->start[b]] < sim->particles->n;
}

static void find_body_energies(const struct ts_body *b, double energy[2])
{
	energy[0] = 0.5 * b->mass * ts_dot(b->v, b->v);
	energy[1] = body_rotation(b);
}

static enum ts_status note_bodies(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_rigid *rigid = sim->rigid;

	l->ncounted = 0;
	if (TS_GROW(l->counted, l->counted_capacity, rigid->n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t b = 0; b < rigid->n; b++) {
		struct ts_ledger_body *note = &l->counted[l->ncounted];

		if (!counts_body(sim, b))
			continue;
		note->id = rigid->id[b];
		note->members = rigid->size[b];
		find_body_energies(&rigid->body[b], note->energy);
		l->ncounted++;
	}
	return TS_OK;
}

/* While particles move between ranks, members of bodies are not known, but bodies do not change. */
static bool particles_move(const struct tsim *sim)
{
	return sim->acted.stage >= TS_STAGE_PRE_EXCHANGE && sim->acted.stage <= TS_STAGE_POST_BUILD;
}

static enum ts_status add_bodies(struct tsim *sim, struct ts_ledger *l, struct ts_exactsum out[2])
{
	if (!sim->division || !particles_move(sim)) {
		TS_TRY(ts_rigid_list(sim));
		TS_TRY(note_bodies(sim, l));
	}
	for (size_t b = 0; b < l->ncounted; b++)
		for (int k = 0; k < 2; k++)
			ts_exactsum_add(&out[k], l->counted[b].energy[k]);
	return TS_OK;
}

enum ts_status ts_ledger_kinetic(struct tsim *sim, struct ts_ledger *l, struct ts_exactsum out[2])
{
	const struct ts_particles *p = sim->particles;

	out[0] = out[1] = ts_exactsum_start();
	for (size_t i = 0; i < p->n; i++) {
		if (ts_rigid_member(p, i))
			continue;
		ts_exactsum_add(&out[0], 0.5 * p->mass[i] * ts_dot(p->v[i], p->v[i]));
		if (p->omega)
			ts_exactsum_add(&out[1], 0.5 * ts_inertia(sim, i) * ts_dot(p->omega[i], p->omega[i]));
	}
	return add_bodies(sim, l, out);
}

/* Sums of one stage of kicks: by cause, then these, then work and own energy of each actor. HELD: of no known actor. */
enum { DRIVE = TS_NCAUSE, BOX, TURNING, HELD, KICK_SUMS };

struct kick {
	struct tsim *sim;
	struct ts_ledger *l;
	double h; /* s: half a time step */
	struct ts_exactsum *sum;
	size_t n;
};

static struct ts_exactsum *work_sum(const struct kick *k, size_t actor)
{
	return &k->sum[KICK_SUMS + 2 * actor];
}

static struct ts_exactsum *own_sum(const struct kick *k, size_t actor)
{
	return &k->sum[KICK_SUMS + 2 * actor + 1];
}

static enum ts_status kick_start(struct kick *k, struct tsim *sim, struct ts_ledger *l)
{
	*k = (struct kick){ .sim = sim, .l = l, .h = 0.5 * sim->clock.dt, .n = KICK_SUMS + 2 * l->nactors };
	k->sum = ts_alloc(k->n, sizeof *k->sum);
	return k->sum ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status post_kick(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				const double *value)
{
	(void)sim;
	for (int c = 0; c < TS_NCAUSE; c++)
		ts_compensated_add(&l->work[c], value[c]);
	ts_compensated_add(&l->drive, value[DRIVE]);
	ts_compensated_add(&l->box, value[BOX]);
	ts_compensated_add(&l->turning, value[TURNING]);
	ts_compensated_add(&l->held, value[HELD]);
	for (size_t a = 0; KICK_SUMS + 2 * a < entry->n; a++) {
		ts_compensated_add(&l->actor[a].work, value[KICK_SUMS + 2 * a]);
		ts_compensated_add(&l->actor[a].own, value[KICK_SUMS + 2 * a + 1]);
	}
	return TS_OK;
}

static enum ts_status kick_finish(struct kick *k)
{
	const struct ts_ledger_entry entry = { .post = post_kick, .n = k->n };
	enum ts_status status = ts_ledger_enter(k->sim, k->l, &entry, k->sum);

	ts_free(k->sum);
	return status;
}

/* s (F.v + T.omega - drive) of one cause. */
static double work_of(const double *cause, const double v[3], const double omega[3], double s)
{
	return s * (ts_dot(cause + TS_CAUSE_FORCE, v) + ts_dot(cause + TS_CAUSE_TORQUE, omega) -
		    cause[TS_CAUSE_DRIVE]);
}

/* Adds the works of all causes on particle i, which moves with these mean velocities for the time s. */
static void add_works(struct kick *k, size_t i, const double v[3], const double omega[3], double s)
{
	const struct ts_particles *p = k->sim->particles;
	const struct ts_ledger *l = k->l;
	const double *cause = ts_ledger_causes(l, p, i);
	bool busy = cause[TS_LEDGER_NONZERO] > 0;

	for (int c = 0; c < TS_NCAUSE && busy; c++, cause += TS_CAUSE_NUMBERS) {
		double work = work_of(cause, v, omega, s);

		if (work != 0)
			ts_exactsum_add(&k->sum[c], work);
		if (cause[TS_CAUSE_DRIVE] != 0)
			ts_exactsum_add(&k->sum[c < TS_NPART ? BOX : DRIVE], s * cause[TS_CAUSE_DRIVE]);
	}
	for (size_t a = 0; a < l->nactors; a++) {
		const struct ts_column *column = &p->column[l->actor[a].column];
		double work;

		if (!l->actor[a].pushes)
			continue;
		work = work_of((const double *)column->data + i * column->width, v, omega, s);
		if (work != 0)
			ts_exactsum_add(work_sum(k, a), work);
	}
}

static bool is_kick(const double before[3], const double after[3], const double push[3], double mass,
		    double s)
{
	bool is = true;

	for (int d = 0; d < 3; d++)
		is &= fabs(mass * (after[d] - before[d]) - s * push[d]) <=
		      kick_tolerance * (mass * (fabs(after[d]) + fabs(before[d])) + s * fabs(push[d]));
	return is;
}

static void mean(const double a[3], const double b[3], double out[3])
{
	for (int d = 0; d < 3; d++)
		out[d] = 0.5 * (a[d] + b[d]);
}

/* Accounts one particle. A velocity change beyond that by the forces, or constraints against them, is
 * attributed to the actor that changed the velocity. */
static void account_particle(struct kick *k, size_t i, double s)
{
	static const double still[3] = { 0 };
	const struct ts_particles *p = k->sim->particles;
	const struct ts_ledger *l = k->l;
	const double *w0 = p->omega ? l->omega[i] : still, *w1 = p->omega ? p->omega[i] : still;
	const double *torque = p->torque ? p->torque[i] : still;
	double v[3], w[3], mass = p->mass[i], inertia = ts_inertia(k->sim, i), rest;
	int32_t by = l->kicker[i];

	mean(l->v[i], p->v[i], v);
	mean(w0, w1, w);
	add_works(k, i, v, w, s);
	if (is_kick(l->v[i], p->v[i], p->f[i], mass, s) && is_kick(w0, w1, torque, inertia, s))
		return;
	rest = 0.5 * mass * (ts_dot(p->v[i], p->v[i]) - ts_dot(l->v[i], l->v[i])) +
	       0.5 * inertia * (ts_dot(w1, w1) - ts_dot(w0, w0)) - s * ts_dot(p->f[i], v) -
	       s * ts_dot(torque, w);
	ts_exactsum_add(by < 0 ? &k->sum[HELD] : own_sum(k, (size_t)by), rest);
}

/* State of body b after a kick: of the first half the kick alone, before the body moves. */
static struct ts_body body_after_kick(const struct ts_ledger *l, const struct ts_rigid *rigid, size_t b,
				      bool final, double h)
{
	struct ts_body after = l->body[b];

	if (final)
		return rigid->body[b];
	ts_body_hold(&after);
	ts_body_kick(&after, h);
	return after;
}

static bool all_directions_free(const struct ts_body *b)
{
	bool is = true;

	for (int d = 0; d < 6; d++)
		is &= b->free[d] == 1;
	return is;
}

static void account_body(struct kick *k, size_t b, bool final)
{
	const struct ts_rigid *rigid = k->sim->rigid;
	const struct ts_body *before = &k->l->body[b];
	struct ts_body after = body_after_kick(k->l, rigid, b, final, k->h);
	const struct ts_particles *p = k->sim->particles;
	double v[3], w0[3], w[3], m[3][3], arm[3], turn[3], at[3], power;

	ts_rigid_omega(before->q, before->inertia, before->spin, w0);
	mean(before->v, after.v, v);
	mean(w0, after.omega, w);
	ts_quaternion_matrix(before->q, m);
	power = ts_dot(rigid->body[b].external, v);
	for (size_t e = rigid->start[b]; e < rigid->start[b + 1]; e++) {
		size_t i = (size_t)rigid->member[e];

		ts_rotate(m, p->body_x[i], arm);
		ts_cross(w, arm, turn);
		ts_add(v, turn, at);
		if (i < p->n)
			add_works(k, i, at, w, k->h);
		power += ts_dot(p->f[i], at) + ts_dot(p->torque[i], w);
	}
	if (!counts_body(k->sim, b))
		return;
	if (!all_directions_free(before)) /* fixed directions */
		ts_exactsum_add(&k->sum[HELD], body_energy(&after) - body_energy(before) - k->h * power);
	ts_exactsum_add(&k->sum[TURNING], body_energy(&rigid->body[b]) - body_energy(&after));
}

enum ts_status ts_ledger_account_kicks(struct tsim *sim, struct ts_ledger *l, bool final)
{
	const struct ts_particles *p = sim->particles;
	struct kick k;

	TS_TRY(kick_start(&k, sim, l));
	for (size_t i = 0; i < p->n; i++) {
		double *whole = ts_ledger_causes(l, p, i) + TS_LEDGER_WHOLE_KICK;
		int32_t by = l->kicker[i];

		if (ts_rigid_member(p, i))
			continue;
		if (!final)
			*whole = by >= 0 && l->actor[by].by &&
				 !l->actor[by].by->style->hook[TS_STAGE_FINAL_INTEGRATE];
		if (final && *whole > 0)
			continue;
		account_particle(&k, i, *whole > 0 ? sim->clock.dt : k.h);
	}
	for (size_t b = 0; b < l->bodies && b < sim->rigid->n; b++)
		account_body(&k, b, final);
	return kick_finish(&k);
}

static void copy_vectors(double (*to)[3], double (*from)[3], size_t n)
{
	if (from && n)
		memcpy(to, from, n * sizeof *to);
}

enum ts_status ts_ledger_store_velocities(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_rigid *rigid = sim->rigid;

	copy_vectors(l->v, p->v, p->n);
	copy_vectors(l->omega, p->omega, p->n);
	copy_vectors(l->seen_v, p->v, p->n);
	copy_vectors(l->seen_omega, p->omega, p->n);
	for (size_t i = 0; i < p->n; i++)
		l->kicker[i] = -1;
	if (rigid->n)
		TS_TRY(ts_rigid_list(sim));
	if (TS_GROW(l->body, l->body_capacity, rigid->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	l->bodies = rigid->n;
	if (rigid->n)
		memcpy(l->body, rigid->body, rigid->n * sizeof *l->body);
	return TS_OK;
}

static bool differ(const double a[3], const double b[3])
{
	return a[0] != b[0] || a[1] != b[1] || a[2] != b[2];
}

void ts_ledger_mark_kicked(struct tsim *sim, struct ts_ledger *l, size_t actor)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		if (differ(l->seen_v[i], p->v[i]) || (p->omega && differ(l->seen_omega[i], p->omega[i])))
			l->kicker[i] = (int32_t)actor;
	copy_vectors(l->seen_v, p->v, p->n);
	copy_vectors(l->seen_omega, p->omega, p->n);
}
