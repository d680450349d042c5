/* Cartesian grids as XML files for VTK. */
#include "base/axes.h"
#include "io/vtk_xml.h"

#include "base/banned.h"

/* Adds Name="0 nx 0 ny 0 nz": indices of points, one more than cells along each axis. */
static void add_extent(struct ts_str *out, const char *name, const struct ts_vtk_grid *grid)
{
	ts_str_addf(out, " %s=\"0 %zu 0 %zu 0 %zu\"", name, grid->n[0], grid->n[1], grid->n[2]);
}

static void add_three(struct ts_str *out, const char *name, const double x[3])
{
	ts_str_addf(out, " %s=\"%.17g %.17g %.17g\"", name, x[0], x[1], x[2]);
}

static void add_head(struct ts_str *out, const struct ts_vtk_grid *grid, bool image)
{
	const char *type = image ? "ImageData" : "RectilinearGrid";
	double low[3], width[3];

	ts_vtk_add_opening(out, type);
	ts_str_addf(out, "<%s", type);
	add_extent(out, "WholeExtent", grid);
	for (int d = 0; d < 3; d++) {
		low[d] = grid->face[d][0];
		width[d] = (grid->face[d][grid->n[d]] - low[d]) / (double)grid->n[d];
	}
	if (image) {
		add_three(out, "Origin", low);
		add_three(out, "Spacing", width);
	}
	ts_str_add(out, ">\n");
	ts_vtk_add_time(out, grid->time);
	ts_str_add(out, "<Piece");
	add_extent(out, "Extent", grid);
	ts_str_add(out, ">\n");
}

static enum ts_status add_coordinates(struct tsim *sim, struct ts_str *out, const struct ts_vtk_grid *grid)
{
	ts_str_add(out, "<Coordinates>\n");
	for (int d = 0; d < 3; d++)
		TS_TRY(ts_vtk_add_array(sim, out, ts_axis_names[d], "Float64", 1, grid->face[d],
					grid->n[d] + 1));
	ts_str_add(out, "</Coordinates>\n");
	return TS_OK;
}

static enum ts_status add_grid(struct tsim *sim, struct ts_str *out, const struct ts_vtk_grid *grid,
			       bool image)
{
	add_head(out, grid, image);
	TS_TRY(ts_vtk_add_data(sim, out, "CellData", grid->cell_data, grid->ncell_data,
			       grid->n[0] * grid->n[1] * grid->n[2]));
	if (!image)
		TS_TRY(add_coordinates(sim, out, grid));
	ts_str_addf(out, "</Piece>\n</%s>\n</VTKFile>\n", image ? "ImageData" : "RectilinearGrid");
	return out->failed ? ts_nomem(&sim->error) : TS_OK;
}

enum ts_status ts_vtk_write_grid(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_grid *grid)
{
	struct ts_str text = { 0 };
	enum ts_status status = add_grid(sim, &text, grid, ts_ends_with(path, ".vti"));

	if (status == TS_OK)
		status = ts_vtk_write_text(sim, path, where, &text);
	ts_str_release(&text);
	return status;
}
