/* Region block: an axis-aligned box. */
#include "region/region.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

struct block {
	struct ts_region region;
	double lo[3], hi[3];
	double given[6]; /* xlo xhi ylo yhi zlo zhi as written */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct block *b = self->state;

	TS_TRY(ts_region_init(self, sim));
	for (int d = 0; d < 3; d++) {
		TS_TRY(ts_region_coord(self, sim, b->given[2 * d], d, &b->lo[d]));
		TS_TRY(ts_region_coord(self, sim, b->given[2 * d + 1], d, &b->hi[d]));
		if (b->lo[d] > b->hi[d])
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "region block: %clo = %g is above %chi = %g", 'x' + d, b->lo[d],
				       'x' + d, b->hi[d]);
	}
	return TS_OK;
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	const struct block *b = self->state;

	for (int d = 0; d < 3; d++)
		if (x[d] < b->lo[d] || x[d] > b->hi[d])
			return false;
	return true;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct block *b = self->state;
	double least = INFINITY, beyond = 0;

	for (int d = 0; d < 3; d++) {
		double in = fmin(x[d] - b->lo[d], b->hi[d] - x[d]);

		least = fmin(least, in);
		beyond += in < 0 ? in * in : 0;
	}
	return least < 0 ? -sqrt(beyond) : least;
}

/* Contact points from inside: one on the plane of each face. */
static int contact_points_inside(const struct block *b, const double x[3],
				 struct ts_region_contact_point *out)
{
	int n = 0;

	for (int face = 0; face < 6; face++) {
		int d = face / 2;

		if (b->region.open & 1u << face)
			continue;
		out[n] = (struct ts_region_contact_point){ .face = face };
		out[n].distance = face % 2 ? b->hi[d] - x[d] : x[d] - b->lo[d];
		out[n++].n[d] = face % 2 ? -1 : 1;
	}
	return n;
}

/* at: the point of the face closest to x; returns the squared distance. */
static double nearest_on_face(const struct block *b, int face, const double x[3], double at[3])
{
	for (int d = 0; d < 3; d++)
		at[d] = fmin(fmax(x[d], b->lo[d]), b->hi[d]);
	at[face / 2] = face % 2 ? b->hi[face / 2] : b->lo[face / 2];
	return ts_distance2(x, at);
}

/* The contact point from outside: the closest point of all faces. Returns 0 if all are open. */
static int contact_point_outside(const struct block *b, const double x[3],
				 struct ts_region_contact_point *out)
{
	double at[3], d2, least = INFINITY;

	for (int face = 0; face < 6; face++) {
		if (b->region.open & 1u << face)
			continue;
		d2 = nearest_on_face(b, face, x, at);
		if (!(d2 < least))
			continue;
		least = d2;
		*out = (struct ts_region_contact_point){ .distance = sqrt(d2) };
		for (int d = 0; d < 3 && d2 > 0; d++)
			out->n[d] = (x[d] - at[d]) / out->distance;
	}
	return isfinite(least);
}

static int contact_points(const struct ts_instance *self, const double x[3], bool inside,
			  struct ts_region_contact_point *out)
{
	return inside ? contact_points_inside(self->state, x, out)
		      : contact_point_outside(self->state, x, out);
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct block *b = self->state;

	for (int d = 0; d < 3; d++) {
		lo[d] = b->lo[d];
		hi[d] = b->hi[d];
	}
}

static double volume(const struct ts_instance *self)
{
	const struct block *b = self->state;

	return (b->hi[0] - b->lo[0]) * (b->hi[1] - b->lo[1]) * (b->hi[2] - b->lo[2]);
}

static const struct ts_arg args[] = {
	TS_COORD("xlo", struct block, given[0], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower x, INF or EDGE"),
	TS_COORD("xhi", struct block, given[1], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper x, INF or EDGE"),
	TS_COORD("ylo", struct block, given[2], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower y, INF or EDGE"),
	TS_COORD("yhi", struct block, given[3], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper y, INF or EDGE"),
	TS_COORD("zlo", struct block, given[4], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "lower z, INF or EDGE"),
	TS_COORD("zhi", struct block, given[5], .flags = TS_POSITIONAL, .unit = "length",
		 .help = "upper z, INF or EDGE"),
	TS_REGION_ARGS(struct block),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_block)
const struct ts_region_style ts_region_block = {
	.style = {
		.name = "block",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Axis-aligned box",
		.doc = "All points with xlo <= x <= xhi, ylo <= y <= yhi and zlo <= z <= zhi. INF means\n"
		       "infinity; EDGE is the face of the simulation box at the time when the region is\n"
		       "defined. Faces 1 to 6 are xlo, xhi, ylo, yhi, zlo, zhi.",
		.example = "region bed block 0 1 0 1 0 0.5 units box\n"
			   "region top block INF INF INF INF 0.4 INF units box",
		.args = args,
		.state_size = sizeof(struct block),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.volume = volume,
	.faces = 6,
	.contact_points = contact_points,
};
