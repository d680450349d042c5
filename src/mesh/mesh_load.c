#include "mesh/mesh_load.h"

#include <math.h>
#include <stdio.h>

#include "base/hash.h"
#include "box/domain.h"
#include "math/vec3.h"
#include "mesh/mesh_admit.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_read.h"
#include "mesh/mesh_soup.h"
#include "mesh/mesh_style.h"

#include "base/banned.h"

const char *const ts_mesh_heal_names[] = { "no", "auto_remove_duplicates", NULL };

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

/* Projects the velocity v onto the plane of the triangle and restores its magnitude. */
static void turn_into_plane(const double normal[3], double v[3])
{
	double speed = ts_norm(v), length;

	ts_axpy(-ts_dot(v, normal), normal, v);
	length = ts_norm(v);
	ts_scale(length > 0 ? speed / length : 0, v, v);
}

static void corner_velocity(const struct conveyor *c, const struct ts_mesh *m, size_t t, int k, double v[3])
{
	double arm[3];

	ts_sub(m->x[t][k], c->origin, arm);
	ts_cross(c->axis, arm, v);
	for (int d = 0; d < 3; d++)
		v[d] = c->omega * v[d] + c->velocity[d];
	turn_into_plane(m->normal[t], v);
}

static bool is_still(const struct ts_mesh_surface *s)
{
	const double *v = s->v[0][0];
	double most = 0;

	for (size_t k = 0; k < 9 * s->mesh.n; k++)
		most = fmax(most, fabs(v[k]));
	return !(most > 0);
}

/* surface_vel, surface_ang_vel: the surface moves in its own plane like a conveyor belt, the mesh stays in
 * place. */
static enum ts_status set_surface_velocity(struct ts_instance *self, struct tsim *sim,
					   const struct ts_mesh_words *w, struct ts_mesh_surface *s)
{
	const char *word = w->surface_vel.n ? "surface_vel" : "surface_ang_vel";
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
		TS_TRY(ts_args_parse(sim, "surface_ang_vel", angular_rows, w->surface_ang_vel, &self->where,
				     &self->arena, &c));
	length = ts_norm(c.axis);
	ts_scale(length > 0 ? 1 / length : 0, c.axis, c.axis);
	s->v = ts_alloc(s->mesh.n, sizeof *s->v);
	if (!s->v)
		return ts_nomem(&sim->error);
	for (size_t t = 0; t < s->mesh.n; t++)
		for (int k = 0; k < 3; k++)
			corner_velocity(&c, &s->mesh, t, k, s->v[t][k]);
	s->belt = true;
	if (is_still(s) && (ts_norm(c.velocity) > 0 || fabs(c.omega) > 0))
		ts_warn(&sim->log, ts_instance_word(self, word),
			"fix %s: %s is along the normals of all triangles of mesh %s: its surface does not "
			"move",
			self->style->name, word, self->id);
	return TS_OK;
}

/* File for the list of refused triangles, `element_exclusion_list write FILE`; NULL: none. */
static const char *exclusion_output(const struct ts_mesh_words *w)
{
	bool writes = w->exclusion.n == 2 && ts_streq(w->exclusion.word[0].text, "write");

	return writes ? w->exclusion.word[1].text : NULL;
}

/* The word of the line that names the source of the triangles: a file, another mesh, or `primitive`. */
static struct ts_word triangle_source(const struct ts_instance *self, const struct ts_mesh_words *w)
{
	const char *text = w->file ? w->file : w->other ? w->other : "primitive";

	return (struct ts_word){ .text = text, .place = *ts_instance_word(self, text) };
}

static enum ts_status make_primitive(struct ts_instance *self, struct tsim *sim,
				     const struct ts_mesh_words *w, struct ts_triangles *soup)
{
	struct ts_shape_report report = { 0 };
	char what[80];

	snprintf(what, sizeof what, "fix %s", self->style->name);
	if (w->exclusion.n)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "element_exclusion_list"),
			       "%s: element_exclusion_list lists lines of a file, but a primitive has none",
			       what);
	soup->file = "primitive";
	return ts_shape_read(sim, what, w->primitive, &self->arena, soup, &report);
}

static enum ts_status read_soup(struct ts_instance *self, struct tsim *sim, const struct ts_mesh_words *w,
				struct ts_triangles *soup)
{
	struct ts_word source;
	int sources = !!w->file + !!w->other + !!w->primitive.n;

	if (sources != 1)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: expected one of `file NAME`, `primitive SHAPE ...` and `fix ID`, "
			       "found %s",
			       self->style->name,
			       sources == 2 ? "both"
			       : sources    ? "all"
					    : "none");
	source = triangle_source(self, w);
	if (w->file)
		TS_TRY(ts_mesh_read(soup, &sim->files, &sim->error, sim->pool, &source.place, w->file));
	else if (w->primitive.n)
		TS_TRY(make_primitive(self, sim, w, soup));
	else
		TS_TRY(ts_mesh_soup_extrude(self, sim, &source, soup));
	TS_TRY(ts_mesh_soup_choose(self, sim, w, soup));
	if (!soup->n)
		return ts_fail(&sim->error, TS_RANGE, &source.place, "mesh %s: there is no triangle in %s",
			       self->id, source.text);
	return ts_mesh_soup_transform(self, sim, soup);
}

/* Only planar meshes can be extruded. */
static enum ts_status check_extrusion(struct ts_instance *self, struct tsim *sim,
				      const struct ts_mesh_surface *surface)
{
	size_t bend;

	if (isnan(surface->extrusion) || ts_mesh_planar(&surface->mesh, &bend))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "extrude_planar"),
		       "mesh %s is not planar, see its triangle %zu: only planar meshes are extruded",
		       self->id, bend / 3 + 1);
}

static uint64_t hash_corners(const struct ts_mesh *m)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_add(&hash, m->x, m->n * sizeof *m->x);
	return ts_hash_value(&hash);
}

static enum ts_status load_mesh(struct ts_instance *self, struct tsim *sim, const struct ts_mesh_words *w,
				struct ts_mesh_surface *surface)
{
	struct ts_mesh_admission how = {
		.curvature = w->curvature,
		.curvature_tolerant = w->curvature_tolerant,
		.heal = w->heal,
		.verbose = w->verbose,
		.exclude = exclusion_output(w),
	};
	struct ts_triangles soup = { 0 };
	struct ts_word source;
	enum ts_status status = read_soup(self, sim, w, &soup);

	if (status == TS_OK) {
		source = triangle_source(self, w);
		/* LIGGGHTS: 1e-8 in units of length, too much for a mesh of micrometres in m */
		how.precision = isnan(w->precision) ? ts_triangles_precision(&soup) : w->precision;
		if (sim->requests.stop)
			status = ts_fail(&sim->error, TS_STOPPED, &source.place,
					 "stopped on request before the mesh was built");
	}
	if (status == TS_OK) {
		status = ts_mesh_admit(sim, &source.place, &how, &soup, &surface->mesh);
	}
	ts_triangles_release(&soup);
	if (status == TS_OK)
		status = check_extrusion(self, sim, surface);
	if (status == TS_OK && ts_mesh_link_images(&surface->mesh, &sim->domain->box, how.precision) != TS_OK)
		status = ts_nomem(&sim->error);
	if (status == TS_OK)
		status = set_surface_velocity(self, sim, w, surface);
	if (status == TS_OK)
		surface->given = hash_corners(&surface->mesh);
	else
		ts_mesh_surface_release(surface);
	return status;
}

enum ts_status ts_mesh_surface_init(struct ts_instance *self, struct tsim *sim,
				    const struct ts_mesh_words *words)
{
	struct ts_mesh_surface *surface = self->state;

	if (!surface->mesh.n)
		TS_TRY(load_mesh(self, sim, words, surface));
	surface->mesh.legacy = sim->legacy == TS_LEGACY_LIGGGHTS;
	ts_mesh_motions_remove_ended(self, sim);
	return ts_mesh_surface_check_box(self, sim, surface);
}
