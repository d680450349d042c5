#include "insert/insertion_rate.h"

#include <math.h>

#include "core/ranks.h"

#include "base/banned.h"

/* A number such as 1e5 as well, or with a fraction, of which the whole part is taken, as in LIGGGHTS. */
static bool read_number(struct ts_instance *self, struct tsim *sim, const char *word, int64_t *total)
{
	double number;

	if (!ts_parse_real(word, &number) || !(number >= 1 && number < 1e15))
		return false;
	*total = (int64_t)number;
	if (number != floor(number))
		ts_warn(&sim->log, ts_instance_word(self, word),
			"fix %s: nparticles is %s, no integer: %lld is taken, as in LIGGGHTS",
			self->style->name, word, (long long)*total);
	return true;
}

static enum ts_status read_total(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate)
{
	const struct ts_distribution *d = ((struct ts_insertion *)self->state)->distribution->state;
	const char *word = rate->number_word ? rate->number_word : rate->mass_word;
	double mass;

	rate->total = -1;
	rate->total_mass = INFINITY;
	if (ts_streq(word, "INF"))
		return TS_OK;
	if (rate->number_word && read_number(self, sim, word, &rate->total))
		return TS_OK;
	if (rate->mass_word && ts_parse_real(word, &mass) && mass > 0 && mass < 1e15 * d->mass) {
		rate->total = (int64_t)(mass / d->mass);
		rate->total_mass = mass;
		return TS_OK;
	}
	return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, word),
		       "fix %s: %s is '%s', expected a number %s, or INF", self->style->name,
		       rate->number_word ? "nparticles" : "mass", word, rate->number_word ? ">= 1" : "> 0");
}

enum ts_status ts_insertion_rate_init(struct ts_instance *self, struct tsim *sim,
				      struct ts_insertion_rate *rate)
{
	const struct ts_distribution *d = ((struct ts_insertion *)self->state)->distribution->state;

	if (!rate->number_word == !rate->mass_word)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: expected one of nparticles and mass", self->style->name);
	if (isnan(rate->particlerate) == isnan(rate->massrate))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: expected one of particlerate and massrate", self->style->name);
	rate->rate = isnan(rate->massrate) ? rate->particlerate : rate->massrate / d->mass;
	return read_total(self, sim, rate);
}

static double per_event(const struct ts_insertion *s, const struct tsim *sim,
			const struct ts_insertion_rate *rate)
{
	return rate->rate * (double)s->every * sim->clock.dt;
}

void ts_insertion_rate_print(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate)
{
	const struct ts_insertion *s = self->state;
	const struct ts_distribution *d = s->distribution->state;
	double each = per_event(s, sim, rate), total = (double)rate->total;

	if (rate->told)
		return;
	rate->told = true;
	ts_log(&sim->log,
	       "INFO: Particle insertion %s: %f particles every %lld steps - particle rate %f, (mass rate "
	       "%e)\n",
	       self->id, each, (long long)s->every, rate->rate, rate->rate * d->mass);
	if (rate->total >= 0)
		ts_log(&sim->log, "      %lld particles (mass %e) within %.0f steps\n",
		       (long long)rate->total, total * d->mass, floor(total / each) * (double)s->every);
}

int64_t ts_insertion_rate_count(struct ts_instance *self, struct tsim *sim, struct ts_insertion_rate *rate)
{
	struct ts_insertion *s = self->state;
	double n = floor(per_event(s, sim, rate) + ts_minstd_uniform(&s->random));
	int64_t left = rate->total < 0 ? INT32_MAX : rate->total - s->inserted;

	if (n == 0 && !s->warned) {
		s->warned = true;
		if (ts_ranks_first(sim))
			ts_warn(&sim->log, &self->where,
				"fix %s %s: no particle is due in the event of step %lld, for the rate gives "
				"%g in "
				"%lld steps; a larger interval draws less often (said once)",
				self->style->name, self->id, (long long)sim->clock.step,
				per_event(s, sim, rate), (long long)s->every);
	}
	return n < (double)left ? (int64_t)n : left;
}

void ts_insertion_rate_next(struct ts_instance *self, const struct ts_insertion_rate *rate)
{
	struct ts_insertion *s = self->state;

	ts_insertion_next(self);
	if (rate->total >= 0 && s->inserted >= rate->total)
		s->wait = 0;
}
