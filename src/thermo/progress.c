#include "thermo/progress.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "particle/particles.h"

#include "base/banned.h"

static const double LOOK = 0.05;   /* s between readings of the clock */
static const double RENEW = 0.5;   /* s between lines on a terminal */
static const double TELL = 0.2;	   /* s between lines for the callback of the log */
static const double WINDOW = 10;   /* s: rates are those since one to two windows ago */
static const double TRIAL = 1;	   /* s from which the duration of the run is estimated */
static const double LONG_RUN = 60; /* s: shorter durations are not told */
enum { PART = 48, USUAL_WIDTH = 80 };

void ts_progress_duration(double seconds, char *out, size_t size)
{
	static const struct {
		int64_t length, part;
		const char *name, *part_name;
	} unit[] = { { 86400, 3600, "d", "h" }, { 3600, 60, "h", "min" }, { 60, 1, "min", "s" } };
	int64_t s;

	if (!(seconds < 1e12)) {
		snprintf(out, size, "very long");
		return;
	}
	s = (int64_t)fmax(seconds, 0);
	for (size_t k = 0; k < sizeof unit / sizeof *unit; k++) {
		if (s < unit[k].length)
			continue;
		snprintf(out, size, "%" PRId64 " %s %" PRId64 " %s", s / unit[k].length, unit[k].name,
			 s % unit[k].length / unit[k].part, unit[k].part_name);
		return;
	}
	snprintf(out, size, "%" PRId64 " s", s);
}

/* "230 steps/s", "1.23 M particle-steps/s"; "" if not known. */
static void print_rate(double rate, const char *what, char *out)
{
	static const char *const prefix[] = { "", " k", " M", " G", " T" };
	size_t k = 0;

	*out = 0;
	if (!(rate > 0) || isinf(rate))
		return;
	for (; k < 4 && rate >= 999.5; k++)
		rate /= 1000;
	snprintf(out, PART, "%.3g%s %s", rate, prefix[k], what);
}

void ts_progress_line(const struct ts_progress_facts *f, int width, char *out, size_t size)
{
	enum { SHARE, STEP, RATE, WORK, LEFT, NPARTS };
	static const int least_important[] = { WORK, STEP, RATE, SHARE, LEFT };
	char part[NPARTS][PART] = { "" }, left[PART - 8];
	size_t total = 0, at = 0;

	if (f->last > f->first) {
		snprintf(part[SHARE], PART, "%.1f %%",
			 100 * (double)(f->step - f->first) / (double)(f->last - f->first));
		snprintf(part[STEP], PART, "step %" PRId64 " of %" PRId64, f->step, f->last);
	} else {
		snprintf(part[STEP], PART, "step %" PRId64, f->step);
	}
	print_rate(f->steps_per_second, "steps/s", part[RATE]);
	print_rate(f->steps_per_second * (double)f->particles, "particle-steps/s", part[WORK]);
	if (f->left >= 0) {
		ts_progress_duration(f->left, left, sizeof left);
		snprintf(part[LEFT], PART, "%s left", left);
	}
	for (int k = 0; k < NPARTS; k++)
		total += part[k][0] ? strlen(part[k]) + 2 : 0;
	for (int k = 0; k < NPARTS && total > (size_t)width + 2; k++) {
		char *less = part[least_important[k]];

		total -= *less ? strlen(less) + 2 : 0;
		*less = 0;
	}
	*out = 0;
	for (int k = 0; k < NPARTS; k++)
		if (part[k][0] && at < size)
			at += (size_t)snprintf(out + at, size - at, "%s%s", at ? ", " : "", part[k]);
}

void ts_progress_begin(struct ts_progress *p, const struct tsim *sim)
{
	double now = ts_clock();
	struct ts_progress_mark mark = { sim->clock.step, now };

	if (sim->clock.step == sim->clock.command_step || p->first != sim->clock.command_step) {
		*p = (struct ts_progress){ .first = sim->clock.command_step, .began = now };
		p->mark[0] = p->mark[1] = mark;
	}
	p->last = mark;
	p->look = sim->clock.step + 1;
}

/* Sets the step of the next reading of the clock. */
static void plan_look(struct ts_progress *p, int64_t step, double now)
{
	double steps = (double)(step - p->last.step), spent = now - p->last.time;
	double next = spent > 0 ? fmin(steps * LOOK / spent, 2 * steps) : 2 * steps;

	p->last = (struct ts_progress_mark){ step, now };
	p->look = step + (next < 1 ? 1 : (int64_t)next);
	if (now - p->mark[1].time > WINDOW) {
		p->mark[0] = p->mark[1];
		p->mark[1] = p->last;
	}
}

static struct ts_progress_facts collect_facts(const struct ts_progress *p, const struct tsim *sim, double now)
{
	const struct ts_clock *c = &sim->clock;
	int64_t last = c->goal > c->last_step ? c->goal : c->last_step;
	double spent = now - p->mark[0].time;
	struct ts_progress_facts f = { p->first, c->step, last, NAN, sim->particles->n, -1 };

	if (last == INT64_MAX || c->step < p->first || c->step > last)
		f.last = p->first - 1;
	if (spent > 0)
		f.steps_per_second = (double)(c->step - p->mark[0].step) / spent;
	if (f.last > f.first && f.steps_per_second > 0)
		f.left = (double)(last - c->step) / f.steps_per_second;
	return f;
}

/* Once, after the first second. -explain, which steps a copy, knows the duration before; a run cannot step a
 * copy, because its files are open. */
static void estimate_duration(struct ts_progress *p, struct tsim *sim, double now)
{
	struct ts_progress_facts f;
	char text[PART];

	if (p->estimated || now - p->began < TRIAL)
		return;
	p->estimated = true;
	f = collect_facts(p, sim, now);
	if (!(f.left + now - p->began > LONG_RUN))
		return;
	ts_progress_duration(f.left + now - p->began, text, sizeof text);
	ts_log(&sim->log, "Estimated duration of this run: %s, %.3g steps/s\n", text, f.steps_per_second);
	ts_log_flush(&sim->log, &sim->error);
}

void ts_progress_step(struct ts_progress *p, struct tsim *sim)
{
	bool shown = ts_log_shows_progress(&sim->log), told = sim->log.sink != NULL;
	struct ts_progress_facts f;
	char text[6 * PART];
	int width;
	double now;

	if (sim->clock.step < p->look || sim->run.in_pieces)
		return;
	now = ts_clock();
	plan_look(p, sim->clock.step, now);
	estimate_duration(p, sim, now);
	if (now < p->due || !(shown || told))
		return;
	p->due = now + (shown ? RENEW : TELL);
	width = shown ? ts_log_width(&sim->log) - 1 : USUAL_WIDTH;
	f = collect_facts(p, sim, now);
	ts_progress_line(&f, width, text, sizeof text);
	ts_log_progress(&sim->log, text);
}
