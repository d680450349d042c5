#include "rigid/rigid_motion.h"

#include "box/domain.h"
#include "math/rigid_turn.h"
#include "math/symmetric3.h"
#include "particle/group_moments.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

/* Sets the velocities of member i; arm: its vector from the centre of mass, in space. */
static void set_velocities(struct tsim *sim, const struct ts_body *b, size_t i, const double arm[3])
{
	struct ts_particles *p = sim->particles;
	double rotational[3];

	ts_cross(b->omega, arm, rotational);
	for (int k = 0; k < 3; k++) {
		p->v[i][k] = b->v[k] + rotational[k];
		p->omega[i][k] = b->omega[k];
	}
}

void ts_rigid_attach(struct tsim *sim, const struct ts_body *body, int32_t id, const int32_t *row, size_t n)
{
	struct ts_particles *p = sim->particles;
	double m[3][3], arm[3];

	ts_quaternion_matrix(body->q, m);
	for (size_t k = 0; k < n; k++) {
		size_t i = (size_t)row[k];

		ts_unwrapped(sim, i, arm);
		ts_sub(arm, body->x, arm);
		ts_rotate_back(m, arm, p->body_x[i]);
		p->body[i] = id;
		p->imass[i] = 1 / body->mass;
	}
}

void ts_rigid_place(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n)
{
	struct ts_particles *p = sim->particles;
	double m[3][3], arm[3];

	ts_quaternion_matrix(body->q, m);
	for (size_t k = 0; k < n; k++) {
		size_t i = (size_t)row[k];

		ts_rotate(m, p->body_x[i], arm);
		for (int d = 0; d < 3; d++)
			p->x[i][d] =
				body->x[d] + arm[d] - p->image[i][d] * ts_box_length(&sim->domain->box, d);
		set_velocities(sim, body, i, arm);
	}
}

void ts_rigid_set_velocities(struct tsim *sim, const struct ts_body *body, const int32_t *row, size_t n)
{
	double m[3][3], arm[3];

	ts_quaternion_matrix(body->q, m);
	for (size_t k = 0; k < n; k++) {
		ts_rotate(m, sim->particles->body_x[row[k]], arm);
		set_velocities(sim, body, (size_t)row[k], arm);
	}
}

void ts_body_hold(struct ts_body *b)
{
	for (int k = 0; k < 3; k++) {
		b->force[k] *= b->free[k];
		b->torque[k] *= b->free[3 + k];
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
	ts_rigid_advance_orientation(b->inertia, b->spin, b->omega, dt, b->q);
}

/* Adds I_i + m (d^2 1 - d d) of particle i, with its own moment of inertia, to the inertia tensor. */
static void add_inertia(const struct tsim *sim, size_t i, double own, const double d[3], double tensor[6])
{
	double m = sim->particles->mass[i], d2 = ts_dot(d, d);

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
	for (int k = 0; k < 3; k++) /* points on a line: 0 instead of rounding errors */
		if (body->inertia[k] < 1e-12 * most)
			body->inertia[k] = 0;
	ts_cross((double[]){ m[0][0], m[1][0], m[2][0] }, (double[]){ m[0][1], m[1][1], m[2][1] }, last);
	for (int k = 0; k < 3; k++) /* right-handed */
		m[k][2] = last[k];
	ts_quaternion_of_matrix(m, body->q);
}

static enum ts_status body_of(struct tsim *sim, const int32_t *row, size_t n, bool points,
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
		double own = points ? 0 : ts_inertia(sim, i);

		ts_unwrapped(sim, i, x);
		ts_sub(x, body->x, d);
		add_inertia(sim, i, own, d, tensor);
		ts_cross(d, p->v[i], l);
		ts_axpy(p->mass[i], l, body->spin);
		if (p->omega)
			ts_axpy(own, p->omega[i], body->spin);
	}
	ts_rigid_principal(body, tensor);
	ts_rigid_omega(body->q, body->inertia, body->spin, body->omega);
	return TS_OK;
}

enum ts_status ts_rigid_of_spheres(struct tsim *sim, const int32_t *row, size_t n, struct ts_body *body)
{
	return body_of(sim, row, n, false, body);
}

enum ts_status ts_rigid_of_points(struct tsim *sim, const int32_t *row, size_t n, struct ts_body *body)
{
	return body_of(sim, row, n, true, body);
}
