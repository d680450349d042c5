/* Triangles as a file lists them, a soup: which of them touch is not known yet. */
#ifndef TS_MESH_TRIANGLES_H
#define TS_MESH_TRIANGLES_H

#include <stddef.h>

#include "base/alloc.h"

struct ts_triangle {
	double v[3][3];	   /* corners; their order gives the normal by the right-hand rule */
	const char *solid; /* the part of the file it belongs to, "" without a name */
	int line;	   /* where it stands in the file; 0: the file is not text */
};

/* Zero-initialise. The texts live as long as the string pool given to the reader. */
struct ts_triangles {
	size_t n, capacity;
	struct ts_triangle *t;
	const char *file;
};

enum ts_status ts_triangles_add(struct ts_triangles *soup, const struct ts_triangle *t);
void ts_triangles_release(struct ts_triangles *soup);

#endif
