/* From triangles of a file to a mesh that walls can be made of: what is broken is refused or left out,
 * and said. */
#ifndef TS_MESH_MESH_ADMIT_H
#define TS_MESH_MESH_ADMIT_H

#include "core/sim.h"
#include "mesh/mesh_doctor.h"
#include "mesh/triangles.h"

struct ts_mesh_admission {
	double precision, curvature; /* as ts_mesh_build takes them */
	bool curvature_tolerant;     /* angles below curvature are accepted */
	bool heal;		     /* duplicates are left out instead of refused */
	bool verbose;		     /* all triangles with an illness are listed, not the first only */
	const char *exclude;	     /* a file to which lines of refused triangles are written; or NULL */
};

/* Triangles that are left out are removed from the soup too. `where` is blamed. */
enum ts_status ts_mesh_admit(struct tsim *sim, const struct ts_place *where,
			     const struct ts_mesh_admission *how, struct ts_triangles *soup,
			     struct ts_mesh *out);

/* Leaves out triangles that begin in the lines which the file lists. */
enum ts_status ts_mesh_exclude(struct tsim *sim, const struct ts_place *where, const char *path,
			       struct ts_triangles *soup);

#endif
