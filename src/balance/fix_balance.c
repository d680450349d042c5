/* Fix balance: changes the blocks of ranks during runs. */
#include "balance/rank_balance.h"
#include "core/report.h"
#include "io/textfile.h"
#include "particle/columns.h"

#include <stdio.h>

#include "base/banned.h"

struct state {
	struct ts_rank_balance balance;
	int64_t every;
	int64_t done; /* step of the last attempt; saved, since it says when properties get their weights */
	bool read;
	struct ts_balance_result last;
	struct ts_textfile file;
};

/* Values of variables are kept from the steps in which all ranks have all particles to the next rebuild. */
static enum ts_status add_column(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	static const double one = 1;
	char name[300];

	if (!ts_weights_have_variables(&s->balance.weights))
		return TS_OK;
	snprintf(name, sizeof name, "balance_%s", self->id);
	TS_TRY(ts_particles_add_column(sim, name, 1, TS_COL_RESULT, &s->balance.weights.column));
	return ts_particles_column_initial(sim, s->balance.weights.column, &one);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->balance.what = "fix balance";
	if (!s->read)
		TS_TRY(ts_balance_read(&s->balance, sim, &self->where));
	if (!s->read)
		TS_TRY(add_column(self, sim));
	s->read = true;
	return TS_OK;
}

static enum ts_status write_file(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_rank_blocks *blocks;

	if (!s->balance.file)
		return TS_OK;
	if (!ts_textfile_is_open(&s->file))
		TS_TRY(ts_textfile_open(&s->file, sim, &self->where, s->balance.file, false));
	TS_TRY(ts_balance_blocks(&s->balance, sim, &blocks));
	return ts_balance_write(&s->file, sim, blocks);
}

static enum ts_status apply(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->done = sim->clock.step;
	TS_TRY(ts_balance_apply(&s->balance, sim, &self->where, &s->last));
	return s->last.iterations || s->last.after != s->last.before ? write_file(self, sim) : TS_OK;
}

static bool has_variables(const struct ts_instance *self)
{
	return ts_weights_have_variables(&((const struct state *)self->state)->balance.weights);
}

static enum ts_status evaluate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return ts_weights_evaluate(&s->balance.weights, sim,
				   sim->particles->column[s->balance.weights.column].data);
}

/* The blocks of a new run; all ranks have all particles. */
static enum ts_status set_up(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_weights_check(&s->balance.weights, sim));
	if (has_variables(self))
		TS_TRY(evaluate(self, sim));
	s->balance.weights.counted = sim->run.force_ticks; /* of all particles on each rank */
	return sim->run.resuming ? TS_OK : apply(self, sim);
}

/* -explain -ranks: the blocks that a run would begin with. There are no measured times. */
static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return sim->reading.ranks && !report->limits_only ? set_up(self, sim) : TS_OK;
}

/* Steps with a number that is a multiple of Nfreq. */
static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return has_variables(self) && (!s->every || sim->clock.step % s->every == 0);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	return due(self, sim) ? evaluate(self, sim) : TS_OK;
}

/* The first rebuild since the last multiple of Nfreq: particles change their ranks in it anyway. */
static enum ts_status rebuild(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	bool now = !s->every || sim->clock.step / s->every > s->done / s->every;

	return now ? apply(self, sim) : TS_OK;
}

static enum ts_status close_file(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	return ts_textfile_close(&((struct state *)self->state)->file);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	(void)ts_textfile_close(&s->file);
	ts_balance_release(&s->balance);
}

static enum ts_status eval_imbalance(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = s->last.after > 0 ? s->last.after : 1;
	return TS_OK;
}

static enum ts_status eval_last(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = s->last.most;
	out->data[1] = s->last.iterations;
	out->data[2] = s->last.before > 0 ? s->last.before : 1;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("Nfreq", struct state, every, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "interval of steps; 0: in each rebuild of the neighbor list"),
	TS_REAL("threshold", struct state, balance.threshold, .flags = TS_POSITIONAL,
		.range = TS_NOT_NEGATIVE,
		.help = "imbalance above which the blocks are changed; less than 1: always"),
	TS_SOME_KEYWORD("shift", struct state, balance.shift, 0, .least = 3,
			.help = "the dimensions, such as xz, along which cuts are moved, the largest number "
				"of "
				"bisections for each, and the imbalance at which to stop"),
	TS_FLAG("rcb", struct state, balance.rcb, .help = "recursive bisection"),
	TS_SOME_KEYWORD("weight", struct state, balance.weight, TS_REPEAT, .least = 2,
			.help = "as of the command `balance`"),
	TS_WORD("out", struct state, balance.file, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file for the corners of the blocks after each change"),
	TS_ARGS_END,
};

static const char *const last_names[] = { "most", "iterations", "before" };

static const struct ts_value values[] = {
	{ "imbalance", "",
	  "the imbalance after the last attempt: the largest load of a rank divided by the mean", TS_SCALAR,
	  1, NULL, eval_imbalance },
	{ "last", "",
	  "of the last attempt: the largest load of a rank, the number of iterations (0: the blocks were not "
	  "changed), "
	  "and the imbalance before",
	  TS_VECTOR, 3, last_names, eval_last },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, done),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_balance)
const struct ts_style ts_fix_balance = {
	.name = "balance",
	.kind = TS_KIND_FIX,
	.summary = "Changes the blocks of space that ranks have during runs",
	.doc = "With several ranks (mpirun) each of them has the particles of a block of the box. When a run "
	       "begins, and after each "
	       "Nfreq steps, the imbalance is computed, and if it is larger than the threshold the blocks "
	       "are changed "
	       "as the command `balance` does: `shift`, `rcb`, `weight` and `out` are described there. "
	       "Particles change their ranks in "
	       "the next rebuild of the neighbor list. LAMMPS rebuilds the list for this; tsim does not, "
	       "because particles change their ranks in rebuilds only, and because results do not depend on "
	       "the number of ranks or "
	       "on their blocks, to the last bit.\n\n"
	       "`weight time` takes the time that each rank has needed for forces since the last attempt, "
	       "`weight var` values of "
	       "the last step whose number is a multiple of Nfreq: all ranks get all particles then, which "
	       "costs about two steps.\n\n"
	       "Without this fix tsim cuts the box again when a rank has 20 % more particles than after the "
	       "last cut "
	       "(doc/ranks.md). Once this fix has changed the blocks, only it does so. Its group has no "
	       "effect. With one rank the "
	       "imbalance is 1.",
	.example = "fix share all balance 1000 1.1 shift xy 10 1.1\n"
		   "fix share all balance 500 1.05 rcb weight time 1.0",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.ranks = TS_RANKS_OWN | TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_OUTPUTS,
	.due = due,
	.init = init,
	.plan = plan,
	.hook = { [TS_STAGE_PRE_EXCHANGE] = rebuild,
		  [TS_STAGE_END_OF_STEP] = end_of_step,
		  [TS_STAGE_SETUP] = set_up },
	.values = values,
	.close = close_file,
	.fini = fini,
};
