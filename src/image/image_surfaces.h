/* Surfaces of a picture: meshes, height fields, plane and cylinder walls; the keywords mesh, voxel and wall. */
#ifndef TS_IMAGE_IMAGE_SURFACES_H
#define TS_IMAGE_IMAGE_SURFACES_H

#include "image/image.h"

struct ts_image_surface;

/* How the surfaces of a keyword are found and drawn. */
struct ts_image_sort {
	const char *name; /* the keyword */
	unsigned colour;  /* 0xRRGGBB, if no color is given */
	double opacity;	  /* if no `trans` is given */
	/* Fails if the ID is not that of such a surface. */
	enum ts_status (*require)(struct tsim *sim, const struct ts_word *id);
	/* Iterates over all of them in script order: start with *k = 0; returns NULL at the end. */
	const struct ts_instance *(*next)(const struct tsim *sim, size_t *k);
	/* Number of elements. */
	size_t (*elements)(const struct ts_instance *by);
	/* Values by elements that the surface itself has; false: it does not have them. NULL: none. */
	bool (*value)(const struct ts_instance *by, const char *name, double *out);
	/* Adds it to the scene. */
	enum ts_status (*add)(struct tsim *sim, const struct ts_instance *by, struct ts_scene *scene,
			      const struct ts_image_surface *s);
};
extern const struct ts_image_sort ts_image_mesh, ts_image_voxel, ts_image_wall;

/* The words after one keyword. */
struct ts_image_surface {
	const struct ts_image_sort *sort;
	const char *id;		 /* or "all" */
	const char *colour_name; /* NULL: not given */
	const char *value;	 /* NULL: one color */
	double opacity;		 /* NaN: not given */
	double smooth;		 /* of meshes: angle, degrees; 0: flat triangles */
	struct ts_word id_word;
	struct ts_ref_input input; /* .name NULL: the value is one of the surface itself */
	struct ts_colour colour;
	/* of the present frame */
	const struct ts_colour_map *map;
	struct ts_table values; /* by elements; no rows: one color */
	double range[2];
};

#endif
