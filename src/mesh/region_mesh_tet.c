/* Region: the tetrahedra of a file. */
#include "mesh/cell_region.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_cell_region_init(self, sim, 10);
}

static const struct ts_arg args[] = {
	TS_CELL_REGION_ARGS,
	TS_ARGS_END,
};

TS_STYLE(region, ts_region_style, ts_region_mesh_tet)
const struct ts_region_style ts_region_mesh_tet = {
	.style = {
		.name = "mesh/tet",
		.kind = TS_KIND_REGION,
	.ranks = TS_RANKS_WHOLE,
		.summary = "The tetrahedra of a VTK file",
		.doc = "All points in the tetrahedra of a legacy VTK file (text or binary). The file must contain no other solid cells; points, lines and surface cells are ignored. Points that lie exactly in a face do not belong to the cell.\n\n"
			"The coordinates of the file are first shifted (`move`), then scaled, then rotated about the axes x, y and z through the origin. The volume of the region is the sum of the volumes of the cells.",
		.example = "region part mesh/tet file part.vtk scale 0.001 move 0 0 0 rotate 0 0 0 units box",
		.args = args,
		.state_size = sizeof(struct ts_cell_region),
		.init = init,
		.fini = ts_cell_region_fini,
	},
	.contains = ts_cell_region_contains,
	.bounds = ts_cell_region_bounds,
	.volume = ts_cell_region_volume,
	.depth = ts_cell_region_depth,
};
