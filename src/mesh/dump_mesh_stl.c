/* Dump mesh/stl: meshes at their present position, as STL. */
#include "core/sim.h"
#include "dump/dump_mesh.h"
#include "io/decimal.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	struct ts_dump_mesh mesh;
	struct ts_instance *region; /* NULL: all of space */
	bool images;
};

static const char *const parts[] = { "local", "owned", "all", "ghost", NULL };

/* In LIGGGHTS these words choose parts of a mesh by processor. Here each rank has whole meshes, and no copies
 * for periodic images (ghost) are stored. */
static enum ts_status read_word(struct ts_instance *self, struct tsim *sim, struct ts_words rest,
				size_t *taken)
{
	struct state *s = self->state;

	*taken = 0;
	for (int k = 0; parts[k]; k++)
		if (ts_streq(rest.word[0].text, parts[k])) {
			s->images = !parts[k + 1];
			*taken = 1;
		}
	if (!ts_streq(rest.word[0].text, "region"))
		return TS_OK;
	*taken = 2;
	if (rest.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &rest.word[0].place,
			       "dump mesh/stl: `region` needs the id of a region");
	return ts_sim_require(sim, TS_KIND_REGION, &rest.word[1], &s->region);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->region = NULL;
	s->images = false;
	return ts_dump_mesh_init(self, sim, read_word);
}

/* A line: what it is, and three numbers as by %g. */
static void add_line(struct ts_str *out, const char *what, const double v[3])
{
	char number[TS_DECIMAL_SIZE];

	ts_str_add(out, what);
	for (int k = 0; k < 3; k++) {
		ts_str_add_n(out, " ", 1);
		ts_str_add_n(out, number, ts_decimal_g(v[k], 6, number));
	}
	ts_str_add_n(out, "\n", 1);
}

static void add_facet(struct ts_str *out, const struct ts_mesh *m, size_t t)
{
	add_line(out, "  facet normal", m->normal[t]);
	ts_str_add(out, "    outer loop\n");
	for (int k = 0; k < 3; k++)
		add_line(out, "      vertex", m->x[t][k]);
	ts_str_add(out, "    endloop\n  endfacet\n");
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str *text = &s->mesh.vtk.common.text;
	bool due;

	TS_TRY(ts_dump_mesh_begin(self, sim, &due));
	if (!due)
		return TS_OK;
	if (s->region)
		TS_TRY(ts_region_update(s->region, sim));
	ts_str_add(text, "solid LIGGGHTS_STL_EXPORT\n");
	for (size_t k = 0; k < s->mesh.nsurfaces && !s->images; k++) {
		const struct ts_mesh *m = &s->mesh.surface[k]->mesh;

		for (size_t t = 0; t < m->n; t++)
			if (!ts_mesh_is_removed(m, t) &&
			    (!s->region || ts_region_contains(s->region, m->centre[t])))
				add_facet(text, m, t);
	}
	ts_str_add(text, "endsolid LIGGGHTS_STL_EXPORT\n");
	return ts_dump_mesh_end(self, sim);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;

	return ts_dump_price_frame(self, sim, 60 + 220 * (double)ts_dump_mesh_triangles(&s->mesh), report);
}

static const struct ts_arg args[] = {
	TS_DUMP_MESH_ARGS(struct state, "*.stl",
			  "ids of `fix mesh/surface`, else all meshes; `region ID`: only triangles with "
			  "their centre in it; local, owned and all are accepted, ghost writes none"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_MESH_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_mesh_stl)
const struct ts_style ts_dump_mesh_stl = {
	.name = "mesh/stl",
	.kind = TS_KIND_DUMP,
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Meshes at their present position, as STL (text)",
	.doc = "Writes one file per frame, with one solid that contains all triangles, mesh after mesh; "
	       "coordinates have six digits, as in LIGGGHTS. `stl` is another name of this style.",
	.example = "dump walls all mesh/stl 300 post/walls*.stl\n"
		   "dump mill all mesh/stl 300 post/mill*.stl lifters drum region half",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_mesh_fini,
};
