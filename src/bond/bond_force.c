/* Bond forces, breakage, and the coefficients of bond styles. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "bond/bond_force.h"
#include "bond/bond_loop.h"
#include "bond/bond_moment.h"
#include "box/domain.h"
#include "core/report.h"
#include "math/constants.h"
#include "math/exactsum.h"
#include "neigh/neigh.h"
#include "particle/orientation.h"
#include "particle/particles.h"

#include "base/banned.h"

/* The mode of failure and the elastic energy of a bond that transmits moments. */
static enum ts_status record_failure(struct tsim *sim, size_t b, struct ts_bond_event *e, double *all)
{
	struct ts_bond_element element;
	struct ts_bond_answer state;
	double energy[TS_BOND_MODES];

	/* a section that has cracked is torn at the latest when it has turned so far */
	const bool cracked = sim->bonds->softens && sim->bonds->damage[b].reached > 1;

	ts_bond_state_of(sim, b, &element, &state);
	if (!(state.cosine > TS_BOND_TURN) && !cracked)
		return ts_fail(&sim->error, TS_PHYSICS, NULL,
			       "at step %" PRId64
			       " particles %d and %d, bonded, have turned by %.0f degrees relative to each "
			       "other; bonds that transmit moments are valid up to 90 degrees: give the bond "
			       "a strength, or more stiffness",
			       sim->clock.step, e->tag[0], e->tag[1],
			       360 / TS_PI * acos(fmin(state.cosine, 1)));
	ts_bond_energies(&element, &state, energy);
	*all = 0;
	for (int k = 0; k < TS_BOND_MODES; k++)
		*all += energy[k];
	e->mode = (int32_t)ts_bond_failure_of(&element, &state);
	return TS_OK;
}

/* The elastic energy of a central spring; NaN if the law has none. */
static double spring_energy(const struct tsim *sim, size_t b)
{
	double energy[TS_BOND_MODES];

	if (!ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND))->energy)
		return NAN;
	ts_bond_energy(sim, b, energy);
	return energy[TS_BOND_NORMAL];
}

/* The force along a bond that does not break by it, without damping: tensions are not stored in each step. */
static double force_now(const struct tsim *sim, size_t b)
{
	const struct ts_instance *self = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_bond_style *style = ts_bond_style_of(self);
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_bond_element element;
	struct ts_bond_answer state;
	double d[3], extension;

	if (style->element) {
		ts_bond_state_of(sim, b, &element, &state);
		return state.axial;
	}
	if (!style->spring)
		return bonds->tension[b];
	extension = ts_bond_separation(sim, (size_t)bonds->row[b][0], (size_t)bonds->row[b][1], d) -
		    bonds->rest[b];
	return style->spring(ts_coeff(&((const struct ts_bond *)self->state)->coeffs, (size_t)bonds->type[b]),
			     extension, bonds->rest[b]);
}

static enum ts_status record_breakage(struct tsim *sim, size_t b)
{
	struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)bonds->row[b][0], j = (size_t)bonds->row[b][1];
	struct ts_bond_event *e;
	double d[3];

	if (i >= p->n) /* the other rank records it */
		return TS_OK;
	TS_TRY(ts_bonds_reserve_events(sim, bonds->nevents + 1));
	e = &bonds->event[bonds->nevents++];
	memset(e, 0, sizeof *e); /* events are archived as bytes, padding included */
	e->step = sim->clock.step;
	e->time = ts_sim_time(sim);
	e->force = bonds->breaks[b] > 1 ? force_now(sim, b) : bonds->tension[b];
	e->type = bonds->type[b];
	ts_bond_separation(sim, i, j, d);
	for (int k = 0; k < 3; k++)
		e->x[k] = p->x[j][k] + 0.5 * d[k];
	for (int s = 0; s < 2; s++)
		e->tag[s] = bonds->tag[b][s];
	bonds->event_fresh[bonds->nevents - 1] = bonds->fresh[b];
	bonds->broken++;
	if (bonds->transmits)
		TS_TRY(record_failure(sim, b, e, &bonds->event_energy[bonds->nevents - 1]));
	else
		bonds->event_energy[bonds->nevents - 1] = spring_energy(sim, b);
	if (bonds->breaks[b] > 1)
		e->mode = bonds->breaks[b] - TS_BOND_BREAKS_BY(0);
	return TS_OK;
}

enum ts_status ts_bonds_break(struct tsim *sim)
{
	struct ts_bonds *bonds = sim->bonds;
	unsigned char *broken = bonds->breaks;

	for (size_t b = 0; b < bonds->n; b++)
		if (broken[b])
			TS_TRY(record_breakage(sim, b));
	if (bonds->transmits) {
		TS_TRY(ts_bond_moments_remove(sim, broken));
	} else {
		ts_bonds_delete(bonds, broken);
		TS_TRY(ts_bonds_build_index(sim));
	}
	/* unbonded pairs may be in contact from now on: rebuild the contact list */
	sim->neigh->stale |= sim->neigh->skip_bonded;
	return TS_OK;
}

/* Whether any bond type in use is damped, so that velocities are needed. */
static bool any_type_damped(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_bond *bond = self->state;
	bool any = false;

	for (int type = 1; type <= sim->bonds->ntypes; type++)
		any |= bond->coeffs.given[type] &&
		       ts_bond_style_of(self)->damped(ts_coeff(&bond->coeffs, (size_t)type));
	return any;
}

static bool any_type_softens(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_bond *bond = self->state;
	const struct ts_bond_style *style = ts_bond_style_of(self);
	bool any = false;

	for (int type = 1; style->softens && type <= sim->bonds->ntypes; type++)
		any |= bond->coeffs.given[type] && style->softens(ts_coeff(&bond->coeffs, (size_t)type));
	return any;
}

/* The work that was lost in bonds that soften, in this step. */
static void collect_lost(const struct tsim *sim, struct ts_bonds *b)
{
	b->flow = ts_exactsum_start();
	for (size_t k = 0; k < b->n; k++)
		if (b->lost[k] > 0) {
			if ((size_t)b->row[k][0] < sim->particles->n)
				ts_exactsum_add(&b->flow, b->lost[k]);
			b->lost[k] = 0;
		}
}

/* Computes all bonds; returns how many break, some counted twice. */
static long compute_bonds(const struct ts_instance *self, const struct tsim *sim, struct ts_bond_task *t)
{
	const struct ts_bonds *b = sim->bonds;

	if (b->transmits)
		return ts_parallel_count(b->rows.shares, (size_t)b->rows.shares,
					 ts_bond_style_of(self)->compute, t);
	return ts_parallel_count(ts_team(sim, b->n), b->slices.n, ts_bond_style_of(self)->compute, t);
}

static bool images_drift(const struct ts_domain *domain)
{
	return domain->drift[0] != 0 || domain->drift[1] != 0 || domain->drift[2] != 0;
}

enum ts_status ts_bond_force(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_bond *bond = self->state;
	struct ts_bond_task t = { sim->particles,
				  sim->bonds,
				  &bond->coeffs,
				  &sim->domain->box,
				  any_type_damped(self, sim),
				  sim->run.complete || sim->bonds->shown,
				  sim->bonds->softens,
				  sim->bonds->transmits ? ts_orientation(sim) : NULL,
				  images_drift(sim->domain) ? sim->domain : NULL };
	long broken;

	if (!sim->bonds->n) {
		if (t.softens)
			sim->bonds->flow = ts_exactsum_start();
		return TS_OK;
	}
	if (sim->bonds->transmits)
		TS_TRY(ts_bond_moments_fill(sim, t.moving, t.softens));
	broken = compute_bonds(self, sim, &t);
	if (t.softens)
		collect_lost(sim, sim->bonds);
	return broken ? ts_bonds_break(sim) : TS_OK;
}

static enum ts_status resize_coeffs(struct tsim *sim, struct ts_instance *self)
{
	struct ts_bond *bond = self->state;

	bond->coeffs.rows = self->style->coeff;
	bond->coeffs.size = ts_bond_style_of(self)->coeff_size;
	return ts_coeffs_resize(sim, &bond->coeffs, (size_t)sim->bonds->ntypes + 1);
}

enum ts_status ts_bond_set_coeffs(struct tsim *sim, struct ts_types types, struct ts_words words,
				  const struct ts_place *where)
{
	struct ts_instance *self = ts_sim_only(sim, TS_KIND_BOND);
	struct ts_bond *bond;
	int last = sim->bonds->ntypes > 0 ? sim->bonds->ntypes : 1;

	if (!self)
		return ts_fail(&sim->error, TS_STATE, where, "bond_coeff needs a bond_style before it");
	bond = self->state;
	if (!types.hi)
		types.hi = last;
	if (types.hi > 1000)
		return ts_fail(&sim->error, TS_RANGE, where, "bond type %d: at most 1000", types.hi);
	if (types.hi > sim->bonds->ntypes)
		sim->bonds->ntypes = types.hi;
	TS_TRY(resize_coeffs(sim, self));
	for (int t = types.lo; t <= types.hi; t++) {
		void *entry = ts_coeff(&bond->coeffs, (size_t)t);

		TS_TRY(ts_coeff_parse(sim, "bond_coeff", &bond->coeffs, words, where, entry));
		TS_TRY(ts_bond_style_of(self)->complete(sim, entry, where));
		bond->coeffs.given[t] = true;
	}
	sim->bonds->rows.filled = false;
	ts_bonds_set_lengths(sim);
	return TS_OK;
}

bool ts_bond_has_coeffs(const struct tsim *sim, int64_t type)
{
	const struct ts_instance *style = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_bond *bond = style ? style->state : NULL;

	return bond && type <= sim->bonds->ntypes && (size_t)type < bond->coeffs.n &&
	       bond->coeffs.given[type];
}

enum ts_status ts_bond_init(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_bonds *bonds = sim->bonds;

	TS_TRY(resize_coeffs(sim, self));
	sim->bonds->flow = ts_exactsum_start();
	for (size_t b = 0; b < bonds->n; b++)
		if (!ts_bond_has_coeffs(sim, bonds->type[b]))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "there are bonds of type %d, but no `bond_coeff %d ...`",
				       bonds->type[b], bonds->type[b]);
	ts_bonds_set_lengths(sim);
	TS_TRY(ts_bonds_soften(sim, any_type_softens(self, sim)));
	if (ts_bond_style_of(self)->element)
		TS_TRY(ts_bond_moments_require(sim));
	else
		TS_TRY(ts_bonds_transmit(sim, false));
	return ts_bonds_allow(sim);
}

enum ts_status ts_bonds_allow(struct tsim *sim)
{
	struct ts_instance *self = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_bond_style *style = self ? ts_bond_style_of(self) : NULL;

	if (!style || !sim->bonds->n)
		return TS_OK;
	if (style->element)
		TS_TRY(ts_bond_moments_allow(self, sim));
	return style->allow ? style->allow(self, sim) : TS_OK;
}

enum ts_status ts_bond_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_bond *bond = self->state;

	TS_TRY(resize_coeffs(sim, self));
	TS_TRY(ts_coeffs_archive(a, sim, &bond->coeffs));
	for (size_t k = 0; !ts_archive_writing(a) && k < bond->coeffs.n; k++)
		if (bond->coeffs.given[k])
			TS_TRY(ts_bond_style_of(self)->complete(sim, ts_coeff(&bond->coeffs, k),
								&self->where));
	if (ts_bond_style_of(self)->element)
		return ts_orientation_archive(sim, a);
	return TS_OK;
}

void ts_bond_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_bond *bond = self->state;

	ts_coeffs_fingerprint(&bond->coeffs, sim, hash);
}

/* 1/m_i + 1/m_j */
static double inverse_mass(const struct tsim *sim, size_t b)
{
	const struct ts_particles *p = sim->particles;

	return p->imass[sim->bonds->row[b][0]] + p->imass[sim->bonds->row[b][1]];
}

static const void *coeff_of(const struct tsim *sim, size_t b)
{
	const struct ts_bond *bond = ts_sim_only(sim, TS_KIND_BOND)->state;

	return ts_coeff(&bond->coeffs, (size_t)sim->bonds->type[b]);
}

double ts_bond_limit(const struct tsim *sim, size_t b, bool explicit_euler)
{
	const struct ts_bond_style *style = ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND));
	double imass = inverse_mass(sim, b);

	if (style->element)
		return ts_bond_moment_limit(sim, b);
	if (!(imass > 0))
		return INFINITY;
	return style->limit(coeff_of(sim, b), sim->bonds->rest[b], 1 / imass, explicit_euler);
}

double ts_bond_stretch_time(const struct tsim *sim, size_t b)
{
	const struct ts_bond_style *style = ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND));
	double imass = inverse_mass(sim, b);
	struct ts_bond_element e;

	if (!style->element)
		return 1 / sqrt(style->stiffness(coeff_of(sim, b), sim->bonds->rest[b]) * imass);
	ts_bond_constants(sim, b, &e);
	return 1 / sqrt(e.k[TS_BOND_NORMAL] * imass);
}

static double smallest_limit(const struct tsim *sim)
{
	const size_t n = sim->bonds->n;
	double smallest = INFINITY;

	/* a limit costs as much as many iterations of a simple loop */
#pragma omp parallel for num_threads(ts_team(sim, 16 * n)) schedule(static) reduction(min : smallest)
	for (size_t b = 0; b < n; b++)
		smallest = fmin(smallest, ts_bond_limit(sim, b, sim->run.explicit_euler));
	return smallest;
}

enum ts_status ts_bond_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_bond_style *style = ts_bond_style_of(self);
	const struct ts_bonds *bonds = sim->bonds;

	if (!bonds->n)
		return TS_OK;
	if (style->element && sim->run.explicit_euler)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "bond_style %s transmits moments, but fix nve/euler does not integrate "
			       "rotation; use fix nve/sphere",
			       self->style->name);
	return ts_report_limit(report, smallest_limit(sim), !sim->run.explicit_euler, &self->where,
			       "a single bond%s", sim->run.explicit_euler ? " under fix nve/euler" : "");
}

void ts_bond_fini(struct ts_instance *self)
{
	struct ts_bond *bond = self->state;

	ts_coeffs_release(&bond->coeffs);
}
