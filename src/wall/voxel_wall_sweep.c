/* `impact exact` on height fields (wall/exact_surface.h): the first touch of a sphere on a straight path, by conservative
 * advancement. No part of the solid is reached before the sphere has travelled its distance from the nearest contact
 * point that it approaches; so the path is followed in steps of that length until the distance is that of a touch. Near
 * it the rate at which the distance decreases predicts the touch. */
#include "wall/voxel_wall.h"

#include <math.h>

#include "box/domain.h"
#include "math/vec3.h"
#include "wall/exact_surface.h"

#include "base/banned.h"

enum {
	MAX_POINTS = 128, /* contact points within the range of a search */
	MAX_ADVANCES =
		100000 /* beside the highest column at 1 degree 1000, at 0.1 degrees 10 000; then it counts as a touch */
};
/* A sphere touches where its distance from the surface is below this part of its radius. */
static const double touch_tolerance = 1e-12;

struct search {
	const struct ts_voxel_field *field;
	const struct ts_sweep *path; /* in the frame of one image of the field */
	double speed;
};

/* The contact point that the sphere touches next. */
struct approach {
	double gap;  /* distance of the surfaces; at most the range of the search */
	double rate; /* -d gap/dt, > 0; 0: no contact point is approached within the range */
	struct ts_voxel_contact at;
};

static void position_at(const struct ts_sweep *path, double time, double x[3])
{
	ts_scale(1, path->x, x);
	ts_axpy(time, path->v, x);
}

/* The contact points within *range of the surface of the sphere; halves the range until they are few enough. */
static size_t find_points(const struct search *s, const double x[3], double *range,
			  struct ts_voxel_contact *point)
{
	for (;;) {
		size_t n = ts_voxel_contacts(s->field, x, s->path->radius + *range, point, MAX_POINTS);

		if (n <= MAX_POINTS)
			return n;
		*range *= 0.5;
		if (*range < touch_tolerance * s->path->radius)
			return MAX_POINTS;
	}
}

static struct approach nearest_approach(const struct search *s, const double x[3])
{
	struct ts_voxel_contact point[MAX_POINTS];
	struct approach out = { .gap = s->path->radius };
	size_t n = find_points(s, x, &out.gap, point);

	for (size_t k = 0; k < n; k++) {
		double gap = point[k].distance - s->path->radius, rate = -ts_dot(point[k].n, s->path->v);

		if (!(rate > 0) || !(gap < out.gap))
			continue;
		out = (struct approach){ gap, rate, point[k] };
	}
	return out;
}

/* Time at which the sphere reaches the level of the highest column; infinite: it does not approach it. */
static double time_to_top(const struct search *s)
{
	const struct ts_voxel_field *f = s->field;
	double above = s->path->x[f->axis[2]] - s->path->radius - ts_voxel_highest(f);
	double speed = -s->path->v[f->axis[2]];

	if (!(above > 0))
		return 0;
	return speed > 0 ? above / speed : INFINITY;
}

static void store_hit(const struct search *s, double time, const struct approach *a,
		      struct ts_exact_touch *out)
{
	const struct ts_voxel_field *f = s->field;
	int64_t i = ts_voxel_wrap(f, 0, a->at.column[0]), j = ts_voxel_wrap(f, 1, a->at.column[1]);

	out->hit.time = time;
	ts_scale(1, a->at.n, out->hit.n);
	out->hit.overlap = time > 0 ? 0 : fmax(0, -a->gap);
	position_at(s->path, time, out->point);
	ts_axpy(-s->path->radius, out->hit.n, out->point);
	out->element = (size_t)(j * f->n[0] + i);
}

/* How far the sphere may go on: by its distance, which is safe; near a touch by the rate of approach, but by no more
 * than twice that distance, as another column may come nearer. */
static double advance(const struct search *s, const struct approach *a)
{
	double safe = a->gap / s->speed;

	return a->rate > 0 && a->gap < 0.01 * s->path->radius ? fmin(a->gap / a->rate, 2 * safe) : safe;
}

/* Whether the path touches this image of the field. */
static bool sweep_image(const struct search *s, struct ts_exact_touch *out)
{
	double tolerance = touch_tolerance * s->path->radius, time = time_to_top(s), safe = time, x[3];

	for (int k = 0; time <= s->path->span || safe < time; k++) {
		struct approach a;

		position_at(s->path, time, x);
		a = nearest_approach(s, x);
		if (safe < time && (a.gap < -tolerance || time > s->path->span)) {
			time = safe; /* another column has come nearer, or may do so before the end of the path */
			continue;
		}
		if (a.rate > 0 && (a.gap <= tolerance || k >= MAX_ADVANCES)) {
			store_hit(s, time, &a, out);
			return true;
		}
		safe = time + a.gap / s->speed;
		time += advance(s, &a);
	}
	return false;
}

/* The field is at its place of the end of the step, at which the path ends, too. */
static enum ts_status sweep(const struct tsim *sim, const void *shape, size_t i, const struct ts_sweep *path,
			    struct ts_mesh_list *list, bool *found, struct ts_exact_touch *out)
{
	const struct ts_voxel_wall *vw = shape;
	const struct ts_voxel_surface *surface = vw->surface;
	struct ts_voxel_images images;
	struct ts_sweep relative = *path;
	struct search s = { .field = &surface->field, .path = &relative };
	double velocity[3], x[3];

	(void)i;
	(void)list;
	*found = false;
	ts_scale(1 / sim->clock.dt, surface->moved, velocity);
	ts_sub(path->v, velocity, relative.v);
	ts_scale(1, path->x, x);
	ts_axpy(path->span, velocity, x);
	s.speed = ts_norm(relative.v);
	if (!(s.speed > 0))
		return TS_OK;
	ts_voxel_images(surface, &sim->domain->box, x, &images);
	for (int k = 0; k < images.n; k++) {
		struct ts_exact_touch touch = { .type = (int)surface->type };

		ts_scale(1, images.x[k], relative.x);
		if (!sweep_image(&s, &touch) || (*found && !(touch.hit.time < out->hit.time)))
			continue;
		*found = true;
		*out = touch;
		ts_add(out->point, surface->shift, out->point);
		ts_scale(1, velocity, out->velocity);
	}
	return TS_OK;
}

const struct ts_exact_surface ts_voxel_wall_exact = { .sweep = sweep };
