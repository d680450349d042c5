/* The parts of a scene in the coordinates of samples, from the nearest to the farthest, and the tiles that they touch. */
#ifndef TS_RENDER_ITEMS_H
#define TS_RENDER_ITEMS_H

#include "render/camera.h"
#include "render/scene.h"

enum { TS_TILE = 64 /* samples along the edge of a tile */ };

/* A sphere, or a rod or cone from a to b, in samples: x to the right, y downwards, z towards the camera. */
struct ts_item_round {
	double a[3], b[3], radius;
};
struct ts_item_triangle {
	double corner[3][3];
	float normal[3];	   /* unit vector, towards the camera; y upwards */
	float corner_normal[3][3]; /* of smooth ones */
};

enum ts_item_kind { TS_ITEM_SPHERE, TS_ITEM_ROD, TS_ITEM_CONE, TS_ITEM_TRIANGLE };

struct ts_item {
	float nearest;	/* z of its nearest point */
	uint8_t kind;	/* enum ts_item_kind */
	bool glass;	/* transparent */
	bool whole;	/* not cut */
	uint32_t index; /* in the array of its kind */
};

/* A plane that cuts: samples with place . (x, y, z) > offset are removed. */
struct ts_item_cut {
	double place[3], offset;
};

/* Zero-initialise. */
struct ts_items {
	struct ts_item *item; /* [n], from the nearest to the farthest */
	size_t n, capacity;
	struct ts_item_round *round; /* spheres, then rods and cones */
	struct ts_item_triangle *triangle;
	size_t round_capacity, triangle_capacity;
	uint32_t columns, rows;	 /* tiles */
	uint32_t *first, *touch; /* items of tile t: touch[first[t]] .. touch[first[t + 1] - 1] */
	size_t first_capacity, touch_capacity, ntouch;
	uint64_t *key; /* for sorting */
	size_t key_capacity;
	struct ts_item_cut cut[TS_SCENE_CUTS];
	int ncuts;
};

/* Projects the scene to width x height samples, sorts its parts and finds their tiles. `camera` has the size and the scale
 * of the samples. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_items_collect(struct ts_items *items, const struct ts_scene *scene,
				const struct ts_camera *camera);
void ts_items_release(struct ts_items *items);

#endif
