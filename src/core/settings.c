#include "core/settings.h"

#include <stdarg.h>

#include "core/ranks.h"
#include "core/units.h"

#include "base/banned.h"

void ts_setting(struct ts_str *out, bool is_default, const char *format, ...)
{
	va_list args;

	ts_str_add(out, " ");
	va_start(args, format);
	ts_str_vaddf(out, format, args);
	va_end(args);
	ts_str_add(out, is_default ? " (default)" : "");
}

static bool is_given(const struct ts_arg *row, struct ts_words words, size_t position)
{
	if (row->flags & TS_POSITIONAL)
		return position < words.n;
	for (size_t k = 0; k < words.n; k++)
		if (ts_streq(words.word[k].text, row->name))
			return true;
	return false;
}

/* Text of the arguments given, and of those with their defaults. */
struct record {
	struct ts_str given, defaults;
};

static void append_arguments(const struct tsim *sim, const struct ts_arg *row, const void *base,
			     struct ts_words words, size_t position, struct record *out)
{
	for (; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)base + row->offset;
		bool is_default = row->fallback && !is_given(row, words, position);
		struct ts_str *to = is_default ? &out->defaults : &out->given;
		struct ts_str value = { 0 };

		if (ts_arg_record(sim, row, base, &value) && value.length)
			ts_str_addf(to, " %s%s", row->name, ts_str_text(&value));
		ts_str_release(&value);
		position += row->type == TS_ARG_VEC3 ? 3 : (row->flags & TS_POSITIONAL) != 0;
		if (row->type == TS_ARG_MODE && *(const int *)field >= 0)
			append_arguments(sim, row->modes[*(const int *)field].args, base, words, position,
					 out);
	}
}

void ts_settings_log(struct tsim *sim, const char *what, const struct ts_arg *rows, const void *base,
		     struct ts_words words)
{
	struct record record = { 0 };
	struct ts_str line = { 0 };

	if (!ts_log_wants_settings(&sim->log))
		return;
	append_arguments(sim, rows, base, words, 0, &record);
	ts_str_addf(&line, "# %s:%s%s by default:%s", what, ts_str_text(&record.given),
		    record.given.length ? ";" : "", ts_str_text(&record.defaults));
	if (record.defaults.length)
		ts_log_setting(&sim->log, ts_str_text(&line));
	ts_str_release(&line);
	ts_str_release(&record.given);
	ts_str_release(&record.defaults);
}

void ts_settings_log_run(struct tsim *sim)
{
	const struct ts_instances *systems = &sim->instances[TS_KIND_SYSTEM];
	double dt = ts_units_dt(sim->units);
	struct ts_str line = { 0 };
	const char *text;

	/* with several ranks all go on, as some settings are found by all of them */
	if (ts_ranks(sim) == 1 && !ts_log_wants_settings(&sim->log))
		return;
	ts_str_add(&line, "# settings:");
	ts_setting(&line, sim->units == TS_UNITS_LJ, "units %s", ts_units_name(sim->units));
	ts_setting(&line, sim->dimension == 3, "dimension %d", sim->dimension);
	ts_setting(&line, !(sim->clock.dt < dt || sim->clock.dt > dt), "timestep %.15g", sim->clock.dt);
	ts_setting(&line, sim->threads == 1, "threads %d", sim->threads);
	for (size_t k = 0; k < systems->n; k++) {
		const struct ts_system_style *style = (const struct ts_system_style *)systems->item[k]->style;

		if (style->settings)
			style->settings(systems->item[k], sim, &line);
	}
	text = line.failed ? NULL : ts_pool_get(sim->pool, ts_str_text(&line));
	if (text && text != sim->settings)
		ts_log_setting(&sim->log, text);
	sim->settings = text;
	ts_str_release(&line);
}
