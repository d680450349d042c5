#include "neigh/mesh_wall.h"

#include <math.h>

#include "base/parallel.h"
#include "geom/mesh_touch.h"
#include "neigh/wall_push.h"
#include "particles/domain.h"

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

static enum ts_status add(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw, size_t i,
			  int32_t mesh, int32_t triangle, const int shift[3])
{
	const struct ts_particles *p = sim->particles;
	size_t k = w->contacts.n;
	int code = 0;

	for (int d = 0; d < 3; d++)
		code = 3 * code + modulo3(p->image[i][d] % 3 + shift[d]);
	if (TS_GROW(mw->near, mw->near_capacity, k + 1) != TS_OK)
		return ts_nomem(&sim->error);
	mw->near[k] = (struct ts_mesh_near){ mesh, triangle, { shift[0], shift[1], shift[2] }, false };
	return ts_wall_contacts_add(sim, &w->contacts, i,
				    ((int)mw->mesh[mesh].first + triangle) * IMAGES + code);
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

/* What is near to a particle: a triangle, and the image of the mesh by box lengths. */
struct found {
	size_t i;
	int32_t mesh, triangle;
	int shift[3];
};

/* What the particles of one share have near, in their order. */
struct search {
	struct found *found;
	size_t n, capacity;
	struct ts_mesh_list list;
	bool failed;
};

static void find_image(struct search *s, const struct ts_mesh_part_of_wall *part, const double at[3], double r,
		       const struct found *what)
{
	if (ts_mesh_tree_near(&part->tree, &part->surface->mesh, at, r, &s->list) != TS_OK ||
	    TS_GROW(s->found, s->capacity, s->n + s->list.n) != TS_OK) {
		s->failed = true;
		return;
	}
	for (size_t k = 0; k < s->list.n; k++) {
		s->found[s->n] = *what;
		s->found[s->n++].triangle = s->list.item[k];
	}
}

static void find_images(const struct tsim *sim, const struct ts_mesh_wall *mw, size_t mesh, size_t i,
			struct search *found)
{
	const struct ts_box *box = &sim->domain->box;
	const struct ts_mesh_part_of_wall *part = &mw->mesh[mesh];
	const double *x = sim->particles->xhold[i];
	double r = sim->particles->radius[i] + sim->neigh->built_skin;
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
	size_t n = s->sim->particles->n;

	for (size_t t = from; t < to; t++)
		for (size_t i = n * t / s->shares; i < n * (t + 1) / s->shares; i++)
			for (size_t mesh = 0; mesh < s->mw->nmeshes && !s->share[t].failed; mesh++)
				if (concerns(s, mesh, i))
					find_images(s->sim, s->mw, mesh, i, &s->share[t]);
}

/* Takes what a share has found, and releases it. */
static enum ts_status take(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw, struct search *share)
{
	enum ts_status status = share->failed ? ts_nomem(&sim->error) : TS_OK;

	for (size_t k = 0; k < share->n && status == TS_OK; k++) {
		const struct found *f = &share->found[k];

		status = add(sim, w, mw, f->i, f->mesh, f->triangle, f->shift);
	}
	ts_free(share->found);
	ts_free(share->list.item);
	return status;
}

enum ts_status ts_mesh_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				 struct ts_mesh_wall *mw)
{
	size_t n = sim->particles->n;
	/* a search is worth many particles of other loops */
	int team = ts_team(sim, 16 * n);
	struct searching s = { self, sim, mw, NULL, (size_t)team };
	enum ts_status status = TS_OK;

	for (size_t k = 0; k < mw->nmeshes; k++)
		TS_TRY(update_tree(sim, &mw->mesh[k]));
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

/* Whether there is a contact: as of the last step, or found in this one. */
static double *alive(const struct ts_wall_contacts *c, size_t k)
{
	return ts_wall_memory(c, k) + c->width - TS_MESH_MEMORY;
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
		if (*alive(c, j) > 0 && !mw->near[j].done && same_surface(mw, j, k))
			for (size_t m = 0; m < c->width; m++)
				ts_wall_memory(c, k)[m] = ts_wall_memory(c, j)[m];
	*alive(c, k) = 1;
	return true;
}

static void push(struct ts_wall_queue *q, struct ts_wall *w, struct ts_mesh_wall *mw, size_t from, size_t to,
		 size_t k)
{
	struct ts_mesh_near *near = &mw->near[k];
	const struct ts_mesh_surface *s = mw->mesh[near->mesh].surface;
	const struct ts_particles *p = q->sim->particles;
	size_t i = (size_t)w->contacts.row[k], t = (size_t)near->triangle;
	struct ts_wall_spot spot = { .type = (int)s->type,
				     .mesh = near->mesh + 1,
				     .triangle = (int)t,
				     .warm = !isnan(s->temperature),
				     .temperature = s->temperature };
	struct ts_mesh_spot at;
	enum ts_mesh_part part;
	double x[3];

	for (int d = 0; d < 3; d++)
		x[d] = p->x[i][d] - near->shift[d] * ts_box_length(&q->sim->domain->box, d);
	part = ts_mesh_nearest(&s->mesh, t, x, &at);
	near->done = part != TS_MESH_NOTHING && at.distance <= p->radius[i] &&
		     (*alive(&w->contacts, k) > 0 || begin_contact(w, mw, from, to, k, part));
	if (!near->done)
		return;
	spot.sums = s->stress != NULL;
	spot.distance = at.distance;
	for (int d = 0; d < 3; d++)
		spot.n[d] = at.n[d];
	ts_mesh_surface_velocity(s, t, at.weight, spot.velocity);
	ts_wall_push(q, k, &spot);
}

struct task {
	struct tsim *sim;
	struct ts_wall *w;
	struct ts_mesh_wall *mw;
};

static void push_share(void *context, size_t from, size_t end)
{
	const struct task *t = context;
	struct ts_wall_contacts *c = &t->w->contacts;
	struct ts_wall_queue queue;

	ts_wall_queue_start(&queue, t->w, t->sim);
	for (size_t to; from < end; from = to) {
		ts_wall_look_ahead(c, t->sim->particles, from, end);
		for (to = from; to < end && c->row[to] == c->row[from]; to++)
			t->mw->near[to].done = false;
		for (size_t k = from; k < to; k++)
			push(&queue, t->w, t->mw, from, to, k);
		for (size_t k = from; k < to; k++)
			if (!t->mw->near[k].done)
				ts_wall_contact_part(c, k);
	}
	ts_wall_queue_end(&queue);
}

void ts_mesh_wall_push(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw)
{
	struct task task = { sim, w, mw };

	ts_wall_contacts_parallel(sim, &w->contacts, push_share, &task);
	ts_wall_finish(w);
}
