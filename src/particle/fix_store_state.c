/* Fix store/state: stores per-particle quantities at a given time. */
#include "core/ref_list.h"

#include "core/sim.h"
#include "core/unclaimed_state.h"
#include "group/group_motion.h"
#include "particle/columns.h"

#include "base/banned.h"

struct state {
	int64_t every;
	struct ts_words words;
	bool com;
	struct ts_ref_list input;
	struct ts_table now;
	size_t column;
	bool started;
};

static double *stored_row(const struct state *s, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[s->column].data + s->input.n * i;
}

/* Dimension of the names xu, yu, zu; -1 for others. */
static int unwrapped_dim(const char *name)
{
	static const char *const names[] = { "xu", "yu", "zu" };

	for (int k = 0; k < 3; k++)
		if (ts_streq(name, names[k]))
			return k;
	return -1;
}

static enum ts_status store_inputs(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;
	double centre[3];

	ts_group_centre(sim, self->group, centre);
	for (size_t k = 0; k < s->input.n; k++) {
		const struct ts_ref_input *input = &s->input.item[k];
		int dim = s->com && input->quantity ? unwrapped_dim(input->name) : -1;
		double origin = dim >= 0 ? centre[dim] : 0;

		TS_TRY(ts_ref_input_eval(sim, input, &s->now));
		for (size_t i = 0; i < p->n; i++)
			stored_row(s, sim, i)[k] =
				ts_in_group(p, i, self->group) ? s->now.data[i] - origin : 0;
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	TS_TRY(ts_ref_list_init(sim, "fix store/state", &self->arena, s->words, TS_WANT(PERATOM), &s->input));
	if (s->started)
		return TS_OK;
	ts_str_addf(&name, "fix store/state %s of %zu", self->id, s->input.n);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), s->input.n, TS_COL_RESULT,
						       &s->column);
	ts_str_release(&name);
	TS_TRY(status);
	s->started = true;
	return ts_unclaimed_exists(sim, self) ? TS_OK : store_inputs(self, sim);
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return s->every > 0 && sim->clock.step % s->every == 0;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	return due(self, sim) ? store_inputs(self, sim) : TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct state *s = self->state;

	return ts_particles_archive_column(a, sim, "stored", s->column);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = s->input.n;

	TS_TRY(ts_table_resize(out, sim->particles->n, n));
	for (size_t i = 0; i < sim->particles->n; i++)
		for (size_t k = 0; k < n; k++)
			out->data[i * n + k] = stored_row(s, sim, i)[k];
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_table_release(&s->now);
	ts_ref_list_release(&s->input);
}

static const struct ts_arg args[] = {
	TS_INT("N", struct state, every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_NOT_NEGATIVE,
	       .help = "steps between updates; 0: only when the fix is defined"),
	TS_LIST_STATEFUL("inputs", struct state, words,
			 .help = "id, x, xu, vx, radius ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or "
				 "v_NAME"),
	TS_BOOL("com", struct state, com, .flags = TS_STATEFUL, .fallback = "no",
		.help = "subtract the centre of mass of the group from xu, yu, zu"),
	TS_ARGS_END,
};

static size_t width(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->input.n;
}

static const struct ts_value values[] = {
	{ .name = "stored",
	  .unit = "",
	  .help = "the stored inputs, one column each; 0 for particles outside the group and for those "
		  "inserted later",
	  .shape = TS_PERATOM,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_store_state)
const struct ts_style ts_fix_store_state = {
	.name = "store/state",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "Stores per-particle quantities",
	.doc = "Stores the inputs of the particles in the group when the fix is defined and, unless N is 0, "
	       "at the end of each step that is a multiple of N. The values move with the particles and are "
	       "written to restart files.",
	.example = "fix before all store/state 0 xu yu zu com yes\n"
		   "variable gone atom sqrt((xu-f_before[1])^2+(yu-f_before[2])^2)",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.width = width,
	.init = init,
	.hook[TS_STAGE_END_OF_STEP] = end_of_step,
	.fini = fini,
};
