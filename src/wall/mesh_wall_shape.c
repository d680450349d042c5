/* Meshes as a shape of walls. */
#include <math.h>

#include "mesh/mesh_distance.h"
#include "mesh/mesh_recede.h"
#include "wall/mesh_stick.h"
#include "wall/mesh_wall.h"
#include "wall/mesh_wall_queue.h"

#include "base/banned.h"

/* ---- definition */

static int given(const void *geometry)
{
	return ((const struct ts_mesh_wall *)geometry)->given;
}

static void release_trees(struct ts_mesh_wall *mw)
{
	for (size_t k = 0; k < mw->nmeshes; k++)
		ts_mesh_tree_release(&mw->mesh[k].tree);
	mw->nmeshes = 0;
}

static void release(void *geometry)
{
	struct ts_mesh_wall *mw = geometry;

	release_trees(mw);
	ts_free(mw->near);
	ts_free(mw->place);
	ts_free(mw->neighbor);
}

static enum ts_status check_words(struct ts_instance *self, struct tsim *sim, const struct ts_wall *w,
				  const struct ts_mesh_wall *mw)
{
	if (!mw->names.n)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wall/gran mesh: which meshes? `n_meshes 1 meshes ID`");
	if (mw->count != INT64_MIN && mw->count != (int64_t)mw->names.n)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "n_meshes"),
			       "fix wall/gran: n_meshes is %d, but %zu meshes are named", (int)mw->count,
			       mw->names.n);
	if (w->type != INT64_MIN)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "type"),
			       "fix wall/gran: each mesh has the type that its fix says");
	return TS_OK;
}

/* The triangles near particles stay listed if the meshes are those of the last run: one without a set-up (`run N pre no`) does
 * not list them again. */
static enum ts_status find_meshes(struct ts_instance *self, struct tsim *sim, struct ts_mesh_wall *mw)
{
	bool same = mw->nmeshes == mw->names.n;
	size_t first = 0;

	release_trees(mw);
	if (!mw->mesh)
		mw->mesh = ts_arena_alloc(&self->arena, mw->names.n, sizeof *mw->mesh);
	if (!mw->mesh)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < mw->names.n; k++) {
		const struct ts_word *name = &mw->names.word[k];
		struct ts_mesh_part_of_wall *part = &mw->mesh[k];
		struct ts_mesh_surface *surface;

		TS_TRY(ts_mesh_surface_require(sim, name, &surface));
		for (size_t j = 0; j < k; j++)
			if (mw->mesh[j].surface == surface)
				return ts_fail(&sim->error, TS_SYNTAX, &name->place,
					       "fix wall/gran: mesh %s is named twice, and would act twice",
					       name->text);
		same = same && part->surface == surface && part->first == first;
		*part = (struct ts_mesh_part_of_wall){ .surface = surface, .first = first };
		part->by = ts_sim_find(sim, TS_KIND_FIX, name->text);
		mw->nmeshes = k + 1;
		first += surface->mesh.n;
		if (first > INT32_MAX / TS_MESH_WALL_IMAGES)
			return ts_fail(&sim->error, TS_RANGE, &name->place,
				       "a wall of %zu triangles is too large", first);
	}
	if (!same)
		mw->nneighbors = 0;
	return TS_OK;
}

static enum ts_status find(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct ts_mesh_wall *mw = ts_mesh_wall_of(w);

	TS_TRY(check_words(self, sim, w, mw));
	TS_TRY(find_meshes(self, sim, mw));
	w->warm = false;
	for (size_t k = 0; k < mw->nmeshes; k++) {
		TS_TRY(ts_wall_check_type(self, sim, mw->mesh[k].surface->type, mw->names.word[k].text));
		w->warm |= !isnan(mw->mesh[k].surface->temperature);
	}
	return TS_OK;
}

/* ---- surfaces */

static size_t count_surfaces(const struct ts_wall *w)
{
	return ts_mesh_wall_of(w)->nmeshes;
}

static const struct ts_instance *fix_of_surface(const struct ts_wall *w, size_t surface)
{
	return ts_mesh_wall_of(w)->mesh[surface].by;
}

static void place_of_contact(const struct ts_wall *w, size_t k, struct ts_wall_place *out)
{
	const struct ts_mesh_near *near = &ts_mesh_wall_of(w)->near[k];

	*out = (struct ts_wall_place){ (size_t)near->mesh,
				       (size_t)near->triangle,
				       { near->shift[0], near->shift[1], near->shift[2] } };
}

static const struct ts_mesh_surface *surface_of(const struct ts_instance *by)
{
	return by->state;
}

static size_t count_triangles(const struct ts_instance *by)
{
	return surface_of(by)->mesh.n;
}

static double triangle_area(const struct ts_instance *by, const struct tsim *sim, size_t element)
{
	(void)sim;
	return surface_of(by)->mesh.area[element];
}

static void triangle_centre(const struct ts_instance *by, const struct tsim *sim, size_t element,
			    double out[3])
{
	(void)sim;
	ts_scale(1, surface_of(by)->mesh.centre[element], out);
}

static int mesh_type(const struct ts_instance *by)
{
	return (int)surface_of(by)->type;
}

static double mesh_temperature(const struct ts_instance *by)
{
	return surface_of(by)->temperature;
}

static bool is_back(const struct ts_instance *by, size_t element, const double normal[3])
{
	return ts_dot(surface_of(by)->mesh.normal[element], normal) < 0;
}

static enum ts_status check_recession(struct tsim *sim, const struct ts_instance *by,
				      const struct ts_recession *how, const struct ts_place *where)
{
	return ts_mesh_recede_check(sim, by->state, how, where);
}

static enum ts_status recede(struct tsim *sim, const struct ts_instance *by, const struct ts_recession *how,
			     const struct ts_place *where, struct ts_recession_element *e, size_t n)
{
	return ts_mesh_recede(sim, by->state, how, where, e, n);
}

/* ---- contacts */

static double contact_distance(const struct ts_wall *w, const struct tsim *sim, size_t k, int *type)
{
	const struct ts_mesh_wall *mw = ts_mesh_wall_of(w);
	const struct ts_mesh_near *near = &mw->near[k];
	double x[3];

	*type = (int)mw->mesh[near->mesh].surface->type;
	ts_mesh_wall_position(sim, near, (size_t)w->contacts.row[k], x);
	return ts_mesh_distance(&mw->mesh[near->mesh].surface->mesh, (size_t)near->triangle, x);
}

static void name_triangle(const struct ts_wall *w, size_t k, struct ts_str *out)
{
	const struct ts_mesh_wall *mw = ts_mesh_wall_of(w);
	const struct ts_mesh_near *near = &mw->near[k];

	ts_str_addf(out, ", triangle %d of mesh %s", near->triangle + 1, mw->mesh[near->mesh].by->id);
}

/* The triangles near particle i, which are listed by particle; NULL: none. */
static const struct ts_mesh_neighbor *find_neighbor(const struct ts_mesh_wall *mw, size_t i)
{
	size_t lo = 0, hi = mw->nneighbors;

	while (lo < hi) {
		size_t mid = (lo + hi) / 2;

		if (mw->neighbor[mid].i < i)
			lo = mid + 1;
		else
			hi = mid;
	}
	return lo < mw->nneighbors && mw->neighbor[lo].i == i ? &mw->neighbor[lo] : NULL;
}

static void near_points(const struct ts_wall *w, const struct tsim *sim, size_t i, double reach,
			ts_wall_near_fn *take, void *context)
{
	const struct ts_mesh_wall *mw = ts_mesh_wall_of(w);
	const struct ts_mesh_neighbor *v = find_neighbor(mw, i);

	if (!v || mw->place_capacity < w->contacts.n)
		return;
	ts_mesh_places(sim, mw, v, reach - v->radius);
	for (size_t k = v->first; k < v->first + v->n; k++) {
		const struct ts_mesh_place *place = &mw->place[k];
		struct ts_wall_near_point point;

		if (!place->own || !(place->at.distance < reach) || !(place->at.distance > 0))
			continue;
		point.distance = place->at.distance;
		ts_scale(1, place->at.n, point.n);
		ts_mesh_surface_velocity(mw->mesh[mw->near[k].mesh].surface, (size_t)mw->near[k].triangle,
					 place->at.weight, point.velocity);
		take(context, &point);
	}
}

const struct ts_wall_shape ts_mesh_wall_shape = {
	.made_of = "meshes",
	.given = given,
	.find = find,
	.release = release,
	.surfaces = count_surfaces,
	.fix = fix_of_surface,
	.place = place_of_contact,
	.surface = { .family = TS_FAMILY_MESH,
		     .elements = count_triangles,
		     .area = triangle_area,
		     .centre = triangle_centre,
		     .type = mesh_type,
		     .temperature = mesh_temperature,
		     .check_recession = check_recession,
		     .recede = recede,
		     .is_back = is_back },
	.list = ts_mesh_wall_list,
	.has_moved = ts_mesh_wall_has_moved,
	.check_displacement = ts_mesh_wall_check_displacement,
	.enqueue = ts_mesh_wall_enqueue_contacts,
	.distance = contact_distance,
	.near = near_points,
	.name = name_triangle,
	.exact = &ts_mesh_wall_exact,
};
