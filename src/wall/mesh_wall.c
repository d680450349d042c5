#include "wall/mesh_wall.h"

#include <math.h>
#include <stdio.h>

#include "base/parallel.h"
#include "box/domain.h"
#include "mesh/mesh_distance.h"
#include "neigh/coincide.h"
#include "wall/mesh_stick.h"
#include "wall/wall_push.h"

#include "base/banned.h"

/* Images of a triangle are told apart by where they are modulo three box lengths, counted from where the
 * particle would be had it not been wrapped: 27 numbers for each triangle. */
enum { IMAGES = 27 };

static void drop_trees(struct ts_mesh_wall *mw)
{
	for (size_t k = 0; k < mw->nmeshes; k++)
		ts_mesh_tree_release(&mw->mesh[k].tree);
	mw->nmeshes = 0;
}

enum ts_status ts_mesh_wall_find(struct ts_instance *self, struct tsim *sim, struct ts_mesh_wall *mw,
				 struct ts_words names)
{
	size_t first = 0;

	drop_trees(mw);
	if (!mw->mesh)
		mw->mesh = ts_arena_alloc(&self->arena, names.n, sizeof *mw->mesh);
	if (!mw->mesh)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < names.n; k++) {
		struct ts_mesh_part_of_wall *part = &mw->mesh[k];
		struct ts_mesh_surface *surface;

		TS_TRY(ts_mesh_surface_require(sim, &names.word[k], &surface));
		*part = (struct ts_mesh_part_of_wall){ .surface = surface, .first = first };
		part->by = ts_sim_find(sim, TS_KIND_FIX, names.word[k].text);
		mw->nmeshes = k + 1;
		first += surface->mesh.n;
		if (first > INT32_MAX / IMAGES)
			return ts_fail(&sim->error, TS_RANGE, &names.word[k].place,
				       "a wall of %zu triangles is too large", first);
	}
	return TS_OK;
}

void ts_mesh_wall_release(struct ts_mesh_wall *mw)
{
	drop_trees(mw);
	ts_free(mw->near);
	ts_free(mw->place);
	ts_free(mw->visitor);
	ts_free(mw->touching);
	*mw = (struct ts_mesh_wall){ 0 };
}

static enum ts_status update_tree(struct tsim *sim, struct ts_mesh_part_of_wall *part)
{
	if (part->tree.n && part->moves == part->surface->moves)
		return TS_OK;
	ts_mesh_tree_release(&part->tree);
	part->moves = part->surface->moves;
	return ts_mesh_tree_build(&part->tree, &part->surface->mesh) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static int modulo3(int a)
{
	return (a % 3 + 3) % 3;
}

/* A touch may be found when a particle is farther by so much: twice the tolerance of the triangle, and rounding. The
 * rest of the gap between a sphere and a triangle both can go in any way; rounding counts less than what is left of it. */
static const double SURE = 0.999;

static double slack(const struct ts_mesh *m, int32_t triangle)
{
	return 4 * ts_mesh_tolerance(m, (size_t)triangle);
}

static double safe_way(const struct ts_mesh *m, int32_t triangle, double distance, double radius)
{
	return SURE * (distance - radius - slack(m, triangle));
}

/* What is near to a particle: a triangle, and the image of the mesh by box lengths. */
struct found {
	size_t i;
	int32_t mesh, triangle;
	int shift[3];
	double distance;
};

/* The contacts of a particle are added one after the other. */
static enum ts_status add_visitor(struct tsim *sim, struct ts_mesh_wall *mw, size_t i, size_t first)
{
	const struct ts_particles *p = sim->particles;
	struct ts_mesh_visitor *v;

	if (!mw->nvisitors || mw->visitor[mw->nvisitors - 1].i != i) {
		if (TS_GROW(mw->visitor, mw->visitor_capacity, mw->nvisitors + 1) != TS_OK)
			return ts_nomem(&sim->error);
		mw->visitor[mw->nvisitors++] = (struct ts_mesh_visitor){
			.i = i, .first = first, .radius = p->radius[i], .until = -INFINITY,
			.place = { p->xhold[i][0], p->xhold[i][1], p->xhold[i][2] },
		};
	}
	v = &mw->visitor[mw->nvisitors - 1];
	v->n++;
	return TS_OK;
}

/* How far from its surface a particle may begin a contact: surfaces that stick have to touch first. */
static double outreach(const struct tsim *sim, const struct ts_wall *w, double radius)
{
	return ts_wall_model(w, sim)->multi ? ts_wall_reach(w, sim, radius) : 0;
}

static enum ts_status add(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw, const struct found *f)
{
	const struct ts_mesh *mesh = &mw->mesh[f->mesh].surface->mesh;
	const struct ts_particles *p = sim->particles;
	size_t k = w->contacts.n;
	int code = 0;

	for (int d = 0; d < 3; d++)
		code = 3 * code + modulo3(p->image[f->i][d] % 3 + f->shift[d]);
	if (TS_GROW(mw->near, mw->near_capacity, k + 1) != TS_OK)
		return ts_nomem(&sim->error);
	if (ts_wall_pulls(w, sim) && TS_GROW(mw->place, mw->place_capacity, k + 1) != TS_OK)
		return ts_nomem(&sim->error);
	mw->near[k] = (struct ts_mesh_near){ f->mesh, f->triangle, { f->shift[0], f->shift[1], f->shift[2] }, false,
					     safe_way(mesh, f->triangle, f->distance,
						      p->radius[f->i] + outreach(sim, w, p->radius[f->i])) };
	TS_TRY(add_visitor(sim, mw, f->i, k));
	return ts_wall_contacts_add(sim, &w->contacts, f->i,
				    ((int)mw->mesh[f->mesh].first + f->triangle) * IMAGES + code);
}

/* The images of a mesh, by box lengths, that reach within r of x in one dimension. */
static void reaching(const struct ts_box *box, const struct ts_mesh_tree *tree, int dim, double x,
		     double r, int range[2])
{
	double length = ts_box_length(box, dim);

	range[0] = range[1] = 0;
	if (!ts_box_periodic(box, dim))
		return;
	range[0] = (int)ceil(fmax(-1e6, (x - r - tree->hi[1][dim]) / length));
	range[1] = (int)floor(fmin(1e6, (x + r - tree->lo[1][dim]) / length));
}

/* What the particles of one share have near, in their order. */
struct search {
	struct found *found;
	size_t n, capacity;
	struct ts_mesh_list list;
	struct ts_mesh_vicinity *vicinity; /* of each mesh */
	bool failed;
};

static void find_image(struct search *s, const struct ts_mesh_part_of_wall *part, const double at[3], double r,
		       const struct found *what)
{
	const struct ts_mesh *mesh = &part->surface->mesh;
	struct ts_mesh_vicinity *v = &s->vicinity[what->mesh];

	if (ts_mesh_tree_near_again(&part->tree, mesh, at, r, v, &s->list) != TS_OK ||
	    TS_GROW(s->found, s->capacity, s->n + s->list.n) != TS_OK) {
		s->failed = true;
		return;
	}
	for (size_t k = 0; k < s->list.n; k++) {
		struct found *f = &s->found[s->n];

		*f = *what;
		f->triangle = s->list.item[k];
		f->distance = ts_mesh_distance(mesh, (size_t)f->triangle, at);
		s->n += f->distance > r + slack(mesh, f->triangle) ? 0 : 1;
	}
}

static void find_images(const struct tsim *sim, const struct ts_mesh_wall *mw, size_t mesh, size_t i,
			double reach, struct search *found)
{
	const struct ts_box *box = &sim->domain->box;
	const struct ts_mesh_part_of_wall *part = &mw->mesh[mesh];
	const double *x = sim->particles->xhold[i];
	double r = sim->particles->radius[i] + sim->neigh->built_skin + reach;
	struct found what = { .i = i, .mesh = (int32_t)mesh };
	int range[3][2], *s = what.shift;

	for (int d = 0; d < 3; d++)
		reaching(box, &part->tree, d, x[d], r, range[d]);
	for (s[0] = range[0][0]; s[0] <= range[0][1]; s[0]++) {
		for (s[1] = range[1][0]; s[1] <= range[1][1]; s[1]++) {
			for (s[2] = range[2][0]; s[2] <= range[2][1]; s[2]++) {
				double at[3];

				for (int d = 0; d < 3; d++)
					at[d] = x[d] - s[d] * ts_box_length(box, d);
				find_image(found, part, at, r, &what);
			}
		}
	}
}

struct searching {
	struct ts_instance *self;
	struct tsim *sim;
	const struct ts_wall *w;
	const struct ts_mesh_wall *mw;
	struct search *share;
	size_t shares;
};

/* A particle that is held does not feel the wall, but who sums forces on the mesh wants to know. */
static bool concerns(const struct searching *s, size_t mesh, size_t i)
{
	const struct ts_mesh_part_of_wall *part = &s->mw->mesh[mesh];
	const struct ts_particles *p = s->sim->particles;

	return ts_in_group(p, i, part->by->group) &&
	       (ts_wall_meets(s->self, s->sim, i, !isnan(part->surface->temperature)) ||
		(part->surface->stress && ts_in_group(p, i, s->self->group)));
}

static void search_share(void *context, size_t from, size_t to)
{
	const struct searching *s = context;
	const struct ts_particles *p = s->sim->particles;
	size_t n = p->n;
	bool pulls = ts_wall_pulls(s->w, s->sim);

	for (size_t t = from; t < to; t++) {
		struct search *share = &s->share[t];

		share->vicinity = ts_alloc(s->mw->nmeshes, sizeof *share->vicinity);
		share->failed = !share->vicinity;
		for (size_t i = n * t / s->shares; i < n * (t + 1) / s->shares; i++)
			for (size_t mesh = 0; mesh < s->mw->nmeshes && !share->failed; mesh++)
				if (concerns(s, mesh, i))
					find_images(s->sim, s->mw, mesh, i,
						    pulls ? ts_wall_reach(s->w, s->sim, p->radius[i]) : 0, share);
		for (size_t mesh = 0; mesh < s->mw->nmeshes && share->vicinity; mesh++)
			ts_free(share->vicinity[mesh].leaf.item);
		ts_free(share->vicinity);
	}
}

/* Takes what a share has found, and releases it. */
static enum ts_status take(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw, struct search *share)
{
	enum ts_status status = share->failed ? ts_nomem(&sim->error) : TS_OK;

	for (size_t k = 0; k < share->n && status == TS_OK; k++)
		status = add(sim, w, mw, &share->found[k]);
	ts_free(share->found);
	ts_free(share->list.item);
	return status;
}

/* How far the meshes have gone since the last call, at most; infinite if nothing is known of it: images move with the
 * box. */
static double come_nearer(const struct tsim *sim, struct ts_mesh_wall *mw)
{
	double most = sim->full & TS_FULL_LOOKS ? INFINITY : 0;

	for (size_t k = 0; k < mw->nmeshes; k++) {
		struct ts_mesh_part_of_wall *part = &mw->mesh[k];
		double step = part->surface->travelled - part->travelled;

		most = fmax(most, step >= 0 ? step : INFINITY);
		part->travelled = part->surface->travelled;
	}
	for (int d = 0; d < 3; d++) {
		double length = ts_box_length(&sim->domain->box, d);

		most = length == mw->length[d] ? most : INFINITY;
		mw->length[d] = length;
	}
	return most;
}

enum ts_status ts_mesh_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				 struct ts_mesh_wall *mw)
{
	size_t n = sim->particles->n;
	/* a search is worth many particles of other loops */
	int team = ts_team(sim, 16 * n);
	struct searching s = { self, sim, w, mw, NULL, (size_t)team };
	enum ts_status status = TS_OK;

	for (size_t k = 0; k < mw->nmeshes; k++) {
		TS_TRY(update_tree(sim, &mw->mesh[k]));
		mw->mesh[k].checked = mw->mesh[k].surface->travelled;
	}
	mw->nvisitors = 0;
	come_nearer(sim, mw);
	s.share = ts_alloc(s.shares, sizeof *s.share);
	if (!s.share)
		return ts_nomem(&sim->error);
	ts_parallel(team, s.shares, search_share, &s);
	for (size_t t = 0; t < s.shares; t++) {
		enum ts_status taken = take(sim, w, mw, &s.share[t]);

		status = status == TS_OK ? taken : status;
	}
	ts_free(s.share);
	return status;
}

/* Particles are listed with a skin: they and the mesh may each use half of it. */
bool ts_mesh_wall_has_moved(const struct tsim *sim, const struct ts_mesh_wall *mw)
{
	bool far = false;

	for (size_t k = 0; k < mw->nmeshes; k++)
		far |= mw->mesh[k].surface->travelled > 0.5 * sim->neigh->built_skin;
	return far;
}

/* The longest way of a corner of the triangle in this step. */
static double way_of(const struct tsim *sim, const struct ts_mesh_surface *s, size_t t)
{
	double most = 0;

	for (int k = 0; s->v && k < 3; k++)
		most = fmax(most, ts_norm(s->v[t][k]));
	return most * sim->clock.dt;
}

/* Whether a triangle has come to the place of particle i, or through it, in a step longer than its radius. */
static enum ts_status check_passage(struct tsim *sim, const struct ts_mesh_part_of_wall *part, size_t i, const double x[3],
				    double step, struct ts_mesh_list *list)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_mesh *m = &part->surface->mesh;
	char what[120];

	list->n = 0;
	if (ts_mesh_tree_near(&part->tree, m, x, p->radius[i] + step, list) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < list->n; k++) {
		size_t t = (size_t)list->item[k];
		double way = way_of(sim, part->surface, t);

		if (!(way > p->radius[i]) || ts_mesh_distance(m, t, x) > p->radius[i] + way)
			continue;
		snprintf(what, sizeof what, "triangle %zu of mesh %.60s", t + 1, part->by->id);
		return ts_coincide_passed(sim, &part->by->where, i, way, what);
	}
	return TS_OK;
}

/* The particle and its images across periodic faces. */
static enum ts_status check_images(struct tsim *sim, const struct ts_mesh_part_of_wall *part, size_t i, double step,
				   struct ts_mesh_list *list)
{
	const struct ts_particles *p = sim->particles;
	double x[3];

	for (int k = 0; k < 27; k++)
		if (ts_box_image(&sim->domain->box, p->x[i], k, p->radius[i] + step, x))
			TS_TRY(check_passage(sim, part, i, x, step, list));
	return TS_OK;
}

/* Most meshes are slow: then this is all. */
static bool is_slow(const struct tsim *sim, struct ts_mesh_part_of_wall *part, double *step)
{
	double travelled = part->surface->travelled;

	*step = travelled >= part->checked ? travelled - part->checked : travelled;
	part->checked = travelled;
	return *step <= sim->neigh->least_radius;
}

enum ts_status ts_mesh_wall_check_pace(struct ts_instance *self, struct tsim *sim, struct ts_mesh_wall *mw)
{
	const struct ts_particles *p = sim->particles;
	struct ts_mesh_list list = { 0 };
	enum ts_status status = TS_OK;
	double step;

	for (size_t k = 0; k < mw->nmeshes && status == TS_OK; k++) {
		struct ts_mesh_part_of_wall *part = &mw->mesh[k];

		if (is_slow(sim, part, &step))
			continue;
		status = update_tree(sim, part);
		for (size_t i = 0; i < p->n && status == TS_OK; i++)
			if (ts_in_group(p, i, part->by->group) && ts_wall_meets(self, sim, i, false))
				status = check_images(sim, part, i, step, &list);
	}
	ts_free(list.item);
	return status;
}

/* Across a periodic face the image of a triangle may be the neighbour. */
static bool same_surface(const struct ts_mesh_wall *mw, size_t a, size_t b)
{
	const struct ts_mesh_near *p = &mw->near[a], *q = &mw->near[b];

	return a != b && p->mesh == q->mesh &&
	       ts_mesh_flat_neighbours(&mw->mesh[p->mesh].surface->mesh, (size_t)p->triangle,
				       (size_t)q->triangle);
}

/* A new contact, among those from..to-1 of the particle. False: a flat neighbour has it. */
static bool begin_contact(struct ts_wall *w, const struct ts_mesh_wall *mw, size_t from, size_t to,
			  size_t k, enum ts_mesh_part part)
{
	const struct ts_wall_contacts *c = &w->contacts;

	for (size_t j = from; j < to && part == TS_MESH_FACE; j++)
		if (mw->near[j].done && same_surface(mw, j, k))
			return false;
	for (size_t j = from; j < to; j++)
		if (*ts_mesh_alive(c, j) > 0 && !mw->near[j].done && same_surface(mw, j, k))
			for (size_t m = 0; m < c->width; m++)
				ts_wall_memory(c, k)[m] = ts_wall_memory(c, j)[m];
	*ts_mesh_alive(c, k) = 1;
	return true;
}

struct task {
	struct tsim *sim;
	struct ts_wall *w;
	struct ts_mesh_wall *mw;
	double step; /* of the meshes since the last time, at most; infinite: all contacts are looked at */
};

void ts_mesh_wall_place(const struct tsim *sim, const struct ts_mesh_near *near, size_t i, double x[3])
{
	for (int d = 0; d < 3; d++)
		x[d] = sim->particles->x[i][d] - near->shift[d] * ts_box_length(&sim->domain->box, d);
}

double ts_mesh_wall_distance(const struct tsim *sim, const struct ts_mesh_wall *mw, size_t k, size_t i)
{
	const struct ts_mesh_near *near = &mw->near[k];
	double x[3];

	ts_mesh_wall_place(sim, near, i, x);
	return ts_mesh_distance(&mw->mesh[near->mesh].surface->mesh, (size_t)near->triangle, x);
}

/* Whether there is no touch yet, and when there may be. */
static bool waits(const struct ts_mesh *m, struct ts_mesh_near *near, const struct ts_mesh_visitor *v, const double x[3])
{
	double far = safe_way(m, near->triangle, ts_mesh_distance(m, (size_t)near->triangle, x), v->radius);

	near->until = far > 0 ? v->way + far : -INFINITY;
	return far > 0;
}

static void make_spot(const struct ts_mesh_surface *s, const struct ts_mesh_near *near, const struct ts_mesh_spot *at,
		      struct ts_wall_spot *spot)
{
	for (int d = 0; d < 3; d++)
		spot->n[d] = at->n[d];
	spot->distance = at->distance;
	ts_mesh_surface_velocity(s, (size_t)near->triangle, at->weight, spot->velocity);
	spot->curvature = 0;
	spot->sums = s->stress != NULL;
	spot->type = (int)s->type;
	spot->mesh = near->mesh + 1;
	spot->triangle = near->triangle;
	spot->warm = !isnan(s->temperature);
	spot->temperature = s->temperature;
}

static void push(const struct task *task, struct ts_wall_queue *q, const struct ts_mesh_visitor *v, size_t k)
{
	struct ts_wall *w = task->w;
	struct ts_mesh_near *near = &task->mw->near[k];
	const struct ts_mesh_surface *s = task->mw->mesh[near->mesh].surface;
	size_t t = (size_t)near->triangle;
	struct ts_wall_spot spot;
	struct ts_mesh_spot at;
	enum ts_mesh_part part;
	double x[3];

	ts_mesh_wall_place(task->sim, near, v->i, x);
	if (!w->contacts.touching[k] && waits(&s->mesh, near, v, x))
		return;
	part = ts_mesh_nearest(&s->mesh, t, x, &at);
	near->done = part != TS_MESH_NOTHING && at.distance <= v->radius &&
		     (*ts_mesh_alive(&w->contacts, k) > 0 || begin_contact(w, task->mw, v->first, v->first + v->n, k, part));
	near->until = -INFINITY;
	if (!near->done)
		return;
	make_spot(s, near, &at, &spot);
	ts_wall_push(q, k, &spot);
}

/* Notes where the particle is now; whether one of its contacts may touch. */
static bool moves(const struct task *task, struct ts_mesh_visitor *v)
{
	const struct ts_particles *p = task->sim->particles;
	const double *x = p->x[v->i];
	double step = sqrt(ts_distance2(x, v->place));

	/* after a particle has grown nothing is known */
	v->way += p->radius[v->i] == v->radius ? step + task->step : INFINITY;
	ts_scale(1, x, v->place);
	v->radius = p->radius[v->i];
	return !(v->way < v->until);
}

/* A surface that acts beyond the touch: whether the contact k, which has a place of its own, is one. */
static bool meets(const struct task *task, struct ts_wall_queue *q, const struct ts_mesh_visitor *v, size_t k,
		  struct ts_wall_spot *spot)
{
	const struct ts_wall_contacts *c = &task->w->contacts;
	const struct ts_mesh_near *near = &task->mw->near[k];
	size_t from = *ts_mesh_alive(c, k) > 0 ? k : ts_mesh_donor(task->mw, c, v, k);

	make_spot(task->mw->mesh[near->mesh].surface, near, &task->mw->place[k].at, spot);
	for (size_t m = 0; m < c->width && from != SIZE_MAX; m++)
		ts_wall_memory(c, k)[m] = ts_wall_memory(c, from)[m];
	if (ts_wall_touches(q, k, spot))
		return true;
	for (size_t m = 0; m < c->width && from != k; m++)
		ts_wall_memory(c, k)[m] = 0;
	return false;
}

static void visit_sticking(const struct task *task, struct ts_wall_queue *q, const struct ts_mesh_visitor *v)
{
	struct ts_mesh_wall *mw = task->mw;
	double begins = v->radius + outreach(task->sim, task->w, v->radius);

	ts_mesh_places(task->sim, mw, v, ts_wall_reach(task->w, task->sim, v->radius));
	for (size_t k = v->first; k < v->first + v->n; k++) {
		struct ts_mesh_near *near = &mw->near[k];
		struct ts_wall_spot spot;

		near->until = v->way + safe_way(&mw->mesh[near->mesh].surface->mesh, near->triangle,
						mw->place[k].distance, begins);
		near->done = mw->place[k].own && meets(task, q, v, k, &spot);
		if (!near->done)
			continue;
		near->until = -INFINITY;
		*ts_mesh_alive(&task->w->contacts, k) = 1;
		ts_wall_push(q, k, &spot);
	}
}

static void visit(const struct task *task, struct ts_wall_queue *q, struct ts_mesh_visitor *v)
{
	struct ts_wall_contacts *c = &task->w->contacts;
	struct ts_mesh_near *near = task->mw->near;
	size_t end = v->first + v->n;

	if (!moves(task, v))
		return;
	for (size_t k = v->first; k < end; k++)
		near[k].done = false;
	if (q->sticks)
		visit_sticking(task, q, v);
	for (size_t k = v->first; k < end && !q->sticks; k++)
		if (c->touching[k] || !(v->way < near[k].until))
			push(task, q, v, k);
	v->until = INFINITY;
	for (size_t k = v->first; k < end; k++) {
		if (!near[k].done)
			ts_wall_contact_part(c, k);
		v->until = fmin(v->until, near[k].until);
	}
}

/* What a visit soon will need. */
TS_INLINE void send_for(const struct task *task, const struct ts_mesh_visitor *v)
{
	const struct ts_wall_contacts *c = &task->w->contacts;
	bool touches = v->until < 0;

	ts_wall_send_for_particle(task->sim->particles, v->i, touches);
	if (!touches)
		return;
	__builtin_prefetch(&task->mw->near[v->first]);
	__builtin_prefetch(&task->mw->near[v->first + v->n - 1]);
	__builtin_prefetch(ts_wall_memory(c, v->first), 1);
	__builtin_prefetch(ts_wall_memory(c, v->first + v->n - 1), 1);
}

static void push_share(void *context, size_t from, size_t end)
{
	const struct task *t = context;
	struct ts_mesh_visitor *v = t->mw->visitor;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->w, t->sim);
	for (size_t k = from; k < end; k++) {
		send_for(t, &v[k + TS_WALL_AHEAD < end ? k + TS_WALL_AHEAD : k]);
		visit(t, &queue, &v[k]);
	}
	ts_wall_queue_end(&queue);
}

/* ": triangle 12 of mesh cad" */
void ts_mesh_wall_name(const void *context, size_t k, struct ts_str *out)
{
	const struct ts_mesh_wall *mw = context;
	const struct ts_mesh_near *near = &mw->near[k];

	ts_str_addf(out, ", triangle %d of mesh %s", near->triangle + 1, mw->mesh[near->mesh].by->id);
}

enum ts_status ts_mesh_wall_push(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw)
{
	struct task task = { sim, w, mw, come_nearer(sim, mw) };

	/* a contact is worth several particles of other loops */
	ts_parallel(ts_team(sim, 4 * w->contacts.n), mw->nvisitors, push_share, &task);
	ts_wall_finish(w);
	return ts_coincide_wall(sim, w, ts_mesh_wall_name, mw);
}
