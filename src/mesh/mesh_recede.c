#include "mesh/mesh_recede.h"

#include <math.h>
#include <stdio.h>

#include "core/archive.h"
#include "mesh/mesh_links.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_recession.h"

#include "base/banned.h"

/* what is due of an element, relative to what it has given: less is a rounding error, which stays pending */
static const double ROUNDING = 1e-14;
/* largest part of the volume that may be worn on the other side */
static const double OTHER_SIDE = 0.1;

struct ts_mesh_worn {
	struct ts_mesh_nodes nodes;
	double *owed;	   /* [nodes] volume that rounding has not taken yet, length^3 */
	double *given;	   /* [triangles] volume taken, length^3 */
	double *area;	   /* [triangles] of the mesh as defined */
	double (*worn)[2]; /* [parts] volume worn on the side of nodes.side = 1 and on the other */
	bool *rim;	   /* [parts] whether the part has edges without neighbour, or holes */
	bool used;	   /* some volume has been taken */
};

void ts_mesh_recede_release(struct ts_mesh_surface *s)
{
	if (!s->worn)
		return;
	ts_mesh_nodes_release(&s->worn->nodes);
	ts_free(s->worn->owed);
	ts_free(s->worn->given);
	ts_free(s->worn->area);
	ts_free(s->worn->worn);
	ts_free(s->worn->rim);
	ts_free(s->worn);
	s->worn = NULL;
}

static const char *name_of(const struct tsim *sim, const struct ts_mesh_surface *s)
{
	struct ts_instance *by;
	const struct ts_mesh_surface *other;

	for (size_t k = 0; (other = ts_mesh_surface_next(sim, &k, &by));)
		if (other == s)
			return by->id;
	return "";
}

/* The positions that recede: those before the motion, if the mesh moves. */
static double (*corners_of(const struct ts_mesh_surface *s))[3][3]
{
	return s->home ? s->home : s->mesh.x;
}

/* ---- what can recede ---- */

static const char *const topology_texts[] = {
	[TS_MESH_NODES_FINE] = "",
	[TS_MESH_NODES_BRANCHED] =
		"has an edge that more than two triangles share: what is behind it is not defined",
	[TS_MESH_NODES_ONE_SIDED] = "is part of a surface with only one side",
	[TS_MESH_NODES_PINCHED] = "touches another surface of the mesh at a corner only",
};

static double triangle_area(double x[3][3])
{
	double a[3], b[3], c[3];

	ts_sub(x[1], x[0], a);
	ts_sub(x[2], x[0], b);
	ts_cross(a, b, c);
	return 0.5 * ts_norm(c);
}

static void find_rims(struct ts_mesh_surface *s)
{
	struct ts_mesh_worn *w = s->worn;

	for (size_t c = 0; c < 3 * s->mesh.n; c++)
		w->rim[w->nodes.part[c / 3]] |=
			s->mesh.neighbour[c / 3][c % 3] < 0 || ts_mesh_is_removed(&s->mesh, c / 3);
}

static enum ts_status fail_without_memory(struct tsim *sim, struct ts_mesh_surface *s)
{
	ts_mesh_recede_release(s);
	return ts_nomem(&sim->error);
}

static enum ts_status make_state(struct tsim *sim, struct ts_mesh_surface *s, const struct ts_place *where)
{
	const struct ts_mesh *m = &s->mesh;
	enum ts_mesh_nodes_fault fault;
	struct ts_mesh_worn *w;
	size_t t;

	if (s->worn)
		return TS_OK;
	w = s->worn = ts_alloc(1, sizeof *w);
	if (!w || ts_mesh_nodes_build(&w->nodes, m, &fault, &t) != TS_OK)
		return fail_without_memory(sim, s);
	if (fault) {
		ts_mesh_recede_release(s);
		return ts_fail(&sim->error, TS_STATE, where,
			       "mesh %s cannot recede: its triangle %zu at (%g, %g, %g) %s; separate these "
			       "surfaces into several meshes, or repair the mesh",
			       name_of(sim, s), t + 1, m->centre[t][0], m->centre[t][1], m->centre[t][2],
			       topology_texts[fault]);
	}
	w->owed = ts_alloc(m->nvertices, sizeof *w->owed);
	w->given = ts_alloc(m->n, sizeof *w->given);
	w->area = ts_alloc(m->n, sizeof *w->area);
	w->worn = ts_alloc((size_t)w->nodes.parts, sizeof *w->worn);
	w->rim = ts_alloc((size_t)w->nodes.parts, sizeof *w->rim);
	if (!w->owed || !w->given || !w->area || !w->worn || !w->rim)
		return fail_without_memory(sim, s);
	find_rims(s);
	for (t = 0; t < m->n; t++) /* not m->area, which depends on the motion by rounding */
		w->area[t] = triangle_area(corners_of(s)[t]);
	return TS_OK;
}

enum ts_status ts_mesh_recede_check(struct tsim *sim, struct ts_mesh_surface *s,
				    const struct ts_recession *how, const struct ts_place *where)
{
	if (how->layer > 0)
		return ts_fail(&sim->error, TS_STATE, where,
			       "mesh %s: `layer` is for height fields; the nodes of a mesh recede by any "
			       "depth",
			       name_of(sim, s));
	if (how->through == TS_THROUGH_OPEN && isinf(how->thickness))
		return ts_fail(&sim->error, TS_STATE, where,
			       "mesh %s: `through open` needs the `thickness` at which triangles are removed",
			       name_of(sim, s));
	if (s->v && !s->home)
		return ts_fail(&sim->error, TS_STATE, where,
			       "mesh %s cannot recede: with surface_vel or surface_ang_vel its material "
			       "moves along the mesh, away from where it has been worn",
			       name_of(sim, s));
	return make_state(sim, s, where);
}

/* ---- an update ---- */

/* Volumes worn from each part on either side. Fails if a sheet is worn on both. A closed body can be touched on one side
 * only; there contacts with its sharp edges may have normals against that of the triangle to which the edge belongs. */
static enum ts_status add_sides(struct tsim *sim, struct ts_mesh_surface *s, const struct ts_place *where,
				const struct ts_recession_element *e, size_t n)
{
	struct ts_mesh_worn *w = s->worn;

	for (size_t k = 0; k < n; k++) {
		size_t t = e[k].element;
		double front = fmax(0, e[k].due - e[k].back), back = fmax(0, e[k].back);
		double *worn = w->worn[w->nodes.part[t]];

		if (!(e[k].due > 0))
			continue;
		worn[w->nodes.side[t] < 0] += front;
		worn[w->nodes.side[t] > 0] += back;
	}
	for (size_t k = 0; k < n; k++) {
		const double *worn = w->worn[w->nodes.part[e[k].element]];

		if (w->rim[w->nodes.part[e[k].element]] &&
		    fmin(worn[0], worn[1]) > OTHER_SIDE * (worn[0] + worn[1]))
			return ts_fail(&sim->error, TS_STATE, where,
				       "mesh %s is worn on both sides, by volumes of %g and %g, see its "
				       "triangle %zu: it can recede from one side only; make it a closed "
				       "body, or two meshes",
				       name_of(sim, s), worn[0], worn[1], e[k].element + 1);
	}
	return TS_OK;
}

/* The volume of an element: what is taken, and what there is no material for. */
static void take_volume(const struct ts_mesh_worn *w, double thickness, struct ts_recession_element *e)
{
	double most = thickness * w->area[e->element], room = fmax(0, most - w->given[e->element]);
	double due = e->due > ROUNDING * w->given[e->element] ? e->due : 0;

	e->taken = fmin(due, room);
	e->surplus = due - e->taken;
	e->through = w->given[e->element] + e->taken >= most * (1 - 1e-12);
}

/* A third of the volume of each element to each of its nodes. */
static void share_volume(const struct ts_mesh_surface *s, const struct ts_recession_element *e, size_t n,
			 double *volume)
{
	const struct ts_mesh_worn *w = s->worn;

	for (size_t k = 0; k < n; k++) {
		const double *worn = w->worn[w->nodes.part[e[k].element]];

		for (int c = 0; c < 3 && e[k].taken > 0; c++)
			volume[s->mesh.vertex[e[k].element][c]] +=
				(worn[1] > worn[0] ? -1 : 1) * e[k].taken / 3;
	}
	for (size_t v = 0; v < w->nodes.n; v++)
		if (volume[v] > 0 || volume[v] < 0)
			volume[v] += w->owed[v];
}

static enum ts_status refuse_fold(struct tsim *sim, const struct ts_mesh_surface *s,
				  const struct ts_place *where, const struct ts_mesh_recession_finding *f)
{
	const double *at = s->mesh.centre[f->triangle];
	const char *id = name_of(sim, s);
	char other[48] = "";

	if (f->fault == TS_MESH_RECESSION_FOLDED || f->fault == TS_MESH_RECESSION_PIERCED)
		snprintf(other, sizeof other, ", triangle %zu", f->other + 1);
	return ts_fail(&sim->error, TS_PHYSICS, where,
		       "mesh %s: triangle %zu at (%g, %g, %g) %s%s, if it receded by the volume worn; evolve "
		       "in smaller steps, end the wear earlier by `thickness`, or remesh this part with "
		       "larger triangles",
		       id, f->triangle + 1, at[0], at[1], at[2], ts_mesh_recession_texts[f->fault], other);
}

/* After a change of the reference positions, or of the positions if the mesh has never moved: renews what depends on
 * them. `farthest`: a corner has moved at most this far, length. */
static enum ts_status renew(struct tsim *sim, struct ts_mesh_surface *s, double farthest)
{
	double most = 0;

	if (s->home)
		ts_mesh_surface_place(sim, s);
	else
		ts_mesh_update_geometry(&s->mesh);
	for (size_t c = 0; c < 3 * s->mesh.n; c++)
		for (int d = 0; d < 3; d++)
			most = fmax(most, fabs(s->mesh.x[c / 3][c % 3][d]));
	s->mesh.loose += 0x1p-51 * most; /* corners of one vertex are rounded each for itself */
	s->travelled += farthest + 0x1p-50 * most;
	s->moves++;
	return ts_mesh_update_active(&s->mesh) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* Makes the new positions those of the mesh. */
static enum ts_status accept_positions(struct tsim *sim, struct ts_mesh_surface *s, const double (*to)[3][3],
				       const double *volume, const double *swept)
{
	double(*x)[3][3] = corners_of(s), farthest = 0;

	for (size_t v = 0; v < s->worn->nodes.n; v++)
		if (volume[v] > 0 || volume[v] < 0)
			s->worn->owed[v] = volume[v] - swept[v];
	for (size_t c = 0; c < 3 * s->mesh.n; c++) {
		farthest = fmax(farthest, ts_distance2(to[c / 3][c % 3], x[c / 3][c % 3]));
		ts_scale(1, to[c / 3][c % 3], x[c / 3][c % 3]);
	}
	return farthest > 0 ? renew(sim, s, sqrt(farthest)) : TS_OK;
}

struct update {
	double *volume, *swept; /* [nodes] */
	double (*to)[3][3];
};

static enum ts_status move_nodes(struct tsim *sim, struct ts_mesh_surface *s, const struct ts_place *where,
				 const struct update *u)
{
	const double(*from)[3][3] = (const double(*)[3][3])corners_of(s);
	struct ts_mesh_recession_finding f;

	if (ts_mesh_recession(&s->mesh, &s->worn->nodes, from, u->volume, u->to, u->swept, &f) != TS_OK)
		return ts_nomem(&sim->error);
	if (f.fault)
		return refuse_fold(sim, s, where, &f);
	return accept_positions(sim, s, (const double(*)[3][3])u->to, u->volume, u->swept);
}

/* A triangle without area cannot lose volume. */
static enum ts_status check_areas(struct tsim *sim, const struct ts_mesh_surface *s,
				  const struct ts_place *where, const struct ts_recession_element *e,
				  size_t n)
{
	for (size_t k = 0; k < n; k++)
		if (e[k].due > 0 && !(s->mesh.area[e[k].element] > 0))
			return ts_fail(&sim->error, TS_PHYSICS, where,
				       "mesh %s: a volume of %g is worn from triangle %zu, which has no area",
				       name_of(sim, s), e[k].due, e[k].element + 1);
	return TS_OK;
}

/* Takes what has been found out for the elements from the geometry. */
static enum ts_status take_from_geometry(struct tsim *sim, struct ts_mesh_surface *s,
					 const struct ts_place *where, const struct ts_recession_element *e,
					 size_t n)
{
	struct update u = { ts_alloc(s->worn->nodes.n, sizeof *u.volume),
			    ts_alloc(s->worn->nodes.n, sizeof *u.swept), ts_alloc(s->mesh.n, sizeof *u.to) };
	enum ts_status status = u.volume && u.swept && u.to ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK) {
		share_volume(s, e, n, u.volume);
		status = move_nodes(sim, s, where, &u);
	}
	for (size_t k = 0; k < n && status == TS_OK; k++)
		s->worn->given[e[k].element] += e[k].taken;
	ts_free(u.volume);
	ts_free(u.swept);
	ts_free(u.to);
	return status;
}

/* Removes the elements that are worn through. */
static enum ts_status open_triangles(struct tsim *sim, struct ts_mesh_surface *s,
				     const struct ts_recession_element *e, size_t n)
{
	bool any = false;

	for (size_t k = 0; k < n; k++)
		if (e[k].through && !ts_mesh_is_removed(&s->mesh, e[k].element)) {
			s->mesh.active[e[k].element] |= TS_MESH_REMOVED;
			any = true;
		}
	if (!any)
		return TS_OK;
	find_rims(s);
	return ts_mesh_update_active(&s->mesh) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_mesh_recede(struct tsim *sim, struct ts_mesh_surface *s, const struct ts_recession *how,
			      const struct ts_place *where, struct ts_recession_element *e, size_t n)
{
	double all = 0;

	TS_TRY(make_state(sim, s, where));
	TS_TRY(check_areas(sim, s, where, e, n));
	TS_TRY(add_sides(sim, s, where, e, n));
	for (size_t k = 0; k < n; k++) {
		take_volume(s->worn, how->thickness, &e[k]);
		all += e[k].taken;
	}
	if (all > 0) {
		s->worn->used = true;
		TS_TRY(take_from_geometry(sim, s, where, e, n));
	}
	return how->through == TS_THROUGH_OPEN ? open_triangles(sim, s, e, n) : TS_OK;
}

/* ---- saved state ---- */

static enum ts_status archive_places(struct ts_mesh_surface *s, struct ts_archive *a)
{
	TS_TRY(ts_archive_fixed(a, "worn active", TS_SAVED_U8, s->mesh.active, s->mesh.n));
	TS_TRY(ts_archive_fixed(a, "worn loose", TS_SAVED_F64, &s->mesh.loose, 1));
	if (s->home) /* saved with the motions */
		return TS_OK;
	TS_TRY(ts_archive_fixed(a, "worn corners", TS_SAVED_F64, s->mesh.x, 9 * s->mesh.n));
	TS_TRY(ts_archive_fixed(a, "travelled", TS_SAVED_F64, &s->travelled, 1));
	if (ts_archive_writing(a))
		return TS_OK;
	ts_mesh_update_geometry(&s->mesh);
	s->moves++;
	return TS_OK;
}

enum ts_status ts_mesh_recede_archive(struct ts_mesh_surface *s, struct tsim *sim, struct ts_archive *a)
{
	struct ts_mesh_worn *w;

	if (ts_archive_writing(a) ? !s->worn || !s->worn->used : !ts_archive_has(a, "worn area"))
		return TS_OK;
	TS_TRY(make_state(sim, s, NULL));
	w = s->worn;
	w->used = true;
	TS_TRY(ts_archive_fixed(a, "worn area", TS_SAVED_F64, w->area, s->mesh.n));
	TS_TRY(ts_archive_fixed(a, "worn given", TS_SAVED_F64, w->given, s->mesh.n));
	TS_TRY(ts_archive_fixed(a, "worn owed", TS_SAVED_F64, w->owed, w->nodes.n));
	TS_TRY(ts_archive_fixed(a, "worn sides", TS_SAVED_F64, w->worn, 2 * (size_t)w->nodes.parts));
	TS_TRY(archive_places(s, a));
	find_rims(s);
	return TS_OK;
}
