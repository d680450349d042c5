/* Scripts, steps, and functions of the calling program that act in steps. */
#include "library/library.h"

#include <inttypes.h>
#include <string.h>

#include "core/ranks.h"
#include "script/script.h"

#include "base/banned.h"

/* Ends the run of tsim_step, for example before a script line. */
static enum ts_status end_run(struct tsim *sim, const char *what)
{
	TS_TRY(ts_library_refuse_in_step(sim, what));
	return ts_stepping_end(&sim->library->stepping, sim);
}

int tsim_line(struct tsim *sim, const char *line)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, line);
	return tsim_text(sim, line, "line");
}

int tsim_string(struct tsim *sim, const char *text)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, text);
	return tsim_text(sim, text, "string");
}

int tsim_text(struct tsim *sim, const char *text, const char *name)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, text);
	TS_LIBRARY_NEEDS(sim, name);

	enum ts_status status = end_run(sim, "a script line");

	if (status == TS_OK)
		status = ts_script_string(sim->script_api_data, text, name);
	return ts_library_result(sim, status);
}

int tsim_file(struct tsim *sim, const char *path)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, path);

	enum ts_status status = end_run(sim, "a script");

	if (status == TS_OK)
		status = ts_script_file(sim->script_api_data, path);
	return ts_library_result(sim, status);
}

int tsim_stream(struct tsim *sim, FILE *stream, const char *name)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, stream);
	TS_LIBRARY_NEEDS(sim, name);

	enum ts_status status = end_run(sim, "a script");

	if (status == TS_OK)
		status = ts_script_stream(sim->script_api_data, stream, name);
	return ts_library_result(sim, status);
}

int tsim_check_report(struct tsim *sim, int *errors, char *out, size_t room, size_t *length)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, errors);
	TS_LIBRARY_NEEDS_ARRAY(sim, out, room);

	struct ts_str text = { 0 }, report = { 0 };
	enum ts_status status;

	*errors = 0;
	if (sim->reading.check)
		status = ts_script_check_report(sim->script_api_data, &text, &report, errors);
	else
		status = ts_fail(&sim->error, TS_STATE, NULL,
				 "the simulation was not opened with the option check");
	ts_str_add(&text, ts_str_text(&report));
	if (status == TS_OK && (text.failed || report.failed))
		status = ts_nomem(&sim->error);
	if (status == TS_OK)
		ts_library_copy(ts_str_text(&text), out, room, length);
	ts_str_release(&text);
	ts_str_release(&report);
	return ts_library_result(sim, status);
}

int tsim_has_quit(struct tsim *sim, int *status)
{
	int ignored;

	return sim ? ts_script_quit(sim->script_api_data, status ? status : &ignored) : 0;
}

void tsim_stop(struct tsim *sim)
{
	if (!sim)
		return;
	if (sim->world)
		sim->world->stop = 1; /* all ranks agree on it in the next step */
	else
		sim->requests.stop = 1;
}

int tsim_step(struct tsim *sim, int64_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);

	enum ts_status status = ts_library_refuse_in_step(sim, "tsim_step");

	if (status == TS_OK && !ts_sim_has_box(sim))
		status = ts_fail(&sim->error, TS_STATE, NULL,
				 "tsim_step needs a simulation box: use create_box or read_restart first");
	if (status == TS_OK && (n < 0 || n > INT64_MAX - sim->clock.step))
		status = ts_fail(&sim->error, TS_RANGE, NULL,
				 "tsim_step: %" PRId64 " steps asked for, expected 0 or more", n);
	if (status == TS_OK)
		status = ts_stepping_advance(&sim->library->stepping, sim, n);
	return ts_library_result(sim, status);
}

/* A function has ended the run. One rank cannot end it alone while others go on. */
static enum ts_status stop_run(struct tsim *sim, int code)
{
	enum ts_status status = sim->error.status;

	if (status == TS_OK)
		status = ts_fail(&sim->error, TS_STOPPED, NULL,
				 "a function of tsim_on_step ended the run at step %" PRId64 " with code %d",
				 sim->clock.step, code);
	if (sim->world)
		sim->world->call->fail(sim->world, tsim_error(sim));
	return status;
}

/* Calls the functions of a stage. An error that a function caused and handled is no error of the run. With several ranks they
 * cannot read what depends on the particles of others, also in steps that each rank does with all. */
static enum ts_status call_functions(struct tsim *sim, enum tsim_stage stage)
{
	struct ts_library *library = sim->library;
	const struct ts_library_calls *calls = &library->calls[stage];
	bool clean = sim->error.status == TS_OK;
	int code = 0;

	library->stage = (int)stage;
	ts_ranks_apart(sim, true);
	for (size_t k = 0; k < calls->n && !code; k++)
		code = calls->item[k].fn(sim, calls->item[k].data);
	ts_ranks_apart(sim, false);
	library->stage = -1;
	if (code)
		return stop_run(sim, code);
	if (clean)
		ts_error_clear(&sim->error);
	return TS_OK;
}

static enum ts_status before_force(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	return call_functions(sim, TSIM_BEFORE_FORCE);
}

static enum ts_status after_force(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	return call_functions(sim, TSIM_AFTER_FORCE);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	return call_functions(sim, TSIM_END_OF_STEP);
}

static const struct ts_style outside = {
	.name = "outside",
	.kind = TS_KIND_SYSTEM,
	.summary = "functions of the calling program, called in each step",
	.hook = { [TS_STAGE_PRE_FORCE] = before_force,
		  [TS_STAGE_POST_FORCE] = after_force,
		  [TS_STAGE_END_OF_STEP] = end_of_step },
};

static enum ts_status check_stage(struct tsim *sim, enum tsim_stage stage)
{
	if ((int)stage >= 0 && (int)stage < TSIM_STAGES)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, NULL, "there is no stage %d of a step", (int)stage);
}

/* Enables or disables the calls. Forces depend on the functions that add to them, so the next run computes
 * them anew. */
static void update_outside(struct tsim *sim, enum tsim_stage stage)
{
	struct ts_library *library = sim->library;
	size_t n = 0;

	for (int k = 0; k < TSIM_STAGES; k++)
		n += library->calls[k].n;
	library->outside.style = &outside;
	library->outside.id = "";
	sim->outside = n ? &library->outside : NULL;
	if (stage != TSIM_END_OF_STEP)
		sim->run.fingerprint = 0;
}

static enum ts_status add_call(struct tsim *sim, enum tsim_stage stage, struct ts_library_call call)
{
	struct ts_library_calls *calls = &sim->library->calls[stage];

	TS_TRY(end_run(sim, "tsim_on_step"));
	if (TS_GROW(calls->item, calls->capacity, calls->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	calls->item[calls->n++] = call;
	update_outside(sim, stage);
	return TS_OK;
}

static enum ts_status remove_call(struct tsim *sim, enum tsim_stage stage, struct ts_library_call call)
{
	struct ts_library_calls *calls = &sim->library->calls[stage];
	size_t k = 0;

	TS_TRY(end_run(sim, "tsim_off_step"));
	while (k < calls->n && (calls->item[k].fn != call.fn || calls->item[k].data != call.data))
		k++;
	if (k == calls->n)
		return ts_fail(&sim->error, TS_UNKNOWN, NULL,
			       "tsim_off_step: this function does not take part in this stage");
	memmove(&calls->item[k], &calls->item[k + 1], (calls->n - k - 1) * sizeof *calls->item);
	calls->n--;
	update_outside(sim, stage);
	return TS_OK;
}

int tsim_on_step(struct tsim *sim, enum tsim_stage stage, tsim_step_fn *fn, void *data)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, fn);

	enum ts_status status = check_stage(sim, stage);

	if (status == TS_OK)
		status = add_call(sim, stage, (struct ts_library_call){ fn, data });
	sim->run.shows_contacts = sim->run.shows_lists = sim->run.needs_lists =
		true; /* the function may evaluate any formula */
	return ts_library_result(sim, status);
}

int tsim_off_step(struct tsim *sim, enum tsim_stage stage, tsim_step_fn *fn, void *data)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, fn);

	enum ts_status status = check_stage(sim, stage);

	if (status == TS_OK)
		status = remove_call(sim, stage, (struct ts_library_call){ fn, data });
	return ts_library_result(sim, status);
}
