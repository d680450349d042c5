/* Dump mesh/vtk: meshes at their present position with quantities of each triangle, for ParaView. */
#include <string.h>

#include "core/sim.h"
#include "dump/dump_mesh.h"
#include "dump/dump_surface.h"
#include "io/vtk_legacy.h"
#include "load/mesh_quantities.h"

#include "base/banned.h"

struct state {
	struct ts_dump_mesh mesh;
	unsigned chosen; /* bit k: ts_mesh_quantities[k] is written */
	struct ts_dump_surface_inputs inputs;
	int form; /* FACE, INTERPOLATE or ORIGINAL */
};

enum { FACE, INTERPOLATE, ORIGINAL };
static const char *const forms[] = { "face", "interpolate", "original", NULL };

/* Keywords of LIGGGHTS for quantities that no mesh has here: their arrays are not written. */
static const char *const missing[] = { "liquid", "distaa", NULL };

/* ---- arguments ---- */

static enum ts_status read_form(struct state *s, struct tsim *sim, struct ts_words rest)
{
	struct ts_suggest suggest = ts_suggest_start(rest.n > 1 ? rest.word[1].text : "");

	for (int k = 0; forms[k]; k++) {
		s->form = k;
		if (rest.n > 1 && ts_streq(rest.word[1].text, forms[k]))
			return TS_OK;
		ts_suggest_try(&suggest, forms[k]);
	}
	return ts_fail(&sim->error, TS_SYNTAX, &rest.word[rest.n > 1].place,
		       "dump mesh/vtk: `output` must be followed by one of its forms%s",
		       ts_suggest_text(&suggest));
}

static bool names_output(const struct tsim *sim, const char *word)
{
	return (strncmp(word, "f_", 2) == 0 || strncmp(word, "c_", 2) == 0) &&
	       !ts_mesh_surface_find(sim, word);
}

static enum ts_status read_word(struct ts_instance *self, struct tsim *sim, struct ts_words rest,
				size_t *taken)
{
	struct state *s = self->state;

	*taken = 0;
	for (int k = 0; k < TS_MESH_QUANTITIES; k++)
		if (ts_streq(rest.word[0].text, ts_mesh_quantities[k].word)) {
			s->chosen |= 1u << k;
			*taken = 1;
		}
	for (int k = 0; missing[k]; k++)
		*taken += ts_streq(rest.word[0].text, missing[k]);
	if (!*taken && names_output(sim, rest.word[0].text)) {
		*taken = 1;
		return s->inputs.list.n ? TS_OK
					: ts_words_append(&self->arena, (struct ts_words){ rest.word, 1 },
							  &s->inputs.names);
	}
	if (!ts_streq(rest.word[0].text, "output"))
		return TS_OK;
	*taken = 2;
	return read_form(s, sim, rest);
}

static bool writes(const struct ts_instance *self, const struct ts_instance *by)
{
	const struct state *s = self->state;

	for (size_t k = 0; k < s->mesh.nsurfaces; k++)
		if (by->state == s->mesh.surface[k])
			return true;
	return false;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->chosen = 0;
	s->form = FACE;
	TS_TRY(ts_dump_mesh_init(self, sim, read_word));
	TS_TRY(ts_dump_surface_find(self, sim, writes, &s->inputs));
	if (ts_vtk_is_supported(s->mesh.vtk.common.file))
		TS_TRY(ts_dump_vtk_check_name(self, sim));
	if (!s->mesh.vtk.array)
		s->mesh.vtk.array = ts_arena_alloc(&self->arena, TS_MESH_QUANTITIES + s->inputs.list.n,
						   sizeof *s->mesh.vtk.array);
	if (!s->mesh.vtk.array)
		return ts_nomem(&sim->error);
	if (s->chosen || s->inputs.list.n)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "dump mesh/vtk: say what to write of each triangle: stress, id, wear, vel, "
		       "stresscomponents, area, ...");
}

/* ---- the file ---- */

/* Copies of a number of a triangle: one for each corner, or one. */
static int copies(const struct state *s)
{
	return s->form == INTERPOLATE ? 3 : 1;
}

/* Files that are not one of the formats of io/vtk.h are legacy text, as .vtk. */
static bool is_text(const struct state *s)
{
	const struct ts_dump_common *d = &s->mesh.vtk.common;

	return !ts_vtk_is_supported(d->file) || (ts_ends_with(d->file, ".vtk") && !d->binary);
}

static enum ts_status fill_points(struct state *s, struct tsim *sim, size_t n)
{
	struct ts_table *points = &s->mesh.vtk.points;
	bool single = is_text(s);
	double *to;

	if (ts_table_resize(points, 3 * n, 3) != TS_OK)
		return ts_nomem(&sim->error);
	to = points->data;
	for (size_t k = 0; k < s->mesh.nsurfaces; k++) {
		const struct ts_mesh *m = &s->mesh.surface[k]->mesh;

		for (size_t c = 0; c < 9 * m->n; c++) {
			double x = m->x[c / 9][c / 3 % 3][c % 3];

			if (!ts_mesh_is_removed(m, c / 9))
				*to++ = single ? (double)(float)x : x;
		}
	}
	return TS_OK;
}

static void fill_quantity(const struct state *s, const struct ts_mesh_quantity *q, double *to)
{
	bool points = s->form == INTERPOLATE;
	double value[3] = { 0 };

	for (size_t k = 0; k < s->mesh.nsurfaces; k++)
		for (size_t t = 0; t < s->mesh.surface[k]->mesh.n; t++)
			for (int corner = points ? 0 : -1; corner < (points ? 3 : 0); corner++) {
				if (ts_mesh_is_removed(&s->mesh.surface[k]->mesh, t))
					continue;
				q->get(s->mesh.surface[k], t, corner, value);
				for (int d = 0; d < q->components; d++)
					*to++ = value[d];
			}
}

/* Output k of those named; 0 for the triangles of other meshes. */
static enum ts_status fill_input(struct state *s, struct tsim *sim, size_t k, double *to)
{
	const struct ts_mesh_surface *of = ts_dump_surface_of(&s->inputs, k)->state;

	TS_TRY(ts_dump_surface_eval(sim, &s->inputs, k, of->mesh.n));
	for (size_t m = 0; m < s->mesh.nsurfaces; m++)
		for (size_t t = 0; t < s->mesh.surface[m]->mesh.n; t++)
			for (int c = 0; c < copies(s) && !ts_mesh_is_removed(&s->mesh.surface[m]->mesh, t);
			     c++)
				*to++ = s->mesh.surface[m] == of ? s->inputs.values.data[t] : 0;
	return TS_OK;
}

/* Whether quantity k is chosen and at least one mesh of the dump has it. */
static bool written(const struct state *s, int k)
{
	bool there = !ts_mesh_quantities[k].of;

	for (size_t m = 0; m < s->mesh.nsurfaces && !there; m++)
		there = ts_mesh_quantities[k].of(s->mesh.surface[m]);
	return there && (s->chosen & 1u << k);
}

/* Lists the arrays in the order of LIGGGHTS, which writes integers at points in single precision. */
static void list_arrays(struct state *s)
{
	struct ts_dump_vtk *v = &s->mesh.vtk;
	bool points = s->form == INTERPOLATE;

	v->narrays = 0;
	for (int k = 0; k < TS_MESH_QUANTITIES; k++) {
		int which = !points ? k : k ? k - 1 : TS_MESH_VELOCITY;
		const struct ts_mesh_quantity *q = &ts_mesh_quantities[which];

		if (written(s, which))
			v->array[v->narrays++] = (struct ts_vtk_array){ q->name, NULL, (size_t)q->components,
									q->integer, q->integer && points };
	}
	for (size_t k = 0; k < s->inputs.list.n; k++)
		v->array[v->narrays++] =
			(struct ts_vtk_array){ .name = s->inputs.list.item[k].name, .components = 1 };
}

static const struct ts_mesh_quantity *quantity_named(const char *name)
{
	const struct ts_mesh_quantity *q = ts_mesh_quantities;

	while (!ts_streq(q->name, name))
		q++;
	return q;
}

static enum ts_status fill_arrays(struct state *s, struct tsim *sim, size_t n)
{
	struct ts_dump_vtk *v = &s->mesh.vtk;
	size_t rows = n * (size_t)copies(s), width = 0, inputs = s->inputs.list.n;
	double *to;

	list_arrays(s);
	for (size_t k = 0; k < v->narrays; k++)
		width += v->array[k].components;
	if (ts_table_resize(&v->merged, rows, width) != TS_OK)
		return ts_nomem(&sim->error);
	to = v->merged.data;
	for (size_t k = 0; k < v->narrays; k++) {
		size_t others = v->narrays - inputs;

		if (k < others)
			fill_quantity(s, quantity_named(v->array[k].name), to);
		else
			TS_TRY(fill_input(s, sim, k - others, to));
		v->array[k].data = to;
		to += rows * v->array[k].components;
	}
	return TS_OK;
}

static enum ts_status write_text(struct ts_instance *self, struct tsim *sim, struct ts_vtk_poly *poly)
{
	struct ts_dump_common *d = self->state;

	TS_TRY(ts_dump_open(self, sim));
	poly->time = ts_sim_time(sim);
	TS_TRY(ts_vtk_legacy_poly(sim, &d->text, poly));
	return ts_dump_mesh_end(self, sim);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_dump_vtk *v = &s->mesh.vtk;
	size_t n = ts_dump_mesh_triangles(&s->mesh);
	struct ts_vtk_poly poly = { .ntriangles = n, .npoints = 3 * n, .single_points = is_text(s) };
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(fill_points(s, sim, n));
	TS_TRY(fill_arrays(s, sim, n));
	poly.points = v->points.data;
	poly.title = is_text(s) ? "Generated by LIGGGHTS" : NULL; /* text is the same byte for byte */
	if (s->form == INTERPOLATE) {
		poly.point_data = v->array;
		poly.npoint_data = v->narrays;
	} else {
		poly.cell_data = v->array;
		poly.ncell_data = v->narrays;
	}
	return ts_vtk_is_supported(v->common.file) ? ts_dump_vtk_write(self, sim, &poly)
						   : write_text(self, sim, &poly);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;

	double triangle = is_text(s) ? 150 : 60; /* bytes, measured */

	return ts_dump_price_frame(self, sim, 200 + triangle * (double)ts_dump_mesh_triangles(&s->mesh),
				   report);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_dump_surface_release(&s->inputs);
	ts_dump_mesh_fini(self);
}

static const struct ts_arg args[] = {
	TS_DUMP_MESH_ARGS(struct state, "*.vtk, *.vtp, *.vtu",
			  "in any order: ids of `fix mesh/surface`, else all meshes; what to write of each "
			  "triangle: stress, stresscomponents, id, wear, temp, owner, area, aedges, "
			  "acorners, index, nneighs, vel (liquid and distaa are accepted, but no mesh has "
			  "them), f_ID[k]: column k of an output of a fix that has rows of triangles; "
			  "`output face|interpolate|original`"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_MESH_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_mesh_vtk)
const struct ts_style ts_dump_mesh_vtk = {
	.name = "mesh/vtk",
	.kind = TS_KIND_DUMP,
	.dump_words = "binary append",
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Meshes with quantities of each triangle, for ParaView",
	.doc = "Writes one file per frame; each triangle has points of its own. The ending of the name "
	       "selects the format, as for dump custom/vtk: .vtp and .vtu are compressed VTK XML, .vtk is "
	       "the legacy format 5.1 as text, with positions of six digits as of LIGGGHTS, with "
	       "`dump_modify binary yes` as binary with all digits; .pvtp, .pvtu: a list with one piece; "
	       ".vtkhdf: all frames in one file; any other name: as .vtk. The collection NAME.pvd, for .vtk "
	       "NAME.vtk.series, lists the frames with their times: open this file in ParaView.\n\n"
	       "With `output interpolate` the quantities are point data, else (face, original) cell data. "
	       "Arrays:\n\n"
	       "  stress             normal_stress_average, shear_stress_average\n"
	       "  stresscomponents   stress, the vector F/A\n"
	       "  id                 meshid\n"
	       "  aedges             active_edges, number of edges that particles can touch\n"
	       "  acorners           active_corners, number of corners that particles can touch\n"
	       "  vel                v\n"
	       "  temp               Temp\n\n"
	       "The other arrays have the name of their keyword. Stresses and wear are written only if a "
	       "mesh is a fix mesh/surface/stress, velocities only if a mesh moves or has moved, and Temp "
	       "only if a mesh has a temperature. LIGGGHTS 3.8 writes the temperature for the first triangle "
	       "of a mesh only.\n\n"
	       "f_ID[k] writes an array of this name with column k of an output of fix ID that has a row for "
	       "each triangle of its mesh, and 0 for the triangles of other meshes. f_ID[*] writes all "
	       "columns.\n\n"
	       "Related: dump mesh/stl, fix mesh/surface, fix mesh/surface/stress.",
	.example = "dump stress all mesh/vtk 200 post/mesh*.vtk id area vel\n"
		   "dump points all mesh/vtk 200 post/drum*.vtk output interpolate vel drum\n"
		   "dump worn all mesh/vtk 200 post/worn*.vtk f_chute[6] chute",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = fini,
};
