/* One tile of a picture: which surface each sample sees. */
#ifndef TS_RENDER_TILE_H
#define TS_RENDER_TILE_H

#include "render/items.h"

enum { TS_TILE_SAMPLES = TS_TILE * TS_TILE };
#define TS_TILE_FAR (-3e38f) /* depth of the background */
#define TS_TILE_NOTHING UINT32_MAX

struct ts_tile {
	uint32_t x, y;			/* its first sample */
	float depth[TS_TILE_SAMPLES];	/* z of the surface seen, samples */
	uint32_t seen[TS_TILE_SAMPLES]; /* number of the item */
	/* with planes that cut: the part of each ray that they leave */
	float high[TS_TILE_SAMPLES], low[TS_TILE_SAMPLES];
};

/* Finds the nearest opaque surface at the middle of each sample. */
void ts_tile_cover(struct ts_tile *tile, const struct ts_items *items, size_t number);

/* Calls `visit` for each sample of an item that is not behind the surface seen; z: depth there. */
typedef void ts_tile_visit_fn(void *context, uint32_t sample, float z);
void ts_tile_visit(const struct ts_tile *tile, const struct ts_items *items, const struct ts_item *item,
		   ts_tile_visit_fn *visit, void *context);
/* Whether the surface of an item at z is the face of a cut; then its normal (y upwards). */
bool ts_tile_is_cut_face(const struct ts_tile *tile, const struct ts_items *items, const struct ts_item *item,
			 uint32_t sample, float z, float normal[3]);

#endif
