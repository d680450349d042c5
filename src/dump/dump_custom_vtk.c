/* Dump custom/vtk: particles as points for ParaView. */
#include "box/domain.h"
#include "core/sim.h"
#include "dump/dump_vtk.h"
#include "io/series.h"
#include "io/vtk_legacy.h"
#include "particle/particles.h"

#include <string.h>

#include "base/banned.h"

struct state {
	struct ts_dump_vtk vtk;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_dump_vtk_init(self, sim, false);
}

static enum ts_status fill_points(struct ts_dump_vtk *s, struct tsim *sim)
{
	if (ts_table_resize(&s->points, s->common.nrows, 3) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t row = 0; row < s->common.nrows; row++)
		for (size_t d = 0; d < 3; d++)
			s->points.data[3 * row + d] = sim->particles->x[s->common.order[row]][d];
	return TS_OK;
}

/* Writes the simulation box to a file of its own, named as by LIGGGHTS: for post/a*.vtk
 * post/aboundingBox_STEP.vtk, for post/a.vtk post/a_boundingBox.vtk. */
static enum ts_status write_box(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;
	const char *star = strchr(d->file, '*');
	struct ts_str name = { 0 }, text = { 0 };
	enum ts_status status;

	if (!ts_ends_with(d->file, ".vtk"))
		return TS_OK;
	ts_str_add_n(&name, d->file, star ? (size_t)(star - d->file) : strlen(d->file) - strlen(".vtk"));
	if (star)
		ts_str_addf(&name, "boundingBox_%s", star);
	else
		ts_str_add(&name, "_boundingBox.vtk");
	ts_series_path(&d->path, ts_str_text(&name), (long long)sim->clock.step, (int)d->pad);
	ts_vtk_legacy_box(&text, sim->domain->box.lo, sim->domain->box.hi, ts_sim_time(sim), d->binary);
	status = name.failed || d->path.failed
			 ? ts_nomem(&sim->error)
			 : ts_vtk_write_text(sim, ts_str_text(&d->path), &self->where, &text);
	ts_str_release(&name);
	ts_str_release(&text);
	return status;
}

static enum ts_status fill_points_and_write_box(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(fill_points(self->state, sim));
	return write_box(self, sim);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	return ts_dump_vtk_frame(self, sim, false, fill_points_and_write_box);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return ts_dump_price(self, sim, false, true, report);
}

static const struct ts_arg args[] = {
	TS_DUMP_VTK_ARGS(struct state,
			 "quantities: id, type, vx, vy, vz, radius ..., c_ID[k], f_ID[k], v_NAME"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_custom_vtk)
const struct ts_style ts_dump_custom_vtk = {
	.name = "custom/vtk",
	.kind = TS_KIND_DUMP,
	.dump_words = TS_DUMP_SELECTION " refresh binary append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Particles as points with quantities for ParaView",
	.doc = "Writes one file per frame; the ending of its name selects the format. .vtp: compressed VTK "
	       "XML (PolyData), recommended; .vtu: the same as UnstructuredGrid; .vtk: the legacy format as "
	       "text, with `dump_modify binary yes` as binary; .pvtp, .pvtu: a list of pieces, with one "
	       "piece; .vtkhdf: all frames in one HDF5 file, see below. A collection, named like the frames "
	       "without the `*` and ending in .pvd (for .vtk in .vtk.series), lists the frames with their "
	       "times; open this file in ParaView. It is replaced by renaming, so that it is complete at any "
	       "time. With .vtk the simulation box is written to a file with boundingBox_ before the step, "
	       "as in LIGGGHTS.\n\n"
	       "Positions are always written; a column that is named twice is written once. Components are "
	       "merged into vectors: vx vy vz into v, fx fy fz into f, three columns c_ID[1] c_ID[2] c_ID[3] "
	       "into c_ID[1-3]. The order of the arrays is that of LIGGGHTS, not that of the command: id, "
	       "type, mass, v, f, radius, omega and so on, then c_, f_ and v_ in the order of the command. A "
	       "variable v_NAME is written as NAME.\n\n"
	       "Files .vtk are of version 5.1, the format of VTK 9 (ParaView 5.9). They equal those of "
	       "LIGGGHTS byte for byte, except for the title, which contains the time, and for positions, "
	       "which are in double precision; with `legacy yes` in single precision as in LIGGGHTS.\n\n"
	       "NAME.vtkhdf (VTKHDF 2.0, UnstructuredGrid) has no `*` in its name: each frame is added to "
	       "the file, which ParaView from version 5.12 on opens as a series with its times. It is closed "
	       "after each frame: a run that is killed or fills the disk leaves all frames before. A "
	       "continued run adds to it and replaces frames of the present step and later ones; "
	       "`dump_modify append yes` adds to the file of another run, whose frames have the same "
	       "quantities. Its data set /tsim/step has the steps. Older ParaView shows all frames at once. "
	       "tsim must have been built with the HDF5 library (libhdf5-dev).",
	.example = "dump rock all custom/vtk 1000 post/rock*.vtp id type x y z vx vy vz radius\n"
		   "dump old all custom/vtk 1000 post/old*.vtk id type radius\n"
		   "dump one all custom/vtk 1000 post/rock.vtkhdf id type vx vy vz radius",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_vtk_fini,
};
