/* Fix store/force: stores the forces at this point of the time step. */
#include "base/axes.h"
#include "core/sim.h"
#include "particle/columns.h"

#include <string.h>

#include "particle/particles.h"

#include "base/banned.h"

struct state {
	size_t column;
};

static double *stored_force(const struct state *s, const struct tsim *sim, size_t i)
{
	return (double *)sim->particles->column[s->column].data + 3 * i;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "fix store/force %s", self->id);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), 3, TS_COL_RESULT, &s->column);
	ts_str_release(&name);
	return status;
}

static enum ts_status store_forces(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; k < 3; k++)
			stored_force(s, sim, i)[k] = ts_in_group(p, i, self->group) ? p->f[i][k] : 0;
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct state *s = self->state;

	return ts_particles_archive_column(a, sim, "force", s->column);
}

static enum ts_status eval_forces(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	size_t n = sim->particles->n;

	TS_TRY(ts_table_resize(out, n, 3));
	if (n)
		memcpy(out->data, stored_force(s, sim, 0), 3 * n * sizeof *out->data);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "force", "force", "stored force on each particle; 0 outside the group", TS_PERATOM, 3,
	  ts_axis_names, eval_forces },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_store_force)
const struct ts_style ts_fix_store_force = {
	.name = "store/force",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "stores the forces on particles before later fixes change them",
	.doc = "Fixes act in the order in which they are defined. This fix stores the sum of the forces of "
	       "contacts, bonds and the fixes defined before it, e.g. before fix setforce or fix freeze "
	       "cancels them. The per-atom array f_ID[k] holds the three components.",
	.example = "fix felt wall store/force\nfix hold wall freeze\ncompute load wall reduce sum f_felt[*]",
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.init = init,
	.hook[TS_STAGE_POST_FORCE] = store_forces,
};
