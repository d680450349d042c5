/* Triangles as listed in a file, without connectivity ("triangle soup"). */
#ifndef TS_GEOM_TRIANGLES_H
#define TS_GEOM_TRIANGLES_H

#include <stddef.h>

#include "base/alloc.h"

struct ts_triangle {
	double v[3][3];	   /* corners, length; their order gives the normal by the right-hand rule */
	const char *solid; /* name of the part of the file that contains it; "": none */
	int line;	   /* line of the file; 0: binary file */
};

/* Zero-initialise. The strings are owned by the string pool given to the reader. */
struct ts_triangles {
	size_t n, capacity;
	struct ts_triangle *t;
	const char *file;
};

enum ts_status ts_triangles_add(struct ts_triangles *soup, const struct ts_triangle *t);
/* Corners nearer to each other than this length are taken for one: a fraction of the size of the mesh, as is the rounding
 * of files in single precision. */
double ts_triangles_precision(const struct ts_triangles *soup);
void ts_triangles_release(struct ts_triangles *soup);

#endif
