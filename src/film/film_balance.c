/* The balance of volume of the cells, and its derivatives. */
#include <float.h>
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

static double pressure_beside(const struct ts_film *f, int axis, int cell, bool high)
{
	return cell >= 0 ? f->p[cell] : f->edge_pressure[axis][high];
}

static double void_beside(const struct ts_film *f, int axis, int cell, bool high)
{
	return cell >= 0 ? f->empty[cell] : f->edge_void[axis][high];
}

static void set_face_flow(struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s)
{
	size_t at = ts_film_face(f, axis, i, j);
	double transport = f->transport[axis][at];
	double drop = pressure_beside(f, axis, s->low, false) - pressure_beside(f, axis, s->high, true);
	double empty =
		transport > 0 ? void_beside(f, axis, s->low, false) : void_beside(f, axis, s->high, true);

	f->flow[axis][at] = s->open ? f->conductance[axis][at] * drop +
					      transport * (f->cavitation == TS_FILM_JFO ? 1 - empty : 1)
				    : 0;
}

double ts_film_full_flow(const struct ts_film *f, int axis, int i, int j)
{
	size_t at = ts_film_face(f, axis, i, j);
	double transport = f->transport[axis][at], empty;
	struct ts_film_sides s;

	if (f->cavitation != TS_FILM_JFO)
		return f->flow[axis][at];
	s = ts_film_sides_of(f, axis, i, j);
	if (!s.open)
		return f->flow[axis][at];
	empty = transport > 0 ? void_beside(f, axis, s.low, false) : void_beside(f, axis, s.high, true);
	return f->flow[axis][at] + transport * empty;
}

static bool is_in_time(const struct ts_film *f)
{
	return f->cavitation == TS_FILM_JFO && f->time_step > 0;
}

static double cell_balance(const struct ts_film *f, int i, int j)
{
	size_t c = ts_film_at(f, i, j);
	double sum = f->flow[0][ts_film_face(f, 0, i + 1, j)] - f->flow[0][ts_film_face(f, 0, i, j)] +
		     f->flow[1][ts_film_face(f, 1, i, j + 1)] - f->flow[1][ts_film_face(f, 1, i, j)] +
		     f->source[c];

	if (is_in_time(f))
		sum -= f->gap[c] * f->empty[c] * ts_film_area(f, i, j) / f->time_step;
	return sum;
}

void ts_film_set_flow(struct ts_film *f)
{
	ts_film_each_face(f, set_face_flow);
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++)
			f->residual[ts_film_at(f, i, j)] = cell_balance(f, i, j);
}

/* Adds the part of one face to the row of a cell; `out` is 1 if the axis points out of the cell. */
static void add_face(const struct ts_film *f, struct ts_grid_row *row, int cell, int side, bool transported)
{
	int axis = side / 2, out = side % 2 ? 1 : -1, i = cell % f->n[0], j = cell / f->n[0];
	size_t at = ts_film_face(f, axis, i + (side == 1), j + (side == 3));
	int other = ts_grid_lu_neighbour(&f->lu, cell, side);
	double away = out * f->transport[axis][at];

	if (f->free[cell])
		row->centre += f->conductance[axis][at];
	else if (transported)
		row->centre += fmax(away, 0);
	if (other < 0)
		return;
	if (f->free[other])
		row->side[side] = -f->conductance[axis][at];
	else if (transported)
		row->side[side] = fmin(away, 0);
}

static void set_row(const struct ts_film *f, int cell, bool transported, struct ts_grid_row *row)
{
	*row = (struct ts_grid_row){ .centre = 0 };
	if (!f->free[cell] && !transported) {
		row->centre = 1;
		return;
	}
	for (int side = 0; side < TS_GRID_NEIGHBOURS; side++)
		add_face(f, row, cell, side, transported);
	if (!f->free[cell] && f->time_step > 0)
		row->centre += f->gap[cell] * ts_film_area(f, cell % f->n[0], cell / f->n[0]) / f->time_step;
}

void ts_film_set_rows(struct ts_film *f, bool transported)
{
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_FLUID)
			set_row(f, (int)c, transported, &f->row[c]);
}

static double mean_flow(const struct ts_film *f)
{
	double sum = 0;
	size_t faces = 0;

	for (int axis = 0; axis < 2; axis++) {
		size_t n = ts_film_face(f, axis, f->n[0] - (axis == 1), f->n[1] - (axis == 0)) + 1;

		faces += n;
		for (size_t at = 0; at < n; at++)
			sum += fabs(f->flow[axis][at]);
	}
	for (size_t c = 0; c < ts_film_cells(f); c++)
		sum += fabs(f->source[c]);
	return sum / (double)faces;
}

/* Lowest and highest of the pressures given. */
static void given_pressures(const struct ts_film *f, double range[2])
{
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (int k = 0; k < 4; k++)
		if (f->edge[k / 2][k % 2] == TS_FILM_PRESSURE) {
			range[0] = fmin(range[0], f->edge_pressure[k / 2][k % 2]);
			range[1] = fmax(range[1], f->edge_pressure[k / 2][k % 2]);
		}
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->kind[c] == TS_FILM_GIVEN) {
			range[0] = fmin(range[0], f->pressure_given[c]);
			range[1] = fmax(range[1], f->pressure_given[c]);
		}
}

bool ts_film_is_driven(const struct ts_film *f)
{
	double range[2];

	for (int axis = 0; axis < 2; axis++)
		for (int j = 0; j < f->n[1] + (axis == 1); j++)
			for (int i = 0; i < f->n[0] + (axis == 0); i++)
				if (f->transport[axis][ts_film_face(f, axis, i, j)] != 0)
					return true;
	for (size_t c = 0; c < ts_film_cells(f); c++)
		if (f->source[c] != 0)
			return true;
	given_pressures(f, range);
	return range[0] < range[1];
}

double ts_film_round_off(const struct ts_film *f)
{
	double pressure = 0, conductance = 0, transport = 0, content = 0;

	for (int axis = 0; axis < 2; axis++)
		for (int j = 0; j < f->n[1] + (axis == 1); j++)
			for (int i = 0; i < f->n[0] + (axis == 0); i++) {
				size_t at = ts_film_face(f, axis, i, j);

				conductance = fmax(conductance, f->conductance[axis][at]);
				transport = fmax(transport, fabs(f->transport[axis][at]));
			}
	for (int j = 0; j < f->n[1]; j++)
		for (int i = 0; i < f->n[0]; i++) {
			size_t c = ts_film_at(f, i, j);

			pressure = fmax(pressure, fabs(f->p[c]));
			if (is_in_time(f))
				content = fmax(content, f->gap[c] * ts_film_area(f, i, j) / f->time_step);
		}
	return DBL_EPSILON * (conductance * pressure + transport + content);
}

void ts_film_set_report(struct ts_film *f)
{
	struct ts_film_report *r = &f->report;

	r->throughput = mean_flow(f);
	r->balance = r->imbalance = 0;
	r->cavitated = 0;
	for (size_t c = 0; c < ts_film_cells(f); c++) {
		if (f->kind[c] != TS_FILM_FLUID)
			continue;
		r->cavitated += !f->free[c];
		if (f->free[c] || f->cavitation == TS_FILM_JFO)
			r->balance = fmax(r->balance, fabs(f->residual[c]));
		else
			r->imbalance += f->residual[c];
	}
}
