/* The extent of the cavity from a solution on a coarser grid. Each iteration moves the borders of a cavity by few
 * cells only; so the number of iterations grows with the number of cells, unless they begin near the solution. */
#include "film/internal.h"

#include "base/banned.h"

enum { FEWEST = 24 }; /* axes with fewer cells are not coarsened */

static int coarse_index(int i, int n, int coarse)
{
	return n == coarse ? i : i / 2 < coarse ? i / 2 : coarse - 1;
}

static size_t parent_of(const struct ts_film *f, const struct ts_film *coarse, int i, int j)
{
	return ts_film_at(coarse, coarse_index(i, f->n[0], coarse->n[0]),
			  coarse_index(j, f->n[1], coarse->n[1]));
}

/* Sums of the cells of a coarse cell, in its fields; `step` holds their number, `residual` that of given ones. */
static void add_cell(const struct ts_film *f, struct ts_film *coarse, size_t c, size_t to)
{
	if (f->kind[c] == TS_FILM_SOLID)
		return;
	coarse->step[to] += 1;
	coarse->gap[to] += f->gap[c];
	coarse->rate[to] += f->rate[c];
	coarse->content[to] += f->content[c];
	for (int axis = 0; axis < 2; axis++)
		for (int side = 0; side < 2; side++)
			coarse->velocity[side][axis][to] += f->velocity[side][axis][c];
	if (f->kind[c] == TS_FILM_GIVEN) {
		coarse->residual[to] += 1;
		coarse->pressure_given[to] += f->pressure_given[c];
	}
}

static void divide_cell(struct ts_film *coarse, size_t c)
{
	double n = coarse->step[c], given = coarse->residual[c];

	coarse->kind[c] = !(n > 0) ? TS_FILM_SOLID : given > 0 ? TS_FILM_GIVEN : TS_FILM_FLUID;
	if (!(n > 0))
		return;
	coarse->gap[c] /= n;
	coarse->rate[c] /= n;
	coarse->content[c] /= n;
	for (int axis = 0; axis < 2; axis++)
		for (int side = 0; side < 2; side++)
			coarse->velocity[side][axis][c] /= n;
	if (given > 0)
		coarse->pressure_given[c] /= given;
}

static void fill_coarse(const struct ts_film *f, struct ts_film *coarse)
{
	for (int axis = 0; axis < 2; axis++)
		for (int i = 0; i <= coarse->n[axis]; i++) {
			bool same = f->n[axis] == coarse->n[axis], last = i == coarse->n[axis];

			coarse->face[axis][i] = f->face[axis][same ? i : last ? f->n[axis] : 2 * i];
		}
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++)
			add_cell(f, coarse, ts_film_at(f, i, j), parent_of(f, coarse, i, j));
	for (size_t c = 0; c < ts_film_cells(coarse); c++)
		divide_cell(coarse, c);
}

void ts_film_take_guess(struct ts_film *f, const struct ts_film *coarse)
{
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			size_t c = ts_film_at(f, i, j), from = parent_of(f, coarse, i, j);

			if (f->kind[c] != TS_FILM_FLUID || coarse->kind[from] != TS_FILM_FLUID)
				continue;
			f->free[c] = coarse->free[from];
			f->p[c] = coarse->p[from];
			f->empty[c] = coarse->empty[from];
		}
}

enum ts_status ts_film_coarsen(const struct ts_film *f, struct ts_film *coarse)
{
	*coarse = (struct ts_film){ .polar = f->polar,
				    .shape = f->shape,
				    .cavitation = f->cavitation,
				    .viscosity = f->viscosity,
				    .density = f->density,
				    .cavity_pressure = f->cavity_pressure,
				    .ambient = f->ambient,
				    .slip = { f->slip[0], f->slip[1] },
				    .roughness = { f->roughness[0], f->roughness[1] },
				    .peklenik = f->peklenik,
				    .asperity = f->asperity,
				    .time_step = f->time_step };
	for (int axis = 0; axis < 2; axis++) {
		coarse->n[axis] = f->n[axis] < FEWEST ? f->n[axis] : f->n[axis] / 2;
		for (int side = 0; side < 2; side++) {
			coarse->edge[axis][side] = f->edge[axis][side];
			coarse->edge_pressure[axis][side] = f->edge_pressure[axis][side];
			coarse->edge_void[axis][side] = f->edge_void[axis][side];
		}
	}
	if (ts_film_make(coarse) != TS_OK)
		return TS_NOMEM;
	fill_coarse(f, coarse);
	return TS_OK;
}

bool ts_film_can_coarsen(const struct ts_film *f)
{
	return f->n[0] >= FEWEST || f->n[1] >= FEWEST;
}
