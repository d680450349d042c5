/* Fix check/timestep/gran: compares the time step with the Rayleigh and Hertz times. */
#include "contact/limits.h"

#include <inttypes.h>
#include <math.h>

#include "mesh/mesh_surface.h"
#include "neigh/neigh.h"
#include "particle/prescribed.h"

#include "base/banned.h"

enum { RAYLEIGH, HERTZ, SKIN, NRATIOS };

struct state {
	struct ts_words words; /* N or check_every_time T, then fraction_r and fraction_h */
	bool warn, error, legacy;
	double vmax;
	double fraction[2], interval; /* interval between checks, time; NaN: given in steps */
	int64_t every;
	double ratio[NRATIOS]; /* ratios of the last check; saved */
	double warned[NRATIOS];
};

static enum ts_status fail_expected(struct tsim *sim, struct ts_words words, size_t k)
{
	const struct ts_word *word = &words.word[k < words.n ? k : words.n - 1];

	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "fix check/timestep/gran: found '%s', expected N fraction_r fraction_h or "
		       "check_every_time T fraction_r fraction_h",
		       word->text);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_words w = s->words;
	size_t at = ts_streq(w.word[0].text, "check_every_time") ? 1 : 0;

	s->interval = NAN;
	if (w.n != at + 3)
		return fail_expected(sim, w, at + 3);
	if (at ? !ts_parse_real(w.word[1].text, &s->interval) || !(s->interval > 0)
	       : !ts_parse_int(w.word[0].text, &s->every) || s->every < 1)
		return fail_expected(sim, w, at);
	if (at) /* a whole number of steps, at least one, as in LIGGGHTS */
		s->every = (int64_t)fmax(1, floor(s->interval / sim->clock.dt));
	for (size_t k = 0; k < 2; k++)
		if (!ts_parse_real(w.word[at + 1 + k].text, &s->fraction[k]) || !(s->fraction[k] > 0))
			return fail_expected(sim, w, at + 1 + k);
	return TS_OK;
}

/* Largest speed of the nodes of all meshes. */
static double largest_mesh_speed(const struct tsim *sim)
{
	const struct ts_mesh_surface *s;
	double most = 0;

	for (size_t k = 0; (s = ts_mesh_surface_next(sim, &k, NULL));)
		for (size_t t = 0; s->v && t < s->mesh.n; t++)
			for (int c = 0; c < 3; c++)
				most = fmax(most, ts_norm(s->v[t][c]));
	return most;
}

static enum ts_status report_ratio(struct ts_instance *self, struct tsim *sim, int which, double limit)
{
	static const char *const of[] = { "of Rayleigh's time", "of the Hertz time" };
	struct state *s = self->state;
	double percent = 100 * s->ratio[which];

	if (which == SKIN && s->error)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix %s: particles may come %g of the skin nearer in a step",
			       self->style->name, s->ratio[which]);
	if (s->error)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix %s: the time step is %.4g %% %s at step %" PRId64 ", more than %.4g %%",
			       self->style->name, percent, of[which], sim->clock.step, 100 * limit);
	/* repeats a warning only if the ratio has grown */
	if (!s->warn || !(s->ratio[which] > 1.1 * s->warned[which]))
		return TS_OK;
	s->warned[which] = s->ratio[which];
	if (which == SKIN)
		ts_warn(&sim->log, &self->where,
			"fix %s: particles may come %g of the skin nearer in a step: the neighbour list is "
			"rebuilt all the time",
			self->style->name, s->ratio[which]);
	else
		ts_warn(&sim->log, &self->where,
			"fix %s: the time step is %.4g %% %s at step %" PRId64 ", more than %.4g %%",
			self->style->name, percent, of[which], sim->clock.step, 100 * limit);
	return TS_OK;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool legacy = s->legacy || sim->legacy;
	struct ts_granular_times times;
	double v, speed, dt = sim->clock.dt;

	if (sim->clock.step % s->every)
		return TS_OK;
	v = fmax(ts_prescribed_max_speed(sim, self->group), s->vmax);
	speed = fmax(2 * v, v + largest_mesh_speed(sim));
	TS_TRY(ts_granular_times(sim, self->group, speed, legacy, "fix check/timestep/gran", &self->where,
				 &times));
	if (legacy && isinf(times.hertz))
		times.hertz = 1e6;
	s->ratio[RAYLEIGH] = dt / times.rayleigh;
	s->ratio[HERTZ] = dt / times.hertz;
	s->ratio[SKIN] = speed * dt / ts_neigh_skin(sim);
	for (int k = 0; k < 2; k++)
		if (s->ratio[k] > s->fraction[k])
			TS_TRY(report_ratio(self, sim, k, s->fraction[k]));
	return s->ratio[SKIN] > 1 && legacy ? report_ratio(self, sim, SKIN, 1) : TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	for (int k = 0; k < NRATIOS; k++)
		out->data[k] = ((const struct state *)self->state)->ratio[k];
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_LIST("when", struct state, words,
		.help = "number of steps between checks, or `check_every_time T`; then the largest allowed "
			"fractions of the Rayleigh time and the Hertz time"),
	TS_BOOL("warn", struct state, warn, .fallback = "yes", .help = "warn if a fraction is exceeded"),
	TS_BOOL("error", struct state, error, .fallback = "no",
		.help = "end the run if a fraction is exceeded"),
	TS_REAL("vmax", struct state, vmax, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "velocity",
		.help = "lower bound of the particle speed"),
	TS_BOOL("legacy", struct state, legacy, .fallback = "no",
		.help = "compute the times as LIGGGHTS does, see below"),
	TS_ARGS_END,
};

static const char *const names[] = { "rayleigh", "hertz", "skin" };
static const struct ts_value values[] = {
	{ "ratios", "", "dt by the Rayleigh time, dt by the Hertz time, displacement per step by the skin",
	  TS_VECTOR, NRATIOS, names, eval },
	{ .name = NULL },
};
static const struct ts_saved saved[] = { TS_SAVE_F64(struct state, ratio), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_check_timestep_gran)
const struct ts_style ts_fix_check_timestep_gran = {
	.name = "check/timestep/gran",
	.kind = TS_KIND_FIX,
	.summary = "compares the time step with the Rayleigh time and the duration of collisions",
	.doc = "Every N steps three ratios are computed. f_ID[1] = dt/t_R, the smallest Rayleigh time t_R = "
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
