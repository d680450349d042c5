/* Region plane: a half-space. */
#include "region/region.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

struct plane {
	struct ts_region region;
	double given_point[3], given_normal[3];
	double point[3], normal[3];
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct plane *p = self->state;
	double length;

	TS_TRY(ts_region_init(self, sim));
	for (int d = 0; d < 3; d++) {
		p->point[d] = p->region.scale[d] * p->given_point[d];
		p->normal[d] = p->region.scale[d] * p->given_normal[d];
	}
	length = ts_norm(p->normal);
	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region plane: the normal is zero, expected a direction");
	ts_scale(1 / length, p->normal, p->normal);
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct plane *p = self->state;
	double d[3];

	ts_sub(x, p->point, d);
	return ts_dot(d, p->normal) >= 0;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct plane *p = self->state;
	double d[3];

	ts_sub(x, p->point, d);
	return ts_dot(d, p->normal);
}

static int contact_points(const struct ts_instance *self, const double x[3], bool inside,
			  struct ts_region_contact_point *out)
{
	const struct plane *p = self->state;

	if (p->region.open)
		return 0;
	*out = (struct ts_region_contact_point){ .distance = fabs(depth(self, x)) };
	ts_scale(inside ? 1 : -1, p->normal, out->n);
	return 1;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct plane *p = self->state;

	for (int d = 0; d < 3; d++) {
		lo[d] = p->normal[d] == 1 ? p->point[d] : -INFINITY;
		hi[d] = p->normal[d] == -1 ? p->point[d] : INFINITY;
	}
}

static const struct ts_arg args[] = {
	TS_VEC3("point", struct plane, given_point, .flags = TS_POSITIONAL, .unit = "length",
		.help = "a point on the plane"),
	TS_VEC3("normal", struct plane, given_normal, .flags = TS_POSITIONAL,
		.help = "normal vector into the region, of any length"),
	TS_REGION_ARGS(struct plane),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_plane)
const struct ts_region_style ts_region_plane = {
	.style = {
		.name = "plane",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Half-space on one side of a plane",
		.doc = "All points with (x - point) . normal >= 0.",
		.example = "region upper plane 0 0 0.5 0 0 1 units box",
		.args = args,
		.state_size = sizeof(struct plane),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.faces = 1,
	.contact_points = contact_points,
};
