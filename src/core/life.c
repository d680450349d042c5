#include "core/life.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "core/fingerprint.h"
#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "core/settings.h"
#include "core/unclaimed_state.h"

#include "base/banned.h"

static void instance_free(struct ts_instance *inst)
{
	if (inst->style->fini && inst->state)
		inst->style->fini(inst);
	ts_arena_release(&inst->arena);
	ts_table_release(&inst->table);
	ts_free(inst->state);
	ts_free(inst);
}

static enum ts_status instance_new(struct tsim *sim, const struct ts_style *style, const char *id, int group,
				   const struct ts_place *where, struct ts_instance **out)
{
	struct ts_instance *inst = ts_alloc(1, sizeof *inst);

	if (!inst)
		return ts_nomem(&sim->error);
	inst->style = style;
	inst->group = group;
	if (where)
		inst->where = *where;
	inst->state = ts_alloc_aligned(1, style->state_size ? style->state_size : 1);
	inst->id = ts_arena_strdup(&inst->arena, id);
	if (!inst->state || !inst->id) {
		instance_free(inst);
		return ts_nomem(&sim->error);
	}
	*out = inst;
	return TS_OK;
}

static enum ts_status start_system(struct tsim *sim, const struct ts_system_style *system)
{
	struct ts_instances *list = &sim->instances[TS_KIND_SYSTEM];
	struct ts_instance *inst = NULL;

	if (TS_GROW(list->item, list->capacity, list->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(instance_new(sim, &system->style, system->style.name, 0, NULL, &inst));
	list->item[list->n++] = inst;
	if (system->slot)
		*(void **)((char *)sim + system->slot) = inst->state;
	return system->style.init ? system->style.init(inst, sim) : TS_OK;
}

static enum ts_status start_systems(struct tsim *sim)
{
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if (!(*s)->no_instance)
			TS_TRY(start_system(sim, *s));
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if ((*s)->connect)
			(*s)->connect(sim);
	return TS_OK;
}

static void set_defaults(struct tsim *sim)
{
	const char *threads = getenv("OMP_NUM_THREADS");
	int64_t n;

	sim->clock = (struct ts_clock){ .dt = 0.005 };
	sim->cost.last = (struct ts_price){ .seconds = NAN, .crowded = NAN };
	sim->units = TS_UNITS_LJ;
	sim->dimension = 3;
	if (sim->grain == 0)
		sim->grain = 8192;
	sim->columns = 0;
	sim->run.fingerprint = 0;
	sim->reading.planned = sim->reading.open_clock = sim->has_box = sim->continued = sim->run.box_moves =
		false;
	sim->groups = (struct ts_groups){ .name = { "all" } };
	sim->hard_particles = sim->soft_particles = sim->newton_on = sim->still_ghosts = false;
	sim->run.inside = sim->run.rebuild = sim->run.relist = sim->run.in_setup = sim->run.resuming =
		sim->run.halted = false;
	if (sim->threads == 0)
		sim->threads = threads && ts_parse_int(threads, &n) && n > 0 && n < 1024 ? (int)n : 1;
	ts_review_set(sim, NULL, TS_REVIEW_WARN);
	sim->review.made = sim->review.stale = sim->review.doubtful = false;
	sim->units_given = false;
	sim->legacy = sim->legacy_option;
	sim->run.undivided = false;
	sim->run.timeout = 0;
	sim->run.timeout_every = 10;
	for (int k = 0; k < TS_NSTANDARD; k++)
		sim->standard[k] = NULL;
}

struct tsim *ts_sim_new(const struct ts_tables *tables)
{
	struct tsim *sim = ts_alloc(1, sizeof *sim);

	if (!sim)
		return NULL;
	sim->tables = tables;
	sim->log.files = &sim->files;
	sim->files.stop = &sim->requests.stop;
	set_defaults(sim);
	sim->pool = ts_pool_new();
	if (!sim->pool || start_systems(sim) != TS_OK) {
		ts_sim_free(sim);
		return NULL;
	}
	return sim;
}

static void free_instance_list(struct ts_instances *list)
{
	while (list->n)
		instance_free(list->item[--list->n]);
	ts_free(list->item);
	*list = (struct ts_instances){ 0 };
}

static enum ts_status close_instance(struct ts_instance *inst, struct tsim *sim)
{
	return inst->style->close ? inst->style->close(inst, sim) : TS_OK;
}

enum ts_status ts_sim_close(struct tsim *sim)
{
	enum ts_status status = TS_OK;

	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			const enum ts_status closed = close_instance(sim->instances[kind].item[k], sim);

			status = status == TS_OK ? closed : status;
		}
	return status;
}

/* In reverse order: instances of a kind may point to those of kinds before it, systems to none. */
static void free_all_instances(struct tsim *sim)
{
	for (int kind = TS_NKIND - 1; kind >= 0; kind--)
		free_instance_list(&sim->instances[kind]);
	free_instance_list(&sim->retired);
	ts_unclaimed_free(sim);
}

void ts_sim_free(struct tsim *sim)
{
	if (!sim)
		return;
	ts_ranks_end_pause(sim);
	if (sim->recorder)
		sim->recorder->release(sim->recorder, sim);
	free_all_instances(sim);
	ts_log_close(&sim->log, &sim->error);
	ts_shared_buffers_end(&sim->holds);
	ts_review_release(&sim->review);
	ts_pool_free(sim->pool);
	ts_files_release(&sim->files);
	ts_free(sim);
}

enum ts_status ts_sim_clear(struct tsim *sim)
{
	if (sim->recorder)
		sim->recorder->clear(sim->recorder, sim);
	TS_TRY(ts_sim_close(sim));
	free_all_instances(sim);
	set_defaults(sim);
	sim->era++;
	ts_review_begin_scene(sim);
	return start_systems(sim);
}

/* init of pair and bond needs their coefficients, which come later; all others are checked when they are
 * defined. */
static enum ts_status init_new_instance(struct tsim *sim, struct ts_instance *inst, struct ts_words args)
{
	const struct ts_instances *systems = &sim->instances[TS_KIND_SYSTEM];
	enum ts_kind kind = inst->style->kind;

	sim->columns |= inst->style->columns;
	inst->serial = sim->defining = ++sim->instances_made;
	inst->removals = sim->removals;
	for (size_t k = 0; k < systems->n; k++)
		if (systems->item[k]->style->init)
			TS_TRY(systems->item[k]->style->init(systems->item[k], sim));
	if (inst->style->init && kind != TS_KIND_PAIR && kind != TS_KIND_BOND)
		TS_TRY(inst->style->init(inst, sim));
	return ts_unclaimed_apply(sim, inst, args);
}

static enum ts_status find_position(struct tsim *sim, enum ts_kind kind, const struct ts_style *style,
				    const char *id, const struct ts_place *where, size_t *at)
{
	struct ts_instances *list = &sim->instances[kind];

	for (*at = 0; *at < list->n; ++*at)
		if (ts_streq(list->item[*at]->id, id))
			break;
	if (*at < list->n && *id && list->item[*at]->style != style)
		return ts_conflict(&sim->error, where, "%s id '%s' is already in use by style %s (%s:%d)",
				   ts_kind_name(kind), id, list->item[*at]->style->name,
				   TS_FILE_AND_LINE(list->item[*at]->where));
	if (*at == list->n && TS_GROW(list->item, list->capacity, list->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

/* Behind a run that has left the particles divided among ranks: whether an instance of this style can come or go without
 * them. */
static bool is_without_rows(const struct tsim *sim, const struct ts_style *style)
{
	return sim->division && (!style->init || style->ranks & TS_RANKS_ROWLESS) &&
	       (ts_ranks_have_read(sim->run.paused) || (style->kind != TS_KIND_PAIR && !style->carrier));
}

enum ts_status ts_sim_create(struct tsim *sim, enum ts_kind kind, const struct ts_style *style,
			     const char *id, int group, struct ts_words args, const struct ts_place *where,
			     struct ts_instance **out)
{
	struct ts_instances *list = &sim->instances[kind];
	struct ts_instance *inst = NULL;
	enum ts_status status;
	char what[128];
	size_t at;

	TS_TRY(find_position(sim, kind, style, id, where, &at));
	snprintf(what, sizeof what, "%s %s", ts_kind_name(kind), style->name);
	TS_TRY(ts_ranks_allow(sim, style, what, where));
	if (!is_without_rows(sim, style))
		TS_TRY(ts_ranks_unite(sim));
	TS_TRY(instance_new(sim, style, id, group, where, &inst));
	status = ts_words_copy(&inst->arena, args, &inst->words) == TS_OK ? TS_OK : ts_nomem(&sim->error);
	if (status == TS_OK)
		status = ts_args_parse(sim, what, style->args, args, where, &inst->arena, inst->state);
	if (status == TS_OK)
		status = ts_args_outputs(sim, what, style->args, inst->state, args, where);
	if (status == TS_OK)
		status = init_new_instance(sim, inst, args);
	sim->defining = 0;
	if (status != TS_OK) {
		instance_free(inst);
		return status;
	}
	if (at < list->n) {
		ts_fingerprint_forget(sim, list->item[at]);
		ts_ranks_forget(sim, list->item[at]);
		instance_free(list->item[at]);
		sim->removals++;
	} else {
		list->n++;
	}
	list->item[at] = inst;
	ts_settings_log(sim, what, style->args, inst->state, args);
	if (out)
		*out = inst;
	return TS_OK;
}

enum ts_status ts_sim_choose(struct tsim *sim, enum ts_kind kind, struct ts_words line,
			     const struct ts_place *where)
{
	const struct ts_word id = { .text = "", .place = line.word[0].place };
	const struct ts_style *style;

	if (line.n == 1 && ts_streq(line.word[0].text, "none")) {
		ts_unclaimed_waive(sim, kind);
		return ts_sim_only(sim, kind) ? ts_sim_destroy(sim, kind, &id) : TS_OK;
	}
	TS_TRY(ts_style_require(sim, kind, &line.word[0], &style));
	return ts_sim_create(sim, kind, style, "", 0, ts_words_from(line, 1), where, NULL);
}

static enum ts_status remove_from_list(struct tsim *sim, enum ts_kind kind, const struct ts_word *id,
				       struct ts_instance **out)
{
	struct ts_instances *list = &sim->instances[kind];
	size_t at = 0;

	TS_TRY(ts_sim_require(sim, kind, id, out));
	if (!is_without_rows(sim, (*out)->style))
		TS_TRY(ts_ranks_unite(sim));
	ts_fingerprint_forget(sim, *out);
	ts_ranks_forget(sim, *out);
	while (list->item[at] != *out)
		at++;
	memmove(&list->item[at], &list->item[at + 1], (list->n - at - 1) * sizeof *list->item);
	list->n--;
	sim->removals++;
	return TS_OK;
}

enum ts_status ts_sim_destroy(struct tsim *sim, enum ts_kind kind, const struct ts_word *id)
{
	struct ts_instance *inst = NULL;
	enum ts_status status;

	TS_TRY(remove_from_list(sim, kind, id, &inst));
	status = close_instance(inst, sim);
	instance_free(inst);
	return status;
}

enum ts_status ts_sim_retire(struct tsim *sim, enum ts_kind kind, const struct ts_word *id)
{
	struct ts_instances *list = &sim->retired;
	struct ts_instance *inst = NULL;

	if (TS_GROW(list->item, list->capacity, list->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(remove_from_list(sim, kind, id, &inst));
	list->item[list->n++] = inst;
	return TS_OK;
}

/* Restores sim->line behind the command, since commands can execute others (run every). */
static enum ts_status execute_command(struct tsim *sim, const struct ts_command_style *command, void *state,
				      struct ts_words words)
{
	struct ts_words outer = sim->line;
	enum ts_status status;

	sim->line = words;
	if (command->needs_box)
		ts_settings_log(sim, command->style.name, command->style.args, state,
				ts_words_from(words, 1));
	sim->run.rowwise = command->style.ranks & TS_RANKS_ROWS && sim->run.made;
	status = command->run(sim, state, &words.word[0].place);
	sim->run.rowwise = false;
	sim->line = outer;
	return status;
}

/* Whether several ranks execute the command as they are, although each may have its own particles only. */
static bool can_be_apart(const struct tsim *sim, const struct ts_style *style, struct ts_words words)
{
	if (style->ranks & TS_RANKS_FORMULAS)
		return true;
	return style->ranks & TS_RANKS_ROWS && sim->run.made && !ts_ranks_find_shared(sim, words);
}

enum ts_status ts_sim_command(struct tsim *sim, struct ts_words words)
{
	const struct ts_style *style;
	const struct ts_command_style *command;
	struct ts_arena arena = { 0 };
	struct ts_place where = words.word[0].place;
	enum ts_status status;
	void *state;

	TS_TRY(ts_style_require(sim, TS_KIND_COMMAND, &words.word[0], &style));
	for (size_t k = 2; k < words.n; k++) /* word 1 is mostly an ID, which may be spelt like a keyword */
		ts_keywords_scan(sim, words.word[k].text);
	command = (const struct ts_command_style *)style;
	if (command->needs_box && !ts_sim_has_box(sim))
		return ts_fail(&sim->error, TS_STATE, &where,
			       "'%s' needs a simulation box: use create_box or read_restart first",
			       style->name);
	if (!can_be_apart(sim, style, words))
		TS_TRY(ts_ranks_unite(sim));
	state = ts_alloc_aligned(1, style->state_size ? style->state_size : 1);
	if (!state)
		return ts_nomem(&sim->error);
	status = ts_args_parse(sim, style->name, style->args, ts_words_from(words, 1), &where, &arena, state);
	if (status == TS_OK)
		status = ts_args_outputs(sim, style->name, style->args, state, words, &where);
	if (status == TS_OK && command->run)
		status = execute_command(sim, command, state, words);
	ts_arena_release(&arena);
	ts_free(state);
	return status;
}
