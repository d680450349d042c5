#include "shape/shape.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "math/constants.h"
#include "math/vec3.h"
#include "shape/internal.h"

#include "base/banned.h"

enum { SEGMENTS = 64 };
/* Triangles with smaller angles are refused, and so are those with sides that are smaller than the shape by this
 * factor: readers of meshes would take their corners for the same point. */
#define SMALLEST_ANGLE 0.5
#define SMALLEST_SIDE 1e-6

const char *const ts_shape_normals_names[] = { "outward", "inward", NULL };

#define MODE(name_, help_, radius) { .name = #name_, .help = help_, .args = ts_shape_##name_##_args },
const struct ts_mode ts_shape_modes[] = { TS_SHAPE_LIST(MODE){ .name = NULL } };

typedef void make_fn(struct ts_facets *f, const struct ts_shape_sizes *s);
#define MAKER(name_, help_, radius) ts_shape_##name_,
static make_fn *const makers[] = { TS_SHAPE_LIST(MAKER) };

const struct ts_arg ts_shape_args[] = { TS_SHAPE_ARGS, TS_ARGS_END };

static double largest_radius(const struct ts_shape_sizes *s)
{
#define RADIUS(name_, help_, radius) radius,
	const double radii[] = { TS_SHAPE_LIST(RADIUS) };
#undef RADIUS
	return radii[s->kind];
}

/* A polygon of n corners on a circle is R (1 - cos(pi/n)) inside of it. `size` may need more segments. */
static int choose_segments(const struct ts_shape_sizes *s, double radius)
{
	double n = s->segments > 0 ? (double)s->segments : SEGMENTS;

	if (!isnan(s->error)) {
		n = s->error < radius ? TS_PI / acos(1 - s->error / radius) : 8;
		n = 4 * ceil(fmax(n, 8) / 4);
	}
	if (!isnan(s->size))
		n = fmax(n, 4 * ceil(2 * TS_PI * radius / s->size / 4));
	return n < INT32_MAX ? (int)n : INT32_MAX;
}

/* Directions of the axes of the shape, see the top of shape.h. */
static enum ts_status set_axes(struct ts_facets *f, const struct ts_shape_sizes *s)
{
	double length = ts_norm(s->axis), cs[2] = { 1, 0 }, quarters = s->angle / 90, x[3], y[3];
	double(*e)[3] = f->unit;
	int main = 0;

	if (!(length > 0) || !isfinite(length))
		return ts_facets_fail(f, TS_RANGE, "%s: the axis has no length", f->name);
	ts_scale(1 / length, s->axis, e[2]);
	for (int d = 1; d < 3; d++)
		main = fabs(e[2][d]) > fabs(e[2][main]) ? d : main;
	for (int d = 0; d < 3; d++)
		x[d] = d == (main + 1) % 3;
	ts_axpy(-ts_dot(x, e[2]), e[2], x);
	ts_scale(1 / ts_norm(x), x, x);
	ts_cross(e[2], x, y);
	if (quarters == floor(quarters) && fabs(quarters) < 1e9) {
		ts_facets_direction((int64_t)quarters, 4, cs);
	} else {
		cs[0] = cos(s->angle * TS_PI / 180);
		cs[1] = sin(s->angle * TS_PI / 180);
	}
	for (int d = 0; d < 3; d++) {
		e[0][d] = cs[0] * x[d] + cs[1] * y[d];
		e[1][d] = cs[0] * y[d] - cs[1] * x[d];
		f->origin[d] = s->base[d];
	}
	return TS_OK;
}

/* The smallest angle of a triangle in degrees, and its shortest side. */
static double sharpest(const struct ts_triangle *t, double *shortest)
{
	double least = INFINITY, side[3][3], normal[3];

	for (int k = 0; k < 3; k++) {
		ts_sub(t->v[(k + 1) % 3], t->v[k], side[k]);
		*shortest = fmin(*shortest, ts_norm(side[k]));
	}
	for (int k = 0; k < 3; k++) {
		ts_cross(side[k], side[(k + 1) % 3], normal);
		least = fmin(least, atan2(ts_norm(normal), -ts_dot(side[k], side[(k + 1) % 3])));
	}
	return least * 180 / TS_PI;
}

/* Sizes that differ too much would make triangles that no wall can be made of. */
static enum ts_status check_triangles(struct ts_facets *f, size_t first)
{
	double least = INFINITY, shortest = INFINITY, lo[3], hi[3], extent = 0;

	for (size_t t = first; t < f->soup->n; t++)
		least = fmin(least, sharpest(&f->soup->t[t], &shortest));
	for (int d = 0; d < 3; d++) {
		lo[d] = INFINITY;
		hi[d] = -INFINITY;
		for (size_t k = 3 * first; k < 3 * f->soup->n; k++) {
			lo[d] = fmin(lo[d], f->soup->t[k / 3].v[k % 3][d]);
			hi[d] = fmax(hi[d], f->soup->t[k / 3].v[k % 3][d]);
		}
		extent = fmax(extent, hi[d] - lo[d]);
	}
	if (!isfinite(extent) || !isfinite(least))
		return ts_facets_fail(f, TS_RANGE, "%s: its sizes are out of the range of numbers", f->name);
	if (least >= SMALLEST_ANGLE && shortest > SMALLEST_SIDE * extent)
		return TS_OK;
	return ts_facets_fail(f, TS_RANGE,
			      "%s: its sizes differ too much: with %d segments there would be a triangle "
			      "with an angle of %.3g degrees and a side of %.3g; take more segments, or a "
			      "larger smallest size",
			      f->name, f->segments, least, shortest);
}

enum ts_status ts_shape_make(struct tsim *sim, const char *what, const struct ts_shape_sizes *s,
			     const struct ts_place *where, struct ts_arena *arena, struct ts_triangles *soup,
			     struct ts_shape_report *report)
{
	char name[96];
	double radius = largest_radius(s);
	size_t first = soup->n;
	struct ts_facets f = { .sim = sim,
			       .where = where,
			       .name = name,
			       .soup = soup,
			       .inward = s->normals == 1,
			       .rows = 1,
			       .segments = choose_segments(s, radius),
			       .size = isnan(s->size) ? INFINITY : s->size };

	snprintf(name, sizeof name, "%s: %s", what, ts_shape_modes[s->kind].name);
	if (s->segments > 0 && !isnan(s->error))
		return ts_fail(&sim->error, TS_SYNTAX, where, "%s: one of `segments` and `error`", name);
	f.chord = radius * (1 - cos(TS_PI / f.segments));
	TS_TRY(set_axes(&f, s));
	makers[s->kind](&f, s);
	TS_TRY(f.status);
	TS_TRY(check_triangles(&f, first));
	report->triangles += soup->n - first;
	report->chord = fmax(report->chord, f.chord);
	return s->other.n ? ts_shape_read(sim, what, s->other, arena, soup, report) : TS_OK;
}

enum ts_status ts_shape_read(struct tsim *sim, const char *what, struct ts_words words,
			     struct ts_arena *arena, struct ts_triangles *soup,
			     struct ts_shape_report *report)
{
	struct ts_shape_sizes *s = ts_arena_alloc(arena, 1, sizeof *s);
	const struct ts_place *where = &words.word[0].place;

	if (!s)
		return ts_nomem(&sim->error);
	if (ts_streq(words.word[0].text, "primitive"))
		words = ts_words_from(words, 1);
	if (words.n)
		where = &words.word[0].place;
	TS_TRY(ts_args_parse(sim, what, ts_shape_args, words, where, arena, s));
	return ts_shape_make(sim, what, s, where, arena, soup, report);
}
