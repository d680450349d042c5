/* Voxel height fields by name, as defined by `fix surface/voxel`. Styles that need one (walls, dumps, wear) find it
 * by the ID of its fix in init, as meshes (mesh/mesh_surface.h). */
#ifndef TS_VOXEL_VOXEL_SURFACE_H
#define TS_VOXEL_VOXEL_SURFACE_H

#include "core/sim.h"
#include "voxel/voxel_field.h"

#define TS_FAMILY_VOXEL "voxel surface"

/* First member of the state of every style of TS_FAMILY_VOXEL. */
struct ts_voxel_surface {
	struct ts_voxel_field field; /* at its reference position */
	double *original;	     /* heights before recession, [n[1]][n[0]]; NULL: there is none */
	int64_t type;		     /* particle type whose material it has */
	bool merges;		     /* contact points within one contact area are one contact */
	double temperature;	     /* for fix heat/gran; NaN: it conducts no heat */
	double winkler;		     /* stiffness of the columns, pressure/length; NaN: they are rigid */
	double shift[3];	     /* displacement from the reference position, length */
	double velocity[3];	     /* of the surface */
	/* upper bound of the displacement since the last rebuild, length; infinite: columns have grown */
	double travelled;
	double moved[3], step; /* displacement in the last step and its length, length */
};

/* Sets the height of column i, j during a run. */
static inline void ts_voxel_surface_set_height(struct ts_voxel_surface *s, int64_t i, int64_t j,
					       double height)
{
	if (height > ts_voxel_heights(&s->field)[j * s->field.n[0] + i])
		s->travelled = INFINITY; /* walls list particles near the surface anew */
	ts_voxel_set_height(&s->field, i, j, height);
}

/* Returns the surface of this ID; fails with an error at the word, and a suggestion, if there is none. */
enum ts_status ts_voxel_surface_require(struct tsim *sim, const struct ts_word *id,
					struct ts_voxel_surface **out);
/* Iterates over all of them in script order: start with *k = 0; returns NULL at the end. *by is its fix; `by`
 * may be NULL. */
struct ts_voxel_surface *ts_voxel_surface_next(const struct tsim *sim, size_t *k, struct ts_instance **by);

#endif
