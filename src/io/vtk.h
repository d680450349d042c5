/* VTK files for ParaView. The ending of the name selects the format: .vtp XML PolyData, .vtu XML
 * UnstructuredGrid, .vtk the legacy format, .pvtp and .pvtu a list of one piece and that piece; for grids
 * .vti XML ImageData, .vtr XML RectilinearGrid. Frames are listed with their times in a collection, .pvd,
 * for legacy files .vtk.series. Layout of XML files: io/vtk_xml.h. */
#ifndef TS_IO_VTK_H
#define TS_IO_VTK_H

#include "core/sim.h"

/* A data array. */
struct ts_vtk_array {
	const char *name;
	const double *data; /* [n][components] */
	size_t components;
	bool integer; /* written as Int64, else Float64 */
};

/* Vertices (one for each point), lines (points 2k, 2k+1), or triangles (points 3k, 3k+1, 3k+2). */
struct ts_vtk_poly {
	const double *points;				   /* [npoints][3] positions (length) */
	size_t npoints, nlines, ntriangles;		   /* at most one of nlines and ntriangles is not 0 */
	const struct ts_vtk_array *point_data, *cell_data; /* [npoint_data], [ncell_data] */
	size_t npoint_data, ncell_data;
	double time;
	/* legacy files only: XML files are always binary and in double precision */
	bool binary;
	bool single_points; /* positions in single precision */
	bool plain;	    /* as ts_vtk_legacy_plain */
};
/* Number of points of a cell: vertex, line or triangle. */
static inline size_t ts_vtk_cell_size(const struct ts_vtk_poly *poly)
{
	return poly->ntriangles ? 3 : poly->nlines ? 2 : 1;
}
/* Whether the ending of the name is one that ts_vtk_write_poly supports. */
bool ts_vtk_is_supported(const char *path);
/* Writes a file, which replaces an existing one when it is complete. */
enum ts_status ts_vtk_write_text(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_str *text);
enum ts_status ts_vtk_write_poly(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_poly *poly);

/* A Cartesian grid: n[d] cells along axis d between n[d] + 1 faces; the x index of cells varies fastest. */
struct ts_vtk_grid {
	const double *face[3]; /* [n[d] + 1] coordinates (length) */
	size_t n[3];
	bool uniform;			      /* equal spacing along each axis: may be written as ImageData */
	const struct ts_vtk_array *cell_data; /* [ncell_data] */
	size_t ncell_data;
	double time;
};
/* The path ends in .vtr, or in .vti if the grid is uniform. */
enum ts_status ts_vtk_write_grid(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_grid *grid);

/* Frames written so far; zero-initialise. */
struct ts_vtk_series {
	int64_t *step; /* [n] */
	double *time;  /* [n] */
	size_t n, step_capacity, time_capacity;
};
enum ts_status ts_vtk_series_add(struct tsim *sim, struct ts_vtk_series *series, int64_t step, double time);
/* Writes the collection of all frames. `pattern` is the name of the frames with a `*` for the step. */
enum ts_status ts_vtk_series_write(struct tsim *sim, const struct ts_vtk_series *series, const char *pattern,
				   int pad, const struct ts_place *where);
enum ts_status ts_vtk_series_archive(struct ts_archive *archive, struct ts_vtk_series *series);
void ts_vtk_series_release(struct ts_vtk_series *series);

#endif
