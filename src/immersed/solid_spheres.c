/* Particles as solids: each sphere (in two dimensions: disc) is a part. */
#include "immersed/solid.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"
#include "particle/identity.h"

#include "base/banned.h"

struct spheres {
	struct ts_solid solid; /* first */
	int group;
	int32_t *row; /* of each part */
	size_t capacity;
	const struct ts_particles *particles;
};

static enum ts_status update(struct ts_solid *solid, struct tsim *sim)
{
	struct spheres *s = (struct spheres *)solid;
	const struct ts_particles *p = sim->particles;
	struct ts_identities all;

	TS_TRY(ts_identities(sim, true, &all));
	s->particles = p;
	solid->parts = 0;
	solid->moved = true;
	if (TS_GROW(s->row, s->capacity, p->n) != TS_OK ||
	    TS_GROW(solid->motion, solid->motion_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	/* in the order of identities, which decides between two equally near spheres */
	for (size_t a = 0; a < all.n; a++) {
		size_t i = (size_t)all.row[a];
		struct ts_solid_motion *m = &solid->motion[solid->parts];

		if (!ts_in_group(p, i, s->group))
			continue;
		memcpy(m->centre, p->x[i], sizeof m->centre);
		memcpy(m->velocity, p->v[i], sizeof m->velocity);
		for (int k = 0; k < 3; k++)
			m->omega[k] = p->omega && (solid->dimensions == 3 || k == 2) ? p->omega[i][k] : 0;
		s->row[solid->parts++] = (int32_t)i;
	}
	return TS_OK;
}

static void bounds(const struct ts_solid *solid, size_t part, double lo[3], double hi[3])
{
	const struct spheres *s = (const struct spheres *)solid;
	double r = s->particles->radius[s->row[part]];

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
	surface_point->distance = length - s->particles->radius[s->row[part]];
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

	return arm_of(solid, part, x, arm) < s->particles->radius[s->row[part]];
}

static void release(struct ts_solid *solid)
{
	ts_free(((struct spheres *)solid)->row);
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
