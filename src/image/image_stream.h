/* Streamlines of a slice: its word streams. */
#ifndef TS_IMAGE_IMAGE_STREAM_H
#define TS_IMAGE_IMAGE_STREAM_H

#include "image/image_slice.h"

/* Adds them, if the slice has them; its position is known. */
enum ts_status ts_image_add_streams(struct ts_scene *scene, struct tsim *sim, const struct ts_image_slice *s,
				    const struct ts_fluid *fluid);

#endif
