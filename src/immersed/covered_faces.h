/* Faces of cells that a body covers: points of velocity components inside it. */
#ifndef TS_IMMERSED_COVERED_FACES_H
#define TS_IMMERSED_COVERED_FACES_H

#include "immersed/immersed.h"

struct ts_covered_face {
	size_t at;	 /* index in fields */
	double velocity; /* of the body, across the face */
};

/* Those across axis c: from first[c] to first[c + 1]. */
struct ts_covered_faces {
	struct ts_covered_face *face;
	size_t n, capacity, first[4];
};

/* Makes the list of a body, which is empty before; of this rank, if ranks have the fluid in some planes only. */
enum ts_status ts_covered_faces_find(struct ts_covered_faces *faces, const struct ts_immersed *ib);
void ts_covered_faces_release(struct ts_covered_faces *faces);

/* All ranks: the lists of `bodies` bodies of the first one get the faces of all ranks, and are empty on the others. */
enum ts_status ts_covered_faces_gather(struct ts_world *world, struct ts_covered_faces *list, size_t bodies);

#endif
