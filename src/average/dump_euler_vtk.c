/* Dump euler/vtk: the cells of fix ave/euler as points for ParaView. */
#include "average/euler.h"
#include "core/sim.h"
#include "dump/dump_vtk.h"

#include "base/banned.h"

enum { NARRAYS = 7 };

struct state {
	struct ts_dump_vtk vtk;
	const char *fix;
	const struct ts_instance *owner;
	struct ts_vtk_array array[NARRAYS];
};

/* Without an id in the script: the first fix ave/euler, as in LIGGGHTS. */
static enum ts_status find_owner(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_instance *inst;

	s->owner = NULL;
	for (size_t k = 0; !s->owner && (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_EULER, &k));)
		if (!s->fix || ts_streq(inst->id, s->fix))
			s->owner = inst;
	if (s->owner)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, s->fix ? ts_instance_word(self, s->fix) : &self->where,
		       "dump euler/vtk needs a fix ave/euler%s%s", s->fix ? ", and there is none of id " : "",
		       s->fix ? s->fix : "");
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_dump_vtk_check_name(self, sim));
	return find_owner(self, sim);
}

static void fill_arrays(struct state *s, const struct ts_euler *euler)
{
	static const struct {
		const char *name;
		int column;
		size_t components;
	} what[NARRAYS] = {
		{ "v_avg", TS_EULER_V, 3 },	  { "volumefraction", TS_EULER_FRACTION, 1 },
		{ "radius", TS_EULER_RADIUS, 1 }, { "pressure", TS_EULER_PRESSURE, 1 },
		{ "count", TS_EULER_COUNT, 1 },	  { "mass", TS_EULER_MASS, 1 },
		{ "stress", TS_EULER_STRESS, 6 },
	};
	double *to = s->vtk.merged.data, *point = s->vtk.points.data;

	for (size_t c = 0; c < euler->ncells; c++)
		for (int d = 0; d < 3; d++)
			*point++ = euler->cell[c * TS_EULER_COLUMNS + TS_EULER_X + (size_t)d];
	for (int k = 0; k < NARRAYS; k++) {
		s->array[k] = (struct ts_vtk_array){ what[k].name, to, what[k].components, false, false };
		for (size_t c = 0; c < euler->ncells; c++)
			for (size_t j = 0; j < what[k].components; j++)
				*to++ = euler->cell[c * TS_EULER_COLUMNS + (size_t)what[k].column + j];
	}
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_euler *euler = s->owner->state;
	struct ts_vtk_poly poly = { .point_data = s->array, .npoint_data = NARRAYS, .plain = true };
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	if (ts_table_resize(&s->vtk.points, euler->ncells, 3) != TS_OK ||
	    ts_table_resize(&s->vtk.merged, euler->ncells, TS_EULER_COLUMNS) != TS_OK)
		return ts_nomem(&sim->error);
	fill_arrays(s, euler);
	poly.points = s->vtk.points.data;
	poly.npoints = euler->ncells;
	return ts_dump_vtk_write(self, sim, &poly);
}

static const struct ts_arg args[] = {
	TS_DUMP_VTK_FILE_ARGS(struct state),
	TS_WORD("fix", struct state, fix, .flags = TS_POSITIONAL | TS_OPTIONAL,
		.help = "ID of the fix ave/euler; default: the first one"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_euler_vtk)
const struct ts_style ts_dump_euler_vtk = {
	.name = "euler/vtk",
	.kind = TS_KIND_DUMP,
	.dump_words = "binary append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "The cells of fix ave/euler as points for ParaView",
	.doc = "Writes a point at the centre of each cell of fix ave/euler with the values of its last "
	       "evaluation: v_avg, volumefraction, radius, pressure, count, mass, and stress (xx yy zz xy xz "
	       "yz). File formats are those of dump custom/vtk; text files .vtk are of version 2.0, with "
	       "SCALARS and VECTORS as LIGGGHTS writes them.",
	.example = "fix cells all ave/euler nevery 1000 cell_size_relative 4 parallel no\n"
		   "dump cells all euler/vtk 1000 post/cells*.vtk",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_vtk_fini,
};
