#include "flow/flow_measures.h"

#include "region/region.h"

#include "base/banned.h"

const char *const ts_flow_face_names[] = { "xlo", "xhi", "ylo", "yhi", "zlo", "zhi", NULL };

static double row_energy(const struct ts_fluid *fluid, int j, int k)
{
	const struct ts_grid *grid = &fluid->grid;
	double sum = 0;

	for (int i = 0; i < grid->n[0]; i++) {
		size_t at = ts_at(grid, i, j, k);
		double squares = 0;

		for (int d = 0; d < grid->dimensions; d++) {
			const double *u = fluid->u[d] + at;

			squares += u[0] * u[0] + u[grid->stride[d]] * u[grid->stride[d]];
		}
		sum += 0.25 * squares * ts_grid_volume(grid, i, j, k) *
		       (fluid->void_fraction ? fluid->void_fraction[at] : 1);
	}
	return sum;
}

/* Sum of e u on the two faces of a cell across axis d. With the e of the cell the sum over all cells is
 * the same, since e of a face is the mean of the halves of two cells. */
static double cell_face_flows(const struct ts_fluid *fluid, int d, size_t low)
{
	const size_t high = low + (size_t)fluid->grid.stride[d];
	const double *u = fluid->u[d], *e = fluid->momentum_void_fraction[d];

	if (e)
		return e[low] * u[low] + e[high] * u[high];
	return (fluid->void_fraction ? fluid->void_fraction[low] : 1) * (u[low] + u[high]);
}

double ts_flow_momentum(const struct ts_fluid *fluid, int d)
{
	const struct ts_grid *grid = &fluid->grid;
	double sum = 0;

	for (int k = 0; k < grid->n[2] && d < grid->dimensions; k++)
		for (int j = 0; j < grid->n[1]; j++) {
			double row = 0;

			for (int i = 0; i < grid->n[0]; i++)
				row += grid->width[0][i] * cell_face_flows(fluid, d, ts_at(grid, i, j, k));
			sum += row * grid->width[1][j] * grid->width[2][k];
		}
	return 0.5 * fluid->density * sum;
}

double ts_flow_kinetic_energy(const struct ts_fluid *fluid)
{
	double total = 0;

	for (int k = 0; k < fluid->grid.n[2]; k++) {
		double plane = 0;

		for (int j = 0; j < fluid->grid.n[1]; j++)
			plane += row_energy(fluid, j, k);
		total += plane;
	}
	return fluid->density * total;
}

void ts_flow_centre_velocity(const struct ts_fluid *fluid, const int cell[3], double u[3])
{
	const struct ts_grid *grid = &fluid->grid;
	size_t at = ts_at(grid, cell[0], cell[1], cell[2]);

	u[2] = 0;
	for (int d = 0; d < grid->dimensions; d++)
		u[d] = 0.5 * (fluid->u[d][at] + fluid->u[d][at + (size_t)grid->stride[d]]);
}

double ts_flow_edge_vorticity(const struct ts_fluid *fluid, int a, const int cell[3])
{
	const struct ts_grid *grid = &fluid->grid;
	int b = (a + 1) % 3, c = (a + 2) % 3;
	ptrdiff_t at = (ptrdiff_t)ts_at(grid, cell[0], cell[1], cell[2]);
	double w = 0;

	if (b < grid->dimensions)
		w += (fluid->u[c][at] - fluid->u[c][at - grid->stride[b]]) / grid->gap[b][cell[b]];
	if (c < grid->dimensions)
		w -= (fluid->u[b][at] - fluid->u[b][at - grid->stride[c]]) / grid->gap[c][cell[c]];
	return w;
}

void ts_flow_centre_vorticity(const struct ts_fluid *fluid, const int cell[3], double w[3])
{
	int dimensions = fluid->grid.dimensions;

	for (int a = 0; a < 3; a++) {
		int b = (a + 1) % 3, c = (a + 2) % 3;

		w[a] = 0;
		for (int corner = 0; corner < 4 && (dimensions == 3 || a == 2); corner++) {
			int edge[3] = { cell[0], cell[1], cell[2] };

			edge[b] += corner & 1;
			edge[c] += corner >> 1;
			w[a] += 0.25 * ts_flow_edge_vorticity(fluid, a, edge);
		}
	}
}

static bool in_region(const struct ts_instance *region, int d, double x, const double other[2])
{
	double place[3];

	if (!region)
		return true;
	place[d] = x;
	place[(d + 1) % 3] = other[0];
	place[(d + 2) % 3] = other[1];
	return ts_region_contains(region, place);
}

static double face_flow(const struct ts_fluid *fluid, int d, size_t at)
{
	return fluid->u[d][at] * (fluid->void_fraction_face[d] ? fluid->void_fraction_face[d][at] : 1);
}

static void sum_flux(const struct ts_fluid *fluid, int d, double x, const struct ts_instance *region,
		     struct ts_flow_flux_sums *out)
{
	const struct ts_grid *grid = &fluid->grid;
	int b = (d + 1) % 3, c = (d + 2) % 3, cell[3];
	double part;

	*out = (struct ts_flow_flux_sums){ 0 };
	cell[d] = ts_grid_find(grid, d, x);
	if (d >= grid->dimensions || cell[d] < 0)
		return;
	part = (x - grid->face[d][cell[d]]) / grid->width[d][cell[d]];
	for (cell[c] = 0; cell[c] < grid->n[c]; cell[c]++) {
		double row = 0, area = 0;

		for (cell[b] = 0; cell[b] < grid->n[b]; cell[b]++) {
			const double other[2] = { grid->centre[b][cell[b]], grid->centre[c][cell[c]] };
			size_t at = ts_at(grid, cell[0], cell[1], cell[2]);
			double a = grid->width[b][cell[b]] * grid->width[c][cell[c]];

			if (!in_region(region, d, x, other))
				continue;
			area += a;
			row += a * ((1 - part) * face_flow(fluid, d, at) +
				    part * face_flow(fluid, d, at + (size_t)grid->stride[d]));
		}
		out->flux += row;
		out->area += area;
	}
}

enum ts_status ts_flow_flux(const struct ts_fluid *fluid, struct tsim *sim, int d, double x,
			    struct ts_instance *region, struct ts_flow_flux_sums *out)
{
	TS_TRY(ts_region_update(region, sim));
	sum_flux(fluid, d, x, region, out);
	return TS_OK;
}

/* A face of the grid and the first layer of cells inside. */
struct edge {
	const struct ts_fluid *fluid;
	int d;
	int cell;	   /* index of these cells along d */
	ptrdiff_t outward; /* stride to the ghosts */
	double sign;	   /* of the outward normal along d */
	const struct ts_instance *region;
};

/* Pressure on the face itself. */
static double face_pressure(const struct edge *e, const int cell[3], ptrdiff_t at)
{
	const struct ts_grid *grid = &e->fluid->grid;
	const double *p = e->fluid->p, *width = grid->width[e->d];
	int inward = e->sign > 0 ? -1 : 1;

	if (ts_flow_face_open(e->fluid->face[e->d][e->sign > 0]))
		return e->fluid->pressure_base +
		       ts_flow_face_pressure_at(&e->fluid->pressure[e->d][e->sign > 0],
						ts_flow_plane_at(grid, e->d, cell[e->d == 0],
								 cell[e->d == 2 ? 1 : 2]));
	if (grid->n[e->d] < 2)
		return p[at];
	return p[at] +
	       (p[at] - p[at - e->outward]) * width[e->cell] / (width[e->cell] + width[e->cell + inward]);
}

static void add_pressure(const struct edge *e, struct ts_flow_face_load *out)
{
	const struct ts_grid *grid = &e->fluid->grid;
	int b = (e->d + 1) % 3, c = (e->d + 2) % 3, cell[3];

	cell[e->d] = e->cell;
	for (cell[c] = 0; cell[c] < grid->n[c]; cell[c]++) {
		double row = 0;

		for (cell[b] = 0; cell[b] < grid->n[b]; cell[b]++) {
			const double other[2] = { grid->centre[b][cell[b]], grid->centre[c][cell[c]] };
			double area = grid->width[b][cell[b]] * grid->width[c][cell[c]];
			double x = grid->face[e->d][e->cell + (e->sign > 0)];

			if (!in_region(e->region, e->d, x, other))
				continue;
			out->area += area;
			row += area *
			       face_pressure(e, cell, (ptrdiff_t)ts_at(grid, cell[0], cell[1], cell[2]));
		}
		out->pressure[e->d] += e->sign * row;
	}
}

/* Length along t that belongs to the velocity point on the lower face of a cell: half of each cell beside it that is in the
 * grid, and whose centre is in the region. */
static double point_length(const struct edge *e, int t, const int cell[3])
{
	const struct ts_grid *grid = &e->fluid->grid;
	int b = (e->d + 1) % 3, c = (e->d + 2) % 3, beside[3] = { cell[0], cell[1], cell[2] };
	double x = grid->face[e->d][e->cell + (e->sign > 0)], width[2] = { 0 };

	for (int high = 0; high < 2; high++) {
		int i = cell[t] - 1 + high;

		if (!grid->periodic[t] && (i < 0 || i >= grid->n[t]))
			continue;
		beside[t] = i < 0 ? grid->n[t] - 1 : i;
		if (in_region(e->region, e->d, x,
			      (const double[]){ grid->centre[b][beside[b]], grid->centre[c][beside[c]] }))
			width[high] = grid->width[t][i];
	}
	return 0.5 * (width[0] + width[1]);
}

/* Adds the shear force of component t, which is stored on the faces across t. */
static void add_shear(const struct edge *e, int t, struct ts_flow_face_load *out)
{
	const struct ts_grid *grid = &e->fluid->grid;
	int c = 3 - e->d - t, cell[3];
	const double *u = e->fluid->u[t];
	double gap = grid->gap[e->d][e->cell + (e->sign > 0)];

	cell[e->d] = e->cell;
	for (cell[c] = 0; cell[c] < grid->n[c]; cell[c]++) {
		double row = 0;

		for (cell[t] = 0; cell[t] < grid->n[t] + !grid->periodic[t]; cell[t]++) {
			ptrdiff_t at = (ptrdiff_t)ts_at(grid, cell[0], cell[1], cell[2]);
			double length = point_length(e, t, cell);

			if (length > 0)
				row += length * grid->width[c][cell[c]] *
				       (e->fluid->void_fraction_face[t] ? e->fluid->void_fraction_face[t][at]
									: 1) *
				       (u[at] - u[at + e->outward]) / gap;
		}
		out->shear[t] += e->fluid->viscosity * row;
	}
}

enum ts_status ts_flow_face_force(const struct ts_fluid *fluid, struct tsim *sim, int d,
				  enum ts_grid_side side, struct ts_instance *region,
				  struct ts_flow_face_load *out)
{
	const struct ts_grid *grid = &fluid->grid;
	bool high = side == TS_HIGH;
	struct edge e = {
		fluid,	       d,     high ? grid->n[d] - 1 : 0, high ? grid->stride[d] : -grid->stride[d],
		high ? 1 : -1, region
	};

	*out = (struct ts_flow_face_load){ 0 };
	if (d >= grid->dimensions)
		return TS_OK;
	TS_TRY(ts_region_update(region, sim));
	add_pressure(&e, out);
	for (int t = 0; t < grid->dimensions; t++)
		if (t != d)
			add_shear(&e, t, out);
	return TS_OK;
}
