/* Slip velocity between a particle and the fluid, and mass of the particle: used by all other files
 * drag_*.c. */

#include <math.h>

#include "coupling/drag_slip.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

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

bool ts_drag_slip_at(const struct ts_instance *self, const struct ts_particles *p, size_t i,
		     struct ts_slip *slip, double w[3])
{
	const struct ts_drag *s = self->state;
	const bool looks = ts_drag_style_of(self)->crowded && isnan(s->fraction);

	slip->empty = ts_drag_style_of(self)->crowded ? s->fraction : 1;
	if (!s->fluid)
		ts_flow_style_of(s->flow)->velocity(s->flow, p->x[i], w);
	else if (!fluid_at(s, p->x[i], i, w, looks ? &slip->empty : NULL))
		return false;
	for (int k = 0; k < 3; k++)
		w[k] -= p->v[i][k];
	slip->diameter = 2 * p->radius[i];
	slip->speed = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
	return true;
}

double ts_drag_mass(const struct ts_drag *s, const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	if (!s->added.n)
		return p->mass[i];
	return p->mass[i] + ts_added_mass_density(&s->added, p, i) * ts_particle_volume(sim, p->radius[i]);
}

bool ts_drag_motion_prescribed(const struct ts_drag *s, const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	return p->imass[i] == 0 ||
	       (!(p->mask[i] & s->moving_groups) && !sim->outside && !ts_rigid_member(p, i));
}
