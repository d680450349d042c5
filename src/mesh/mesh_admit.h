/* From the triangles of a file to a mesh that is suitable for walls: faulty triangles are refused or left
 * out, and reported. */
#ifndef TS_MESH_MESH_ADMIT_H
#define TS_MESH_MESH_ADMIT_H

#include "core/sim.h"
#include "mesh/mesh_doctor.h"
#include "geom/triangles.h"

struct ts_mesh_admission {
	double precision, curvature; /* see ts_mesh_build */
	bool curvature_tolerant;     /* angles of triangles below `curvature` are accepted */
	bool heal;		     /* duplicates are left out instead of refused */
	bool verbose;		     /* all faulty triangles are reported, not only the first of each fault */
	const char *exclude; /* file to which line numbers of refused triangles are written; or NULL */
};

/* Builds the mesh. Triangles that are left out are removed from the soup, too. `where`: place of error
 * messages. */
enum ts_status ts_mesh_admit(struct tsim *sim, const struct ts_place *where,
			     const struct ts_mesh_admission *how, struct ts_triangles *soup,
			     struct ts_mesh *out);

/* Removes the triangles whose first lines in the mesh file are listed in the file `path`. */
enum ts_status ts_mesh_exclude(struct tsim *sim, const struct ts_place *where, const char *path,
			       struct ts_triangles *soup);

#endif
