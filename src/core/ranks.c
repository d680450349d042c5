#include "core/ranks.h"

#include <stdio.h>
#include <string.h>

#include "core/due_lists.h"
#include "core/plan.h"
#include "core/recorder.h"

#include "base/banned.h"

void ts_ranks_most_of(const struct tsim *sim, double *value, size_t n)
{
	if (sim->division)
		ts_world_most(sim->world, value, n);
}

double ts_ranks_most(const struct tsim *sim, double value)
{
	ts_ranks_most_of(sim, &value, 1);
	return value;
}

void ts_ranks_sums(const struct tsim *sim, int64_t *number, size_t n)
{
	if (sim->world)
		ts_world_sums(sim->world, number, n);
}

double ts_ranks_same(const struct tsim *sim, double value)
{
	if (sim->world && !(sim->division && sim->run.inside))
		ts_world_spread(sim->world, 0, &value, sizeof value);
	return value;
}

enum ts_status ts_ranks_refuse(struct tsim *sim, const char *what, const struct ts_place *where)
{
	if (ts_ranks(sim) == 1)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "%s does not work with several ranks yet (there are %d): run tsim without mpirun, "
		       "with threads (OMP_NUM_THREADS); see doc/ranks.md",
		       what, ts_ranks(sim));
}

/* The name in v_NAME or v_NAME[k] or NAME; false: there is no such variable. */
static bool name_of_variable(const struct tsim *sim, const char *text, char name[128])
{
	const struct ts_script_api *api = sim->script_api;

	text += strncmp(text, "v_", 2) == 0 ? 2 : 0;
	snprintf(name, 128, "%.*s", (int)strcspn(text, "["), text);
	return api && api->has_variable(sim->script_api_data, name);
}

/* Whether the variable would have to be computed by all ranks together. One that does not exist, or has a wrong formula, is
 * refused by who reads it. */
static bool variable_reads_all(const struct tsim *sim, const char *text)
{
	char name[128];

	return name_of_variable(sim, text, name) && sim->script_api->reads_all(sim->script_api_data, name);
}

bool ts_ranks_variable_reads_fluid(const struct tsim *sim, const char *variable)
{
	char name[128];

	return variable && name_of_variable(sim, variable, name) &&
	       sim->script_api->reads_fluid(sim->script_api_data, name);
}

const struct ts_word *ts_ranks_find_shared(const struct tsim *sim, struct ts_words words)
{
	for (size_t k = 0; k < words.n; k++) {
		const char *text = words.word[k].text;
		bool output = (text[0] == 'c' || text[0] == 'f') && text[1] == '_';

		if (output || (text[0] == 'v' && text[1] == '_' && variable_reads_all(sim, text)))
			return &words.word[k];
	}
	return NULL;
}

bool ts_ranks_variable_shared(const struct tsim *sim, const char *variable)
{
	return variable && variable_reads_all(sim, variable);
}

enum ts_status ts_ranks_allow(struct tsim *sim, const struct ts_style *style, const char *what,
			      const struct ts_place *where)
{
	return style->ranks ? TS_OK : ts_ranks_refuse(sim, what, where);
}

void ts_ranks_apart(struct tsim *sim, bool begins)
{
	sim->run.apart = begins && ts_ranks(sim) > 1;
}

/* ---- values that depend on all particles, and act in each step */

/* Of fixes and the flow style; sets where it is. NULL: there is none. */
static const char *find_shared_argument(const struct tsim *sim, char what[128], const struct ts_place **where)
{
	static const enum ts_kind kinds[] = { TS_KIND_FLOW, TS_KIND_FIX };

	for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
		for (size_t i = 0; i < sim->instances[kinds[k]].n; i++) {
			const struct ts_instance *inst = sim->instances[kinds[k]].item[i];
			const struct ts_word *shared = inst->style->ranks & TS_RANKS_OWN
							       ? ts_ranks_find_shared(sim, inst->words)
							       : NULL;

			if (!shared)
				continue;
			snprintf(what, 128, "%s of %s %s", shared->text, ts_kind_name(kinds[k]),
				 inst->style->name);
			*where = &shared->place;
			return what;
		}
	return NULL;
}

static const char *find_shared_system(const struct tsim *sim)
{
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++) {
		const char *what = (*s)->undivided ? (*s)->undivided(sim) : NULL;

		if (what)
			return what;
	}
	return NULL;
}

void ts_ranks_choose_steps(struct tsim *sim)
{
	const struct ts_place *where = ts_sim_word(sim, 0, NULL);
	const bool before = sim->run.undivided;
	const char *what;
	char text[128];

	if (ts_ranks(sim) == 1)
		return;
	what = find_shared_system(sim);
	if (!what)
		what = find_shared_argument(sim, text, &where);
	sim->run.undivided = what != NULL;
	if (what && !before && ts_ranks_first(sim))
		ts_warn(&sim->log, where,
			"%s depends on all particles, a clock or random numbers, and acts in each step: "
			"all %d ranks do all steps with all particles, which takes as long as with one rank; "
			"see doc/ranks.md",
			what, ts_ranks(sim));
}

static bool system_is_whole(const struct tsim *sim, bool set_up)
{
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if ((*s)->whole_step && (*s)->whole_step(sim, set_up))
			return true;
	return false;
}

/* ---- steps and outputs */

enum ts_status ts_ranks_settle(const struct ts_plan *plan, struct tsim *sim)
{
	for (size_t k = 0; k < plan->n[TS_STAGE_END_OF_STEP]; k++) {
		struct ts_instance *self = plan->actions[TS_STAGE_END_OF_STEP][k].self;

		if (!self->style->settle || !self->style->due(self, sim))
			continue;
		sim->draws = (struct ts_draws){ plan->actions[TS_STAGE_END_OF_STEP][k].site, 0 };
		TS_TRY(self->style->settle(self, sim));
	}
	sim->draws = (struct ts_draws){ 0 };
	return TS_OK;
}

/* Whether a hook of the stage is due that needs all particles, and does not have these flags. */
static bool stage_is_due(const struct ts_plan *plan, const struct tsim *sim, enum ts_stage stage,
			 unsigned without)
{
	for (size_t k = 0; k < plan->n[stage]; k++) {
		const struct ts_instance *self = plan->actions[stage][k].self;

		if (self->style->ranks & TS_RANKS_WHOLE && !(self->style->ranks & without) &&
		    (!self->style->due || self->style->due(self, sim)))
			return true;
	}
	return false;
}

/* Whether it is the last step of a run whose end all ranks are to have. */
static bool ends_whole(const struct ts_plan *plan, const struct tsim *sim)
{
	return (sim->clock.step == sim->clock.last_step || sim->run.timed_out) &&
	       !ts_ranks_may_pause(plan, sim);
}

bool ts_ranks_whole_due(const struct ts_plan *plan, const struct tsim *sim)
{
	return ends_whole(plan, sim) || sim->requests.saving || sim->requests.stop ||
	       stage_is_due(plan, sim, TS_STAGE_END_OF_STEP, 0) ||
	       stage_is_due(plan, sim, TS_STAGE_OUTPUT, 0);
}

/* Any hook of the set-up may evaluate a compute. */
static bool compute_reads_lists(const struct tsim *sim)
{
	const struct ts_instances *computes = &sim->instances[TS_KIND_COMPUTE];

	for (size_t k = 0; k < computes->n; k++)
		if (!(computes->item[k]->style->ranks & TS_RANKS_PARTICLES))
			return true;
	return false;
}

bool ts_ranks_lists_due(const struct ts_plan *plan, const struct tsim *sim)
{
	return ends_whole(plan, sim) || sim->requests.saving || sim->requests.stop || sim->run.needs_lists ||
	       stage_is_due(plan, sim, TS_STAGE_END_OF_STEP, TS_RANKS_PARTICLES) ||
	       stage_is_due(plan, sim, TS_STAGE_OUTPUT, TS_RANKS_PARTICLES) || ts_due_lists_named(plan, sim);
}

/* Whether the hook of SETUP reads more than the columns of particles, or changes them. */
static bool sets_up_whole(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_style *style = self->style;
	/* one that acts on particles of its rank, too, is fix balance: it changes the division */
	bool reads = !(style->ranks & TS_RANKS_OWN && style->ranks & TS_RANKS_WHOLE);
	bool idle = style->kind == TS_KIND_SYSTEM && style->due && !style->due(self, sim);

	return !(reads && style->ranks & TS_RANKS_PARTICLES) && !idle;
}

static bool review_reads_all(const struct tsim *sim)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			const struct ts_style *style = sim->instances[kind].item[k]->style;

			if (style->review && !(style->ranks & TS_RANKS_REVIEW))
				return true;
		}
	return false;
}

bool ts_ranks_set_up_whole(const struct ts_plan *plan, const struct tsim *sim)
{
	for (size_t k = 0; k < plan->n[TS_STAGE_SETUP]; k++)
		if (sets_up_whole(plan->actions[TS_STAGE_SETUP][k].self, sim))
			return true;
	/* the limits of bonds need those of all ranks */
	return system_is_whole(sim, true) || sim->run.shows_lists || sim->instances[TS_KIND_BOND].n ||
	       compute_reads_lists(sim) || stage_is_due(plan, sim, TS_STAGE_OUTPUT, TS_RANKS_PARTICLES) ||
	       review_reads_all(sim);
}

bool ts_ranks_may_pause(const struct ts_plan *plan, const struct tsim *sim)
{
	if (!sim->run.pauses || ts_ranks(sim) == 1 || sim->legacy || sim->dimension != 3 ||
	    (sim->recorder && sim->recorder->records(sim->recorder)))
		return false;
	for (size_t k = 0; k < plan->n[TS_STAGE_FINISH]; k++)
		if (!(plan->actions[TS_STAGE_FINISH][k].self->style->ranks & TS_RANKS_PARTICLES))
			return false;
	return !sim->requests.stop && !sim->requests.save && !ts_ranks_set_up_whole(plan, sim);
}

bool ts_ranks_rowless(const struct tsim *sim)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			const struct ts_instance *inst = sim->instances[kind].item[k];
			bool acts = kind == TS_KIND_FIX || kind == TS_KIND_REGION || kind == TS_KIND_FLOW;

			if (inst->style->init && !(inst->style->ranks & TS_RANKS_ROWLESS))
				return false;
			if (acts && ts_ranks_find_shared(sim, inst->words))
				return false;
		}
	return true;
}

/* Whether a hook of the stage reads or changes particles. */
static bool stage_has_rows(const struct ts_plan *plan, const struct tsim *sim, enum ts_stage stage)
{
	for (size_t k = 0; k < plan->n[stage]; k++) {
		const struct ts_instance *self = plan->actions[stage][k].self;
		const struct ts_style *style = self->style;
		bool idle = style->kind == TS_KIND_SYSTEM && style->due && !style->due(self, sim);

		if (!(style->ranks & TS_RANKS_ROWLESS) && !idle)
			return true;
	}
	return false;
}

bool ts_ranks_may_rest(const struct ts_plan *plan, const struct tsim *sim)
{
	return !stage_has_rows(plan, sim, TS_STAGE_FINISH) && ts_ranks_rowless(sim);
}

bool ts_ranks_output_due(const struct ts_plan *plan, const struct tsim *sim)
{
	return stage_is_due(plan, sim, TS_STAGE_OUTPUT, 0);
}

bool ts_ranks_first_look(const struct ts_plan *plan, const struct tsim *sim)
{
	return stage_has_rows(plan, sim, TS_STAGE_SETUP) || ts_ranks_output_due(plan, sim);
}

enum ts_status ts_ranks_tell(struct tsim *sim)
{
	if (!sim->division)
		return TS_OK;
	TS_TRY(sim->tables->rest(sim, true));
	return sim->tables->rest(sim, false);
}

bool ts_ranks_step_due(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_instance *self = fixes->item[k];

		if (self->style->ranks & TS_RANKS_STEPS && self->style->due(self, sim))
			return true;
	}
	return sim->run.undivided || system_is_whole(sim, false);
}

void ts_ranks_agree(struct tsim *sim)
{
	double flag[] = { sim->run.rebuild, sim->world->stop,  sim->world->save,
			  sim->run.relist,  sim->run.runaways, ts_ranks_first(sim) && ts_sim_time_is_up(sim),
			  sim->run.seeks };

	ts_world_most(sim->world, flag, sizeof flag / sizeof *flag);
	sim->run.rebuild = flag[0] > 0;
	sim->run.relist = flag[3] > 0;
	sim->run.runaways = flag[4] > 0;
	sim->run.timed_out = flag[5] > 0;
	if (flag[1] > 0)
		sim->requests.stop = 1;
	if (flag[2] > 0)
		sim->requests.save = 1;
	sim->world->stop = sim->world->save = 0;
	if (sim->division && flag[6] > 0)
		sim->run.rebuild |= sim->tables->search_left(sim);
	sim->run.seeks = false;
}
