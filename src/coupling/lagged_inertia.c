/* In a step n the forces on particles are those of the pressure gradient G and the acceleration a of the fluid of the step
 * before; e a + phi b = 0, as the volumes of fluid and particles that flow into a cell add up to nothing. With the density
 * rho of the fluid, m of particles, A of their added mass, r = phi/e, and b the acceleration of the particles:
 *
 *   (m + A) b[n] = -G[n-1] + A a[n-1],  f[n] = A (a[n-1] - b[n]),  rho a[n] = -G[n] - r f[n],  a[n] = -r b[n-1]
 *
 *   (m + A) z^3 + r A z^2 + r (rho + A) z + r^2 A = 0 for b ~ z^n,
 *
 * which decays if, and only if, Jury's criterion holds; without added mass, for r rho < m. The step does not occur in it.
 * Motion without divergence has no pressure: a[n] = -r A m/(rho (m + A)) a[n-1]. Drag is left out. */
#include "coupling/lagged_inertia.h"

#include <math.h>

#include "base/alloc.h"
#include "core/ranks.h"
#include "core/report.h"
#include "coupling/added_mass.h"
#include "coupling/interpolation_weights.h"
#include "coupling/near_particles.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* Of the particles with their centre in a cell. */
struct inertia {
	double volume, all; /* of the particles that the forces accelerate, and of all */
	double mass, added; /* of the former */
	/* the part of the added mass that follows the acceleration of the fluid, whose reaction acts on it, and that with both */
	double follows, reacts, both;
};

/* The densities of it, and r. */
struct lag {
	double fluid, particle, ratio, added, follows, reacts, both;
	bool pressed;
};

static bool grows(const struct lag *l)
{
	const double r = l->ratio, inertia = l->particle + l->added;
	const double a2 = l->pressed ? r * l->reacts / inertia : 0;
	const double a1 = r * (l->pressed * l->fluid + l->follows) / inertia;
	const double a0 = l->pressed ? r * r * l->both / inertia : 0;

	return !(a0 < 1) || !(1 - a2 + a1 - a0 > 0) || !(1 - a0 * a0 > fabs(a0 * a2 - a1)) ||
	       !(r * l->both * l->particle < l->fluid * inertia);
}

/* Without the forces that the particle does not follow: held ones, and members of bodies. */
static void add_particle(struct inertia *sum, const struct tsim *sim, int group,
			 const struct ts_added_masses *masses, size_t i)
{
	const struct ts_particles *p = sim->particles;
	const double volume = ts_particle_volume(sim, p->radius[i]);

	sum->all += volume;
	if (!ts_in_group(p, i, group) || p->imass[i] == 0 || ts_rigid_member(p, i))
		return;
	sum->volume += volume;
	sum->mass += p->mass[i];
	for (size_t k = 0; k < masses->n; k++) {
		const double added = masses->of[k].density * volume;

		if (!ts_in_group(p, i, masses->of[k].group))
			continue;
		sum->added += added;
		sum->follows += masses->of[k].follows ? added : 0;
		sum->reacts += masses->of[k].reacts ? added : 0;
		sum->both += masses->of[k].follows && masses->of[k].reacts ? added : 0;
	}
}

static struct lag lag_of(const struct inertia *sum, double fluid, double e, bool pressed)
{
	const double v = sum->volume;

	return (struct lag){ .fluid = fluid,
			     .particle = sum->mass / v,
			     .ratio = (1 - e) / e * v / sum->all,
			     .added = sum->added / v,
			     .follows = sum->follows / v,
			     .reacts = sum->reacts / v,
			     .both = sum->both / v,
			     .pressed = pressed };
}

/* What helps in a cell that is unstable. */
static const char *remedy_for(const struct lag *now)
{
	static const double COEFFICIENT = 0.5; /* of spheres */
	const double mass = COEFFICIENT * now->fluid;
	struct lag other = {
		.fluid = now->fluid, .particle = now->particle, .ratio = now->ratio, .pressed = now->pressed
	};

	if (!grows(&other))
		return "leave out fix added_mass";
	other.added = other.reacts = other.follows = other.both = mass;
	if (!grows(&other))
		return "use fix added_mass";
	other.follows = other.both = 0;
	if (!grows(&other))
		return "use fix added_mass with `fluid_acceleration no`";
	return "use heavier particles, or resolved ones (fix immersed/boundary)";
}

static enum ts_status report_cell(const struct ts_instance *self, const struct ts_fluid *fluid, size_t at,
				  const struct lag *lag, struct ts_plan_report *report)
{
	const struct ts_grid *grid = &fluid->grid;
	int cell[3];

	ts_grid_indices(grid, at, cell);
	return ts_report_limit(report, 0, false, &self->where,
			       "fix %s on particles of density %.4g, %.2g of the cell at (%.3g %.3g %.3g), "
			       "in a fluid of density %.4g, which learns their acceleration a step later: %s",
			       self->style->name, lag->particle, 1 - fluid->void_fraction[at],
			       grid->centre[0][cell[0]], grid->centre[1][cell[1]], grid->centre[2][cell[2]],
			       lag->fluid, remedy_for(lag));
}

/* Sums by cell, of `size` of the grid. */
static void sum_cells(const struct ts_instance *self, const struct tsim *sim, const struct ts_fluid *fluid,
		      struct inertia *sums)
{
	const struct ts_added_masses masses = ts_added_mass_find(sim);
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		double place[3];
		int cell[3];

		if (ts_coupling_locate(fluid, p->x[i], place, cell))
			add_particle(&sums[ts_at(&fluid->grid, cell[0], cell[1], cell[2])], sim, self->group,
				     &masses, i);
	}
}

/* The cell whose velocities grow most; false: there is none. */
static bool find_worst(const struct ts_fluid *fluid, const struct inertia *sums, bool pressed, size_t *at,
		       struct lag *worst)
{
	double most = 0;

	for (size_t c = 0; c < fluid->grid.size; c++) {
		double gain;
		struct lag lag;

		if (!(sums[c].volume > 0))
			continue;
		lag = lag_of(&sums[c], fluid->density, fluid->void_fraction[c], pressed);
		gain = lag.ratio * (lag.fluid + lag.follows) / (lag.particle + lag.added);
		if (!grows(&lag) || gain <= most)
			continue;
		most = gain;
		*at = c;
		*worst = lag;
	}
	return most > 0;
}

static enum ts_status report_worst(struct ts_instance *self, struct tsim *sim, const struct ts_fluid *fluid,
				   bool pressed, struct ts_plan_report *report)
{
	struct inertia *sums = ts_alloc(fluid->grid.size, sizeof *sums);
	struct lag lag = { .fluid = 0 };
	size_t at = 0;
	bool found;

	if (!sums)
		return ts_nomem(&sim->error);
	sum_cells(self, sim, fluid, sums);
	found = find_worst(fluid, sums, pressed, &at, &lag);
	ts_free(sums);
	return found ? report_cell(self, fluid, at, &lag, report) : TS_OK;
}

/* While the particles are divided among ranks: whether one of them would be unstable, if its cell were full of its like. */
static bool is_doubtful(const struct ts_instance *self, const struct tsim *sim, const struct ts_fluid *fluid,
			bool pressed)
{
	const struct ts_added_masses masses = ts_added_mass_find(sim);
	const struct ts_particles *p = sim->particles;
	bool found = false;

	for (size_t i = 0; i < p->n && !found; i++) {
		struct inertia sum = { .volume = 0 };
		struct lag lag;
		double place[3];
		int cell[3];

		add_particle(&sum, sim, self->group, &masses, i);
		if (!(sum.volume > 0) || !ts_coupling_locate(fluid, p->x[i], place, cell))
			continue;
		lag = lag_of(&sum, fluid->density,
			     fluid->void_fraction[ts_at(&fluid->grid, cell[0], cell[1], cell[2])], pressed);
		found = grows(&lag);
	}
	return found;
}

enum ts_status ts_lagged_inertia_report(struct ts_instance *self, struct tsim *sim, bool pressed,
					struct ts_plan_report *report)
{
	struct ts_fluid *fluid = ts_flow_fluid(sim);

	if (!fluid || !fluid->void_fraction)
		return TS_OK;
	if (!sim->division) /* at all particles */
		TS_TRY(ts_flow_require_fields(sim, self->style->name, &self->where, &fluid));
	TS_TRY(ts_near_particles_ready(fluid, sim));
	if (!sim->division)
		return report_worst(self, sim, fluid, pressed, report);
	report->undecided |= is_doubtful(self, sim, fluid, pressed);
	return TS_OK;
}
