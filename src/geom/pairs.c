#include "geom/pairs.h"

#include <stdbool.h>
#include <stdint.h>

#include "base/alloc.h"
#include "base/clones.h"
#include "base/eight.h"

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
	int32_t *start, *list;	  /* points of cell c: list[start[c]] .. list[start[c + 1] - 1] */
	int32_t (*place)[3];	  /* cell of each point, along each axis */
	int32_t (*turns)[3];	  /* number of box lengths that a point is outside of the periodic box */
	double *x[3], *turned[3]; /* positions and turns in the order of the list */
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
	for (size_t i = 0; i < n; i++) {
		int32_t at = g->start[cell_number(g, g->place[i]) + 1]++;

		g->list[at] = (int32_t)i;
		for (int d = 0; d < 3; d++) {
			g->x[d][at] = x[i][d];
			g->turned[d][at] = g->turns[i][d];
		}
	}
}

/* A search around the point i. Points that are near are noted, and visited together, since a branch for each point would often
 * be guessed wrong. */
enum { CHUNK = 8, ROOM = 64 };
struct search {
	const struct grid *g;
	double cutoff2;
	ts_pair_fn *visit;
	void *context;
	size_t i;
	double x[3];
	int32_t image[3]; /* of the cells that are searched, in box lengths */
	double turns[3];  /* the same, and the turns of point i */
	size_t n;
	int32_t near[ROOM]; /* places in the list */
};

/* Component m of the vector to point i from the point in place `at` of the list. */
static double component(const struct search *s, int m, size_t at)
{
	const struct grid *g = s->g;
	double d = (s->x[m] - g->x[m][at]) - (s->turns[m] - g->turned[m][at]) * g->axis[m].length;
	int k = g->shear->gradient;

	return g->shear->on && m == g->shear->flow ? d - (s->turns[k] - g->turned[k][at]) * g->shear->offset
						   : d;
}

/* The same for eight places. */
TS_INLINE void components(const struct search *s, int m, size_t at, ts_eight *d)
{
	const struct grid *g = s->g;
	int k = g->shear->gradient;

	*d = (s->x[m] - TS_EIGHT_LOAD(&g->x[m][at])) -
	     (s->turns[m] - TS_EIGHT_LOAD(&g->turned[m][at])) * g->axis[m].length;
	if (g->shear->on && m == g->shear->flow)
		*d -= (s->turns[k] - TS_EIGHT_LOAD(&g->turned[k][at])) * g->shear->offset;
}

static void visit_near(struct search *s)
{
	bool imaged = s->image[0] || s->image[1] || s->image[2];

	for (size_t k = 0; k < s->n; k++) {
		size_t at = (size_t)s->near[k], j = (size_t)s->g->list[at];
		double d[3];

		for (int m = 0; m < 3; m++)
			d[m] = component(s, m, at);
		if (s->i != j || imaged)
			s->visit(s->context, s->i, j, d);
	}
	s->n = 0;
}

/* Notes which points list[from] .. list[to - 1] are near; of the last eight those beyond `to` are computed, too, but not
 * noted. */
TS_CLONES static void note_near(struct search *s, size_t from, size_t to)
{
	for (; from < to; from += CHUNK) {
		size_t n = s->n;
		ts_eight_marks near;
		ts_eight d[3];

		for (int m = 0; m < 3; m++)
			components(s, m, from, &d[m]);
		near = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < s->cutoff2;
		for (size_t k = 0; k < CHUNK; k++) {
			s->near[n] = (int32_t)(from + k);
			n += (near[k] != 0) & (from + k < to);
		}
		s->n = n;
		if (n > ROOM - CHUNK)
			visit_near(s);
	}
}

/* Searches cells that follow each other along x, `image` box lengths away. */
static void search_cells(struct search *s, const int32_t cell[3], int32_t cells, const int32_t image[3])
{
	const struct grid *g = s->g;
	size_t c = cell_number(g, cell);

	if (image[0] != s->image[0] || image[1] != s->image[1] || image[2] != s->image[2]) {
		visit_near(s);
		for (int m = 0; m < 3; m++) {
			s->image[m] = image[m];
			s->turns[m] = g->turns[s->i][m] + image[m];
		}
	}
	note_near(s, (size_t)g->start[c], (size_t)g->start[c + (size_t)cells]);
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

/* Cells in reach along x, in pieces without a periodic face between them. */
static void search_row(struct search *s, int32_t cell[3], int32_t image[3])
{
	const struct axis *a = &s->g->axis[0];
	int32_t from = s->g->place[s->i][0], last = a->reach, cells;

	for (int32_t offset = -a->reach; offset <= last; offset += cells) {
		cells = 1;
		if (!neighbor_cell(a, from, offset, &cell[0], &image[0]))
			continue;
		cells = a->cells - cell[0] < last - offset + 1 ? a->cells - cell[0] : last - offset + 1;
		search_cells(s, cell, cells, image);
	}
}

static void search_around(struct search *s, const double x[3], size_t i)
{
	const struct axis *a = s->g->axis;
	const int32_t *from = s->g->place[i];
	int32_t cell[3], image[3];

	s->i = i;
	for (int m = 0; m < 3; m++) {
		s->x[m] = x[m];
		s->image[m] = 0;
		s->turns[m] = s->g->turns[i][m];
	}
	for (int32_t z = -a[2].reach; z <= a[2].reach; z++)
		for (int32_t y = -a[1].reach; y <= a[1].reach; y++)
			if (neighbor_cell(&a[1], from[1], y, &cell[1], &image[1]) &&
			    neighbor_cell(&a[2], from[2], z, &cell[2], &image[2]))
				search_row(s, cell, image);
	visit_near(s);
}

static enum ts_status allocate(struct grid *g, size_t n)
{
	size_t cells = (size_t)g->axis[0].cells * (size_t)g->axis[1].cells * (size_t)g->axis[2].cells;
	bool all;

	g->start = ts_alloc(cells + 2, sizeof *g->start);
	g->list = ts_alloc_unset(n, sizeof *g->list);
	g->place = ts_alloc_unset(n, sizeof *g->place);
	g->turns = ts_alloc_unset(n, sizeof *g->turns);
	all = g->start && g->list && g->place && g->turns;
	for (int d = 0; d < 3; d++) {
		g->x[d] = ts_alloc(n + CHUNK, sizeof *g->x[d]);
		g->turned[d] = ts_alloc(n + CHUNK, sizeof *g->turned[d]);
		all = all && g->x[d] && g->turned[d];
	}
	return all ? TS_OK : TS_NOMEM;
}

static void release(struct grid *g)
{
	ts_free(g->start);
	ts_free(g->list);
	ts_free(g->place);
	ts_free(g->turns);
	for (int d = 0; d < 3; d++) {
		ts_free(g->x[d]);
		ts_free(g->turned[d]);
	}
}

enum ts_status ts_pairs_visit(const struct ts_box *box, int dimensions, const double (*x)[3], size_t n,
			      double cutoff, ts_pair_fn *visit, void *context)
{
	struct grid g = { .shear = &box->shear };
	struct search s = { .g = &g, .cutoff2 = cutoff * cutoff, .visit = visit, .context = context };
	enum ts_status status;

	for (int d = 0; d < 3; d++) {
		axis_extent(box, x, n, d, d < dimensions && ts_box_periodic(box, d), &g.axis[d]);
		axis_divide(&g.axis[d], n, cutoff);
		if (box->shear.on && d == box->shear.flow)
			axis_shear(&g.axis[d], &box->shear, cutoff);
	}
	status = allocate(&g, n);
	if (status == TS_OK) {
		sort_into_cells(&g, x, n);
		for (size_t i = 0; i < n; i++)
			search_around(&s, x[i], i);
	}
	release(&g);
	return status;
}
