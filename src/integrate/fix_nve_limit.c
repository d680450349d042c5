/* Fix nve/limit: velocity Verlet with a limit of the displacement per step. */
#include "core/sim.h"

#include <math.h>

#include "base/parallel.h"
#include "math/vec3.h"
#include "particle/rank_sums.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { ABSOLUTE, RADIUS_RATIO };

struct state {
	struct ts_words words;
	int mode;
	double limit;
	int64_t limited; /* number of limited velocities since the fix was defined; saved */
	int64_t recent;	 /* those of this rank that are not in it yet, while the particles are divided */
};

struct task {
	const struct ts_instance *self;
	struct tsim *sim;
	bool moves;
};

/* Syntax of LAMMPS: xmax. LIGGGHTS: absolute xmax, or radius_ratio r. */
static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_word *word = s->words.word;
	size_t n = s->words.n;

	s->mode = n == 2 && ts_streq(word[0].text, "radius_ratio") ? RADIUS_RATIO : ABSOLUTE;
	if (n > 2 || (n == 2 && s->mode == ABSOLUTE && !ts_streq(word[0].text, "absolute")) ||
	    !ts_parse_real(word[n - 1].text, &s->limit) || !(s->limit > 0))
		return ts_fail(&sim->error, TS_SYNTAX, &word[n - 1].place,
			       "fix nve/limit: found '%s', expected a length > 0, or radius_ratio and a "
			       "number > 0",
			       word[n - 1].text);
	sim->run.clamped = true; /* diverging motion is limited, so limits of the step are warnings only */
	return TS_OK;
}

/* Kick, and drift on request; velocities that would move a particle by more than the limit in a step are
 * reduced to it. Returns their number. */
static long kick_and_drift_share(void *context, size_t from, size_t to)
{
	const struct task *task = context;
	const struct state *s = task->self->state;
	struct ts_particles *p = task->sim->particles;
	double dt = task->sim->clock.dt;
	long limited = 0;

	for (size_t i = from; i < to; i++) {
		double most = (s->mode == RADIUS_RATIO ? s->limit * p->radius[i] : s->limit) / dt;
		double speed;

		if (!ts_in_group(p, i, task->self->group))
			continue;
		for (int k = 0; k < 3; k++)
			p->v[i][k] += 0.5 * dt / p->mass[i] * p->f[i][k];
		speed = ts_norm(p->v[i]);
		if (speed > most) {
			limited++;
			ts_scale(most / speed, p->v[i], p->v[i]);
		}
		for (int k = 0; task->moves && k < 3; k++)
			p->x[i][k] += dt * p->v[i][k];
	}
	return limited;
}

static enum ts_status kick_and_drift(struct ts_instance *self, struct tsim *sim, bool moves)
{
	struct state *s = self->state;
	struct task task = { self, sim, moves };
	size_t n = sim->particles->n;

	*(sim->division ? &s->recent : &s->limited) +=
		ts_parallel_count(ts_team(sim, n), n, kick_and_drift_share, &task);
	return TS_OK;
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	return kick_and_drift(self, sim, true);
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	return kick_and_drift(self, sim, false);
}

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double recent = (double)s->recent, sum;

	TS_TRY(ts_rank_sums(sim, &recent, 1, 1, 1, &sum));
	s->limited += (int64_t)sum;
	s->recent = 0;
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = (double)((const struct state *)self->state)->limited;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("limit", struct state, words,
		.help = "largest displacement of a particle in a step: a length, `absolute` and a length, or "
			"`radius_ratio` and a fraction of its radius"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "limited", "", "number of limited velocities since the fix was defined", TS_SCALAR, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_SAVE_I64(struct state, limited), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_nve_limit)
const struct ts_style ts_fix_nve_limit = {
	.name = "nve/limit",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,
	.join = join,
	.summary = "velocity Verlet with a limited displacement per step",
	.doc = "As fix nve, but after each half kick a velocity that would move its particle by more than the limit in a step is reduced to it. The fix is for scenes that begin with overlaps; energy is not conserved while it acts.",
	.example = "fix part all nve/limit radius_ratio 0.01\nfix part all nve/limit 1e-4",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.integrates = TS_MOVES | TS_OBEYS,
	.hook = {
		[TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		[TS_STAGE_FINAL_INTEGRATE] = final_integrate,
	},
};
