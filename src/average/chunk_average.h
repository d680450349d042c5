/* Averages over chunks and over time: shared by fix ave/chunk and fix ave/spatial. */
#ifndef TS_AVERAGE_CHUNK_AVERAGE_H
#define TS_AVERAGE_CHUNK_AVERAGE_H

#include "average/average.h"
#include "average/average_file.h"
#include "average/chunk.h"

struct ts_chunk_column;
struct ts_chunk_average;

/* Finds the chunks of the average, and their owner. */
typedef enum ts_status ts_chunk_source(struct ts_instance *self, struct tsim *sim, struct ts_instance **owner,
				       struct ts_chunks **chunks);

/* First member of the state. */
struct ts_chunk_average {
	struct ts_average average;
	struct ts_average_file file;
	struct ts_words words;	 /* the values as given */
	int norm;		 /* index of ts_chunk_norms */
	double adof, cdof;	 /* degrees of freedom of a particle (NaN: the dimension), of a chunk */
	ts_chunk_source *source; /* set by the style before init */
	bool spatial;		 /* file in the format of fix ave/spatial, else of fix ave/chunk */

	struct ts_chunk_column *column; /* [ncolumns] the values */
	size_t ncolumns;
	struct ts_table peratom; /* [particle][ncolumns] numbers to be summed */
	struct ts_table one;	 /* [particle] of one value */
	struct ts_table sums;	 /* [chunk][1 + ncolumns] particle count and sums of one sample */
	/* state, written to restart files */
	int64_t ncoordinates, compressed; /* coordinates of a chunk; 1: with `compress yes` */
	double *place; /* [chunk][compressed + ncoordinates] original number, coordinates */
	size_t place_n, place_capacity;
};
#define TS_CHUNK_AVERAGE_KEYWORDS(T)                                                               \
	TS_ENUM("norm", T, common.norm, ts_chunk_norms, .flags = TS_STATEFUL, .fallback = "all",   \
		.help = "divisor of sums: number of particles in all samples (all), in each "      \
			"sample (sample), or number of samples (none)"),                           \
		TS_REAL("adof", T, common.adof, .flags = TS_OPTIONAL | TS_STATEFUL, .unit = "",    \
			.help = "for temp: degrees of freedom per particle; default: the "         \
				"dimension"),                                                      \
		TS_REAL("cdof", T, common.cdof, .flags = TS_STATEFUL, .unit = "", .fallback = "0", \
			.help = "for temp: degrees of freedom added per chunk; may be negative")
#define TS_CHUNK_AVERAGE_SAVED(T) TS_SAVE_I64(T, common.ncoordinates), TS_SAVE_I64(T, common.compressed)
extern const char *const ts_chunk_norms[];
extern const struct ts_value ts_chunk_average_values[];

enum ts_status ts_chunk_average_init(struct ts_instance *self, struct tsim *sim);
/* Stage functions for SETUP and END_OF_STEP. */
enum ts_status ts_chunk_average_setup(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_chunk_average_sample(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_chunk_average_archive(struct ts_instance *self, struct tsim *sim,
					struct ts_archive *archive);
void ts_chunk_average_fini(struct ts_instance *self);

#endif
