#include "neigh/mesh_wall.h"

#include <math.h>

#include "geom/mesh_touch.h"
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
	ts_free(mw->list.item);
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

static enum ts_status list_images(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw,
				  size_t mesh, size_t i)
{
	const struct ts_box *box = &sim->domain->box;
	const struct ts_mesh_part_of_wall *part = &mw->mesh[mesh];
	const double *x = sim->particles->xhold[i];
	double r = sim->particles->radius[i] + sim->neigh->built_skin;
	int range[3][2], s[3];

	for (int d = 0; d < 3; d++)
		reaching(box, &part->tree, d, x[d], r, range[d]);
	for (s[0] = range[0][0]; s[0] <= range[0][1]; s[0]++) {
		for (s[1] = range[1][0]; s[1] <= range[1][1]; s[1]++) {
			for (s[2] = range[2][0]; s[2] <= range[2][1]; s[2]++) {
				double at[3];

				for (int d = 0; d < 3; d++)
					at[d] = x[d] - s[d] * ts_box_length(box, d);
				if (ts_mesh_tree_near(&part->tree, &part->surface->mesh, at, r,
						      &mw->list) != TS_OK)
					return ts_nomem(&sim->error);
				for (size_t k = 0; k < mw->list.n; k++)
					TS_TRY(add(sim, w, mw, i, (int32_t)mesh, mw->list.item[k], s));
			}
		}
	}
	return TS_OK;
}

/* A particle that is held does not feel the wall, but who sums forces on the mesh wants to know. */
enum ts_status ts_mesh_wall_list(struct ts_instance *self, struct tsim *sim, struct ts_wall *w,
				 struct ts_mesh_wall *mw)
{
	const struct ts_particles *p = sim->particles;

	for (size_t k = 0; k < mw->nmeshes; k++)
		TS_TRY(update_tree(sim, &mw->mesh[k]));
	for (size_t i = 0; i < p->n; i++)
		for (size_t k = 0; k < mw->nmeshes; k++)
			if (ts_in_group(p, i, mw->mesh[k].by->group) &&
			    (ts_wall_meets(self, sim, i, !isnan(mw->mesh[k].surface->temperature)) ||
			     (mw->mesh[k].surface->stress && ts_in_group(p, i, self->group))))
				TS_TRY(list_images(sim, w, mw, k, i));
	return TS_OK;
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

static void push(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw, size_t from, size_t to,
		 size_t k)
{
	struct ts_mesh_near *near = &mw->near[k];
	const struct ts_mesh_surface *s = mw->mesh[near->mesh].surface;
	const struct ts_particles *p = sim->particles;
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
		x[d] = p->x[i][d] - near->shift[d] * ts_box_length(&sim->domain->box, d);
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
	ts_wall_push(w, sim, k, &spot);
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

	for (size_t to; from < end; from = to) {
		ts_wall_look_ahead(c, t->sim->particles, from, end);
		for (to = from; to < end && c->row[to] == c->row[from]; to++)
			t->mw->near[to].done = false;
		for (size_t k = from; k < to; k++)
			push(t->sim, t->w, t->mw, from, to, k);
		for (size_t k = from; k < to; k++)
			if (!t->mw->near[k].done)
				ts_wall_contact_part(c, k);
	}
}

void ts_mesh_wall_push(struct tsim *sim, struct ts_wall *w, struct ts_mesh_wall *mw)
{
	struct task task = { sim, w, mw };

	ts_wall_contacts_parallel(sim, &w->contacts, push_share, &task);
	ts_wall_finish(w);
}
