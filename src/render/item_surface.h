/* Colour, opacity and normal of an item at a sample. */
#ifndef TS_RENDER_ITEM_SURFACE_H
#define TS_RENDER_ITEM_SURFACE_H

#include "render/items.h"

/* Its colour is seen as it is, without light. */
bool ts_item_is_unlit(const struct ts_scene *scene, const struct ts_item *item);
float ts_item_opacity(const struct ts_scene *scene, const struct ts_item *item);
/* Colour at the sample x, y of the picture; of painted triangles that of the number there. */
struct ts_colour ts_item_colour(const struct ts_scene *scene, const struct ts_items *items,
				const struct ts_item *item, double x, double y);
/* Unit normal towards the camera, y upwards. */
void ts_item_normal(const struct ts_scene *scene, const struct ts_items *items, const struct ts_item *item,
		    double x, double y, double z, float n[3]);

#endif
