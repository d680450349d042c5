#include "rigid/rigid_change.h"

#include "base/parallel.h"
#include "math/rigid_turn.h"

#include "base/banned.h"

static size_t members_in_group(const struct tsim *sim, size_t b, int group)
{
	const struct ts_rigid *r = sim->rigid;
	size_t n = 0;

	for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
		n += ts_in_group(sim->particles, (size_t)r->member[k], group);
	return n;
}

static bool all_in_group(const struct tsim *sim, size_t b, int group)
{
	const struct ts_rigid *r = sim->rigid;
	const size_t n = r->start[b + 1] - r->start[b];

	return n && members_in_group(sim, b, group) == n;
}

enum ts_status ts_rigid_require_whole(struct tsim *sim, int group, const char *who,
				      const struct ts_place *where)
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
	for (size_t b = 0; b < r->n; b++)
		if (members_in_group(sim, b, group) && !all_in_group(sim, b, group))
			return ts_fail(&sim->error, TS_STATE, where,
				       "%s: the rigid body of particle %d has %zu of its %zu members in "
				       "group %s; give the fix a group with all of them, or with none",
				       who, sim->particles->tag[r->member[r->start[b]]],
				       members_in_group(sim, b, group), r->start[b + 1] - r->start[b],
				       ts_group_name(sim, group));
	return TS_OK;
}

enum ts_status ts_rigid_refuse_resizing(struct tsim *sim, int group, const char *who,
					const struct ts_place *where)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; p->body && i < p->n; i++)
		if (ts_in_group(p, i, group) && ts_rigid_member(p, i))
			return ts_fail(&sim->error, TS_STATE, where,
				       "%s: particle %d belongs to a rigid body, whose mass and inertia "
				       "would not follow; give the fix a group without such particles",
				       who, p->tag[i]);
	return TS_OK;
}

/* Velocities of the members from those of the body. */
static void set_member_velocities(struct tsim *sim, size_t b)
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
		ts_scale(1, body->omega, p->omega[i]);
	}
}

static void subtract_from(struct ts_body *body, const struct ts_rigid_motion *motion)
{
	double arm[3], v[3];

	ts_sub(body->x, motion->centre, arm);
	ts_cross(motion->omega, arm, v);
	ts_add(motion->v, v, v);
	for (int k = 0; k < 3; k++) {
		body->v[k] -= body->free[k] * v[k];
		body->omega[k] -= body->free[3 + k] * motion->omega[k];
	}
	ts_rigid_angular_momentum(body->q, body->inertia, body->omega, body->spin);
}

enum ts_status ts_rigid_subtract_motion(struct tsim *sim, int group, bool clumps,
					const struct ts_rigid_motion *motion)
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
#pragma omp parallel for num_threads(ts_team(sim, r->n)) schedule(static)
	for (size_t b = 0; b < r->n; b++) {
		if ((clumps && !(r->body[b].kind > 0)) || !all_in_group(sim, b, group))
			continue;
		subtract_from(&r->body[b], motion);
		set_member_velocities(sim, b);
	}
	return TS_OK;
}

enum ts_status ts_rigid_scale_motion(struct tsim *sim, int group, double factor)
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
#pragma omp parallel for num_threads(ts_team(sim, r->n)) schedule(static)
	for (size_t b = 0; b < r->n; b++) {
		struct ts_body *body = &r->body[b];

		if (!all_in_group(sim, b, group))
			continue;
		ts_scale(factor, body->v, body->v);
		if (!(body->kind > 0)) {
			ts_scale(factor, body->omega, body->omega);
			ts_scale(factor, body->spin, body->spin);
		}
		set_member_velocities(sim, b);
	}
	return TS_OK;
}

enum ts_status ts_rigid_shift(struct tsim *sim, int group, const double shift[3])
{
	const struct ts_rigid *r = sim->rigid;
	struct ts_particles *p = sim->particles;

	TS_TRY(ts_rigid_list(sim));
#pragma omp parallel for num_threads(ts_team(sim, r->n)) schedule(static)
	for (size_t b = 0; b < r->n; b++) {
		if (!ts_rigid_in_group(r, p, b, group))
			continue;
		ts_add(r->body[b].x, shift, r->body[b].x);
		for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
			ts_add(p->x[r->member[k]], shift, p->x[r->member[k]]);
	}
	return TS_OK;
}
