/* A camera with parallel projection: how lengths of the simulation become pixels. */
#ifndef TS_RENDER_CAMERA_H
#define TS_RENDER_CAMERA_H

#include <stdbool.h>
#include <stdint.h>

struct ts_camera {
	double right[3], up[3], towards[3]; /* orthonormal; `towards` points from the scene to the camera */
	double centre[3];		    /* the point in the middle of the picture, length */
	double scale;			    /* pixels per length */
	uint32_t width, height;		    /* pixels */
};

/* Sets the directions: the camera is at the angle theta from +z and phi around z (radian) as seen from the centre, and
 * the projection of `up` points upwards. False: `up` is zero or parallel to the view. */
bool ts_camera_look(struct ts_camera *camera, double theta, double phi, const double up[3]);
/* Sets the scale as LAMMPS does: the height of the picture is twice the longest edge of the box, divided by zoom. */
void ts_camera_zoom(struct ts_camera *camera, const double box_length[3], double zoom);
/* Place in the picture in pixels: to the right of its left edge, down from its upper edge, towards the camera from the
 * centre. Pixel (i, j) covers i .. i + 1, j .. j + 1. */
void ts_camera_project(const struct ts_camera *camera, const double x[3], double out[3]);

#endif
