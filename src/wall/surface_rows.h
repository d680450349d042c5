/* Numbers of the elements of a surface that have been touched: a row for each of them, in the order of the first
 * touch. Elements that no particle has touched take no time and no memory but a number of 4 bytes. */
#ifndef TS_WALL_SURFACE_ROWS_H
#define TS_WALL_SURFACE_ROWS_H

#include "wall/surface.h"

struct ts_surface_rows {
	size_t elements;  /* of the surface */
	int32_t *row;	  /* [elements] 1 + number of its row; 0: never touched */
	int32_t *touched; /* [n] element of each row */
	double *data;	  /* [n * width] */
	size_t n, width, row_capacity, touched_capacity, data_capacity;
};

/* In the init of a style: for this surface; fails if rows exist already and the surface has another number of
 * elements now. `place`: of the word that names the surface. */
enum ts_status ts_surface_rows_init(struct tsim *sim, struct ts_surface_rows *rows,
				    const struct ts_surface *surface, size_t width,
				    const struct ts_place *place);
/* The numbers of an element, all 0 when it is touched for the first time; valid until the next call. */
enum ts_status ts_surface_rows_at(struct tsim *sim, struct ts_surface_rows *rows, size_t element,
				  double **out);
/* Fields `touched` and `sums`. */
enum ts_status ts_surface_rows_archive(struct tsim *sim, struct ts_surface_rows *rows,
				       struct ts_archive *archive);
void ts_surface_rows_release(struct ts_surface_rows *rows);

#endif
