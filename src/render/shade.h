/* Light on a surface: ambient, three diffuse lights, highlights of the key and the fill light. */
#ifndef TS_RENDER_SHADE_H
#define TS_RENDER_SHADE_H

#include "render/picture.h"

/* What the lights of a style are in the coordinates of the camera: x to the right, y upwards, z towards the camera. */
struct ts_shade {
	float ambient, light[3], direction[3][3]; /* key, fill, back */
	float middle[2][3];			  /* unit vectors half-way from key and fill to the camera */
	float shiny, hardness;
};

struct ts_shade ts_shade_make(const struct ts_picture_style *style);
/* Light that comes from a surface of this colour with the unit normal n, not limited to 1. */
void ts_shade_surface(const struct ts_shade *s, const float n[3], const struct ts_colour *colour,
		      float out[3]);

#endif
