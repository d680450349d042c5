#include "average/particle_tally.h"
#include "base/axes.h"
#include "core/deferred_loops.h"
#include "core/number_or_peratom.h"
#include "force/restraint.h"
#include "group/chosen.h"

#include <string.h>

#include "base/banned.h"

struct setforce {
	struct ts_particle_tally before; /* force on each particle before it was set */
	struct ts_number f[3];
	struct ts_instance *region;
	struct ts_number_or_peratom now[3];
};

struct task {
	const struct ts_particles *p;
	struct setforce *s;
	int group;
};

static void set_range(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_particles *p = t->p;
	struct setforce *s = t->s;

	for (size_t i = from; i < to; i++) {
		double *note = s->before.note[i];

		memset(note, 0, sizeof s->before.note[i]);
		if (!ts_chosen(p, i, t->group, s->region))
			continue;
		memcpy(note, p->f[i], sizeof p->f[i]);
		for (int k = 0; k < 3; k++)
			if (!s->f[k].null)
				p->f[i][k] = ts_number_or_peratom_of(&s->now[k], i);
	}
}

static bool is_constant(const struct setforce *s)
{
	return !s->region && !s->f[0].variable && !s->f[1].variable && !s->f[2].variable;
}

static enum ts_status set_forces(struct ts_instance *self, struct tsim *sim)
{
	struct setforce *s = self->state;
	struct task task = { sim->particles, s, self->group };

	if (!is_constant(s)) /* a region and a variable may read particles */
		ts_deferred_loops_run(sim);
	TS_TRY(ts_region_update(s->region, sim));
	TS_TRY(ts_particle_tally_start_unset(sim, &s->before));
	for (int k = 0; k < 3; k++)
		if (!s->f[k].null)
			TS_TRY(ts_number_or_peratom_now(sim, &s->f[k], &self->where, &s->now[k]));
	TS_DEFER_LOOP(sim, sim->particles->n, set_range, &task);
	if (!is_constant(s)) /* it is of this step */
		ts_deferred_loops_run(sim);
	return TS_OK;
}

static enum ts_status update_region(struct ts_instance *self, struct tsim *sim)
{
	return ts_region_update(((struct setforce *)self->state)->region, sim);
}

static void clear_set_components(const struct ts_instance *self, const struct tsim *sim, size_t i,
				 double f[3])
{
	const struct setforce *s = self->state;

	for (int k = 0; k < 3; k++)
		if (!s->f[k].null && (!s->region || ts_region_contains(s->region, sim->particles->x[i])))
			f[k] = 0;
}

static const struct ts_restraint restraint = { update_region, clear_set_components };

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct setforce *s = self->state;

	(void)sim;
	return ts_particle_tally_archive(a, &s->before);
}

static enum ts_status eval_before(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct setforce *s = self->state;

	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&s->before), 3 * sizeof *out->data);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct setforce *s = self->state;

	for (int k = 0; k < 3; k++)
		ts_number_or_peratom_release(&s->now[k]);
	ts_particle_tally_release(&s->before);
}

static const struct ts_arg args[] = {
	TS_NUMBER("fx", struct setforce, f[0], .flags = TS_POSITIONAL | TS_EACH | TS_NULLABLE,
		  .unit = "force",
		  .help = "x component of the force; NULL: unchanged; v_NAME: an equal-style or atom-style "
			  "variable"),
	TS_NUMBER("fy", struct setforce, f[1], .flags = TS_POSITIONAL | TS_EACH | TS_NULLABLE,
		  .unit = "force", .help = "y component"),
	TS_NUMBER("fz", struct setforce, f[2], .flags = TS_POSITIONAL | TS_EACH | TS_NULLABLE,
		  .unit = "force", .help = "z component"),
	TS_REGION_KEYWORD(struct setforce),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "before", "force", "total force on the particles before it was set", TS_VECTOR, 3, ts_axis_names,
	  eval_before },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_setforce)
const struct ts_style ts_fix_setforce = {
	.name = "setforce",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_particle_tally_join,
	.summary = "sets components of the force on each particle of the group",
	.doc = "Replaces the force on each particle of the group (that is in the region) by (fx, fy, fz). "
	       "All forces that were added earlier in the time step are discarded; a component that is NULL "
	       "is not changed. The vector f_ID[k] is the total force on the particles before it was set.",
	.example = "fix guide tool setforce 0.0 0.0 NULL",
	.args = args,
	.state_size = sizeof(struct setforce),
	.archive = archive,
	.values = values,
	.hook = { [TS_STAGE_POST_FORCE] = set_forces },
	.defers = TS_DEFERS(POST_FORCE),
	.restraint = &restraint,
	.fini = fini,
};
