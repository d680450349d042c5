/* Chunks: particles grouped by spatial bin, by type, or by a per-particle number, for sums and averages over
 * each chunk. Shared by compute chunk/atom, the computes .../chunk, fix ave/chunk and fix ave/spatial. Chunks
 * are numbered from 1. */
#ifndef TS_AVERAGE_CHUNK_H
#define TS_AVERAGE_CHUNK_H

#include "core/ref_list.h"
#include "core/sim.h"

enum ts_chunk_style { TS_CHUNK_BINS, TS_CHUNK_SPHERE, TS_CHUNK_CYLINDER, TS_CHUNK_TYPE, TS_CHUNK_VALUE };
enum ts_chunk_ids { TS_CHUNK_IDS_EVERY, TS_CHUNK_IDS_ONCE, TS_CHUNK_IDS_NFREQ };
/* In the order of the words in ts_chunk_discards, ts_chunk_units and ts_chunk_numbers. */
enum ts_chunk_discard { TS_DISCARD_DEFAULT, TS_DISCARD_YES, TS_DISCARD_NO, TS_DISCARD_MIXED };
enum ts_chunk_lengths { TS_LENGTHS_LATTICE, TS_LENGTHS_BOX, TS_LENGTHS_REDUCED };
enum ts_chunk_number { TS_NUMBER_DEFAULT, TS_NUMBER_ONCE, TS_NUMBER_EVERY };
enum ts_chunk_origin { TS_ORIGIN_LOWER, TS_ORIGIN_CENTER, TS_ORIGIN_UPPER, TS_ORIGIN_VALUE };

/* Bins along one axis. */
struct ts_chunk_axis {
	int dim; /* 0, 1, 2: x, y, z */
	const char *origin_word;
	double delta; /* bin width in the units of the keyword `units` */
	enum ts_chunk_origin origin;
	double at; /* TS_ORIGIN_VALUE: the coordinate, in those units */
	/* set by ts_chunk_bins_place for the current box */
	double lo, width; /* lower end of the first bin, and bin width (length) */
	int64_t n;	  /* number of bins */
};

/* One end of the keyword `bound`. */
struct ts_chunk_bound {
	bool given; /* false: the face of the box */
	double at;  /* coordinate (length) */
};

/* First member of the state of compute chunk/atom; fix ave/spatial has one of its own. */
struct ts_chunks {
	/* arguments */
	struct ts_words words;	    /* chunk style and its arguments */
	struct ts_instance *region; /* NULL: everywhere */
	bool compress, periodic;
	int number, ids, discard, units;
	struct ts_words limit_words, bound_words;

	enum ts_chunk_style style;
	int naxes;
	struct ts_chunk_axis axis[3];
	double centre[3], inner, outer;	   /* bin/sphere, bin/cylinder: centre, rmin, rmax (length) */
	int64_t shells;			   /* nbin; 0: other styles */
	struct ts_ref_input value;	   /* TS_CHUNK_VALUE: c_ID, f_ID or v_NAME */
	struct ts_chunk_bound bound[3][2]; /* by axis; lower, upper */
	int64_t limit;			   /* 0: none */
	bool exact;			   /* `limit N exact`, else max */

	/* state, written to restart files: bins of `nchunk once`, chunks of `ids once` and `ids nfreq` */
	int64_t started, once; /* 1: arguments are read; the bins below are set */
	int64_t held_until;    /* up to this step chunks stay those of the first sample of an average */
	double once_lo[3];     /* axis.lo of the first placement */
	int64_t once_n[3];     /* axis.n of it; [0] is the number of chunks for TS_CHUNK_VALUE */
	size_t column;	       /* column of the particles: 1 + chunk number; 0: not yet assigned */
	bool has_column;

	/* results of the last ts_chunks_assign */
	size_t n;	   /* number of chunks */
	int32_t *id;	   /* [particle] chunk number 1 .. n; 0: in no chunk */
	int64_t *original; /* [n] `compress yes`: number of chunk k before compression, at [k - 1] */
	size_t *first;	   /* [n + 3] particles of chunk k: member[first[k]] .. member[first[k + 1] - 1], */
	int32_t *member;   /* sorted by id of the particle */
	size_t id_capacity, original_capacity, first_capacity, member_capacity;
	struct ts_table values; /* of `value`, reused */
	struct tsim *sim;
};
#define TS_CHUNK_KEYWORDS(T)                                                                      \
	TS_REGION("region", T, chunks.region, .flags = TS_OPTIONAL | TS_STATEFUL,                 \
		  .help = "particles outside are in no chunk"),                                   \
		TS_ENUM("discard", T, chunks.discard, ts_chunk_discards, .fallback = "default",   \
			.flags = TS_STATEFUL,                                                     \
			.help = "whether particles outside the bins are in no chunk (yes) or in " \
				"the nearest bin (no); mixed: yes where there is a bound, else "  \
				"no; default: mixed below, yes above, for shells no"),            \
		TS_LIST_KEYWORD("bound", T, chunks.bound_words,                                   \
				.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT | TS_STATEFUL,   \
				.help = "dim lo hi: bins extend from lo to hi, a coordinate or "  \
					"lower, upper; repeat for other dims"),                   \
		TS_ENUM("units", T, chunks.units, ts_chunk_units, .fallback = "lattice",          \
			.flags = TS_STATEFUL,                                                     \
			.help = "units of lengths: lattice spacings, those of the script (box), " \
				"or fractions of the box (reduced)")
extern const char *const ts_chunk_discards[], *const ts_chunk_units[];
extern const char *const ts_chunk_numbers[], *const ts_chunk_id_words[];
#define TS_CHUNK_SAVED(T)                                                                               \
	TS_SAVE_I64(T, chunks.started), TS_SAVE_I64(T, chunks.once), TS_SAVE_I64(T, chunks.held_until), \
		TS_SAVE_F64(T, chunks.once_lo), TS_SAVE_I64(T, chunks.once_n)

/* For the first sample of an average whose last one is taken at step `until`: number and places of chunks stay, as with
 * `nchunk once`, so that samples can be added when the box changes in between. */
void ts_chunks_hold(struct ts_chunks *chunks, int64_t until);
bool ts_chunks_held(const struct ts_chunks *chunks);
/* Called by init: parses the arguments at the first call, resolves names at each. */
enum ts_status ts_chunks_init(struct ts_instance *self, struct tsim *sim, struct ts_chunks *chunks);
/* Assigns the particles of the owner's group to chunks. With `ids nfreq` the first sample of an average
 * assigns them and its other samples keep that; TS_CHUNK_NO_SAMPLE is an evaluation outside of averages. */
enum ts_chunk_moment { TS_CHUNK_NO_SAMPLE, TS_CHUNK_FIRST_SAMPLE, TS_CHUNK_NEXT_SAMPLE };
enum ts_status ts_chunks_assign(struct ts_instance *self, struct ts_chunks *chunks,
				enum ts_chunk_moment moment);
enum ts_status ts_chunks_archive(struct ts_archive *archive, struct tsim *sim, struct ts_chunks *chunks);
void ts_chunks_release(struct ts_chunks *chunks);

/* Number of coordinates of a chunk (0 unless it is a bin), and coordinate k (from 0) of the centre of a bin
 * in the units of the keyword `units`; chunks count from 1. */
int ts_chunks_dimension(const struct ts_chunks *chunks);
double ts_chunks_coordinate(const struct ts_chunks *c, size_t chunk, int k);
/* Volume of a bin (length^3; in two dimensions the area, length^2); of the box for chunks that are no
 * bins. */
double ts_chunks_volume(const struct ts_chunks *c, size_t chunk);

/* Finds the compute chunk/atom of this id; `user` is named in the error message. */
enum ts_status ts_chunks_find(struct tsim *sim, const struct ts_instance *user, const char *id,
			      struct ts_instance **owner, struct ts_chunks **chunks);

/* Sums `width` numbers per particle, returned by `term`, over the particles of each chunk that are in the
 * group: out has a row for each chunk. Sums are exact and rounded once. */
typedef void ts_chunk_term(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term);
enum ts_status ts_chunk_sum(const struct ts_chunks *chunks, int group, size_t width, ts_chunk_term *term,
			    const void *context, struct ts_table *out);

#endif
