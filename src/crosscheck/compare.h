/* Two runs of the same script, output by output and column by column.
 *
 * A difference is counted beyond what the printed digits leave open, in units of the column's scale: its
 * range, but at least a thousandth of its largest magnitude, so that round-off of a constant is none. The
 * components of a vector have one scale. Grains in contact are chaotic: a difference of one digit grows
 * until the runs have nothing in common but their statistics. So the first step is found where any column
 * parts by more than the tolerance, and from there on means, spreads and distributions are compared. */
#ifndef TS_CROSSCHECK_COMPARE_H
#define TS_CROSSCHECK_COMPARE_H

#include "crosscheck/frame.h"

enum { TS_HERE, TS_PEER, TS_BOTH };

/* What one program printed in a column. */
struct ts_side {
	int digits, decimals;
	bool padded, whole;
	bool named;	     /* it has the column, be it without rows */
	size_t n, after;     /* words in all, and since the runs parted */
	double sum, squares; /* of the latter, above the column's lowest value */
};

struct ts_compared {
	const char *name;
	struct ts_side side[TS_BOTH];
	double lo, hi, scale;
	double most; /* the largest difference */
	int64_t at;  /* its step */
	bool parts;
	int64_t parts_at;
	bool differs; /* on purpose */
	/* since the runs parted, in units of the scale */
	double mean, spread, profile, frames;
};

/* An output that both have. */
struct ts_pairing {
	const char *name; /* "post/dump*.txt" */
	enum ts_frame_kind kind;
	const struct ts_meanings *meanings;
	const char *folder[TS_BOTH];
	const char *const *file[TS_BOTH];
	/* what was found */
	struct ts_compared *column;
	size_t columns, column_capacity;
	size_t frames, alone[TS_BOTH]; /* in both; only in one of them */
	size_t rows_alone;
	size_t turned;	  /* contacts whose partners the programs name the other way round */
	int64_t alone_at; /* the first step of which one has a frame or row that the other lacks */
	bool lines;	  /* steps are not known: numbers of lines stand for them */
	bool left_out;	  /* wall times are in the file and not compared */
};

/* Fills in all but the statistics. */
enum ts_status ts_compare(struct ts_pairing *p, double tolerance, struct ts_error *err, struct ts_pool *pool);
/* Those, from this step on. */
enum ts_status ts_compare_statistics(struct ts_pairing *p, int64_t from, struct ts_error *err,
				     struct ts_pool *pool);
/* Whether that program lacks a column that the other fills. */
bool ts_compare_lacks(const struct ts_compared *column, int who);
void ts_compare_release(struct ts_pairing *p);

#endif
