/* Fix check/timestep/gran: compares the time step with the Rayleigh and Hertz times. */
#include "contact/limits.h"
#include "limits/step_check.h"

#include <math.h>

#include "neigh/neigh.h"

#include "base/banned.h"

enum { RAYLEIGH, HERTZ, SKIN };

struct state {
	struct ts_step_check check; /* first: ts_step_check_eval */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	return ts_step_check_init(self, sim, &s->check, 2, "fraction_r fraction_h");
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_step_check *c = &((struct state *)self->state)->check;
	bool legacy = c->legacy || sim->legacy == TS_LEGACY_LIGGGHTS;
	struct ts_granular_times times;
	double speed, dt = sim->clock.dt;

	if (!ts_step_check_is_due(c, sim))
		return TS_OK;
	speed = ts_step_check_speed(self, sim, c);
	TS_TRY(ts_granular_times(sim, self->group, speed, legacy, "fix check/timestep/gran", &self->where,
				 &times));
	if (legacy && isinf(times.hertz))
		times.hertz = 1e6;
	c->ratio[RAYLEIGH] = dt / times.rayleigh;
	c->ratio[HERTZ] = dt / times.hertz;
	c->ratio[SKIN] = speed * dt / ts_neigh_skin(sim);
	TS_TRY(ts_step_check_judge(self, sim, c, RAYLEIGH, "of Rayleigh's time", ""));
	TS_TRY(ts_step_check_judge(self, sim, c, HERTZ, "of the Hertz time", ""));
	return ts_step_check_judge_skin(self, sim, c, SKIN);
}

static const struct ts_arg args[] = {
	TS_LIST("when", struct state, check.words,
		.help = "number of steps between checks, or `check_every_time T`; then the largest allowed "
			"fractions of the Rayleigh time and the Hertz time"),
	TS_STEP_CHECK_ROWS(struct state, check),
	TS_ARGS_END,
};

static const char *const names[] = { "rayleigh", "hertz", "skin" };
static const struct ts_value values[] = {
	{ "ratios", "", "dt by the Rayleigh time, dt by the Hertz time, displacement per step by the skin",
	  TS_VECTOR, TS_STEP_RATIOS, names, ts_step_check_eval },
	{ .name = NULL },
};
static const struct ts_saved saved[] = { TS_SAVE_F64(struct state, check.ratio), TS_SAVED_ROWS_END };

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->check.every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_check_timestep_gran)
const struct ts_style ts_fix_check_timestep_gran = {
	.name = "check/timestep/gran",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = due,
	.summary = "compares the time step with the Rayleigh time and the duration of collisions",
	.doc = "Every N steps, of a number with a fraction its whole part, three ratios are computed. "
	       "f_ID[1] = dt/t_R, the smallest Rayleigh time t_R = "
	       "pi R sqrt(rho/G)/(0.1631 nu + 0.8766), G = Y/(2(1+nu)), of the particles of the group. "
	       "f_ID[2] = dt/t_H, the smallest Hertz time t_H = 2.87 (m*^2/(R* Y*^2 v))^(1/5) of all pairs "
	       "of these particles. f_ID[3] = v dt/skin. v is twice the largest speed in the group, or this "
	       "speed plus that of a mesh, whichever is larger. All ratios are 0 before the first check.\n\n"
	       "With `legacy yes` (or the command legacy) t_H is that of LIGGGHTS: each particle collides "
	       "with an equal one, but with its mass m instead of m* = m/2, so that t_H is 1.32 times as "
	       "long; it is 1e6 where all particles are at rest. f_ID[3] > 1 is reported as well; in tsim it "
	       "has little meaning, since no contact is missed whatever the skin.\n\n"
	       "The plan of a run (tsim -explain) reports these times, too, and the limits of stability "
	       "themselves.",
	.example = "fix ts all check/timestep/gran 1000 0.1 0.1\nthermo_style custom step f_ts[1] f_ts[2]",
	.cite = "C. O'Sullivan, J. D. Bray, Eng. Comput. 21 (2004) 278",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_END_OF_STEP] = end_of_step },
};
