/* Search of the triangles near each particle.
 *
 * Particles that follow each other in memory and are near each other are a tile. For each mesh, and each periodic image of one,
 * the tree is searched once for the tile, and each of its particles is compared with what is there. */
#ifndef TS_WALL_MESH_WALL_SEARCH_H
#define TS_WALL_MESH_WALL_SEARCH_H

#include "wall/mesh_wall.h"

/* A triangle near particle i. */
struct ts_mesh_found {
	size_t i;
	int32_t mesh, triangle;
	int shift[3];	 /* periodic image of the mesh, in box lengths */
	double distance; /* from the centre of the particle, length */
};

/* A mesh, or a periodic image of it, that is near a tile. */
struct ts_mesh_image {
	int32_t mesh;
	int shift[3];			/* in box lengths */
	struct ts_mesh_vicinity nearby; /* relative to the mesh itself */
};

/* Result of one thread: triangles near its particles, in the order of particles, meshes, images and triangles. Each begins on
 * a cache line of its own, since threads write their numbers all the time. */
struct ts_mesh_found_part {
	_Alignas(TS_CACHE_LINE) struct ts_mesh_found *found;
	size_t n, capacity;
	struct ts_mesh_image *image; /* of the present tile */
	size_t images, image_capacity;
	struct ts_mesh_list list;
	bool failed; /* out of memory */
};

struct ts_mesh_wall_search {
	struct ts_mesh_found_part *part;
	size_t parts;
};

/* Searches for all particles that the wall lists; to be released also where it fails. */
enum ts_status ts_mesh_wall_search(struct ts_instance *self, struct tsim *sim,
				   struct ts_mesh_wall_search *search);
void ts_mesh_wall_search_release(struct ts_mesh_wall_search *search);

#endif
