#include "tsim.h"

#include <math.h>

#include "core/sim.h"
#include "particles/particles.h"
#include "script/script.h"

#include "base/banned.h"

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

struct tsim *tsim_open(void)
{
	struct tsim *sim = ts_sim_new();

	if (sim && !ts_script_new(sim)) {
		ts_sim_free(sim);
		return NULL;
	}
	return sim;
}

void tsim_close(struct tsim *sim)
{
	if (!sim)
		return;
	ts_script_free(sim->host_data);
	ts_sim_free(sim);
}

const char *tsim_version(void)
{
	return PACKAGE_VERSION;
}

/* Whoever only passes a status on may have left no message. */
static int settle(struct tsim *sim, enum ts_status status)
{
	if (status != TS_OK && sim->error.status == TS_OK)
		ts_fail(&sim->error, status, NULL, "%s", ts_status_text(status));
	return (int)status;
}

int tsim_line(struct tsim *sim, const char *line)
{
	return tsim_string(sim, line);
}

int tsim_string(struct tsim *sim, const char *text)
{
	return settle(sim, ts_script_string(sim->host_data, text, "string"));
}

int tsim_file(struct tsim *sim, const char *path)
{
	return settle(sim, ts_script_file(sim->host_data, path));
}

int tsim_stream(struct tsim *sim, FILE *stream, const char *name)
{
	return settle(sim, ts_script_stream(sim->host_data, stream, name));
}

int tsim_variable(struct tsim *sim, const char *name, const char *value)
{
	return settle(sim, ts_script_set(sim->host_data, name, &value, 1, "variable"));
}

int tsim_value(struct tsim *sim, const char *formula, double *out)
{
	return settle(sim, ts_script_value(sim->host_data, formula, out));
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

void tsim_error_clear(struct tsim *sim)
{
	ts_error_clear(&sim->error);
}

void tsim_screen(struct tsim *sim, FILE *stream)
{
	sim->log.screen = stream;
}

int tsim_log(struct tsim *sim, const char *path)
{
	return (int)ts_log_open(&sim->log, &sim->error, NULL, path, false);
}

void tsim_stop(struct tsim *sim)
{
	sim->stop = 1;
}

size_t tsim_count(struct tsim *sim)
{
	return sim->particles ? sim->particles->n : 0;
}

static int check_count(struct tsim *sim, size_t n)
{
	if (n == tsim_count(sim))
		return 0;
	return (int)ts_fail(&sim->error, TS_RANGE, NULL,
			    "the array has room for %zu particles, there are %zu", n,
			    tsim_count(sim));
}

int tsim_column_read(struct tsim *sim, const char *name, double *out, size_t n)
{
	struct ts_table table = { 0 };
	struct ts_suggest suggest = ts_suggest_start(name);
	enum ts_status status = (enum ts_status)check_count(sim, n);

	if (status == TS_OK && !ts_quantity_has(sim, name)) {
		ts_quantity_suggest(&suggest);
		status = ts_fail(&sim->error, TS_UNKNOWN, NULL, "unknown particle column '%s'%s",
				 name, ts_suggest_text(&suggest));
	}
	if (status == TS_OK)
		status = ts_quantity_eval(sim, name, &table);
	for (size_t i = 0; status == TS_OK && i < n; i++)
		out[i] = table.data[i];
	ts_table_release(&table);
	return settle(sim, status);
}

/* What forces depend on is compared before each run, so new values need no further notice. */
int tsim_column_write(struct tsim *sim, const char *name, const double *in, size_t n)
{
	static const char *const names[] = { "x", "y", "z", "vx", "vy", "vz" };
	struct ts_suggest suggest = ts_suggest_start(name);
	int status = check_count(sim, n);
	size_t k = 0;

	if (status)
		return status;
	for (; k < 6 && !ts_streq(names[k], name); k++)
		ts_suggest_try(&suggest, names[k]);
	if (k == 6)
		return (int)ts_fail(&sim->error, TS_UNKNOWN, NULL,
				    "x, y, z, vx, vy and vz can be written, not '%s'%s", name,
				    ts_suggest_text(&suggest));
	for (size_t i = 0; i < n; i++)
		if (!isfinite(in[i]))
			return (int)ts_fail(&sim->error, TS_RANGE, NULL,
					    "value %zu for column %s is not finite", i, name);
	for (size_t i = 0; i < n; i++)
		(k < 3 ? sim->particles->x : sim->particles->v)[i][k % 3] = in[i];
	return 0;
}
