#include "group/temperature.h"

#include "core/units.h"

#include "base/banned.h"

struct motion {
	ts_peculiar_velocity *peculiar;
	const void *flow;
	int group;
};

/* Kinetic tensor and number. */
static void kinetic_tensors(const struct tsim *sim, size_t from, size_t n, double (*u)[TS_TERM_BLOCK],
			    double (*term)[TS_TERM_BLOCK])
{
	ts_group_tensor_terms(sim->particles->mass + from, n, u, term);
	for (size_t i = 0; i < n; i++)
		term[6][i] = 1;
}

/* The flow may not be known where others than those of the group are. */
static void tensors_in_flow(const struct tsim *sim, size_t from, size_t n, const void *context,
			    double (*term)[TS_TERM_BLOCK])
{
	const struct motion *m = context;
	double u[3][TS_TERM_BLOCK], own[3] = { 0 };

	for (size_t i = 0; i < n; i++) {
		if (ts_in_group(sim->particles, from + i, m->group))
			m->peculiar(sim, from + i, m->flow, own);
		for (int d = 0; d < 3; d++)
			u[d][i] = own[d];
	}
	kinetic_tensors(sim, from, n, u, term);
}

void ts_temperature_tensor_in(const struct tsim *sim, int group, ts_peculiar_velocity *peculiar,
			      const void *flow, double out[7])
{
	struct motion motion = { peculiar, flow, group };

	ts_group_sum_blocks(sim, group, 7, tensors_in_flow, &motion, out);
}

/* For velocities less their mean, which the context is. */
static void tensors_less_mean(const struct tsim *sim, size_t from, size_t n, const void *context,
			      double (*term)[TS_TERM_BLOCK])
{
	const double(*v)[3] = (const double(*)[3])sim->particles->v + from, *mean = context;
	double u[3][TS_TERM_BLOCK];

	for (size_t i = 0; i < n; i++)
		for (int d = 0; d < 3; d++)
			u[d][i] = v[i][d] - mean[d];
	kinetic_tensors(sim, from, n, u, term);
}

void ts_temperature_tensor(const struct tsim *sim, int group, const double mean[3], double out[7])
{
	static const double zero[3] = { 0 };

	ts_group_sum_blocks(sim, group, 7, tensors_less_mean, mean ? mean : zero, out);
}

enum ts_status ts_temperature_write_tensor(const double tensor[7], struct ts_table *out)
{
	for (int k = 0; k < 6; k++)
		out->data[k] = tensor[k];
	return TS_OK;
}

enum ts_status ts_freedom_read(struct ts_freedom *freedom, struct tsim *sim, struct ts_words words,
			       size_t *used)
{
	bool extra = ts_streq(words.word[0].text, "extra");

	*used = 0;
	if (!extra && !ts_streq(words.word[0].text, "extra/dof"))
		return TS_OK;
	if (words.n < 2 || !ts_parse_real(words.word[1].text, &freedom->missing))
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[words.n > 1].place,
			       "compute_modify: %s takes the number of degrees of freedom that do not count",
			       words.word[0].text);
	freedom->given = true;
	*used = 2;
	return TS_OK;
}

enum ts_status ts_freedom_modify(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				 size_t *used)
{
	return ts_freedom_read(self->state, sim, words, used);
}

double ts_temperature_without(const struct tsim *sim, const double t[7], double missing)
{
	double freedom = sim->dimension * t[6] - missing;
	double twice_energy = t[0] + t[1] + (sim->dimension == 3 ? t[2] : 0);

	return freedom > 0 ? twice_energy / (freedom * ts_boltzmann(sim)) : 0;
}

double ts_temperature(const struct tsim *sim, const double tensor[7], const struct ts_freedom *f)
{
	return ts_temperature_without(sim, tensor, f && f->given ? f->missing : sim->dimension);
}
