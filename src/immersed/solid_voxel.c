/* Height fields as solids. */
#include "immersed/solid.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "math/vec3.h"
#include "voxel/voxel_distance.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

struct columns {
	struct ts_solid solid; /* first */
	const struct ts_voxel_surface *surface;
	const struct ts_grid *grid;
	struct ts_voxel_space space; /* owned */
	const struct ts_solid_prescribed *prescribed;
	double shift[3], low[3], high[3]; /* displacement, extents at the last update */
};

/* Relative tolerance for round-off of lengths in the script. */
static const double ROUNDING = 1e-9;

/* Extents, infinite where the field is periodic or reaches the end of the grid: what is beyond does not matter, and the
 * end of the field there is no surface. */
static void find_extents(struct columns *s)
{
	const struct ts_voxel_field *f = &s->surface->field;
	double base;
	int up;

	for (int d = 0; d < 2; d++) {
		int axis = f->axis[d];
		double lo = f->origin[d] + s->shift[axis],
		       hi = ts_voxel_border(f, d, f->n[d]) + s->shift[axis];
		double from = s->grid->face[axis][0], to = s->grid->face[axis][s->grid->n[axis]];
		bool across = !s->grid->periodic[axis];

		s->space.continues[d][0] = across && lo <= from + ROUNDING * (to - from);
		s->space.continues[d][1] = across && hi >= to - ROUNDING * (to - from);
		s->low[axis] = f->periodic[d] || s->space.continues[d][0] ? -INFINITY : lo;
		s->high[axis] = f->periodic[d] || s->space.continues[d][1] ? INFINITY : hi;
	}
	up = f->axis[2];
	base = f->base + s->shift[up];
	s->space.bottomless = !s->grid->periodic[up] && base <= s->grid->face[up][0];
	s->low[up] = s->space.bottomless ? -INFINITY : base;
	s->high[up] = ts_voxel_highest(f) + s->shift[up];
}

/* Middle of the field along an axis; where it has no end, it ends with the box, before it moves. */
static double middle(const struct columns *s, const struct ts_box *box, int d)
{
	const double lo = isfinite(s->low[d]) ? s->low[d] : box->lo[d] + s->shift[d];
	const double hi = isfinite(s->high[d]) ? s->high[d] : box->hi[d] + s->shift[d];

	return isfinite(s->low[d]) || isfinite(s->high[d]) ? 0.5 * (lo + hi)
							   : 0.5 * (box->lo[d] + box->hi[d]);
}

static enum ts_status update(struct ts_solid *solid, struct tsim *sim)
{
	struct columns *s = (struct columns *)solid;
	struct ts_solid_motion *m = solid->motion;
	bool reshaped;

	if (ts_voxel_space_update(&s->space, &s->surface->field, &reshaped) != TS_OK)
		return ts_nomem(&sim->error);
	solid->moved = reshaped || memcmp(s->shift, s->surface->shift, sizeof s->shift) != 0;
	memcpy(s->shift, s->surface->shift, sizeof s->shift);
	find_extents(s);
	for (int d = 0; d < 3; d++)
		m->centre[d] = middle(s, &sim->domain->box, d);
	if (s->prescribed->centre)
		memcpy(m->centre, s->prescribed->motion.centre, sizeof m->centre);
	memcpy(m->velocity, s->prescribed->velocity ? s->prescribed->motion.velocity : s->surface->velocity,
	       sizeof m->velocity);
	memset(m->omega, 0, sizeof m->omega);
	if (s->prescribed->omega)
		memcpy(m->omega, s->prescribed->motion.omega, sizeof m->omega);
	return TS_OK;
}

static void bounds(const struct ts_solid *solid, size_t part, double lo[3], double hi[3])
{
	const struct columns *s = (const struct columns *)solid;

	(void)part;
	memcpy(lo, s->low, sizeof s->low);
	memcpy(hi, s->high, sizeof s->high);
}

static enum ts_status find_surface(struct ts_solid *solid, size_t worker, size_t part, const double x[3],
				   double reach, enum ts_solid_side *side,
				   struct ts_solid_surface *surface_point)
{
	const struct columns *s = (const struct columns *)solid;
	struct ts_voxel_distance near;
	double y[3];

	(void)worker;
	(void)part;
	ts_sub(x, s->shift, y);
	*side = ts_voxel_signed_distance(&s->surface->field, &s->space, y, reach, &near) ? TS_SOLID_NEAR
											 : TS_SOLID_FAR;
	if (*side == TS_SOLID_FAR)
		return TS_OK;
	surface_point->distance = near.distance;
	memcpy(surface_point->n, near.n, sizeof near.n);
	ts_solid_rigid_velocity(solid->motion, x, surface_point);
	return TS_OK;
}

static bool inside(const struct ts_solid *solid, size_t part, const double x[3])
{
	const struct columns *s = (const struct columns *)solid;
	double y[3];

	(void)part;
	ts_sub(x, s->shift, y);
	return ts_voxel_inside(&s->surface->field, y);
}

static void release(struct ts_solid *solid)
{
	ts_voxel_field_release(&((struct columns *)solid)->space.field);
}

static const struct ts_solid_kind kind = { update, bounds, find_surface, inside, release, NULL };

struct ts_solid *ts_solid_of_voxels(const struct ts_voxel_surface *surface, const struct ts_grid *grid,
				    int dimensions, const struct ts_solid_prescribed *prescribed)
{
	struct columns *s = ts_alloc(1, sizeof *s);

	if (!s)
		return NULL;
	s->solid = (struct ts_solid){ .kind = &kind, .parts = 1, .dimensions = dimensions };
	s->surface = surface;
	s->grid = grid;
	s->prescribed = prescribed;
	if (TS_GROW(s->solid.motion, s->solid.motion_capacity, 1) == TS_OK)
		return &s->solid;
	ts_free(s);
	return NULL;
}
