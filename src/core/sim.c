#include "core/sim.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"

#include "base/banned.h"

double ts_sim_time(const struct tsim *sim)
{
	const struct ts_clock *c = &sim->clock;

	return c->base_time + (double)(c->step - c->base_step) * c->dt;
}

void ts_sim_set_dt(struct tsim *sim, double dt)
{
	if (dt == sim->clock.dt) /* given again after read_restart: a new base would round the time */
		return;
	ts_deferred_loops_run(sim); /* some belong to the step that ends with the old dt */
	sim->clock.base_time = ts_sim_time(sim);
	sim->clock.base_step = sim->clock.step;
	sim->clock.dt = dt;
}

bool ts_sim_time_is_up(const struct tsim *sim)
{
	int64_t done = sim->clock.step - sim->clock.first_step;

	return sim->run.timeout > 0 && done % sim->run.timeout_every == 0 && ts_clock() >= sim->run.timeout;
}

struct ts_instance *ts_sim_find(const struct tsim *sim, enum ts_kind kind, const char *id)
{
	const struct ts_instances *list = &sim->instances[kind];

	for (size_t k = 0; k < list->n; k++)
		if (ts_streq(list->item[k]->id, id))
			return list->item[k];
	return NULL;
}

struct ts_instance *ts_sim_only(const struct tsim *sim, enum ts_kind kind)
{
	const struct ts_instances *list = &sim->instances[kind];

	return list->n ? list->item[0] : NULL;
}

struct ts_instance *ts_sim_next_of(const struct tsim *sim, enum ts_kind kind, const char *family, size_t *k)
{
	const struct ts_instances *list = &sim->instances[kind];

	while (*k < list->n) {
		struct ts_instance *inst = list->item[(*k)++];

		if (inst->style->family && ts_streq(inst->style->family, family))
			return inst;
	}
	return NULL;
}

enum ts_status ts_sim_require(struct tsim *sim, enum ts_kind kind, const struct ts_word *id,
			      struct ts_instance **out)
{
	const struct ts_instances *list = &sim->instances[kind];
	struct ts_suggest suggest = ts_suggest_start(id->text);

	*out = ts_sim_find(sim, kind, id->text);
	if (*out)
		return TS_OK;
	for (size_t k = 0; k < list->n; k++)
		ts_suggest_try(&suggest, list->item[k]->id);
	return ts_missing(&sim->error, ts_kind_name(kind), id->text, &id->place, "there is no %s '%s'%s",
			  ts_kind_name(kind), id->text, ts_suggest_text(&suggest));
}

enum ts_status ts_sim_defer_error(struct tsim *sim, enum ts_status status)
{
	if (status == TS_OK || !sim->reading.explain || !sim->script_api)
		return status;
	sim->reading.faults++;
	return sim->script_api->defer_error(sim->script_api_data, status);
}

bool ts_sim_awaits_run(struct tsim *sim, const char *name)
{
	if (sim->reading.dry)
		return true;
	if (!sim->reading.explain || !sim->reading.planned)
		return false;
	if (!sim->reading.from_run[0])
		snprintf(sim->reading.from_run, sizeof sim->reading.from_run, "%s", name);
	return true;
}

bool ts_sim_has_property(const struct tsim *sim, const char *name)
{
	bool found = false;

	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		found |= (*s)->has_property && (*s)->has_property(sim, name);
	return found;
}

const struct ts_place *ts_instance_word(const struct ts_instance *inst, const char *text)
{
	for (size_t k = 0; k < inst->words.n; k++)
		if (ts_streq(inst->words.word[k].text, text))
			return &inst->words.word[k].place;
	return &inst->where;
}

enum ts_status ts_sim_next_step(struct tsim *sim, const char *what, const char *output, const char *variable,
				const struct ts_place *where, int64_t *next)
{
	double step;

	TS_TRY(sim->script_api->scalar(sim->script_api_data, variable, where, &step));
	if (!(step > (double)sim->clock.step))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "%s v_%s: the step of the next %s would be %g, but step %" PRId64
			       " is reached already",
			       what, variable, output, step, sim->clock.step);
	*next = ts_clock_step_of(step);
	return TS_OK;
}

const struct ts_place *ts_sim_word(const struct tsim *sim, size_t k, const struct ts_place *where)
{
	return k < sim->line.n ? &sim->line.word[k].place : where;
}

const struct ts_place *ts_sim_word_of(const struct tsim *sim, const char *text, const struct ts_place *where)
{
	for (size_t k = 1; k < sim->line.n; k++)
		if (ts_streq(sim->line.word[k].text, text))
			return &sim->line.word[k].place;
	return where;
}

uint64_t ts_instance_site(const struct ts_instance *inst, int stage)
{
	const int32_t key[] = { (int32_t)inst->style->kind, stage };
	struct ts_hash hash = ts_hash_start();

	ts_hash_add(&hash, key, sizeof key);
	ts_hash_text(&hash, inst->style->name);
	ts_hash_text(&hash, inst->id);
	return ts_hash_value(&hash) | 1;
}
