#include "group/temperature.h"

#include "base/clones.h"
#include "core/units.h"

#include "base/banned.h"

struct motion {
	ts_peculiar_velocity *peculiar;
	const void *flow;
};

static void kinetic_tensor_terms(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct motion *m = context;
	double u[3];

	m->peculiar(sim, i, m->flow, u);
	for (int k = 0; k < 6; k++)
		term[k] = sim->particles->mass[i] * u[ts_tensor_row[k]] * u[ts_tensor_column[k]];
	term[6] = 1;
}

void ts_temperature_tensor_in(const struct tsim *sim, int group, ts_peculiar_velocity *peculiar,
			      const void *flow, double out[7])
{
	struct motion motion = { peculiar, flow };

	ts_group_sum(sim, group, 7, kinetic_tensor_terms, &motion, out);
}

/* For velocities less their mean, which the context is. */
TS_CLONES static void kinetic_tensor_less_mean(const struct tsim *sim, size_t from, size_t n,
					       const void *context, double (*term)[TS_TERM_BLOCK])
{
	const double(*v)[3] = (const double(*)[3])sim->particles->v + from, *m = sim->particles->mass + from;
	const double *mean = context;

	for (size_t i = 0; i < n; i++) {
		double x = v[i][0] - mean[0], y = v[i][1] - mean[1], z = v[i][2] - mean[2];

		term[0][i] = m[i] * x * x;
		term[1][i] = m[i] * y * y;
		term[2][i] = m[i] * z * z;
		term[3][i] = m[i] * x * y;
		term[4][i] = m[i] * x * z;
		term[5][i] = m[i] * y * z;
		term[6][i] = 1;
	}
}

void ts_temperature_tensor(const struct tsim *sim, int group, const double mean[3], double out[7])
{
	static const double zero[3] = { 0 };

	ts_group_sum_blocks(sim, group, 7, kinetic_tensor_less_mean, mean ? mean : zero, out);
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
