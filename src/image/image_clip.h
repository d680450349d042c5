/* Planes that cut the scene open: the keyword clip. */
#ifndef TS_IMAGE_IMAGE_CLIP_H
#define TS_IMAGE_IMAGE_CLIP_H

#include "image/image_groups.h"

struct ts_image_clip {
	struct ts_image_group group;
	int axis, below;
	struct ts_number position; /* length */
};
enum ts_status ts_image_read_clips(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_clips(struct ts_instance *self, struct tsim *sim);

#endif
