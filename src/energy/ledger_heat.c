/* Balance of the heat content of the particles, sum m c T, by source. Dissipated kinetic energy does
 * not become heat, so this balance is separate from the mechanical one.
 *
 * Explicit Euler adds h times the flux to each particle, so the fluxes that each action adds, times h,
 * are the gain to rounding; conduction between particles adds nothing. With `scheme exact` fluxes
 * change within the step: the difference is attributed to the heat fix. */
#include "energy/ledger.h"
#include "heat/heat.h"
#include "particle/particles.h"

#include "base/banned.h"

static const struct ts_instance *active_heat_fix(const struct tsim *sim)
{
	size_t k = 0;
	const struct ts_instance *inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_HEAT, &k);

	return inst && ((const struct ts_heat *)inst->state)->ready ? inst : NULL;
}

static double heat_content(const struct tsim *sim, const struct ts_heat *heat)
{
	const struct ts_particles *p = sim->particles;
	const double *temperature = ts_heat_column(sim, heat->temperature);
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < p->n && heat->capacity; i++)
		ts_exactsum_add(&sum, p->mass[i] * heat->capacity[p->type[i]] * temperature[i]);
	return ts_exactsum_value(&sum);
}

/* Sum of a column over the particles whose temperature changes. */
static double sum_over_group(const struct tsim *sim, const struct ts_instance *inst, size_t column)
{
	const double *value = ts_heat_column(sim, column);
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < sim->particles->n; i++)
		if (ts_in_group(sim->particles, i, inst->group))
			ts_exactsum_add(&sum, value[i]);
	return ts_exactsum_value(&sum);
}

void ts_ledger_heat_update(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_instance *inst = active_heat_fix(sim);
	double before = l->heat.now;

	if (!inst)
		return;
	l->heat.now = heat_content(sim, inst->state);
	if (l->open && l->heat.known)
		ts_compensated_add(&l->heat.moved, l->heat.now - before);
	else
		l->heat.start = l->heat.now;
	l->heat.known = 1;
}

void ts_ledger_heat_clear(struct ts_ledger *l)
{
	l->heat.seen = 0;
	for (size_t a = 0; a < l->nactors; a++)
		l->actor[a].heat_rate = 0;
}

void ts_ledger_heat_flux(struct tsim *sim, struct ts_ledger *l, size_t actor)
{
	const struct ts_instance *inst = active_heat_fix(sim);
	double flux;

	if (!inst)
		return;
	flux = sum_over_group(sim, inst, ((const struct ts_heat *)inst->state)->flux);
	l->actor[actor].heat_rate += flux - l->heat.seen;
	l->heat.seen = flux;
}

void ts_ledger_heat_advance(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by, size_t actor)
{
	const struct ts_instance *inst = active_heat_fix(sim);
	const struct ts_heat *heat;
	double before = l->heat.now, h = sim->clock.dt, source, sum = 0;

	if (!inst || inst != by)
		return;
	heat = inst->state;
	source = h * sum_over_group(sim, inst, heat->source);
	l->heat.now = heat_content(sim, heat);
	for (size_t a = 0; a < l->nactors; a++) {
		ts_compensated_add(&l->actor[a].heat, h * l->actor[a].heat_rate);
		sum += h * l->actor[a].heat_rate;
	}
	ts_compensated_add(&l->heat.source, source);
	if (heat->scheme == TS_HEAT_EXACT)
		ts_compensated_add(&l->actor[actor].heat, l->heat.now - before - sum - source);
}

double ts_ledger_heat_closure(const struct ts_ledger *l)
{
	double sum = l->heat.now - l->heat.start - ts_compensated_value(&l->heat.source) -
		     ts_compensated_value(&l->heat.moved);

	for (size_t a = 0; a < l->nactors; a++)
		sum -= ts_compensated_value(&l->actor[a].heat);
	return l->heat.known ? sum : 0;
}
