/* Streamlines in a slice: integrated from a raster of places in both directions with the velocity in the plane, until they
 * leave the grid, enter a body, or come into a square that another line or an earlier part of the same line has passed, so
 * that they are nowhere denser than one in a square. */
#include <math.h>
#include <string.h>

#include "image/image_body.h"
#include "image/image_stream.h"
#include "math/vec3.h"

#include "base/banned.h"

enum { STEPS = 8 /* of integration along the edge of a square */, FINE = 4 /* distances along it */ };
/* Parts of the edge of a square: diameter of a line, length and radius of its head; a shorter line is left out. */
static const double WIDTH = 0.05, HEAD = 0.35, HEAD_RADIUS = 0.1, SHORTEST = 2;

struct streams {
	const struct ts_image_slice *s;
	const struct ts_fluid *fluid;
	int axis[2];
	double edge, lo[2];
	size_t n[2];	  /* squares */
	uint32_t *line;	  /* [n[1]][n[0]] number of the line that has passed; 0: none */
	double *distance; /* [FINE n[1] + 1][FINE n[0] + 1] from bodies */
	double (*place)[3];
	double (*point)[3]; /* of the present line */
	size_t npoints, capacity;
};

/* ---- the raster */

static size_t fine_points(const struct streams *t, int k)
{
	return FINE * t->n[k] + 1;
}

static enum ts_status reserve(struct streams *t)
{
	const size_t fine = fine_points(t, 0) * fine_points(t, 1);

	t->line = ts_alloc(t->n[0] * t->n[1], sizeof *t->line);
	t->distance = ts_alloc(fine, sizeof *t->distance);
	t->place = ts_alloc(fine, sizeof *t->place);
	if (!t->line || !t->distance || !t->place)
		return TS_NOMEM;
	memset(t->line, 0, t->n[0] * t->n[1] * sizeof *t->line);
	for (size_t k = 0; k < fine; k++) {
		const size_t at[2] = { k % fine_points(t, 0), k / fine_points(t, 0) };

		t->place[k][t->s->axis] = t->s->at;
		for (int d = 0; d < 2; d++)
			t->place[k][t->axis[d]] = t->lo[d] + t->edge / FINE * (double)at[d];
	}
	return TS_OK;
}

static void release(struct streams *t)
{
	ts_free(t->line);
	ts_free(t->distance);
	ts_free(t->place);
	ts_free(t->point);
}

/* The square of a place; false: outside. */
static bool find_square(const struct streams *t, const double x[3], size_t *square)
{
	size_t at[2];

	for (int d = 0; d < 2; d++) {
		const double place = (x[t->axis[d]] - t->lo[d]) / t->edge;

		if (!(place >= 0 && place < (double)t->n[d]))
			return false;
		at[d] = (size_t)place;
	}
	*square = at[1] * t->n[0] + at[0];
	return true;
}

/* Bilinear between the points of the raster. */
static double distance_at(const struct streams *t, const double x[3])
{
	size_t at[2];
	double part[2];
	const double *row;

	for (int d = 0; d < 2; d++) {
		const double place = FINE * (x[t->axis[d]] - t->lo[d]) / t->edge;

		at[d] = (size_t)fmin(place, (double)(FINE * t->n[d] - 1));
		part[d] = place - (double)at[d];
	}
	row = t->distance + at[1] * fine_points(t, 0) + at[0];
	return (1 - part[1]) * ((1 - part[0]) * row[0] + part[0] * row[1]) +
	       part[1] * ((1 - part[0]) * row[fine_points(t, 0)] + part[0] * row[fine_points(t, 0) + 1]);
}

/* ---- lines */

/* Unit vector of the velocity in the plane; false: it is zero. */
static bool direction_at(const struct streams *t, const double x[3], double u[3])
{
	double size;

	ts_fluid_velocity(t->fluid, x, u);
	u[t->s->axis] = 0;
	size = ts_norm(u);
	if (!(size > 0) || isinf(size))
		return false;
	ts_scale(1 / size, u, u);
	return true;
}

/* By the midpoint rule. */
static bool advance(const struct streams *t, double sign, double x[3])
{
	const double step = sign * t->edge / STEPS;
	double u[3], middle[3] = { x[0], x[1], x[2] };

	if (!direction_at(t, x, u))
		return false;
	ts_axpy(0.5 * step, u, middle);
	if (!direction_at(t, middle, u))
		return false;
	ts_axpy(step, u, x);
	return true;
}

/* Whether line number `line` may go to x from the square it is in. */
static bool may_enter(struct streams *t, uint32_t line, const double x[3], size_t *square)
{
	const size_t from = *square;

	if (!find_square(t, x, square) || distance_at(t, x) < 0)
		return false;
	if (*square != from && t->line[*square])
		return false;
	t->line[*square] = line;
	return true;
}

static enum ts_status follow(struct streams *t, uint32_t line, double sign, const double start[3])
{
	double x[3] = { start[0], start[1], start[2] };
	size_t square = 0;

	find_square(t, x, &square);
	for (;;) {
		TS_TRY(TS_GROW(t->point, t->capacity, t->npoints + 1));
		memcpy(t->point[t->npoints++], x, sizeof x);
		if (t->npoints > STEPS * 8 * (t->n[0] * t->n[1] + 8) || !advance(t, sign, x) ||
		    !may_enter(t, line, x, &square))
			return TS_OK;
	}
}

/* Rods between the points of a part of the line. */
static enum ts_status add_rods(const struct streams *t, struct ts_scene *scene, size_t from, size_t to,
			       double radius)
{
	for (size_t k = from; k + 1 < to; k++)
		TS_TRY(ts_scene_add_rod(scene, t->point[k], t->point[k + 1], radius, t->s->style.colour));
	return TS_OK;
}

static enum ts_status add_head(const struct streams *t, struct ts_scene *scene, const double x[3],
			       double radius)
{
	double u[3], base[3] = { x[0], x[1], x[2] }, tip[3] = { x[0], x[1], x[2] };

	if (!direction_at(t, x, u))
		return TS_OK;
	ts_axpy(-0.5 * HEAD * t->edge, u, base);
	ts_axpy(0.5 * HEAD * t->edge, u, tip);
	return ts_scene_add_cone(scene, base, tip, fmax(HEAD_RADIUS * t->edge, 2 * radius),
				 t->s->style.colour);
}

/* Squares of a line that is too short are free again. */
static void forget(struct streams *t)
{
	size_t square;

	for (size_t k = 0; k < t->npoints; k++)
		if (find_square(t, t->point[k], &square))
			t->line[square] = 0;
}

static enum ts_status add_line(struct streams *t, struct ts_scene *scene, uint32_t line,
			       const double start[3])
{
	const double radius = 0.5 * (isnan(t->s->style.width) ? WIDTH * t->edge : t->s->style.width);
	size_t square, forward;

	if (!find_square(t, start, &square) || t->line[square] || distance_at(t, start) < 0)
		return TS_OK;
	t->line[square] = line;
	t->npoints = 0;
	TS_TRY(follow(t, line, 1, start));
	forward = t->npoints;
	TS_TRY(follow(t, line, -1, start));
	if ((double)t->npoints < SHORTEST * STEPS) {
		forget(t);
		return TS_OK;
	}
	TS_TRY(add_rods(t, scene, 0, forward, radius));
	TS_TRY(add_rods(t, scene, forward, t->npoints, radius));
	return add_head(t, scene, start, radius);
}

static enum ts_status add_lines(struct streams *t, struct ts_scene *scene)
{
	double x[3];

	x[t->s->axis] = t->s->at;
	for (size_t k = 0; k < t->n[0] * t->n[1]; k++) {
		x[t->axis[0]] = t->lo[0] + t->edge * ((double)(k % t->n[0]) + 0.5);
		x[t->axis[1]] = t->lo[1] + t->edge * ((double)(k / t->n[0]) + 0.5);
		TS_TRY(add_line(t, scene, (uint32_t)k + 1, x));
	}
	return TS_OK;
}

enum ts_status ts_image_add_streams(struct ts_scene *scene, struct tsim *sim, const struct ts_image_slice *s,
				    const struct ts_fluid *fluid)
{
	struct streams t = {
		.s = s, .fluid = fluid, .axis = { (s->axis + 1) % 3, (s->axis + 2) % 3 }, .edge = s->streams
	};
	enum ts_status status;

	if (isnan(s->streams) || !s->valid)
		return TS_OK;
	for (int d = 0; d < 2; d++) {
		const double lo = fluid->grid.face[t.axis[d]][0],
			     length = fluid->grid.face[t.axis[d]][fluid->grid.n[t.axis[d]]] - lo;

		t.n[d] = length > t.edge ? (size_t)(length / t.edge + 1e-9) : 1;
		t.lo[d] = lo + 0.5 * (length - (double)t.n[d] * t.edge);
	}
	if (reserve(&t) != TS_OK) {
		release(&t);
		return ts_nomem(&sim->error);
	}
	status = ts_image_body_distances(sim, fine_points(&t, 0) * fine_points(&t, 1),
					 (const double(*)[3])t.place, t.edge, t.distance);
	if (status == TS_OK && add_lines(&t, scene) != TS_OK)
		status = ts_nomem(&sim->error);
	release(&t);
	return status;
}
