/* Rigid bodies whose members were moved, or got other velocities, by commands between runs: `velocity`, `set`,
 * `displace_atoms`, `change_box`. */
#include "rigid/rigid_follow.h"

#include <string.h>

#include "math/rigid_turn.h"
#include "particle/group_moments.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

/* Relative differences that are not rounding errors. */
static const double OTHER_VELOCITY = 1e-9, OTHER_PLACE = 1e-6;

struct members {
	const int32_t *row;
	size_t n;
};

static struct members members_of(const struct ts_rigid *r, size_t b)
{
	return (struct members){ r->member + r->start[b], r->start[b + 1] - r->start[b] };
}

/* Vector from the centre of mass of the body to member i, by the place of the body. */
static void arm_of(const struct tsim *sim, const struct ts_body *body, size_t i, double arm[3])
{
	double m[3][3];

	ts_quaternion_matrix(body->q, m);
	ts_rotate(m, sim->particles->body_x[i], arm);
}

static void velocity_of(const struct ts_body *body, const double arm[3], double v[3])
{
	ts_cross(body->omega, arm, v);
	ts_add(body->v, v, v);
}

/* ---- velocities */

static bool moves_otherwise(const struct tsim *sim, const struct ts_body *body, size_t i)
{
	const struct ts_particles *p = sim->particles;
	double arm[3], v[3], speed;

	arm_of(sim, body, i, arm);
	velocity_of(body, arm, v);
	speed = ts_norm(body->v) + ts_norm(body->omega) * ts_norm(arm);
	return sqrt(ts_distance2(v, p->v[i])) > OTHER_VELOCITY * speed ||
	       sqrt(ts_distance2(body->omega, p->omega[i])) > OTHER_VELOCITY * ts_norm(body->omega);
}

/* Velocity of the centre of mass of the body if it moves with `members`. */
static void velocity_at_centre(const struct ts_body *members, struct ts_body *body)
{
	double arm[3], v[3];

	ts_sub(body->x, members->x, arm);
	velocity_of(members, arm, v);
	memcpy(body->v, v, sizeof body->v);
}

/* The motion of a body that is nearest to that of its members, in the norm of their kinetic energy: for spheres that do
 * not overlap, that with their momentum and angular momentum. The centre of mass of a clump is not that of its spheres:
 * there the velocity is that of the motion of their centres alone, so that equal velocities of all are that of the clump,
 * however the spheres rotate. */
static enum ts_status take_velocities(struct tsim *sim, struct ts_body *body, struct members m)
{
	struct ts_body spheres, points;

	TS_TRY(ts_rigid_of_spheres(sim, m.row, m.n, &spheres));
	memcpy(body->omega, spheres.omega, sizeof body->omega);
	if (body->kind > 0)
		TS_TRY(ts_rigid_of_points(sim, m.row, m.n, &points));
	velocity_at_centre(body->kind > 0 ? &points : &spheres, body);
	ts_rigid_angular_momentum(body->q, body->inertia, body->omega, body->spin);
	ts_rigid_set_velocities(sim, body, m.row, m.n);
	return TS_OK;
}

static enum ts_status take_changed_velocities(struct tsim *sim, size_t b)
{
	const struct ts_rigid *r = sim->rigid;
	struct members m = members_of(r, b);
	bool otherwise = false;

	for (size_t k = 0; k < m.n; k++)
		otherwise |= moves_otherwise(sim, &r->body[b], (size_t)m.row[k]);
	if (otherwise && m.n == (size_t)r->size[b] && ts_rigid_owner_lives(sim, r->owner[b]))
		return take_velocities(sim, &r->body[b], m);
	return TS_OK;
}

enum ts_status ts_rigid_take_velocities(struct tsim *sim)
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
	for (size_t b = 0; b < r->n; b++)
		TS_TRY(take_changed_velocities(sim, b));
	return TS_OK;
}

enum ts_status ts_rigid_take_clump_velocities(struct tsim *sim, int group)
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
	for (size_t b = 0; b < r->n; b++)
		if (r->body[b].kind > 0 && ts_rigid_all_in_group(r, sim->particles, b, group))
			TS_TRY(take_changed_velocities(sim, b));
	return TS_OK;
}

/* ---- places */

/* By which member i has been moved out of its place. */
static void shift_of(const struct tsim *sim, const struct ts_body *body, size_t i, double shift[3])
{
	double arm[3];

	arm_of(sim, body, i, arm);
	ts_unwrapped(sim, i, shift);
	ts_sub(shift, body->x, shift);
	ts_sub(shift, arm, shift);
}

/* Mean of the shifts of the members; *alike: all of them have it, but for rounding errors. */
static void mean_shift(const struct tsim *sim, const struct ts_body *body, struct members m, double mean[3],
		       bool *alike)
{
	double shift[3];

	memset(mean, 0, 3 * sizeof *mean);
	for (size_t k = 0; k < m.n; k++) {
		shift_of(sim, body, (size_t)m.row[k], shift);
		ts_axpy(1 / (double)m.n, shift, mean);
	}
	*alike = true;
	for (size_t k = 0; k < m.n; k++) {
		shift_of(sim, body, (size_t)m.row[k], shift);
		*alike &= sqrt(ts_distance2(shift, mean)) <= OTHER_PLACE * sim->particles->radius[m.row[k]];
	}
}

/* The body of the spheres where they are now. */
static enum ts_status reshape(struct tsim *sim, struct ts_body *body, int32_t id, struct members m)
{
	struct ts_body made;

	TS_TRY(ts_rigid_of_spheres(sim, m.row, m.n, &made));
	memcpy(made.free, body->free, sizeof made.free);
	*body = made;
	ts_rigid_attach(sim, body, id, m.row, m.n);
	return TS_OK;
}

static enum ts_status follow(struct tsim *sim, size_t b, bool reshapes, const char *who,
			     const struct ts_place *where)
{
	struct ts_rigid *r = sim->rigid;
	struct ts_body *body = &r->body[b];
	struct members m = members_of(r, b);
	double shift[3];
	bool alike;

	mean_shift(sim, body, m, shift, &alike);
	if (alike && !(ts_norm(shift) > OTHER_PLACE * sim->particles->radius[m.row[0]]))
		return TS_OK;
	if (!alike && reshapes && body->kind > 0)
		return ts_fail(&sim->error, TS_STATE, where,
			       "%s: particle %d belongs to a clump, whose spheres can be moved together only",
			       who, sim->particles->tag[m.row[0]]);
	if (!alike && reshapes)
		return reshape(sim, body, r->id[b], m);
	ts_add(body->x, shift, body->x);
	ts_rigid_place(sim, body, m.row, m.n);
	return TS_OK;
}

enum ts_status ts_rigid_follow(struct tsim *sim, bool reshapes, const char *who, const struct ts_place *where)
{
	struct ts_rigid *r = sim->rigid;

	if (!r->n)
		return TS_OK;
	TS_TRY(ts_rigid_list(sim));
	for (size_t b = 0; b < r->n; b++)
		if (r->start[b + 1] > r->start[b] && ts_rigid_owner_lives(sim, r->owner[b]))
			TS_TRY(follow(sim, b, reshapes, who, where));
	return TS_OK;
}
