/* Dump local/gran/vtk: contacts with all quantities of a compute, as lines for ParaView. */
#include "contact/contact_columns.h"
#include "core/sim.h"
#include "dump/dump_vtk.h"

#include <stdint.h>

#include "base/banned.h"

struct state {
	struct ts_dump_vtk vtk;
	const char *compute;
	struct ts_instance *contacts;
	struct ts_vtk_array array[TS_CONTACT_ARRAYS];
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->compute, .place = *ts_instance_word(self, s->compute) };

	TS_TRY(ts_dump_vtk_check_name(self, sim));
	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &id, &s->contacts));
	if (!s->contacts->style->family || !ts_streq(s->contacts->style->family, TS_FAMILY_CONTACTS))
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "dump local/gran/vtk needs a compute pair/gran/local or wall/gran/local; '%s' "
			       "is %s",
			       s->compute, s->contacts->style->name);
	return TS_OK;
}

static enum ts_status fill_points(struct state *s, struct tsim *sim, const struct ts_table *table, size_t pos)
{
	if (ts_table_resize(&s->vtk.points, 2 * table->rows, 3) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t row = 0; row < table->rows; row++) {
		const double *ends = table->data + row * table->columns + pos;

		ts_dump_vtk_line(sim, ends, ends + 3, &s->vtk.points.data[6 * row]);
	}
	return TS_OK;
}

static enum ts_status fill_arrays(struct state *s, struct tsim *sim, const struct ts_table *table,
				  const struct ts_contact_array *array, size_t n)
{
	double *to;

	if (ts_table_resize(&s->vtk.merged, table->rows, table->columns) != TS_OK)
		return ts_nomem(&sim->error);
	to = s->vtk.merged.data;
	for (size_t k = 0; k < n; k++) {
		s->array[k] = (struct ts_vtk_array){ array[k].name, to, array[k].components, false, false };
		for (size_t row = 0; row < table->rows; row++)
			for (size_t c = 0; c < array[k].components; c++)
				*to++ = table->data[row * table->columns + array[k].first + c];
	}
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_table *table = &s->contacts->table;
	struct ts_contact_array array[TS_CONTACT_ARRAYS];
	struct ts_vtk_poly poly = { .cell_data = s->array };
	size_t pos;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_value_cached(s->contacts, sim, ts_value_find(s->contacts, TS_LOCAL)));
	poly.ncell_data = ts_contact_columns_arrays(s->contacts->state, table->columns, array, &pos);
	if (pos == SIZE_MAX)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->compute),
			       "dump local/gran/vtk: compute %s has no positions: add the keyword pos",
			       s->compute);
	TS_TRY(fill_points(s, sim, table, pos));
	TS_TRY(fill_arrays(s, sim, table, array, poly.ncell_data));
	poly.points = s->vtk.points.data;
	poly.npoints = 2 * table->rows;
	poly.nlines = table->rows;
	return ts_dump_vtk_write(self, sim, &poly);
}

static const struct ts_arg args[] = {
	TS_DUMP_VTK_FILE_ARGS(struct state),
	TS_WORD("compute", struct state, compute, .flags = TS_POSITIONAL,
		.help = "ID of a compute pair/gran/local or wall/gran/local with the keyword pos"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_local_gran_vtk)
const struct ts_style ts_dump_local_gran_vtk = {
	.name = "local/gran/vtk",
	.kind = TS_KIND_DUMP,
	.dump_words = "binary append",
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Contacts as lines with forces and other data for ParaView",
	.doc = "Writes a line for each contact of the compute, from the centre of the first particle to the "
	       "nearest periodic image of the second, or from the wall to the particle. The other quantities "
	       "of the compute are data of the lines: vel1, vel2, id1, id2, id3, force, force_normal, "
	       "force_tangential, torque, history, contact_area, delta, contact_point. ParaView's filter "
	       "Tube shows them as force chains. Files are as with dump custom/vtk.\n\n"
	       "LIGGGHTS writes a triangle of both centres and the contact point, with the same data three "
	       "times; here a contact is one line.",
	.example = "compute chain all pair/gran/local pos id force\n"
		   "dump chains all local/gran/vtk 1000 post/chains*.vtp chain",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_vtk_fini,
};
