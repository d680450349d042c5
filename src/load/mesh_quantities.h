/* Quantities of the triangles of a mesh by name, for files and pictures. */
#ifndef TS_LOAD_MESH_QUANTITIES_H
#define TS_LOAD_MESH_QUANTITIES_H

#include "load/mesh_stress.h"
#include "mesh/mesh_surface.h"

struct ts_mesh_quantity {
	const char *word, *name; /* keyword of dump mesh/vtk; name of the array */
	int components;
	bool integer;
	/* Stores a scalar or vector of triangle t, or of one of its corners 0 .. 2 (-1: of the triangle as a whole). */
	void (*get)(const struct ts_mesh_surface *s, size_t t, int corner, double out[3]);
	bool (*of)(const struct ts_mesh_surface *s); /* whether the mesh has it; NULL: all have */
};
/* In the order in which they are written; the velocity comes first with `output interpolate`. */
enum { TS_MESH_QUANTITIES = 13, TS_MESH_VELOCITY = TS_MESH_QUANTITIES - 1 };
extern const struct ts_mesh_quantity ts_mesh_quantities[TS_MESH_QUANTITIES];

/* The quantity with this word or name, of vectors their size, of all triangles; false: the mesh does not have it. */
bool ts_mesh_quantity_sizes(const struct ts_mesh_surface *s, const char *name, double *out);

#endif
