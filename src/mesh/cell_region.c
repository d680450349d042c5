#include "mesh/cell_region.h"

#include <math.h>
#include <string.h>

#include "geom/motion.h"
#include "math/constants.h"
#include "mesh/mesh_read.h"

#include "base/banned.h"

enum { TETRAHEDRON = 10, HEXAHEDRON = 12 };

/* Tetrahedra of a cell, by its corners. A hexahedron is split along the diagonal from corner 0 to 6. */
static const int tetrahedron_parts[][4] = { { 0, 1, 2, 3 } };
static const int hexahedron_parts[][4] = { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 },
					   { 0, 7, 4, 6 }, { 0, 4, 5, 6 }, { 0, 5, 1, 6 } };

static double signed_volume(const double a[3], const double b[3], const double c[3], const double d[3])
{
	double u[3], v[3], w[3], across[3];

	ts_sub(b, a, u);
	ts_sub(c, a, v);
	ts_sub(d, a, w);
	ts_cross(u, v, across);
	return ts_dot(across, w) / 6;
}

static void find_turn(const struct ts_cell_region *r, struct ts_motion turn[3])
{
	for (int d = 0; d < 3; d++) {
		turn[d] = ts_motion_none();
		ts_motion_set_turn(&turn[d], (double[3]){ d == 0, d == 1, d == 2 },
				   r->angle[d] * TS_PI / 180);
	}
}

static void transform_point(const struct ts_cell_region *r, const struct ts_motion turn[3],
			    const double given[3], double x[3])
{
	for (int d = 0; d < 3; d++)
		x[d] = r->factor * (given[d] * r->region.scale[d] + r->offset[d] * r->region.scale[d]);
	for (int d = 0; d < 3; d++)
		ts_motion_apply(&turn[d], x, x);
}

static enum ts_status add_tetrahedron(struct ts_cell_region *r, struct tsim *sim,
				      const struct ts_motion turn[3], const struct ts_vtk_cells *cells,
				      size_t k, const int part[4])
{
	struct ts_cell_region_tet *t;

	if (TS_GROW(r->tet, r->capacity, r->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	t = &r->tet[r->n++];
	for (int c = 0; c < 4; c++) {
		transform_point(r, turn, cells->point[cells->corner[cells->offset[k] + part[c]]], t->x[c]);
		for (int d = 0; d < 3; d++) {
			r->lo[d] = fmin(r->lo[d], t->x[c][d]);
			r->hi[d] = fmax(r->hi[d], t->x[c][d]);
		}
	}
	r->volume += fabs(signed_volume(t->x[0], t->x[1], t->x[2], t->x[3]));
	return TS_OK;
}

/* VTK's points, lines and surface cells, which mesh generators write besides the solid cells. */
static bool has_no_volume(int type)
{
	return type >= 1 && type <= 9;
}

static enum ts_status take_cells(struct ts_instance *self, struct tsim *sim, const struct ts_vtk_cells *cells,
				 int shape)
{
	struct ts_cell_region *r = self->state;
	bool tet = shape == TETRAHEDRON;
	struct ts_motion turn[3];

	r->n = 0;
	r->volume = 0;
	find_turn(r, turn);
	for (int d = 0; d < 3; d++) {
		r->lo[d] = INFINITY;
		r->hi[d] = -INFINITY;
	}
	for (size_t k = 0; k < cells->ncells; k++) {
		if (has_no_volume(cells->type[k]))
			continue;
		if (cells->type[k] != shape || cells->offset[k + 1] - cells->offset[k] != (tet ? 4 : 8))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, r->file),
				       "region %s: cell %zu of '%s' is of type %d, expected %s only",
				       self->style->name, k + 1, r->file, cells->type[k],
				       tet ? "tetrahedra (10)" : "hexahedra (12)");
		for (int p = 0; p < (tet ? 1 : 6); p++)
			TS_TRY(add_tetrahedron(r, sim, turn, cells, k,
					       tet ? tetrahedron_parts[p] : hexahedron_parts[p]));
	}
	if (r->n)
		return TS_OK;
	return ts_fail(&sim->error, TS_DAMAGED, ts_instance_word(self, r->file),
		       "region %s: '%s' has no cell with a volume", self->style->name, r->file);
}

/* The file has solid cells of this shape only: take_cells. */
static enum ts_status make_surface(struct ts_instance *self, struct tsim *sim,
				   const struct ts_vtk_cells *cells, int shape)
{
	struct ts_cell_region *r = self->state;
	int corners = shape == TETRAHEDRON ? 4 : 8;
	size_t n = r->n / (shape == TETRAHEDRON ? 1 : 6), k = 0;
	double(*x)[3] = ts_alloc_unset(n * (size_t)corners, sizeof *x), longest = 0;
	enum ts_status status = TS_NOMEM;
	struct ts_motion turn[3];

	find_turn(r, turn);
	for (size_t c = 0; x && c < cells->ncells; c++)
		for (int64_t p = cells->offset[c]; p < cells->offset[c + 1] && !has_no_volume(cells->type[c]);
		     p++)
			transform_point(r, turn, cells->point[cells->corner[p]], x[k++]);
	for (int d = 0; d < 3; d++)
		longest = fmax(longest, r->hi[d] - r->lo[d]);
	if (x)
		status = ts_cell_surface_build(&r->surface, (const double(*)[3])x, n, corners,
					       longest > 0 ? 1e-7 * longest : 1);
	ts_free(x);
	if (status != TS_RANGE)
		return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, r->file),
		       "region %s: '%s' has too many cells", self->style->name, r->file);
}

/* ---- the grid ---- */

static int grid_index(const struct ts_cell_region *r, int d, double x)
{
	double length = r->hi[d] - r->lo[d];
	double at = length > 0 ? (x - r->lo[d]) / length * r->grid[d] : 0;

	return (int)fmin(fmax(at, 0), r->grid[d] - 1);
}

/* For each grid cell that overlaps the bounding box of tetrahedron k: increments its count (item NULL), or
 * enters k in its list. */
static void enter_in_grid(const struct ts_cell_region *r, size_t k, uint32_t *count, int32_t *item)
{
	int from[3], to[3], c[3];

	for (int d = 0; d < 3; d++) {
		double lo = INFINITY, hi = -INFINITY;

		for (int p = 0; p < 4; p++) {
			lo = fmin(lo, r->tet[k].x[p][d]);
			hi = fmax(hi, r->tet[k].x[p][d]);
		}
		from[d] = grid_index(r, d, lo);
		to[d] = grid_index(r, d, hi);
	}
	for (c[0] = from[0]; c[0] <= to[0]; c[0]++)
		for (c[1] = from[1]; c[1] <= to[1]; c[1]++)
			for (c[2] = from[2]; c[2] <= to[2]; c[2]++) {
				size_t cell = ((size_t)c[0] * (size_t)r->grid[1] + (size_t)c[1]) *
						      (size_t)r->grid[2] +
					      (size_t)c[2];

				if (item)
					item[count[cell]++] = (int32_t)k;
				else
					count[cell]++;
			}
}

/* Counting sort. Counts are stored with an offset of two, so that after the lists are filled start[c] is
 * the first item of cell c. */
static enum ts_status make_grid(struct ts_cell_region *r, struct tsim *sim)
{
	int side = (int)fmin(fmax(cbrt((double)r->n), 1), 100);
	size_t cells = (size_t)(side * side * side);

	for (int d = 0; d < 3; d++)
		r->grid[d] = side;
	ts_free(r->start);
	r->start = ts_alloc(cells + 2, sizeof *r->start);
	if (!r->start)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < r->n; k++)
		enter_in_grid(r, k, r->start + 2, NULL);
	for (size_t k = 2; k < cells + 2; k++)
		r->start[k] += r->start[k - 1];
	r->item = ts_alloc(r->start[cells + 1], sizeof *r->item);
	if (!r->item)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < r->n; k++)
		enter_in_grid(r, k, r->start + 1, r->item);
	return TS_OK;
}

/* ---- slots ---- */

enum ts_status ts_cell_region_init(struct ts_instance *self, struct tsim *sim, int shape)
{
	struct ts_cell_region *r = self->state;
	struct ts_vtk_cells cells = { 0 };
	enum ts_status status;

	TS_TRY(ts_region_init(self, sim));
	r->closed = shape == HEXAHEDRON;
	if (r->item)
		return TS_OK;
	status = ts_vtk_cells_read(&cells, &sim->files, &sim->error, sim->pool,
				   ts_instance_word(self, r->file), r->file);
	if (status == TS_OK)
		status = take_cells(self, sim, &cells, shape);
	if (status == TS_OK)
		status = make_surface(self, sim, &cells, shape);
	ts_vtk_cells_release(&cells);
	return status == TS_OK ? make_grid(r, sim) : status;
}

/* Whether x is in the tetrahedron: on the same side of each face as the opposite corner; `closed`: or in
 * the face. */
static bool tet_contains(const struct ts_cell_region_tet *t, const double x[3], bool closed)
{
	double all = signed_volume(t->x[0], t->x[1], t->x[2], t->x[3]);
	const double *c[4] = { t->x[0], t->x[1], t->x[2], t->x[3] };

	for (int k = 0; k < 4; k++) {
		const double *was = c[k];
		double part;

		c[k] = x;
		part = signed_volume(c[0], c[1], c[2], c[3]);
		c[k] = was;
		part *= all < 0 ? -1 : 1;
		if (part < 0 || (part <= 0 && !closed))
			return false;
	}
	return true;
}

static bool contains(const struct ts_cell_region *r, const double x[3], bool closed)
{
	size_t cell = 0;

	for (int d = 0; d < 3; d++) {
		if (!(x[d] >= r->lo[d] && x[d] <= r->hi[d]))
			return false;
		cell = cell * (size_t)r->grid[d] + (size_t)grid_index(r, d, x[d]);
	}
	for (uint32_t k = r->start[cell]; k < r->start[cell + 1]; k++)
		if (tet_contains(&r->tet[r->item[k]], x, closed))
			return true;
	return false;
}

bool ts_cell_region_contains(const struct ts_instance *self, const double x[3])
{
	const struct ts_cell_region *r = self->state;

	return contains(r, x, r->closed);
}

double ts_cell_region_depth(const struct ts_instance *self, const double x[3])
{
	const struct ts_cell_region *r = self->state;
	double distance = ts_cell_surface_distance(&r->surface, x);

	return contains(r, x, true) ? distance : -distance;
}

void ts_cell_region_bounds(const struct ts_instance *self, double lo[3], double hi[3])
{
	const struct ts_cell_region *r = self->state;

	memcpy(lo, r->lo, sizeof r->lo);
	memcpy(hi, r->hi, sizeof r->hi);
}

double ts_cell_region_volume(const struct ts_instance *self)
{
	return ((const struct ts_cell_region *)self->state)->volume;
}

void ts_cell_region_fini(struct ts_instance *self)
{
	struct ts_cell_region *r = self->state;

	ts_free(r->tet);
	ts_free(r->start);
	ts_free(r->item);
	ts_cell_surface_release(&r->surface);
}
