/* Where the bins of chunks lie: between average/chunk.c and chunk_bins.c. */
#ifndef TS_AVERAGE_CHUNK_BINS_H
#define TS_AVERAGE_CHUNK_BINS_H

#include "average/chunk.h"

/* Lays the bins into the box as it is now, and counts them. */
enum ts_status ts_chunk_bins_place(const struct ts_instance *self, struct ts_chunks *chunks);
/* The bin of a point, from 1; 0: none. */
int64_t ts_chunk_bin_of(const struct ts_chunks *chunks, const double x[3]);

#endif
