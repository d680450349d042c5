#include "average/particle_tally.h"
#include "base/axes.h"
#include "core/deferred_loops.h"
#include "core/number_or_peratom.h"
#include "energy/potential_energy.h"
#include "group/chosen.h"
#include "particle/group_moments.h"

#include <string.h>

#include "base/banned.h"

enum { ENERGY = 3 };

struct addforce {
	struct ts_particle_tally before; /* per particle: force before it was added, potential energy */
	struct ts_number f[3], energy;
	int64_t every;
	struct ts_instance *region;
	struct ts_number_or_peratom now[3], energy_now;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct addforce *s = self->state;

	if (s->energy.null || s->energy.variable)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where, "fix addforce: energy takes a variable, v_NAME");
}

static enum ts_status evaluate_variables(struct ts_instance *self, struct tsim *sim)
{
	struct addforce *s = self->state;

	for (int k = 0; k < 3; k++)
		TS_TRY(ts_number_or_peratom_now(sim, &s->f[k], &self->where, &s->now[k]));
	if (s->energy.variable)
		return ts_number_or_peratom_now(sim, &s->energy, &self->where, &s->energy_now);
	return TS_OK;
}

/* Potential energy of particle i: -f . x for constant components; `energy` for variable ones. */
static double particle_energy(const struct addforce *s, const struct tsim *sim, size_t i)
{
	double x[3], energy = 0;

	if (s->energy.variable)
		return ts_number_or_peratom_of(&s->energy_now, i);
	ts_unwrapped(sim, i, x);
	for (int k = 0; k < 3; k++)
		energy -= s->f[k].variable ? 0 : s->f[k].value * x[k];
	return energy;
}

struct task {
	const struct tsim *sim;
	struct addforce *s;
	int group;
};

static void add_range(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_particles *p = t->sim->particles;
	struct addforce *s = t->s;

	for (size_t i = from; i < to; i++) {
		double *note = s->before.note[i];

		if (!ts_chosen(p, i, t->group, s->region)) {
			memset(note, 0, sizeof s->before.note[i]);
			continue;
		}
		memcpy(note, p->f[i], sizeof p->f[i]);
		note[ENERGY] = particle_energy(s, t->sim, i);
		for (int k = 0; k < 3; k++)
			p->f[i][k] += ts_number_or_peratom_of(&s->now[k], i);
	}
}

static bool is_constant(const struct addforce *s)
{
	return !s->region && !s->energy.variable && !s->f[0].variable && !s->f[1].variable &&
	       !s->f[2].variable;
}

static enum ts_status add_force(struct ts_instance *self, struct tsim *sim)
{
	struct addforce *s = self->state;
	struct task task = { sim, s, self->group };

	if (sim->clock.step % s->every != 0)
		return TS_OK;
	if (!is_constant(s)) /* a region and a variable may read particles */
		ts_deferred_loops_run(sim);
	TS_TRY(ts_region_update(s->region, sim));
	TS_TRY(ts_particle_tally_start_unset(sim, &s->before));
	TS_TRY(evaluate_variables(self, sim));
	TS_DEFER_LOOP(sim, sim->particles->n, add_range, &task);
	if (!is_constant(s)) /* it is of this step */
		ts_deferred_loops_run(sim);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct addforce *s = self->state;

	(void)sim;
	return ts_particle_tally_archive(a, &s->before);
}

static enum ts_status eval_energy(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct addforce *s = self->state;

	(void)sim;
	out->data[0] = ts_particle_tally_sums(&s->before)[ENERGY];
	return TS_OK;
}

static enum ts_status eval_before(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct addforce *s = self->state;

	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&s->before), 3 * sizeof *out->data);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct addforce *s = self->state;

	for (int k = 0; k < 3; k++)
		ts_number_or_peratom_release(&s->now[k]);
	ts_number_or_peratom_release(&s->energy_now);
	ts_particle_tally_release(&s->before);
}

static const struct ts_arg args[] = {
	TS_NUMBER("fx", struct addforce, f[0], .flags = TS_POSITIONAL | TS_EACH, .unit = "force",
		  .help = "x component of the force on each particle; a number, or v_NAME for an equal-style "
			  "or atom-style variable"),
	TS_NUMBER("fy", struct addforce, f[1], .flags = TS_POSITIONAL | TS_EACH, .unit = "force",
		  .help = "y component"),
	TS_NUMBER("fz", struct addforce, f[2], .flags = TS_POSITIONAL | TS_EACH, .unit = "force",
		  .help = "z component"),
	TS_INT("every", struct addforce, every, .range = TS_WITHIN, .lo = 1, .hi = 1e15, .fallback = "1",
	       .help = "the force is added only in time steps that are multiples of this"),
	TS_REGION_KEYWORD(struct addforce),
	TS_NUMBER("energy", struct addforce, energy, .flags = TS_OPTIONAL | TS_EACH, .unit = "energy",
		  .help = "v_NAME: potential energy of each particle, for forces that are variables"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "energy", "energy", "potential energy of all particles in the added force", TS_SCALAR, 1, NULL,
	  eval_energy },
	{ "before", "force", "total force on the particles before the force was added", TS_VECTOR, 3,
	  ts_axis_names, eval_before },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_addforce)
const struct ts_style ts_fix_addforce = {
	.name = "addforce",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,
	.join = ts_particle_tally_join,
	.summary = "adds a force to each particle of the group",
	.doc = "Adds the force (fx, fy, fz) to each particle of the group (that is in the region). The "
	       "potential energy of the constant components is -f . x with unwrapped positions x; components "
	       "that are variables have no energy unless the keyword `energy` gives one. The energy counts "
	       "in compute pe if `fix_modify ID energy yes` is set.",
	.example = "fix push tool addforce 0.0 0.0 -2.5\n"
		   "fix swing all addforce v_fx 0.0 0.0 every 10 region left energy v_e",
	.args = args,
	.state_size = sizeof(struct addforce),
	.archive = archive,
	.values = values,
	.energy = ts_energy_output,
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = add_force },
	.defers = TS_DEFERS(POST_FORCE),
	.fini = fini,
};
