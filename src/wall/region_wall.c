#include "wall/region_wall.h"

#include <math.h>
#include <stdio.h>

#include "math/vec3.h"
#include "neigh/coincide.h"
#include "particle/particles.h"
#include "wall/wall_coincide.h"
#include "wall/wall_queue.h"

#include "base/banned.h"

enum ts_status ts_region_wall_init(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w)
{
	const struct ts_place *where = ts_instance_word(self, w->region->id);

	w->faces = ts_region_faces(w->region);
	if (!w->faces)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix wall/gran/region: region %s is of style %s, whose surface is no wall; "
			       "expected block, cone, cylinder, plane, sphere, or a union or intersection "
			       "of them",
			       w->region->id, w->region->style->name);
	w->nmovers = ts_region_movers(w->region, NULL, 0);
	w->spot = ts_arena_alloc(&self->arena, (size_t)w->faces, sizeof *w->spot);
	w->mover = ts_arena_alloc(&self->arena, (size_t)w->nmovers + 1, sizeof *w->mover);
	w->listed = ts_arena_alloc(&self->arena, (size_t)w->nmovers + 1, sizeof *w->listed);
	if (!w->motion)
		w->motion = ts_arena_alloc(&self->arena, (size_t)w->nmovers + 1, sizeof *w->motion);
	if (!w->spot || !w->mover || !w->motion || !w->listed)
		return ts_nomem(&sim->error);
	w->quick = false;
	ts_region_movers(w->region, w->mover, w->nmovers);
	if (w->nmovers < 2 || w->mover[0] != w->region)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "fix wall/gran/region: region %s moves, and %s, which it is made of, moves in it; "
		       "expected one of both",
		       w->region->id, w->mover[1]->id);
}

/* ---- motion ---- */

/* The velocity is by what variables said in the last step, as in LAMMPS; 0 where nobody asked before. */
static void look_at_motion(const struct ts_instance *mover, struct ts_region_motion *m,
			   const struct tsim *sim)
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

/* Of the surface at the spot nearest to x. */
static void surface_velocity(const struct ts_region_wall *w, const struct ts_instance *mover,
			     const double x[3], struct ts_wall_contact_point *spot)
{
	const struct ts_region *r = mover->state;
	const struct ts_region_motion *m = w->motion;
	double arm[3], spin[3], turn[3];

	for (int k = 0; k < w->nmovers && w->mover[k] != mover; k++)
		m++;
	for (int k = 0; k < 3; k++) {
		arm[k] = x[k] - spot->distance * spot->n[k] - r->pivot[k] - r->shift[k];
		spin[k] = m->rate * r->axis[k];
	}
	ts_cross(spin, arm, turn);
	ts_add(m->velocity, turn, spot->velocity);
}

/* ---- stages ---- */

/* A particle with its centre at x, as far as its surface or the wall's reach and `further`. */
static bool is_near(const struct ts_region_wall *w, const struct tsim *sim, const struct ts_wall *wall,
		    size_t i, const double x[3], double further)
{
	double radius = sim->particles->radius[i];

	return !(fabs(ts_region_depth(w->region, x)) >= radius + further + ts_wall_reach(wall, sim, radius));
}

/* Where the movers are now, and how far from their pivots particles are until they are listed again. */
static void note_poses(struct ts_region_wall *w, const struct tsim *sim)
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
		ts_scale(1, r->shift, pose->shift);
	}
	w->listed_step = sim->clock.step;
}

/* How far the surface has come towards any particle since, at most: turning it is turning the particle
 * back. */
static double gone(const struct ts_region_wall *w)
{
	double sum = 0;

	for (int k = 0; k < w->nmovers; k++) {
		const struct ts_region *r = w->mover[k]->state;
		const struct ts_region_pose *pose = &w->listed[k];

		sum += sqrt(ts_distance2(r->shift, pose->shift)) + fabs(r->turned - pose->angle) * pose->far;
	}
	return sum;
}

/* ---- pace ---- */

/* How far the movers have carried it in this step at x. */
static double carried(const struct ts_region_wall *w, const struct tsim *sim, const double x[3])
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

/* At most, at the farthest particle. */
static double carried_most(const struct ts_region_wall *w, const struct tsim *sim)
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

/* How deep particles are in the region. NULL: out of memory. */
static double *depths(const struct tsim *sim, const struct ts_region_wall *w)
{
	const struct ts_particles *p = sim->particles;
	double *depth = ts_alloc(p->n + 1, sizeof *depth);

	for (size_t i = 0; depth && i < p->n; i++)
		depth[i] = ts_region_depth(w->region, p->x[i]);
	return depth;
}

/* `before`: of a region that changes its shape, the depths in it as it was one step ago; else NULL. */
static enum ts_status check_pace(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w,
				 const double *before)
{
	const struct ts_particles *p = sim->particles;
	char what[80];

	if (!before && !(carried_most(w, sim) > sim->neigh->least_radius))
		return TS_OK;
	for (size_t i = 0; i < p->n; i++) {
		double depth = ts_region_depth(w->region, p->x[i]);
		double way = before ? fabs(depth - before[i]) : carried(w, sim, p->x[i]);

		if (!(way > p->radius[i]) || !ts_wall_meets(self, sim, i, false) ||
		    fabs(depth) > p->radius[i] + way)
			continue;
		snprintf(what, sizeof what, "the surface of wall %.40s", self->id);
		return ts_coincide_passed(sim, &self->where, i, way, what);
	}
	return TS_OK;
}

enum ts_status ts_region_wall_update(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w)
{
	double *before = NULL;
	enum ts_status status;

	if (ts_region_reshapes(w->region) && w->seen > 0 && w->seen == sim->clock.step) {
		before = depths(sim, w);
		if (!before)
			return ts_nomem(&sim->error);
	}
	status = ts_region_update(w->region, sim);
	w->seen = sim->clock.step + 1;
	if (status == TS_OK)
		status = check_pace(self, sim, w, before);
	ts_free(before);
	return status;
}

/* Where it must be done again within some steps, listing all particles is cheaper. */
enum { QUICK = 8 };

enum ts_status ts_region_wall_follow(struct ts_instance *self, struct tsim *sim, struct ts_region_wall *w,
				     bool *list)
{
	TS_TRY(ts_region_wall_update(self, sim, w));
	*list = gone(w) > w->margin;
	w->quick |= *list && sim->clock.step - w->listed_step < QUICK;
	return TS_OK;
}

/* Lists particles near the surface: of one that moves also those somewhat farther, of one that changes
 * otherwise all. */
enum ts_status ts_region_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *wall,
				   struct ts_region_wall *w)
{
	const struct ts_particles *p = sim->particles;
	bool all = w->quick || ts_region_reshapes(w->region);
	double further;

	w->margin = all ? INFINITY : w->nmovers ? sim->neigh->built_skin : 0;
	note_poses(w, sim);
	further = sim->neigh->built_skin + w->margin;
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_wall_meets(self, sim, i, false) ||
		    !(all || is_near(w, sim, wall, i, p->xhold[i], further)))
			continue;
		for (int k = 0; k < w->faces; k++)
			TS_TRY(ts_wall_contacts_add(sim, &wall->contacts, i, k));
	}
	return TS_OK;
}

static const struct ts_region_contact_point *spot_of(const struct ts_region_contact_point *spot, int n,
						     int face)
{
	for (int k = 0; k < n; k++)
		if (spot[k].face == face)
			return &spot[k];
	return NULL;
}

double ts_region_wall_distance(const struct ts_region_wall *w, const struct tsim *sim,
			       const struct ts_wall *wall, size_t k)
{
	int n = ts_region_contact_points(w->region, sim->particles->x[wall->contacts.row[k]], w->spot);
	const struct ts_region_contact_point *on = spot_of(w->spot, n, wall->contacts.key[k][1]);

	return on ? on->distance : INFINITY;
}

/* The contact k of a particle with a face that has a spot for it. */
static void push_face(struct ts_wall_queue *q, struct ts_wall *wall, const struct ts_region_wall *w, size_t k,
		      const struct ts_region_contact_point *on, int type)
{
	struct ts_wall_contact_point spot = { .type = type,
					      .distance = on->distance,
					      .curvature = on->curvature };

	for (int d = 0; d < 3; d++)
		spot.n[d] = on->n[d];
	if (!ts_wall_touches(q, k, &spot)) {
		ts_wall_contact_part(&wall->contacts, k);
		return;
	}
	if (on->mover)
		surface_velocity(w, on->mover, q->sim->particles->x[wall->contacts.row[k]], &spot);
	ts_wall_enqueue_contact(q, k, &spot);
}

struct task {
	struct tsim *sim;
	struct ts_wall *wall;
	const struct ts_region_wall *w;
	int type;
	bool far; /* particles that are far are listed, too */
};

/* The faces of a particle follow one another. */
static void push_contacts(const struct task *t, size_t from, size_t to, struct ts_region_contact_point *spot)
{
	const struct ts_particles *p = t->sim->particles;
	struct ts_wall_contacts *c = &t->wall->contacts;
	struct ts_wall_queue queue;
	int n = 0;

	ts_wall_queue_start(&queue, t->wall, t->sim);
	for (size_t k = from; k < to; k++) {
		const double *x = p->x[c->row[k]];
		const struct ts_region_contact_point *on;
		int face = c->key[k][1];

		ts_wall_look_ahead(c, p, k, to);
		if (face == 0)
			n = t->far && !is_near(t->w, t->sim, t->wall, (size_t)c->row[k], x, 0)
				    ? 0
				    : ts_region_contact_points(t->w->region, x, spot);
		on = spot_of(spot, n, face);
		if (on)
			push_face(&queue, t->wall, t->w, k, on, t->type);
		else
			ts_wall_contact_part(c, k);
	}
	ts_wall_queue_end(&queue);
}

/* Regions of more faces are looked at by one thread. */
enum { SPOTS = 24 };

static void push_share(void *context, size_t from, size_t to)
{
	struct ts_region_contact_point spot[SPOTS];

	push_contacts(context, from, to, spot);
}

enum ts_status ts_region_wall_enqueue_contacts(struct tsim *sim, struct ts_wall *wall,
					       struct ts_region_wall *w, int type)
{
	struct task task = { sim, wall, w, type, ts_region_varies(w->region) };

	for (int k = 0; k < w->nmovers; k++)
		look_at_motion(w->mover[k], &w->motion[k], sim);
	if (w->faces <= SPOTS)
		ts_wall_contacts_parallel(sim, &wall->contacts, push_share, &task);
	else
		push_contacts(&task, 0, wall->contacts.n, w->spot);
	ts_wall_finish(wall);
	return ts_coincide_wall(sim, wall);
}

enum ts_status ts_region_wall_archive(struct ts_archive *a, struct ts_region_wall *w)
{
	if (!w->nmovers)
		return TS_OK;
	return ts_archive_fixed(a, "motion", TS_SAVED_F64, w->motion, (size_t)w->nmovers * TS_REGION_MOTION);
}
