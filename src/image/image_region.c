/* Surfaces of regions, as far as they are in the box: where their depth is zero between the points of a grid, by marching
 * tetrahedra (A. Doi, A. Koide, IEICE Trans. E74 (1991) 214). */
#include <math.h>

#include "box/domain.h"
#include "image/image_region.h"
#include "region/region.h"

#include "base/banned.h"

enum { CELLS = 80 /* along the longest edge */ };
enum { FILLED, TRANSPARENT };

static const char *const styles[] = { [FILLED] = "filled", [TRANSPARENT] = "transparent", NULL };
static const struct ts_arg rows[] = {
	TS_REGION("id", struct ts_image_region, region, .flags = TS_POSITIONAL, .help = "ID of the region"),
	TS_WORD("color", struct ts_image_region, colour_name, .flags = TS_POSITIONAL,
		.help = "name of a color"),
	TS_ENUM("style", struct ts_image_region, style, styles, .flags = TS_POSITIONAL,
		.help = "filled, or transparent OPACITY"),
	TS_REAL("opacity", struct ts_image_region, opacity, .flags = TS_POSITIONAL, .range = TS_FRACTION,
		.fallback = "0.5", .help = "with transparent: from 0, invisible, to 1, opaque"),
	TS_ARGS_END,
};

enum ts_status ts_image_read_regions(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;
	void *array = d->region;

	TS_TRY(ts_image_read_groups(self, sim, "region", rows, d->region_words, sizeof *d->region, &array,
				    &d->nregions));
	d->region = array;
	for (size_t n = 0; n < d->nregions; n++)
		TS_TRY(ts_image_group_colour(self, sim, &d->region[n].group, d->region[n].colour_name,
					     &d->region[n].colour));
	return TS_OK;
}

/* ---- the grid */

/* Around the part of the region in the box, with a layer of points outside; false: there is none. */
static bool place_grid(struct ts_image_region *r, const struct ts_box *box)
{
	double lo[3], hi[3], longest = 0;

	ts_region_bounds(r->region, lo, hi);
	for (int d = 0; d < 3; d++) {
		lo[d] = fmax(lo[d], box->lo[d]);
		hi[d] = fmin(hi[d], box->hi[d]);
		longest = fmax(longest, hi[d] - lo[d]);
	}
	r->spacing = longest / CELLS;
	for (int d = 0; d < 3; d++) {
		if (!(hi[d] > lo[d]))
			return false;
		r->origin[d] = lo[d] - 0.5 * r->spacing;
		r->n[d] = (size_t)ceil((hi[d] - lo[d]) / r->spacing) + 2;
	}
	return true;
}

static void position(const struct ts_image_region *r, const size_t at[3], double x[3])
{
	for (int d = 0; d < 3; d++)
		x[d] = r->origin[d] + (double)at[d] * r->spacing;
}

/* Depth in the region and in the box; half a spacing where a region does not know it. */
static double depth_at(const struct ts_image_region *r, const struct ts_box *box, const double x[3])
{
	double depth = ts_region_depth(r->region, x);

	if (isnan(depth))
		depth = ts_region_contains(r->region, x) ? 0.5 * r->spacing : -0.5 * r->spacing;
	for (int d = 0; d < 3; d++)
		depth = fmin(depth, fmin(x[d] - box->lo[d], box->hi[d] - x[d]));
	return depth;
}

static enum ts_status find_depths(struct ts_image_region *r, const struct ts_box *box)
{
	size_t k = 0, at[3];
	double x[3];

	TS_TRY(TS_GROW(r->depth, r->capacity, r->n[0] * r->n[1] * r->n[2]));
	for (at[2] = 0; at[2] < r->n[2]; at[2]++)
		for (at[1] = 0; at[1] < r->n[1]; at[1]++)
			for (at[0] = 0; at[0] < r->n[0]; at[0]++) {
				position(r, at, x);
				r->depth[k++] = (float)depth_at(r, box, x);
			}
	return TS_OK;
}

/* ---- tetrahedra */

struct corner {
	double x[3], depth;
};

/* The point between two corners, one of them inside, where the depth is zero. */
static void crossing(const struct corner *a, const struct corner *b, double out[3])
{
	const double t = a->depth / (a->depth - b->depth);

	for (int d = 0; d < 3; d++)
		out[d] = a->x[d] + t * (b->x[d] - a->x[d]);
}

static enum ts_status add_tetrahedron(struct ts_scene *scene, const struct ts_image_region *r,
				      const struct corner *const corner[4])
{
	const struct corner *in[4], *out[4];
	double x[4][3];
	int inside = 0, outside = 0;

	for (int k = 0; k < 4; k++) {
		if (corner[k]->depth > 0)
			in[inside++] = corner[k];
		else
			out[outside++] = corner[k];
	}
	if (inside == 2) {
		for (int k = 0; k < 4; k++) /* around the quadrangle */
			crossing(in[k / 2], out[(k == 1 || k == 2)], x[k]);
		return ts_scene_add_quadrangle(scene, (const double(*)[3])x, r->colour, r->opacity);
	}
	if (inside == 0 || outside == 0)
		return TS_OK;
	for (int k = 0; k < 3; k++)
		crossing(in[inside == 1 ? 0 : k], out[inside == 1 ? k : 0], x[k]);
	return ts_scene_add_triangle(scene, (const double(*)[3])x, r->colour, r->opacity);
}

static enum ts_status add_cell(struct ts_scene *scene, const struct ts_image_region *r, const size_t at[3])
{
	/* six around the diagonal; bit d of a number: the upper corner along axis d */
	static const int part[6][4] = { { 0, 1, 3, 7 }, { 0, 1, 5, 7 }, { 0, 2, 3, 7 },
					{ 0, 2, 6, 7 }, { 0, 4, 5, 7 }, { 0, 4, 6, 7 } };
	struct corner corner[8];
	int inside = 0;

	for (size_t k = 0; k < 8; k++) {
		const size_t c[3] = { at[0] + (k & 1), at[1] + (k >> 1 & 1), at[2] + (k >> 2) };

		position(r, c, corner[k].x);
		corner[k].depth = (double)r->depth[(c[2] * r->n[1] + c[1]) * r->n[0] + c[0]];
		inside += corner[k].depth > 0;
	}
	for (int t = 0; t < 6 && inside > 0 && inside < 8; t++) {
		const struct corner *tetrahedron[4];

		for (int k = 0; k < 4; k++)
			tetrahedron[k] = &corner[part[t][k]];
		TS_TRY(add_tetrahedron(scene, r, tetrahedron));
	}
	return TS_OK;
}

static enum ts_status add_surface(struct ts_scene *scene, const struct ts_image_region *r)
{
	size_t at[3];

	for (at[2] = 0; at[2] + 1 < r->n[2]; at[2]++)
		for (at[1] = 0; at[1] + 1 < r->n[1]; at[1]++)
			for (at[0] = 0; at[0] + 1 < r->n[0]; at[0]++)
				TS_TRY(add_cell(scene, r, at));
	return TS_OK;
}

enum ts_status ts_image_add_regions(struct ts_instance *self, struct tsim *sim)
{
	struct ts_image *d = self->state;

	for (size_t n = 0; n < d->nregions; n++) {
		struct ts_image_region *r = &d->region[n];

		if (r->style == FILLED)
			r->opacity = 1;
		TS_TRY(ts_region_update(r->region, sim));
		if (place_grid(r, &sim->domain->box) &&
		    (find_depths(r, &sim->domain->box) != TS_OK || add_surface(&d->scene, r) != TS_OK))
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

void ts_image_release_regions(struct ts_image *d)
{
	for (size_t n = 0; n < d->nregions; n++)
		ts_free(d->region[n].depth);
}
