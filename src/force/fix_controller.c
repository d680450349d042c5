/* Fix controller: a PID controller that changes a variable. */
#include "core/ref_list.h"
#include "core/sim.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int64_t every;
	double alpha, proportional, integral, derivative, setpoint;
	const char *process, *control;
	struct ts_ref_input input;

	/* saved */
	int64_t started;
	double term[3]; /* proportional, integral and derivative part of the last change */
	double error, sum, value;
};

static enum ts_status set_control_variable(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->script_api->set(sim->script_api_data, s->control, &self->where, s->value);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->input.name = s->process;
	s->input.where = self->where;
	TS_TRY(ts_ref_input_resolve(sim, "fix controller", TS_WANT(SCALAR), &s->input));
	if (strncmp(s->process, "c_", 2) && strncmp(s->process, "f_", 2) && strncmp(s->process, "v_", 2))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix controller: found '%s', expected c_ID, c_ID[k], f_ID, f_ID[k] or v_NAME",
			       s->process);
	if (!s->started) /* else perhaps continued from a restart file */
		TS_TRY(sim->script_api->scalar(sim->script_api_data, s->control, &self->where, &s->value));
	return set_control_variable(self, sim);
}

static enum ts_status update_control(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double tau = (double)s->every * sim->clock.dt, value, error;

	if (sim->clock.step % s->every != 0)
		return TS_OK;
	TS_TRY(ts_ref_input_scalar(sim, &s->input, &value));
	error = value - s->setpoint;
	s->sum += s->started ? error : 0;
	s->term[0] = -s->alpha * tau * s->proportional * error;
	s->term[1] = -s->alpha * tau * s->integral * tau * s->sum;
	s->term[2] = s->started ? -s->alpha * s->derivative * (error - s->error) : 0;
	s->value += s->term[0] + s->term[1] + s->term[2];
	s->error = error;
	s->started = 1;
	return set_control_variable(self, sim);
}

static enum ts_status eval_value(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = ((const struct state *)self->state)->value;
	return TS_OK;
}

static enum ts_status eval_terms(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	for (int k = 0; k < 3; k++)
		out->data[k] = ((const struct state *)self->state)->term[k];
	return TS_OK;
}

#define CONSTANT(name_, field, help_) \
	TS_REAL(name_, struct state, field, .flags = TS_POSITIONAL, .help = help_)
static const struct ts_arg args[] = {
	TS_INT("Nevery", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN,
	       .lo = 1, .hi = 1e15, .help = "number of time steps between changes"),
	CONSTANT("alpha", alpha, "common factor of all changes"),
	CONSTANT("Kp", proportional, "gain of the proportional term"),
	CONSTANT("Ki", integral, "gain of the integral term"),
	CONSTANT("Kd", derivative, "gain of the derivative term"),
	TS_WORD("pvar", struct state, process, .flags = TS_POSITIONAL | TS_STATEFUL,
		.help = "process variable: c_ID, c_ID[k], f_ID, f_ID[k] or v_NAME"),
	CONSTANT("setpoint", setpoint, "desired value of the process variable"),
	TS_WORD("cvar", struct state, control, .flags = TS_POSITIONAL | TS_STATEFUL,
		.help = "name of the control variable, an internal-style variable"),
	TS_ARGS_END,
};

static const char *const terms[] = { "P", "I", "D" };
static const struct ts_value values[] = {
	{ "control", "", "value of the control variable", TS_SCALAR, 1, NULL, eval_value },
	{ "terms", "", "proportional, integral and derivative part of the last change", TS_VECTOR, 3, terms,
	  eval_terms },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, started), TS_SAVE_F64(struct state, term),
	TS_SAVE_F64(struct state, error),   TS_SAVE_F64(struct state, sum),
	TS_SAVE_F64(struct state, value),   TS_SAVED_ROWS_END,
};

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	return sim->clock.step % ((const struct state *)self->state)->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_controller)
const struct ts_style ts_fix_controller = {
	.name = "controller",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.due = is_due,
	.summary = "PID controller: changes a variable so that a quantity approaches a setpoint",
	.doc = "At the end of each time step that is a multiple of Nevery the control variable c, the "
	       "internal-style variable cvar, is changed by\n\n"
	       "    c += -Kp alpha tau e - Ki alpha tau^2 (e2 + e3 + ... + e) - Kd alpha (e - e_previous)\n\n"
	       "where e is the deviation of the process variable pvar from the setpoint, e1, e2 ... its "
	       "earlier values from the first on, and tau = Nevery times the time step. The state of the "
	       "controller is saved in restart files.",
	.example = "variable push internal 0.0\n"
		   "fix speed all controller 10 1.0 0.5 0.0 0.1 c_fast[1] 2.385 push\n"
		   "fix pull all addforce v_push 0 0",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook[TS_STAGE_END_OF_STEP] = update_control,
};
