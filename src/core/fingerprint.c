#include "core/fingerprint.h"

#include <string.h>

#include "base/name.h"

#include "base/banned.h"

/* Key of the random numbers drawn while the fingerprint is computed: struct ts_draws. */
enum { FINGERPRINT_SITE = 2 };

static const uint64_t ANY_ORDER = (uint64_t)1 << 63;

static enum ts_status hash_instance(struct tsim *sim, const struct ts_instance *inst, struct ts_hash *hash);

/* Arguments of regions that are words: v_NAME of a motion, and members of a union or intersection. */
static enum ts_status hash_words(struct tsim *sim, const struct ts_instance *inst, struct ts_words words,
				 struct ts_hash *hash)
{
	for (size_t k = 0; k < words.n; k++) {
		const char *text = words.word[k].text;
		const struct ts_instance *member = ts_sim_find(sim, TS_KIND_REGION, text);
		struct ts_number number = { .variable = text + 2 };
		double value;

		if (member && member != inst)
			TS_TRY(hash_instance(sim, member, hash));
		if (strncmp(text, "v_", 2) != 0)
			continue;
		TS_TRY(ts_number_now(sim, &number, &inst->where, &value));
		ts_hash_add(hash, &value, sizeof value);
	}
	return TS_OK;
}

enum { DEEPEST = 16 }; /* variables that name each other, one in the other */

static enum ts_status hash_variable(struct tsim *sim, const struct ts_instance *inst, const char *name,
				    int depth, struct ts_hash *hash);

/* The variables that a formula names. */
static enum ts_status hash_named_variables(struct tsim *sim, const struct ts_instance *inst, const char *text,
					   int depth, struct ts_hash *hash)
{
	for (size_t n; *text; text += n ? n : 1) {
		char name[128];

		n = ts_name_length(text);
		if (n < 3 || n >= sizeof name || strncmp(text, "v_", 2) != 0)
			continue;
		memcpy(name, text + 2, n - 2);
		name[n - 2] = '\0';
		TS_TRY(hash_variable(sim, inst, name, depth, hash));
	}
	return TS_OK;
}

/* A number; of a variable with numbers of all particles, whose order may change, the formula and what it names. */
static enum ts_status hash_variable(struct tsim *sim, const struct ts_instance *inst, const char *name,
				    int depth, struct ts_hash *hash)
{
	const struct ts_script_api *api = sim->script_api;
	void *data = sim->script_api_data;
	struct ts_words words;
	double value;

	if (depth > DEEPEST || !api->words_of_variable(data, name, &words))
		return TS_OK;
	for (size_t k = 0; api->is_peratom(data, name) && k < words.n; k++) {
		ts_hash_text(hash, words.word[k].text);
		TS_TRY(hash_named_variables(sim, inst, words.word[k].text, depth + 1, hash));
	}
	if (api->is_peratom(data, name) || api->is_vector(data, name))
		return TS_OK;
	TS_TRY(api->scalar(data, name, &inst->where, &value));
	ts_hash_add(hash, &value, sizeof value);
	return TS_OK;
}

/* Hashes what arguments refer to: the present value of variables, the geometry of regions. */
static enum ts_status hash_references(struct tsim *sim, const struct ts_instance *inst,
				      const struct ts_arg *rows, struct ts_hash *hash)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)inst->state + row->offset;
		const struct ts_instance *region;

		if (row->type == TS_ARG_MODE && *(const int *)field >= 0)
			TS_TRY(hash_references(sim, inst, row->modes[*(const int *)field].args, hash));
		if (row->type == TS_ARG_NUMBER && ((const struct ts_number *)field)->variable)
			TS_TRY(hash_variable(sim, inst, ((const struct ts_number *)field)->variable, 0,
					     hash));
		if (row->type == TS_ARG_REST && inst->style->kind == TS_KIND_REGION)
			TS_TRY(hash_words(sim, inst, *(const struct ts_words *)field, hash));
		region = row->type == TS_ARG_REGION ? *(struct ts_instance *const *)field : NULL;
		if (region)
			TS_TRY(hash_instance(sim, region, hash));
	}
	return TS_OK;
}

static enum ts_status hash_instance(struct tsim *sim, const struct ts_instance *inst, struct ts_hash *hash)
{
	struct ts_str record = { 0 };

	ts_str_addf(&record, "%s %s %d", inst->style->name, inst->id, inst->group);
	ts_args_record(sim, inst->style->args, inst->state, &record);
	ts_hash_text(hash, ts_str_text(&record));
	ts_str_release(&record);
	if (inst->style->fingerprint)
		inst->style->fingerprint(inst, sim, hash);
	return hash_references(sim, inst, inst->style->args, hash);
}

/* Fixes that act in no step, or only read (averages, prints). */
static bool has_no_effect_on_forces(const struct ts_instance *inst)
{
	if (inst->style->kind != TS_KIND_FIX)
		return false;
	for (int stage = TS_STAGE_INITIAL_INTEGRATE; stage <= TS_STAGE_FINAL_INTEGRATE; stage++)
		if (inst->style->hook[stage])
			return false;
	return true;
}

void ts_fingerprint_forget(struct tsim *sim, const struct ts_instance *gone)
{
	for (int stage = TS_STAGE_PRE_FORCE; stage <= TS_STAGE_POST_FORCE; stage++)
		if (gone->style->kind == TS_KIND_FIX && gone->style->hook[stage])
			sim->run.fingerprint = 0;
}

/* What an instance adds: one that acts in no step, but that others read, such as a material, adds to a sum, under whatever
 * name and in any place of the script. */
static enum ts_status hash_effect(struct tsim *sim, const struct ts_instance *inst, struct ts_hash *hash,
				  uint64_t *sum)
{
	struct ts_hash one = ts_hash_start();

	if (!has_no_effect_on_forces(inst))
		return hash_instance(sim, inst, hash);
	if (!inst->style->fingerprint)
		return TS_OK;
	inst->style->fingerprint(inst, sim, &one);
	*sum += ts_hash_value(&one);
	return TS_OK;
}

static enum ts_status hash_all(struct tsim *sim, uint64_t *out)
{
	/* without the pressure solver: the present state of the fluid does not depend on it */
	static const enum ts_kind kinds[] = { TS_KIND_SYSTEM, TS_KIND_PAIR, TS_KIND_BOND, TS_KIND_FLOW,
					      TS_KIND_FIX };
	struct ts_hash hash = ts_hash_start();
	uint64_t sum = 0;

	ts_hash_add(&hash, &sim->clock.dt, sizeof sim->clock.dt);
	ts_hash_add(&hash, &sim->clock.step, sizeof sim->clock.step);
	ts_hash_add(&hash, &sim->units, sizeof sim->units);
	ts_hash_add(&hash, &sim->dimension, sizeof sim->dimension);
	for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
		const struct ts_instances *list = &sim->instances[kinds[k]];

		for (size_t i = 0; i < list->n; i++)
			TS_TRY(hash_effect(sim, list->item[i], &hash, &sum));
	}
	ts_hash_add(&hash, &sum, sizeof sum);
	*out = ts_fingerprint_in_order(sim) ? ts_hash_value(&hash) & ~ANY_ORDER
					    : ts_hash_value(&hash) | ANY_ORDER;
	return TS_OK;
}

uint64_t ts_fingerprint_of_old(uint64_t fingerprint)
{
	return fingerprint & ~ANY_ORDER;
}

bool ts_fingerprint_in_order(const struct tsim *sim)
{
	return sim->run.fingerprint && !(sim->run.fingerprint & ANY_ORDER);
}

enum ts_status ts_fingerprint_renew(struct tsim *sim)
{
	sim->run.fingerprint = 0;
	return ts_sim_fingerprint(sim, &sim->run.fingerprint);
}

/* Evaluates variables without side effects: streams of random numbers and next() do not advance. */
enum ts_status ts_sim_fingerprint(struct tsim *sim, uint64_t *out)
{
	const struct ts_draws before = sim->draws;
	bool probing = sim->reading.probing;
	enum ts_status status;

	sim->draws = (struct ts_draws){ FINGERPRINT_SITE, 0 };
	sim->reading.probing = true;
	status = hash_all(sim, out);
	sim->reading.probing = probing;
	sim->draws = before;
	if (status == TS_OK || status == TS_NOMEM)
		return status;
	/* a variable has no value before the set-up: ramp(), quantities of contacts */
	ts_error_clear(&sim->error);
	*out = 0;
	return TS_OK;
}

enum ts_status ts_fingerprint_differs(struct tsim *sim, uint64_t before, bool *differs)
{
	uint64_t now;

	TS_TRY(ts_sim_fingerprint(sim, &now));
	*differs = !now || now != before;
	return TS_OK;
}
