/* Region prism: a parallelepiped with one edge along x. */
#include "region/region.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

/* Edges from the corner (xlo ylo zlo): (lx 0 0), (xy ly 0), (xz yz lz). */
struct prism {
	struct ts_region region;
	double given[6]; /* xlo xhi ylo yhi zlo zhi as written */
	double given_tilt[3];
	double lo[3], hi[3], xy, xz, yz;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct prism *p = self->state;

	TS_TRY(ts_region_init(self, sim));
	for (int d = 0; d < 3; d++) {
		TS_TRY(ts_region_coord(self, sim, p->given[2 * d], d, &p->lo[d]));
		TS_TRY(ts_region_coord(self, sim, p->given[2 * d + 1], d, &p->hi[d]));
		if (isinf(p->lo[d]) || isinf(p->hi[d]))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "region prism: all faces must be finite; EDGE is the face of the box");
		if (p->lo[d] >= p->hi[d])
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "region prism: %clo = %g is not below %chi = %g", 'x' + d, p->lo[d],
				       'x' + d, p->hi[d]);
	}
	p->xy = p->region.scale[0] * p->given_tilt[0];
	p->xz = p->region.scale[0] * p->given_tilt[1];
	p->yz = p->region.scale[1] * p->given_tilt[2];
	return TS_OK;
}

/* Coordinates along the edges, 0 to 1 inside. */
static void coordinates(const struct prism *p, const double x[3], double a[3])
{
	a[2] = (x[2] - p->lo[2]) / (p->hi[2] - p->lo[2]);
	a[1] = (x[1] - p->lo[1] - a[2] * p->yz) / (p->hi[1] - p->lo[1]);
	a[0] = (x[0] - p->lo[0] - a[2] * p->xz - a[1] * p->xy) / (p->hi[0] - p->lo[0]);
}

static bool contains(const struct ts_instance *self, const double x[3])
{
	double a[3];

	coordinates(self->state, x, a);
	return a[0] >= 0 && a[0] <= 1 && a[1] >= 0 && a[1] <= 1 && a[2] >= 0 && a[2] <= 1;
}

/* Smallest distance to the planes of the six faces: the gradients of the coordinates are normal to these. */
static double distance_to_planes(const struct prism *p, const double a[3])
{
	double l[3] = { p->hi[0] - p->lo[0], p->hi[1] - p->lo[1], p->hi[2] - p->lo[2] };
	double across[3] = { 1, -p->xy / l[1], (p->xy * p->yz / l[1] - p->xz) / l[2] };
	double tilt = p->yz / l[2];

	return fmin(fmin(fmin(a[0], 1 - a[0]) * l[0] / ts_norm(across),
			 fmin(a[1], 1 - a[1]) * l[1] / sqrt(1 + tilt * tilt)),
		    fmin(a[2], 1 - a[2]) * l[2]);
}

/* Distance of r, relative to a corner, from the parallelogram with the edges u and v at that corner: on its plane, or on the
 * nearest of its edges. */
static double distance_from_face(const double u[3], const double v[3], const double r[3])
{
	double uu = ts_dot(u, u), uv = ts_dot(u, v), vv = ts_dot(v, v), ru = ts_dot(r, u), rv = ts_dot(r, v);
	double area2 = uu * vv - uv * uv, best = INFINITY;
	double a = (ru * vv - rv * uv) / area2, b = (rv * uu - ru * uv) / area2;
	bool within = a >= 0 && a <= 1 && b >= 0 && b <= 1;

	for (int k = 0; k < (within ? 1 : 4); k++) {
		double y[3];

		if (!within) { /* along an edge of u, or of v */
			a = k < 2 ? fmax(0, fmin(1, (ru - k * uv) / uu)) : k - 2;
			b = k < 2 ? k : fmax(0, fmin(1, (rv - (k - 2) * uv) / vv));
		}
		for (int d = 0; d < 3; d++)
			y[d] = r[d] - a * u[d] - b * v[d];
		best = fmin(best, ts_norm(y));
	}
	return best;
}

static double depth(const struct ts_instance *self, const double x[3])
{
	const struct prism *p = self->state;
	const double edge[3][3] = { { p->hi[0] - p->lo[0], 0, 0 },
				    { p->xy, p->hi[1] - p->lo[1], 0 },
				    { p->xz, p->yz, p->hi[2] - p->lo[2] } };
	double a[3], away = INFINITY;

	coordinates(p, x, a);
	for (int d = 0; d < 3; d++) { /* of two opposite faces the one towards x, if x is beyond it */
		double r[3];

		if (a[d] >= 0 && a[d] <= 1)
			continue;
		for (int k = 0; k < 3; k++)
			r[k] = x[k] - p->lo[k] - (a[d] > 1) * edge[d][k];
		away = fmin(away, distance_from_face(edge[(d + 1) % 3], edge[(d + 2) % 3], r));
	}
	return isinf(away) ? distance_to_planes(p, a) : -away;
}

static void bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct prism *p = self->state;

	for (int d = 0; d < 3; d++) {
		lo[d] = p->lo[d];
		hi[d] = p->hi[d];
	}
	lo[0] += fmin(0, p->xy) + fmin(0, p->xz);
	hi[0] += fmax(0, p->xy) + fmax(0, p->xz);
	lo[1] += fmin(0, p->yz);
	hi[1] += fmax(0, p->yz);
}

static double volume(const struct ts_instance *self)
{
	const struct prism *p = self->state;

	return (p->hi[0] - p->lo[0]) * (p->hi[1] - p->lo[1]) * (p->hi[2] - p->lo[2]);
}

#define END(name, k, help_) \
	TS_COORD(name, struct prism, given[k], .flags = TS_POSITIONAL, .unit = "length", .help = help_)
#define TILT(name, k, help_) \
	TS_REAL(name, struct prism, given_tilt[k], .flags = TS_POSITIONAL, .unit = "length", .help = help_)
static const struct ts_arg args[] = {
	END("xlo", 0, "lower x before the tilt, or EDGE"),
	END("xhi", 1, "upper x before the tilt, or EDGE"),
	END("ylo", 2, "lower y before the tilt, or EDGE"),
	END("yhi", 3, "upper y before the tilt, or EDGE"),
	END("zlo", 4, "lower z, or EDGE"),
	END("zhi", 5, "upper z, or EDGE"),
	TILT("xy", 0, "displacement of the upper y face in x"),
	TILT("xz", 1, "displacement of the upper z face in x"),
	TILT("yz", 2, "displacement of the upper z face in y"),
	TS_REGION_ARGS(struct prism),
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_prism)
const struct ts_region_style ts_region_prism = {
	.style = {
		.name = "prism",
		.kind = TS_KIND_REGION,
		.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
		.summary = "Parallelepiped",
		.doc = "The parallelepiped spanned by the edges (xhi-xlo 0 0), (xy yhi-ylo 0) and (xz yz\n"
		       "zhi-zlo) from the corner (xlo ylo zlo). Faces 1 to 6 are the lower and upper\n"
		       "faces of the three edges.",
		.example = "region ramp prism 0 1 0 1 0 0.5 0.2 0 0 units box",
		.args = args,
		.state_size = sizeof(struct prism),
		.init = init,
	},
	.contains = contains,
	.depth = depth,
	.bounds = bounds,
	.volume = volume,
	.faces = 6,
};
