/* Slip velocity between a particle and the fluid, and mass of the particle: used by all other files
 * drag_*.c. */

#include <math.h>

#include "coupling/drag_slip.h"
#include "coupling/stencil_batch.h"
#include "particle/particles.h"

#include "base/banned.h"

const char *const ts_drag_axes[] = { "x", "y", "z", "xy", "xz", "yz", "xyz", NULL };

static double weighted_mean(double wa, double wb, double a, double b)
{
	return (wa * a + wb * b) / (wa + wb);
}

/* Velocity of a cell: mean over its faces; with a void fraction the mean of e u divided by e of the cell,
 * so that the slip in a layer of a bed is the superficial velocity by the void fraction of that layer. */
static void cell_velocity(const struct ts_fluid *fluid, const int cell[3], double u[3])
{
	const struct ts_grid *grid = &fluid->grid;
	const size_t at = ts_at(grid, cell[0], cell[1], cell[2]);
	const double *e = fluid->void_fraction;

	for (int c = 0; c < 3; c++) {
		size_t s = c < grid->dimensions ? (size_t)grid->stride[c] : 0;
		double low = fluid->u[c][at], high = fluid->u[c][at + s];

		if (e && s) {
			const double *width = grid->width[c] + cell[c];

			low *= weighted_mean(width[-1], width[0], e[at - s], e[at]) / e[at];
			high *= weighted_mean(width[0], width[1], e[at], e[at + s]) / e[at];
		}
		u[c] = 0.5 * (low + high);
	}
}

/* Velocity of the computed fluid at particle i, and its void fraction (NULL: not asked for); false: outside. */
static bool fluid_at(const struct ts_drag *s, const double x[3], size_t i, double u[3], double *empty)
{
	const struct ts_fluid *fluid = s->fluid;
	double place[3];
	int cell[3];

	if (!(s->sorted ? ts_cell_order_locate(&s->order, fluid, i, place, cell)
			: ts_coupling_locate(fluid, x, place, cell)))
		return false;
	if (s->interpolation != TS_INTERPOLATE_CELL) {
		ts_fluid_velocity_in_cell(fluid, place, cell, u, empty ? fluid->void_fraction : NULL, empty);
		return true;
	}
	cell_velocity(fluid, cell, u);
	if (empty)
		*empty = fluid->void_fraction[ts_at(&fluid->grid, cell[0], cell[1], cell[2])];
	return true;
}

/* Whether the law takes the void fraction of the fluid. */
static bool looks_for_void_fraction(const struct ts_instance *self)
{
	return ts_drag_style_of(self)->crowded && isnan(((const struct ts_drag *)self->state)->fraction);
}

/* From the velocity of the fluid in w. */
static void set_slip(const struct ts_particles *p, size_t i, struct ts_slip *slip, double w[3])
{
	for (int k = 0; k < 3; k++)
		w[k] -= p->v[i][k];
	slip->diameter = 2 * p->radius[i];
	slip->speed = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
}

bool ts_drag_slip_at(const struct ts_instance *self, const struct ts_particles *p, size_t i,
		     struct ts_slip *slip, double w[3])
{
	const struct ts_drag *s = self->state;

	slip->empty = ts_drag_style_of(self)->crowded ? s->fraction : 1;
	if (!s->fluid)
		ts_flow_style_of(s->flow)->velocity(s->flow, p->x[i], w);
	else if (!fluid_at(s, p->x[i], i, w, looks_for_void_fraction(self) ? &slip->empty : NULL))
		return false;
	set_slip(p, i, slip, w);
	return true;
}

/* In vectors of particles. */
static void find_batch(const struct ts_instance *self, const struct ts_particles *p,
		       struct ts_drag_slips *slips)
{
	const struct ts_drag *s = self->state;
	const double fraction = ts_drag_style_of(self)->crowded ? s->fraction : 1;
	const bool looks = looks_for_void_fraction(self);
	double u[3][TS_STENCIL_BATCH], empty[TS_STENCIL_BATCH];
	struct ts_stencil_batch batch;

	_Static_assert((int)TS_DRAG_BATCH <= (int)TS_STENCIL_BATCH, "all are a batch");
	batch.n = 0;
	for (size_t k = 0; k < slips->n && s->sorted; k++)
		ts_stencil_batch_add(&batch, p->x[slips->of[k]], s->order.sort->where[slips->of[k]]);
	if (!s->sorted)
		ts_stencil_batch_find(&batch, &s->fluid->grid, (const double(*)[3])p->x, slips->of, slips->n);
	ts_stencil_batch_velocity(&batch, s->fluid, u, looks ? s->fluid->void_fraction : NULL, empty,
				  slips->inside);
	for (size_t k = 0; k < slips->n; k++) {
		for (int c = 0; c < 3; c++)
			slips->w[k][c] = u[c][k];
		slips->slip[k].empty = looks ? empty[k] : fraction;
		set_slip(p, slips->of[k], &slips->slip[k], slips->w[k]);
	}
}

void ts_drag_find_slips(const struct ts_instance *self, const struct ts_particles *p,
			struct ts_drag_slips *slips)
{
	const struct ts_drag *s = self->state;

	for (size_t k = 0; k < slips->n; k++) {
		slips->slip[k].density = slips->density;
		slips->slip[k].viscosity = slips->viscosity;
	}
	if (s->fluid && ts_stencil_batch_possible(s->fluid, s->interpolation)) {
		find_batch(self, p, slips);
		return;
	}
	for (size_t k = 0; k < slips->n; k++)
		slips->inside[k] = ts_drag_slip_at(self, p, slips->of[k], &slips->slip[k], slips->w[k]);
}
