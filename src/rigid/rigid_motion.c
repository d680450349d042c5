#include "rigid/rigid_motion.h"

#include <string.h>

#include "box/domain.h"
#include "math/rigid_turn.h"
#include "math/symmetric3.h"
#include "particle/body.h"
#include "particle/moments.h"

#include "base/banned.h"

/* arm: R d of particle i. */
static void move_member(struct tsim *sim, const struct ts_body *b, size_t i, const double arm[3])
{
	struct ts_particles *p = sim->particles;
	double turn[3];

	ts_cross(b->omega, arm, turn);
	for (int k = 0; k < 3; k++) {
		p->x[i][k] = b->x[k] + arm[k] -
			     p->image[i][k] * ts_box_length(&sim->domain->box, k);
		p->v[i][k] = b->v[k] + turn[k];
		p->omega[i][k] = b->omega[k];
	}
}

void ts_rigid_place(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n)
{
	double m[3][3], arm[3];

	ts_quaternion_matrix(body->q, m);
	for (size_t k = 0; k < n; k++) {
		ts_rotate(m, sim->particles->body_x[row[k]], arm);
		move_member(sim, body, (size_t)row[k], arm);
	}
}

/* Velocities only: places are those of the step. */
static void set_velocities(struct tsim *sim, size_t b)
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_body *body = &r->body[b];
	struct ts_particles *p = sim->particles;
	double m[3][3], arm[3], turn[3];

	ts_quaternion_matrix(body->q, m);
	for (size_t k = r->start[b]; k < r->start[b + 1]; k++) {
		size_t i = (size_t)r->member[k];

		ts_rotate(m, p->body_x[i], arm);
		ts_cross(body->omega, arm, turn);
		ts_add(body->v, turn, p->v[i]);
		memcpy(p->omega[i], body->omega, sizeof body->omega);
	}
}

/* F and T of the members act on the body: T += arm x F. */
static void gather(struct tsim *sim, size_t b)
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_particles *p = sim->particles;
	struct ts_body *body = &r->body[b];
	double m[3][3], arm[3], turn[3];

	memcpy(body->force, body->external, sizeof body->force);
	memset(body->torque, 0, sizeof body->torque);
	ts_quaternion_matrix(body->q, m);
	for (size_t k = r->start[b]; k < r->start[b + 1]; k++) {
		size_t i = (size_t)r->member[k];

		ts_rotate(m, p->body_x[i], arm);
		ts_cross(arm, p->f[i], turn);
		ts_add(body->force, p->f[i], body->force);
		ts_add(turn, p->torque[i], turn);
		ts_add(body->torque, turn, body->torque);
	}
	for (int k = 0; k < 3; k++) {
		body->force[k] *= body->free[k];
		body->torque[k] *= body->free[3 + k];
	}
}

void ts_body_kick(struct ts_body *b, double h)
{
	for (int k = 0; k < 3; k++) {
		b->v[k] += h * b->force[k] / b->mass;
		b->spin[k] += h * b->torque[k];
	}
	ts_rigid_omega(b->q, b->inertia, b->spin, b->omega);
}

void ts_body_move(struct ts_body *b, double dt)
{
	ts_axpy(dt, b->v, b->x);
	ts_rigid_turn(b->inertia, b->spin, b->omega, dt, b->q);
}

/* ---- the stages: all that is done with a body, and its members, at once */

static void begin_step(struct tsim *sim, size_t b)
{
	struct ts_rigid *r = sim->rigid;
	double dt = sim->clock.dt;

	ts_body_kick(&r->body[b], 0.5 * dt);
	ts_body_move(&r->body[b], dt);
	ts_rigid_place(sim, &r->body[b], r->member + r->start[b], r->start[b + 1] - r->start[b]);
}

static void end_step(struct tsim *sim, size_t b)
{
	gather(sim, b);
	ts_body_kick(&sim->rigid->body[b], 0.5 * sim->clock.dt);
	set_velocities(sim, b);
}

/* Bodies stand in the order of their identities, but are taken as their members are in memory: so many before their
 * turn they are sent for. */
enum { AHEAD = 4 };

static enum ts_status each_body(struct tsim *sim, void (*work)(struct tsim *sim, size_t b))
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
#pragma omp parallel for num_threads(ts_team(sim, r->n)) schedule(static)
	for (size_t k = 0; k < r->ordered; k++) {
		const char *next = (const char *)&r->body[r->order[k + AHEAD < r->ordered ? k + AHEAD : k]];

		for (size_t line = 0; line < sizeof *r->body; line += 64)
			__builtin_prefetch(next + line, 1);
		work(sim, (size_t)r->order[k]);
	}
	return TS_OK;
}

enum ts_status ts_rigid_initial(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_rigid *r = self->state;

	if (!r->n)
		return TS_OK;
	ts_sweep(sim);
	return each_body(sim, begin_step);
}

enum ts_status ts_rigid_clear(struct ts_instance *self, struct tsim *sim)
{
	struct ts_rigid *r = self->state;

	(void)sim;
	for (size_t b = 0; b < r->n; b++)
		memset(r->body[b].external, 0, sizeof r->body[b].external);
	return TS_OK;
}

enum ts_status ts_rigid_final(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_rigid *r = self->state;

	if (!r->n)
		return TS_OK;
	ts_sweep(sim);
	return each_body(sim, end_step);
}

/* What acts on the bodies at the start. A run that goes on has it from the last step. */
enum ts_status ts_rigid_setup(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_rigid *r = self->state;

	if (!r->n || sim->resuming)
		return TS_OK;
	return each_body(sim, gather);
}

/* I = sum of (I_i + m (d^2 1 - d d)). */
static void add_inertia(const struct tsim *sim, size_t i, const double d[3], double tensor[6])
{
	double m = sim->particles->mass[i], own = ts_inertia(sim, i), d2 = ts_dot(d, d);

	for (int k = 0; k < 3; k++)
		tensor[k] += own + m * (d2 - d[k] * d[k]);
	tensor[3] -= m * d[0] * d[1];
	tensor[4] -= m * d[0] * d[2];
	tensor[5] -= m * d[1] * d[2];
}

void ts_rigid_principal(struct ts_body *body, const double tensor[6])
{
	double m[3][3], last[3], most;

	ts_symmetric3_eigen(tensor, body->inertia, m);
	most = fmax(body->inertia[0], fmax(body->inertia[1], body->inertia[2]));
	for (int k = 0; k < 3; k++) /* a line of points, to rounding */
		if (body->inertia[k] < 1e-12 * most)
			body->inertia[k] = 0;
	ts_cross((double[]){ m[0][0], m[1][0], m[2][0] }, (double[]){ m[0][1], m[1][1], m[2][1] },
		 last);
	for (int k = 0; k < 3; k++) /* right-handed */
		m[k][2] = last[k];
	ts_quaternion_of_matrix(m, body->q);
}

enum ts_status ts_rigid_of_spheres(struct tsim *sim, const int32_t *row, size_t n,
				   struct ts_body *body)
{
	const struct ts_particles *p = sim->particles;
	double tensor[6] = { 0 }, x[3], d[3], l[3];

	*body = (struct ts_body){ .free = { 1, 1, 1, 1, 1, 1 } };
	for (size_t k = 0; k < n; k++) {
		size_t i = (size_t)row[k];

		ts_unwrapped(sim, i, x);
		body->mass += p->mass[i];
		ts_axpy(p->mass[i], x, body->x);
		ts_axpy(p->mass[i], p->v[i], body->v);
	}
	if (!(body->mass > 0))
		return ts_fail(&sim->error, TS_PHYSICS, NULL, "a rigid body without mass");
	ts_scale(1 / body->mass, body->x, body->x);
	ts_scale(1 / body->mass, body->v, body->v);
	for (size_t k = 0; k < n; k++) {
		size_t i = (size_t)row[k];

		ts_unwrapped(sim, i, x);
		ts_sub(x, body->x, d);
		add_inertia(sim, i, d, tensor);
		ts_cross(d, p->v[i], l);
		ts_axpy(p->mass[i], l, body->spin);
		if (p->omega)
			ts_axpy(ts_inertia(sim, i), p->omega[i], body->spin);
	}
	ts_rigid_principal(body, tensor);
	ts_rigid_omega(body->q, body->inertia, body->spin, body->omega);
	return TS_OK;
}
