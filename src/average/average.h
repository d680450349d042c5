/* Averages over time, as all fixes ave/... take them: every Nfreq steps an average of Nrepeat samples, Nevery
 * steps apart, the last at the step itself; then `ave` combines averages with those before. */
#ifndef TS_AVERAGE_AVERAGE_H
#define TS_AVERAGE_AVERAGE_H

#include "core/sim.h"

enum ts_average_mode { TS_AVE_ONE, TS_AVE_RUNNING, TS_AVE_WINDOW };

struct ts_average {
	/* arguments */
	int64_t every, repeat, freq, start, window;
	int ave;
	/* saved */
	int64_t next;	 /* step of the next sample */
	int64_t samples; /* taken of the average under way */
	int64_t started, averages;
	double *sum;	 /* of the samples under way; the style turns it into the average */
	double *total;	 /* of the averages that `ave` combines */
	double *history; /* the last `window` averages, a ring */
	double *result;
	size_t n, sum_n, total_n, history_n, result_n;
	size_t sum_capacity, total_capacity, history_capacity, result_capacity;
	/* set by the style */
	bool totals;   /* averages are added up, not averaged again */
	bool extremes; /* the last two numbers are a least and a largest one */
};

/* Rows for a state of type T in which A is the struct ts_average. */
#define TS_AVERAGE_STEPS(T, A)                                                                           \
	TS_INT("Nevery", T, A.every, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1,  \
	       .hi = 1e15, .help = "steps between samples"),                                             \
		TS_INT("Nrepeat", T, A.repeat, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, \
		       .lo = 1, .hi = 1e15, .help = "samples per average"),                              \
		TS_INT("Nfreq", T, A.freq, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN,     \
		       .lo = 1, .hi = 1e15, .help = "steps between averages")
#define TS_AVERAGE_WINDOW_ROW(T, A)                                                                 \
	TS_INT("M", T, A.window, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, .lo = 1, \
	       .hi = 1e6, .help = "how many averages")
/* Needs: static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(T, A), TS_ARGS_END }; and
 * static const struct ts_mode combinations[] = TS_AVERAGE_MODES; */
#define TS_AVERAGE_MODES                                                                    \
	{                                                                                   \
		[TS_AVE_ONE] = { "one", "each average by itself", NULL },                   \
		[TS_AVE_RUNNING] = { "running", "all averages so far together", NULL },     \
		[TS_AVE_WINDOW] = { "window", "the last M averages together", window_row }, \
		{                                                                           \
			.name = NULL                                                        \
		}                                                                           \
	}
/* clang-format off */
#define TS_AVERAGE_KEYWORDS(T, A)                                                                     \
	{ .name = "ave",                                                                           \
	  .type = TS_ARG_MODE,                                                                     \
	  .flags = TS_STATEFUL,                                                                    \
	  .offset = TS_FIELD(T, A.ave, int *),                                               \
	  .modes = combinations,                                                                   \
	  .fallback = "one",                                                                       \
	  .help = "what becomes of averages" },                                                    \
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

/* In init: checks the numbers of steps; the first time finds the step of the first sample. */
enum ts_status ts_average_init(struct ts_instance *self, struct tsim *sim, struct ts_average *a);
/* Room for n numbers. With `ave` other than one it must stay the same. */
enum ts_status ts_average_resize(struct ts_instance *self, struct tsim *sim, struct ts_average *a, size_t n);
/* Is a sample to be taken at this step? Before the first one of an average the sums are cleared. */
bool ts_average_due(struct ts_average *a, const struct tsim *sim);
/* A sample has been added to the sums; true: it was the last of an average, which the style now completes
 * in `sum`, and then calls ts_average_combine. */
bool ts_average_sampled(struct ts_average *a, const struct tsim *sim);
void ts_average_combine(struct ts_average *a);
/* How many averages the result stands for. */
int64_t ts_average_weight(const struct ts_average *a);

enum ts_status ts_average_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive,
				  struct ts_average *a);
void ts_average_release(struct ts_average *a);

#endif
