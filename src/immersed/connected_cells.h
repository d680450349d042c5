/* Sets of cells that are connected through faces which no body covers.
 *
 * The cells of a row along x are divided into runs, within which no face is covered; runs of neighbouring rows that share a
 * face which is not covered are united (connected components by run-length labelling; union-find with path halving,
 * Tarjan & van Leeuwen, J. ACM 31 (1984) 245). The time is of the order of rows and covered faces. */
#ifndef TS_IMMERSED_CONNECTED_CELLS_H
#define TS_IMMERSED_CONNECTED_CELLS_H

#include <stdint.h>

#include "grid/grid.h"

/* Of lower faces across each axis, indexed like fields: the body that covers the face, from 1; 0: none. */
typedef uint16_t *ts_face_owners[3];

struct ts_connected_cells {
	const struct ts_grid *grid;
	size_t *row;	/* first run of each row j + k n[1], and the number of runs + 1 */
	int32_t *begin; /* first cell of each run; run 0 stands for the outside */
	size_t *set;	/* of each run: the first run of its set, 0: connected to the outside */
	size_t nruns, begin_capacity, set_capacity;
};

/* Finds the runs, and unites them through faces inside the grid and across periodic boundaries; no set is connected to the
 * outside yet. Returns TS_OK or TS_NOMEM. Released by ts_connected_cells_release, also after TS_NOMEM. */
enum ts_status ts_connected_cells_find(struct ts_connected_cells *cells, const struct ts_grid *grid,
				       const ts_face_owners owner);
void ts_connected_cells_release(struct ts_connected_cells *cells);

/* Connects all cells with a face on this boundary that is not covered to the outside. */
void ts_connected_cells_open_face(struct ts_connected_cells *cells, const ts_face_owners owner, int d,
				  enum ts_grid_side side);

/* Sets `set` of all runs to the first run of their set. To be called last, before ts_connected_cells_run is used. */
void ts_connected_cells_complete(struct ts_connected_cells *cells);

/* The run that contains a cell. */
size_t ts_connected_cells_run(const struct ts_connected_cells *cells, const int i[3]);

#endif
