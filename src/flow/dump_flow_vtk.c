/* Dump flow/vtk: the fields of the fluid, cell by cell, for ParaView. */
#include <string.h>

#include "dump/dump_vtk.h"
#include "flow/flow.h"
#include "flow/flow_measures.h"
#include "flow/transported_scalars.h"

#include "base/banned.h"

enum { VELOCITY, PRESSURE, VOID, VORTICITY, NFIELDS };

struct state {
	struct ts_dump_vtk vtk;
	struct ts_words words, chosen; /* arguments; all fields if there are none */
	struct ts_name_list list;      /* indices of `chosen` */
	struct ts_vtk_array *array;    /* one for each of them, in the arena */
};

typedef void fill_fn(const struct ts_fluid *fluid, const int cell[3], double *out);

static size_t cell_index(const struct ts_fluid *fluid, const int cell[3])
{
	return ts_at(&fluid->grid, cell[0], cell[1], cell[2]);
}

static void pressure(const struct ts_fluid *fluid, const int cell[3], double *out)
{
	*out = fluid->p[cell_index(fluid, cell)];
}

static void void_fraction(const struct ts_fluid *fluid, const int cell[3], double *out)
{
	*out = fluid->void_fraction ? fluid->void_fraction[cell_index(fluid, cell)] : 1;
}

static const struct field {
	const char *name;
	size_t components;
	fill_fn *fill;
} fields[] = {
	[VELOCITY] = { "velocity", 3, ts_flow_centre_velocity },
	[PRESSURE] = { "pressure", 1, pressure },
	[VOID] = { "void", 1, void_fraction },
	[VORTICITY] = { "vorticity", 3, ts_flow_centre_vorticity },
	[NFIELDS] = { NULL, 0, NULL },
};

/* The VTK format that can hold the grid. */
static enum ts_status check_name(struct ts_instance *self, struct tsim *sim)
{
	const char *file = ((const struct state *)self->state)->vtk.common.file;
	bool image = ts_ends_with(file, ".vti"), graded = false;
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fluid(sim, "dump flow/vtk", &self->where, &fluid));
	for (int d = 0; d < 3; d++)
		graded |= !fluid->grid.uniform[d];
	if (!image && !ts_ends_with(file, ".vtr"))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, file),
			       "dump flow/vtk: the name of the file must end in .vti or .vtr, found '%s'",
			       file);
	if (image && graded)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, file),
			       "dump flow/vtk: a .vti file holds uniform grids, this one is graded: use a "
			       "name that ends in .vtr");
	return TS_OK;
}

/* "f_ID" */
static const char *name_of(struct ts_instance *self, const struct ts_instance *fix)
{
	size_t n = strlen(fix->id) + 1;
	char *name = ts_arena_alloc(&self->arena, n + 2, 1);

	if (name) {
		memcpy(name, "f_", 2);
		memcpy(name + 2, fix->id, n);
	}
	return name;
}

/* Without words: all fields of the fluid, and all scalars of fixes. */
static enum ts_status select_all_fields(struct ts_instance *self, struct tsim *sim,
					const struct ts_fluid *fluid)
{
	const struct ts_instance *fix;
	size_t most = NFIELDS, n = 0, k = 0;
	struct ts_word *word;

	while (ts_flow_next_scalar(sim, &k))
		most++;
	word = ts_arena_alloc(&self->arena, most, sizeof *word);
	if (!word)
		return ts_nomem(&sim->error);
	for (int field = 0; field < NFIELDS; field++)
		if (field != VOID || fluid->void_fraction)
			word[n++].text = fields[field].name;
	for (k = 0; (fix = ts_flow_next_scalar(sim, &k)); n++)
		if (!(word[n].text = name_of(self, fix)))
			return ts_nomem(&sim->error);
	((struct state *)self->state)->chosen = (struct ts_words){ word, n };
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_fluid *fluid;

	TS_TRY(check_name(self, sim));
	TS_TRY(ts_flow_require_fluid(sim, "dump flow/vtk", &self->where, &fluid));
	s->chosen = s->words;
	if (!s->words.n)
		TS_TRY(select_all_fields(self, sim, fluid));
	s->list.item = NULL; /* fields may have been added */
	TS_TRY(ts_flow_read_names(sim, "dump flow/vtk", &self->arena, s->chosen, fields, sizeof *fields,
				  &s->list));
	s->array = ts_arena_alloc(&self->arena, s->list.n, sizeof *s->array);
	return s->array ? TS_OK : ts_nomem(&sim->error);
}

static size_t number_of_components(int field)
{
	return field == TS_FLOW_SCALAR ? 1 : fields[field].components;
}

static size_t number_of_columns(const struct state *s)
{
	size_t n = 0;

	for (size_t k = 0; k < s->list.n; k++)
		n += number_of_components(s->list.item[k]);
	return n;
}

/* Value of a cell: by the function, or from the scalar field. */
static void fill_cells(const struct ts_fluid *fluid, fill_fn *fill, const double *carried, size_t n,
		       double *to)
{
	const struct ts_grid *grid = &fluid->grid;
	int cell[3];

	for (cell[2] = 0; cell[2] < grid->n[2]; cell[2]++)
		for (cell[1] = 0; cell[1] < grid->n[1]; cell[1]++)
			for (cell[0] = 0; cell[0] < grid->n[0]; cell[0]++, to += n)
				if (fill)
					fill(fluid, cell, to);
				else
					*to = carried[cell_index(fluid, cell)];
}

static enum ts_status fill_fields(struct ts_instance *self, struct tsim *sim, const struct ts_fluid *fluid)
{
	struct state *s = self->state;
	double *to = s->vtk.merged.data;

	for (size_t k = 0; k < s->list.n; k++) {
		int field = s->list.item[k];
		size_t n = number_of_components(field);
		struct ts_flow_scalar carried = { 0 };

		if (field == TS_FLOW_SCALAR)
			TS_TRY(ts_flow_scalar_field(sim, "dump flow/vtk", &s->chosen.word[k], &carried));
		s->array[k] = (struct ts_vtk_array){ s->chosen.word[k].text, to, n, false, false };
		fill_cells(fluid, carried.value ? NULL : fields[field].fill, carried.value, n, to);
		to += ts_grid_cells(&fluid->grid) * n;
	}
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_vtk_grid grid = { .ncell_data = s->list.n };
	struct ts_fluid *fluid;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_flow_require_fields(sim, "dump flow/vtk", &self->where, &fluid));
	if (ts_table_resize(&s->vtk.merged, ts_grid_cells(&fluid->grid), number_of_columns(s)) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(fill_fields(self, sim, fluid));
	grid.cell_data = s->array;
	for (int d = 0; d < 3; d++) {
		grid.face[d] = fluid->grid.face[d];
		grid.n[d] = (size_t)fluid->grid.n[d];
	}
	grid.time = ts_sim_time(sim);
	TS_TRY(ts_dump_vtk_path(&s->vtk.common, sim));
	TS_TRY(ts_vtk_write_grid(sim, ts_str_text(&s->vtk.common.path), &self->where, &grid));
	return ts_dump_vtk_list(self, sim);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const double left = 0.9 * 4 / 3; /* size after zlib and base64, by size of the data */
	const struct state *s = self->state;
	struct ts_fluid *fluid;

	TS_TRY(ts_flow_require_fluid(sim, "dump flow/vtk", &self->where, &fluid));
	return ts_dump_price_frame(self, sim,
				   8 * left * (double)(number_of_columns(s) * ts_grid_cells(&fluid->grid)),
				   report);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, vtk.common.every, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_WORD("file", struct state, vtk.common.file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "file name, ending in .vti (uniform grids) or .vtr (any grid), with `*` for the "
			"step"),
	TS_REST_OPTIONAL("fields", struct state, words,
			 .help = "velocity, pressure, void, vorticity, f_ID (a scalar of fix flow/scalar); "
				 "default: all that exist"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_flow_vtk)
const struct ts_style ts_dump_flow_vtk = {
	.name = "flow/vtk",
	.kind = TS_KIND_DUMP,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Writes the fields of the fluid to VTK files for ParaView",
	.doc = "Cell values: velocity (mean over the faces of the cell), pressure, void fraction, vorticity "
	       "curl u (mean over the edges of the cell), and scalars of fix flow/scalar (f_ID). A .vti file "
	       "(image data) stores three spacings in place of coordinates, for uniform grids; a .vtr file "
	       "(rectilinear grid) stores the faces along all axes. With `*` in the name, one file is "
	       "written for each frame, and a collection NAME.pvd with the times of all frames, which is the "
	       "file to open in ParaView. Files and collection are renamed into place when they are "
	       "complete.",
	.example = "dump fields all flow/vtk 1000 post/flow*.vti\n"
		   "dump speed all flow/vtk 1000 post/speed*.vtr velocity",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_vtk_fini,
};
