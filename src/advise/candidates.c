/* The settings that can be tried with a script, and how they are changed. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "advise/candidates.h"
#include "core/sim.h"
#include "neigh/neigh.h"
#include "particle/prescribed.h"

#include "base/banned.h"

static const double SAFE = 0.8; /* longest time step tried, as a fraction of the stability limit */
static const double steps[] = { 0.25, 0.5, 2, 4 }, skins[] = { 0.5, 2 };
enum { MOST_THREADS = 8 };

/* Arguments of styles that are varied. The values `to` are tried if the present one is among `from` ("*":
 * any). `needs`: a material property that the new value requires; if it is not defined, it is estimated
 * from the speeds of the particles. */
static const struct {
	enum ts_kind kind;
	const char *style, *keyword;
	const char *from[6], *to[6];
	const char *needs;
} choices[] = {
	{ TS_KIND_PAIR, "gran", "model", { "hertz" }, { "hooke" }, "characteristicVelocity" },
	{ TS_KIND_PAIR, "gran", "model", { "hooke" }, { "hertz" }, NULL },
	{ TS_KIND_PAIR, "gran", "tangential", { "history" }, { "no_history" }, NULL },
	{ TS_KIND_PAIR, "gran", "tangential", { "no_history" }, { "history" }, NULL },
	{ TS_KIND_PAIR, "gran", "rolling_friction", { "cdt", "epsd", "epsd2", "epsd3" }, { "off" }, NULL },
	{ TS_KIND_PAIR, "*", "located", { "*" }, { "yes" }, NULL },
	{ TS_KIND_FLOW, "projection", "time", { "*" }, { "euler", "rk2" }, NULL },
	{ TS_KIND_FLOW, "projection", "viscous", { "explicit" }, { "implicit" }, NULL },
	{ TS_KIND_FLOW,
	  "projection",
	  "convection",
	  { "*" },
	  { "donor", "central", "quick", "cubista" },
	  NULL },
	{ TS_KIND_FLOW, "projection", "every", { "1" }, { "2", "5" }, NULL },
	{ TS_KIND_FLOW, "projection", "substeps", { "1" }, { "2", "auto" }, NULL },
};
enum { NCHOICES = sizeof choices / sizeof *choices };

static const struct ts_arg *find_argument(const struct ts_instance *inst, const char *keyword)
{
	const struct ts_arg *row = inst->style->args;

	while (row && row->type != TS_ARG_END && !ts_streq(row->name, keyword))
		row++;
	return row && row->type != TS_ARG_END ? row : NULL;
}

/* The value of an argument as in a script; "" if it has none. */
static void present_value(const struct tsim *sim, const struct ts_instance *inst, const struct ts_arg *row,
			  char *out, size_t room)
{
	struct ts_str text = { 0 };

	ts_arg_record(sim, row, inst->state, &text);
	snprintf(out, room, "%s", *ts_str_text(&text) ? ts_str_text(&text) + 1 : "");
	ts_str_release(&text);
}

static bool is_listed(const char *const list[6], const char *value)
{
	for (int k = 0; k < 6 && list[k]; k++)
		if (ts_streq(list[k], value) || ts_streq(list[k], "*"))
			return true;
	return false;
}

/* Index of the word among the choices of an ENUM argument, or -1. */
static int choice_of(const struct ts_arg *row, const char *value)
{
	for (int k = 0; row->choices && row->choices[k]; k++)
		if (ts_streq(row->choices[k], value))
			return k;
	return -1;
}

static bool can_set(const struct ts_arg *row, const char *value)
{
	return row->type == TS_ARG_BOOL || row->type == TS_ARG_INT || row->type == TS_ARG_WORD ||
	       (row->type == TS_ARG_ENUM && choice_of(row, value) >= 0);
}

/* Stores the value as the parser would; init of the style, which is called before each run, evaluates it. */
static void set_argument(struct ts_instance *inst, const struct ts_arg *row, const char *value)
{
	void *field = (char *)inst->state + row->offset;
	int64_t number = 0;

	if (row->type == TS_ARG_ENUM)
		*(int *)field = choice_of(row, value);
	else if (row->type == TS_ARG_BOOL)
		*(bool *)field = ts_streq(value, "yes");
	else if (row->type == TS_ARG_WORD)
		*(const char **)field = value;
	else if (ts_parse_int(value, &number))
		*(int64_t *)field = number;
}

static struct ts_trial *add_trial(struct ts_trial_results *b, enum ts_subject subject)
{
	struct ts_trial *t;

	if (b->n == TS_TRIAL_MOST)
		return NULL;
	t = &b->trial[b->n++];
	*t = (struct ts_trial){ .subject = (int)subject };
	return t;
}

static void add_step_trial(struct ts_trial_results *b, double dt)
{
	struct ts_trial *t = add_trial(b, TS_SUBJECT_STEP);

	if (!t)
		return;
	t->dt = dt;
	snprintf(t->label, sizeof t->label, "timestep %.4g", dt);
}

static void list_steps(struct ts_trial_results *b)
{
	double most = isfinite(b->limit) ? SAFE * b->limit : 2 * b->dt, longest = b->dt;

	for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
		if (steps[k] * b->dt > most * (1 + 1e-12))
			continue;
		longest = fmax(longest, steps[k] * b->dt);
		add_step_trial(b, steps[k] * b->dt);
	}
	if (isfinite(b->limit) && most > 1.2 * longest && most < 100 * b->dt)
		add_step_trial(b, most);
}

static void list_skins(struct ts_trial_results *b)
{
	for (size_t k = 0; k < sizeof skins / sizeof *skins && b->skin > 0; k++) {
		struct ts_trial *t = add_trial(b, TS_SUBJECT_SKIN);

		if (!t)
			return;
		t->skin = skins[k] * b->skin;
		snprintf(t->label, sizeof t->label, "neighbor %.4g bin", t->skin);
	}
}

static void list_threads(struct ts_trial_results *b)
{
	long there = sysconf(_SC_NPROCESSORS_ONLN);

	for (int n = 1; n <= MOST_THREADS && n <= there; n *= 2) {
		struct ts_trial *t = n == b->threads ? NULL : add_trial(b, TS_SUBJECT_THREADS);

		if (!t)
			continue;
		t->threads = n;
		snprintf(t->label, sizeof t->label, "-threads %d", n);
	}
}

static void list_choice(struct tsim *sim, struct ts_trial_results *b, int c)
{
	const struct ts_instance *inst = ts_sim_only(sim, choices[c].kind);
	const struct ts_arg *row;
	char now[TS_TRIAL_TEXT];

	if (!inst || !ts_glob(choices[c].style, inst->style->name))
		return;
	row = find_argument(inst, choices[c].keyword);
	if (!row)
		return;
	present_value(sim, inst, row, now, sizeof now);
	if (!is_listed(choices[c].from, now))
		return;
	for (int k = 0; k < 6 && choices[c].to[k]; k++) {
		struct ts_trial *t = ts_streq(choices[c].to[k], now) || !can_set(row, choices[c].to[k])
					     ? NULL
					     : add_trial(b, TS_SUBJECT_CHOICE);

		if (!t)
			continue;
		t->choice = c;
		t->contact_law = choices[c].kind == TS_KIND_PAIR;
		snprintf(t->value, sizeof t->value, "%s", choices[c].to[k]);
		snprintf(t->label, sizeof t->label, "%s %s", choices[c].keyword, choices[c].to[k]);
	}
}

static void list_pressures(struct tsim *sim, struct ts_trial_results *b)
{
	static const char *const solvers[] = { "direct", "cg", "multigrid", "sor", NULL };
	const struct ts_instance *now = ts_sim_only(sim, TS_KIND_PRESSURE);
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	if (!flow || !ts_streq(flow->style->name, "projection"))
		return;
	for (const char *const *s = solvers; *s; s++) {
		struct ts_trial *t =
			now && ts_streq(now->style->name, *s) ? NULL : add_trial(b, TS_SUBJECT_PRESSURE);

		if (t)
			snprintf(t->label, sizeof t->label, "pressure_style %s", *s);
	}
}

void ts_candidates_list(struct tsim *sim, struct ts_trial_results *b)
{
	struct ts_trial *t = add_trial(b, TS_SUBJECT_PRESENT);

	snprintf(t->label, sizeof t->label, "present: %.4g, %d thread%s", b->dt, b->threads,
		 b->threads == 1 ? "" : "s");
	if (b->particles && (t = add_trial(b, TS_SUBJECT_PERTURBED)))
		snprintf(t->label, sizeof t->label, "present, perturbed by 1e-10 R");
	list_steps(b);
	list_skins(b);
	list_threads(b);
	for (int c = 0; c < NCHOICES; c++)
		list_choice(sim, b, c);
	list_pressures(sim, b);
}

/* ---- in the forked copy */

static enum ts_status run_line(struct tsim *sim, const char *format, ...)
	__attribute__((format(printf, 2, 3)));
static enum ts_status run_line(struct tsim *sim, const char *format, ...)
{
	static const struct ts_place here = { .file = "-advise" };
	struct ts_str line = { 0 };
	enum ts_status status;
	va_list args;

	va_start(args, format);
	ts_str_vaddf(&line, format, args);
	va_end(args);
	status = line.failed ? ts_nomem(&sim->error)
			     : sim->script_api->execute(sim->script_api_data, line.text, &here);
	ts_str_release(&line);
	return status;
}

static enum ts_status define_missing_property(struct tsim *sim, const char *property)
{
	double speed = ts_prescribed_max_speed(sim, 0);

	if (!property || ts_sim_has_property(sim, property))
		return TS_OK;
	if (!(speed > 0))
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "requires %s, which cannot be estimated: no particle moves", property);
	return run_line(sim, "fix advise_%s all property/global %s scalar %.3g", property, property, speed);
}

/* Sets the argument of the style, and that of walls with contact laws of their own if it had the same
 * value. */
static enum ts_status apply_choice(struct tsim *sim, int c, const char *value)
{
	struct ts_instance *inst = ts_sim_only(sim, choices[c].kind);
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	const struct ts_arg *row = find_argument(inst, choices[c].keyword);
	char before[TS_TRIAL_TEXT], now[TS_TRIAL_TEXT];

	TS_TRY(define_missing_property(sim, choices[c].needs));
	present_value(sim, inst, row, before, sizeof before);
	set_argument(inst, row, value);
	for (size_t k = 0; k < fixes->n && choices[c].kind == TS_KIND_PAIR; k++) {
		struct ts_instance *wall = fixes->item[k];

		row = wall->style->family && ts_streq(wall->style->family, "wall")
			      ? find_argument(wall, choices[c].keyword)
			      : NULL;
		if (!row)
			continue;
		present_value(sim, wall, row, now, sizeof now);
		if (ts_streq(now, before) && can_set(row, value))
			set_argument(wall, row, value);
	}
	return TS_OK;
}

enum ts_status ts_candidates_apply(struct tsim *sim, const struct ts_trial_results *b,
				   const struct ts_trial *t)
{
	if (t->threads > 0)
		sim->threads = t->threads;
	if (t->skin > 0)
		sim->neigh->skin = t->skin;
	if (t->subject == TS_SUBJECT_CHOICE)
		return apply_choice(sim, t->choice, t->value);
	if (t->subject == TS_SUBJECT_PRESSURE)
		return run_line(sim, "%s", t->label);
	if (t->subject != TS_SUBJECT_TOGETHER)
		return TS_OK;
	for (int k = 0; k < b->n; k++) /* those advised when the trial was added */
		if (b->trial[k].advised && b->trial[k].subject >= TS_SUBJECT_CHOICE &&
		    b->trial[k].subject < TS_SUBJECT_TOGETHER)
			TS_TRY(ts_candidates_apply(sim, b, &b->trial[k]));
	return TS_OK;
}
