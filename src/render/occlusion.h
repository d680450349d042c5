/* Ambient occlusion in the space of the screen: a sample is darkened by the surfaces around it that are nearer to the
 * camera (M. Mittring, SIGGRAPH 2007 course 28, section 8.5.4.3). */
#ifndef TS_RENDER_OCCLUSION_H
#define TS_RENDER_OCCLUSION_H

#include <stddef.h>
#include <stdint.h>

struct ts_occlusion {
	uint32_t width, height;
	const float *depth; /* [height][width], samples; below `background`: nothing is there */
	float background;
	double strength; /* 0 to 1 */
	double reach;	 /* samples */
	uint32_t seed;
};

/* Factor from 1 - strength to 1 for the light of a sample. It depends on the place, the seed and the depths only. */
float ts_occlusion_at(const struct ts_occlusion *o, uint32_t x, uint32_t y);

#endif
