#include "rigid/rigid_change.h"

#include "base/parallel.h"
#include "math/rigid_turn.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

enum ts_status ts_rigid_require_whole(struct tsim *sim, int group, const char *who,
				      const struct ts_place *where)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
	for (size_t b = 0; b < r->n; b++) {
		const size_t all = r->start[b + 1] - r->start[b];
		const size_t within = ts_rigid_members_in_group(r, p, b, group);

		if (within && within < all)
			return ts_fail(&sim->error, TS_STATE, where,
				       "%s: the rigid body of particle %d has %zu of its %zu members in "
				       "group %s; give the fix a group with all of them, or with none",
				       who, p->tag[r->member[r->start[b]]], within, all,
				       ts_group_name(sim, group));
	}
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

/* Velocities of the members from those of body b. */
static void set_member_velocities(struct tsim *sim, size_t b)
{
	const struct ts_rigid *r = sim->rigid;

	ts_rigid_set_velocities(sim, &r->body[b], r->member + r->start[b], r->start[b + 1] - r->start[b]);
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
		if ((clumps && !(r->body[b].kind > 0)) || !ts_rigid_all_in_group(r, sim->particles, b, group))
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

		if (!ts_rigid_all_in_group(r, sim->particles, b, group))
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
