#include "core/report.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "base/hash.h"

#include "base/banned.h"

static uint64_t cause_of(const struct ts_place *where, const char *format)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_text(&hash, where->file ? where->file : "");
	ts_hash_add(&hash, &where->line, sizeof where->line);
	ts_hash_text(&hash, format);
	return ts_hash_value(&hash);
}

enum ts_status ts_report_limit(struct ts_plan_report *report, double dt, bool fatal,
			       const struct ts_place *where, const char *format, ...)
{
	struct ts_limit *limit;
	va_list args;

	if (isinf(dt)) /* no limit */
		return TS_OK;
	TS_TRY(TS_GROW(report->limit, report->limit_capacity, report->nlimits + 1));
	limit = &report->limit[report->nlimits++];
	limit->dt = dt;
	limit->fatal = fatal;
	limit->where = *where;
	limit->cause = cause_of(where, format);
	va_start(args, format);
	vsnprintf(limit->text, sizeof limit->text, format, args);
	va_end(args);
	return TS_OK;
}

void ts_report_watched(struct ts_plan_report *report, size_t n)
{
	for (; n < report->nlimits; n++)
		report->limit[n].watched = true;
}

static void append_line(struct ts_str *to, const char *name, const char *format, va_list args)
{
	ts_str_addf(to, "  %-16s ", name);
	ts_str_vaddf(to, format, args);
	ts_str_add(to, "\n");
}

int64_t ts_report_count(const struct tsim *sim, int64_t every)
{
	return every > 0 ? sim->clock.last_step / every - sim->clock.step / every : 0;
}

enum ts_status ts_report_output(struct ts_plan_report *report, const char *name, int64_t frames, double bytes)
{
	struct ts_output *output;

	if (report->limits_only)
		return TS_OK;
	TS_TRY(TS_GROW(report->output, report->output_capacity, report->noutputs + 1));
	output = &report->output[report->noutputs++];
	snprintf(output->name, sizeof output->name, "%s", name);
	output->frames = frames;
	output->bytes = bytes;
	return TS_OK;
}

void ts_report_line(struct ts_plan_report *report, const char *name, const char *format, ...)
{
	va_list args;

	if (report->limits_only)
		return;
	va_start(args, format);
	append_line(&report->lines, name, format, args);
	va_end(args);
}

void ts_report_left_out(struct ts_plan_report *report, const char *name, unsigned part, double bytes,
			const char *format, ...)
{
	struct ts_left_out *left;
	va_list args;

	if (report->limits_only ||
	    TS_GROW(report->left_out, report->left_out_capacity, report->nleft_out + 1) != TS_OK)
		return;
	left = &report->left_out[report->nleft_out++];
	*left = (struct ts_left_out){ .part = part, .bytes = bytes, .share = NAN };
	snprintf(left->name, sizeof left->name, "%s", name);
	va_start(args, format);
	vsnprintf(left->why, sizeof left->why, format, args);
	va_end(args);
}

void ts_report_release(struct ts_plan_report *report)
{
	ts_free(report->limit);
	ts_free(report->output);
	ts_str_release(&report->lines);
	ts_free(report->left_out);
	*report = (struct ts_plan_report){ 0 };
}

enum ts_status ts_report_collect(struct ts_plan_report *report, struct tsim *sim)
{
	for (int kind = 0; kind < TS_NKIND; kind++) {
		const struct ts_instances *list = &sim->instances[kind];

		if (report->limits_only && (kind == TS_KIND_COMPUTE || kind == TS_KIND_DUMP))
			continue;
		for (size_t k = 0; k < list->n; k++)
			if (list->item[k]->style->plan)
				TS_TRY(ts_sim_defer_error(sim, list->item[k]->style->plan(list->item[k], sim,
											  report)));
	}
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if ((*s)->limits)
			TS_TRY(ts_sim_defer_error(sim, (*s)->limits(report, sim)));
	return TS_OK;
}

const struct ts_limit *ts_report_binding(const struct ts_plan_report *report, bool fatal)
{
	const struct ts_limit *least = NULL;

	for (size_t k = 0; k < report->nlimits; k++)
		if (report->limit[k].fatal == fatal && (!least || report->limit[k].dt < least->dt))
			least = &report->limit[k];
	return least;
}
