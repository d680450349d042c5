/* Slices of the fields of the fluid: a plane perpendicular to an axis, coloured by a quantity, and arrows of the velocity
 * in it.
 *
 * The quantity is computed at the corners of rectangles that are a cell or a part of one, and is linear between them. Where
 * the plane is inside of a body it has one colour; the line between is where the distance from the surface, linear as well,
 * is zero. */
#include <math.h>
#include <string.h>

#include "base/axes.h"
#include "base/parallel.h"
#include "flow/flow.h"
#include "image/image_body.h"
#include "image/image_stream.h"
#include "math/vec3.h"

#include "base/banned.h"

static const char who[] = "dump image: slice";
/* Corners along an axis that coarse grids are refined to; the most parts of a cell; the most corners of a slice. */
enum { FINE = 200, MOST_PARTS = 8, MOST_CORNERS = 400000, MOST_ARROWS = 1000000 };

static const struct ts_arg rows[] = {
	TS_ENUM("axis", struct ts_image_slice, axis, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "that the plane is perpendicular to"),
	TS_NUMBER("position", struct ts_image_slice, position, .flags = TS_POSITIONAL,
		  .help = "coordinate of the plane (length), number or variable"),
	TS_WORD("quantity", struct ts_image_slice, quantity, .flags = TS_POSITIONAL,
		.help = "speed, vx, vy, vz, p, void, wx, wy, wz, vorticity, f_ID of fix flow/scalar; none"),
	TS_REAL("trans", struct ts_image_slice, opacity, .range = TS_FRACTION, .fallback = "1",
		.help = "from 0, invisible, to 1, opaque"),
	TS_WORD("body", struct ts_image_slice, body, .fallback = "gray",
		.help = "color inside of bodies of fix immersed/boundary; none: not drawn there"),
	TS_REAL("arrows", struct ts_image_slice, spacing, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance of arrows of the velocity"),
	TS_REAL("streams", struct ts_image_slice, streams, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance of streamlines"),
	TS_IMAGE_ARROW_ROWS(struct ts_image_slice, style, "black"),
	TS_ARGS_END,
};

static int axis_of(const struct ts_image_slice *s, int k)
{
	return (s->axis + 1 + k) % 3;
}

/* ---- words */

static bool is_in_grid(const struct ts_grid *grid, int d, double x)
{
	return d >= grid->dimensions || ts_grid_find(grid, d, x) >= 0;
}

static enum ts_status check_position(struct tsim *sim, const struct ts_image_slice *s,
				     const struct ts_grid *grid)
{
	if (s->position.variable || is_in_grid(grid, s->axis, s->position.value))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &s->group.keyword.place,
		       "dump image: slice: %s = %g is outside of the fluid's grid, which goes from %g to %g",
		       ts_axis_names[s->axis], s->position.value, grid->face[s->axis][0],
		       grid->face[s->axis][grid->n[s->axis]]);
}

static double extent(const struct ts_grid *grid, int d)
{
	return grid->face[d][grid->n[d]] - grid->face[d][0];
}

static enum ts_status check_spacing(struct tsim *sim, const struct ts_image_slice *s, const char *what,
				    double spacing, const struct ts_grid *grid)
{
	double n = 1;

	for (int k = 0; k < 2; k++)
		n *= extent(grid, axis_of(s, k)) / spacing + 1;
	if (isnan(spacing) || n <= MOST_ARROWS)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &s->group.keyword.place,
		       "dump image: slice: %s %g apart are about %.2g, more than %d: choose a larger "
		       "distance",
		       what, spacing, n, MOST_ARROWS);
}

static enum ts_status read_one(struct ts_instance *self, struct tsim *sim, struct ts_image_slice *s)
{
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fluid(sim, who, &s->group.keyword.place, &fluid));
	s->sampler.list.item = NULL; /* the quantity may have changed */
	if (!ts_streq(s->quantity, "none")) {
		s->word = (struct ts_word){ .text = s->quantity,
					    .place = *ts_image_group_word(&s->group, s->quantity) };
		s->sampler.words = (struct ts_words){ &s->word, 1 };
		TS_TRY(ts_flow_sampler_read(&s->sampler, sim, &self->arena, who, &s->word.place));
	}
	if (!ts_streq(s->body, "none"))
		TS_TRY(ts_image_group_colour(self, sim, &s->group, s->body, &s->body_colour));
	TS_TRY(ts_image_read_arrow_style(self, sim, &s->group, &s->style));
	if (ts_streq(s->style.colour_name, "atom"))
		return ts_fail(&sim->error, TS_SYNTAX, ts_image_group_word(&s->group, "atom"),
			       "dump image: slice: arrows of the fluid have no color of a particle");
	TS_TRY(check_position(sim, s, &fluid->grid));
	TS_TRY(check_spacing(sim, s, "arrows", s->spacing, &fluid->grid));
	return check_spacing(sim, s, "streamlines", s->streams, &fluid->grid);
}

enum ts_status ts_image_read_slices(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	void *array = d->slice;

	TS_TRY(ts_image_read_groups(self, sim, "slice", rows, d->slice_words, sizeof *d->slice, &array,
				    &d->nslices));
	d->slice = array;
	for (size_t n = 0; n < d->nslices; n++)
		TS_TRY(read_one(self, sim, &d->slice[n]));
	return TS_OK;
}

/* ---- corners */

/* Coordinates of a row of corners: the boundary, the centres of cells, the other boundary. */
static double coarse_corner(const struct ts_grid *grid, int d, int k)
{
	return k == 0		? grid->face[d][0]
	       : k > grid->n[d] ? grid->face[d][grid->n[d]]
				: grid->centre[d][k - 1];
}

/* Each interval is divided into `parts`, or only every `stride`-th corner is taken. */
static enum ts_status make_corners(struct ts_image_slice *s, const struct ts_grid *grid, int k, int parts,
				   int stride)
{
	const int d = axis_of(s, k), last = grid->n[d] + 1;
	size_t n = 0;

	TS_TRY(TS_GROW(s->node[k], s->node_capacity[k], (size_t)(last + 1) * (size_t)parts + 1));
	for (int i = 0; i < last; i += stride) {
		const int next = i + stride < last ? i + stride : last;
		const double a = coarse_corner(grid, d, i), b = coarse_corner(grid, d, next);

		for (int part = 0; part < parts; part++)
			s->node[k][n++] = a + (b - a) * part / parts;
	}
	s->node[k][n++] = coarse_corner(grid, d, last);
	s->n[k] = n;
	return TS_OK;
}

static enum ts_status make_all_corners(struct ts_image_slice *s, const struct ts_grid *grid)
{
	const int a = grid->n[axis_of(s, 0)] + 1, b = grid->n[axis_of(s, 1)] + 1, most = a > b ? a : b;
	int parts = 1, stride = 1;

	while (parts < MOST_PARTS && parts * most < FINE)
		parts++;
	while ((double)(a / stride) * (double)(b / stride) > MOST_CORNERS)
		stride++;
	for (int k = 0; k < 2; k++)
		TS_TRY(make_corners(s, grid, k, parts, stride));
	return TS_OK;
}

struct sampling {
	struct ts_image_slice *s;
	const struct ts_fluid *fluid;
};

static void sample_rows(void *context, size_t from, size_t to)
{
	const struct sampling *c = context;
	struct ts_image_slice *s = c->s;

	for (size_t at = from * s->n[0]; at < to * s->n[0]; at++)
		ts_flow_sample(&s->sampler, c->fluid, s->place[at], 0, &s->value[at]);
}

static enum ts_status reserve(struct ts_image_slice *s, size_t n)
{
	TS_TRY(TS_GROW(s->place, s->place_capacity, n));
	TS_TRY(TS_GROW(s->value, s->capacity, n));
	return TS_GROW(s->distance, s->distance_capacity, n);
}

/* Places, distances and values of all corners. */
static enum ts_status sample(struct tsim *sim, struct ts_image_slice *s, struct ts_fluid *fluid)
{
	const int a = axis_of(s, 0), b = axis_of(s, 1);
	struct sampling context = { s, fluid };
	double reach;

	if (ts_streq(s->quantity, "none"))
		return TS_OK;
	TS_TRY(ts_flow_sampler_fetch(&s->sampler, sim, who, &s->group.keyword.place, &fluid));
	if (make_all_corners(s, &fluid->grid) != TS_OK || reserve(s, s->n[0] * s->n[1]) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t j = 0; j < s->n[1]; j++)
		for (size_t i = 0; i < s->n[0]; i++) {
			double *x = s->place[j * s->n[0] + i];

			x[s->axis] = s->at;
			x[a] = s->node[0][i];
			x[b] = s->node[1][j];
		}
	reach = fmax(extent(&fluid->grid, a), extent(&fluid->grid, b)) / FINE * 4;
	TS_TRY(ts_image_body_distances(sim, s->n[0] * s->n[1], (const double(*)[3])s->place, reach,
				       s->distance));
	ts_parallel(sim->threads, s->n[1], sample_rows, &context);
	return TS_OK;
}

/* Range of the values of all slices of that quantity, in the fluid; whether some of them are no numbers. */
static bool find_range(const struct ts_image *d, struct ts_image_slice *s)
{
	bool numbers = true;

	s->scale = (struct ts_scene_scale){ &d->field_map, INFINITY, -INFINITY };
	for (size_t n = 0; n < d->nslices; n++) {
		const struct ts_image_slice *other = &d->slice[n];

		for (size_t k = 0; ts_streq(other->quantity, s->quantity) && k < other->n[0] * other->n[1];
		     k++)
			if (other->distance[k] >= 0) {
				ts_colour_map_extend(&other->value[k], 1, 1, &s->scale.lo, &s->scale.hi);
				numbers &= !isnan(other->value[k]);
			}
	}
	ts_colour_map_range(&d->field_map, &s->scale.lo, &s->scale.hi);
	return numbers;
}

/* ---- triangles */

struct corner {
	double x[3], value, distance;
};

static struct corner between(const struct corner *a, const struct corner *b)
{
	const double t = a->distance / (a->distance - b->distance);
	struct corner c = { .value = a->value + t * (b->value - a->value) };

	for (int d = 0; d < 3; d++)
		c.x[d] = a->x[d] + t * (b->x[d] - a->x[d]);
	return c;
}

/* The part of a triangle in the fluid, or that inside of bodies: 0, 3 or 4 corners. */
static int cut(const struct corner corner[3], bool fluid, struct corner out[4])
{
	int n = 0;

	for (int k = 0; k < 3; k++) {
		const struct corner *a = &corner[k], *b = &corner[(k + 1) % 3];
		const bool in = (a->distance >= 0) == fluid;

		if (in)
			out[n++] = *a;
		if (in != ((b->distance >= 0) == fluid))
			out[n++] = between(a, b);
	}
	return n;
}

static enum ts_status add_polygon(struct ts_scene *scene, const struct ts_image_slice *s,
				  const struct corner *corner, int n, bool fluid)
{
	struct ts_scene_triangle t = { .opacity = (float)s->opacity,
				       .unlit = true,
				       .colour = s->body_colour,
				       .scale = fluid ? &s->scale : NULL };

	for (int first = 1; first + 1 < n; first++) {
		for (int k = 0; k < 3; k++) {
			const struct corner *from = &corner[k ? first + k - 1 : 0];

			memcpy(t.corner[k], from->x, sizeof t.corner[k]);
			t.value[k] = (float)from->value;
		}
		TS_TRY(ts_scene_add_painted(scene, &t));
	}
	return TS_OK;
}

static enum ts_status add_triangle(struct ts_scene *scene, const struct ts_image_slice *s, const size_t at[3])
{
	struct corner corner[3], part[4];

	for (int k = 0; k < 3; k++) {
		memcpy(corner[k].x, s->place[at[k]], sizeof corner[k].x);
		corner[k].value = s->value[at[k]];
		corner[k].distance = s->distance[at[k]];
	}
	for (int fluid = ts_streq(s->body, "none"); fluid < 2; fluid++)
		TS_TRY(add_polygon(scene, s, part, cut(corner, fluid, part), fluid));
	return TS_OK;
}

static enum ts_status add_triangles(struct ts_scene *scene, const struct ts_image_slice *s)
{
	for (size_t j = 0; j + 1 < s->n[1]; j++)
		for (size_t i = 0; i + 1 < s->n[0]; i++) {
			const size_t a = j * s->n[0] + i, b = a + 1, c = a + s->n[0], d = c + 1;

			TS_TRY(add_triangle(scene, s, (const size_t[]){ a, b, d }));
			TS_TRY(add_triangle(scene, s, (const size_t[]){ a, d, c }));
		}
	return TS_OK;
}

/* ---- arrows */

/* Places of arrows, in the middle of squares of the given distance. */
static enum ts_status place_arrows(struct ts_image_slice *s, const struct ts_grid *grid, size_t *n)
{
	size_t count[2];
	double first[2];

	for (int k = 0; k < 2; k++) {
		const int d = axis_of(s, k);
		const double length = extent(grid, d);

		count[k] = length > s->spacing && d < grid->dimensions ? (size_t)(length / s->spacing) : 1;
		first[k] = grid->face[d][0] + 0.5 * (length - (double)(count[k] - 1) * s->spacing);
	}
	*n = count[0] * count[1];
	TS_TRY(reserve(s, *n));
	for (size_t k = 0; k < *n; k++) {
		s->place[k][s->axis] = s->at;
		s->place[k][axis_of(s, 0)] = first[0] + (double)(k % count[0]) * s->spacing;
		s->place[k][axis_of(s, 1)] = first[1] + (double)(k / count[0]) * s->spacing;
	}
	return TS_OK;
}

static enum ts_status add_arrows(struct ts_scene *scene, struct tsim *sim, struct ts_image_slice *s,
				 const struct ts_fluid *fluid)
{
	struct ts_image_arrow_size size;
	double largest = 0, u[3];
	size_t n;

	if (isnan(s->spacing) || !s->valid)
		return TS_OK;
	if (place_arrows(s, &fluid->grid, &n) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_image_body_distances(sim, n, (const double(*)[3])s->place, s->spacing, s->distance));
	for (int pass = 0; pass < 2; pass++) {
		size = ts_image_arrow_size(&s->style, largest, s->spacing);
		for (size_t k = 0; k < n; k++) {
			if (s->distance[k] < 0)
				continue;
			ts_fluid_velocity(fluid, s->place[k], u);
			if (pass == 0)
				largest = isfinite(ts_norm(u)) ? fmax(largest, ts_norm(u)) : largest;
			else if (ts_image_add_arrow(scene, s->place[k], u, &size, s->style.colour) != TS_OK)
				return ts_nomem(&sim->error);
		}
	}
	return TS_OK;
}

/* ---- frames */

/* The position at this step; no corners if it is not in the grid. */
static enum ts_status begin(struct ts_instance *self, struct tsim *sim, struct ts_image_slice *s,
			    struct ts_fluid *fluid)
{
	s->n[0] = s->n[1] = 0;
	TS_TRY(ts_number_now(sim, &s->position, &s->group.keyword.place, &s->at));
	s->valid = is_in_grid(&fluid->grid, s->axis, s->at) && isfinite(s->at);
	if (s->valid)
		return sample(sim, s, fluid);
	if (!s->told)
		ts_warn(&sim->log, &s->group.keyword.place,
			"dump %s: no slice at step %lld: %s = %g is outside of the fluid's grid", self->id,
			(long long)sim->clock.step, ts_axis_names[s->axis], s->at);
	s->told = true;
	return TS_OK;
}

enum ts_status ts_image_add_slices(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	struct ts_fluid *fluid;

	if (!d->nslices)
		return TS_OK;
	TS_TRY(ts_flow_require_fields(sim, who, &d->slice->group.keyword.place, &fluid));
	for (size_t n = 0; n < d->nslices; n++)
		TS_TRY(begin(self, sim, &d->slice[n], fluid));
	for (size_t n = 0; n < d->nslices; n++) {
		if (!find_range(d, &d->slice[n]))
			ts_image_warn_nan(self, sim, d->slice[n].quantity);
		if (add_triangles(&d->scene, &d->slice[n]) != TS_OK)
			return ts_nomem(&sim->error);
	}
	for (size_t n = 0; n < d->nslices; n++) { /* they use the memory of the corners */
		TS_TRY(add_arrows(&d->scene, sim, &d->slice[n], fluid));
		TS_TRY(ts_image_add_streams(&d->scene, sim, &d->slice[n], fluid));
	}
	return TS_OK;
}

void ts_image_release_slices(struct ts_image *d)
{
	for (size_t n = 0; n < d->nslices; n++) {
		struct ts_image_slice *s = &d->slice[n];

		ts_free(s->node[0]);
		ts_free(s->node[1]);
		ts_free(s->place);
		ts_free(s->value);
		ts_free(s->distance);
	}
}
