/* Regions union and intersect: combinations of other regions. */
#include "region/region.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"

#include "base/banned.h"

struct state {
	struct ts_region region;
	int64_t n;
	struct ts_words names;
	struct ts_instance **member;
	double parts; /* number of elementary regions that are evaluated for a point */
};

static const double MAX_PARTS = 2e6;

extern const struct ts_region_style ts_region_union, ts_region_intersect;

/* Points are in all members of an intersection, in at least one of a union. */
static bool is_intersection(const struct ts_instance *self)
{
	return self->style == &ts_region_intersect.style;
}

static double count_parts(const struct ts_instance *region)
{
	bool made_of_others = region->style == &ts_region_union.style || is_intersection(region);

	return made_of_others ? ((const struct state *)region->state)->parts : 1;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if ((size_t)s->n != s->names.n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "region %s: expected the names of %lld regions, found %zu", self->style->name,
			       (long long)s->n, s->names.n);
	if (!s->member)
		s->member = ts_arena_alloc(&self->arena, s->names.n, sizeof *s->member);
	if (!s->member)
		return ts_nomem(&sim->error);
	TS_TRY(ts_region_init(self, sim));
	s->parts = 0;
	for (size_t k = 0; k < s->names.n; k++) {
		struct ts_instance *member;

		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &s->names.word[k], &member));
		s->member[k] = member; /* else the deleted one, which is kept, stays */
		s->parts += count_parts(s->member[k]);
		s->region.varies |= ts_region_varies(s->member[k]);
		s->region.reshapes |= ts_region_reshapes(s->member[k]);
	}
	if (s->parts > MAX_PARTS)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region %s: with its members and theirs it consists of %.3g regions, which "
			       "are evaluated for each point; at most %g are allowed: name each region once",
			       self->style->name, s->parts, MAX_PARTS);
	return TS_OK;
}

static enum ts_status update(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	for (int64_t k = 0; k < s->n; k++)
		TS_TRY(ts_region_update(s->member[k], sim));
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct state *s = self->state;
	bool all = is_intersection(self);

	for (int64_t k = 0; k < s->n; k++)
		if (ts_region_contains(s->member[k], x) != all)
			return !all;
	return all;
}

/* ---- depth */

/* Moves x to the nearest point of the region if it is outside; `step`: of the differences for the normal. */
static void project_into(const struct ts_instance *region, double step, double x[3])
{
	double depth = ts_region_depth_at_edges(region, x), n[3], size;

	if (!(depth < 0))
		return;
	ts_region_depth_slope(ts_region_depth_at_edges, region, x, step, n);
	size = ts_norm(n);
	if (size > 0)
		ts_axpy(-depth / size, n, x);
}

/* Distance of a point outside an intersection; `least`: the largest distance from a member. Where faces of several members
 * meet it is longer: the distance from the nearest point of all, by alternating projections (J. P. Boyle & R. L. Dykstra,
 * Lect. Notes Stat. 37 (1986) 28), exact for convex members. */
static double distance_outside(const struct state *s, const double x[3], double least)
{
	enum { MOST = 8, SWEEPS = 50 };
	const double step = 1e-4 * least + 1e-7 * ts_norm(x);
	double y[3] = { x[0], x[1], x[2] }, correction[MOST][3] = { { 0 } }, moved = INFINITY;

	for (int sweep = 0; s->n <= MOST && sweep < SWEEPS && moved > 1e-6 * least; sweep++) {
		moved = 0;
		for (int64_t k = 0; k < s->n; k++) {
			double z[3], before[3] = { y[0], y[1], y[2] };

			ts_add(y, correction[k], z);
			memcpy(y, z, sizeof y);
			project_into(s->member[k], step, y);
			ts_sub(z, y, correction[k]);
			moved = fmax(moved, sqrt(ts_distance2(y, before)));
		}
	}
	return fmax(least, sqrt(ts_distance2(x, y)));
}

static double combine_depths(const struct ts_instance *self, const double x[3], ts_region_depth_fn *depth_of)
{
	const struct state *s = self->state;
	bool all = is_intersection(self);
	double d = all ? INFINITY : -INFINITY;

	for (int64_t k = 0; k < s->n; k++) {
		double one = depth_of(s->member[k], x);

		if (isnan(one))
			return NAN;
		d = all ? fmin(d, one) : fmax(d, one);
	}
	return d;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	return combine_depths(self, x, ts_region_depth);
}

static double depth_at_edges(const struct ts_instance *self, const double x[3])
{
	double d = combine_depths(self, x, ts_region_depth_at_edges);

	return is_intersection(self) && d < 0 ? -distance_outside(self->state, x, -d) : d;
}

/* ---- surface: faces of the members */

static const struct ts_instance *member(const struct ts_instance *self, int64_t k)
{
	const struct state *s = self->state;

	return k < s->n ? s->member[k] : NULL;
}

/* Whether a contact point of member `of` is on the surface: in all other members of an intersection, in
 * none of a union. */
static bool is_on_surface(const struct ts_instance *self, int64_t of, const double x[3],
			  const struct ts_region_contact_point *point)
{
	const struct state *s = self->state;
	bool all = is_intersection(self);
	double at[3];

	for (int d = 0; d < 3; d++)
		at[d] = x[d] - point->distance * point->n[d];
	for (int64_t k = 0; k < s->n; k++)
		if (k != of && ts_region_contains(s->member[k], at) != all)
			return false;
	return true;
}

static int contact_points(const struct ts_instance *self, const double x[3], bool inside,
			  struct ts_region_contact_point *out)
{
	const struct state *s = self->state;
	int n = 0, first = 0;

	for (int64_t k = 0; k < s->n; k++) {
		const struct ts_instance *one = s->member[k];
		const struct ts_region *r = one->state;
		/* from inside, only members that contain x have faces towards it */
		bool seen = r->open || ts_region_contains(one, x) == inside;
		int end = n + (seen ? ts_region_contact_points_all(one, x, out + n) : 0);

		for (int at = n; at < end; at++) {
			if (!is_on_surface(self, k, x, &out[at]))
				continue;
			out[n] = out[at];
			out[n++].face += first;
		}
		first += ts_region_faces(one);
	}
	return n;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct state *s = self->state;
	bool all = is_intersection(self);
	double a[3], b[3];

	for (int64_t k = 0; k < s->n; k++) {
		ts_region_bounds(s->member[k], a, b);
		for (int d = 0; d < 3; d++) {
			lo[d] = !k ? a[d] : all ? fmax(lo[d], a[d]) : fmin(lo[d], a[d]);
			hi[d] = !k ? b[d] : all ? fmin(hi[d], b[d]) : fmax(hi[d], b[d]);
		}
	}
}

static const struct ts_arg args[] = {
	TS_INT("n", struct state, n, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e6,
	       .help = "number of regions"),
	TS_LIST("regions", struct state, names, .help = "names of the n regions"),
	TS_REGION_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_union)
const struct ts_region_style ts_region_union = {
	.style = {
		.name = "union",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Union of regions",
		.doc = "All points that are in at least one of the n regions, each with its own side.\n"
		       "Including members of members, counted each time they are named, there may be at\n"
		       "most 2e6 regions.",
		.example = "region both union 2 left right",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.depth_at_edges = depth_at_edges,
	.bounds = bounds,
	.update = update,
	.contact_points = contact_points,
	.member = member,
};

TS_STYLE(region, ts_region_style, ts_region_intersect)
const struct ts_region_style ts_region_intersect = {
	.style = {
		.name = "intersect",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Intersection of regions",
		.doc = "All points that are in all of the n regions, each with its own side: a region\n"
		       "with `side out` cuts a hole.",
		.example = "region ring intersect 2 outer_cylinder not_inner_cylinder",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.depth_at_edges = depth_at_edges,
	.bounds = bounds,
	.update = update,
	.contact_points = contact_points,
	.member = member,
};
