/* Time averages of the fixes ave/...: every Nfreq steps an average of Nrepeat samples taken Nevery steps
 * apart, the last of them at that step; the keyword `ave` combines it with previous averages. */
#ifndef TS_AVERAGE_AVERAGE_H
#define TS_AVERAGE_AVERAGE_H

#include "core/sim.h"

enum ts_average_mode { TS_AVE_ONE, TS_AVE_RUNNING, TS_AVE_WINDOW };

struct ts_average {
	/* arguments */
	int64_t every, repeat, freq, start; /* Nevery, Nrepeat, Nfreq, start: steps, but Nrepeat samples */
	int64_t window;			    /* M of `ave window M` */
	int ave;			    /* enum ts_average_mode */
	/* state, written to restart files */
	int64_t next;	  /* step of the next sample */
	int64_t samples;  /* samples taken for the current average */
	int64_t started;  /* 1: `next` is set */
	int64_t averages; /* completed averages */
	double *sum;   /* [n] over the samples of the current average; the style turns it into the average */
	double *total; /* [n] `ave running`: sum of all averages */
	double *history; /* [window][n] `ave window`: ring buffer of the last averages */
	double *result;	 /* [n] what the fix outputs */
	size_t n;	 /* numbers in one average; the lengths of the arrays follow */
	size_t sum_n, total_n, history_n, result_n;
	size_t sum_capacity, total_capacity, history_capacity, result_capacity;
	/* set by the style before ts_average_init */
	bool totals;   /* `ave running` and `ave window` add averages up instead of taking their mean */
	bool extremes; /* the last two of the n numbers are a minimum and a maximum */
};

/* Argument rows of a style whose state is of type T and has the struct ts_average as member A. */
#define TS_AVERAGE_STEPS(T, A)                                                                           \
	TS_INT("Nevery", T, A.every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1,  \
	       .hi = 1e15, .help = "steps between samples"),                                             \
		TS_INT("Nrepeat", T, A.repeat, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, \
		       .lo = 1, .hi = 1e15, .help = "samples per average"),                              \
		TS_INT("Nfreq", T, A.freq, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN,     \
		       .lo = 1, .hi = 1e15, .help = "steps between averages")
#define TS_AVERAGE_WINDOW_ROW(T, A)                                                                 \
	TS_INT("M", T, A.window, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1, \
	       .hi = 1e6, .help = "number of averages in the window")
/* Needs: static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(T, A), TS_ARGS_END }; and
 * static const struct ts_mode combinations[] = TS_AVERAGE_MODES; */
#define TS_AVERAGE_MODES                                                                                     \
	{                                                                                                    \
		[TS_AVE_ONE] = { "one", "each average by itself", NULL },                                    \
		[TS_AVE_RUNNING] = { "running", "mean of all averages so far (histograms: sum)", NULL },     \
		[TS_AVE_WINDOW] = { "window", "mean of the last M averages (histograms: sum)", window_row }, \
		{                                                                                            \
			.name = NULL                                                                         \
		}                                                                                            \
	}
/* clang-format off */
#define TS_AVERAGE_KEYWORDS(T, A)                                                                     \
	{ .name = "ave",                                                                           \
	  .type = TS_ARG_MODE,                                                                     \
	  .flags = TS_STATEFUL,                                                                    \
	  .offset = TS_FIELD(T, A.ave, int *),                                               \
	  .modes = combinations,                                                                   \
	  .fallback = "one",                                                                       \
	  .help = "how an average is combined with previous ones" },                              \
		TS_INT("start", T, A.start, .flags = TS_STATEFUL, .range = TS_WITHIN,        \
		       .lo = 0, .hi = 1e15, .fallback = "0",                                       \
		       .help = "no average before this step")
/* clang-format on */
/* clang-format off */
#define TS_AVERAGE_SAVED(T, A)                                                                        \
	{ "next", TS_SAVED_I64, offsetof(T, A.next), 1 },                                    \
		{ "samples", TS_SAVED_I64, offsetof(T, A.samples), 1 },                      \
		{ "started", TS_SAVED_I64, offsetof(T, A.started), 1 },                      \
	{                                                                                          \
		"averages", TS_SAVED_I64, offsetof(T, A.averages), 1                         \
	}
/* clang-format on */

/* Called by init: checks Nevery, Nrepeat and Nfreq; the first call sets the step of the first sample. */
enum ts_status ts_average_init(struct ts_instance *self, struct tsim *sim, struct ts_average *a);
/* Allocates the arrays for n numbers. Once there are averages to combine (`ave running` or `window`), n may
 * not change. */
enum ts_status ts_average_resize(struct ts_instance *self, struct tsim *sim, struct ts_average *a, size_t n);
/* Whether a sample is due at this step; before the first sample of an average, the sums are set to 0. */
bool ts_average_due(struct ts_average *a, const struct tsim *sim);
/* Slot `due` of styles whose state begins with a struct ts_average: whether a sample is due at this step. */
bool ts_average_waits(const struct ts_instance *self, const struct tsim *sim);
/* At the first sample of an average: the step of the last sample for which what is averaged must keep its number of values,
 * with `ave running` and `window` that of the next average. */
int64_t ts_average_until(const struct ts_average *a, const struct tsim *sim);
/* Counts a sample that the style has added to `sum`. Returns true after the last sample of an average: the
 * style then turns `sum` into the average and calls ts_average_combine. */
bool ts_average_sampled(struct ts_average *a, const struct tsim *sim);
/* Sets `result` from the average in `sum` and previous ones. */
void ts_average_combine(struct ts_average *a);
/* Number of averages that `result` combines. */
int64_t ts_average_weight(const struct ts_average *a);

enum ts_status ts_average_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive,
				  struct ts_average *a);
void ts_average_release(struct ts_average *a);

#endif
