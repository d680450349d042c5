#include "geom/pairs.h"

#include <stdbool.h>
#include <stdint.h>

#include "base/alloc.h"

#include "base/banned.h"

/* Cells along one axis, at least as long as the cutoff if there is room. */
struct axis {
	double lo, length, inverse; /* cell = (x - lo) inverse */
	int32_t cells, reach;	    /* neighbours are up to `reach` cells away */
	bool periodic;
};

struct grid {
	struct axis axis[3];
	const struct ts_shear *shear;
	int32_t *start, *list; /* points of cell c: list[start[c]] .. list[start[c + 1] - 1] */
	int32_t (*place)[3];   /* cell of each point, along each axis */
	int32_t (*turns)[3];   /* number of box lengths that a point is outside of the periodic box */
};

static void axis_extent(const struct ts_box *box, const double (*x)[3], size_t n, int dim, bool periodic,
			struct axis *a)
{
	double lo = box->lo[dim], hi = box->hi[dim];

	a->periodic = periodic;
	for (size_t i = 0; !a->periodic && i < n; i++) {
		lo = i ? fmin(lo, x[i][dim]) : x[i][dim];
		hi = i ? fmax(hi, x[i][dim]) : x[i][dim];
	}
	a->lo = lo;
	a->length = hi - lo;
}

static void axis_divide(struct axis *a, size_t n, double cutoff)
{
	double max_cells = 1 + 2 * cbrt((double)n); /* more cells than points do not pay */
	double reach = cutoff * (1 + 1e-9);	    /* margin for rounding of the cell index */
	double cells = fmin(floor(a->length / reach), max_cells);

	a->cells = cells > 1 ? (int32_t)cells : 1;
	a->inverse = a->length > 0 ? a->cells / a->length : 0;
	a->reach = a->length > 0 && (a->periodic || a->cells > 1)
			   ? (int32_t)fmin(ceil(reach * a->inverse), 1e6)
			   : 0;
}

/* Along the flow of a sheared box there is one cell: its images, which the shear displaces, are all visited. */
static void axis_shear(struct axis *a, const struct ts_shear *shear, double cutoff)
{
	double reach = cutoff * (1 + 1e-9) + 2 * fabs(shear->offset);

	a->cells = 1;
	a->inverse = 1 / a->length;
	a->reach = (int32_t)fmin(ceil(reach * a->inverse), 1e6);
}

static void axis_locate(const struct axis *a, double x, int32_t *cell, int32_t *turns)
{
	double at;

	*turns = a->periodic ? (int32_t)floor((x - a->lo) / a->length) : 0;
	at = (x - *turns * a->length - a->lo) * a->inverse;
	*cell = at > 0 ? at < a->cells ? (int32_t)at : a->cells - 1 : 0;
}

static size_t cell_number(const struct grid *g, const int32_t c[3])
{
	return (size_t)c[0] +
	       (size_t)g->axis[0].cells * ((size_t)c[1] + (size_t)g->axis[1].cells * (size_t)c[2]);
}

/* Counting sort of the points by cell. */
static void sort_into_cells(struct grid *g, const double (*x)[3], size_t n)
{
	for (size_t i = 0; i < n; i++) {
		for (int d = 0; d < 3; d++)
			axis_locate(&g->axis[d], x[i][d], &g->place[i][d], &g->turns[i][d]);
		g->start[cell_number(g, g->place[i]) + 2]++;
	}
	for (size_t c = 2;
	     c < 2 + (size_t)g->axis[0].cells * (size_t)g->axis[1].cells * (size_t)g->axis[2].cells; c++)
		g->start[c] += g->start[c - 1];
	for (size_t i = 0; i < n; i++)
		g->list[g->start[cell_number(g, g->place[i]) + 1]++] = (int32_t)i;
}

struct search {
	const struct grid *g;
	const double (*x)[3];
	double cutoff2;
	ts_pair_fn *visit;
	void *context;
};

/* Visits the points of one cell, `image` box lengths away. */
static void visit_cell(const struct search *s, size_t i, const int32_t cell[3], const int32_t image[3])
{
	const struct grid *g = s->g;
	size_t c = cell_number(g, cell);

	for (int32_t k = g->start[c]; k < g->start[c + 1]; k++) {
		size_t j = (size_t)g->list[k];
		double d[3];
		int32_t away = 0, across = 0;

		for (int m = 0; m < 3; m++) {
			int32_t turns = g->turns[i][m] - g->turns[j][m] + image[m];

			away |= turns;
			d[m] = (s->x[i][m] - s->x[j][m]) - turns * g->axis[m].length;
			if (m == g->shear->gradient)
				across = turns;
		}
		if (g->shear->on)
			d[g->shear->flow] -= across * g->shear->offset;
		if ((i != j || away) && d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < s->cutoff2)
			s->visit(s->context, i, j, d);
	}
}

/* Cell at the given offset, and its periodic image; false if there is none. */
static bool neighbor_cell(const struct axis *a, int32_t from, int32_t offset, int32_t *cell, int32_t *image)
{
	int32_t at = from + offset;

	*cell = at;
	*image = 0;
	if (!a->periodic)
		return at >= 0 && at < a->cells;
	*image = at >= 0 ? at / a->cells : -((-at + a->cells - 1) / a->cells);
	*cell = at - *image * a->cells;
	return true;
}

static void search_around(const struct search *s, size_t i)
{
	const struct axis *a = s->g->axis;
	const int32_t *from = s->g->place[i];
	int32_t cell[3], image[3];

	for (int32_t z = -a[2].reach; z <= a[2].reach; z++)
		for (int32_t y = -a[1].reach; y <= a[1].reach; y++)
			for (int32_t x = -a[0].reach; x <= a[0].reach; x++)
				if (neighbor_cell(&a[0], from[0], x, &cell[0], &image[0]) &&
				    neighbor_cell(&a[1], from[1], y, &cell[1], &image[1]) &&
				    neighbor_cell(&a[2], from[2], z, &cell[2], &image[2]))
					visit_cell(s, i, cell, image);
}

enum ts_status ts_pairs_visit(const struct ts_box *box, int dimensions, const double (*x)[3], size_t n,
			      double cutoff, ts_pair_fn *visit, void *context)
{
	struct grid g = { .shear = &box->shear };
	struct search s = { &g, x, cutoff * cutoff, visit, context };
	enum ts_status status = TS_NOMEM;
	size_t cells = 1;

	for (int d = 0; d < 3; d++) {
		axis_extent(box, x, n, d, d < dimensions && ts_box_periodic(box, d), &g.axis[d]);
		axis_divide(&g.axis[d], n, cutoff);
		if (box->shear.on && d == box->shear.flow)
			axis_shear(&g.axis[d], &box->shear, cutoff);
		cells *= (size_t)g.axis[d].cells;
	}
	g.start = ts_alloc(cells + 2, sizeof *g.start);
	g.list = ts_alloc(n, sizeof *g.list);
	g.place = ts_alloc(n, sizeof *g.place);
	g.turns = ts_alloc(n, sizeof *g.turns);
	if (g.start && g.list && g.place && g.turns) {
		sort_into_cells(&g, x, n);
		for (size_t i = 0; i < n; i++)
			search_around(&s, i);
		status = TS_OK;
	}
	ts_free(g.start);
	ts_free(g.list);
	ts_free(g.place);
	ts_free(g.turns);
	return status;
}
