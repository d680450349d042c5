#include "render/scene.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

static bool finite3(const double x[3])
{
	return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

enum ts_status ts_scene_add_sphere(struct ts_scene *s, const double x[3], double radius,
				   struct ts_colour colour)
{
	struct ts_scene_sphere *to;

	if (!finite3(x) || !(radius > 0) || isinf(radius))
		return TS_OK;
	TS_TRY(TS_GROW(s->sphere, s->sphere_capacity, s->nspheres + 1));
	to = &s->sphere[s->nspheres++];
	memcpy(to->x, x, sizeof to->x);
	to->radius = radius;
	to->colour = colour;
	return TS_OK;
}

enum ts_status ts_scene_add_rod(struct ts_scene *s, const double a[3], const double b[3], double radius,
				struct ts_colour colour)
{
	struct ts_scene_rod *to;

	if (!finite3(a) || !finite3(b) || !(radius > 0) || isinf(radius))
		return TS_OK;
	TS_TRY(TS_GROW(s->rod, s->rod_capacity, s->nrods + 1));
	to = &s->rod[s->nrods++];
	memcpy(to->end[0], a, sizeof to->end[0]);
	memcpy(to->end[1], b, sizeof to->end[1]);
	to->radius = radius;
	to->colour = colour;
	return TS_OK;
}

enum ts_status ts_scene_add_triangle(struct ts_scene *s, const double corner[3][3], struct ts_colour colour,
				     double opacity)
{
	struct ts_scene_triangle *to;

	if (!finite3(corner[0]) || !finite3(corner[1]) || !finite3(corner[2]) || !(opacity > 0))
		return TS_OK;
	TS_TRY(TS_GROW(s->triangle, s->triangle_capacity, s->ntriangles + 1));
	to = &s->triangle[s->ntriangles++];
	memcpy(to->corner, corner, sizeof to->corner);
	to->colour = colour;
	to->opacity = (float)fmin(opacity, 1);
	return TS_OK;
}

enum ts_status ts_scene_add_quadrangle(struct ts_scene *s, const double corner[4][3], struct ts_colour colour,
				       double opacity)
{
	double part[2][3][3];

	for (int d = 0; d < 3; d++)
		for (int k = 0; k < 3; k++) {
			part[0][k][d] = corner[k][d];
			part[1][k][d] = corner[(k + 2) % 4][d];
		}
	TS_TRY(ts_scene_add_triangle(s, (const double(*)[3])part[0], colour, opacity));
	return ts_scene_add_triangle(s, (const double(*)[3])part[1], colour, opacity);
}

void ts_scene_clear(struct ts_scene *s)
{
	s->nspheres = s->nrods = s->ntriangles = 0;
}

void ts_scene_release(struct ts_scene *s)
{
	ts_free(s->sphere);
	ts_free(s->rod);
	ts_free(s->triangle);
	memset(s, 0, sizeof *s);
}
