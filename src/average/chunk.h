/* Chunks: particles sorted into bins of space, types, or by any number of theirs, so that sums and averages
 * can be taken chunk by chunk. Shared by compute chunk/atom, the computes with /chunk in their names, and the
 * fixes that average in space. */
#ifndef TS_AVERAGE_CHUNK_H
#define TS_AVERAGE_CHUNK_H

#include "core/ref_list.h"
#include "core/sim.h"

enum ts_chunk_style { TS_CHUNK_BINS, TS_CHUNK_SPHERE, TS_CHUNK_CYLINDER, TS_CHUNK_TYPE, TS_CHUNK_VALUE };
enum ts_chunk_ids { TS_CHUNK_IDS_EVERY, TS_CHUNK_IDS_ONCE, TS_CHUNK_IDS_NFREQ };
/* In the order of the words below. */
enum ts_chunk_discard { TS_DISCARD_DEFAULT, TS_DISCARD_YES, TS_DISCARD_NO, TS_DISCARD_MIXED };
enum ts_chunk_lengths { TS_LENGTHS_LATTICE, TS_LENGTHS_BOX, TS_LENGTHS_REDUCED };
enum ts_chunk_number { TS_NUMBER_DEFAULT, TS_NUMBER_ONCE, TS_NUMBER_EVERY };
enum ts_chunk_origin { TS_ORIGIN_LOWER, TS_ORIGIN_CENTER, TS_ORIGIN_UPPER, TS_ORIGIN_VALUE };

/* Bins along one axis. */
struct ts_chunk_axis {
	int dim;
	const char *origin_word;
	double delta; /* as given */
	enum ts_chunk_origin origin;
	double at; /* origin, where it is a value */
	/* as they are now */
	double lo, width; /* in lengths of the box's kind */
	int64_t n;
};

struct ts_chunk_side {
	bool given;
	double at;
};

/* First member of the state of who offers chunks. */
struct ts_chunks {
	/* arguments */
	struct ts_words words; /* style and its own arguments */
	struct ts_instance *region;
	bool compress, periodic;
	int number, ids, discard, units;
	struct ts_words limit_words, bound_words;

	enum ts_chunk_style style;
	int naxes;
	struct ts_chunk_axis axis[3];
	double centre[3], inner, outer; /* of spheres and cylinders */
	int64_t shells;
	struct ts_ref_input value;
	struct ts_chunk_side bound[3][2];
	int64_t limit; /* 0: none */
	bool exact;

	/* state: bins of `nchunk once`, identities of `ids once` */
	int64_t started, once;
	double once_lo[3];
	int64_t once_n[3];
	size_t column;
	bool has_column;

	/* as assigned last */
	size_t n;	   /* chunks */
	int32_t *id;	   /* of each local particle: 1 .. n; 0: in none */
	int64_t *original; /* with compress: the identity before, of chunk k at [k - 1] */
	size_t *first;	   /* particles of chunk k: member[first[k]] .. member[first[k + 1] - 1], in */
	int32_t *member;   /* the order of their identities */
	size_t id_capacity, original_capacity, first_capacity, member_capacity;
	struct ts_table values;
	struct tsim *sim;
};
#define TS_CHUNK_KEYWORDS(T)                                                                      \
	TS_REGION("region", T, chunks.region, .flags = TS_OPTIONAL | TS_STATEFUL,                 \
		  .help = "particles outside are in no chunk"),                                   \
		TS_ENUM("discard", T, chunks.discard, ts_chunk_discards, .fallback = "default",   \
			.flags = TS_STATEFUL,                                                     \
			.help = "whether particles beyond the bins are in no chunk (yes) or in "  \
				"the nearest bin (no); mixed, the default for bins: yes where "   \
				"there is a bound"),                                              \
		TS_LIST_KEYWORD("bound", T, chunks.bound_words,                                   \
				.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT | TS_STATEFUL,   \
				.help = "dim lo hi: bins reach from lo to hi, numbers or lower, " \
					"upper; again for other dims"),                           \
		TS_ENUM("units", T, chunks.units, ts_chunk_units, .fallback = "lattice",          \
			.flags = TS_STATEFUL,                                                     \
			.help = "whether lengths are in lattice spacings, as they are, or parts " \
				"of the box")
extern const char *const ts_chunk_discards[], *const ts_chunk_units[];
extern const char *const ts_chunk_numbers[], *const ts_chunk_id_words[];
#define TS_CHUNK_SAVED(T)                                                                            \
	TS_SAVE_I64(T, chunks.started), TS_SAVE_I64(T, chunks.once), TS_SAVE_F64(T, chunks.once_lo), \
		TS_SAVE_I64(T, chunks.once_n)

/* For init: reads the words the first time, finds anew what names stand for. */
enum ts_status ts_chunks_init(struct ts_instance *self, struct tsim *sim, struct ts_chunks *chunks);
/* Sorts the particles of the owner's group as they are now. With `ids nfreq` who is where is settled at the
 * first sample of an average, and stays so for the others. */
enum ts_chunk_moment { TS_CHUNK_LOOK, TS_CHUNK_FIRST_SAMPLE, TS_CHUNK_NEXT_SAMPLE };
enum ts_status ts_chunks_assign(struct ts_instance *self, struct ts_chunks *chunks,
				enum ts_chunk_moment moment);
enum ts_status ts_chunks_archive(struct ts_archive *archive, struct tsim *sim, struct ts_chunks *chunks);
void ts_chunks_release(struct ts_chunks *chunks);

/* How many coordinates a chunk has, and the k-th of the middle of a chunk (counted from 1), as a user
 * would give it. */
int ts_chunks_dimension(const struct ts_chunks *chunks);
double ts_chunks_coordinate(const struct ts_chunks *c, size_t chunk, int k);
/* Volume of a bin, in two dimensions its area; of chunks that are no bins that of the box. */
double ts_chunks_volume(const struct ts_chunks *c, size_t chunk);

/* The chunks of compute chunk/atom of this name. */
enum ts_status ts_chunks_find(struct tsim *sim, const struct ts_instance *user, const char *id,
			      struct ts_instance **owner, struct ts_chunks **chunks);

/* For each chunk, from 1, the sums over its particles in the group of `width` numbers: rounded once. */
typedef void ts_chunk_term(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term);
enum ts_status ts_chunk_sum(const struct ts_chunks *chunks, int group, size_t width, ts_chunk_term *term,
			    const void *context, struct ts_table *out);

#endif
