/* Dump local/vtk: local rows of two particles, such as bonds and contacts, as lines for ParaView. */
#include "core/sim.h"
#include "dump/dump_vtk.h"
#include "particle/identity.h"
#include "particle/particles.h"

#include <math.h>

#include "base/banned.h"

struct state {
	struct ts_dump_vtk vtk;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (s->vtk.names.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "dump local/vtk: the first two columns must be the ids of the ends, found %zu "
			       "column",
			       s->vtk.names.n);
	TS_TRY(ts_dump_vtk_init(self, sim, true));
	s->vtk.common.column[0].integer = s->vtk.common.column[1].integer = true;
	return TS_OK;
}

static enum ts_status find_particle(struct ts_instance *self, struct tsim *sim,
				    const struct ts_identities *map, double id, int32_t *row)
{
	*row = id >= 1 && id <= map->max && floor(id) == id ? ts_identity_row(map, (int32_t)id) : -1;
	if (*row >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "dump local/vtk: %g in the first two columns is not the id of a particle", id);
}

static enum ts_status fill_points(struct ts_instance *self, struct tsim *sim)
{
	struct state *state = self->state;
	struct ts_dump_vtk *s = &state->vtk;
	const struct ts_dump_common *d = &s->common;
	const double(*x)[3] = (const double(*)[3])sim->particles->x;
	struct ts_identities map;
	int32_t i, j;

	if (ts_table_resize(&s->points, 2 * d->nrows, 3) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t row = 0; row < d->nrows; row++) {
		int32_t from = d->order[row];

		TS_TRY(find_particle(self, sim, &map, d->column[0].values.data[from], &i));
		TS_TRY(find_particle(self, sim, &map, d->column[1].values.data[from], &j));
		ts_dump_vtk_line(sim, x[i], x[j], &s->points.data[6 * row]);
	}
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	return ts_dump_vtk_frame(self, sim, true, fill_points);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return ts_dump_price(self, sim, true, true, report);
}

static const struct ts_arg args[] = {
	TS_DUMP_VTK_ARGS(struct state,
			 "c_ID[k] or f_ID[k]; the first two columns are the ids of the two particles"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_local_vtk)
const struct ts_style ts_dump_local_vtk = {
	.name = "local/vtk",
	.kind = TS_KIND_DUMP,
	.dump_words = "refresh binary append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Bonds or contacts as lines between particles for ParaView",
	.doc = "The first two columns are the ids of two particles; a line is drawn from the first to the "
	       "nearest periodic image of the second. All columns are written as data of the lines. Files "
	       "are as with dump custom/vtk.",
	.example = "dump bonds all local/vtk 1000 post/bonds*.vtp c_bonds[1] c_bonds[2] c_bonds[3]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_vtk_fini,
};
