/* What a run is going to do, said before it starts: limits of the time step, memory, what is left
 * out. */
#include "core/plan.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "base/hash.h"
#include "explain/guard.h"
#include "explain/price.h"

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

static void add_line(struct ts_str *to, const char *name, const char *format, va_list args)
{
	ts_str_addf(to, "  %-16s ", name);
	ts_str_vaddf(to, format, args);
	ts_str_add(to, "\n");
}

int64_t ts_report_times(const struct tsim *sim, int64_t every)
{
	return every > 0 ? sim->clock.last_step / every - sim->clock.step / every : 0;
}

enum ts_status ts_report_output(struct ts_plan_report *report, const char *name, int64_t frames,
				double bytes)
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
	add_line(&report->lines, name, format, args);
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
				TS_TRY(ts_pardon(sim, list->item[k]->style->plan(list->item[k], sim,
										 report)));
	}
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

static void print_stages(const struct ts_plan *plan, struct tsim *sim)
{
#define STAGE_NAME(name) #name,
	static const char *const names[] = { TS_STAGE_LIST(STAGE_NAME) };
#undef STAGE_NAME

	ts_log(&sim->log, "who acts when:\n");
	for (int stage = 0; stage < TS_NSTAGE; stage++) {
		if (!plan->n[stage])
			continue;
		ts_log(&sim->log, "  %-18s", names[stage]);
		for (size_t k = 0; k < plan->n[stage]; k++) {
			const struct ts_instance *inst = plan->actions[stage][k].self;

			if (k && plan->actions[stage][k].watches) /* once a stage */
				continue;
			ts_log(&sim->log, "%s%s%s%s",
			       plan->actions[stage][k].late ? " then " : " ", inst->style->name,
			       *inst->id && inst->style->kind != TS_KIND_SYSTEM ? ":" : "",
			       inst->style->kind != TS_KIND_SYSTEM ? inst->id : "");
		}
		ts_log(&sim->log, "\n");
	}
}

static void print_outputs(const struct ts_plan_report *report, struct tsim *sim)
{
	struct ts_str text = { 0 };
	double bytes = 0;

	for (size_t k = 0; k < report->noutputs; k++) {
		const struct ts_output *o = &report->output[k];

		if (!o->frames)
			continue;
		bytes += (double)o->frames * o->bytes;
		ts_str_addf(&text, "  %-28s %" PRId64 " times ", o->name, o->frames);
		ts_price_bytes(o->bytes, &text);
		ts_str_add(&text, "\n");
	}
	sim->bill.bytes += bytes;
	if (text.length) {
		ts_str_add(&text, "  in all ");
		ts_price_bytes(bytes, &text);
		ts_log(&sim->log, "files:\n%s\n", ts_str_text(&text));
	}
	ts_str_release(&text);
}

/* "about 3.1 min", or from .. to where the particles coming together makes a difference. */
static void add_duration(struct ts_str *text, double least, double most)
{
	static const double WORTH_TELLING = 1.15;

	ts_price_time(least, text);
	if (most > WORTH_TELLING * least) {
		ts_str_add(text, " to ");
		ts_price_time(most, text);
	}
}

static void add_price(struct ts_str *text, const struct ts_price *price, int64_t steps, bool inserts)
{
	double n = (double)steps;

	ts_str_add(text, "about ");
	add_duration(text, price->seconds * n + price->frames, price->crowded * n + price->frames);
	ts_str_add(text, ", a step takes ");
	ts_price_time(price->seconds, text);
	if (price->steps)
		ts_str_addf(text, " (%" PRId64 " tried from the state here)", price->steps);
	else
		ts_str_add(text, " (as in the run before)");
	if (price->crowded > price->seconds) {
		ts_str_add(text, ", ");
		ts_price_time(price->crowded, text);
		ts_str_add(text, " when the particles lie together");
	}
	if (inserts)
		ts_str_add(text, "; particles still to be inserted are not priced");
}

static void print_price(const struct ts_plan *plan, struct tsim *sim, const struct ts_price *price,
			int64_t steps)
{
	struct ts_str text = { 0 };

	if (isfinite(price->seconds)) {
		add_price(&text, price, steps, plan->n[TS_STAGE_PRE_EXCHANGE] > 0);
		sim->bill.seconds += price->seconds * (double)steps + price->frames;
		sim->bill.most += price->crowded * (double)steps + price->frames;
	} else {
		ts_str_add(&text, "not known, the first steps could not be tried");
	}
	if (steps)
		ts_log(&sim->log, "duration: %s\n", ts_str_text(&text));
	ts_str_release(&text);
}

/* What each omission would add to a step, from trials with it. */
static enum ts_status price_left_out(struct ts_plan_report *report, struct ts_plan *plan,
				     struct tsim *sim, const struct ts_price *price)
{
	for (size_t k = 0; k < report->nleft_out; k++) {
		struct ts_left_out *left = &report->left_out[k];
		double seconds;

		if (!left->part || !price->steps)
			continue;
		TS_TRY(ts_price_full(plan, sim, left->part, &seconds));
		left->share = (seconds - price->seconds) / price->seconds;
	}
	return TS_OK;
}

static void print_left_out(const struct ts_plan_report *report, struct tsim *sim)
{
	static const double WORTH_TELLING = 0.02; /* less is not measured */
	struct ts_str text = { 0 };

	for (size_t k = 0; k < report->nleft_out; k++) {
		const struct ts_left_out *left = &report->left_out[k];
		bool takes = left->share >= WORTH_TELLING;

		ts_str_addf(&text, "  %-16s %s", left->name, left->why);
		if (left->bytes > 0 || takes)
			ts_str_add(&text, "; saves ");
		if (left->bytes > 0)
			ts_price_bytes(left->bytes, &text);
		if (takes && left->share < 1)
			ts_str_addf(&text, "%s%.2g %% of a step", left->bytes > 0 ? ", " : "",
				    100 * left->share);
		else if (takes)
			ts_str_addf(&text, "%sthe time of %.2g steps in each", left->bytes > 0 ? ", " : "",
				    left->share);
		ts_str_add(&text, "\n");
	}
	ts_log(&sim->log, "left out:\n%s", ts_str_text(&text));
	ts_str_release(&text);
}

static void print_report(const struct ts_plan *plan, const struct ts_plan_report *report,
			 struct tsim *sim, int64_t steps)
{
	const struct ts_limit *hard = ts_report_binding(report, true);

	ts_log(&sim->log, "\nPlan of a run of %" PRId64 " steps of %g (time %g to %g)\n", steps,
	       sim->clock.dt, ts_sim_time(sim),
	       ts_sim_time(sim) + (double)steps * sim->clock.dt);
	ts_log(&sim->log, "modelled:\n%s", ts_str_text(&report->lines));
	print_left_out(report, sim);
	ts_log(&sim->log, "memory: about %.3g MB\n", report->bytes / 1e6);
	ts_log(&sim->log, "limits of the time step (now %g):\n", sim->clock.dt);
	for (size_t k = 0; k < report->nlimits; k++)
		ts_log(&sim->log, "%s %-12.6g %s%s\n", &report->limit[k] == hard ? "->" : "  ",
		       report->limit[k].dt, report->limit[k].text,
		       report->limit[k].fatal ? "" : " (advice)");
	print_outputs(report, sim);
	print_stages(plan, sim);
}

/* A run that will be refused has no price. */
static bool has_price(const struct ts_plan_report *report, const struct tsim *sim)
{
	const struct ts_limit *hard = ts_report_binding(report, true);

	return sim->explain && !sim->log.quiet && (!hard || sim->clock.dt < hard->dt || sim->unsafe);
}

enum ts_status ts_plan_review(struct ts_plan *plan, struct tsim *sim, int64_t steps)
{
	struct ts_plan_report report = { .advice = true, .enough = sim->explain ? INFINITY : ts_guard_enough(sim) };
	enum ts_status status = ts_report_collect(&report, sim);
	struct ts_price price;
	bool priced = status == TS_OK && has_price(&report, sim);

	if (priced)
		status = ts_price_steps(plan, sim, &price);
	if (priced && status == TS_OK)
		status = price_left_out(&report, plan, sim, &price);
	if (status == TS_OK && sim->explain)
		print_report(plan, &report, sim, steps);
	if (status == TS_OK)
		status = ts_guard_judge(sim, &report);
	if (status == TS_OK && priced)
		print_price(plan, sim, &price, steps);
	ts_report_release(&report);
	return status;
}
