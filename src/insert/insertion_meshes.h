/* Meshes that new particles must not touch: keyword avoid_meshes of fix insert/pack and insert/rate/region. */
#ifndef TS_INSERT_INSERTION_MESHES_H
#define TS_INSERT_INSERTION_MESHES_H

#include "core/sim.h"
#include "mesh/mesh_tree.h"

/* The meshes at their present positions. Zero-initialise. */
struct ts_insertion_meshes {
	struct ts_insertion_mesh {
		const struct ts_mesh *mesh;
		struct ts_mesh_tree tree;
	} * item;
	size_t n;
	struct ts_mesh_list near; /* buffer */
};
/* Fails if one of the IDs is not that of a mesh. */
enum ts_status ts_insertion_meshes_check(struct tsim *sim, const struct ts_words *ids);
enum ts_status ts_insertion_meshes_start(struct ts_insertion_meshes *m, struct tsim *sim,
					 const struct ts_words *ids);
/* Whether a sphere touches one of them, or a periodic image of them. */
enum ts_status ts_insertion_meshes_touch(struct ts_insertion_meshes *m, struct tsim *sim, const double x[3],
					 double radius, bool *touches);
void ts_insertion_meshes_release(struct ts_insertion_meshes *m);

#endif
