/* Loops of a script that is read without running. Loops without a run command are executed to their end;
 * others while they reach new lines, or if they have few iterations. The remaining iterations are
 * extrapolated if their number is known, otherwise reported as unknown. After an error, without which they may end
 * elsewhere, a few more jumps back are followed in all. */
#include <string.h>

#include "script/check.h"
#include "formula/unknown.h"

#include "base/banned.h"

enum { FEW = 20, MOST_ROUNDS = 1000, MOST_JUMPS = 100000, MOST_RUNS = 2000, MOST_AFTER_ERROR = 100 };

static bool is_inside_loop(const struct ts_check_loop *loop, const struct ts_place *where)
{
	return where->file && ts_streq(loop->file, where->file) && loop->from <= where->line &&
	       where->line <= loop->to;
}

/* Stores the counters at the start of an iteration. */
static enum ts_status begin_iteration(struct ts_script *script, struct ts_check_loop *loop)
{
	const struct ts_check *check = script->check;

	loop->reached = check->reached;
	loop->nexts = check->nexts;
	loop->branches = check->branches;
	loop->step = script->sim->clock.step;
	loop->cost = script->sim->cost;
	if (TS_GROW(loop->run, loop->run_capacity, check->nruns) != TS_OK)
		return ts_nomem(&script->sim->error);
	for (const struct ts_check_event *e = check->first; e; e = e->next)
		if (e->kind == TS_CHECK_RUN)
			loop->run[e->index] = (struct ts_check_sum){ e->count, e->steps };
	loop->nruns = check->nruns;
	return TS_OK;
}

static struct ts_check_loop *find_loop(const struct ts_check *check, const char *file, int from, int to)
{
	struct ts_check_loop *loop = check->loop;

	while (loop && !(ts_streq(loop->file, file) && (from < 0 || loop->from == from) && loop->to == to))
		loop = loop->next;
	return loop;
}

enum ts_status ts_check_loop_of(struct ts_script *script, const struct ts_place *where, const char *file,
				const char *label, struct ts_check_loop **out)
{
	struct ts_check *check = script->check;
	const struct ts_source *source = script->source;
	int from = label ? -1 : 0;

	*out = NULL;
	if (!source || !where->line || !ts_streq(where->file, source->name) ||
	    !(ts_streq(file, "SELF") || ts_streq(file, source->name)))
		return TS_OK;
	for (size_t k = 0; label && k < source->nlabels; k++)
		if (ts_streq(source->label[k].name, label) && source->label[k].at <= source->at) {
			from = source->label[k].line;
			break;
		}
	if (from < 0)
		return TS_OK;
	*out = find_loop(check, source->name, from, where->line);
	if (*out)
		return TS_OK;
	*out = ts_arena_alloc(&check->arena, 1, sizeof **out);
	if (!*out)
		return ts_nomem(&script->sim->error);
	**out = (struct ts_check_loop){
		.next = check->loop, .file = source->name, .from = from, .to = where->line
	};
	check->loop = *out;
	return TS_OK;
}

void ts_check_open_loop(struct ts_script *script, struct ts_check_loop *loop)
{
	loop->open = true;
	script->sim->reading.open_clock |= script->sim->reading.planned;
	script->sim->cost.open = true;
}

/* Whether an `if` with an unknown condition may leave the loop. */
static bool may_end_by_unknown(const struct ts_check *check, const struct ts_check_loop *loop)
{
	for (const struct ts_check_event *e = check->first; e; e = e->next)
		if (e->leaves && is_inside_loop(loop, &e->where))
			return true;
	return false;
}

static bool has_run(const struct ts_check *check, const struct ts_check_loop *loop)
{
	for (const struct ts_check_event *e = check->first; e; e = e->next)
		if (e->kind == TS_CHECK_RUN && is_inside_loop(loop, &e->where))
			return true;
	return false;
}

/* Adds `left` iterations that are not executed, each equal to the last one, to steps and cost. */
static void extrapolate_iterations(struct ts_script *script, const struct ts_check_loop *loop, int64_t left)
{
	struct tsim *sim = script->sim;
	struct ts_total_cost *cost = &sim->cost;

	for (struct ts_check_event *e = script->check->first; e; e = e->next) {
		struct ts_check_sum before = { 0 };

		if (e->kind != TS_CHECK_RUN)
			continue;
		if (e->index < loop->nruns)
			before = loop->run[e->index];
		e->steps += left * (e->steps - before.steps);
		e->count += left * (e->count - before.count);
	}
	sim->clock.step += left * (sim->clock.step - loop->step);
	cost->seconds += (double)left * (cost->seconds - loop->cost.seconds);
	cost->most += (double)left * (cost->most - loop->cost.most);
	cost->bytes += (double)left * (cost->bytes - loop->cost.bytes);
}

/* Deletes the variables of the last `next`, as if it had found no further value. */
static void delete_next_variables(struct ts_script *script)
{
	struct ts_check *check = script->check;

	for (size_t k = 0; k < sizeof check->next_variable / sizeof *check->next_variable; k++) {
		struct ts_variable *variable =
			check->next_variable[k] ? ts_variable_find(&script->formulas, check->next_variable[k])
						: NULL;

		if (variable)
			ts_variable_delete(&script->formulas, variable);
		check->next_variable[k] = NULL;
	}
}

/* Whether to execute another iteration. */
static bool needs_another_iteration(struct ts_script *script, struct ts_check_loop *loop)
{
	const struct ts_check *check = script->check;
	bool steps = check->nexts != loop->nexts,
	     news = loop->iterations == 1 || check->reached != loop->reached;

	if (check->jumps_after_error > MOST_AFTER_ERROR && loop->iterations > 1) /* the counts are of one */
		return false;
	if (!has_run(check, loop))
		return loop->iterations < (steps && check->iterations_left ? MOST_JUMPS : MOST_ROUNDS) &&
		       (!loop->open || loop->iterations < FEW);
	if (check->runs > MOST_RUNS)
		return false;
	if (loop->open)
		return news && loop->iterations < MOST_ROUNDS;
	if (steps && check->iterations_left)
		return news || loop->iterations + check->iterations_left <= FEW;
	return loop->iterations < FEW;
}

static enum ts_status close_loop(struct ts_script *script, struct ts_check_loop *loop,
				 struct ts_check_event *event, bool *follow)
{
	struct ts_check *check = script->check;
	bool steps = check->nexts != loop->nexts;

	loop->iterations++;
	if (!loop->open && may_end_by_unknown(check, loop))
		ts_check_open_loop(script, loop);
	check->jumps_after_error += check->nerrors > 0;
	*follow = needs_another_iteration(script, loop);
	check->cut |= !*follow && check->nerrors;
	if (*follow)
		return begin_iteration(script, loop);
	event->bounded = true;
	if (steps && check->iterations_left && !loop->open) {
		event->iterations = loop->iterations + check->iterations_left;
		extrapolate_iterations(script, loop, check->iterations_left);
	} else {
		event->endless =
			!loop->open && !steps && check->branches == loop->branches && !check->nerrors;
		ts_check_open_loop(script, loop);
	}
	if (steps)
		delete_next_variables(script);
	loop->iterations = 0;
	return TS_OK;
}

enum ts_status ts_check_jump(struct ts_script *script, const struct ts_place *where, const char *file,
			     const char *label, bool *follow)
{
	struct ts_check *check = script->check;
	struct ts_check_event *event;
	struct ts_check_loop *loop;

	*follow = true;
	if (!check)
		return TS_OK;
	TS_TRY(ts_check_record_event(script, TS_CHECK_STEP, where, NULL, &event, "jump %s%s%s", file,
				     label ? " " : "", label ? label : ""));
	TS_TRY(ts_check_loop_of(script, where, file, label, &loop));
	if (loop)
		TS_TRY(close_loop(script, loop, event, follow));
	if (++check->jumps >= MOST_JUMPS && *follow) {
		*follow = false;
		event->bounded = true;
	}
	event->count -= !*follow;
	check->at = script->source ? script->source->at : 0;
	check->line = script->source ? script->source->line : 0;
	return TS_OK;
}

void ts_check_leave_loop(struct ts_script *script, const struct ts_place *where)
{
	struct ts_check_loop *loop =
		script->check && where->file ? find_loop(script->check, where->file, -1, where->line) : NULL;

	if (loop)
		loop->iterations = 0;
}

void ts_check_record_next(struct ts_script *script, struct ts_words names)
{
	struct ts_check *check = script->check;
	size_t most = check ? sizeof check->next_variable / sizeof *check->next_variable : 0;

	if (!check)
		return;
	check->nexts++;
	check->iterations_left = 0;
	for (size_t k = 0; k < most; k++) {
		const struct ts_variable *v =
			k < names.n ? ts_variable_find(&script->formulas, names.word[k].text) : NULL;
		int64_t left = v && !v->feed ? v->last - v->at + 1 : 0;

		check->next_variable[k] = v ? v->name : NULL;
		if (left && (!check->iterations_left || left < check->iterations_left))
			check->iterations_left = left;
		for (size_t j = 0; v && j < v->values.n; j++)
			if (ts_unknown_in_text(script->sim, v->values.word[j].text))
				check->iterations_left = -1;
	}
}
