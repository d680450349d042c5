/* Forces of particles on the fluid: explicit force f, semi-implicit coefficient k, and the weights of
 * faces in the projection that follow from them. */
#include <string.h>

#include "flow/fluid_slabs.h"
#include "flow/particle_sources.h"
#include "flow/projection.h"
#include "flow/void_fraction.h"

#include "base/banned.h"

/* The void fraction that multiplies du/dt in the momentum equation of a stage; NULL: 1. */
static const double *momentum_void_fraction(const struct ts_projection *p, int d)
{
	const double *momentum = p->fluid.momentum_void_fraction[d];

	return ts_projection_conservative(p) && momentum && !p->initial_projection
		       ? momentum
		       : p->fluid.void_fraction_face[d];
}

/* w = e e/E/(1 + dt k/(E rho)) for all faces across d, with E the void fraction in the product e u. */
static void make_weights(const struct ts_projection *p, int d, double dt)
{
	const struct ts_fluid *fluid = &p->fluid;
	const double *e = fluid->void_fraction_face[d], *k = fluid->exchange[d],
		     *mass = momentum_void_fraction(p, d);
	const double share = dt / fluid->density * p->source_scale;
	double *weight = p->weight[d];

	for (int range = 0; range < ts_fluid_ranges(fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(fluid, range, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (size_t at = first; at < end; at++) {
			double fraction = e ? e[at] : 1, heavy = mass ? mass[at] : 1;
			double held = k ? share * k[at] / heavy : 0;

			weight[at] = mass == e ? fraction / (1 + held)
					       : fraction * (fraction / heavy) / (1 + held);
		}
	}
}

enum ts_status ts_projection_face_weights(struct ts_projection *p, double dt)
{
	struct ts_fluid *fluid = &p->fluid;

	for (int d = 0; d < fluid->grid.dimensions; d++) {
		if (!fluid->exchange[d] && !ts_projection_conservative(p)) {
			p->poisson.weight[d] = fluid->void_fraction_face[d];
			continue;
		}
		if (!p->weight[d] && !(p->weight[d] = ts_grid_field(&fluid->grid)))
			return TS_NOMEM;
		make_weights(p, d, dt);
		ts_fluid_fill_periodic(fluid, p->weight[d]);
		p->poisson.weight[d] = p->weight[d];
	}
	return TS_OK;
}

/* u <- (u + dt f/(e rho))/(1 + dt k/(e rho)) at the faces of a component. */
static void apply_forces_to_row(const struct ts_projection *p, int c, size_t at, size_t end, double dt)
{
	const struct ts_fluid *fluid = &p->fluid;
	const double *e = momentum_void_fraction(p, c), *f = fluid->force[c], *k = fluid->exchange[c];
	const double share = dt / fluid->density * p->source_scale;
	double *u = fluid->u[c];

	for (; at < end; at++) {
		double scale = share / (e ? e[at] : 1);

		if (f)
			u[at] += scale * f[at];
		if (k)
			u[at] /= 1 + scale * k[at];
	}
}

void ts_projection_apply_particle_forces(struct ts_projection *p, double dt)
{
	const struct ts_fluid *fluid = &p->fluid;
	const struct ts_grid *grid = &fluid->grid;
	int height = grid->n[1] + 1;
	long first, end;

	if (!fluid->force[0] && !fluid->exchange[0])
		return;
	ts_slabs_rows(&p->slabs, grid->n[2], height, grid->dimensions == 3, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
	for (long line = first; line < end; line++) {
		int j = (int)(line % height), k = (int)(line / height);

		for (int c = 0; c < grid->dimensions; c++) {
			int from[3], to[3];

			ts_flow_unknowns(fluid, c, from, to);
			if (j >= from[1] && j < to[1] && k >= from[2] && k < to[2])
				apply_forces_to_row(p, c, ts_at(grid, from[0], j, k),
						    ts_at(grid, to[0], j, k), dt);
		}
	}
}

/* mean <- take (carry mean + u). */
static void average_field(struct ts_projection *p, double *mean, const double *u, double carry, double take)
{
	for (int range = 0; range < ts_fluid_ranges(&p->fluid); range++) {
		size_t first, end;

		ts_fluid_range_values(&p->fluid, range, &first, &end);
#pragma omp parallel for num_threads(p->poisson.threads) schedule(static)
		for (size_t at = first; at < end; at++)
			mean[at] = take * (carry * mean[at] + u[at]);
	}
}

void ts_projection_average_exchange(struct ts_projection *p, double carry, double take)
{
	struct ts_fluid *fluid = &p->fluid;

	for (int d = 0; d < fluid->grid.dimensions && fluid->exchange_velocity[d]; d++)
		average_field(p, fluid->exchange_velocity[d], fluid->u[d], carry, take);
	if (fluid->p_mean)
		average_field(p, fluid->p_mean, fluid->p, carry, take);
}

void ts_projection_clear_sources(struct ts_projection *p)
{
	for (int d = 0; d < 3; d++) {
		if (p->fluid.force[d])
			ts_fluid_clear(&p->fluid, p->fluid.force[d]);
		if (p->fluid.exchange[d])
			ts_fluid_clear(&p->fluid, p->fluid.exchange[d]);
	}
	p->source_steps = 0;
}
