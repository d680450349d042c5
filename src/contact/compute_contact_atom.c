/* Compute contact/atom: number of particles that touch or overlap each particle. */
#include "neigh/overlaps.h"
#include "particle/particles.h"

#include "base/banned.h"

struct contact {
	int with; /* group of the partners; -1: all */
};

struct task {
	const struct ts_particles *p;
	double *count;
	int group, with;
};

static void count_overlap(void *context, size_t i, size_t j, const double d[3])
{
	const struct task *t = context;

	(void)d;
	t->count[i] += ts_in_group(t->p, i, t->group) && ts_in_group(t->p, j, t->with);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct contact *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct task task = { .p = p, .group = self->group, .with = s->with < 0 ? 0 : s->with };

	TS_TRY(ts_table_resize(out, p->n, 1));
	task.count = out->data;
	for (size_t i = 0; i < p->n; i++)
		out->data[i] = 0;
	return ts_overlaps_visit(sim, count_overlap, &task);
}

static const struct ts_value values[] = {
	{ "contacts", "", "number of particles that overlap it; 0 outside the group", TS_PERATOM, 1, NULL,
	  eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_GROUP("with", struct contact, with, .flags = TS_POSITIONAL | TS_OPTIONAL,
		 .help = "only overlaps with particles of this group count"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_contact_atom)
const struct ts_style ts_compute_contact_atom = {
	.name = "contact/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Number of contacts of each particle",
	.doc = "Counts, for each particle of the group, the other particles, of any group, whose distance "
	       "is at most the sum of the radii, but not pairs excluded by neigh_modify, special_bonds or "
	       "a common rigid body. It uses positions and radii only: without a pair_style overlaps count "
	       "as well. Periodic images count.",
	.example = "compute z all contact/atom\ncompute mean all reduce ave c_z",
	.args = args,
	.state_size = sizeof(struct contact),
	.values = values,
};
