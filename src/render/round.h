/* Round bodies along a ray: where a sphere, a rod or a cone begins and ends behind a sample, and its normal there. */
#ifndef TS_RENDER_ROUND_H
#define TS_RENDER_ROUND_H

#include "render/items.h"

/* A body in coordinates of samples from the place `from`. */
struct ts_round {
	enum ts_item_kind kind;
	double from[2], a[3], b[3], u[3]; /* ends; u: unit vector from a to b */
	double radius, length;
};

struct ts_round ts_round_make(const struct ts_item_round *s, enum ts_item_kind kind, double x, double y);
/* z of the nearest and of the farthest point on the ray through x, y, which is relative to `from`; false: missed. */
bool ts_round_span(const struct ts_round *r, double x, double y, double *nearest, double *farthest);
/* Unit normal at a point of its surface; y upwards. */
void ts_round_normal(const struct ts_round *r, double x, double y, double z, float n[3]);

#endif
