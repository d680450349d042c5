/* Positions of spatial bins; used by average/chunk.c. */
#ifndef TS_AVERAGE_CHUNK_BINS_H
#define TS_AVERAGE_CHUNK_BINS_H

#include "average/chunk.h"

/* Places the bins in the current box: sets lo, width and n of the axes and the number of chunks. */
enum ts_status ts_chunk_bins_place(const struct ts_instance *self, struct ts_chunks *chunks);
/* Number of the bin that contains the point, from 1; 0: none. */
int64_t ts_chunk_bin_of(const struct ts_chunks *chunks, const double x[3]);

#endif
