/* Averages chunk by chunk: what fixes ave/chunk and ave/spatial share. */
#ifndef TS_AVERAGE_CHUNK_AVERAGE_H
#define TS_AVERAGE_CHUNK_AVERAGE_H

#include "average/average.h"
#include "average/average_file.h"
#include "average/chunk.h"

struct ts_chunk_column;
struct ts_chunk_average;

/* Sorts the particles into chunks for a sample. */
typedef enum ts_status ts_chunk_source(struct ts_instance *self, struct tsim *sim,
				       enum ts_chunk_moment moment, struct ts_chunks **chunks);

/* First member of the state. */
struct ts_chunk_average {
	struct ts_average average;
	struct ts_average_file file;
	struct ts_words words; /* of the values */
	int norm;
	double adof, cdof;
	ts_chunk_source *source; /* set by the style before init */
	bool spatial;		 /* titles and rows as LIGGGHTS and older LAMMPS write them */

	struct ts_chunk_column *column;
	size_t ncolumns;
	struct ts_table each, one, sums;
	int64_t ncoordinates, compressed; /* saved, with `place`: coordinates of each chunk and, with
					   * compress, its number before that */
	double *place;
	size_t place_n, place_capacity;
};
#define TS_CHUNK_AVERAGE_KEYWORDS(T)                                                               \
	TS_ENUM("norm", T, common.norm, ts_chunk_norms, .flags = TS_STATEFUL, .fallback = "all",   \
		.help = "whether sums are divided by the particles of all samples together, of "   \
			"each sample, or by the samples only"),                                    \
		TS_REAL("adof", T, common.adof, .flags = TS_OPTIONAL | TS_STATEFUL, .unit = "",    \
			.help = "for temp: degrees of freedom of a particle; else the dimension"), \
		TS_REAL("cdof", T, common.cdof, .flags = TS_STATEFUL, .unit = "", .fallback = "0", \
			.help = "for temp: degrees of freedom of a chunk besides; < 0 takes off")
#define TS_CHUNK_AVERAGE_SAVED(T) TS_SAVE_I64(T, common.ncoordinates), TS_SAVE_I64(T, common.compressed)
extern const char *const ts_chunk_norms[];
extern const struct ts_value ts_chunk_average_values[];

enum ts_status ts_chunk_average_init(struct ts_instance *self, struct tsim *sim);
/* For SETUP, and for END_OF_STEP. */
enum ts_status ts_chunk_average_setup(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_chunk_average_sample(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_chunk_average_archive(struct ts_instance *self, struct tsim *sim,
					struct ts_archive *archive);
void ts_chunk_average_fini(struct ts_instance *self);

#endif
