#include "render/scene.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

static bool finite3(const double x[3])
{
	return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

enum ts_status ts_scene_add_sphere(struct ts_scene *s, const double x[3], double radius,
				   struct ts_colour colour, double opacity)
{
	struct ts_scene_sphere *to;

	if (!finite3(x) || !(radius > 0) || isinf(radius) || !(opacity > 0))
		return TS_OK;
	TS_TRY(TS_GROW(s->sphere, s->sphere_capacity, s->nspheres + 1));
	to = &s->sphere[s->nspheres++];
	*to = (struct ts_scene_sphere){
		.radius = radius, .colour = colour, .opacity = (float)fmin(opacity, 1), .whole = s->whole
	};
	memcpy(to->x, x, sizeof to->x);
	return TS_OK;
}

static enum ts_status add_rod(struct ts_scene *s, const double a[3], const double b[3], double radius,
			      struct ts_colour colour, bool cone)
{
	struct ts_scene_rod *to;

	if (!finite3(a) || !finite3(b) || !(radius > 0) || isinf(radius))
		return TS_OK;
	TS_TRY(TS_GROW(s->rod, s->rod_capacity, s->nrods + 1));
	to = &s->rod[s->nrods++];
	*to = (struct ts_scene_rod){ .radius = radius, .colour = colour, .cone = cone, .whole = s->whole };
	memcpy(to->end[0], a, sizeof to->end[0]);
	memcpy(to->end[1], b, sizeof to->end[1]);
	return TS_OK;
}

enum ts_status ts_scene_add_rod(struct ts_scene *s, const double a[3], const double b[3], double radius,
				struct ts_colour colour)
{
	return add_rod(s, a, b, radius, colour, false);
}

enum ts_status ts_scene_add_cone(struct ts_scene *s, const double base[3], const double tip[3], double radius,
				 struct ts_colour colour)
{
	return add_rod(s, base, tip, radius, colour, true);
}

enum ts_status ts_scene_add_painted(struct ts_scene *s, const struct ts_scene_triangle *t)
{
	struct ts_scene_triangle *to;

	if (!finite3(t->corner[0]) || !finite3(t->corner[1]) || !finite3(t->corner[2]) || !(t->opacity > 0))
		return TS_OK;
	TS_TRY(TS_GROW(s->triangle, s->triangle_capacity, s->ntriangles + 1));
	to = &s->triangle[s->ntriangles++];
	*to = *t;
	to->opacity = fminf(t->opacity, 1);
	to->whole = s->whole;
	return TS_OK;
}

enum ts_status ts_scene_add_triangle(struct ts_scene *s, const double corner[3][3], struct ts_colour colour,
				     double opacity)
{
	struct ts_scene_triangle t = { .colour = colour, .opacity = (float)opacity };

	memcpy(t.corner, corner, sizeof t.corner);
	return ts_scene_add_painted(s, &t);
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
	s->ncuts = 0;
	s->whole = false;
}

void ts_scene_release(struct ts_scene *s)
{
	ts_free(s->sphere);
	ts_free(s->rod);
	ts_free(s->triangle);
	memset(s, 0, sizeof *s);
}
