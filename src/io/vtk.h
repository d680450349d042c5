/* VTK files for ParaView. The ending of the name says what is written: .vtp XML PolyData, .vtu XML
 * UnstructuredGrid, .vtk the legacy format, .pvtp and .pvtu the list of one piece and that piece; of grids
 * .vti XML ImageData, .vtr XML RectilinearGrid. Frames over time are listed in a collection, .pvd, or for
 * legacy files .vtk.series. How XML files are laid out: io/vtk_xml.h. */
#ifndef TS_IO_VTK_H
#define TS_IO_VTK_H

#include "core/sim.h"

/* A column of numbers, interleaved if it has several components. */
struct ts_vtk_array {
	const char *name;
	const double *data; /* n * components */
	size_t components;
	bool integer; /* written as Int64, else Float64 */
};

/* Vertices (each point is one), lines of two points each: 2k, 2k+1, or triangles: 3k, 3k+1, 3k+2. */
struct ts_vtk_poly {
	const double *points;		    /* npoints * 3 */
	size_t npoints, nlines, ntriangles; /* of the last two at most one is not 0 */
	const struct ts_vtk_array *point_data, *cell_data;
	size_t npoint_data, ncell_data;
	double time;
	/* legacy files: XML files are binary, and in double precision */
	bool binary;
	bool single_points;
	bool plain; /* ts_vtk_legacy_plain */
};
/* Points of each vertex, line or triangle. */
static inline size_t ts_vtk_cell_size(const struct ts_vtk_poly *poly)
{
	return poly->ntriangles ? 3 : poly->nlines ? 2 : 1;
}
/* Whether a file of this name can be written: its ending. */
bool ts_vtk_knows(const char *path);
/* A whole file, which appears when it is complete. */
enum ts_status ts_vtk_put(struct tsim *sim, const char *path, const struct ts_place *where,
			  const struct ts_str *text);
enum ts_status ts_vtk_write_poly(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_poly *poly);

/* A Cartesian grid: n[d] cells along an axis between the n[d] + 1 faces, the x index running fastest. */
struct ts_vtk_grid {
	const double *face[3];
	size_t n[3];
	bool uniform; /* all axes: may be written as an image */
	const struct ts_vtk_array *cell_data;
	size_t ncell_data;
	double time;
};
/* The path ends in .vtr, or in .vti if the grid is uniform. */
enum ts_status ts_vtk_write_grid(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_grid *grid);

/* The frames written so far; zero-initialise. */
struct ts_vtk_series {
	int64_t *step;
	double *time;
	size_t n, step_capacity, time_capacity;
};
enum ts_status ts_vtk_series_add(struct tsim *sim, struct ts_vtk_series *series, int64_t step, double time);
/* Writes the collection anew. `pattern` is the name of the frames with its `*`. */
enum ts_status ts_vtk_series_write(struct tsim *sim, const struct ts_vtk_series *series, const char *pattern,
				   int pad, const struct ts_place *where);
enum ts_status ts_vtk_series_archive(struct ts_archive *archive, struct ts_vtk_series *series);
void ts_vtk_series_release(struct ts_vtk_series *series);

void ts_base64(struct ts_str *out, const unsigned char *bytes, size_t n);

#endif
