#include "contact/limits.h"

#include <math.h>
#include <stdio.h>

#include "core/ranks.h"
#include "insert/template.h"
#include "material/property.h"
#include "particle/prescribed.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* Of equal ones the smaller: so their order does not matter. */
static bool comes_before(const struct ts_lightest *l, int k, double inverse_mass, double radius)
{
	return inverse_mass > l->inverse_mass[k] ||
	       (inverse_mass == l->inverse_mass[k] && radius < l->radius[k]);
}

static void insert_lightest(struct ts_lightest *l, double inverse_mass, double radius)
{
	int k = comes_before(l, 0, inverse_mass, radius)   ? 0
		: comes_before(l, 1, inverse_mass, radius) ? 1
							   : 2;

	if (k == 2)
		return;
	if (k == 0) {
		l->inverse_mass[1] = l->inverse_mass[0];
		l->radius[1] = l->radius[0];
	}
	l->inverse_mass[k] = inverse_mass;
	l->radius[k] = radius;
}

/* By type, while the particles are divided among ranks: of the first particles of the lists of all ranks the one that comes
 * first, which leaves the list of one rank that has it. */
struct first_of_ranks {
	double *inverse_mass, *radius, *rank;
};

static void take_first(const struct tsim *sim, struct ts_lightest *list, const struct first_of_ranks *f)
{
	size_t n = (size_t)sim->particles->ntypes + 1;
	const double own = sim->world->rank;

	for (size_t t = 0; t < n; t++)
		f->inverse_mass[t] = list[t].inverse_mass[0];
	ts_ranks_most_of(sim, f->inverse_mass, n);
	for (size_t t = 0; t < n; t++)
		f->radius[t] = list[t].inverse_mass[0] == f->inverse_mass[t] ? -list[t].radius[0] : -INFINITY;
	ts_ranks_most_of(sim, f->radius, n);
	for (size_t t = 0; t < n; t++) {
		bool has =
			list[t].inverse_mass[0] == f->inverse_mass[t] && -list[t].radius[0] == f->radius[t];

		f->rank[t] = has ? own : -1;
	}
	ts_ranks_most_of(sim, f->rank, n);
	for (size_t t = 0; t < n; t++)
		if (f->rank[t] == own) {
			list[t].inverse_mass[0] = list[t].inverse_mass[1];
			list[t].radius[0] = list[t].radius[1];
			list[t].inverse_mass[1] = -1;
		}
}

/* Returns the list with the particles of all ranks, or NULL without memory. */
static struct ts_lightest *merge_ranks(const struct tsim *sim, struct ts_lightest *list)
{
	size_t n = (size_t)sim->particles->ntypes + 1;
	double *number = sim->division ? ts_alloc(6 * n, sizeof *number) : NULL;

	if (list && number) {
		for (size_t m = 0; m < 2; m++)
			take_first(sim, list,
				   &(struct first_of_ranks){ number + (3 * m) * n, number + (3 * m + 1) * n,
							     number + (3 * m + 2) * n });
		for (size_t t = 0; t < n; t++)
			list[t] = (struct ts_lightest){ { number[t], number[3 * n + t] },
							{ -number[n + t], -number[4 * n + t] } };
	} else if (sim->division) {
		ts_free(list);
		list = NULL;
	}
	ts_free(number);
	return list;
}

struct ts_lightest *ts_lightest(const struct tsim *sim, int group)
{
	const struct ts_particles *p = sim->particles;
	const uint32_t prescribed = ts_prescribed(sim);
	struct ts_lightest *list = ts_alloc((size_t)p->ntypes + 1, sizeof *list);

	for (int t = 0; list && t <= p->ntypes; t++)
		list[t].inverse_mass[0] = list[t].inverse_mass[1] = -1;
	for (size_t i = 0; list && i < p->n; i++)
		if (ts_in_group(p, i, group))
			insert_lightest(&list[p->type[i]], p->mask[i] & prescribed ? 0 : p->imass[i],
					p->radius[i]);
	list = merge_ranks(sim, list);
	for (int t = 1; list && t <= p->ntypes; t++) {
		double radius, inverse_mass = ts_template_inverse_mass(sim, t, &radius);

		/* two, as there will be several particles of the template */
		for (int k = 0; k < 2 && inverse_mass > 0; k++)
			insert_lightest(&list[t], inverse_mass, radius);
	}
	return list;
}

/* Without an integrator contacts cannot oscillate (e.g. heat conduction in a packing at rest). */
static bool any_integrator(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	bool some = false;

	for (size_t k = 0; k < fixes->n; k++)
		some |= fixes->item[k]->style->hook[TS_STAGE_INITIAL_INTEGRATE] != NULL;
	return some;
}

enum ts_status ts_contact_report_limits(struct ts_plan_report *report, const struct tsim *sim,
					const struct ts_place *where, const struct ts_contact_case *c,
					const char *what)
{
	bool stiffens = ts_granular_stiffens(c->model), euler = sim->run.explicit_euler;
	const char *how = euler ? " under fix nve/euler" : "";
	double overlap = 1, limit, slip;
	char depth[48] = "";

	if (stiffens) {
		overlap = fmax(c->overlap,
			       ts_granular_impact_overlap(c->model, c->law, c->r_eff, c->m_eff, c->speed));
		snprintf(depth, sizeof depth, ", overlap %.3g", overlap);
	}
	if (!(overlap > 0) || !isfinite(overlap) || !any_integrator(sim))
		return TS_OK;
	limit = ts_granular_limit(c->model, c->law, c->r_eff, c->m_eff, overlap, euler);
	slip = ts_granular_slip_limit(c->model, c->law, c->r_eff, c->m_eff, overlap, ts_inertia_factor(sim),
				      euler);
	if (isfinite(limit))
		TS_TRY(ts_report_limit(report, limit, !euler && !stiffens, where,
				       "a contact %s (m* = %.4g%s)%s", what, c->m_eff, depth, how));
	if (isfinite(slip))
		TS_TRY(ts_report_limit(report, slip, false, where, "the slip of a contact %s (m* = %.4g%s)%s",
				       what, c->m_eff, depth, how));
	return TS_OK;
}

/* ---- Rayleigh time and Hertz time ---- */

static enum ts_status read_elastic_constants(struct tsim *sim, int type, const char *who,
					     const struct ts_place *where, double *young, double *nu)
{
	TS_TRY(ts_property_value(sim, "youngsModulus", type, 0, who, where, young));
	return ts_property_value(sim, "poissonsRatio", type, 0, who, where, nu);
}

/* By type, the least value of `number` over the particles of the group; infinite where there is none. */
typedef double number_fn(const struct tsim *sim, size_t i);
static double *least_by_type(const struct tsim *sim, int group, number_fn *number)
{
	const struct ts_particles *p = sim->particles;
	double *least = ts_alloc((size_t)p->ntypes + 1, sizeof *least);

	for (int t = 0; least && t <= p->ntypes; t++)
		least[t] = INFINITY;
	for (size_t i = 0; least && i < p->n; i++)
		if (ts_in_group(p, i, group))
			least[p->type[i]] = fmin(least[p->type[i]], number(sim, i));
	return least;
}

/* The Rayleigh time is proportional to it. */
static double radius_root_density(const struct tsim *sim, size_t i)
{
	return sim->particles->radius[i] * sqrt(ts_rigid_material_density(sim, i));
}

static enum ts_status least_rayleigh_time(struct tsim *sim, int group, const char *who,
					  const struct ts_place *where, double *out)
{
	double *least = least_by_type(sim, group, radius_root_density), young, nu;
	enum ts_status status = least ? TS_OK : ts_nomem(&sim->error);

	*out = INFINITY;
	for (int t = 1; status == TS_OK && t <= sim->particles->ntypes; t++) {
		if (isinf(least[t]))
			continue;
		status = read_elastic_constants(sim, t, who, where, &young, &nu);
		if (status == TS_OK)
			*out = fmin(*out, ts_rayleigh_time(least[t], 1, young / (2 * (1 + nu)), nu));
	}
	ts_free(least);
	return status;
}

/* Effective modulus Y* of two types. */
static enum ts_status effective_young(struct tsim *sim, int a, int b, const char *who,
				      const struct ts_place *where, double *out)
{
	double young[2], nu[2];

	TS_TRY(read_elastic_constants(sim, a, who, where, &young[0], &nu[0]));
	TS_TRY(read_elastic_constants(sim, b, who, where, &young[1], &nu[1]));
	*out = 1 / ((1 - nu[0] * nu[0]) / young[0] + (1 - nu[1] * nu[1]) / young[1]);
	return TS_OK;
}

/* m*^2/R* grows with the mass of either particle, so it is enough to check the lightest ones: of one type the
 * two lightest, or one with itself if it is the only one. */
static enum ts_status least_hertz_time(struct tsim *sim, const struct ts_lightest *list, double speed,
				       const char *who, const struct ts_place *where, double *out)
{
	int n = sim->particles->ntypes;

	for (int a = 1; a <= n; a++) {
		for (int b = a; b <= n; b++) {
			const struct ts_lightest *one = &list[a], *other = &list[b];
			int k = a == b && other->inverse_mass[1] >= 0;
			double sum = one->inverse_mass[0] + other->inverse_mass[k], r, young;

			if (one->inverse_mass[0] < 0 || other->inverse_mass[k] < 0 || !(sum > 0))
				continue;
			TS_TRY(effective_young(sim, a, b, who, where, &young));
			r = one->radius[0] * other->radius[k] / (one->radius[0] + other->radius[k]);
			*out = fmin(*out, ts_hertz_time(r, 1 / sum, young, speed));
		}
	}
	return TS_OK;
}

/* The Hertz time of a particle and an equal one is proportional to this to the power 1/5. */
static double mass2_by_radius(const struct tsim *sim, size_t i)
{
	double radius = sim->particles->radius[i];
	double mass = ts_rigid_material_density(sim, i) * ts_particle_volume(sim, radius);

	return mass * mass / (0.5 * radius);
}

static enum ts_status least_legacy_hertz_time(struct tsim *sim, int group, double speed, const char *who,
					      const struct ts_place *where, double *out)
{
	double *least = least_by_type(sim, group, mass2_by_radius), young;
	enum ts_status status = least ? TS_OK : ts_nomem(&sim->error);

	for (int t = 1; status == TS_OK && t <= sim->particles->ntypes; t++) {
		if (isinf(least[t]))
			continue;
		status = effective_young(sim, t, t, who, where, &young);
		if (status == TS_OK)
			*out = fmin(*out, ts_hertz_time(1 / least[t], 1, young, speed));
	}
	ts_free(least);
	return status;
}

enum ts_status ts_granular_times(struct tsim *sim, int group, double speed, bool legacy, const char *who,
				 const struct ts_place *where, struct ts_granular_times *out)
{
	struct ts_lightest *list;
	enum ts_status status;

	out->hertz = INFINITY;
	TS_TRY(least_rayleigh_time(sim, group, who, where, &out->rayleigh));
	if (!(speed > 0))
		return TS_OK;
	if (legacy)
		return least_legacy_hertz_time(sim, group, speed, who, where, &out->hertz);
	list = ts_lightest(sim, group);
	if (!list)
		return ts_nomem(&sim->error);
	status = least_hertz_time(sim, list, speed, who, where, &out->hertz);
	ts_free(list);
	return status;
}
