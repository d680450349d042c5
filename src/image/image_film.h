/* Lubrication films: the keyword film. */
#ifndef TS_IMAGE_IMAGE_FILM_H
#define TS_IMAGE_IMAGE_FILM_H

#include "image/image.h"
#include "image/image_groups.h"

struct ts_image_film {
	struct ts_image_group group;
	int quantity;
	struct ts_number height; /* of the plane (length) */
	double relief;		 /* factor of the gap that is added to it */
	double opacity;
	struct ts_scene_scale scale; /* of the present frame */
};
enum ts_status ts_image_read_films(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_films(struct ts_instance *self, struct tsim *sim);
/* The quantity as in the script. */
const char *ts_image_film_quantity(const struct ts_image_film *film);

#endif
