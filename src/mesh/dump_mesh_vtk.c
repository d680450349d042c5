/* Dump mesh/vtk: meshes at their present position with quantities of each triangle, as legacy VTK (text). */
#include <string.h>

#include "core/sim.h"
#include "dump/dump_mesh.h"
#include "dump/dump_surface.h"
#include "load/mesh_stress.h"

#include "base/banned.h"

struct state {
	struct ts_dump_mesh mesh;
	unsigned chosen; /* bit k: quantities[k] is written */
	struct ts_dump_surface_inputs inputs;
	int form;      /* FACE, INTERPOLATE or ORIGINAL */
	size_t column; /* numbers in the present line */
};

enum { FACE, INTERPOLATE, ORIGINAL };
static const char *const forms[] = { "face", "interpolate", "original", NULL };

/* ---- quantities ---- */

/* Stores a scalar or vector of triangle t, or of one of its corners 0 .. 2 (-1: of the triangle as a
 * whole). */
typedef void get_fn(const struct ts_mesh_surface *s, size_t t, int corner, double out[3]);

static bool tracked(const struct ts_mesh_surface *s)
{
	return s->stress && s->stress->tracks;
}

static bool worn(const struct ts_mesh_surface *s)
{
	return s->stress && s->stress->wear.law != TS_MESH_WEAR_OFF;
}

static bool moves(const struct ts_mesh_surface *s)
{
	return s->v != NULL;
}

static void get_normal_stress(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = tracked(s) ? s->stress->normal[t] : 0;
}

static void get_shear_stress(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = tracked(s) ? s->stress->shear[t] : 0;
}

static void get_stress(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	for (int d = 0; d < 3; d++)
		out[d] = tracked(s) ? s->stress->load[t][d] / s->mesh.area[t] : 0;
}

static void get_wear(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = worn(s) ? s->stress->wear.depth[t] : 0;
}

static bool warm(const struct ts_mesh_surface *s)
{
	return !isnan(s->temperature);
}

static void get_temperature(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)t;
	(void)corner;
	out[0] = warm(s) ? s->temperature : 0;
}

static void get_index(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)s;
	(void)corner;
	out[0] = (double)t;
}

static void get_owner(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)s;
	(void)t;
	(void)corner;
	out[0] = 0;
}

static void get_area(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = s->mesh.area[t];
}

static void get_active_edges(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = 0;
	for (int k = 0; k < 3; k++)
		out[0] += ts_mesh_edge_active(&s->mesh, t, k);
}

static void get_active_corners(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	(void)corner;
	out[0] = 0;
	for (int k = 0; k < 3; k++)
		out[0] += ts_mesh_corner_active(&s->mesh, t, k);
}

static bool has_vertex(const struct ts_mesh *m, size_t t, int32_t vertex)
{
	return m->vertex[t][0] == vertex || m->vertex[t][1] == vertex || m->vertex[t][2] == vertex;
}

static void get_neighbours(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	const struct ts_mesh *m = &s->mesh;

	(void)corner;
	out[0] = 0;
	for (int k = 0; k < 3; k++) {
		out[0] += m->neighbour[t][k] >= 0;
		for (size_t o = 0; m->neighbour[t][k] == TS_MESH_MANY && o < m->n; o++)
			out[0] += o != t && has_vertex(m, o, m->vertex[t][k]) &&
				  has_vertex(m, o, m->vertex[t][(k + 1) % 3]);
	}
}

static void get_velocity(const struct ts_mesh_surface *s, size_t t, int corner, double out[3])
{
	for (int d = 0; d < 3; d++) {
		out[d] = 0;
		for (int k = 0; s->v && k < 3; k++)
			if (corner < 0 || corner == k)
				out[d] += s->v[t][k][d] / (corner < 0 ? 3 : 1);
	}
}

/* In the order in which they are written; `vel` comes first with `output interpolate`. */
static const struct quantity {
	const char *word, *name;
	int components;
	bool integer;
	get_fn *get;
	bool (*of)(const struct ts_mesh_surface *s); /* whether the mesh has it; NULL: all have */
} quantities[] = {
	{ "stress", "normal_stress_average", 1, false, get_normal_stress, tracked },
	{ "stress", "shear_stress_average", 1, false, get_shear_stress, tracked },
	{ "stresscomponents", "stress", 3, false, get_stress, tracked },
	{ "id", "meshid", 1, true, get_index, NULL },
	{ "wear", "wear", 1, false, get_wear, worn },
	{ "temp", "Temp", 1, false, get_temperature, warm },
	{ "owner", "owner", 1, true, get_owner, NULL },
	{ "area", "area", 1, false, get_area, NULL },
	{ "aedges", "active_edges", 1, true, get_active_edges, NULL },
	{ "acorners", "active_corners", 1, true, get_active_corners, NULL },
	{ "index", "index", 1, true, get_index, NULL },
	{ "nneighs", "nneighs", 1, true, get_neighbours, NULL },
	{ "vel", "v", 3, false, get_velocity, moves },
};
/* Keywords of LIGGGHTS for quantities that no mesh has here: their arrays are not written. */
static const char *const missing[] = { "liquid", "distaa", NULL };
enum { NQUANTITIES = sizeof quantities / sizeof *quantities, VELOCITY = NQUANTITIES - 1 };

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
	for (int k = 0; k < NQUANTITIES; k++)
		if (ts_streq(rest.word[0].text, quantities[k].word)) {
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
	if (s->chosen || s->inputs.list.n)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "dump mesh/vtk: say what to write of each triangle: stress, id, wear, vel, "
		       "stresscomponents, area, ...");
}

/* ---- the file ---- */

/* Nine numbers per line, each followed by a blank, as VTK's own writer does. */
static void add_number(struct state *s, const char *format, double value)
{
	struct ts_str *text = &s->mesh.common.text;

	ts_str_addf(text, format, value);
	if (++s->column % 9 == 0)
		ts_str_add(text, "\n");
}

static void end_numbers(struct state *s)
{
	s->column = 0;
	ts_str_add(&s->mesh.common.text, "\n");
}

static void add_points(struct state *s)
{
	for (size_t k = 0; k < s->mesh.nsurfaces; k++) {
		const struct ts_mesh *m = &s->mesh.surface[k]->mesh;

		for (size_t c = 0; c < 9 * m->n; c++)
			if (!ts_mesh_is_removed(m, c / 9))
				add_number(s, "%g ", (double)(float)m->x[c / 9][c / 3 % 3][c % 3]);
	}
	end_numbers(s);
}

static void add_cells(struct state *s, size_t n)
{
	struct ts_str *text = &s->mesh.common.text;

	ts_str_addf(text, "POLYGONS %zu %zu\nOFFSETS vtktypeint64\n", n + 1, 3 * n);
	for (size_t t = 0; t <= n; t++)
		add_number(s, "%.0f ", 3 * (double)t);
	end_numbers(s);
	ts_str_add(text, "CONNECTIVITY vtktypeint64\n");
	for (size_t c = 0; c < 3 * n; c++)
		add_number(s, "%.0f ", (double)c);
	end_numbers(s);
}

static void add_array(struct state *s, const struct quantity *q, size_t n)
{
	bool points = s->form == INTERPOLATE;
	const char *format = !q->integer ? "%.11g " : points ? "%g " : "%.0f ";
	double value[3] = { 0 };

	ts_str_addf(&s->mesh.common.text, "%s %d %zu %s\n", q->name, q->components, points ? 3 * n : n,
		    !q->integer ? "double"
		    : points	? "float"
				: "int");
	for (size_t k = 0; k < s->mesh.nsurfaces; k++)
		for (size_t t = 0; t < s->mesh.surface[k]->mesh.n; t++)
			for (int corner = points ? 0 : -1; corner < (points ? 3 : 0); corner++) {
				if (ts_mesh_is_removed(&s->mesh.surface[k]->mesh, t))
					continue;
				q->get(s->mesh.surface[k], t, corner, value);
				for (int d = 0; d < q->components; d++)
					add_number(s, format, value[d]);
			}
	end_numbers(s);
}

/* Output k of those named; 0 for the triangles of other meshes. */
static enum ts_status add_input(struct state *s, struct tsim *sim, size_t k, size_t n)
{
	const struct ts_mesh_surface *of = ts_dump_surface_of(&s->inputs, k)->state;
	size_t copies = s->form == INTERPOLATE ? 3 : 1; /* one for each corner */

	TS_TRY(ts_dump_surface_begin_array(sim, &s->inputs, k, of->mesh.n, n * copies, &s->mesh.common.text));
	for (size_t m = 0; m < s->mesh.nsurfaces; m++)
		for (size_t t = 0; t < s->mesh.surface[m]->mesh.n; t++)
			for (size_t c = 0; c < copies && !ts_mesh_is_removed(&s->mesh.surface[m]->mesh, t);
			     c++)
				add_number(s, "%.11g ",
					   s->mesh.surface[m] == of ? s->inputs.values.data[t] : 0);
	end_numbers(s);
	return TS_OK;
}

/* Whether quantity k is chosen and at least one mesh of the dump has it. */
static bool written(const struct state *s, int k)
{
	bool there = !quantities[k].of;

	for (size_t m = 0; m < s->mesh.nsurfaces && !there; m++)
		there = quantities[k].of(s->mesh.surface[m]);
	return there && (s->chosen & 1u << k);
}

static enum ts_status add_arrays(struct state *s, struct tsim *sim, size_t n)
{
	bool points = s->form == INTERPOLATE;
	int count = (int)s->inputs.list.n;

	for (int k = 0; k < NQUANTITIES; k++)
		count += written(s, k);
	if (!count)
		return TS_OK;
	ts_str_addf(&s->mesh.common.text, "%s %zu\nFIELD FieldData %d\n", points ? "POINT_DATA" : "CELL_DATA",
		    points ? 3 * n : n, count);
	for (int k = 0; k < NQUANTITIES; k++) {
		int which = !points ? k : k ? k - 1 : VELOCITY;

		if (written(s, which))
			add_array(s, &quantities[which], n);
	}
	for (size_t k = 0; k < s->inputs.list.n; k++)
		TS_TRY(add_input(s, sim, k, n));
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t n = ts_dump_mesh_triangles(&s->mesh);
	bool due;

	TS_TRY(ts_dump_mesh_begin(self, sim, &due));
	if (!due)
		return TS_OK;
	ts_str_addf(&s->mesh.common.text,
		    "# vtk DataFile Version 5.1\nGenerated by LIGGGHTS\nASCII\nDATASET POLYDATA\n"
		    "POINTS %zu float\n",
		    3 * n);
	add_points(s);
	add_cells(s, n);
	TS_TRY(add_arrays(s, sim, n));
	return ts_dump_mesh_end(self, sim);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;

	return ts_dump_price_frame(self, sim, 200 + 150 * (double)ts_dump_mesh_triangles(&s->mesh), report);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_dump_surface_release(&s->inputs);
	ts_dump_mesh_fini(self);
}

static const struct ts_arg args[] = {
	TS_DUMP_MESH_ARGS(struct state, "*.vtk",
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
	.summary = "Meshes with quantities of each triangle, as legacy VTK for ParaView",
	.doc = "Writes one file per frame, PolyData of version 5.1 as text; each triangle has points of its "
	       "own. With `output interpolate` the quantities are point data, else (face, original) cell "
	       "data. Arrays:\n\n"
	       "  stress             normal_stress_average, shear_stress_average\n"
	       "  stresscomponents   stress, the vector F/A\n"
	       "  id                 meshid\n"
	       "  aedges             active_edges, number of edges that particles can touch\n"
	       "  acorners           active_corners, number of corners that particles can touch\n"
	       "  vel                v\n"
	       "  temp               Temp\n\n"
	       "The other arrays have the name of their keyword. Stresses and wear are written only if a "
	       "mesh is a fix mesh/surface/stress, velocities only if a mesh moves, and Temp only if a mesh "
	       "has a temperature. LIGGGHTS 3.8 writes the temperature for the first triangle of a mesh "
	       "only.\n\n"
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
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = fini,
};
