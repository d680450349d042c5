/* Parts of the film on whose border no pressure is given: all edges closed or periodic, or solid cells around. Only
 * differences of the pressure are determined there. With `floating` one cell of each gets the ambient pressure. Its own
 * balance is not an equation: it is minus the sum of those of all other cells of the part, 0 if nothing comes from the
 * motion of the surfaces. */
#include <math.h>

#include "base/alloc.h"
#include "film/internal.h"

#include "base/banned.h"

static int root_of(int *parent, int c)
{
	while (parent[c] != c)
		c = parent[c] = parent[parent[c]];
	return c;
}

/* Joins cells on both sides of a face; an edge or cell with a given pressure is the last node. */
static void join_face(const struct ts_film *f, int *parent, int axis, int i, int j)
{
	struct ts_film_sides s = ts_film_sides_of(f, axis, i, j);
	int given = (int)ts_film_cells(f), a, b;

	if (!s.open)
		return;
	a = s.low < 0 || f->kind[s.low] == TS_FILM_GIVEN ? given : s.low;
	b = s.high < 0 || f->kind[s.high] == TS_FILM_GIVEN ? given : s.high;
	parent[root_of(parent, a)] = root_of(parent, b);
}

/* The first node of the chain that ends in the root of its part, for each cell and the node of given pressures. */
static int *find_parts(const struct ts_film *f)
{
	size_t n = ts_film_cells(f);
	int *parent = ts_alloc(n + 1, sizeof *parent);

	if (!parent)
		return NULL;
	for (size_t c = 0; c <= n; c++)
		parent[c] = (int)c;
	for (int d = 0; d < 2; d++)
		for (int j = 0; j < f->n[1] + (d == 1); j++)
			for (int i = 0; i < f->n[0] + (d == 0); i++)
				join_face(f, parent, d, i, j);
	return parent;
}

static bool is_undetermined(const struct ts_film *f, int *parent, size_t c)
{
	return f->kind[c] == TS_FILM_FLUID &&
	       root_of(parent, (int)c) != root_of(parent, (int)ts_film_cells(f));
}

enum ts_status ts_film_check_parts(const struct ts_film *f, struct ts_error *error)
{
	size_t n = ts_film_cells(f), c;
	int *parent = find_parts(f);

	if (!parent)
		return ts_nomem(error);
	for (c = 0; c < n; c++)
		if (is_undetermined(f, parent, c))
			break;
	ts_free(parent);
	if (c == n)
		return TS_OK;
	return ts_fail(error, TS_STATE, NULL,
		       "film: no pressure is given at any border of the part of the film that contains (%g, "
		       "%g), so that its pressure is not determined but for a constant; see `floating`",
		       ts_film_centre(f, 0, (int)(c % (size_t)f->n[0])),
		       ts_film_centre(f, 1, (int)(c / (size_t)f->n[0])));
}

enum ts_status ts_film_pin_parts(struct ts_film *f, struct ts_error *error)
{
	size_t n = ts_film_cells(f);
	int *parent;

	if (!f->floating)
		return TS_OK;
	parent = find_parts(f);
	if (!parent)
		return ts_nomem(error);
	for (size_t c = 0; c < n; c++) {
		f->pinned[c] = is_undetermined(f, parent, c);
		if (!f->pinned[c])
			continue;
		f->kind[c] = TS_FILM_GIVEN;
		f->pressure_given[c] = f->ambient;
		parent[root_of(parent, (int)c)] = root_of(parent, (int)n);
	}
	ts_free(parent);
	return TS_OK;
}

/* Sum over the flows out of the cell and its change: that of the volume of the whole part. */
static double growth_of(const struct ts_film *f, int i, int j)
{
	return f->flow[0][ts_film_face(f, 0, i + 1, j)] - f->flow[0][ts_film_face(f, 0, i, j)] +
	       f->flow[1][ts_film_face(f, 1, i, j + 1)] - f->flow[1][ts_film_face(f, 1, i, j)] +
	       f->rate[ts_film_at(f, i, j)] * ts_film_area(f, i, j);
}

void ts_film_unpin_parts(struct ts_film *f)
{
	for (size_t c = 0; c < ts_film_cells(f) && f->floating; c++)
		if (f->pinned[c])
			f->kind[c] = TS_FILM_FLUID;
}

enum ts_status ts_film_check_pinned(const struct ts_film *f, struct ts_error *error)
{
	/* the balances of all other cells, each at round-off, add up in that of the pinned one */
	double most = (double)ts_film_cells(f) * (1e-7 * f->report.throughput + 1e4 * ts_film_round_off(f));

	for (int j = 0; j < f->n[1] && f->floating; j++)
		for (int i = 0; i < f->n[0]; i++) {
			double growth = growth_of(f, i, j);

			if (f->pinned[ts_film_at(f, i, j)] && !(fabs(growth) <= most))
				return ts_fail(error, TS_PHYSICS, NULL,
					       "film: the volume of the part of the film that contains (%g, "
					       "%g) changes, by %g per time, and no pressure is given at its "
					       "border: the fluid cannot leave it",
					       ts_film_centre(f, 0, i), ts_film_centre(f, 1, j), growth);
		}
	return TS_OK;
}
