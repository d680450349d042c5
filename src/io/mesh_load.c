#include "io/mesh_load.h"

#include <math.h>
#include <stdlib.h>

#include "io/mesh_read.h"
#include "io/mesh_soup.h"
#include "geom/mesh_links.h"
#include "math/vec3.h"
#include "particles/mesh_motion.h"

#include "base/banned.h"

static const double SHARP = 0.5, TOO_SHARP = 0.0181185; /* angles of triangles, degrees */

const char *const ts_mesh_heal_names[] = { "no", "auto_remove_duplicates", NULL };

static double smallest_angle(const struct ts_mesh *m, size_t t)
{
	double least = 180;

	for (int k = 0; k < 3; k++) {
		double c = -ts_dot(m->along[t][k], m->along[t][(k + 2) % 3]);

		least = fmin(least, acos(fmax(-1, fmin(1, c))) * 180 / TS_MESH_PI);
	}
	return m->area[t] > 0 ? least : 0;
}

static enum ts_status check_angles(struct ts_instance *self, struct tsim *sim,
				   const struct ts_mesh_words *w, const struct ts_mesh *m)
{
	size_t sharp = 0;

	for (size_t t = 0; t < m->n; t++) {
		double angle = smallest_angle(m, t);

		if (!(angle >= TOO_SHARP))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "mesh %s: triangle %zu at (%g, %g, %g) has an angle of %g "
				       "degrees, at least %g is needed",
				       self->id, t + 1, m->centre[t][0], m->centre[t][1],
				       m->centre[t][2], angle, TOO_SHARP);
		if (angle < w->curvature && !w->curvature_tolerant)
			return ts_fail(
				&sim->error, TS_RANGE, ts_instance_word(self, "curvature"),
				"mesh %s: curvature is %g degrees, but triangle %zu at (%g, %g, %g) "
				"has an angle of %g; `curvature_tolerant yes` takes it all the same",
				self->id, w->curvature, t + 1, m->centre[t][0], m->centre[t][1],
				m->centre[t][2], angle);
		sharp += angle < SHARP;
		if (angle < SHARP && w->verbose)
			ts_warn(&sim->log, &self->where, "mesh %s: triangle %zu has an angle of %g degrees",
				self->id, t + 1, angle);
	}
	if (sharp)
		ts_warn(&sim->log, &self->where,
			"mesh %s: %zu of %zu triangles have an angle below %g degrees", self->id,
			sharp, m->n, SHARP);
	return TS_OK;
}

/* Triangles with the same three corners. */
struct corners {
	int32_t vertex[3], triangle;
};

static void set_corners(struct corners *c, const struct ts_mesh *m, size_t t)
{
	int32_t *v = c->vertex;

	for (int k = 0; k < 3; k++)
		v[k] = m->vertex[t][k];
	for (int k = 0; k < 3; k++) { /* three exchanges sort three numbers */
		int32_t a = v[k % 2], b = v[k % 2 + 1];

		v[k % 2] = a < b ? a : b;
		v[k % 2 + 1] = a < b ? b : a;
	}
	c->triangle = (int32_t)t;
}

static int by_corners(const void *a, const void *b)
{
	const struct corners *p = a, *q = b;

	for (int k = 0; k < 3; k++)
		if (p->vertex[k] != q->vertex[k])
			return p->vertex[k] < q->vertex[k] ? -1 : 1;
	return (p->triangle > q->triangle) - (p->triangle < q->triangle);
}

/* twice[t]: there is an earlier triangle with the same corners. */
static enum ts_status find_duplicates(const struct ts_mesh *m, unsigned char *twice, size_t *found)
{
	struct corners *list = ts_alloc(m->n, sizeof *list);

	if (!list)
		return TS_NOMEM;
	for (size_t t = 0; t < m->n; t++)
		set_corners(&list[t], m, t);
	qsort(list, m->n, sizeof *list, by_corners);
	*found = 0;
	for (size_t k = 1; k < m->n; k++) {
		bool same = true;

		for (int d = 0; d < 3; d++)
			same &= list[k].vertex[d] == list[k - 1].vertex[d];
		twice[list[k].triangle] = same;
		*found += same;
	}
	ts_free(list);
	return TS_OK;
}

static enum ts_status refuse_duplicates(struct ts_instance *self, struct tsim *sim,
					const struct ts_mesh *m, const unsigned char *twice,
					size_t found)
{
	size_t t = 0;

	while (!twice[t])
		t++;
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "mesh %s: %zu triangles are given twice, the first is triangle %zu at (%g, %g, "
		       "%g); `heal auto_remove_duplicates` drops them",
		       self->id, found, t + 1, m->centre[t][0], m->centre[t][1], m->centre[t][2]);
}

static enum ts_status build(struct ts_instance *self, struct tsim *sim,
			    const struct ts_mesh_words *w, double (*x)[3][3], size_t n,
			    struct ts_mesh *m)
{
	enum ts_status status =
		ts_mesh_build(m, (const double(*)[3][3])x, n, w->precision, w->curvature);

	if (status == TS_RANGE)
		return ts_fail(&sim->error, status, ts_instance_word(self, w->file),
			       "mesh %s: %zu triangles are too many", self->id, n);
	return status == TS_OK ? status : ts_nomem(&sim->error);
}

/* Without what is given twice. */
static enum ts_status build_clean(struct ts_instance *self, struct tsim *sim,
				  const struct ts_mesh_words *w, double (*x)[3][3], size_t n,
				  struct ts_mesh *m)
{
	unsigned char *twice = ts_alloc(n, 1);
	size_t found = 0, kept = 0;
	enum ts_status status = twice ? build(self, sim, w, x, n, m) : ts_nomem(&sim->error);

	if (status == TS_OK && find_duplicates(m, twice, &found) != TS_OK)
		status = ts_nomem(&sim->error);
	if (status == TS_OK && found && !w->heal)
		status = refuse_duplicates(self, sim, m, twice, found);
	if (status == TS_OK && found) {
		ts_log(&sim->log, "mesh %s: %zu triangles were given twice and are dropped\n", self->id,
		       found);
		for (size_t t = 0; t < n; t++) {
			for (int k = 0; k < 9 && !twice[t]; k++)
				x[kept][k / 3][k % 3] = x[t][k / 3][k % 3];
			kept += !twice[t];
		}
		ts_mesh_release(m);
		status = build(self, sim, w, x, kept, m);
	}
	ts_free(twice);
	return status;
}

static enum ts_status build_from(struct ts_instance *self, struct tsim *sim,
				 const struct ts_mesh_words *w, const struct ts_triangles *soup,
				 struct ts_mesh *m)
{
	double(*x)[3][3] = ts_alloc(soup->n, sizeof *x);
	enum ts_status status;

	if (!x)
		return ts_nomem(&sim->error);
	for (size_t t = 0; t < soup->n; t++)
		for (int k = 0; k < 9; k++)
			x[t][k / 3][k % 3] = soup->t[t].v[k / 3][k % 3];
	status = build_clean(self, sim, w, x, soup->n, m);
	ts_free(x);
	return status == TS_OK ? check_angles(self, sim, w, m) : status;
}

struct conveyor {
	double velocity[3], origin[3], axis[3], omega;
};
static const struct ts_arg linear_rows[] = {
	TS_VEC3("velocity", struct conveyor, velocity, .flags = TS_POSITIONAL, .help = "vx vy vz"),
	TS_ARGS_END,
};
static const struct ts_arg angular_rows[] = {
	TS_VEC3("origin", struct conveyor, origin, .help = "a point of the axis"),
	TS_VEC3("axis", struct conveyor, axis, .help = "direction of the axis"),
	TS_REAL("omega", struct conveyor, omega, .help = "radian/time"),
	TS_ARGS_END,
};

/* A velocity v becomes its part in the plane of the triangle, made as long as v. */
static void lay_down(const double normal[3], double v[3])
{
	double speed = ts_norm(v), length;

	ts_axpy(-ts_dot(v, normal), normal, v);
	length = ts_norm(v);
	ts_scale(length > 0 ? speed / length : 0, v, v);
}

static void corner_velocity(const struct conveyor *c, const struct ts_mesh *m, size_t t, int k,
			    double v[3])
{
	double arm[3];

	ts_sub(m->x[t][k], c->origin, arm);
	ts_cross(c->axis, arm, v);
	for (int d = 0; d < 3; d++)
		v[d] = c->omega * v[d] + c->velocity[d];
	lay_down(m->normal[t], v);
}

/* A surface that moves in itself. */
static enum ts_status convey(struct ts_instance *self, struct tsim *sim,
			     const struct ts_mesh_words *w, struct ts_mesh_surface *s)
{
	struct conveyor c = { 0 };
	double length;

	if (!w->surface_vel.n && !w->surface_ang_vel.n)
		return TS_OK;
	if (w->surface_vel.n && w->surface_ang_vel.n)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "surface_ang_vel"),
			       "fix %s: one of surface_vel and surface_ang_vel", self->style->name);
	if (w->surface_vel.n)
		TS_TRY(ts_args_parse(sim, "surface_vel", linear_rows, w->surface_vel, &self->where,
				     &self->arena, &c));
	else
		TS_TRY(ts_args_parse(sim, "surface_ang_vel", angular_rows, w->surface_ang_vel,
				     &self->where, &self->arena, &c));
	length = ts_norm(c.axis);
	ts_scale(length > 0 ? 1 / length : 0, c.axis, c.axis);
	s->v = ts_alloc(s->mesh.n, sizeof *s->v);
	if (!s->v)
		return ts_nomem(&sim->error);
	for (size_t t = 0; t < s->mesh.n; t++)
		for (int k = 0; k < 3; k++)
			corner_velocity(&c, &s->mesh, t, k, s->v[t][k]);
	return TS_OK;
}

static enum ts_status load(struct ts_instance *self, struct tsim *sim,
			   const struct ts_mesh_words *words, struct ts_mesh_surface *surface)
{
	struct ts_triangles soup = { 0 };
	enum ts_status status = ts_mesh_read(&soup, &sim->error, sim->pool,
					     ts_instance_word(self, words->file), words->file);

	if (status == TS_OK)
		status = ts_mesh_soup_choose(self, sim, words, &soup);
	if (status == TS_OK && !soup.n)
		status = ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, words->file),
				 "mesh %s: there is no triangle in %s", self->id, words->file);
	if (status == TS_OK)
		status = ts_mesh_soup_transform(self, sim, &soup);
	if (status == TS_OK)
		status = build_from(self, sim, words, &soup, &surface->mesh);
	ts_triangles_release(&soup);
	if (status == TS_OK)
		status = convey(self, sim, words, surface);
	if (status == TS_OK)
		return TS_OK;
	ts_mesh_surface_release(surface);
	return status;
}

enum ts_status ts_mesh_surface_init(struct ts_instance *self, struct tsim *sim,
				    const struct ts_mesh_words *words)
{
	struct ts_mesh_surface *surface = self->state;

	if (!surface->mesh.n)
		TS_TRY(load(self, sim, words, surface));
	ts_mesh_motions_settle(self, sim);
	return ts_mesh_surface_check_box(self, sim, surface);
}
