/* Fix halt: ends a run early when a condition is met. */
#include "core/sim.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "bond/bonds.h"
#include "box/domain.h"
#include "core/number_or_peratom.h"
#include "neigh/neigh.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { LESS, LESS_EQUAL, MORE, MORE_EQUAL, EQUAL, NOT_EQUAL, XOR };
enum { HARD, SOFT, CONTINUE };

struct state;
typedef enum ts_status measure_fn(struct ts_instance *self, struct tsim *sim, double *out);

struct state {
	int64_t every;
	const char *attribute, *path;
	int comparison, error;
	double limit;
	bool message;
	measure_fn *measure;
	struct ts_number number; /* the variable of attribute v_NAME */
};

static enum ts_status longest_bond(struct ts_instance *self, struct tsim *sim, double *out)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_identities map;

	(void)self;
	*out = 0;
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t b = 0; b < bonds->n; b++) {
		const double *x = p->x[ts_identity_row(&map, bonds->tag[b][0])];
		const double *y = p->x[ts_identity_row(&map, bonds->tag[b][1])];
		double d[3] = { x[0] - y[0], x[1] - y[1], x[2] - y[2] };

		ts_box_nearest(&sim->domain->box, d);
		*out = fmax(*out, sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
	}
	return TS_OK;
}

static enum ts_status wall_time(struct ts_instance *self, struct tsim *sim, double *out)
{
	(void)self;
	*out = ts_clock() - sim->clock.wall_start;
	return TS_OK;
}

static enum ts_status free_disk(struct ts_instance *self, struct tsim *sim, double *out)
{
	const struct state *s = self->state;
	double bytes = ts_files_free_space(&sim->files, s->path);

	if (bytes < 0)
		return ts_fail(&sim->error, TS_IO, &self->where, "fix halt: no disk at '%s': %s", s->path,
			       ts_files_why(&sim->files));
	*out = bytes / 1e6;
	return TS_OK;
}

static enum ts_status variable_value(struct ts_instance *self, struct tsim *sim, double *out)
{
	const struct state *s = self->state;

	return ts_number_now(sim, &s->number, &self->where, out);
}

static const struct {
	const char *name;
	measure_fn *measure;
} attributes[] = {
	{ "bondmax", longest_bond },
	{ "tlimit", wall_time },
	{ "diskfree", free_disk },
};
enum { NATTRIBUTES = sizeof attributes / sizeof *attributes };

static enum ts_status use_variable(struct ts_instance *self, struct tsim *sim, const char *name)
{
	struct state *s = self->state;
	struct ts_suggest suggest = ts_suggest_start(name);

	if (!sim->script_api || !sim->script_api->has_variable(sim->script_api_data, name)) {
		if (sim->script_api)
			sim->script_api->suggest_variable(sim->script_api_data, &suggest);
		return ts_missing(&sim->error, "variable", name, &self->where,
				  "fix halt: unknown variable '%s'%s", name, ts_suggest_text(&suggest));
	}
	s->number.variable = name;
	s->measure = variable_value;
	return ts_number_check(sim, &s->number, ts_instance_word(self, s->attribute));
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_suggest suggest = ts_suggest_start(s->attribute);

	ts_neigh_keep_forces_every(sim->neigh,
				   s->every); /* each may be the last step, whose contact forces are kept */
	if (strncmp(s->attribute, "v_", 2) == 0)
		return use_variable(self, sim, s->attribute + 2);
	for (int k = 0; k < NATTRIBUTES; k++) {
		if (ts_streq(s->attribute, attributes[k].name)) {
			s->measure = attributes[k].measure;
			return TS_OK;
		}
		ts_suggest_try(&suggest, attributes[k].name);
	}
	return ts_fail(&sim->error, TS_UNKNOWN, &self->where,
		       "fix halt: unknown attribute '%s', expected v_NAME or one of bondmax, tlimit, "
		       "diskfree%s",
		       s->attribute, suggest.best ? ts_suggest_text(&suggest) : "");
}

static bool holds(int comparison, double a, double b)
{
	switch (comparison) {
	case LESS:
		return a < b;
	case LESS_EQUAL:
		return a <= b;
	case MORE:
		return a > b;
	case MORE_EQUAL:
		return a >= b;
	case EQUAL:
		return a <= b && a >= b;
	case NOT_EQUAL:
		return a < b || a > b;
	default:
		return (a < 0 || a > 0) != (b < 0 || b > 0);
	}
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0;
}

/* If the condition holds, this step becomes the last one of the run. */
static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	char text[160];
	double value;

	if (!due(self, sim))
		return TS_OK;
	TS_TRY(s->measure(self, sim, &value));
	if (!holds(s->comparison, value, s->limit))
		return TS_OK;
	snprintf(text, sizeof text, "Fix halt condition for fix-id %s met on step %" PRId64 " with value %g",
		 self->id, sim->clock.step, value);
	if (s->error == HARD)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where, "%s", text);
	if (s->message)
		ts_log(&sim->log, "%s\n", text);
	sim->clock.last_step = sim->clock.step;
	sim->run.halted = s->error == SOFT;
	return TS_OK;
}

static const char *const comparisons[] = {
	[LESS] = "<",	[LESS_EQUAL] = "<=", [MORE] = ">", [MORE_EQUAL] = ">=",
	[EQUAL] = "==", [NOT_EQUAL] = "!=",  [XOR] = "|^", NULL,
};
static const char *const errors[] = { "hard", "soft", "continue", NULL };

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "steps between checks"),
	TS_WORD("attribute", struct state, attribute, .flags = TS_POSITIONAL,
		.help = "v_NAME; bondmax: length of the longest bond; tlimit: wall time since the start of "
			"the run in seconds; diskfree: free disk space in megabytes"),
	TS_ENUM("comparison", struct state, comparison, comparisons, .flags = TS_POSITIONAL,
		.help = "comparison operator; |^: exactly one of the two is not 0"),
	TS_REAL("limit", struct state, limit, .flags = TS_POSITIONAL,
		.help = "value with which it is compared"),
	TS_ENUM("error", struct state, error, errors, .fallback = "soft",
		.help = "hard: stop with an error; soft: end this run and skip all later ones; continue: end "
			"this run"),
	TS_BOOL("message", struct state, message, .fallback = "yes",
		.help = "whether a message is printed (always with hard)"),
	TS_WORD("path", struct state, path, .fallback = ".",
		.help = "for diskfree: a file or folder on that disk"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_halt)
const struct ts_style ts_fix_halt = {
	.name = "halt",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = due,
	.summary = "Ends a run early when a condition is met",
	.doc = "Compares the attribute with the limit at the end of each step that is a multiple of N. If "
	       "the comparison holds, this step becomes the last of the run: its output is written and the "
	       "script continues. After a soft halt (the default) later `run` commands do nothing, so that a "
	       "script can write its state and end; `timer timeout reset` enables them again.",
	.example = "variable speed equal vcm(all,z)\n"
		   "fix calm all halt 100 v_speed > -1e-4 error continue\n"
		   "fix apart all halt 10 bondmax > 0.023",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook[TS_STAGE_END_OF_STEP] = end_of_step,
};
