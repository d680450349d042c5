#include "render/picture.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/parallel.h"
#include "render/items.h"
#include "render/occlusion.h"
#include "render/shade.h"
#include "render/item_surface.h"
#include "render/tile.h"

#include "base/banned.h"

struct ts_picture_work {
	struct ts_items items;
	unsigned char *sample; /* [height][width][3] with four samples per pixel, else not used */
	float *depth;	       /* [height][width] with occlusion */
	size_t sample_capacity, depth_capacity;
};

/* One picture on its way. */
struct drawing {
	const struct ts_scene *scene;
	const struct ts_items *items;
	const struct ts_picture_style *style;
	struct ts_shade shade;
	uint32_t width, height;	 /* samples */
	unsigned char *rgb;	 /* of samples */
	float *depth;		 /* of samples; NULL: not kept */
	float nearest, farthest; /* z of the items that haze begins and ends at; equal: no haze */
	struct ts_occlusion occlusion;
	struct ts_picture *picture;
	size_t tiles, stride; /* the k-th tile to be drawn is k stride modulo tiles */
};

/* Colours of a tile while it is drawn. */
struct canvas {
	const struct drawing *d;
	struct ts_tile tile;
	float light[TS_TILE_SAMPLES][3];
	const struct ts_item *glass; /* the transparent item that is drawn */
};

/* ---- shading */

static struct ts_colour background(const struct drawing *d, uint32_t y)
{
	const double t = d->height > 1 ? (double)y / (d->height - 1) : 1;

	return ts_colour_mix(d->style->ground[1], d->style->ground[0], t);
}

/* Light of an item at a sample of the tile at depth z. */
static void light_of(const struct canvas *c, const struct ts_item *item, uint32_t sample, float z,
		     float out[3])
{
	const struct drawing *d = c->d;
	const double x = c->tile.x + sample % TS_TILE + 0.5, y = c->tile.y + (double)(sample / TS_TILE) + 0.5;
	const struct ts_colour colour = ts_item_colour(d->scene, d->items, item, x, y);
	float n[3];

	if (item->kind == TS_ITEM_TRIANGLE && ts_item_is_unlit(d->scene, item)) {
		memcpy(out, colour.c, sizeof colour.c);
		return;
	}
	if (item->whole || !ts_tile_is_cut_face(&c->tile, d->items, item, sample, z, n))
		ts_item_normal(d->scene, d->items, item, x, y, (double)z, n);
	ts_shade_surface(&d->shade, n, &colour, out);
}

static void shade_sample(struct canvas *c, int i, int j)
{
	const struct drawing *d = c->d;
	const int k = j * TS_TILE + i;

	if (c->tile.seen[k] == TS_TILE_NOTHING) {
		const struct ts_colour ground = background(d, c->tile.y + (uint32_t)j);

		memcpy(c->light[k], ground.c, sizeof c->light[k]);
		return;
	}
	light_of(c, &d->items->item[c->tile.seen[k]], (uint32_t)k, c->tile.depth[k], c->light[k]);
}

/* ---- tiles */

/* Samples of the tile that are in the picture. */
static int samples_along(uint32_t first, uint32_t size)
{
	return size - first < TS_TILE ? (int)(size - first) : TS_TILE;
}

static void blend(void *context, uint32_t sample, float z)
{
	struct canvas *c = context;
	const float opacity = ts_item_opacity(c->d->scene, c->glass);
	float light[3];

	light_of(c, c->glass, sample, z, light);
	for (int k = 0; k < 3; k++)
		c->light[sample][k] += opacity * (fminf(light[k], 1) - fminf(c->light[sample][k], 1));
}

/* Transparent spheres and triangles, from the farthest to the nearest. */
static void draw_glass(struct canvas *c, size_t number)
{
	const struct ts_items *items = c->d->items;

	for (uint32_t k = items->first[number + 1]; k-- > items->first[number];) {
		c->glass = &items->item[items->touch[k]];
		if (c->glass->glass)
			ts_tile_visit(&c->tile, items, c->glass, blend, c);
	}
}

static void store(const struct canvas *c)
{
	const struct drawing *d = c->d;
	const int width = samples_along(c->tile.x, d->width), height = samples_along(c->tile.y, d->height);

	for (int j = 0; j < height; j++) {
		unsigned char *to = d->rgb + 3 * ((size_t)(c->tile.y + (uint32_t)j) * d->width + c->tile.x);
		const float *from = c->light[j * TS_TILE];

		for (int k = 0; k < 3 * width; k++)
			to[k] = (unsigned char)(255 * fminf(fmaxf(from[k], 0), 1) + 0.5F);
	}
}

static bool is_unlit(const struct canvas *c, int sample)
{
	const uint32_t seen = c->tile.seen[sample];

	return seen != TS_TILE_NOTHING && ts_item_is_unlit(c->d->scene, &c->d->items->item[seen]);
}

/* Mixes in the background, the more the farther the surface is. */
static void add_haze(struct canvas *c, int sample, uint32_t y)
{
	const struct drawing *d = c->d;
	const struct ts_colour ground = background(d, y);
	const float t = (d->nearest - c->tile.depth[sample]) / (d->nearest - d->farthest);
	const float part = (float)d->style->haze * fminf(fmaxf(t, 0), 1);

	for (int k = 0; k < 3; k++)
		c->light[sample][k] += part * (ground.c[k] - fminf(c->light[sample][k], 1));
}

static void shade_tile(struct canvas *c)
{
	const struct drawing *d = c->d;
	const int width = samples_along(c->tile.x, d->width), height = samples_along(c->tile.y, d->height);

	for (int j = 0; j < height; j++)
		for (int i = 0; i < width; i++) {
			const int k = j * TS_TILE + i;
			float open = 1;

			shade_sample(c, i, j);
			if (d->depth && !is_unlit(c, k))
				open = ts_occlusion_at(&d->occlusion, c->tile.x + (uint32_t)i,
						       c->tile.y + (uint32_t)j);
			for (int b = 0; b < 3 && open < 1; b++)
				c->light[k][b] = open * fminf(c->light[k][b], 1);
			if (d->farthest < d->nearest && c->tile.seen[k] != TS_TILE_NOTHING && !is_unlit(c, k))
				add_haze(c, k, c->tile.y + (uint32_t)j);
		}
}

static void draw_tiles(void *context, size_t from, size_t to)
{
	struct canvas c = { .d = context };

	for (size_t k = from; k < to; k++) {
		const size_t number = k * c.d->stride % c.d->tiles;

		ts_tile_cover(&c.tile, c.d->items, number);
		shade_tile(&c);
		draw_glass(&c, number);
		store(&c);
	}
}

/* With occlusion all depths are computed before the first sample is shaded. */
static void find_depths(void *context, size_t from, size_t to)
{
	struct canvas c = { .d = context };

	for (size_t k = from; k < to; k++) {
		ts_tile_cover(&c.tile, c.d->items, k * c.d->stride % c.d->tiles);
		for (int j = 0, height = samples_along(c.tile.y, c.d->height); j < height; j++)
			memcpy(c.d->depth + (size_t)(c.tile.y + (uint32_t)j) * c.d->width + c.tile.x,
			       c.tile.depth + j * TS_TILE,
			       (size_t)samples_along(c.tile.x, c.d->width) * sizeof *c.d->depth);
	}
}

/* ---- the picture */

/* Means of four samples. */
static void average_rows(void *context, size_t from, size_t to)
{
	const struct drawing *d = context;
	const size_t row = 3 * (size_t)d->width;

	for (size_t y = from; y < to; y++)
		for (size_t x = 0; x < d->picture->width; x++)
			for (size_t k = 0; k < 3; k++) {
				const unsigned char *s = d->rgb + 2 * y * row + 6 * x + k;

				d->picture->rgb[3 * (y * d->picture->width + x) + k] =
					(unsigned char)((s[0] + s[3] + s[row] + s[row + 3] + 2) / 4);
			}
}

/* A number without a common divisor with n, near 0.618 n: each thread gets tiles from everywhere, as some parts of a picture
 * take longer than others. */
static size_t stride_of(size_t n)
{
	for (size_t s = n * 618 / 1000; s > 1; s--) {
		size_t a = n, b = s;

		while (b) {
			const size_t rest = a % b;

			a = b;
			b = rest;
		}
		if (a == 1)
			return s;
	}
	return 1;
}

static enum ts_status reserve(struct drawing *d, struct ts_picture_work *w)
{
	struct ts_picture *p = d->picture;
	const size_t samples = (size_t)d->width * d->height;

	TS_TRY(TS_GROW(p->rgb, p->capacity, 3 * (size_t)p->width * p->height));
	d->rgb = p->rgb;
	if (d->style->smooth) {
		TS_TRY(TS_GROW(w->sample, w->sample_capacity, 3 * samples));
		d->rgb = w->sample;
	}
	if (d->style->occlusion > 0) {
		TS_TRY(TS_GROW(w->depth, w->depth_capacity, samples));
		d->depth = w->depth;
	}
	return TS_OK;
}

enum ts_status ts_picture_draw(struct ts_picture *p, const struct ts_scene *scene,
			       const struct ts_camera *camera, const struct ts_picture_style *style,
			       int threads)
{
	const uint32_t finer = style->smooth ? 2 : 1;
	struct ts_camera samples = *camera;
	struct drawing d = { .scene = scene, .style = style, .shade = ts_shade_make(style), .picture = p };

	if (!p->work)
		p->work = ts_alloc(1, sizeof *p->work);
	if (!p->work)
		return TS_NOMEM;
	p->width = camera->width;
	p->height = camera->height;
	d.width = samples.width = finer * camera->width;
	d.height = samples.height = finer * camera->height;
	samples.scale *= finer;
	TS_TRY(reserve(&d, p->work));
	TS_TRY(ts_items_collect(&p->work->items, scene, &samples));
	d.items = &p->work->items;
	d.tiles = (size_t)d.items->columns * d.items->rows;
	d.stride = stride_of(d.tiles);
	d.occlusion = (struct ts_occlusion){ .width = d.width,
					     .height = d.height,
					     .depth = d.depth,
					     .background = TS_TILE_FAR,
					     .strength = style->occlusion,
					     .reach = samples.scale * style->crevice,
					     .seed = style->seed };
	if (style->haze > 0 && d.items->n) {
		d.nearest = d.items->item[0].nearest;
		d.farthest = d.items->item[d.items->n - 1].nearest;
	}
	if (d.depth)
		ts_parallel(threads, d.tiles, find_depths, &d);
	ts_parallel(threads, d.tiles, draw_tiles, &d);
	if (style->smooth)
		ts_parallel(threads, p->height, average_rows, &d);
	return TS_OK;
}

void ts_picture_release(struct ts_picture *p)
{
	if (p->work) {
		ts_items_release(&p->work->items);
		ts_free(p->work->sample);
		ts_free(p->work->depth);
	}
	ts_free(p->work);
	ts_free(p->rgb);
	memset(p, 0, sizeof *p);
}
