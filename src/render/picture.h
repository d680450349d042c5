/* Draws a scene as seen by a camera. Each sphere, cylinder and triangle is computed for each pixel that it covers, not
 * approximated by polygons: the nearest surface is kept, then shaded. The picture is divided into tiles that are drawn
 * independently, so it has the same bits for any number of threads. */
#ifndef TS_RENDER_PICTURE_H
#define TS_RENDER_PICTURE_H

#include "render/camera.h"
#include "render/scene.h"

/* Strengths of the lights; the key light is from the upper left, the fill light from the right, the back light from behind.
 * Names and directions are those of LAMMPS. */
struct ts_lights {
	double ambient, key, fill, back;
};
#define TS_LIGHTS_DEFAULT           \
	{                           \
		0.0, 0.9, 0.45, 0.9 \
	}

struct ts_picture_style {
	struct ts_colour ground[2]; /* background: at the lower and at the upper edge */
	struct ts_lights lights;
	double shiny;	  /* 0: dull; 1: highlights */
	double haze;	  /* part of the background in the colour of the farthest surface; 0: none */
	bool smooth;	  /* four samples per pixel */
	double occlusion; /* 0: none; 1: crevices are black */
	double crevice;	  /* distance within which surfaces darken each other, length */
	uint32_t seed;	  /* of the directions that are sampled for it */
};

/* Zero-initialise. */
struct ts_picture {
	uint32_t width, height;
	unsigned char *rgb; /* [height][width][3], the first row is the upper one */
	size_t capacity;
	struct ts_picture_work *work; /* kept for the next picture */
};

/* Largest number of pixels along an edge, and of samples of a picture: with more, `smooth` or the size is refused. */
enum { TS_PICTURE_EDGE = 16384 };
#define TS_PICTURE_SAMPLES ((size_t)1 << 28)

/* Draws the scene. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_picture_draw(struct ts_picture *p, const struct ts_scene *scene,
			       const struct ts_camera *camera, const struct ts_picture_style *style,
			       int threads);
void ts_picture_release(struct ts_picture *p);

#endif
