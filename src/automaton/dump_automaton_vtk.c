/* Dump automaton/vtk: the cells of the automaton, for ParaView. */
#include <string.h>

#include "automaton/automaton.h"
#include "dump/dump_vtk.h"

#include "base/banned.h"

enum { STATE, VELOCITY, NFIELDS };
enum { NCOLUMNS = 4 };

struct state {
	struct ts_dump_vtk vtk;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const char *file = ((const struct state *)self->state)->vtk.common.file;
	struct ts_automaton *a;

	TS_TRY(ts_automaton_require(sim, "dump automaton/vtk", &self->where, &a));
	if (!ts_ends_with(file, ".vti"))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, file),
			       "dump automaton/vtk: the name of the file must end in .vti, found '%s'", file);
	return TS_OK;
}

static void fill(const struct ts_automaton *a, double *state, double *velocity)
{
	const struct ts_automaton_lattice *l = &a->lattice;
	const double unit = ts_automaton_unit(a);

	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++, state++, velocity += 3) {
			const uint32_t w = l->cell[ts_automaton_at(l, x, y)];
			const struct ts_laws_velocity v = ts_laws_velocity_of(w);
			const bool granule = ts_cell_is_granule(w);

			*state = granule ? 1 : ts_cell_state(w) == TS_CELL_FIXED ? 2 : 0;
			velocity[0] = granule ? unit * v.x : 0;
			velocity[1] = granule ? unit * v.y : 0;
			velocity[2] = 0;
		}
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_vtk_array array[NFIELDS] = { { "state", NULL, 1, true, false },
					       { "velocity", NULL, 3, false, false } };
	struct ts_vtk_grid grid = { .uniform = true, .cell_data = array, .ncell_data = NFIELDS };
	struct ts_table faces = { 0 };
	struct ts_automaton *a;
	enum ts_status status;
	size_t cells, at = 0;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_automaton_require(sim, "dump automaton/vtk", &self->where, &a));
	cells = (size_t)a->lattice.nx * (size_t)a->lattice.ny;
	if (ts_table_resize(&s->vtk.merged, cells, NCOLUMNS) != TS_OK ||
	    ts_table_resize(&faces, (size_t)a->lattice.nx + (size_t)a->lattice.ny + 4, 1) != TS_OK)
		return ts_nomem(&sim->error);
	array[STATE].data = s->vtk.merged.data;
	array[VELOCITY].data = s->vtk.merged.data + cells;
	fill(a, s->vtk.merged.data, s->vtk.merged.data + cells);
	grid.n[0] = (size_t)a->lattice.nx;
	grid.n[1] = (size_t)a->lattice.ny;
	grid.n[2] = 1;
	for (int d = 0; d < 3; d++) {
		const double width = d < 2 ? a->cell : a->hi[2] - a->lo[2];

		grid.face[d] = faces.data + at;
		for (size_t k = 0; k <= grid.n[d]; k++)
			faces.data[at++] = a->lo[d] + (double)k * width;
	}
	grid.time = ts_sim_time(sim);
	status = ts_dump_vtk_path(&s->vtk.common, sim);
	if (status == TS_OK)
		status = ts_vtk_write_grid(sim, ts_str_text(&s->vtk.common.path), &self->where, &grid);
	ts_table_release(&faces);
	return status == TS_OK ? ts_dump_vtk_list(self, sim) : status;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const double left = 0.5; /* size after zlib and base64, by size of the data */
	struct ts_automaton *a;

	TS_TRY(ts_automaton_require(sim, "dump automaton/vtk", &self->where, &a));
	return ts_dump_price_frame(self, sim,
				   8 * NCOLUMNS * left * (double)a->lattice.nx * (double)a->lattice.ny,
				   report);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, vtk.common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_WORD("file", struct state, vtk.common.file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "file name, ending in .vti, with `*` for the step"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_automaton_vtk)
const struct ts_style ts_dump_automaton_vtk = {
	.name = "automaton/vtk",
	.kind = TS_KIND_DUMP,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Writes the cells of an automaton to VTK files for ParaView",
	.doc = "Image data (.vti), one layer of cells. Cell values: `state`, 0 empty, 1 granule, 2 obstacle, "
	       "and\n"
	       "`velocity`, that of the granule. With `*` in the name, one file is written for each frame, "
	       "and a\n"
	       "collection NAME.pvd with the times of all frames, which is the file to open in ParaView.",
	.example = "dump cells all automaton/vtk 100 post/cells*.vti",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_vtk_fini,
};
