/* Surfaces of regions: the keyword region. */
#ifndef TS_IMAGE_IMAGE_REGION_H
#define TS_IMAGE_IMAGE_REGION_H

#include "image/image_groups.h"

struct ts_image_region {
	struct ts_image_group group;
	struct ts_instance *region;
	const char *colour_name;
	int style; /* filled or transparent */
	double opacity;
	struct ts_colour colour;
	/* of the present frame: depths of the points of a grid around it */
	double origin[3], spacing; /* length */
	size_t n[3], capacity;
	float *depth; /* [n[2]][n[1]][n[0]], length; < 0 outside */
};
enum ts_status ts_image_read_regions(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_regions(struct ts_instance *self, struct tsim *sim);
void ts_image_release_regions(struct ts_image *d);

#endif
