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

static struct ts_exactsum heat_content(const struct tsim *sim, const struct ts_heat *heat)
{
	const struct ts_particles *p = sim->particles;
	const double *temperature = ts_heat_column(sim, heat->temperature);
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < p->n && heat->capacity; i++)
		ts_exactsum_add(&sum, p->mass[i] * heat->capacity[p->type[i]] * temperature[i]);
	return sum;
}

/* Sum of a column over the particles whose temperature changes. */
static struct ts_exactsum sum_over_group(const struct tsim *sim, const struct ts_instance *inst,
					 size_t column)
{
	const double *value = ts_heat_column(sim, column);
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t i = 0; i < sim->particles->n; i++)
		if (ts_in_group(sim->particles, i, inst->group))
			ts_exactsum_add(&sum, value[i]);
	return sum;
}

static enum ts_status post_content(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				   const double *value)
{
	double before = l->heat.now;

	(void)sim, (void)entry;
	l->heat.now = value[0];
	if (l->open && l->heat.known)
		ts_compensated_add(&l->heat.moved, l->heat.now - before);
	else
		l->heat.start = l->heat.now;
	l->heat.known = 1;
	return TS_OK;
}

enum ts_status ts_ledger_heat_update(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_instance *inst = active_heat_fix(sim);
	struct ts_ledger_entry entry = { .post = post_content, .n = 1 };
	struct ts_exactsum sum;

	if (!inst)
		return TS_OK;
	sum = heat_content(sim, inst->state);
	return ts_ledger_enter(sim, l, &entry, &sum);
}

void ts_ledger_heat_clear(struct ts_ledger *l)
{
	l->heat.seen = 0;
	for (size_t a = 0; a < l->nactors; a++)
		l->actor[a].heat_rate = 0;
}

static enum ts_status post_flux(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				const double *value)
{
	(void)sim;
	l->actor[entry->at].heat_rate += value[0] - l->heat.seen;
	l->heat.seen = value[0];
	return TS_OK;
}

enum ts_status ts_ledger_heat_flux(struct tsim *sim, struct ts_ledger *l, size_t actor)
{
	const struct ts_instance *inst = active_heat_fix(sim);
	struct ts_ledger_entry entry = { .post = post_flux, .at = actor, .n = 1 };
	struct ts_exactsum sum;

	if (!inst)
		return TS_OK;
	sum = sum_over_group(sim, inst, ((const struct ts_heat *)inst->state)->flux);
	return ts_ledger_enter(sim, l, &entry, &sum);
}

/* Values: source and content. */
static enum ts_status post_advance(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				   const double *value)
{
	double before = l->heat.now, h = entry->factor, source = h * value[0], sum = 0;

	(void)sim;
	l->heat.now = value[1];
	for (size_t a = 0; a < l->nactors; a++) {
		ts_compensated_add(&l->actor[a].heat, h * l->actor[a].heat_rate);
		sum += h * l->actor[a].heat_rate;
	}
	ts_compensated_add(&l->heat.source, source);
	if (entry->flags & TS_LEDGER_EXACT)
		ts_compensated_add(&l->actor[entry->at].heat, l->heat.now - before - sum - source);
	return TS_OK;
}

enum ts_status ts_ledger_heat_advance(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by,
				      size_t actor)
{
	const struct ts_instance *inst = active_heat_fix(sim);
	struct ts_ledger_entry entry = { .post = post_advance, .at = actor, .factor = sim->clock.dt, .n = 2 };
	const struct ts_heat *heat;
	struct ts_exactsum sum[2];

	if (!inst || inst != by)
		return TS_OK;
	heat = inst->state;
	entry.flags = heat->scheme == TS_HEAT_EXACT ? TS_LEDGER_EXACT : 0;
	sum[0] = sum_over_group(sim, inst, heat->source);
	sum[1] = heat_content(sim, heat);
	return ts_ledger_enter(sim, l, &entry, sum);
}

double ts_ledger_heat_closure(const struct ts_ledger *l)
{
	double sum = l->heat.now - l->heat.start - ts_compensated_value(&l->heat.source) -
		     ts_compensated_value(&l->heat.moved);

	for (size_t a = 0; a < l->nactors; a++)
		sum -= ts_compensated_value(&l->actor[a].heat);
	return l->heat.known ? sum : 0;
}
