#include "film/film.h"

#include <math.h>

#include "base/alloc.h"

#include "base/banned.h"

double ts_film_area(const struct ts_film *f, int i, int j)
{
	double area = (f->face[0][i + 1] - f->face[0][i]) * (f->face[1][j + 1] - f->face[1][j]);

	return f->polar ? area * ts_film_centre(f, 0, i) : area;
}

static bool make_field(double **field, size_t n)
{
	*field = ts_alloc(n, sizeof **field);
	return *field != NULL;
}

static bool make_axis(struct ts_film *f, int axis)
{
	size_t faces =
		axis == 0 ? (size_t)(f->n[0] + 1) * (size_t)f->n[1] : (size_t)f->n[0] * (size_t)(f->n[1] + 1);

	return make_field(&f->face[axis], (size_t)f->n[axis] + 1) && make_field(&f->flow[axis], faces) &&
	       make_field(&f->conductance[axis], faces) && make_field(&f->transport[axis], faces) &&
	       make_field(&f->ride[0][axis], faces) && make_field(&f->ride[1][axis], faces) &&
	       make_field(&f->velocity[0][axis], ts_film_cells(f)) &&
	       make_field(&f->velocity[1][axis], ts_film_cells(f));
}

enum ts_status ts_film_make(struct ts_film *f)
{
	size_t n = ts_film_cells(f);
	double **const fields[] = { &f->gap,	&f->rate,  &f->pressure_given, &f->content, &f->p, &f->empty,
				    &f->source, &f->value, &f->residual,       &f->step,    NULL };

	if (!make_axis(f, 0) || !make_axis(f, 1))
		return TS_NOMEM;
	for (size_t k = 0; fields[k]; k++)
		if (!make_field(fields[k], n))
			return TS_NOMEM;
	f->kind = ts_alloc(n, sizeof *f->kind);
	f->free = ts_alloc(n, sizeof *f->free);
	f->pinned = ts_alloc(n, sizeof *f->pinned);
	f->row = ts_alloc(n, sizeof *f->row);
	return f->kind && f->free && f->pinned && f->row ? TS_OK : TS_NOMEM;
}

double ts_film_bytes(const struct ts_film *f)
{
	/* fields, rows of the matrix and the order of its elimination */
	const double by_cell = 28 * sizeof(double) + sizeof *f->row + 8 * sizeof(double);
	/* of a coefficient in L and in U, and its place; their number by cell, fitted to 100 x 100 to 400 x 400 cells */
	const double of_factors = 2 * sizeof(double) + sizeof(int);
	double cells = (double)ts_film_cells(f);

	return cells * (by_cell + of_factors * fmax(3.1 * log2(cells) - 17, 2));
}

void ts_film_release(struct ts_film *f)
{
	double *const fields[] = { f->gap,   f->rate,	f->pressure_given, f->content,	f->p,
				   f->empty, f->source, f->value,	   f->residual, f->step };

	for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
		ts_free(fields[k]);
	for (int d = 0; d < 2; d++) {
		ts_free(f->face[d]);
		ts_free(f->flow[d]);
		ts_free(f->conductance[d]);
		ts_free(f->transport[d]);
		ts_free(f->ride[0][d]);
		ts_free(f->ride[1][d]);
		ts_free(f->velocity[0][d]);
		ts_free(f->velocity[1][d]);
	}
	ts_free(f->kind);
	ts_free(f->free);
	ts_free(f->pinned);
	ts_free(f->row);
	ts_grid_lu_release(&f->lu);
	*f = (struct ts_film){ .n = { 0, 0 } };
}
