#include "wall/mesh_stick.h"

#include <math.h>

#include "mesh/mesh_distance.h"

#include "base/banned.h"

static const struct ts_mesh *contact_mesh(const struct ts_mesh_wall *mw, size_t k)
{
	return &mw->mesh[mw->near[k].mesh].surface->mesh;
}

/* Tolerance, length: points of two triangles that are no farther apart than the sum of both tolerances are
 * the same. */
static double place_tolerance(const struct ts_mesh_wall *mw, size_t k)
{
	return 4 * ts_mesh_tolerance(contact_mesh(mw, k), (size_t)mw->near[k].triangle);
}

static void compute_place(const struct tsim *sim, const struct ts_mesh_wall *mw, size_t i, size_t k,
			  double within)
{
	struct ts_mesh_place *place = &mw->place[k];
	const struct ts_mesh *m = contact_mesh(mw, k);
	size_t t = (size_t)mw->near[k].triangle;
	double x[3];

	ts_mesh_wall_position(sim, &mw->near[k], i, x);
	place->distance = ts_mesh_distance(m, t, x);
	place->part = TS_MESH_NOTHING;
	if (!ts_mesh_is_removed(m, t) && place->distance <= within + place_tolerance(mw, k))
		place->part = ts_mesh_nearest(m, t, x, &place->at);
	place->own = place->part != TS_MESH_NOTHING;
	for (int d = 0; d < 3 && place->own; d++)
		place->point[d] = -place->at.distance * place->at.n[d];
}

static bool same_place(const struct ts_mesh_wall *mw, size_t j, size_t k)
{
	return sqrt(ts_distance2(mw->place[j].point, mw->place[k].point)) <=
	       place_tolerance(mw, j) + place_tolerance(mw, k);
}

/* Whether triangle j contains the point of triangle k, but has another point that is nearer to the
 * particle. */
static bool has_nearer_place(const struct tsim *sim, const struct ts_mesh_wall *mw, size_t i, size_t j,
			     size_t k)
{
	double x[3];

	if (mw->place[j].part == TS_MESH_NOTHING || same_place(mw, j, k))
		return false;
	ts_mesh_wall_position(sim, &mw->near[j], i, x);
	ts_add(x, mw->place[k].point, x);
	return ts_mesh_distance(contact_mesh(mw, j), (size_t)mw->near[j].triangle, x) <=
	       place_tolerance(mw, j);
}

static bool is_nearest_place(const struct tsim *sim, const struct ts_mesh_wall *mw,
			     const struct ts_mesh_neighbor *v, size_t k)
{
	for (size_t j = v->first; j < v->first + v->n; j++) {
		if (j == k || mw->near[j].mesh != mw->near[k].mesh)
			continue;
		if (j < k && mw->place[j].own && same_place(mw, j, k))
			return false;
		if (mw->place[k].part != TS_MESH_FACE && has_nearer_place(sim, mw, v->i, j, k))
			return false;
	}
	return true;
}

void ts_mesh_places(const struct tsim *sim, const struct ts_mesh_wall *mw, const struct ts_mesh_neighbor *v,
		    double reach)
{
	for (size_t k = v->first; k < v->first + v->n; k++)
		compute_place(sim, mw, v->i, k, v->radius + reach);
	for (size_t k = v->first; k < v->first + v->n; k++)
		mw->place[k].own = mw->place[k].own && is_nearest_place(sim, mw, v, k);
}

static bool share_corner(const struct ts_mesh_wall *mw, size_t j, size_t k)
{
	const struct ts_mesh *m = contact_mesh(mw, k);
	const int32_t *a = m->vertex[mw->near[j].triangle], *b = m->vertex[mw->near[k].triangle];
	bool share = false;

	for (int e = 0; e < 9; e++)
		share |= a[e / 3] == b[e % 3];
	return share && mw->near[j].mesh == mw->near[k].mesh && ts_mesh_wall_adjoin(mw, j, k);
}

size_t ts_mesh_donor(const struct ts_mesh_wall *mw, const struct ts_wall_contacts *c,
		     const struct ts_mesh_neighbor *v, size_t k)
{
	size_t best = SIZE_MAX;
	double least = INFINITY;

	for (size_t j = v->first; j < v->first + v->n; j++) {
		/* the nearest of the contacts that have ended and share a corner with k */
		if (mw->place[j].own || !(*ts_mesh_contact_exists(c, j) > 0) || !share_corner(mw, j, k) ||
		    !(mw->place[j].distance < least))
			continue;
		least = mw->place[j].distance;
		best = j;
	}
	return best;
}
