/* Compute pressure: pressure of the whole system. */
#include "contact/contact_view.h"
#include "contact/virial.h"
#include "group/temperature.h"

#include <string.h>

#include "base/banned.h"

struct pressure {
	const char *temperature;
	struct ts_words words;
	struct ts_virial_parts parts;
	struct ts_table kinetic;
	double virial[6]; /* with ranks: that of all of them, of the step `joined` */
	int64_t joined;
	struct tsim *sim;
};

/* The compute that gives the kinetic part of the tensor; NULL: that of all particles. */
static const struct ts_value *kinetic_of(const struct pressure *s, struct ts_instance **inst)
{
	const struct ts_value *value;

	*inst = ts_sim_find(s->sim, TS_KIND_COMPUTE, s->temperature);
	value = *inst && strncmp((*inst)->style->name, "temp", 4) == 0 ? ts_value_find(*inst, TS_VECTOR)
								       : NULL;
	return value && value->columns == 6 ? value : NULL;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct pressure *s = self->state;
	struct ts_instance *inst;

	s->sim = sim;
	sim->neigh->keep_forces = true;
	if (self->group != 0)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "compute pressure is that of all particles: its group must be all");
	TS_TRY(ts_virial_read_parts(sim, self, s->words, &s->parts));
	if (ts_streq(s->temperature, "NULL") && s->parts.kinetic)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "compute pressure: without a temperature (NULL) the part ke cannot be "
			       "included; use `virial`");
	if (ts_streq(s->temperature, "NULL") || ts_streq(s->temperature, "thermo_temp") ||
	    kinetic_of(s, &inst))
		return TS_OK;
	return ts_fail(&sim->error, TS_UNKNOWN, &self->where,
		       "compute pressure: '%s' is not a temperature compute; thermo_temp is that of all "
		       "particles",
		       s->temperature);
}

static enum ts_status add_kinetic(struct pressure *s, double out[6])
{
	struct ts_instance *inst;
	const struct ts_value *value = kinetic_of(s, &inst);
	double sum[7];

	if (value)
		TS_TRY(ts_value_eval(inst, s->sim, value, &s->kinetic));
	else
		ts_temperature_tensor(s->sim, 0, NULL, sum);
	for (int k = 0; k < 6; k++)
		out[k] += value ? s->kinetic.data[k] : sum[k];
	return TS_OK;
}

static enum ts_status pressure_tensor(struct ts_instance *self, double out[6])
{
	struct pressure *s = self->state;
	struct tsim *sim = s->sim;
	double volume = ts_virial_box_volume(sim);

	TS_TRY(ts_virial_now(sim, self, &s->parts, s->virial, s->joined, out));
	if (s->parts.kinetic)
		TS_TRY(add_kinetic(s, out));
	for (int k = 0; k < 6; k++)
		out[k] /= volume;
	return TS_OK;
}

static enum ts_status eval_pressure(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double t[6];

	TS_TRY(pressure_tensor(self, t));
	out->data[0] = ts_virial_mean_pressure(sim, t);
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	return pressure_tensor(self, out->data);
}

static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct pressure *s = self->state;

	return ts_virial_join(sim, self, &s->parts, s->virial, &s->joined);
}

static void fini(struct ts_instance *self)
{
	ts_table_release(&((struct pressure *)self->state)->kinetic);
}

static const struct ts_value values[] = {
	{ "pressure", "pressure", "mean of the diagonal of the tensor", TS_SCALAR, 1, NULL, eval_pressure },
	{ "tensor", "pressure", "pressure tensor", TS_VECTOR, 6, ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("temperature", struct pressure, temperature, .flags = TS_POSITIONAL,
		.help = "ID of a compute temp, thermo_temp for all particles, or NULL"),
	TS_REST_OPTIONAL("parts", struct pressure, words,
			 .help = "ke, pair, bond, fix, virial (all but ke); none: all"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_pressure)
const struct ts_style ts_compute_pressure = {
	.name = "pressure",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.join = join,
	.summary = "Pressure of the whole system",
	.doc = "P_ab = (sum m v_a v_b + sum d_a F_b) / V, the first sum over all particles, the second over "
	       "all contacts and bonds, each once; d is the vector between the two particles and F the force "
	       "on the first, for ab = xx, yy, zz, xy, xz, yz. The scalar is the mean of xx, yy and zz (of "
	       "xx and yy in two dimensions). V is the volume of the box, in two dimensions its area. Forces "
	       "of walls and other fixes are not included, nor are the constraint forces of rigid bodies. "
	       "Sums are rounded once.",
	.example = "compute p all pressure thermo_temp\ncompute contact all pressure NULL virial",
	.args = args,
	.state_size = sizeof(struct pressure),
	.values = values,
	.init = init,
	.fini = fini,
};
