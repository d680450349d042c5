#include "wall/mesh_wall_search.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "box/domain.h"
#include "geom/box_images.h"
#include "mesh/mesh_distance.h"

#include "base/banned.h"

struct searching {
	struct ts_instance *self;
	struct tsim *sim;
	const struct ts_wall *w;
	const struct ts_mesh_wall *mw;
	struct ts_mesh_wall_search *result;
};

/* Particles that follow each other in memory and are near each other, and the box of their centres. */
struct tile {
	size_t from, to;
	double lo[3], hi[3], radius; /* the largest of their search radii */
};
enum { MOST_IN_TILE = 64 };

/* Whether pairs of particle i with this mesh are listed. */
static bool is_candidate(const struct searching *s, size_t mesh, size_t i)
{
	const struct ts_mesh_part_of_wall *part = &s->mw->mesh[mesh];
	const struct ts_particles *p = s->sim->particles;

	return ts_in_group(p, i, part->by->group) &&
	       ts_wall_lists(s->self, s->sim, i, mesh, !isnan(part->surface->temperature));
}

/* Distance from its centre up to which triangles are listed for particle i. */
static double search_radius(const struct searching *s, size_t i)
{
	double radius = s->sim->particles->radius[i];
	double reach = ts_wall_long_ranged(s->w, s->sim) ? ts_wall_reach(s->w, s->sim, radius) : 0;

	return radius + s->sim->neigh->built_skin + fmax(s->w->look, reach);
}

/* Whether the image is one of those that come near particle i. */
static bool image_is_near(const struct searching *s, const struct ts_mesh_image *image, size_t i, double r)
{
	const struct ts_mesh_tree *tree = &s->mw->mesh[image->mesh].tree;
	const double *x = s->sim->particles->xhold[i];
	struct ts_box_images images = ts_box_images(&s->sim->domain->box, tree->lo[1], tree->hi[1], x, x, r);

	return ts_box_images_have(&images, image->shift);
}

static void find_triangles(const struct searching *s, struct ts_mesh_image *image, size_t i, double r,
			   struct ts_mesh_found_part *out)
{
	const struct ts_box *box = &s->sim->domain->box;
	const struct ts_mesh_part_of_wall *part = &s->mw->mesh[image->mesh];
	const struct ts_mesh *mesh = &part->surface->mesh;
	double at[3];

	ts_box_images_place(box, image->shift, s->sim->particles->xhold[i], at);
	if (ts_mesh_vicinity_near(&part->tree, mesh, at, r, &image->nearby, &out->list) != TS_OK ||
	    TS_GROW(out->found, out->capacity, out->n + out->list.n) != TS_OK) {
		out->failed = true;
		return;
	}
	for (size_t k = 0; k < out->list.n; k++) {
		int32_t t = out->list.item[k];
		double distance = ts_mesh_distance(mesh, (size_t)t, at);

		if (distance > r + ts_mesh_wall_slack(mesh, t))
			continue;
		out->found[out->n++] = (struct ts_mesh_found){
			i, image->mesh, t, { image->shift[0], image->shift[1], image->shift[2] }, distance
		};
	}
}

static bool add_to_tile(const struct searching *s, struct tile *tile)
{
	const double *x = s->sim->particles->xhold[tile->to];
	struct tile with = *tile;
	bool fits = true;

	with.radius = fmax(tile->radius, search_radius(s, tile->to));
	for (int d = 0; d < 3; d++) {
		with.lo[d] = fmin(tile->lo[d], x[d]);
		with.hi[d] = fmax(tile->hi[d], x[d]);
		fits &= with.hi[d] - with.lo[d] <= TS_MESH_VICINITY * with.radius;
	}
	if (!fits && tile->to > tile->from)
		return false;
	*tile = with;
	tile->to++;
	return true;
}

/* Keeps the image if a triangle of it is near the tile. */
static void try_image(const struct searching *s, const struct tile *tile, int32_t mesh, const int shift[3],
		      struct ts_mesh_found_part *out)
{
	const struct ts_mesh_part_of_wall *part = &s->mw->mesh[mesh];
	struct ts_mesh_image *image;
	double lo[3], hi[3];

	if (TS_GROW(out->image, out->image_capacity, out->images + 1) != TS_OK) {
		out->failed = true;
		return;
	}
	image = &out->image[out->images];
	image->mesh = mesh;
	memcpy(image->shift, shift, sizeof image->shift);
	ts_box_images_place(&s->sim->domain->box, shift, tile->lo, lo);
	ts_box_images_place(&s->sim->domain->box, shift, tile->hi, hi);
	out->failed |= ts_mesh_vicinity_make(&part->tree, &part->surface->mesh, lo, hi, tile->radius,
					     &image->nearby) != TS_OK;
	out->images += image->nearby.candidate.n > 0;
}

static void find_images(const struct searching *s, const struct tile *tile, int32_t mesh,
			struct ts_mesh_found_part *out)
{
	const struct ts_mesh_tree *tree = &s->mw->mesh[mesh].tree;
	struct ts_box_images images = ts_box_images(&s->sim->domain->box, tree->lo[1], tree->hi[1], tile->lo,
						    tile->hi, tile->radius);

	while (!out->failed && ts_box_images_next(&images))
		try_image(s, tile, mesh, images.shift, out);
}

static void search_tile(const struct searching *s, const struct tile *tile, struct ts_mesh_found_part *out)
{
	out->images = 0;
	for (size_t mesh = 0; mesh < s->mw->nmeshes; mesh++)
		find_images(s, tile, (int32_t)mesh, out);
	for (size_t i = tile->from; out->images && i < tile->to; i++) {
		double r = search_radius(s, i);

		for (size_t k = 0; k < out->images && !out->failed; k++)
			if (is_candidate(s, (size_t)out->image[k].mesh, i) &&
			    image_is_near(s, &out->image[k], i, r))
				find_triangles(s, &out->image[k], i, r, out);
	}
}

static void search_part(const struct searching *s, size_t from, size_t to, struct ts_mesh_found_part *out)
{
	while (from < to && !out->failed) {
		struct tile tile = { .from = from,
				     .to = from,
				     .lo = { INFINITY, INFINITY, INFINITY },
				     .hi = { -INFINITY, -INFINITY, -INFINITY } };

		while (tile.to < to && tile.to - from < MOST_IN_TILE && add_to_tile(s, &tile))
			continue;
		search_tile(s, &tile, out);
		from = tile.to;
	}
}

static void search_range(void *context, size_t from, size_t to)
{
	const struct searching *s = context;
	size_t n = s->sim->particles->n, parts = s->result->parts;

	for (size_t t = from; t < to; t++) {
		struct ts_mesh_found_part *part = &s->result->part[t];

		search_part(s, n * t / parts, n * (t + 1) / parts, part);
		for (size_t k = 0; k < part->image_capacity; k++)
			ts_mesh_vicinity_release(&part->image[k].nearby);
		ts_free(part->image);
		ts_free(part->list.item);
	}
}

enum ts_status ts_mesh_wall_search(struct ts_instance *self, struct tsim *sim,
				   struct ts_mesh_wall_search *search)
{
	const struct ts_wall *w = self->state;
	/* a search costs as much as about 16 particles of simple loops */
	int team = ts_team(sim, 16 * sim->particles->n);
	struct searching s = { self, sim, w, ts_mesh_wall_of(w), search };

	search->parts = (size_t)team;
	search->part = ts_alloc_aligned(search->parts, sizeof *search->part);
	if (!search->part)
		return ts_nomem(&sim->error);
	ts_parallel(team, search->parts, search_range, &s);
	for (size_t k = 0; k < search->parts; k++)
		if (search->part[k].failed)
			return ts_nomem(&sim->error);
	return TS_OK;
}

void ts_mesh_wall_search_release(struct ts_mesh_wall_search *search)
{
	for (size_t k = 0; search->part && k < search->parts; k++)
		ts_free(search->part[k].found);
	ts_free(search->part);
	*search = (struct ts_mesh_wall_search){ 0 };
}
