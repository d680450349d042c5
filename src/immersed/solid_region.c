/* Regions as solids: distance from the surface, normal by finite differences. */
#include "immersed/solid.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "flow/projection.h"
#include "math/vec3.h"
#include "region/region.h"

#include "base/banned.h"

struct region {
	struct ts_solid solid; /* first */
	struct ts_instance *instance;
	const struct ts_solid_prescribed *prescribed;
	struct ts_solid_pose *before;
};

static struct ts_solid_pose region_pose(const struct ts_region *r, double time)
{
	struct ts_solid_pose s = { .time = time, .seen = true };

	memcpy(s.shift, r->shift, sizeof s.shift);
	memcpy(s.turn, r->turn, sizeof s.turn);
	return s;
}

/* A point y of the shape is at turn (y - pivot) + pivot + shift. */
static void transform_point(const struct ts_region *r, const struct ts_solid_pose *s, const double y[3],
			    double x[3])
{
	double arm[3];

	ts_sub(y, r->pivot, arm);
	for (int k = 0; k < 3; k++)
		x[k] = ts_dot(s->turn[k], arm) + r->pivot[k] + s->shift[k];
}

/* Mean velocity and angular velocity between two poses; the rotation between them by its angle and axis. */
static void motion_between(const struct ts_region *r, const struct ts_solid_pose *a,
			   const struct ts_solid_pose *b, const double home[3], struct ts_solid_motion *m)
{
	double x[2][3], q[3][3] = { { 0 } }, axis[3], angle, dt = b->time - a->time;

	transform_point(r, a, home, x[0]);
	transform_point(r, b, home, x[1]);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			q[i][j] = ts_dot(b->turn[i], a->turn[j]);
	axis[0] = 0.5 * (q[2][1] - q[1][2]);
	axis[1] = 0.5 * (q[0][2] - q[2][0]);
	axis[2] = 0.5 * (q[1][0] - q[0][1]);
	angle = atan2(ts_norm(axis), 0.5 * (q[0][0] + q[1][1] + q[2][2] - 1));
	for (int k = 0; k < 3; k++) {
		m->velocity[k] = (x[1][k] - x[0][k]) / dt;
		m->omega[k] = ts_norm(axis) > 0 ? axis[k] / ts_norm(axis) * angle / dt : 0;
	}
}

/* Centre of the shape as defined, before it moves; where it has no end, it ends with the box. */
static void shape_centre(const struct region *s, const struct tsim *sim, double home[3])
{
	const struct ts_region_style *style = (const struct ts_region_style *)s->instance->style;
	double lo[3], hi[3];

	style->bounds(s->instance, lo, hi);
	for (int k = 0; k < 3; k++)
		home[k] = 0.5 * ((isfinite(lo[k]) ? lo[k] : sim->domain->box.lo[k]) +
				 (isfinite(hi[k]) ? hi[k] : sim->domain->box.hi[k]));
	if (s->prescribed->centre)
		memcpy(home, s->prescribed->motion.centre, sizeof s->prescribed->motion.centre);
}

/* Whether the shape depends on variables, also through the regions it consists of. */
static bool shape_varies(const struct tsim *sim, const struct ts_instance *region)
{
	for (size_t k = 0; k < region->words.n; k++) {
		const char *word = region->words.word[k].text;
		const struct ts_instance *member = ts_sim_find(sim, TS_KIND_REGION, word);

		if (strncmp(word, "v_", 2) == 0 || (member && member != region && shape_varies(sim, member)))
			return true;
	}
	return false;
}

/* Whether this is the beginning of a run while the fluid waits (`every`): the velocity is that since its last step. */
static bool fluid_waits(const struct tsim *sim, const struct ts_solid_pose *before, double time)
{
	static const double ROUND_OFF = 1e-9;
	const struct ts_projection *p = ts_sim_only(sim, TS_KIND_FLOW)->state;

	return before->seen && p->waited > 0 && p->waited < p->every &&
	       fabs(time - before->time - p->elapsed) <= ROUND_OFF * p->elapsed;
}

static enum ts_status update(struct ts_solid *solid, struct tsim *sim)
{
	struct region *s = (struct region *)solid;
	const struct ts_region *r = s->instance->state;
	const struct ts_region_style *style = (const struct ts_region_style *)s->instance->style;
	struct ts_solid_motion *m = solid->motion;
	double home[3];
	struct ts_solid_pose now;

	TS_TRY(ts_region_update(s->instance, sim));
	now = region_pose(r, ts_sim_time(sim));
	shape_centre(s, sim, home);
	transform_point(r, &now, home, m->centre);
	solid->moved = !s->before->seen || (style->update && shape_varies(sim, s->instance)) ||
		       memcmp(&now, s->before, offsetof(struct ts_solid_pose, time)) != 0;
	memset(m->velocity, 0, sizeof m->velocity);
	memset(m->omega, 0, sizeof m->omega);
	if (r->moves && s->before->seen && now.time > s->before->time)
		motion_between(r, s->before, &now, home, m);
	if (s->prescribed->velocity)
		memcpy(m->velocity, s->prescribed->motion.velocity, sizeof m->velocity);
	if (s->prescribed->omega)
		memcpy(m->omega, s->prescribed->motion.omega, sizeof m->omega);
	if (!fluid_waits(sim, s->before, now.time))
		*s->before = now;
	return TS_OK;
}

static void bounds(const struct ts_solid *solid, size_t part, double lo[3], double hi[3])
{
	(void)part;
	ts_region_bounds(((const struct region *)solid)->instance, lo, hi);
}

/* Normal as the gradient of the distance, by central differences over a small part of the reach. */
static void normal(const struct region *s, const double x[3], double reach, double n[3])
{
	double length;

	ts_region_depth_slope(ts_region_depth_at_edges, s->instance, x, 1e-4 * reach, n);
	for (int k = 0; k < 3; k++)
		n[k] = k < s->solid.dimensions ? -n[k] : 0;
	length = ts_norm(n);
	if (!(length > 0)) { /* the distance has no gradient there, deep inside */
		n[0] = 1;
		length = 1;
	}
	ts_scale(1 / length, n, n);
}

static enum ts_status find_surface(struct ts_solid *solid, size_t worker, size_t part, const double x[3],
				   double reach, enum ts_solid_side *side,
				   struct ts_solid_surface *surface_point)
{
	const struct region *s = (const struct region *)solid;

	(void)worker;
	(void)part;
	surface_point->distance = -ts_region_depth_at_edges(s->instance, x);
	*side = fabs(surface_point->distance) > reach ? TS_SOLID_FAR : TS_SOLID_NEAR;
	if (*side == TS_SOLID_FAR)
		return TS_OK;
	normal(s, x, reach, surface_point->n);
	ts_solid_rigid_velocity(solid->motion, x, surface_point);
	return TS_OK;
}

static bool inside(const struct ts_solid *solid, size_t part, const double x[3])
{
	(void)part;
	return ts_region_depth_at_edges(((const struct region *)solid)->instance, x) > 0;
}

static const struct ts_solid_kind kind = { update, bounds, find_surface, inside, NULL, NULL };

struct ts_solid *ts_solid_of_region(struct ts_instance *instance, int dimensions,
				    const struct ts_solid_prescribed *prescribed,
				    struct ts_solid_pose *before)
{
	struct region *s = ts_alloc(1, sizeof *s);

	if (!s)
		return NULL;
	s->solid = (struct ts_solid){ .kind = &kind, .parts = 1, .dimensions = dimensions };
	s->instance = instance;
	s->prescribed = prescribed;
	s->before = before;
	if (TS_GROW(s->solid.motion, s->solid.motion_capacity, 1) == TS_OK)
		return &s->solid;
	ts_free(s);
	return NULL;
}
