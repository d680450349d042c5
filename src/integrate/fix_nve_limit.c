/* Fix nve/limit: velocity Verlet with a limit of the displacement per step. */
#include "core/sim.h"

#include <math.h>

#include "base/clones.h"
#include "core/deferred_loops.h"
#include "group/group_members.h"
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
	const struct ts_particles *p;
	int64_t *limited;
	double dt, ratio, absolute; /* the limit: ratio * radius, or absolute */
	int group;
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
 * reduced to it and counted. */
TS_CLONES static void kick_and_drift_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	double(*restrict x)[3] = t.p->x, (*restrict v)[3] = t.p->v, (*restrict f)[3] = t.p->f;
	bool all = ts_group_members(t.p, t.group, from, to) == to - from;
	int64_t limited = 0;

	for (size_t i = from; i < to; i++) {
		double kick = 0.5 * t.dt / t.p->mass[i];
		double most = (t.ratio > 0 ? t.ratio * t.p->radius[i] : t.absolute) / t.dt, speed;

		if (!all && !ts_in_group(t.p, i, t.group))
			continue;
		for (int k = 0; k < 3; k++)
			v[i][k] += kick * f[i][k];
		speed = ts_norm(v[i]);
		if (speed > most) {
			limited++;
			ts_scale(most / speed, v[i], v[i]);
		}
		for (int k = 0; t.moves && k < 3; k++)
			x[i][k] += t.dt * v[i][k];
	}
	if (!limited)
		return;
#pragma omp atomic
	*t.limited += limited;
}

static enum ts_status kick_and_drift(struct ts_instance *self, struct tsim *sim, bool moves)
{
	struct state *s = self->state;
	struct task task = { .p = sim->particles,
			     .limited = sim->division ? &s->recent : &s->limited,
			     .dt = sim->clock.dt,
			     .ratio = s->mode == RADIUS_RATIO ? s->limit : 0,
			     .absolute = s->limit,
			     .group = self->group,
			     .moves = moves };

	TS_DEFER_LOOP(sim, sim->particles->n, kick_and_drift_range, &task);
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
	.defers = TS_DEFERS(INITIAL_INTEGRATE) | TS_DEFERS(FINAL_INTEGRATE),
};
