#include "average/particle_tally.h"
#include "base/axes.h"
#include "core/deferred_loops.h"
#include "group/group_members.h"
#include "particle/particles.h"

#include <string.h>

#include "base/banned.h"

struct freeze {
	struct ts_particle_tally before; /* force on each particle before it was cleared */
};

/* Inverse mass 0: the neighbour search skips pairs of frozen particles. */
static enum ts_status set_infinite_mass(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			p->imass[i] = 0;
	return TS_OK;
}

struct task {
	const struct ts_particles *p;
	struct ts_particle_tally *before;
	int group;
};

static void clear_forces(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_particles *p = t->p;

	size_t members = ts_group_members(p, t->group, from, to);
	double(*note)[TS_PARTICLE_TALLY_MOST];

	if (!members)
		return;
	note = ts_particle_tally_append(t->before, members);
	for (size_t i = from; i < to; i++) {
		if (!ts_in_group(p, i, t->group))
			continue;
		memcpy(*note++, p->f[i], sizeof p->f[i]);
		memset(p->f[i], 0, sizeof p->f[i]);
		if (p->torque)
			memset(p->torque[i], 0, sizeof p->torque[i]);
	}
}

static enum ts_status freeze_particles(struct ts_instance *self, struct tsim *sim)
{
	struct freeze *s = self->state;
	struct task task = { sim->particles, &s->before, self->group };

	TS_TRY(ts_particle_tally_start_empty(sim, &s->before));
	TS_DEFER_LOOP(sim, sim->particles->n, clear_forces, &task);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct freeze *s = self->state;

	(void)sim;
	return ts_particle_tally_archive(a, &s->before);
}

static enum ts_status eval_before(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct freeze *s = self->state;

	(void)sim;
	memcpy(out->data, ts_particle_tally_sums(&s->before), 3 * sizeof *out->data);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct freeze *s = self->state;

	ts_particle_tally_release(&s->before);
}

static const struct ts_value values[] = {
	{ "before", "force", "total force on the particles before it was cleared", TS_VECTOR, 3,
	  ts_axis_names, eval_before },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_freeze)
const struct ts_style ts_fix_freeze = {
	.name = "freeze",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_particle_tally_join,
	.summary = "keeps the particles of the group at rest",
	.doc = "Sets force and torque of the particles of the group to zero. Particles at rest stay at "
	       "rest; moving ones keep their velocity, so set it to zero first. Frozen particles have "
	       "infinite mass in contact laws. Contacts between two frozen particles are not evaluated; "
	       "those of one with a wall only where a style reads the contacts of that surface, as fix "
	       "wear/archard, surface/heat or mesh/surface/stress. f_ID has no forces of other walls. Define "
	       "this fix after the fixes whose forces it cancels.",
	.example = "velocity wall set 0 0 0\nfix hold wall freeze",
	.state_size = sizeof(struct freeze),
	.archive = archive,
	.values = values,
	.hook = { [TS_STAGE_EXCHANGE] = set_infinite_mass, [TS_STAGE_POST_FORCE] = freeze_particles },
	.defers = TS_DEFERS(POST_FORCE),
	.fini = fini,
};
