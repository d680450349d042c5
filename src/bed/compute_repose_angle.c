/* Compute repose/angle: slope of the surface of a heap or bed. */
#include <math.h>

#include "base/sort.h"
#include "bed/robust_fit.h"
#include "bed/heap_surface.h"
#include "math/constants.h"
#include "math/vec3.h"

#include "base/banned.h"

enum shape { CONE, RIDGE, PLANE };
static const char *const shapes[] = { "cone", "ridge", "plane", NULL };

struct state {
	int shape;
	double up[3], column, base, centre[3], lo, hi;
	struct ts_bed_surface surface;
	struct tsim *sim;

	struct ts_robust_point *point; /* of each top; lengths divided by `unit` */
	size_t point_capacity;
	double unit;	/* extent of the surface: horizontal */
	double axis[2]; /* of cone and ridge: horizontal coordinates */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	if (!(s->lo < s->hi))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute repose/angle: expected `lower` less than `upper`");
	if (s->shape == CONE && sim->dimension == 2)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "compute repose/angle: a heap in two dimensions is a `ridge`");
	return ts_bed_frame_make(sim, self, s->up, &s->surface.frame);
}

static const struct ts_bed_grain *top_of(const struct state *s, size_t k)
{
	return &s->surface.grain[s->surface.top[k]];
}

enum which { SIDE1, SIDE2, HEIGHT };

/* The median over all particles. */
static enum ts_status median(const struct state *s, enum which which, double *out)
{
	size_t n = s->surface.n;
	double *x = ts_alloc(n, sizeof *x);

	if (!x)
		return ts_nomem(&s->sim->error);
	for (size_t k = 0; k < n; k++) {
		const struct ts_bed_grain *g = &s->surface.grain[k];

		x[k] = which == HEIGHT ? 0.5 * (g->height + g->bottom) : g->side[which];
	}
	ts_sort(x, n, sizeof *x, ts_compare_double);
	*out = n ? 0.5 * (x[(n - 1) / 2] + x[n / 2]) : 0;
	ts_free(x);
	return TS_OK;
}

static double distance_from_axis(const struct state *s, const struct ts_bed_grain *g)
{
	return s->shape == CONE ? hypot(g->side[0] - s->axis[0], g->side[1] - s->axis[1])
				: g->side[0] - s->axis[0];
}

/* Fits the selected tops: height = c0 + c1 distance, for a plane c0 + c1 side1 + c2 side2; side -1, 1: of a ridge. */
static enum ts_status fit(struct state *s, int side, struct ts_robust_fit *out)
{
	size_t n = s->surface.ntops;
	bool plane = s->shape == PLANE, spatial = plane && s->surface.frame.sides == 2;

	for (size_t k = 0; k < n; k++) {
		const struct ts_bed_grain *g = top_of(s, k);
		struct ts_robust_point *p = &s->point[k];
		double r = distance_from_axis(s, g);

		p->selected = p->selected && r * side >= 0;
		p->term[0] = 1;
		p->term[1] = (plane || !side ? r : r * side) / s->unit;
		p->term[2] = spatial ? (g->side[1] - s->axis[1]) / s->unit : 0;
		p->y = (g->height - s->surface.base) / s->unit;
	}
	if (ts_robust_fit(s->point, n, spatial ? 3 : 2, out) != TS_OK)
		return ts_nomem(&s->sim->error);
	return TS_OK;
}

static void select_between(struct state *s, double lo, double hi, const struct ts_robust_fit *by)
{
	for (size_t k = 0; k < s->surface.ntops; k++) {
		double h = (top_of(s, k)->height - s->surface.base) / s->unit;

		h = by ? ts_robust_value(by, &s->point[k]) : h;
		s->point[k].selected = h >= lo && h <= hi;
	}
}

/* A flank. First the tops between parts of the height of a heap with this median height of particles; then, since a
 * selection by the heights that are fitted makes slopes too small, between those parts of the fitted flank. */
static enum ts_status fit_flank(struct state *s, int side, double height, struct ts_robust_fit *out)
{
	enum { ROUNDS = 8 };

	select_between(s, s->lo * height, s->hi * height, NULL);
	TS_TRY(fit(s, side, out));
	for (int round = 0; out->defined && round < ROUNDS; round++) {
		struct ts_robust_fit last = *out;

		select_between(s, s->lo * last.coefficient[0], s->hi * last.coefficient[0], &last);
		TS_TRY(fit(s, side, out));
	}
	return TS_OK;
}

/* A plane: tops in the middle part of the surface along its slope. */
static enum ts_status fit_plane(struct state *s, struct ts_robust_fit *out)
{
	size_t n = s->surface.ntops;

	for (int round = 0; round < 4; round++) {
		double least = INFINITY, most = -INFINITY, *slope = out->coefficient;

		for (size_t k = 0; round && k < n; k++) {
			double along = slope[1] * s->point[k].term[1] + slope[2] * s->point[k].term[2];

			least = fmin(least, along);
			most = fmax(most, along);
		}
		for (size_t k = 0; k < n; k++) {
			double along = slope[1] * s->point[k].term[1] + slope[2] * s->point[k].term[2];

			s->point[k].selected = !round || (along >= least + s->lo * (most - least) &&
							  along <= least + s->hi * (most - least));
		}
		TS_TRY(fit(s, 0, out));
		if (!out->defined)
			break;
	}
	return TS_OK;
}

enum { ANGLE, ERROR, RMS, APEX, RADIUS, LEFT, RIGHT, AXIS1, AXIS2, POINTS, NNUMBERS };
static const char *const names[] = { "angle", "error", "rms",	"apex",	  "radius", "left",
				     "right", "axis1", "axis2", "points", NULL };

static double degrees(double slope)
{
	return atan(slope) * 180 / TS_PI;
}

static double degrees_error(double slope, double error)
{
	return error / (1 + slope * slope) * 180 / TS_PI;
}

/* The fits of the flanks or of the plane: one, for a ridge two. */
static void enter_numbers(const struct state *s, const struct ts_robust_fit f[2], double *number)
{
	double slope = -f[0].coefficient[1], apex = f[0].coefficient[0];

	if (s->shape == PLANE)
		slope = hypot(f[0].coefficient[1], f[0].coefficient[2]);
	number[LEFT] = number[RIGHT] = number[ANGLE] = degrees(slope);
	number[ERROR] = degrees_error(slope, hypot(f[0].error[1], f[0].error[2]));
	number[RMS] = f[0].rms * s->unit;
	number[POINTS] = (double)f[0].points;
	number[RADIUS] = s->shape != PLANE && slope > 0 ? apex / slope * s->unit : 0;
	if (s->shape == RIDGE) {
		double other = -f[1].coefficient[1];

		number[RIGHT] = degrees(other);
		number[ANGLE] = 0.5 * (number[LEFT] + number[RIGHT]);
		number[ERROR] = 0.5 * hypot(number[ERROR], degrees_error(other, f[1].error[1]));
		number[RMS] = hypot(f[0].rms, f[1].rms) / sqrt(2) * s->unit;
		number[POINTS] += (double)f[1].points;
		apex = 0.5 * (apex + f[1].coefficient[0]);
		number[RADIUS] = slope > 0 && other > 0 ? 0.5 * (apex / slope + apex / other) * s->unit : 0;
	}
	number[APEX] = s->surface.base + apex * s->unit;
	number[AXIS1] = s->axis[0];
	number[AXIS2] = s->axis[1];
}

/* Both flanks of a ridge, whose axis is where they meet; the axis is moved there until it stays. */
static enum ts_status fit_ridge(struct state *s, double height, struct ts_robust_fit f[2])
{
	enum { ROUNDS = 20 };
	bool given = !isnan(s->centre[0]);

	for (int round = 0; round < ROUNDS; round++) {
		double slopes, shift;

		TS_TRY(fit_flank(s, -1, height, &f[0]));
		TS_TRY(fit_flank(s, 1, height, &f[1]));
		slopes = f[0].coefficient[1] + f[1].coefficient[1];
		if (given || !f[0].defined || !f[1].defined || !(slopes < 0))
			return TS_OK;
		/* left: h = a - b (-r), right: h = c - d r: equal at r = (c - a)/(b + d) */
		shift = (f[1].coefficient[0] - f[0].coefficient[0]) / -slopes * s->unit;
		if (!(fabs(shift) > 1e-9 * s->unit) || fabs(shift) > s->unit)
			return TS_OK;
		s->axis[0] += shift;
	}
	return TS_OK;
}

/* Prepares the points, the axis, and the height [unit] that a heap with this median height of its particles has. */
static enum ts_status prepare(struct ts_instance *self, double *height)
{
	struct state *s = self->state;
	double middle;

	TS_TRY(ts_bed_surface_find(s->sim, self->group, isnan(s->column) ? 0 : s->column, 1, &s->surface));
	if (!isnan(s->base))
		s->surface.base = s->base;
	if (TS_GROW(s->point, s->point_capacity, s->surface.ntops + 1) != TS_OK)
		return ts_nomem(&s->sim->error);
	TS_TRY(median(s, HEIGHT, &middle));
	for (int d = 0; d < 2; d++) {
		enum which side = d ? SIDE2 : SIDE1;

		if (s->shape == PLANE || isnan(s->centre[0]))
			TS_TRY(median(s, side, &s->axis[d]));
		else
			s->axis[d] = ts_dot(s->centre, s->surface.frame.side[d]);
	}
	s->unit = 0;
	for (size_t k = 0; k < s->surface.ntops; k++)
		for (int d = 0; d < s->surface.frame.sides; d++)
			s->unit = fmax(s->unit, fabs(top_of(s, k)->side[d] - s->axis[d]));
	/* half of the volume of a cone is below 1 - 2^(-1/3) of its height, of a ridge below 1 - 2^(-1/2) */
	*height = s->unit > 0 ? (middle - s->surface.base) / s->unit /
					(1 - pow(2, s->shape == CONE ? -1. / 3 : -0.5))
			      : 0;
	return TS_OK;
}

static enum ts_status measure(struct ts_instance *self, double number[NNUMBERS])
{
	struct state *s = self->state;
	struct ts_robust_fit f[2] = { { .defined = false }, { .defined = false } };
	double height = 0;

	for (int k = 0; k < NNUMBERS; k++)
		number[k] = 0;
	TS_TRY(prepare(self, &height));
	if (!(s->unit > 0))
		return TS_OK;
	if (s->shape == PLANE)
		TS_TRY(fit_plane(s, &f[0]));
	else if (s->shape == RIDGE)
		TS_TRY(fit_ridge(s, height, f));
	else
		TS_TRY(fit_flank(s, 0, height, &f[0]));
	if (f[0].defined && (s->shape != RIDGE || f[1].defined))
		enter_numbers(s, f, number);
	return TS_OK;
}

static enum ts_status eval_angle(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double number[NNUMBERS];

	(void)sim;
	TS_TRY(measure(self, number));
	out->data[0] = number[ANGLE];
	return TS_OK;
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	return measure(self, out->data);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_bed_surface_release(&s->surface);
	ts_free(s->point);
}

static const struct ts_value values[] = {
	{ "angle", "degrees", "angle of the slope; 0 where it is not defined", TS_SCALAR, 1, NULL,
	  eval_angle },
	{ "numbers", "",
	  "angle and its standard error [degrees]; rms distance of the surface from the fit, along `up` "
	  "[length]; of the fitted cone or ridge the coordinate of the tip along `up` and the radius at the "
	  "base [length], angles left and right of a ridge [degrees], horizontal coordinates of the axis "
	  "[length]; number of columns fitted",
	  TS_VECTOR, NNUMBERS, names, eval_numbers },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_ENUM("shape", struct state, shape, shapes, .flags = TS_POSITIONAL,
		.help = "what is fitted to the surface"),
	TS_VEC3("up", struct state, up, .flags = TS_OPTIONAL,
		.help = "upward direction, of any length; default: 0 0 1, in two dimensions 0 1 0"),
	TS_REAL("column", struct state, column, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "width of the square columns; default: twice the mean diameter"),
	TS_REAL("base", struct state, base, .flags = TS_OPTIONAL, .unit = "length",
		.help = "coordinate along `up` of the foot of the heap; default: that below which 1 % of the "
			"particles reach"),
	TS_VEC3("center", struct state, centre, .flags = TS_OPTIONAL, .unit = "length",
		.help = "a point on the axis of the cone, in the middle plane of the ridge; default: found"),
	TS_REAL("lower", struct state, lo, .fallback = "0.15", .range = TS_FRACTION,
		.help = "the surface below this part of the height, or of the length of the plane, is left "
			"out"),
	TS_REAL("upper", struct state, hi, .fallback = "0.85", .range = TS_FRACTION,
		.help = "the surface above this part is left out"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_repose_angle)
const struct ts_style ts_compute_repose_angle = {
	.name = "repose/angle",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Angle of repose: slope of the surface of a heap or of a bed",
	.doc = "The surface is made of the uppermost points of the highest particle in each square column "
	       "along `up` (strips in two dimensions; columns begin at the origin). To it is fitted\n\n"
	       "    cone   h = h_0 - r tan(angle), r the distance from the axis: a heap\n"
	       "    ridge  two planes that meet at a middle plane, which contains `up`: a heap in two "
	       "dimensions, or one between two walls; its flanks face along x (along y where x is upward)\n"
	       "    plane  one plane: the bed in a drum, or a tilted box\n\n"
	       "The fit is a robust one (Tukey's biweight), for which single particles on the heap or above "
	       "it do not count. The rounded tip and the foot are left out: what is below `lower` or above "
	       "`upper` of the fitted height over `base`; of a plane the ends along its slope. Angles are "
	       "those between the surface and the horizontal, in degrees.\n\n"
	       "The axis of a cone is found as the median of the particles' coordinates, which suits "
	       "symmetric heaps; else give `center`. That of a ridge is found where both flanks meet. The "
	       "uppermost points of particles are about a radius above the surface through their centres; "
	       "this shifts tip and radius, but not the angle. The angle is 0, and the number of columns "
	       "c_ID[10] too, where there are too few of them: without particles, with one, with a single "
	       "layer of columns.",
	.example = "compute a all repose/angle cone\n"
		   "compute a all repose/angle cone center 0 0 0 base 0 column 0.006\n"
		   "compute drum all repose/angle plane lower 0.25 upper 0.75\n"
		   "print \"angle of repose $(c_a) +- $(c_a[2]) degrees\"",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
