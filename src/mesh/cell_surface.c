#include "mesh/cell_surface.h"

#include <math.h>

#include "base/alloc.h"
#include "base/sort.h"
#include "geom/pointhash.h"
#include "math/vec3.h"
#include "mesh/mesh_distance.h"

#include "base/banned.h"

enum { MOST_SIDES = 4, MOST_CORNERS = 8 };

/* The faces of a cell. Quadrangles begin with corner 0 or 6, from which they are split: region mesh/hex splits the cell along the
 * diagonal between these. */
struct cell_kind {
	int faces, sides, corners;
	int face[6][MOST_SIDES];
};

static const struct cell_kind tetrahedron = {
	4, 3, 4, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } }
};
static const struct cell_kind hexahedron = {
	6,
	4,
	8,
	{ { 0, 1, 2, 3 }, { 0, 3, 7, 4 }, { 0, 4, 5, 1 }, { 6, 5, 1, 2 }, { 6, 2, 3, 7 }, { 6, 7, 4, 5 } }
};

/* A face of one cell. Faces of the same vertices are one face of the union. */
struct face {
	int32_t vertex[MOST_SIDES]; /* in ascending order, each once; then INT32_MAX */
	int32_t cell;
	int8_t of_cell; /* which face of it */
	int8_t side; /* on which side of it the cell is, if seen from a side that depends on the vertices only; 0: no volume */
};

static int by_vertices(const void *a, const void *b)
{
	const struct face *f = a, *g = b;

	for (int k = 0; k < MOST_SIDES; k++)
		if (f->vertex[k] != g->vertex[k])
			return f->vertex[k] < g->vertex[k] ? -1 : 1;
	if (f->cell != g->cell)
		return f->cell < g->cell ? -1 : 1;
	return (f->of_cell > g->of_cell) - (f->of_cell < g->of_cell);
}

/* The number of each corner: that of the first one at its place. */
static enum ts_status number_vertices(const double (*x)[3], size_t n, double precision, int32_t *vertex,
				      struct ts_pointhash *found)
{
	TS_TRY(ts_pointhash_start(found, precision));
	for (size_t k = 0; k < n; k++) {
		vertex[k] = ts_pointhash_find(found, x[k], precision);
		if (vertex[k] >= 0)
			continue;
		vertex[k] = (int32_t)found->n;
		TS_TRY(ts_pointhash_add(found, x[k]));
	}
	return TS_OK;
}

/* Inserts v into the ascending list, unless it has it. */
static void insert_vertex(int32_t list[MOST_SIDES], int32_t v)
{
	for (int k = 0; k < MOST_SIDES && v != list[k]; k++) {
		int32_t was = list[k];

		if (v > was)
			continue;
		list[k] = v;
		v = was;
	}
}

/* On which side of the triangle of the three first vertices the centre of the cell is. */
static int8_t side_of_cell(const struct face *f, const double (*place)[3], const double (*x)[3], int corners)
{
	const double *at = place[f->vertex[0]];
	double u[3], v[3], w[3], centre[3] = { 0 }, height;

	for (int c = 0; c < corners; c++)
		ts_axpy(1.0 / corners, x[c], centre);
	ts_sub(place[f->vertex[1]], at, u);
	ts_sub(place[f->vertex[2]], at, v);
	ts_cross(u, v, w);
	ts_sub(centre, at, u);
	height = ts_dot(u, w);
	return (int8_t)((height > 0) - (height < 0));
}

static size_t list_faces(const struct cell_kind *kind, const double (*x)[3], size_t n, const int32_t *vertex,
			 const double (*place)[3], struct face *face)
{
	size_t nfaces = 0;

	for (size_t c = 0; c < n; c++)
		for (int k = 0; k < kind->faces; k++) {
			const size_t first = c * (size_t)kind->corners;
			struct face f = { .cell = (int32_t)c, .of_cell = (int8_t)k };

			for (int s = 0; s < MOST_SIDES; s++)
				f.vertex[s] = INT32_MAX;
			for (int s = 0; s < kind->sides; s++)
				insert_vertex(f.vertex, vertex[first + (size_t)kind->face[k][s]]);
			if (f.vertex[2] == INT32_MAX) /* a line */
				continue;
			f.side = side_of_cell(&f, place, x + first, kind->corners);
			if (f.side)
				face[nfaces++] = f;
		}
	return nfaces;
}

/* Keeps one of the equal faces if all of their cells are on one side. */
static size_t keep_surface(struct face *face, size_t n)
{
	size_t kept = 0;

	for (size_t k = 0, next; k < n; k = next) {
		bool one_side = true;

		for (next = k + 1; next < n; next++) {
			bool same = true;

			for (int s = 0; s < MOST_SIDES; s++)
				same &= face[next].vertex[s] == face[k].vertex[s];
			if (!same)
				break;
			one_side &= face[next].side == face[k].side;
		}
		if (one_side)
			face[kept++] = face[k];
	}
	return kept;
}

static size_t split_faces(const struct cell_kind *kind, const double (*x)[3], const struct face *face,
			  size_t n, double (*soup)[3][3])
{
	size_t triangles = 0;

	for (size_t k = 0; k < n; k++) {
		const double(*of_cell)[3] = x + (size_t)face[k].cell * (size_t)kind->corners;
		const int *corner = kind->face[face[k].of_cell];

		for (int s = 2; s < kind->sides; s++, triangles++) {
			ts_scale(1, of_cell[corner[0]], soup[triangles][0]);
			ts_scale(1, of_cell[corner[s - 1]], soup[triangles][1]);
			ts_scale(1, of_cell[corner[s]], soup[triangles][2]);
		}
	}
	return triangles;
}

static enum ts_status build_mesh(struct ts_cell_surface *surface, const struct cell_kind *kind,
				 const double (*x)[3], const struct face *face, size_t n, double precision)
{
	double(*soup)[3][3] = ts_alloc_unset(n * 2, sizeof *soup);
	enum ts_status status = TS_NOMEM;

	if (soup)
		status = ts_mesh_build(&surface->mesh, (const double(*)[3][3])soup,
				       split_faces(kind, x, face, n, soup), precision, 0);
	ts_free(soup);
	if (status == TS_OK)
		status = ts_mesh_tree_build(&surface->tree, &surface->mesh);
	return status;
}

enum ts_status ts_cell_surface_build(struct ts_cell_surface *surface, const double (*x)[3], size_t n,
				     int corners, double precision)
{
	const struct cell_kind *kind = corners == 4 ? &tetrahedron : &hexahedron;
	struct ts_pointhash found = { 0 };
	enum ts_status status = TS_RANGE;
	struct face *face = NULL;
	int32_t *vertex = NULL;

	*surface = (struct ts_cell_surface){ 0 };
	if (n <= INT32_MAX / MOST_CORNERS) {
		face = ts_alloc_unset(n * (size_t)kind->faces, sizeof *face);
		vertex = ts_alloc_unset(n * (size_t)corners, sizeof *vertex);
		status = face && vertex ? number_vertices(x, n * (size_t)corners, precision, vertex, &found)
					: TS_NOMEM;
	}
	if (status == TS_OK) {
		size_t faces = list_faces(kind, x, n, vertex, (const double(*)[3])found.x, face);

		ts_sort(face, faces, sizeof *face, by_vertices);
		status = build_mesh(surface, kind, x, face, keep_surface(face, faces), precision);
	}
	ts_pointhash_release(&found);
	ts_free(face);
	ts_free(vertex);
	if (status != TS_OK)
		ts_cell_surface_release(surface);
	return status;
}

double ts_cell_surface_distance(const struct ts_cell_surface *surface, const double x[3])
{
	return ts_mesh_distance_least(&surface->mesh, &surface->tree, x);
}

void ts_cell_surface_release(struct ts_cell_surface *surface)
{
	ts_mesh_release(&surface->mesh);
	ts_mesh_tree_release(&surface->tree);
}
