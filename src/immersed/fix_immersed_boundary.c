/* Fix immersed/boundary: solids in a fluid that is solved for, by direct forcing. */

#include <stdio.h>
#include <string.h>

#include "core/ranks.h"
#include "core/report.h"
#include "flow/flow.h"
#include "flow/flow_arguments.h"
#include "flow/fluid_slabs.h"
#include "force/restraint.h"
#include "group/group_members.h"
#include "immersed/closed_regions.h"
#include "immersed/immersed.h"
#include "immersed/immersed_spheres.h"
#include "math/vec3.h"
#include "mesh/mesh_surface.h"
#include "particle/particles.h"
#include "region/region.h"
#include "rigid/rigid.h"

#include "base/banned.h"

enum { REGION, MESH, SURFACE, SPHERES };

struct state {
	struct ts_flow_part part; /* first */
	int body;
	struct ts_instance *region;
	const char *mesh, *voxels;
	struct ts_words velocity_words, omega_words;
	struct ts_number velocity[3], omega[3];
	double centre[3], relax, virtual_mass; /* centre NaN: not given */
	int64_t iterations;
	double least_cells;

	struct ts_solid *solid;
	struct ts_solid_prescribed prescribed;
	struct ts_solid_pose stand; /* saved */
	struct ts_immersed immersed;
	bool placed, warned;
	bool stepped; /* its points have been found in a step of this run */
	/* time of the last search for points; cells moved since the last search for closed regions */
	double seen_at, drift;
	size_t seen_inside; /* number of points inside at that search */
	const struct ts_fluid *fluid;
	bool begun;			       /* a step of the fluid is in progress */
	struct ts_immersed_record own;	       /* saved: of a region or a mesh */
	const struct ts_mesh_surface *surface; /* of a mesh */
	const struct ts_voxel_surface *field;  /* a height field */
	/* saved: position of the torque's reference point relative to the mean of the corners */
	double lever[3];
	struct ts_immersed_spheres spheres;
	struct ts_restraints restraints; /* of spheres */
	bool free_mesh;			 /* a mesh that the fluid moves */
	double slip;			 /* saved */
};

/* NULL: the sphere is on another rank. */
static struct ts_immersed_record *record_of_part(struct state *s, const struct tsim *sim, size_t part)
{
	int32_t row;

	if (s->body != SPHERES)
		return &s->own;
	row = ts_solid_sphere_row(s->solid, part);
	return row < 0 ? NULL : ts_immersed_sphere_record(&s->spheres, sim, (size_t)row);
}

static enum ts_status apply_forcing(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				    double time, double dt);
static enum ts_status end_substep(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				  double dt);
static double limit(const struct ts_instance *self, const struct ts_fluid *fluid);
static enum ts_status update_forces(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				    double length);
static void add_mesh_load(const struct ts_instance *self, const struct ts_mesh_surface *mesh,
			  double out[2][3], double *virtual_density);
static bool explain_instability(const struct ts_instance *self, const struct ts_fluid *fluid, double dt,
				char *cause, size_t size);
static void mark_closed_faces(const struct ts_instance *self, struct ts_closed_search *search);
static void rehearse_force(const struct ts_instance *self, const struct ts_fluid *fluid);
static enum ts_status rehearse_step(const struct ts_instance *self, const struct ts_fluid *fluid);

/* ---- before a run */

static enum ts_status read_motion(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->prescribed.velocity = s->velocity_words.n > 0;
	s->prescribed.omega = s->omega_words.n > 0;
	s->prescribed.centre = !isnan(s->centre[0]);
	if (s->prescribed.velocity)
		TS_TRY(ts_flow_read_vector(sim, "fix immersed/boundary: velocity", s->velocity_words,
					   &self->where, &self->arena, s->velocity));
	if (s->prescribed.omega)
		TS_TRY(ts_flow_read_vector(sim, "fix immersed/boundary: omega", s->omega_words, &self->where,
					   &self->arena, s->omega));
	return TS_OK;
}

static enum ts_status make_region(struct ts_instance *self, struct tsim *sim, int dimensions)
{
	static const double somewhere[3] = { 0 };
	struct state *s = self->state;

	if (isnan(ts_region_depth(s->region, somewhere)))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->region->id),
			       "fix immersed/boundary: the distance from the surface is not available for a "
			       "region of style %s; use block, cone, cylinder, plane, prism, sphere, wedge, "
			       "or a union or intersect of these, or a mesh",
			       s->region->style->name);
	s->solid = ts_solid_of_region(s->region, dimensions, &s->prescribed, &s->stand);
	return s->solid ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status make_mesh(struct ts_instance *self, struct tsim *sim, int dimensions)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->mesh, .place = *ts_instance_word(self, s->mesh) };
	struct ts_mesh_surface *surface;
	bool inwards;

	TS_TRY(ts_mesh_surface_require(sim, &id, &surface));
	TS_TRY(ts_solid_check_mesh(sim, &id, &surface->mesh, &inwards));
	s->surface = surface;
	s->solid = ts_solid_of_mesh(surface, inwards, dimensions, &s->prescribed);
	return s->solid ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status make_columns(struct ts_instance *self, struct tsim *sim, int dimensions)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->voxels, .place = *ts_instance_word(self, s->voxels) };
	struct ts_voxel_surface *surface;

	TS_TRY(ts_voxel_surface_require(sim, &id, &surface));
	s->field = surface;
	s->solid = ts_solid_of_voxels(surface, &s->fluid->grid, dimensions, &s->prescribed);
	return s->solid ? TS_OK : ts_nomem(&sim->error);
}

/* Each of two fixes would add the force of the fluid on a particle. */
static enum ts_status refuse_same_spheres(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instance *other;

	for (size_t k = 0; (other = ts_flow_part_named(sim, "immersed/boundary", &k));)
		if (!ts_streq(other->id, self->id) && ((const struct state *)other->state)->body == SPHERES &&
		    ts_ranks_most(sim, ts_groups_meet(sim->particles, other->group, self->group)) > 0)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix immersed/boundary: fix %s (%s:%d) has particles of this group "
				       "already: the fluid would act on them twice",
				       other->id, TS_FILE_AND_LINE(other->where));
	return TS_OK;
}

static enum ts_status make_spheres(struct ts_instance *self, struct tsim *sim, int dimensions)
{
	struct state *s = self->state;

	TS_TRY(refuse_same_spheres(self, sim));
	TS_TRY(ts_immersed_spheres_prepare(&s->spheres, sim, self));
	TS_TRY(ts_restraints_find(&s->restraints, sim, self, false));
	s->solid = ts_solid_of_spheres(self->group, dimensions);
	return s->solid ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status find_distances(struct ts_instance *self, struct tsim *sim, size_t n,
				     const double (*x)[3], double reach, double *distance)
{
	struct state *s = self->state;

	if (s->placed && s->body == SPHERES) /* their rows may have changed since the step */
		TS_TRY(s->solid->kind->update(s->solid, sim));
	return s->placed ? ts_immersed_distances(s->solid, &s->fluid->grid, n, x, reach, distance) : TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	static enum ts_status (*const make[])(struct ts_instance *, struct tsim *, int) = {
		[REGION] = make_region, [MESH] = make_mesh, [SURFACE] = make_columns, [SPHERES] = make_spheres
	};
	struct state *s = self->state;
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fluid(sim, "fix immersed/boundary", &self->where, &fluid));
	s->part = (struct ts_flow_part){ .force = apply_forcing,
					 .after_substep = end_substep,
					 .limit = limit,
					 .after_step = update_forces,
					 .mesh_load = add_mesh_load,
					 .mark_closed = mark_closed_faces,
					 .distance = find_distances,
					 .planes_beside = ts_immersed_planes_beside(&fluid->grid),
					 .rehearse_force = rehearse_force,
					 .rehearse_step = rehearse_step,
					 .shared = s->body == SPHERES ? TS_SOLID_SPHERE_BYTES : 0,
					 .explain_instability = explain_instability };
	TS_TRY(read_motion(self, sim));
	ts_solid_free(s->solid);
	s->solid = NULL;
	s->placed = s->begun = s->stepped = s->free_mesh = false;
	s->fluid = fluid;
	return make[s->body](self, sim, sim->dimension);
}

static enum ts_status evaluate_prescribed_motion(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_solid_motion *m = &s->prescribed.motion;

	for (int k = 0; k < 3; k++) {
		if (s->prescribed.velocity)
			TS_TRY(ts_number_now(sim, &s->velocity[k], &self->where, &m->velocity[k]));
		if (s->prescribed.omega)
			TS_TRY(ts_number_now(sim, &s->omega[k], &self->where, &m->omega[k]));
		m->centre[k] = s->centre[k];
	}
	return TS_OK;
}

static enum ts_status update_points(struct ts_instance *self, struct tsim *sim, const struct ts_fluid *fluid)
{
	struct state *s = self->state;
	struct ts_solid_motion before = { .centre = { 0 } };
	enum ts_status status;

	if (s->placed && s->solid->parts)
		before = *s->solid->motion;
	TS_TRY(evaluate_prescribed_motion(self, sim));
	TS_TRY(s->solid->kind->update(s->solid, sim));
	if (s->placed && !s->solid->moved && memcmp(&before, s->solid->motion, sizeof before) == 0 &&
	    ts_immersed_has_planes(&s->immersed, fluid))
		return TS_OK;
	if (s->field)
		TS_TRY(ts_immersed_check_voxels(sim, &self->where, s->voxels, s->field, &fluid->grid));
	TS_TRY(ts_immersed_check_size(sim, &self->where, s->solid, &fluid->grid, s->body == SPHERES,
				      s->least_cells));
	status = ts_immersed_find_points(&s->immersed, s->solid, fluid);
	s->placed = true;
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}

/* Warns of gaps. Spheres may touch, and columns are checked by their widths. */
static enum ts_status warn_gap(struct ts_instance *self, struct tsim *sim, const struct ts_instance *part)
{
	struct state *s = self->state, *other = part->state;

	if (s->body == SPHERES || other->body == SPHERES || (part == self && s->field))
		return TS_OK;
	return ts_immersed_warn_gap(sim, &self->where, &s->immersed, other->solid, s->fluid,
				    part == self ? NULL : part->id);
}

static enum ts_status warn_others(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state, *other;
	struct ts_instance *part;

	for (size_t k = 0;
	     (part = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_FLOW_PART, &k)) && part != self;) {
		other = part->state;
		if (part->style == self->style && other->placed) {
			TS_TRY(warn_gap(self, sim, part));
			TS_TRY(ts_immersed_warn_overlap(sim, &self->where, &other->immersed, &s->immersed,
							s->fluid, part->id));
		}
	}
	return TS_OK;
}

/* Whether the velocity of the body is not known yet: that of a moving region or mesh follows from a step. */
static bool velocity_unknown(const struct state *s)
{
	if (s->stepped || s->prescribed.velocity || s->prescribed.omega)
		return false;
	return s->body == REGION ? ((const struct ts_region *)s->region->state)->moves
				 : s->surface && s->surface->v;
}

/* Refuses a body without fluid around it, and warns once of what makes results wrong. */
static enum ts_status check_room(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->warned || s->solid->parts == 0)
		return TS_OK;
	s->warned = true;
	if (s->immersed.inside > 0 && s->immersed.beside == 0)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix immersed/boundary: the body fills the whole grid: no fluid is left");
	ts_immersed_warn_thin(sim, &self->where, &s->immersed);
	if (s->field)
		ts_immersed_warn_columns(sim, &self->where, s->voxels, &s->field->field, &s->fluid->grid);
	ts_immersed_warn_walls(sim, &self->where, &s->immersed, s->fluid);
	TS_TRY(warn_gap(self, sim, self));
	return warn_others(self, sim);
}

static void mark_closed_faces(const struct ts_instance *self, struct ts_closed_search *search)
{
	const struct state *s = self->state;

	if (s->placed)
		ts_closed_search_add_body(search, self, &s->immersed, s->solid,
					  s->body == SPHERES	? TS_BODY_FREE
					  : velocity_unknown(s) ? TS_BODY_UNKNOWN
								: TS_BODY_DRIVEN);
}

/* Checks for closed regions of fluid with a net inflow. */
static enum ts_status check_closed(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->drift = 0;
	s->seen_inside = s->immersed.inside;
	return ts_immersed_check_closed(sim);
}

/* The same if the body has moved or grown so much that it may have closed a region. */
static enum ts_status check_closed_if_moved(struct ts_instance *self, struct tsim *sim, double time)
{
	static const double FAR = 0.5, GROWN = 0.02;
	struct state *s = self->state;
	double grown = fabs((double)s->immersed.inside - (double)s->seen_inside);

	s->drift += s->immersed.rate * fmax(0, time - s->seen_at);
	s->seen_at = time;
	if (!s->stepped) /* first step of the fluid in this run */
		s->drift = 2 * FAR;
	s->stepped = true;
	return s->drift > FAR || grown > GROWN * (double)s->seen_inside ? check_closed(self, sim) : TS_OK;
}

/* Sets velocity and spin of the fluid inside before the first step, of which the force needs the change. */
static enum ts_status initialize_inner_fluid(struct ts_instance *self, struct tsim *sim,
					     const struct ts_fluid *fluid)
{
	struct state *s = self->state;
	double unknown = 0;

	for (size_t k = 0; k < s->solid->parts; k++) {
		const struct ts_immersed_record *r = record_of_part(s, sim, k);

		if (r && r->known == 0)
			unknown = 1;
	}
	if (ts_fluid_divided(fluid) && s->body == SPHERES) /* each rank has the records of its own */
		unknown = ts_fluid_slabs_most(fluid, unknown);
	if (unknown == 0)
		return TS_OK;
	if (ts_immersed_sum_parts(&s->immersed, fluid, s->solid->parts) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->solid->parts; k++) {
		struct ts_immersed_record *r = record_of_part(s, sim, k);

		if (!r || r->known != 0)
			continue;
		memcpy(r->velocity, s->immersed.sums[k].velocity, sizeof r->velocity);
		memcpy(r->spin, s->immersed.sums[k].spin, sizeof r->spin);
		r->known = TS_IMMERSED_INSIDE;
	}
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	struct state *s = self->state;
	struct ts_fluid *fluid;

	if (report->limits_only)
		return TS_OK;
	TS_TRY(ts_flow_require_fluid(sim, "fix immersed/boundary", &self->where, &fluid));
	TS_TRY(update_points(self, sim, fluid));
	s->seen_at = fluid->time;
	TS_TRY(initialize_inner_fluid(self, sim, fluid));
	TS_TRY(check_room(self, sim));
	TS_TRY(check_closed(self, sim));
	ts_report_line(report, "immersed body", "%s: %zu points of velocities inside, %zu beside the surface",
		       self->id, s->immersed.inside, s->immersed.beside);
	return TS_OK;
}

/* ---- in a step of the fluid */

static enum ts_status apply_forcing(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				    double time, double dt)
{
	struct state *s = self->state;

	if (!s->begun) {
		TS_TRY(update_points(self, sim, fluid));
		TS_TRY(check_closed_if_moved(self, sim, time));
		TS_TRY(initialize_inner_fluid(self, sim, fluid)); /* of particles inserted in this run */
		ts_immersed_begin_step(&s->immersed);
	}
	s->begun = true;
	ts_immersed_force(&s->immersed, fluid, dt, (int)s->iterations);
	s->part.keeps_ghosts = !s->immersed.beside_boundary;
	return TS_OK;
}

static enum ts_status end_substep(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				  double dt)
{
	struct state *s = self->state;

	(void)sim, (void)fluid, (void)dt;
	ts_immersed_end_substep(&s->immersed);
	return TS_OK;
}

static void mean_of_corners(const struct ts_mesh *mesh, double mean[3])
{
	mean[0] = mean[1] = mean[2] = 0;
	for (size_t c = 0; c < 3 * mesh->n; c++)
		ts_axpy(1 / (3 * (double)mesh->n), mesh->x[c / 3][c % 3], mean);
}

static enum ts_status update_forces(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				    double length)
{
	struct state *s = self->state;
	double share = s->body == REGION || s->body == SURFACE ? 1 : s->relax;
	/* masses of discs are per unit of depth */
	const bool discs = s->body == SPHERES && sim->dimension == 2;
	double depth = discs ? fluid->grid.width[2][0] : 1;

	if (ts_immersed_sum_parts(&s->immersed, fluid, s->solid->parts) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < s->solid->parts; k++) {
		struct ts_immersed_record *r = record_of_part(s, sim, k);

		if (!r)
			continue;
		ts_immersed_record_update(r, &s->immersed.sums[k], fluid, share, length, depth);
		if (discs) /* cell centres may be beside the plane of the discs */
			r->torque[0] = r->torque[1] = 0;
	}
	for (size_t k = 0; s->body == SPHERES && k < s->solid->parts; k++)
		if (record_of_part(s, sim, k))
			ts_net_force_average(
				ts_immersed_sphere_net_force(&s->spheres, sim,
							     (size_t)ts_solid_sphere_row(s->solid, k)));
	if (s->body == MESH) {
		mean_of_corners(&s->surface->mesh, s->lever);
		ts_sub(s->solid->motion->centre, s->lever, s->lever);
	}
	s->slip = s->immersed.slip;
	s->begun = false;
	return TS_OK;
}

/* The mesh has moved since the step of the fluid; the reference point of the torque moves with the mean of
 * its corners, which is near the body (the anchor may be far away), so that the rotation since then has
 * little effect. */
static void add_mesh_load(const struct ts_instance *self, const struct ts_mesh_surface *mesh,
			  double out[2][3], double *virtual_density)
{
	struct state *s = self->state;
	double arm[3], torque[3];

	if (s->body != MESH || s->surface != mesh)
		return;
	s->free_mesh = true;
	*virtual_density = fmax(*virtual_density, s->virtual_mass * s->fluid->density);
	mean_of_corners(&mesh->mesh, arm);
	ts_add(arm, s->lever, arm);
	ts_sub(arm, mesh->anchor, arm);
	ts_cross(arm, s->own.force, torque);
	ts_add(torque, s->own.torque, torque);
	ts_add(out[0], s->own.force, out[0]);
	ts_add(out[1], torque, out[1]);
}

/* No part of a solid may skip a layer of cells in one step. */
static double limit(const struct ts_instance *self, const struct ts_fluid *fluid)
{
	const struct state *s = self->state;

	(void)fluid;
	return s->immersed.rate > 0 ? 1 / s->immersed.rate : INFINITY;
}

/* The added-mass instability of a light body grows until the speed exceeds the limit of the step. */
static bool explain_instability(const struct ts_instance *self, const struct ts_fluid *fluid, double dt,
				char *cause, size_t size)
{
	static const double FAST = 0.25; /* cells per step, by the Courant number of the fluid */
	const struct state *s = self->state;

	if (!(s->body == SPHERES || s->free_mesh) || s->immersed.rate * dt < FAST * fluid->courant)
		return false;
	snprintf(cause, size,
		 "the bodies of fix immersed/boundary %s have come to %.3g cells a step, and where they are "
		 "light the force of the fluid and their motion may have excited each other; use `relax` "
		 "below its %g there, a larger `virtual_mass` than %g, or a smaller `timestep`",
		 self->id, s->immersed.rate * dt, s->relax, s->virtual_mass);
	return true;
}

/* ---- what ranks send for it */

static void rehearse_force(const struct ts_instance *self, const struct ts_fluid *fluid)
{
	const struct state *s = self->state;

	ts_immersed_rehearse_force(&s->immersed, fluid, (int)s->iterations);
}

/* Spheres: that all agree whether there is a new one. */
static enum ts_status rehearse_step(const struct ts_instance *self, const struct ts_fluid *fluid)
{
	struct state *s = self->state;

	if (!ts_fluid_divided(fluid))
		return TS_OK;
	if (s->body == SPHERES)
		ts_fluid_slabs_most(fluid, 0);
	return ts_immersed_rehearse_sums(&s->immersed, fluid);
}

/* ---- forces on particles */

static void stabilize_particle(struct state *s, const struct tsim *sim, size_t i)
{
	struct ts_particles *p = sim->particles;
	struct ts_net_force *net = ts_immersed_sphere_net_force(&s->spheres, sim, i);
	double share =
		ts_virtual_mass_ratio(ts_virtual_mass_density(sim, i), s->virtual_mass, s->fluid->density);
	double change[3] = { -p->f[i][0], -p->f[i][1], -p->f[i][2] };

	ts_net_force_stabilize(net, share, p->f[i], p->torque[i]);
	ts_add(change, p->f[i], change);
	ts_sub(p->f[i], change, p->f[i]);
	ts_restraints_apply(&s->restraints, sim, i, change);
	ts_add(p->f[i], change, p->f[i]);
	ts_net_force_record(net, sim->run.in_setup, p->f[i], p->torque[i]);
}

/* Called when all forces on particles are known. */
static enum ts_status stabilize_particles(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_rigid_list(sim));
	TS_TRY(ts_restraints_prepare(&s->restraints, sim));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group) && p->imass[i] != 0)
			stabilize_particle(s, sim, i);
	return TS_OK;
}

static bool stabilizes_particles(const struct ts_instance *self)
{
	const struct state *s = self->state;

	return s->body == SPHERES && s->virtual_mass > 0;
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->body == SPHERES)
		ts_immersed_spheres_add_forces(&s->spheres, sim);
	return TS_OK;
}

/* ---- outputs */

/* Force and torque on all parts. */
static enum ts_status eval_total(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;

	if (s->body == SPHERES) {
		ts_immersed_spheres_total(&s->spheres, sim, out->data);
	} else {
		for (int k = 0; k < 3; k++) {
			out->data[k] = s->own.force[k] + 0; /* 0 has no sign */
			out->data[3 + k] = s->own.torque[k] + 0;
		}
	}
	out->data[6] = s->slip;
	return TS_OK;
}

static enum ts_status eval_parts(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	const size_t n = sim->particles->n;

	TS_TRY(ts_table_resize(out, n, 6));
	memset(out->data, 0, n * 6 * sizeof *out->data);
	if (s->body == SPHERES)
		ts_immersed_spheres_forces(&s->spheres, sim, out->data);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	if (s->body != SPHERES)
		return TS_OK;
	return ts_immersed_spheres_archive(&s->spheres, sim, a);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_solid_free(s->solid);
	ts_immersed_release(&s->immersed);
	ts_restraints_release(&s->restraints);
}

/* ---- tables */

#define GIVEN_ROWS                                                                                           \
	TS_SOME_KEYWORD("velocity", struct state, velocity_words, 0,                                         \
			.help = "Vx Vy Vz, numbers or v_name: velocity of the centre, instead of "           \
				"what the motion of the region, mesh or field says"),                        \
		TS_SOME_KEYWORD("omega", struct state, omega_words, 0,                                       \
				.help = "Wx Wy Wz, numbers or v_name: angular velocity about the "           \
					"centre, in radian per time"),                                       \
		TS_VEC3("centre", struct state, centre, .flags = TS_OPTIONAL, .unit = "length",              \
			.help = "reference point of the rotation and of the torque; default: the centre of " \
				"the bounding box of the region (which ends with the box where it has no "   \
				"end) or field, "                                                            \
				"the mean of the mesh's corners")
#define ITERATIONS                                                                                          \
	TS_INT("iterations", struct state, iterations, .fallback = "3", .range = TS_WITHIN, .lo = 1,        \
	       .hi = 100,                                                                                   \
	       .help = "number of iterations for the velocities next to the surface, which depend on each " \
		       "other")
#define MIN_CELLS                                                                                  \
	TS_REAL("min_cells", struct state, least_cells, .fallback = "4", .range = TS_NOT_NEGATIVE, \
		.unit = "", .help = "a body with fewer cells across is refused")
#define RELAX                                                                                              \
	TS_REAL("relax", struct state, relax, .fallback = "1", .range = TS_WITHIN, .lo = 1e-3, .hi = 1,    \
		.help = "relaxation factor of the force: weight of the present step against the previous " \
			"one"),                                                                            \
		TS_REAL("virtual_mass", struct state, virtual_mass, .fallback = "1.5",                     \
			.range = TS_NOT_NEGATIVE, .unit = "",                                              \
			.help = "virtual mass of freely moving bodies, divided by the mass of the "        \
				"displaced fluid")
static const struct ts_arg region_args[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL, .help = "the solid"),
	GIVEN_ROWS,
	ITERATIONS,
	MIN_CELLS,
	TS_ARGS_END,
};
static const struct ts_arg mesh_args[] = {
	TS_WORD("mesh", struct state, mesh, .flags = TS_POSITIONAL,
		.help = "ID of the fix mesh/surface or its kin; a closed surface"),
	GIVEN_ROWS,
	RELAX,
	ITERATIONS,
	MIN_CELLS,
	TS_ARGS_END,
};
static const struct ts_arg surface_args[] = {
	TS_WORD("surface", struct state, voxels, .flags = TS_POSITIONAL,
		.help = "ID of the fix surface/voxel; all below its tops"),
	GIVEN_ROWS,
	ITERATIONS,
	MIN_CELLS,
	TS_ARGS_END,
};
static const struct ts_arg sphere_args[] = {
	RELAX,
	ITERATIONS,
	MIN_CELLS,
	TS_ARGS_END,
};
static const struct ts_mode bodies[] = {
	[REGION] = { "region", "a region of the script", region_args },
	[MESH] = { "mesh", "a closed mesh", mesh_args },
	[SURFACE] = { "surface", "a height field", surface_args },
	[SPHERES] = { "spheres", "the particles of the group, moved by the fluid", sphere_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("body", struct state, body, bodies, .help = "the solid"),
	TS_ARGS_END,
};

static const char *const components[] = { "fx", "fy", "fz", "tx", "ty", "tz", "slip", NULL };
static const struct ts_value values[] = {
	{ "force", "force",
	  "[1..3] force and [4..6] torque of the fluid on the body, for spheres their sums; [7] largest "
	  "difference between the velocity of the fluid inside and that of the body",
	  TS_VECTOR, 7, components, eval_total },
	{ "force on each", "force",
	  "force and torque of the fluid on each particle; 0 for particles that are not bodies", TS_PERATOM,
	  6, components, eval_parts },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, own.force),	 TS_SAVE_F64(struct state, own.torque),
	TS_SAVE_F64(struct state, own.velocity), TS_SAVE_F64(struct state, own.spin),
	TS_SAVE_F64(struct state, own.known),	 TS_SAVE_F64(struct state, lever),
	TS_SAVE_F64(struct state, stand.shift),	 TS_SAVE_F64(struct state, stand.turn),
	TS_SAVE_F64(struct state, stand.time),	 TS_SAVE_U8(struct state, stand.seen),
	TS_SAVE_F64(struct state, slip),	 TS_SAVED_ROWS_END,
};

static const char forces_and_limits[] =
	"The force on the body is the opposite of the force that the forcing exerts on the fluid, plus the "
	"rate of change of the momentum of the fluid inside, without its weight,\n\n"
	"    F = -sum rho (u_forced - u) V/dt + d/dt int rho u dV - int rho g dV,\n\n"
	"and 0 before the first step; in two dimensions on the depth of the box, but for spheres. g is the "
	"body_force of flow_style along axes not periodic (buoyancy, 3 % too large with 8 cells across a "
	"sphere, 1 % with 16). With `viscous implicit` velocities next to the body have errors of first "
	"order in the step: keep the step near h^2/nu. Bodies of fewer than `min_cells` cells across, where "
	"they are fewest, are refused: with 4 the error of the drag is 5 to 13 %, with 8 1 to 4 %. A clump "
	"is as thick as its largest sphere. A body nowhere thicker than two cells leaks, with a warning.\n\n"
	"The pressure cannot drive fluid through a body. At the beginning of a run, and when bodies move, "
	"all cells are marked that are connected with an outlet (or an inlet with given pressure) through "
	"faces of cells whose centre is in the fluid. A body is refused, and the position reported, if it "
	"closes off a part of the fluid into which more flows through faces of the grid than out of it, or, "
	"for a region or mesh, if its motion displaces fluid in a closed part that is at least three cells "
	"wide. Closed parts without inflow are allowed. A body may touch walls and outlets; it may touch an "
	"inlet with given velocity only if that is the velocity of the body.";

static const char *const doc_more[] = { forces_and_limits, NULL };

TS_STYLE(fix, ts_style, ts_fix_immersed_boundary)
const struct ts_style ts_fix_immersed_boundary = {
	.name = "immersed/boundary",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "A solid body in a fluid that is solved for, by direct forcing on the grid",
	.doc = "Inside the body the velocity of the fluid is set to that of the body. At points next to its "
	       "surface it is set to the value on the parabola along the normal n through the surface and "
	       "the fluid farther out,\n\n"
	       "    u(x) = v_s + 2 d/(d + l) (u(x + l n) - v_s) - d/(d + 2 l) (u(x + 2 l n) - v_s)\n\n"
	       "with d the distance from the surface, v_s the velocity of the surface and l the grid "
	       "spacing along n: no slip to second order. The grid need not conform to the body, any "
	       "pressure_style can be used, and bodies may move through the grid. Define the fix after "
	       "flow_style; use one fix for each body. If bodies of two fixes are nearer than three cells, "
	       "the order of the fixes divides their forces. Such a gap, or one within a region or a mesh, "
	       "is warned of when a run begins, but for spheres.\n\n"
	       "`region`: the body has the position of the region, including its `move` and `rotate`, and "
	       "the velocity that follows from its positions in two steps of the fluid. `velocity` and "
	       "`omega` give the velocity instead: exactly, if formulas for it are known, or for a surface "
	       "that slides in itself, such as that of a rotating cylinder. A region with `side out` "
	       "encloses the fluid. If not the region as a whole but its members or sizes change, the "
	       "surface has only the velocity given by `velocity` and `omega`. A body that extends through "
	       "the whole box must end at INF, not at EDGE.\n\n"
	       "`mesh`: a closed surface of fix mesh/surface. Position and velocity of the body are those "
	       "of the mesh. Particles interact with the same mesh by fix wall/gran mesh; with fix "
	       "move/mesh/free the body moves freely under the force of the fluid.\n\n"
	       "`surface`: the columns of a fix surface/voxel, below their tops. They move as the field "
	       "does (`move`), with its velocity; heights that wear have no velocity of their own. A field "
	       "that is as long as the grid along an axis that is not periodic must cover it to both ends; "
	       "the ends of the grid are no surface.\n\n"
	       "`spheres`: each particle of the group is a body (in two dimensions a disc, with force and "
	       "torque per unit depth, like its mass) that is large compared with the cells. The force on "
	       "it is added in the next step, so integrators, contacts, fix rigid and fix multisphere work "
	       "as usual. Weight and, without body_force, buoyancy are those of the script.\n\n"
	       "For particles and for meshes of fix move/mesh/free a virtual mass m_v, `virtual_mass` times "
	       "that of the displaced fluid, is added to both sides of the equation of motion,\n\n"
	       "    (m + m_v) a = F + (all other forces) + m_v a',\n\n"
	       "with a' the mean acceleration over the last step of the fluid. It stabilizes bodies that "
	       "are as light as the fluid or lighter, with an error of first order in the step, whatever "
	       "the order in the script. Bodies whose added mass is more than 4.5 times the mass of the "
	       "displaced fluid (light ones in narrow channels) need a larger value, or `relax`.\n\n"
	       "Equations, order, limits: doc/theory-immersed.md.",
	.doc_more = doc_more,
	.example = "region rod cylinder z 0 0 0.5 INF INF units box\n"
		   "fix rod all immersed/boundary region rod\n"
		   "fix spin all immersed/boundary region rod omega 0 0 2.385\n"
		   "fix pad all immersed/boundary surface rough\n"
		   "fix balls heavy immersed/boundary spheres",
	.cite = "E. A. Fadlun, R. Verzicco, P. Orlandi, J. Mohd-Yusof, J. Comput. Phys. 161 (2000) 35; E. "
		"Balaras, Comput. Fluids 33 (2004) 375; M. Uhlmann, J. Comput. Phys. 209 (2005) 448; S. "
		"Schwarz, T. Kempe, J. Froehlich, J. Comput. Phys. 281 (2015) 591",
	.family = TS_FAMILY_FLOW_PART,
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = post_force },
	.late = { [TS_LATE_INERTIA] = stabilize_particles },
	.is_late = stabilizes_particles,
	.plan = plan,
	.fini = fini,
};
