/* Comparison of the outputs of two runs of the same script, output by output and column by column.
 *
 * A difference counts as far as it exceeds the resolution of the printed digits, in units of the scale of
 * the column: its range, but at least a thousandth of its largest magnitude, so that round-off of a
 * constant is no difference. The components of a vector have one scale. Granular systems are chaotic: a
 * difference in the last digit grows until only the statistics of the runs agree. Therefore the first step
 * is found at which any column diverges by more than the tolerance, and from there on means, standard
 * deviations and distributions are compared. */
#ifndef TS_CROSSCHECK_COMPARE_H
#define TS_CROSSCHECK_COMPARE_H

#include "crosscheck/frame.h"

enum { TS_SELF, TS_PEER, TS_NPROGRAMS }; /* tsim, the other program */

/* What one program printed in a column. */
struct ts_printed_column {
	int digits, decimals; /* largest number of significant digits, and of decimals */
	bool padded;	      /* fixed format: numbers end in zeros */
	bool integer;	      /* all numbers are integers */
	bool present;	      /* the column exists, even without rows */
	size_t n;	      /* number of values */
	/* since the runs diverged: number, sum and sum of squares of the values minus the smallest one */
	size_t n_after;
	double sum, squares;
};

/* Comparison of a column; differences in units of `scale`. */
struct ts_compared {
	const char *name;
	struct ts_printed_column side[TS_NPROGRAMS];
	double lo, hi, scale; /* range in both runs */
	double most;	      /* largest difference */
	int64_t at;	      /* its step */
	bool diverged;	      /* the difference exceeds the tolerance */
	int64_t diverged_at;  /* at this step for the first time */
	bool differs_on_purpose;
	/* since the runs diverged: difference of the means and of the standard deviations; sum, later mean,
	 * of the distance of the distributions; number of frames in it */
	double mean, deviation, quantiles, frames;
};

/* An output that both programs wrote, and its comparison. */
struct ts_pairing {
	const char *name; /* "post/dump*.txt" */
	enum ts_frame_kind kind;
	const struct ts_meanings *meanings;
	const char *folder[TS_NPROGRAMS];
	const char *const *file[TS_NPROGRAMS]; /* file names in the folder, NULL-terminated */

	/* the result */
	struct ts_compared *column; /* owned */
	size_t columns, column_capacity;
	size_t frames;			       /* number of frames in both */
	size_t unmatched_frames[TS_NPROGRAMS]; /* number of frames in only one of them */
	size_t unmatched_rows;		       /* number of rows in only one of them */
	size_t swapped;	      /* number of contacts whose partners the programs list in opposite order */
	int64_t unmatched_at; /* first step with an unmatched frame or row; -1: none */
	bool lines;	      /* the output has no steps: line numbers take their place */
	bool wall_times_skipped;
};

/* Computes all of the result except the statistics. */
enum ts_status ts_compare(struct ts_pairing *p, double tolerance, struct ts_error *err, struct ts_pool *pool);
/* Computes the statistics from this step on. */
enum ts_status ts_compare_statistics(struct ts_pairing *p, int64_t from, struct ts_error *err,
				     struct ts_pool *pool);
/* Whether program `who` does not have the column, and the other one has values in it. */
bool ts_compare_lacks(const struct ts_compared *column, int who);
void ts_compare_release(struct ts_pairing *p);

#endif
