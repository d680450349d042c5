#include "wall/region_wall.h"

#include <math.h>
#include <stdio.h>

#include "math/vec3.h"
#include "neigh/coincide.h"
#include "particle/particles.h"
#include "wall/exact_surface.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

/* ---- definition ---- */

static int given(const void *geometry)
{
	return ((const struct ts_region_wall *)geometry)->region != NULL;
}

static enum ts_status find_region(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w)
{
	const struct ts_place *where = ts_instance_word(self, w->region->id);

	w->faces = ts_region_faces(w->region);
	if (!w->faces)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix wall/gran/region: region %s is of style %s, whose surface is no wall; "
			       "expected block, cone, cylinder, plane, sphere, or a union or intersection of "
			       "them",
			       w->region->id, w->region->style->name);
	w->nmovers = ts_region_movers(w->region, NULL, 0);
	w->point = ts_arena_alloc(&self->arena, (size_t)w->faces, sizeof *w->point);
	w->mover = ts_arena_alloc(&self->arena, (size_t)w->nmovers + 1, sizeof *w->mover);
	w->listed = ts_arena_alloc(&self->arena, (size_t)w->nmovers + 1, sizeof *w->listed);
	if (!w->motion)
		w->motion = ts_arena_alloc(&self->arena, (size_t)w->nmovers + 1, sizeof *w->motion);
	if (!w->point || !w->mover || !w->motion || !w->listed)
		return ts_nomem(&sim->error);
	w->list_all = false;
	ts_region_movers(w->region, w->mover, w->nmovers);
	if (w->nmovers < 2 || w->mover[0] != w->region)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "fix wall/gran/region: region %s moves, and %s, which it is made of, moves in it; "
		       "expected one of both",
		       w->region->id, w->mover[1]->id);
}

static enum ts_status find(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *wall = self->state;

	if (wall->type == INT64_MIN && !wall->given)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran/region: which law? `hertz/history ...`, `granular ...`, or the "
			       "`type` of its material");
	if (wall->type == INT64_MIN) /* LAMMPS' walls have no material */
		wall->type = 1;
	return find_region(self, sim, wall->geometry);
}

/* ---- motion ---- */

/* The velocity is the difference of the variables to the last step, as in LAMMPS; 0 at the first
 * evaluation. */
static void update_motion(const struct ts_instance *mover, struct ts_region_motion *m, const struct tsim *sim)
{
	const struct ts_region *r = mover->state;
	double step = (double)sim->clock.step;

	if (m->known > 0 && m->step == step)
		return;
	for (int k = 0; k < 3; k++) {
		m->velocity[k] = m->known > 0 ? (r->shift[k] - m->shift[k]) / sim->clock.dt : 0;
		m->shift[k] = r->shift[k];
	}
	m->rate = m->known > 0 ? (r->turned - m->angle) / sim->clock.dt : 0;
	m->angle = r->turned;
	m->step = step;
	m->known = 1;
}

/* Velocity of the surface at the contact point of a particle at x: V + omega x arm. */
static void surface_velocity(const struct ts_region_wall *w, const struct ts_instance *mover,
			     const double x[3], struct ts_wall_contact_point *point)
{
	const struct ts_region *r = mover->state;
	const struct ts_region_motion *m = w->motion;
	double arm[3], spin[3], turn[3];

	for (int k = 0; k < w->nmovers && w->mover[k] != mover; k++)
		m++;
	for (int k = 0; k < 3; k++) {
		arm[k] = x[k] - point->distance * point->n[k] - r->pivot[k] - r->shift[k];
		spin[k] = m->rate * r->axis[k];
	}
	ts_cross(spin, arm, turn);
	ts_add(m->velocity, turn, point->velocity);
}

/* ---- stages ---- */

/* Whether the surface of particle i, with its centre at x, is within the range of the contact law plus
 * `further` of the wall. */
static bool is_near(const struct ts_region_wall *w, const struct tsim *sim, const struct ts_wall *wall,
		    size_t i, const double x[3], double further)
{
	double radius = sim->particles->radius[i];

	return !(fabs(ts_region_depth(w->region, x)) >= radius + further + ts_wall_reach(wall, sim, radius));
}

/* The distance by which the centre of particle i is out of the range of the law, with a margin of 0.1 % for rounding;
 * unknown for a law whose range may change, and for a region that changes its shape. */
static double clear_distance(const struct ts_region_wall *w, const struct tsim *sim,
			     const struct ts_wall *wall, size_t i)
{
	double depth = ts_region_depth(w->region, sim->particles->xhold[i]);

	return ts_wall_long_ranged(wall, sim) || ts_region_reshapes(w->region) ? -INFINITY
									       : 0.999 * fabs(depth);
}

/* Stores the present poses of the moving regions, and upper bounds of the distances of particles from their
 * pivots until the next listing. */
static void store_poses(struct ts_region_wall *w, const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	for (int k = 0; k < w->nmovers; k++) {
		const struct ts_region *r = w->mover[k]->state;
		struct ts_region_pose *pose = &w->listed[k];
		double pivot[3], far2 = 0;

		ts_add(r->pivot, r->shift, pivot);
		for (size_t i = 0; i < p->n; i++)
			far2 = fmax(far2, ts_distance2(p->xhold[i], pivot));
		pose->far = sqrt(far2) + sim->neigh->built_skin + w->margin;
		pose->angle = r->turned;
		pose->in_place = ts_region_turns_in_place(w->mover[k]);
		ts_scale(1, r->shift, pose->shift);
	}
	w->listed_step = sim->clock.step;
}

/* Upper bound of the displacement of the surface towards any particle since the listing: |shift| + |angle| *
 * distance from the pivot. */
static double max_approach(const struct ts_region_wall *w)
{
	double sum = 0;

	for (int k = 0; k < w->nmovers; k++) {
		const struct ts_region *r = w->mover[k]->state;
		const struct ts_region_pose *pose = &w->listed[k];

		if (!pose->in_place)
			sum += sqrt(ts_distance2(r->shift, pose->shift)) +
			       fabs(r->turned - pose->angle) * pose->far;
	}
	return sum;
}

/* ---- displacement in a step ---- */

/* Upper bound of the displacement of the surface at x in this step. */
static double displacement_at(const struct ts_region_wall *w, const struct tsim *sim, const double x[3])
{
	double sum = 0;

	for (int k = 0; k < w->nmovers; k++) {
		const struct ts_region *r = w->mover[k]->state;
		const struct ts_region_motion *m = &w->motion[k];
		double pivot[3];

		if (!(m->known > 0) || (int64_t)m->step != sim->clock.step - 1)
			continue;
		ts_add(r->pivot, r->shift, pivot);
		sum += sqrt(ts_distance2(r->shift, m->shift)) +
		       fabs(r->turned - m->angle) * sqrt(ts_distance2(x, pivot));
	}
	return sum;
}

/* The same for the farthest particle. */
static double max_displacement(const struct ts_region_wall *w, const struct tsim *sim)
{
	double sum = 0;

	for (int k = 0; k < w->nmovers; k++) {
		const struct ts_region *r = w->mover[k]->state;
		const struct ts_region_motion *m = &w->motion[k];
		double turn = fabs(r->turned - m->angle);

		if (m->known > 0 && (int64_t)m->step == sim->clock.step - 1) /* far may be infinite */
			sum += sqrt(ts_distance2(r->shift, m->shift)) +
			       (turn > 0 ? turn * w->listed[k].far : 0);
	}
	return sum;
}

/* Depth of each particle below the surface of the region, length. NULL: out of memory. */
static double *region_depths(const struct tsim *sim, const struct ts_region_wall *w)
{
	const struct ts_particles *p = sim->particles;
	double *depth = ts_alloc(p->n + 1, sizeof *depth);

	for (size_t i = 0; depth && i < p->n; i++)
		depth[i] = ts_region_depth(w->region, p->x[i]);
	return depth;
}

/* `before`: the depths one step ago, for a region that changes its shape; else NULL. */
static enum ts_status check_displacement(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w,
					 const double *before)
{
	const struct ts_particles *p = sim->particles;
	char what[80];

	if (!before && !(max_displacement(w, sim) > sim->neigh->least_radius))
		return TS_OK;
	for (size_t i = 0; i < p->n; i++) {
		double depth = ts_region_depth(w->region, p->x[i]);
		double travel = before ? fabs(depth - before[i]) : displacement_at(w, sim, p->x[i]);

		if (!(travel > p->radius[i]) || !ts_wall_interacts(self, sim, i, false) ||
		    fabs(depth) > p->radius[i] + travel)
			continue;
		snprintf(what, sizeof what, "the surface of wall %.40s", self->id);
		return ts_coincide_passed(sim, &self->where, i, travel, what);
	}
	return TS_OK;
}

/* Updates the region to the present step; fails if its surface has passed through a particle in one step. */
static enum ts_status update(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w)
{
	double *before = NULL;
	enum ts_status status;

	if (ts_region_reshapes(w->region) && w->updated > 0 && w->updated == sim->clock.step) {
		before = region_depths(sim, w);
		if (!before)
			return ts_nomem(&sim->error);
	}
	status = ts_region_update(w->region, sim);
	w->updated = sim->clock.step + 1;
	if (status == TS_OK)
		status = check_displacement(self, sim, w, before);
	ts_free(before);
	return status;
}

/* Whether the surface stays where it is: nothing moves, or it only slides along itself. */
static bool are_in_place(const struct ts_region_wall *w)
{
	bool are = true;

	for (int k = 0; k < w->nmovers; k++)
		are &= ts_region_turns_in_place(w->mover[k]);
	return are;
}

/* If particles would be listed again within fewer steps than this, listing all of them is cheaper. */
enum { MIN_LIST_STEPS = 8 };

/* Whether the surface has moved so far that particles must be listed again. */
static bool needs_list(const struct tsim *sim, struct ts_region_wall *w)
{
	bool far = max_approach(w) > w->margin;

	w->list_all |= far && sim->clock.step - w->listed_step < MIN_LIST_STEPS;
	return far;
}

/* Lists the particles near the surface: within the skin; of a region that moves within the skin plus
 * `margin`; of a region that changes its shape all particles. */
static enum ts_status add_pairs(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *wall = self->state;
	struct ts_region_wall *w = wall->geometry;
	const struct ts_particles *p = sim->particles;
	bool all = w->list_all || ts_region_reshapes(w->region);
	double further;
	size_t listed = 0;

	w->margin = all ? INFINITY : are_in_place(w) ? 0 : sim->neigh->built_skin;
	store_poses(w, sim);
	further = sim->neigh->built_skin + w->margin;
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_wall_interacts(self, sim, i, false) ||
		    !(all || is_near(w, sim, wall, i, p->xhold[i], further)))
			continue;
		for (int k = 0; k < w->faces; k++)
			TS_TRY(ts_wall_contacts_add(sim, &wall->contacts, i, k, 0));
		if (TS_GROW(w->clear, w->clear_capacity, listed + 1) != TS_OK)
			return ts_nomem(&sim->error);
		w->clear[listed++] = clear_distance(w, sim, wall, i);
	}
	return TS_OK;
}

static enum ts_status list(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(update(self, sim, ((struct ts_wall *)self->state)->geometry));
	return ts_wall_relist(self, sim, 0, add_pairs);
}

static const struct ts_region_contact_point *face_point(const struct ts_region_contact_point *point, int n,
							int face)
{
	for (int k = 0; k < n; k++)
		if (point[k].face == face)
			return &point[k];
	return NULL;
}

/* Infinite: the face has no contact point for the particle. */
static double contact_distance(const struct ts_wall *wall, const struct tsim *sim, size_t k, int *type)
{
	const struct ts_region_wall *w = wall->geometry;
	int n = ts_region_contact_points(w->region, sim->particles->x[wall->contacts.row[k]], w->point);
	const struct ts_region_contact_point *on = face_point(w->point, n, wall->contacts.key[k][1]);

	*type = (int)wall->type;
	return on ? on->distance : INFINITY;
}

/* Contact k of a particle with a face, at the contact point `on`. */
static void compute_face(struct ts_wall_queue *q, struct ts_wall *wall, const struct ts_region_wall *w,
			 size_t k, const struct ts_region_contact_point *on)
{
	struct ts_wall_contact_point *point = ts_wall_queue_next(q);

	*point = (struct ts_wall_contact_point){ .type = (int)wall->type,
						 .distance = on->distance,
						 .curvature = on->curvature };
	for (int d = 0; d < 3; d++)
		point->n[d] = on->n[d];
	if (!ts_wall_touches(q, k, point)) {
		ts_wall_contact_end(&wall->contacts, k);
		return;
	}
	if (on->mover)
		surface_velocity(w, on->mover, q->sim->particles->x[wall->contacts.row[k]], point);
	ts_wall_enqueue_contact(q, k, point);
}

struct force_task {
	struct tsim *sim;
	struct ts_wall *wall;
	const struct ts_region_wall *w;
	bool far;	 /* the list contains particles that are far from the surface */
	double approach; /* upper bound of the displacement of the surface since the listing, length */
};

/* Whether particle i, the `listed`th of the list, cannot touch yet: it and the surface have moved by less than the
 * distance between them at the listing. */
static bool is_clear(const struct force_task *t, size_t i, size_t listed)
{
	const struct ts_particles *p = t->sim->particles;
	double room = t->w->clear[listed] - p->radius[i] - t->approach;

	return room > 0 && ts_distance2(p->x[i], p->xhold[i]) < room * room;
}

/* Prefetches what the computation of the particle with contacts from k on will read. */
TS_INLINE void prefetch_particle(const struct force_task *t, size_t k, size_t end)
{
	const struct ts_wall_contacts *c = &t->wall->contacts;
	size_t faces = (size_t)t->w->faces,
	       next = k + TS_WALL_AHEAD * faces < end ? k + TS_WALL_AHEAD * faces : k;
	size_t i = (size_t)c->row[next];
	bool touches = false;

	for (size_t face = 0; face < faces; face++) {
		if (c->touching[next + face])
			ts_wall_prefetch_contact(c, next + face);
		touches |= c->touching[next + face] != 0;
	}
	ts_wall_prefetch_particle(t->sim->particles, i, touches);
	if (!touches)
		ts_wall_prefetch(t->sim->particles->xhold[i]);
}

/* The contacts of a particle with the faces 0 .. faces - 1 are consecutive. */
static void compute_contacts(const struct force_task *t, size_t from, size_t to,
			     struct ts_region_contact_point *point)
{
	const struct ts_particles *p = t->sim->particles;
	struct ts_wall_contacts *c = &t->wall->contacts;
	const size_t faces = (size_t)t->w->faces;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->wall, t->sim);
	for (size_t k = from; k < to; k += faces) {
		size_t i = (size_t)c->row[k];
		int n = 0;

		prefetch_particle(t, k, to);
		if (!is_clear(t, i, k / faces) && !(t->far && !is_near(t->w, t->sim, t->wall, i, p->x[i], 0)))
			n = ts_region_contact_points(t->w->region, p->x[i], point);
		for (size_t face = 0; face < faces; face++) {
			const struct ts_region_contact_point *on = face_point(point, n, (int)face);

			if (on)
				compute_face(&queue, t->wall, t->w, k + face, on);
			else
				ts_wall_contact_end(c, k + face);
		}
	}
	ts_wall_queue_end(&queue);
}

/* Regions with more faces are computed by one thread, which uses the buffer of the wall. */
enum { MAX_STACK_POINTS = 24 };

static void compute_range(void *context, size_t from, size_t to)
{
	struct ts_region_contact_point point[MAX_STACK_POINTS];

	compute_contacts(context, from, to, point);
}

static enum ts_status enqueue(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *wall = self->state;
	struct ts_region_wall *w = wall->geometry;
	struct force_task task = { sim, wall, w, false, 0 };

	TS_TRY(update(self, sim, w));
	if (needs_list(sim, w))
		TS_TRY(ts_wall_relist(self, sim, 0, add_pairs));
	for (int k = 0; k < w->nmovers; k++)
		update_motion(w->mover[k], &w->motion[k], sim);
	task.far = w->margin > 0;
	task.approach = max_approach(w);
	if (w->faces <= MAX_STACK_POINTS)
		ts_wall_contacts_parallel(sim, &wall->contacts, compute_range, &task);
	else
		compute_contacts(&task, 0, wall->contacts.n, w->point);
	ts_wall_finish(wall);
	return ts_coincide_wall(sim, wall);
}

static void release(void *geometry)
{
	ts_free(((struct ts_region_wall *)geometry)->clear);
}

/* The surface of a region that moves or changes may be anywhere: gap 0. */
static double gap(const struct ts_wall *wall, const struct tsim *sim, const double x[3])
{
	const struct ts_region_wall *w = wall->geometry;
	double depth = ts_region_depth(w->region, x);

	(void)sim;
	return ts_region_varies(w->region) || isnan(depth) ? 0 : fabs(depth);
}

/* ---- the first touch on a path ---- */

/* The face that a sphere at x with velocity v touches next, by the safe distance for which it may go on; NULL: it
 * approaches none. *room: this distance; infinite: there is no face. */
static const struct ts_region_contact_point *next_face(const struct ts_region_wall *w, const double x[3],
						       const double v[3], double radius, double *room)
{
	const struct ts_region_contact_point *next = NULL;
	int n = ts_region_contact_points(w->region, x, w->point);

	*room = n ? 0.1 * radius : INFINITY;
	for (int k = 0; k < n; k++) {
		const struct ts_region_contact_point *at = &w->point[k];

		if (ts_dot(at->n, v) < 0 && (!next || at->distance < next->distance))
			next = at;
	}
	if (next)
		*room = next->distance - radius;
	return next;
}

/* Of a region that does not change with time; by one thread. A sphere touches where its distance is below a thousandth
 * of its radius. */
static enum ts_status sweep(const struct tsim *sim, const void *shape, size_t i, const struct ts_sweep *path,
			    struct ts_mesh_list *list, bool *found, struct ts_exact_touch *out)
{
	const struct ts_region_wall *w = shape;
	double speed = ts_norm(path->v), negligible = 1e-3 * path->radius, time = 0, room;

	(void)sim;
	(void)i;
	(void)list;
	*found = false;
	while (!*found && !ts_region_varies(w->region) && speed > 0 && time <= path->span) {
		const struct ts_region_contact_point *at;
		double x[3];

		ts_scale(1, path->x, x);
		ts_axpy(time, path->v, x);
		at = next_face(w, x, path->v, path->radius, &room);
		*found = at && room <= negligible;
		if (*found) {
			*out = (struct ts_exact_touch){ .hit.time = time, .hit.overlap = fmax(0, -room) };
			ts_scale(1, at->n, out->hit.n);
		}
		time += fmax(room, negligible) / speed;
	}
	return TS_OK;
}

static const struct ts_exact_surface exact = { .sweep = sweep };

/* ---- as a surface, which no style can observe: from outside all contacts are with face 0 ---- */

static int surface_type(const struct ts_instance *by)
{
	return (int)((const struct ts_wall *)by->state)->type;
}

static enum ts_status archive(struct ts_archive *a, void *geometry)
{
	struct ts_region_wall *w = geometry;

	if (!w->nmovers)
		return TS_OK;
	return ts_archive_fixed(a, "motion", TS_SAVED_F64, w->motion, (size_t)w->nmovers * TS_REGION_MOTION);
}

const struct ts_wall_shape ts_region_wall_shape = {
	.made_of = "the surface of a region",
	.given = given,
	.find = find,
	.archive = archive,
	.release = release,
	.surfaces = ts_wall_one_surface,
	.fix = ts_wall_own_fix,
	.place = ts_wall_own_place,
	.surface = { .type = surface_type },
	.list = list,
	.enqueue = enqueue,
	.distance = contact_distance,
	.gap = gap,
	.exact = &exact,
};
