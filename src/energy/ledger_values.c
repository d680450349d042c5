/* Output values of the ledger, and its archive functions. */
#include <stdio.h>
#include <string.h>

#include "energy/ledger.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Change of a store of elastic energy, without what came or went with particles. */
static double elastic_energy_gain(const struct ts_ledger *l, int store)
{
	return l->store[store] - l->start_store[store] - ts_compensated_value(&l->moved[store]);
}

static double work_of_part(const struct ts_ledger *l, int side, int part)
{
	return ts_compensated_value(&l->work[ts_ledger_cause(side, part)]);
}

/* Elastic energy gained minus the work put in: the drift of normal springs. */
static double normal_spring_drift(const struct ts_ledger *l, int side)
{
	return elastic_energy_gain(l, ts_ledger_store(side, TS_STORE_NORMAL)) +
	       work_of_part(l, side, TS_PART_NORMAL);
}

static double bond_drift(const struct ts_ledger *l)
{
	double gain = elastic_energy_gain(l, TS_LEDGER_BOND);

	for (int mode = 1; mode < TS_BOND_MODES; mode++)
		gain += elastic_energy_gain(l, TS_LEDGER_BOND + mode);
	return gain + ts_compensated_value(&l->work[TS_CAUSE_BOND]) + ts_compensated_value(&l->broken) +
	       ts_compensated_value(&l->yielded);
}

/* Springs of sliding and rolling friction store a part of the work put in; the rest is dissipated. */
static void add_side_values(const struct ts_ledger *l, int side, double out[])
{
	double slip = ts_compensated_value(&l->slip[side]);

	out[TS_LEDGER_NORMAL_DASHPOTS_VALUE] -= work_of_part(l, side, TS_PART_DASHPOT);
	out[TS_LEDGER_TANGENTIAL_DASHPOTS_VALUE] -= work_of_part(l, side, TS_PART_VISCOUS);
	out[TS_LEDGER_FRICTION_VALUE] += slip - work_of_part(l, side, TS_PART_SLIP);
	out[TS_LEDGER_SPRINGS_VALUE] -= work_of_part(l, side, TS_PART_SHEAR) +
					elastic_energy_gain(l, ts_ledger_store(side, TS_STORE_SHEAR)) + slip;
	out[TS_LEDGER_ROLLING_VALUE] -= work_of_part(l, side, TS_PART_ROLLING) +
					elastic_energy_gain(l, ts_ledger_store(side, TS_STORE_ROLLING));
	out[l->plastic[side] ? TS_LEDGER_PLASTIC_VALUE : TS_LEDGER_DRIFT_VALUE] +=
		l->plastic[side] ? -normal_spring_drift(l, side) : normal_spring_drift(l, side);
	for (int k = 0; k < TS_NCONTACT_STORE; k++)
		out[side ? TS_LEDGER_WALLS_VALUE : TS_LEDGER_CONTACTS_VALUE] +=
			l->store[ts_ledger_store(side, k)];
}

/* Change of kinetic energy that is not accounted for. */
static double closure(const struct ts_ledger *l, const double v[])
{
	double sum = v[TS_LEDGER_TRANSLATION_VALUE] - l->start_kinetic[0] + v[TS_LEDGER_ROTATION_VALUE] -
		     l->start_kinetic[1];

	for (int c = 0; c < TS_NCAUSE; c++)
		sum -= ts_compensated_value(&l->work[c]);
	for (size_t a = 0; a < l->nactors; a++)
		sum -= ts_compensated_value(&l->actor[a].work) + ts_compensated_value(&l->actor[a].own);
	return sum - ts_compensated_value(&l->box) - ts_compensated_value(&l->held) -
	       ts_compensated_value(&l->between) - ts_compensated_value(&l->turning);
}

static double turnover(const struct ts_ledger *l)
{
	double largest = fmax(l->largest_energy, fmax(l->drive.turnover, l->held.turnover));

	for (int c = 0; c < TS_NCAUSE; c++)
		largest = fmax(largest, l->work[c].turnover);
	for (size_t a = 0; a < l->nactors; a++)
		largest = fmax(largest, fmax(l->actor[a].work.turnover, l->actor[a].own.turnover));
	return largest;
}

void ts_ledger_drifts(const struct ts_ledger *l, double out[TS_NSTORE + 1])
{
	memset(out, 0, (TS_NSTORE + 1) * sizeof *out);
	for (int side = 0; side < TS_LEDGER_SIDES; side++)
		if (!l->plastic[side])
			out[ts_ledger_store(side, TS_STORE_NORMAL)] = normal_spring_drift(l, side);
	out[TS_LEDGER_BOND] = bond_drift(l);
	out[TS_NSTORE] = ts_compensated_value(&l->turning);
}

static void heat_values(const struct ts_ledger *l, double out[])
{
	out[TS_LEDGER_HEAT_VALUE] = l->heat.now;
	out[TS_LEDGER_HEAT_IN_VALUE] = ts_compensated_value(&l->heat.source);
	for (size_t a = 0; a < l->nactors; a++)
		out[TS_LEDGER_HEAT_IN_VALUE] += ts_compensated_value(&l->actor[a].heat);
	out[TS_LEDGER_HEAT_MOVED_VALUE] = ts_compensated_value(&l->heat.moved);
	out[TS_LEDGER_HEAT_CLOSURE_VALUE] = ts_ledger_heat_closure(l);
}

void ts_ledger_values(const struct ts_ledger *l, double out[TS_LEDGER_VALUES])
{
	memset(out, 0, TS_LEDGER_VALUES * sizeof *out);
	if (!l->open)
		return;
	out[TS_LEDGER_TRANSLATION_VALUE] = l->kinetic[0];
	out[TS_LEDGER_ROTATION_VALUE] = l->kinetic[1];
	for (int side = 0; side < TS_LEDGER_SIDES; side++)
		add_side_values(l, side, out);
	for (int mode = 0; mode < TS_BOND_MODES; mode++) {
		out[TS_LEDGER_BOND_NORMAL_VALUE + mode] = l->store[TS_LEDGER_BOND + mode];
		out[TS_LEDGER_BONDS_VALUE] += l->store[TS_LEDGER_BOND + mode];
	}
	for (int k = TS_LEDGER_TRANSLATION_VALUE; k <= TS_LEDGER_BONDS_VALUE; k++)
		out[TS_LEDGER_TOTAL_VALUE] += out[k];
	for (size_t a = 0; a < l->nactors; a++) {
		out[TS_LEDGER_FORCES_VALUE] += ts_compensated_value(&l->actor[a].work);
		out[TS_LEDGER_MOVED_VALUE] += ts_compensated_value(&l->actor[a].own);
	}
	out[TS_LEDGER_FORCES_VALUE] -= ts_compensated_value(&l->drive);
	out[TS_LEDGER_DRIVE_VALUE] = ts_compensated_value(&l->drive) + ts_compensated_value(&l->box);
	out[TS_LEDGER_MOVED_VALUE] += ts_compensated_value(&l->held) + ts_compensated_value(&l->between);
	for (int k = 0; k < TS_NSTORE; k++)
		out[TS_LEDGER_MOVED_VALUE] += ts_compensated_value(&l->moved[k]);
	out[TS_LEDGER_BOND_DASHPOTS_VALUE] = -ts_compensated_value(&l->work[TS_CAUSE_BOND_DASHPOT]);
	out[TS_LEDGER_PLASTIC_VALUE] += ts_compensated_value(&l->yielded);
	out[TS_LEDGER_BROKEN_VALUE] = ts_compensated_value(&l->broken);
	for (int k = TS_LEDGER_NORMAL_DASHPOTS_VALUE; k <= TS_LEDGER_BROKEN_VALUE; k++)
		out[TS_LEDGER_LOST_VALUE] += out[k];
	out[TS_LEDGER_CLOSURE_VALUE] = closure(l, out);
	out[TS_LEDGER_DRIFT_VALUE] += bond_drift(l) + ts_compensated_value(&l->turning);
	out[TS_LEDGER_TURNOVER_VALUE] = turnover(l);
	heat_values(l, out);
}

static enum ts_status archive_numbers(struct ts_archive *a, struct ts_ledger *l)
{
	TS_TRY(ts_archive_fixed(a, "open", TS_SAVED_I64, &l->open, 1));
	TS_TRY(ts_archive_fixed(a, "split", TS_SAVED_I64, &l->split, 1));
	TS_TRY(ts_archive_fixed(a, "plastic", TS_SAVED_I64, l->plastic, TS_LEDGER_SIDES));
	TS_TRY(ts_archive_fixed(a, "first", TS_SAVED_I64, &l->first, 1));
	TS_TRY(ts_archive_fixed(a, "first_time", TS_SAVED_F64, &l->first_time, 1));
	TS_TRY(ts_archive_fixed(a, "start_kinetic", TS_SAVED_F64, l->start_kinetic, 2));
	TS_TRY(ts_archive_fixed(a, "start_store", TS_SAVED_F64, l->start_store, TS_NSTORE));
	TS_TRY(ts_archive_fixed(a, "kinetic", TS_SAVED_F64, l->kinetic, 2));
	TS_TRY(ts_archive_fixed(a, "store", TS_SAVED_F64, l->store, TS_NSTORE));
	TS_TRY(ts_archive_fixed(a, "work", TS_SAVED_F64, l->work, 3 * TS_NCAUSE));
	TS_TRY(ts_archive_fixed(a, "drive", TS_SAVED_F64, &l->drive, 3));
	TS_TRY(ts_archive_fixed(a, "box", TS_SAVED_F64, &l->box, 3));
	TS_TRY(ts_archive_fixed(a, "heat", TS_SAVED_F64, &l->heat, sizeof l->heat / sizeof(double)));
	TS_TRY(ts_archive_fixed(a, "slip", TS_SAVED_F64, l->slip, 3 * TS_LEDGER_SIDES));
	TS_TRY(ts_archive_fixed(a, "broken", TS_SAVED_F64, &l->broken, 3));
	TS_TRY(ts_archive_fixed(a, "yielded", TS_SAVED_F64, &l->yielded, 3));
	TS_TRY(ts_archive_fixed(a, "turning", TS_SAVED_F64, &l->turning, 3));
	TS_TRY(ts_archive_fixed(a, "held", TS_SAVED_F64, &l->held, 3));
	TS_TRY(ts_archive_fixed(a, "between", TS_SAVED_F64, &l->between, 3));
	TS_TRY(ts_archive_fixed(a, "moved", TS_SAVED_F64, l->moved, 3 * TS_NSTORE));
	TS_TRY(ts_archive_fixed(a, "most", TS_SAVED_F64, &l->largest_energy, 1));
	return ts_archive_fixed(a, "newest", TS_SAVED_I32, &l->newest, 1);
}

static enum ts_status archive_actor(struct ts_archive *a, struct tsim *sim, struct ts_ledger *l, size_t k)
{
	struct ts_ledger_actor *actor = &l->actor[k];
	double number[10] = { actor->work.sum,	    actor->work.lost, actor->work.turnover,
			      actor->own.sum,	    actor->own.lost,  actor->own.turnover,
			      actor->heat.sum,	    actor->heat.lost, actor->heat.turnover,
			      (double)actor->pushes };
	char name[40];

	snprintf(name, sizeof name, "actor %zu", k);
	TS_TRY(ts_archive_string(a, name, &actor->name));
	snprintf(name, sizeof name, "books %zu", k);
	TS_TRY(ts_archive_fixed(a, name, TS_SAVED_F64, number, 10));
	actor->work = (struct ts_compensated_sum){ number[0], number[1], number[2] };
	actor->own = (struct ts_compensated_sum){ number[3], number[4], number[5] };
	actor->heat = (struct ts_compensated_sum){ number[6], number[7], number[8] };
	if (!(number[9] >= 0 && number[9] <= INT32_MAX))
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "invalid state of an energy ledger");
	actor->pushes = (int)number[9];
	return TS_OK;
}

enum ts_status ts_ledger_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_ledger *l = self->state;
	int64_t n = (int64_t)l->nactors;

	TS_TRY(archive_numbers(a, l));
	TS_TRY(ts_archive_fixed(a, "actors", TS_SAVED_I64, &n, 1));
	if (n < 0 || n > 1000000)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "invalid state of an energy ledger");
	if (!ts_archive_writing(a)) {
		l->nactors = 0;
		if (TS_GROW(l->actor, l->actor_capacity, (size_t)n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		memset(l->actor, 0, ((size_t)n + 1) * sizeof *l->actor);
		l->nactors = (size_t)n;
	}
	for (size_t k = 0; k < l->nactors; k++)
		TS_TRY(archive_actor(a, sim, l, k));
	return ts_ledger_archive_columns(sim, l, a);
}
