/* Particles as solids: each sphere (in two dimensions: disc) is a part. */
#include "immersed/solid.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "math/vec3.h"
#include "particle/particles.h"
#include "rank/world.h"

#include "base/banned.h"

/* A sphere, for all ranks. */
struct sphere {
	struct ts_solid_motion motion;
	double radius;
	int32_t tag, row; /* row: of the particle, on the rank that has it */
};

_Static_assert(sizeof(struct sphere) == TS_SOLID_SPHERE_BYTES, "as the plan of a run says");

struct spheres {
	struct ts_solid solid; /* first */
	int group;
	int32_t *row; /* of each part; -1: its particle is on another rank */
	double *radius;
	size_t row_capacity, radius_capacity;
	struct ts_parcel own, all; /* struct sphere */
};

static struct sphere sphere_of(const struct ts_solid *solid, const struct ts_particles *p, size_t i)
{
	struct sphere out = { .radius = p->radius[i], .tag = p->tag[i], .row = (int32_t)i };

	memcpy(out.motion.centre, p->x[i], sizeof out.motion.centre);
	memcpy(out.motion.velocity, p->v[i], sizeof out.motion.velocity);
	for (int k = 0; k < 3; k++)
		out.motion.omega[k] = p->omega && (solid->dimensions == 3 || k == 2) ? p->omega[i][k] : 0;
	return out;
}

static enum ts_status list_own(struct spheres *s, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	s->own.n = 0;
	for (size_t i = 0; i < p->n; i++) {
		struct sphere sphere;

		if (!ts_in_group(p, i, s->group))
			continue;
		sphere = sphere_of(&s->solid, p, i);
		TS_TRY(ts_parcel_add(&s->own, &sphere, sizeof sphere));
	}
	return TS_OK;
}

static int by_identity(const void *a, const void *b)
{
	int32_t x = ((const struct sphere *)a)->tag, y = ((const struct sphere *)b)->tag;

	return (x > y) - (x < y);
}

/* The spheres of all ranks, in the order of identities, which decides between two equally near ones. */
static enum ts_status list_all(struct spheres *s, const struct tsim *sim, struct sphere **list, size_t *n)
{
	size_t first = 0;

	TS_TRY(list_own(s, sim));
	*list = (struct sphere *)(void *)s->own.data;
	*n = s->own.n / sizeof **list;
	if (sim->division) {
		size_t own = *n;

		s->all.n = 0;
		TS_TRY(ts_world_share_own(sim->world, &s->own, &s->all, &first));
		first /= sizeof **list;
		*list = (struct sphere *)(void *)s->all.data;
		*n = s->all.n / sizeof **list;
		for (size_t k = 0; k < *n; k++)
			if (k < first || k >= first + own)
				(*list)[k].row = -1;
	}
	ts_sort(*list, *n, sizeof **list, by_identity);
	return TS_OK;
}

static enum ts_status update(struct ts_solid *solid, struct tsim *sim)
{
	struct spheres *s = (struct spheres *)solid;
	struct sphere *list;
	size_t n;

	solid->parts = 0;
	solid->moved = true;
	if (list_all(s, sim, &list, &n) != TS_OK || TS_GROW(s->row, s->row_capacity, n) != TS_OK ||
	    TS_GROW(s->radius, s->radius_capacity, n) != TS_OK ||
	    TS_GROW(solid->motion, solid->motion_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++) {
		solid->motion[k] = list[k].motion;
		s->radius[k] = list[k].radius;
		s->row[k] = list[k].row;
	}
	solid->parts = n;
	return TS_OK;
}

static void bounds(const struct ts_solid *solid, size_t part, double lo[3], double hi[3])
{
	double r = ((const struct spheres *)solid)->radius[part];

	for (int k = 0; k < 3; k++) {
		lo[k] = k < solid->dimensions ? solid->motion[part].centre[k] - r : -INFINITY;
		hi[k] = k < solid->dimensions ? solid->motion[part].centre[k] + r : INFINITY;
	}
}

static double arm_of(const struct ts_solid *solid, size_t part, const double x[3], double arm[3])
{
	ts_sub(x, solid->motion[part].centre, arm);
	if (solid->dimensions == 2)
		arm[2] = 0;
	return ts_norm(arm);
}

static enum ts_status find_surface(struct ts_solid *solid, size_t worker, size_t part, const double x[3],
				   double reach, enum ts_solid_side *side,
				   struct ts_solid_surface *surface_point)
{
	const struct spheres *s = (const struct spheres *)solid;
	double length = arm_of(solid, part, x, surface_point->n);

	(void)worker;
	surface_point->distance = length - s->radius[part];
	*side = fabs(surface_point->distance) > reach ? TS_SOLID_FAR : TS_SOLID_NEAR;
	if (*side == TS_SOLID_FAR)
		return TS_OK;
	if (length > 0)
		ts_scale(1 / length, surface_point->n, surface_point->n);
	else
		surface_point->n[0] = 1;
	ts_solid_rigid_velocity(&solid->motion[part], x, surface_point);
	return TS_OK;
}

static bool inside(const struct ts_solid *solid, size_t part, const double x[3])
{
	const struct spheres *s = (const struct spheres *)solid;
	double arm[3];

	return arm_of(solid, part, x, arm) < s->radius[part];
}

static void release(struct ts_solid *solid)
{
	struct spheres *s = (struct spheres *)solid;

	ts_free(s->row);
	ts_free(s->radius);
	ts_parcel_release(&s->own);
	ts_parcel_release(&s->all);
}

static const struct ts_solid_kind kind = { update, bounds, find_surface, inside, release, NULL };

struct ts_solid *ts_solid_of_spheres(int group, int dimensions)
{
	struct spheres *s = ts_alloc(1, sizeof *s);

	if (!s)
		return NULL;
	s->solid = (struct ts_solid){ .kind = &kind, .dimensions = dimensions };
	s->group = group;
	return &s->solid;
}

int32_t ts_solid_sphere_row(const struct ts_solid *solid, size_t part)
{
	return ((const struct spheres *)solid)->row[part];
}
