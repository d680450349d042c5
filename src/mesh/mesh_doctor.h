/* Examination of a mesh: kinds of faults, the triangles that have them, and remedies. */
#ifndef TS_MESH_MESH_DOCTOR_H
#define TS_MESH_MESH_DOCTOR_H

#include "mesh/mesh.h"

/* Limits of the smallest angle of a triangle in degrees: below the first its plane is undefined by
 * rounding, below the second it is reported. */
#define TS_MESH_HARD_ANGLE 0.0181185
#define TS_MESH_SOFT_ANGLE 0.5

/* name, description, unit of the amount ("": none), remedy */
#define TS_MESH_FAULT_LIST(X)                                                                      \
	X(COLLAPSED, "has two corners at the same place and is left out", "",                      \
	  "take a smaller `precision`, or export the surface with more digits")                    \
	X(NEEDLE, "has hardly any area: its smallest angle is below 0.0181185 degrees", "degrees", \
	  "remesh this part, or remove the triangle")                                              \
	X(SHARP, "has an angle smaller than `curvature`", "degrees",                               \
	  "remesh this part, reduce `curvature`, or set `curvature_tolerant yes`")                 \
	X(SLIVER, "has an angle below 0.5 degrees", "degrees", "remesh this part")                 \
	X(DUPLICATE, "has the same corners as another", "",                                        \
	  "remove it, or set `heal auto_remove_duplicates`")                                       \
	X(CROWDED, "shares its edges with more than 5 others", "neighbours",                       \
	  "remove walls inside of the surface")                                                    \
	X(FOLDED, "overlaps a neighbour in the same plane", "", "remove the part that overlaps")   \
	X(BRANCHED, "has an edge that more than two triangles share", "triangles",                 \
	  "remove walls inside of the surface, if there should be none")                           \
	X(FLIPPED, "has its normal opposite to those of its neighbours", "",                       \
	  "reverse the order of its corners if the side matters (stress, insertion, counting)")    \
	X(CRACKED, "nearly touches the edge of another, without a corner there", "wide",           \
	  "join the corners, or take a larger `precision`")                                        \
	X(OPEN, "has an edge without neighbour", "", "none needed if the surface has a rim there")

#define TS_MESH_FAULT_ENUM(name, what, unit, remedy) TS_MESH_##name,
enum ts_mesh_fault { TS_MESH_FAULT_LIST(TS_MESH_FAULT_ENUM) TS_NMESH_FAULTS };
#undef TS_MESH_FAULT_ENUM

struct ts_mesh_finding {
	enum ts_mesh_fault fault;
	int32_t triangle, other; /* `other`: the second triangle of the fault; -1: none */
	double at[3];		 /* position, length */
	double amount;		 /* angle in degrees, number of triangles, or width of the crack, length */
};

/* Zero-initialise. Sorted by fault, then triangle; at most one finding for each triangle and fault. */
struct ts_mesh_findings {
	size_t n, capacity;
	struct ts_mesh_finding *list;
	size_t count[TS_NMESH_FAULTS];
};

/* Examines a mesh; `curvature` in degrees, as in ts_mesh_build. */
enum ts_status ts_mesh_examine(const struct ts_mesh *mesh, double curvature, struct ts_mesh_findings *out);
void ts_mesh_findings_release(struct ts_mesh_findings *findings);

struct ts_mesh_fault_text {
	const char *what, *unit, *remedy;
};
extern const struct ts_mesh_fault_text ts_mesh_fault_texts[TS_NMESH_FAULTS];

/* Volume of a closed mesh by the divergence theorem, positive if the normals point outwards. */
double ts_mesh_volume(const struct ts_mesh *mesh);

#endif
