#include "geom/sweep.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

/* First time from 0 on at which |p + t v| = r, |p| being larger, p.v < 0; infinite: never. */
static double reach_from_outside(const double p[3], const double v[3], double r)
{
	double a = ts_dot(v, v), b = -ts_dot(p, v), c = ts_dot(p, p) - r * r, d = b * b - a * c;

	return d >= 0 ? c / (b + sqrt(d)) : INFINITY;
}

/* The same with |p| smaller: there is always one, unless v = 0. */
static double reach_from_inside(const double p[3], const double v[3], double r)
{
	double a = ts_dot(v, v), b = ts_dot(p, v), c = ts_dot(p, p) - r * r, root = sqrt(b * b - a * c);

	if (!(a > 0))
		return INFINITY;
	return b > 0 ? -c / (b + root) : (root - b) / a;
}

/* A sphere at p relative to a point, or in the plane across a line. */
static bool hit_centre(const struct ts_sweep *s, const double p[3], const double v[3],
		       struct ts_sweep_hit *hit)
{
	double distance = ts_norm(p);

	if (!(ts_dot(p, v) < 0))
		return false;
	hit->overlap = fmax(0, s->radius - distance);
	hit->time = distance > s->radius ? reach_from_outside(p, v, s->radius) : 0;
	if (!(hit->time <= s->span))
		return false;
	ts_scale(1, p, hit->n);
	ts_axpy(hit->time, v, hit->n);
	ts_scale(1 / ts_norm(hit->n), hit->n, hit->n);
	return true;
}

bool ts_sweep_point(const struct ts_sweep *s, const double point[3], struct ts_sweep_hit *hit)
{
	double p[3];

	ts_sub(s->x, point, p);
	return hit_centre(s, p, s->v, hit);
}

bool ts_sweep_line(const struct ts_sweep *s, const double a[3], const double along[3], double length,
		   struct ts_sweep_hit *hit)
{
	double p[3], v[3], position, speed = ts_dot(s->v, along);

	ts_sub(s->x, a, p);
	position = ts_dot(p, along);
	ts_axpy(-position, along, p);
	ts_scale(1, s->v, v);
	ts_axpy(-speed, along, v);
	if (!hit_centre(s, p, v, hit))
		return false;
	position += hit->time * speed;
	return position > 0 && position < length;
}

static bool hit_plane(const struct ts_sweep *s, double height, double rate, struct ts_sweep_hit *hit)
{
	double side = height > 0 ? 1 : -1, gap = fabs(height) - s->radius, approach = -side * rate;

	if (!(approach > 0) || !(fabs(height) > 0))
		return false;
	hit->overlap = fmax(0, -gap);
	hit->time = fmax(0, gap) / approach;
	return hit->time <= s->span;
}

bool ts_sweep_plane(const struct ts_sweep *s, const double a[3], const double normal[3],
		    struct ts_sweep_hit *hit)
{
	double arm[3], height;

	ts_sub(s->x, a, arm);
	height = ts_dot(arm, normal);
	ts_scale(height > 0 ? 1 : -1, normal, hit->n);
	return hit_plane(s, height, ts_dot(s->v, normal), hit);
}

static bool hit_cylinder(const struct ts_sweep *s, const struct ts_primitive *wall, struct ts_sweep_hit *hit)
{
	int axis = (int)wall->shape - TS_XCYLINDER, a = (axis + 1) % 3, b = (axis + 2) % 3;
	double p[3] = { s->x[a] - wall->centre[0], s->x[b] - wall->centre[1], 0 };
	double v[3] = { s->v[a], s->v[b], 0 }, r = ts_norm(p), side = r > wall->radius ? 1 : -1, at, norm;

	at = wall->radius + side * s->radius; /* distance of the centre from the axis at the touch */
	hit->overlap = fmax(0, side * (at - r));
	hit->time = 0;
	if (hit->overlap > 0 || side * (r - at) <= 0) {
		if (!(side * ts_dot(p, v) < 0))
			return false;
	} else if (side > 0) {
		hit->time = ts_dot(p, v) < 0 ? reach_from_outside(p, v, at) : INFINITY;
	} else {
		hit->time = reach_from_inside(p, v, at);
	}
	if (!(hit->time <= s->span))
		return false;
	ts_axpy(hit->time, v, p);
	norm = ts_norm(p);
	hit->n[axis] = 0;
	hit->n[a] = norm > 0 ? side * p[0] / norm : 0;
	hit->n[b] = norm > 0 ? side * p[1] / norm : 0;
	return norm > 0;
}

bool ts_sweep_primitive(const struct ts_sweep *s, const struct ts_primitive *wall, struct ts_sweep_hit *hit)
{
	int dim = (int)wall->shape;
	double height;

	if (wall->shape > TS_ZPLANE)
		return hit_cylinder(s, wall, hit);
	height = s->x[dim] - wall->position;
	hit->n[0] = hit->n[1] = hit->n[2] = 0;
	hit->n[dim] = height > 0 ? 1 : -1;
	return hit_plane(s, height, s->v[dim], hit);
}
