#include "limits/step_check.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "mesh/mesh_surface.h"
#include "particle/prescribed.h"

#include "base/banned.h"

static enum ts_status fail_expected(const struct ts_instance *self, struct tsim *sim, struct ts_words words,
				    size_t k, const char *names)
{
	const struct ts_word *word = &words.word[k < words.n ? k : words.n - 1];

	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "fix %s: found '%s', expected N %s or check_every_time T %s", self->style->name,
		       word->text, names, names);
}

enum ts_status ts_step_check_init(const struct ts_instance *self, struct tsim *sim, struct ts_step_check *c,
				  size_t n, const char *names)
{
	struct ts_words w = c->words;
	size_t at = ts_streq(w.word[0].text, "check_every_time") ? 1 : 0;

	c->interval = NAN;
	if (w.n != at + 1 + n)
		return fail_expected(self, sim, w, at + 1 + n, names);
	if (at ? !ts_parse_real(w.word[1].text, &c->interval) || !(c->interval > 0)
	       : !ts_arg_whole_part(self, sim, "N", w.word[0].text, &c->every) || c->every < 1)
		return fail_expected(self, sim, w, at, names);
	if (at) /* a whole number of steps, at least one, as in LIGGGHTS */
		c->every = (int64_t)fmax(1, floor(c->interval / sim->clock.dt));
	for (size_t k = 0; k < n; k++)
		if (!ts_parse_real(w.word[at + 1 + k].text, &c->fraction[k]) || !(c->fraction[k] > 0))
			return fail_expected(self, sim, w, at + 1 + k, names);
	return TS_OK;
}

bool ts_step_check_is_due(const struct ts_step_check *c, const struct tsim *sim)
{
	return sim->clock.step % c->every == 0;
}

/* Largest speed of the nodes of all meshes, as in LIGGGHTS without those that stay in place while their surface moves. */
static double largest_mesh_speed(const struct tsim *sim, bool legacy)
{
	const struct ts_mesh_surface *s;
	double most = 0;

	for (size_t k = 0; (s = ts_mesh_surface_next(sim, &k, NULL));)
		for (size_t t = 0; s->v && (s->home || !legacy) && t < s->mesh.n; t++)
			for (int c = 0; c < 3; c++)
				most = fmax(most, ts_norm(s->v[t][c]));
	return most;
}

double ts_step_check_speed(const struct ts_instance *self, const struct tsim *sim,
			   const struct ts_step_check *c)
{
	double v = fmax(ts_prescribed_max_speed(sim, self->group), c->vmax);

	return fmax(2 * v, v + largest_mesh_speed(sim, c->legacy || sim->legacy == TS_LEGACY_LIGGGHTS));
}

/* Whether a warning is to be given. */
static bool has_grown(struct ts_step_check *c, int which)
{
	if (!c->warn || !(c->ratio[which] > 1.1 * c->warned[which]))
		return false;
	c->warned[which] = c->ratio[which];
	return true;
}

#define STEP "fix %s: the time step is %.4g %% %s at step %" PRId64 ", more than %.4g %%%s"

enum ts_status ts_step_check_judge(const struct ts_instance *self, struct tsim *sim, struct ts_step_check *c,
				   int which, const char *of, const char *more)
{
	double percent = 100 * c->ratio[which], most = 100 * c->fraction[which];

	if (!(c->ratio[which] > c->fraction[which]))
		return TS_OK;
	if (c->error)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where, STEP, self->style->name, percent, of,
			       sim->clock.step, most, more);
	if (has_grown(c, which))
		ts_warn(&sim->log, &self->where, STEP, self->style->name, percent, of, sim->clock.step, most,
			more);
	return TS_OK;
}

enum ts_status ts_step_check_judge_skin(const struct ts_instance *self, struct tsim *sim,
					struct ts_step_check *c, int which)
{
	if (!(c->legacy || sim->legacy == TS_LEGACY_LIGGGHTS) || !(c->ratio[which] > 1))
		return TS_OK;
	if (c->error)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix %s: particles may come %g of the skin nearer in a step",
			       self->style->name, c->ratio[which]);
	if (has_grown(c, which))
		ts_warn(&sim->log, &self->where,
			"fix %s: particles may come %g of the skin nearer in a step: the neighbour list is "
			"rebuilt all the time",
			self->style->name, c->ratio[which]);
	return TS_OK;
}

enum ts_status ts_step_check_eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_step_check *c = self->state;

	(void)sim;
	memcpy(out->data, c->ratio, sizeof c->ratio);
	return TS_OK;
}
