/* Record of what a script does, line by line, for the report of -check. */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/mkdirs.h"
#include "script/check.h"
#include "formula/unknown.h"

#include "base/banned.h"

static const char *keep_text(struct ts_script *script, struct ts_str *text)
{
	const char *kept = text->failed ? NULL : ts_pool_get(script->sim->pool, ts_str_text(text));

	ts_str_release(text);
	return kept;
}

enum ts_status ts_check_begin_line(struct ts_script *script, const struct ts_place *row)
{
	struct ts_str text = { 0 };
	const char *key;

	script->sim->reading.from_run[0] = '\0';
	if (!row->line)
		return TS_OK;
	ts_str_addf(&text, "%s:%d", row->file, row->line);
	key = keep_text(script, &text);
	if (!key)
		return ts_nomem(&script->sim->error);
	if (ts_map_get(&script->check->seen, key))
		return TS_OK;
	script->check->reached++;
	return ts_map_set(&script->check->seen, key, script->check) == TS_OK ? TS_OK
									     : ts_nomem(&script->sim->error);
}

static struct ts_check_event *add_event(struct ts_check *check, const char *key)
{
	struct ts_check_event *event = ts_arena_alloc(&check->arena, 1, sizeof *event);

	if (!event || ts_map_set(&check->events, key, event) != TS_OK)
		return NULL;
	*check->last = event;
	check->last = &event->next;
	return event;
}

enum ts_status ts_check_record_event(struct ts_script *script, enum ts_check_kind kind,
				     const struct ts_place *where, const char *depends_on,
				     struct ts_check_event **out, const char *format, ...)
{
	struct ts_check *check = script->check;
	struct ts_place place = where ? *where : (struct ts_place){ .file = "" };
	struct ts_check_event *event;
	struct ts_str text = { 0 }, shown = { 0 };
	const char *what, *key;
	va_list args;

	va_start(args, format);
	ts_str_vaddf(&text, format, args);
	va_end(args);
	ts_unknown_show(script->sim, ts_str_text(&text), "?", &shown);
	ts_str_release(&text);
	what = keep_text(script, &shown);
	ts_str_addf(&text, "%d %s:%d %s", (int)kind, place.file, place.line, what ? what : "");
	key = keep_text(script, &text);
	event = what && key ? ts_map_get(&check->events, key) : NULL;
	if (what && key && !event) {
		event = add_event(check, key);
		if (event)
			event->kind = kind, event->where = place, event->what = what;
	}
	if (!event)
		return ts_nomem(&script->sim->error);
	event->count++;
	if (depends_on && *depends_on && !event->depends_on)
		event->depends_on = ts_pool_get(script->sim->pool, depends_on);
	if (out)
		*out = event;
	return TS_OK;
}

enum ts_status ts_check_record_run(struct ts_script *script, const struct ts_place *where, int64_t steps)
{
	struct tsim *sim = script->sim;
	struct ts_check_event *event;

	TS_TRY(ts_check_record_event(script, TS_CHECK_RUN, where, sim->reading.from_run, &event, "run"));
	if (event->count == 1) {
		event->index = script->check->nruns++;
		event->step = sim->clock.step;
		event->dt = sim->clock.dt;
		event->start_unknown = sim->reading.open_clock;
	}
	event->open |= sim->line.n > 1 && ts_unknown_in_text(sim, sim->line.word[1].text);
	event->steps += steps;
	script->check->runs++;
	sim->reading.open_clock |= event->open;
	sim->cost.open |= event->open;
	sim->reading.planned = true;
	return TS_OK;
}

/* The folder need not exist: it is created with the file. */
enum ts_status ts_check_record_write(struct ts_script *script, const struct ts_place *where, const char *what,
				     const char *path)
{
	struct ts_check_event *event;
	char by[256];

	if (ts_mkdirs_blocked(&script->sim->files, path, by, sizeof by))
		return ts_fail(&script->sim->error, TS_IO, where,
			       "%s '%s': '%s' is not a folder that can be written to", what, path, by);
	TS_TRY(ts_check_record_event(script, TS_CHECK_WRITE, where, NULL, &event, "%s %s", what, path));
	event->path = strrchr(event->what, ' ') + 1;
	return TS_OK;
}

enum ts_status ts_check_record_branch(struct ts_script *script, const struct ts_place *where,
				      const char *which)
{
	struct ts_check *check = script->check;

	if (!check)
		return TS_OK;
	check->branches++;
	return ts_check_record_event(script, TS_CHECK_STEP, where, script->sim->reading.from_run, NULL,
				     "if: %s", which);
}
