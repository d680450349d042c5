/* Regions that are the union of the tetrahedra or hexahedra of a VTK file. */
#ifndef TS_MESH_CELL_REGION_H
#define TS_MESH_CELL_REGION_H

#include "mesh/cell_surface.h"
#include "region/region.h"

struct ts_cell_region_tet {
	double x[4][3]; /* corners, length */
};

/* State of these region styles. */
struct ts_cell_region {
	struct ts_region region;
	const char *file;
	double factor, offset[3], angle[3]; /* scale; move, length; rotate, degrees */

	struct ts_cell_region_tet *tet;
	size_t n, capacity;
	bool closed; /* points in the faces of a tetrahedron belong to it; else not, as in LIGGGHTS */
	double lo[3], hi[3], volume; /* bounding box; sum of the volumes of all cells */
	/* search grid over lo..hi: cell c has the tetrahedra item[start[c]] .. item[start[c + 1] - 1] */
	int grid[3];	 /* number of grid cells in each dimension */
	uint32_t *start; /* [grid cells + 1] */
	int32_t *item;
	struct ts_cell_surface surface;
};

#define TS_CELL_REGION_ARGS                                                                                  \
	TS_WORD("file", struct ts_cell_region, file, .help = "legacy VTK file with the cells"),              \
		TS_REAL("scale", struct ts_cell_region, factor, .fallback = "1", .range = TS_POSITIVE,       \
			.help = "factor of all coordinates, applied after the shift"),                       \
		TS_VEC3("move", struct ts_cell_region, offset, .fallback = "0 0 0", .unit = "length",        \
			.help = "shift, applied first"),                                                     \
		TS_VEC3("rotate", struct ts_cell_region, angle, .fallback = "0 0 0", .unit = "degrees",      \
			.help = "angles of rotation about the axes x, then y, then z, applied after scale"), \
		TS_REGION_SIDE_ARGS(struct ts_cell_region)

/* `shape`: VTK cell type, 10 tetrahedra, 12 hexahedra. */
enum ts_status ts_cell_region_init(struct ts_instance *self, struct tsim *sim, int shape);
bool ts_cell_region_contains(const struct ts_instance *self, const double x[3]);
void ts_cell_region_bounds(const struct ts_instance *self, double lo[3], double hi[3]);
/* Distance from the surface, < 0 outside; if cells overlap, a bound nearer to 0. */
double ts_cell_region_depth(const struct ts_instance *self, const double x[3]);
double ts_cell_region_volume(const struct ts_instance *self);
void ts_cell_region_fini(struct ts_instance *self);

#endif
