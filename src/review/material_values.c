/* Checks of the review: units, diameters, densities and elastic moduli. */
#include "review/internal.h"

#include <math.h>
#include <stdio.h>

#include "core/ranks.h"
#include "force/gravity.h"
#include "material/property.h"
#include "particle/columns.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"
#include "wall/wall.h"

#include "base/banned.h"

/* Magnitude of a fix gravity that is about 9.81, as on earth in SI units; 0: there is none. */
static double earth_gravity(struct tsim *sim, const struct ts_instance **by)
{
	for (size_t k = 0; (*by = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_GRAVITY, &k));) {
		const struct ts_number *g = &((const struct ts_gravity *)(*by)->state)->magnitude;

		if (!g->variable && fabs(g->value) > 9.7 && fabs(g->value) < 9.9)
			return g->value;
	}
	return 0;
}

enum ts_status ts_review_units(struct tsim *sim)
{
	const struct ts_instance *by = NULL;
	const struct ts_property *young;
	double g;

	if (sim->units_given || sim->units != TS_UNITS_LJ)
		return TS_OK;
	g = earth_gravity(sim, &by);
	if (g != 0)
		return ts_review_report(sim, "units", &by->where,
					"gravity is %g, its value in SI units, but the script has no `units` "
					"command and uses units lj (time step %g); begin it with `units si`, "
					"or with `units lj` if intended",
					g, sim->clock.dt);
	young = ts_property_find(sim, "youngsModulus", &by);
	if (young && young->n && young->value[0] >= 1e5)
		return ts_review_report(sim, "units", &by->where,
					"youngsModulus is %g, a value in SI units, but the script has no "
					"`units` command and uses units lj (time step %g); begin it with "
					"`units si`, or with `units lj` if intended",
					young->value[0], sim->clock.dt);
	return TS_OK;
}

/* Number of particles for which is_so holds, and the index of the first. */
static size_t count_particles(const struct tsim *sim, bool (*is_so)(const struct tsim *sim, size_t i),
			      size_t *first)
{
	size_t n = 0;

	for (size_t i = sim->particles->n; i-- > 0;) {
		if (!is_so(sim, i))
			continue;
		*first = i;
		n++;
	}
	return n;
}

/* Whether a particle has the default diameter 1 and density 1 of ts_particles_add. */
static bool has_defaults(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	return !(fabs(p->radius[i] - 0.5) > 0) && fabs(p->mass[i] / ts_particle_volume(sim, 0.5) - 1) < 1e-12;
}

enum ts_status ts_review_diameter(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	size_t n = 0, first = 0;

	if (sim->units == TS_UNITS_LJ)
		return TS_OK;
	n = count_particles(sim, has_defaults, &first);
	if (!n)
		return TS_OK;
	return ts_review_report(sim, "diameter", NULL,
				"%zu of %zu particles have diameter 1 and density 1, the defaults of "
				"create_atoms; the first is particle %d (type %d); use `set type %d diameter "
				"D density RHO` before the run",
				n, p->n, p->tag[first], p->type[first], p->type[first]);
}

/* ---- densities ---- */

static const double LIGHTEST = 10, HEAVIEST = 30000; /* kg/m3: foam, osmium */

static bool has_unlikely_density(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	double density = p->mass[i] / ts_particle_volume(sim, p->radius[i]);

	return !ts_rigid_member(p, i) && p->imass[i] > 0 && !has_defaults(sim, i) &&
	       !(density >= LIGHTEST && density <= HEAVIEST);
}

/* Only with gravity of about 9.81, which shows that lengths are in metres and times in seconds; test
 * scripts with other numbers are not checked. */
enum ts_status ts_review_density(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_instance *by = NULL;
	size_t n = 0, first = 0;

	if (sim->units != TS_UNITS_SI || sim->dimension != 3 || !(fabs(earth_gravity(sim, &by)) > 0))
		return TS_OK;
	n = count_particles(sim, has_unlikely_density, &first);
	if (!n)
		return TS_OK;
	return ts_review_report(sim, "density", NULL,
				"%zu of %zu particles have densities outside the range of solids; the first "
				"is particle %d (type %d) with %g kg/m3 (water 1000, sand 2650, steel 7850 "
				"kg/m3); use `set type %d density RHO`",
				n, p->n, p->tag[first], p->type[first],
				p->mass[first] / ts_particle_volume(sim, p->radius[first]), p->type[first]);
}

/* ---- moduli ---- */

static const double SOFTEST = 1e4, HARDEST = 1e13; /* Pa: soft gel; ten times diamond */

/* Effective modulus E* (Pa) of hertz and of adhesive laws; 0: the law has none. */
static double modulus_of(const struct ts_granular_model *model, const struct ts_granular_pair *law)
{
	return model->normal == TS_NORMAL_HERTZ	      ? law->young
	       : model->normal > TS_NORMAL_AREA_HOOKE ? 0.75 * law->kn
						      : 0;
}

static bool is_unlikely_modulus(double modulus)
{
	return modulus > 0 && !(modulus >= 0.5 * SOFTEST && modulus <= HARDEST);
}

static enum ts_status report_modulus(struct tsim *sim, const struct ts_instance *by, const char *what,
				     double modulus)
{
	return ts_review_report(sim, "modulus", &by->where,
				"%s have the modulus E* = %g Pa (1/E* = sum of (1 - nu^2)/E), outside the "
				"range of solids: rubber 1e6 to 1e8, glass 7e10, steel 2e11 Pa; check the "
				"units of Young's modulus (softened grains seldom have less than 1e5) and "
				"the command `units`",
				what, modulus);
}

/* Of all ranks. */
static bool has_type(const struct tsim *sim, int type)
{
	const struct ts_particles *p = sim->particles;
	bool has = false;

	for (size_t i = 0; i < p->n && !has; i++)
		has = p->type[i] == type;
	return ts_ranks_most(sim, has) > 0;
}

static enum ts_status check_walls(struct tsim *sim)
{
	const struct ts_instance *by;
	const struct ts_wall *w;
	char what[80];

	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by));)
		for (int a = 1; w->own_model && w->law && a <= w->ntypes; a++)
			for (int b = 1; b <= sim->particles->ntypes; b++) {
				double modulus = modulus_of(&w->model, ts_wall_law(w, sim, a, b));

				if (!has_type(sim, b) || !is_unlikely_modulus(modulus))
					continue;
				snprintf(what, sizeof what, "contacts of type %d with wall %.30s", b, by->id);
				return report_modulus(sim, by, what, modulus);
			}
	return TS_OK;
}

enum ts_status ts_review_modulus(struct tsim *sim)
{
	const struct ts_instance *by = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_particles *p = sim->particles;
	char what[80];

	if (sim->units != TS_UNITS_SI)
		return TS_OK;
	for (int a = 1; by && a <= p->ntypes; a++)
		for (int b = a; has_type(sim, a) && b <= p->ntypes; b++) {
			double modulus =
				modulus_of(ts_pair_model(by->state, a, b), ts_pair_law(by->state, a, b));

			if (!has_type(sim, b) || !is_unlikely_modulus(modulus))
				continue;
			snprintf(what, sizeof what, "contacts of types %d and %d", a, b);
			return report_modulus(sim, by, what, modulus);
		}
	return check_walls(sim);
}
