/* Opening and closing, errors, output. */
#include "library/library.h"

#include <string.h>

#include "core/life.h"
#include "library/tsim_tables.h"
#include "particle/particles.h"
#include "script/diagnostic.h"
#include "script/script.h"

#include "base/banned.h"

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

#define SAME(code) _Static_assert((int)TSIM_##code == (int)TS_##code, "codes agree")
SAME(OK);
SAME(SYNTAX);
SAME(UNKNOWN);
SAME(RANGE);
SAME(STATE);
SAME(IO);
SAME(DAMAGED);
SAME(NOMEM);
SAME(PHYSICS);
SAME(STOPPED);
SAME(LOG_TEXT);
SAME(LOG_WARNING);
SAME(LOG_PROGRESS);

struct tsim *tsim_open(void)
{
	struct tsim *sim = ts_sim_new(&ts_tables);

	if (!sim)
		return NULL;
	sim->library = ts_alloc(1, sizeof *sim->library);
	if (!sim->library || !ts_script_new(sim)) {
		tsim_close(sim);
		return NULL;
	}
	sim->library->stage = -1;
	return sim;
}

static void release_library(struct ts_library *library)
{
	if (!library)
		return;
	for (int stage = 0; stage < TSIM_STAGES; stage++)
		ts_free(library->calls[stage].item);
	ts_table_release(&library->table);
	ts_sheets_release(&library->sheets);
	ts_free(library->row.name);
	ts_free(library->row.value);
	ts_free(library);
}

void tsim_close(struct tsim *sim)
{
	struct ts_library *library;
	struct ts_world *world;

	if (!sim || sim->run.inside)
		return;
	library = sim->library;
	world = sim->world;
	if (sim->library)
		ts_stepping_end(&sim->library->stepping, sim);
	ts_script_free(sim->script_api_data);
	ts_sim_free(sim);
	if (library && library->leave)
		library->leave(world);
	release_library(library);
}

int tsim_open_with(const struct tsim_options *options, struct tsim **out)
{
	struct tsim_options o = { 0 };
	enum ts_status status;

	if (!out)
		return TSIM_RANGE;
	*out = tsim_open();
	if (!*out)
		return TSIM_NOMEM;
	TS_LIBRARY_NEEDS(*out, options);
	memcpy(&o, options, options->size < sizeof o ? options->size : sizeof o);
	if (o.threads < 0 || o.threads > 1024)
		return (int)ts_fail(&(*out)->error, TS_RANGE, NULL,
				    "%d threads asked for, possible are 1 to 1024", o.threads);
	if (o.threads)
		(*out)->threads = o.threads;
	(*out)->reading.explain = o.explain != 0;
	tsim_screen(*out, o.screen);
	tsim_on_log(*out, o.on_log, o.on_log_data);
	(*out)->log.quiet = o.check && !o.explain;
	if (o.check && (status = ts_script_check((*out)->script_api_data)) != TS_OK)
		return (int)status;
	return o.log ? tsim_log(*out, o.log) : TSIM_OK;
}

const char *tsim_version(void)
{
	return PACKAGE_VERSION;
}

/* An error while the particles are divided may be one of this rank alone, for which the others would wait. */
int ts_library_result(struct tsim *sim, enum ts_status status)
{
	if (status != TS_OK && sim->error.status == TS_OK)
		ts_fail(&sim->error, status, NULL, "%s", ts_status_text(status));
	if (status != TS_OK && status != TS_STOPPED && sim->library->leave && sim->division)
		sim->world->call->fail(sim->world, tsim_error(sim));
	return (int)status;
}

int ts_library_null(struct tsim *sim, const char *function, const char *argument)
{
	if (sim)
		ts_fail(&sim->error, TS_RANGE, NULL, "%s: the argument %s is NULL", function, argument);
	return TSIM_RANGE;
}

enum ts_status ts_library_refuse_in_step(struct tsim *sim, const char *what)
{
	if (!sim->run.inside)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, NULL, "%s: not possible inside a step", what);
}

void ts_library_copy_struct(void *out, const void *full, size_t size)
{
	size_t room;

	memcpy(&room, out, sizeof room);
	if (room > size)
		room = size;
	if (room > sizeof room)
		memcpy((char *)out + sizeof room, (const char *)full + sizeof room, room - sizeof room);
}

void ts_library_copy(const char *text, char *out, size_t room, size_t *length)
{
	size_t n = strlen(text);

	if (length)
		*length = n;
	if (!room)
		return;
	if (n > room - 1)
		n = room - 1;
	memcpy(out, text, n);
	out[n] = '\0';
}

const char *tsim_error(struct tsim *sim)
{
	struct ts_str text = { 0 };
	const char *shared = NULL;

	if (!sim)
		return "error: out of memory\n";
	if (sim->error.status == TS_OK)
		return "";
	ts_diagnostic(&sim->error, &text);
	if (!text.failed)
		shared = ts_pool_get(sim->pool, ts_str_text(&text));
	ts_str_release(&text);
	return shared ? shared : sim->error.message;
}

void tsim_error_where(struct tsim *sim, struct tsim_error_place *out)
{
	const struct ts_error none = { .status = TS_NOMEM, .message = "out of memory" };
	const struct ts_error *error = sim ? &sim->error : &none;
	const struct ts_place *place = &error->place;
	const struct tsim_error_place full = {
		.status = (int)error->status,
		.line = place->line,
		.column = place->column,
		.length = place->length,
		.message = error->message,
		.file = place->file ? place->file : "",
		.text = place->text ? place->text : "",
	};

	if (out)
		ts_library_copy_struct(out, &full, sizeof full);
}

void tsim_error_clear(struct tsim *sim)
{
	if (!sim)
		return;
	ts_error_clear(&sim->error);
	sim->requests.stop = 0;
}

const char *tsim_status_text(int status)
{
	return ts_status_text((enum ts_status)status);
}

void tsim_screen(struct tsim *sim, FILE *stream)
{
	if (sim)
		sim->log.screen = stream;
}

int tsim_log(struct tsim *sim, const char *path)
{
	TS_LIBRARY_NEEDS(sim, sim);
	return (int)ts_log_open(&sim->log, &sim->error, NULL, path, false);
}

static void forward_log(void *data, enum ts_log_level level, const char *text)
{
	const struct ts_library *library = data;

	library->on_log(library->on_log_data, (enum tsim_log_level)level, text);
}

void tsim_on_log(struct tsim *sim, tsim_log_fn *fn, void *data)
{
	if (!sim)
		return;
	sim->library->on_log = fn;
	sim->library->on_log_data = data;
	sim->log.sink = fn ? forward_log : NULL;
	sim->log.sink_data = sim->library;
}
