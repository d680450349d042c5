/* Compute contact/atom: number of particles that touch or overlap each particle. */
#include "box/domain.h"
#include "geom/pairs.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct contact {
	int with; /* group of the partners; -1: all */
};

struct task {
	const struct tsim *sim;
	const struct ts_particles *p;
	ts_excluded_fn *excluded; /* NULL: no pair is */
	double *count;
	int group, with;
};

static void count_overlap(void *context, size_t i, size_t j, const double d[3])
{
	const struct task *t = context;
	double reach = t->p->radius[i] + t->p->radius[j];

	if (ts_in_group(t->p, i, t->group) && ts_in_group(t->p, j, t->with) &&
	    !(t->excluded && t->excluded(t->sim, i, j, d)))
		t->count[i] += d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= reach * reach;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct contact *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct task task = { .sim = sim,
			     .p = p,
			     .excluded = ts_neigh_excluded(sim),
			     .group = self->group,
			     .with = s->with < 0 ? 0 : s->with };
	double most = 0;

	TS_TRY(ts_table_resize(out, p->n, 1));
	task.count = out->data;
	for (size_t i = 0; i < p->n; i++) {
		out->data[i] = 0;
		most = p->radius[i] > most ? p->radius[i] : most;
	}
	if (!(most > 0))
		return TS_OK;
	/* pairs that just touch are in reach */
	return ts_pairs_visit(&sim->domain->box, sim->dimension, (const double(*)[3])p->x, p->n,
			      2 * most * (1 + 1e-9), count_overlap, &task);
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
