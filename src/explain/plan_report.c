#include "explain/plan_report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "core/ranks.h"
#include "core/report.h"
#include "explain/guard.h"
#include "explain/price.h"
#include "explain/rank_report.h"

#include "base/banned.h"

static void print_stages(const struct ts_plan *plan, struct tsim *sim)
{
#define STAGE_NAME(name) #name,
	static const char *const names[] = { TS_STAGE_LIST(STAGE_NAME) };
#undef STAGE_NAME

	ts_log(&sim->log, "actions of each stage:\n");
	for (int stage = 0; stage < TS_NSTAGE; stage++) {
		if (!plan->n[stage])
			continue;
		ts_log(&sim->log, "  %-18s", names[stage]);
		for (size_t k = 0; k < plan->n[stage]; k++) {
			const struct ts_instance *inst = plan->actions[stage][k].self;

			if (k && plan->actions[stage][k].watches) /* listed once per stage */
				continue;
			ts_log(&sim->log, "%s%s%s%s", plan->actions[stage][k].late ? " then " : " ",
			       inst->style->name, *inst->id && inst->style->kind != TS_KIND_SYSTEM ? ":" : "",
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
	sim->cost.bytes += bytes;
	if (text.length) {
		ts_str_add(&text, "  total ");
		ts_price_bytes(bytes, &text);
		ts_log(&sim->log, "output files:\n%s\n", ts_str_text(&text));
	}
	ts_str_release(&text);
}

/* Adds "3.1 min", or "3.1 min to 5.2 min" if a dense packing of the particles takes noticeably longer. */
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
	ts_str_add(text, ", time per step ");
	ts_price_time(price->seconds, text);
	if (price->steps)
		ts_str_addf(text, " (%" PRId64 " steps measured from the current state)", price->steps);
	else
		ts_str_add(text, " (as in the previous run)");
	if (price->crowded > price->seconds) {
		ts_str_add(text, ", ");
		ts_price_time(price->crowded, text);
		ts_str_add(text, " in a dense packing");
	}
	if (inserts)
		ts_str_add(text, "; particles that are still to be inserted are not included");
}

/* Whether fixes insert particles, or change the division. */
static bool has_insertions(const struct ts_plan *plan)
{
	bool has = false;

	for (size_t k = 0; k < plan->n[TS_STAGE_PRE_EXCHANGE]; k++)
		has |= plan->actions[TS_STAGE_PRE_EXCHANGE][k].self->style->kind == TS_KIND_FIX;
	return has;
}

static void print_price(const struct ts_plan *plan, struct tsim *sim, const struct ts_price *price,
			int64_t steps)
{
	struct ts_str text = { 0 };

	if (isfinite(price->seconds)) {
		add_price(&text, price, steps, has_insertions(plan));
		sim->cost.seconds += price->seconds * (double)steps + price->frames;
		sim->cost.most += price->crowded * (double)steps + price->frames;
	} else {
		ts_str_addf(&text, "unknown, %s", price->why[0] ? price->why : "the first steps failed");
	}
	if (steps)
		ts_log(&sim->log, "duration: %s\n", ts_str_text(&text));
	ts_str_release(&text);
}

/* Measures how much each omitted part would add to the time of a step. */
static enum ts_status price_left_out(struct ts_plan_report *report, struct ts_plan *plan, struct tsim *sim,
				     const struct ts_price *price)
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
	static const double WORTH_TELLING = 0.02; /* smaller differences are not significant */
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
			ts_str_addf(&text, "%s%.2g times the time of a step", left->bytes > 0 ? ", " : "",
				    left->share);
		ts_str_add(&text, "\n");
	}
	ts_log(&sim->log, "omitted:\n%s", ts_str_text(&text));
	ts_str_release(&text);
}

static void print_report(const struct ts_plan *plan, const struct ts_plan_report *report, struct tsim *sim,
			 int64_t steps)
{
	const struct ts_limit *hard = ts_report_binding(report, true);

	ts_log(&sim->log, "\nPlan of a run of %" PRId64 " steps of %g (time %g to %g)\n", steps,
	       sim->clock.dt, ts_sim_time(sim), ts_sim_time(sim) + (double)steps * sim->clock.dt);
	ts_log(&sim->log, "modelled:\n%s", ts_str_text(&report->lines));
	print_left_out(report, sim);
	ts_log(&sim->log, "memory: about %.3g MB\n", report->bytes / 1e6);
	ts_log(&sim->log, "time step limits (present %g):\n", sim->clock.dt);
	for (size_t k = 0; k < report->nlimits; k++)
		ts_log(&sim->log, "%s %-12.6g %s%s\n", &report->limit[k] == hard ? "->" : "  ",
		       report->limit[k].dt, report->limit[k].text, report->limit[k].fatal ? "" : " (advice)");
	print_outputs(report, sim);
	print_stages(plan, sim);
}

/* A run that will be refused is not priced. */
static bool has_price(const struct ts_plan_report *report, const struct tsim *sim)
{
	const struct ts_limit *hard = ts_report_binding(report, true);

	return sim->reading.explain && !sim->log.quiet &&
	       (!hard || sim->clock.dt < hard->dt || sim->run.unsafe);
}

enum ts_status ts_plan_judge_own(struct tsim *sim)
{
	struct ts_plan_report report = { .advice = true, .enough = ts_guard_enough(sim) };
	enum ts_status status = ts_report_collect(&report, sim);

	if (status == TS_OK)
		sim->review.found |= ts_guard_has_doubts(sim, &report);
	ts_report_release(&report);
	return status;
}

enum ts_status ts_plan_judge(struct ts_plan *plan, struct tsim *sim, int64_t steps)
{
	struct ts_plan_report report = { .advice = true,
					 .enough = sim->reading.explain ? INFINITY : ts_guard_enough(sim) };
	enum ts_status status = ts_report_collect(&report, sim);
	struct ts_price price;
	bool priced = status == TS_OK && has_price(&report, sim);

	if (status == TS_OK && sim->reading.explain && sim->requests.stop)
		status = ts_fail(&sim->error, TS_STOPPED, NULL, "stopped on request");
	if (priced && status == TS_OK)
		status = ts_price_steps(plan, sim, &price);
	if (priced && status == TS_OK)
		status = price_left_out(&report, plan, sim, &price);
	if (status == TS_OK && sim->reading.explain)
		print_report(plan, &report, sim, steps);
	if (status == TS_OK && sim->recorder)
		sim->recorder->planned(sim->recorder, sim, &report);
	if (status == TS_OK)
		status = ts_guard_judge(sim, &report);
	if (status == TS_OK && priced)
		print_price(plan, sim, &price, steps);
	if (status == TS_OK && sim->reading.explain && ts_ranks(sim) > 1)
		status = ts_rank_report(sim, &report, priced ? price.seconds : NAN);
	ts_report_release(&report);
	return status;
}
