/* Slices of the fields of the fluid: the keyword slice. */
#ifndef TS_IMAGE_IMAGE_SLICE_H
#define TS_IMAGE_IMAGE_SLICE_H

#include "flow/flow_sampling.h"
#include "image/image_arrow.h"

struct ts_image_slice {
	struct ts_image_group group;
	int axis;
	struct ts_number position; /* length */
	const char *quantity;	   /* or "none" */
	double opacity;
	const char *body; /* colour inside of bodies, or "none" */
	struct ts_colour body_colour;
	double spacing; /* of arrows of the velocity, length; NaN: none */
	double streams; /* distance of streamlines, length; NaN: none */
	struct ts_image_arrow_style style;
	struct ts_flow_sampler sampler;
	struct ts_word word; /* of the sampler */
	/* of the present frame */
	double at;	 /* position */
	bool valid;	 /* it is in the grid */
	double *node[2]; /* [n] coordinates of the corners along the axes of the plane */
	size_t n[2], node_capacity[2], capacity, place_capacity, distance_capacity;
	double *value; /* [n[1]][n[0]] at the corners */
	double (*place)[3];
	double *distance; /* from bodies */
	struct ts_scene_scale scale;
	bool told; /* of a position outside of the grid */
};
enum ts_status ts_image_read_slices(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_slices(struct ts_instance *self, struct tsim *sim);
void ts_image_release_slices(struct ts_image *d);

#endif
