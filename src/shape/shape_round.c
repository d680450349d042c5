/* Surfaces of revolution: disk, cylinder, tube, cone, conical hopper, and any profile. */
#include <math.h>

#include "math/constants.h"
#include "shape/internal.h"
#include "shape/lathe.h"

#include "base/banned.h"

const char *const ts_shape_open_names[] = { "none", "lower", "upper", "both", NULL };

const struct ts_arg ts_shape_disk_args[] = {
	TS_SHAPE_LENGTH("radius", disk.radius, "radius"),
	TS_SHAPE_LENGTH_OR("hole", disk.hole, "0", "radius of a hole in the middle"),
	TS_ARGS_END,
};

const struct ts_arg ts_shape_cylinder_args[] = {
	TS_SHAPE_LENGTH("radius", cylinder.radius, "radius"),
	TS_SHAPE_LENGTH("length", cylinder.length, "length"),
	TS_SHAPE_OPEN(cylinder.open),
	TS_ARGS_END,
};

const struct ts_arg ts_shape_tube_args[] = {
	TS_SHAPE_LENGTH("radius", tube.radius, "outer radius"),
	TS_SHAPE_LENGTH("thickness", tube.thickness, "thickness of the wall"),
	TS_SHAPE_LENGTH("length", tube.length, "length"),
	TS_SHAPE_OPEN(tube.open),
	TS_ARGS_END,
};

const struct ts_arg ts_shape_cone_args[] = {
	TS_SHAPE_LENGTH_OR("radlo", cone.radlo, NULL, "radius at the lower end"),
	TS_SHAPE_LENGTH_OR("radhi", cone.radhi, NULL, "radius at the upper end"),
	TS_SHAPE_LENGTH("length", cone.length, "length"),
	TS_SHAPE_OPEN(cone.open),
	TS_ARGS_END,
};

const struct ts_arg ts_shape_revolve_args[] = {
	TS_LIST("r z r z", struct ts_shape_sizes, revolve.profile,
		.help = "at least two points of a line that is revolved: distance from the axis, and z. "
			"Closed surfaces come from lines that begin and end on the axis, or where they "
			"began"),
	TS_ARGS_END,
};

const struct ts_arg ts_shape_hopper_args[] = {
	TS_SHAPE_LENGTH("radius", hopper.radius, "radius of the upper end"),
	TS_SHAPE_LENGTH("outlet", hopper.outlet, "radius of the outlet"),
	TS_REAL("half_angle", struct ts_shape_sizes, hopper.angle, .range = TS_WITHIN, .lo = 0, .hi = 90,
		.unit = "degrees", .help = "angle between the conical wall and the axis; 90: a flat bottom"),
	TS_SHAPE_LENGTH_OR("height", hopper.height, "0", "height of the cylinder above the cone"),
	TS_SHAPE_LENGTH_OR("stem", hopper.stem, "0", "length of the tube below the cone, as of a funnel"),
	TS_ARGS_END,
};

void ts_shape_disk(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	const double profile[2][2] = { { s->disk.radius, 0 }, { s->disk.hole, 0 } };

	if (!(s->disk.hole < s->disk.radius))
		ts_facets_fail(f, TS_RANGE, "%s: the hole of radius %g is not smaller than the radius %g",
			       f->name, s->disk.hole, s->disk.radius);
	ts_lathe(f, profile, 2);
}

/* A polyline without the ends that are open: from its side, or from the axis. */
static void add_capped(struct ts_facets *f, double radlo, double radhi, double length, int open)
{
	const double profile[4][2] = { { 0, 0 }, { radlo, 0 }, { radhi, length }, { 0, length } };
	bool lower = !(open & TS_SHAPE_LOWER) && radlo > 0, upper = !(open & TS_SHAPE_UPPER) && radhi > 0;

	f->rows = open == TS_SHAPE_BOTH ? TS_SHAPE_PERIODIC_ROWS : 1;
	ts_lathe(f, profile + !lower, (size_t)(2 + lower + upper));
}

void ts_shape_cylinder(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	add_capped(f, s->cylinder.radius, s->cylinder.radius, s->cylinder.length, s->cylinder.open);
}

void ts_shape_cone(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	if (!(s->cone.radlo > 0 || s->cone.radhi > 0))
		ts_facets_fail(f, TS_RANGE, "%s: radlo and radhi are both 0", f->name);
	add_capped(f, s->cone.radlo, s->cone.radhi, s->cone.length, s->cone.open);
}

void ts_shape_tube(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double r = s->tube.radius - s->tube.thickness, l = s->tube.length;
	const double profile[5][2] = {
		{ r, l }, { r, 0 }, { s->tube.radius, 0 }, { s->tube.radius, l }, { r, l }
	};

	if (!(r > 0)) {
		ts_facets_fail(f, TS_RANGE,
			       "%s: the thickness %g is not smaller than the radius %g; without a bore it is "
			       "a cylinder",
			       f->name, s->tube.thickness, s->tube.radius);
		return;
	}
	f->rows = s->tube.open == TS_SHAPE_BOTH ? TS_SHAPE_PERIODIC_ROWS : 1;
	for (int k = 0; k < 4; k++)
		if (!(k == 1 && s->tube.open & TS_SHAPE_LOWER) && !(k == 3 && s->tube.open & TS_SHAPE_UPPER))
			ts_lathe(f, profile + k, 2);
}

void ts_shape_hopper(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double slope = s->hopper.angle * TS_PI / 180, r = s->hopper.outlet, R = s->hopper.radius;
	double top = s->hopper.stem + (s->hopper.angle < 90 ? (R - r) / tan(slope) : 0);
	const double profile[4][2] = {
		{ r, 0 }, { r, s->hopper.stem }, { R, top }, { R, top + s->hopper.height }
	};
	bool stem = s->hopper.stem > 0, bin = s->hopper.height > 0;

	if (!(r < R))
		ts_facets_fail(f, TS_RANGE, "%s: the outlet of radius %g is not narrower than the radius %g",
			       f->name, r, R);
	if (!(s->hopper.angle > 0))
		ts_facets_fail(f, TS_RANGE,
			       "%s: the angle of the wall is 0; a straight bin is a cylinder with open ends",
			       f->name);
	ts_lathe(f, profile + !stem, (size_t)(2 + stem + bin));
}

static bool read_profile(const struct ts_words *w, double (*profile)[2])
{
	for (size_t k = 0; k < w->n; k++)
		if (!ts_parse_real(w->word[k].text, &profile[k / 2][k % 2]) ||
		    (k % 2 == 0 && profile[k / 2][0] < 0))
			return false;
	return true;
}

double ts_shape_revolve_radius(const struct ts_shape_sizes *s)
{
	double most = 0, r;

	for (size_t k = 0; k < s->revolve.profile.n; k += 2)
		if (ts_parse_real(s->revolve.profile.word[k].text, &r))
			most = fmax(most, r);
	return most;
}

/* Whether the volume that a line encloses, if it is closed or completed by lines to the axis, is negative: pi times the
 * integral of r^2 dz. Then its normals would point inwards. */
static bool is_reversed(const double (*p)[2], size_t n)
{
	double volume = 0;

	for (size_t k = 0; k + 1 < n; k++)
		volume += (p[k][0] * p[k][0] + p[k][0] * p[k + 1][0] + p[k + 1][0] * p[k + 1][0]) *
			  (p[k + 1][1] - p[k][1]);
	return volume < 0;
}

/* Twice the area of the triangle a b c, > 0 if anticlockwise. */
static double side_of(const double a[2], const double b[2], const double c[2])
{
	return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Refuses lines that cross themselves, which enclose no volume. */
static void check_crossings(struct ts_facets *f, const double (*p)[2], size_t n)
{
	for (size_t i = 0; i + 1 < n; i++)
		for (size_t j = i + 2; j + 1 < n && f->status == TS_OK; j++)
			if (side_of(p[i], p[i + 1], p[j]) * side_of(p[i], p[i + 1], p[j + 1]) < 0 &&
			    side_of(p[j], p[j + 1], p[i]) * side_of(p[j], p[j + 1], p[i + 1]) < 0)
				ts_facets_fail(f, TS_RANGE,
					       "%s: the line crosses itself between points %zu and %zu, and "
					       "%zu and %zu",
					       f->name, i + 1, i + 2, j + 1, j + 2);
}

void ts_shape_revolve(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	const struct ts_words *w = &s->revolve.profile;
	double(*p)[2] = ts_alloc(w->n / 2 + 1, sizeof *p);

	if (!p)
		f->status = ts_nomem(&f->sim->error);
	else if (w->n < 4 || w->n % 2 || !read_profile(w, p))
		ts_facets_fail(f, TS_RANGE,
			       "%s: expected pairs of numbers r z, at least two, with r not negative",
			       f->name);
	for (size_t k = 0; f->status == TS_OK && k + 1 < w->n / 2; k++)
		if ((p[k][0] == p[k + 1][0] && p[k][1] == p[k + 1][1]) || !(p[k][0] > 0 || p[k + 1][0] > 0))
			ts_facets_fail(f, TS_RANGE,
				       "%s: points %zu and %zu are the same, or both on the axis", f->name,
				       k + 1, k + 2);
	check_crossings(f, (const double(*)[2])p, w->n / 2);
	if (f->status == TS_OK) {
		f->reversed = is_reversed((const double(*)[2])p, w->n / 2);
		ts_lathe(f, (const double(*)[2])p, w->n / 2);
		f->reversed = false;
	}
	ts_free(p);
}
