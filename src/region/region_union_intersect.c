/* Regions that combine others: their union and their intersection. */
#include "region/region.h"

#include <math.h>

#include "base/banned.h"

struct state {
	struct ts_region region;
	int64_t n;
	struct ts_words names;
	struct ts_instance **member;
	double parts; /* plain regions in it, each as often as it is asked about a point */
};

static const double MOST_PARTS = 2e6;

extern const struct ts_region_style ts_region_union, ts_region_intersect;

/* An intersection has the points that are in all of its members, a union those in any. */
static bool wants_all(const struct ts_instance *self)
{
	return self->style == &ts_region_intersect.style;
}

static double parts_of(const struct ts_instance *region)
{
	bool made_of_others = region->style == &ts_region_union.style || wants_all(region);

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
		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &s->names.word[k], &s->member[k]));
		s->parts += parts_of(s->member[k]);
		s->region.varies |= ts_region_varies(s->member[k]);
		s->region.reshapes |= ts_region_reshapes(s->member[k]);
	}
	if (s->parts > MOST_PARTS)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "region %s: with its members and theirs it is made of %.3g regions, of which "
			       "each point is asked; at most %g are allowed: name each region once",
			       self->style->name, s->parts, MOST_PARTS);
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
	bool all = wants_all(self);

	for (int64_t k = 0; k < s->n; k++)
		if (ts_region_contains(s->member[k], x) != all)
			return !all;
	return all;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct state *s = self->state;
	bool all = wants_all(self);
	double d = all ? INFINITY : -INFINITY;

	for (int64_t k = 0; k < s->n; k++) {
		double one = ts_region_depth(s->member[k], x);

		if (isnan(one))
			return NAN;
		d = all ? fmin(d, one) : fmax(d, one);
	}
	return d;
}

/* ---- the surface: faces of the members */

static const struct ts_instance *member(const struct ts_instance *self, int64_t k)
{
	const struct state *s = self->state;

	return k < s->n ? s->member[k] : NULL;
}

/* A spot of a member bounds the whole where all other members have it, or of a union none. */
static bool bounds_whole(const struct ts_instance *self, int64_t of, const double x[3],
			 const struct ts_region_contact_point *spot)
{
	const struct state *s = self->state;
	bool all = wants_all(self);
	double at[3];

	for (int d = 0; d < 3; d++)
		at[d] = x[d] - spot->distance * spot->n[d];
	for (int64_t k = 0; k < s->n; k++)
		if (k != of && ts_region_contains(s->member[k], at) != all)
			return false;
	return true;
}

static int spots(const struct ts_instance *self, const double x[3], bool inside,
		 struct ts_region_contact_point *out)
{
	const struct state *s = self->state;
	int n = 0, first = 0;

	for (int64_t k = 0; k < s->n; k++) {
		const struct ts_instance *one = s->member[k];
		const struct ts_region *r = one->state;
		/* from within the whole only members that have x turn faces to it */
		bool seen = r->open || ts_region_contains(one, x) == inside;
		int end = n + (seen ? ts_region_contact_points_all(one, x, out + n) : 0);

		for (int at = n; at < end; at++) {
			if (!bounds_whole(self, k, x, &out[at]))
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
	bool all = wants_all(self);
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
	TS_LIST("regions", struct state, names, .help = "the names of n regions"),
	TS_REGION_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_union)
const struct ts_region_style ts_region_union = {
	.style = {
		.name = "union",
		.kind = TS_KIND_REGION,
		.summary = "All points of any of several regions",
		.doc = "A point belongs to it if it belongs to at least one of the n regions; the side of "
		       "each\n"
		       "counts. With the members of members, each counted as often as it is named, at most "
		       "2e6 regions.",
		.example = "region both union 2 left right",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.update = update,
	.spots = spots,
	.member = member,
};

TS_STYLE(region, ts_region_style, ts_region_intersect)
const struct ts_region_style ts_region_intersect = {
	.style = {
		.name = "intersect",
		.kind = TS_KIND_REGION,
		.summary = "All points that several regions share",
		.doc = "A point belongs to it if it belongs to all of the n regions; the side of each "
		       "counts, so\n"
		       "that a region with `side out` cuts a hole.",
		.example = "region ring intersect 2 outer_cylinder not_inner_cylinder",
		.args = args,
		.state_size = sizeof(struct state),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.update = update,
	.spots = spots,
	.member = member,
};
