/* Streams of random numbers of formulas: one per seed, which lives as long as the script. */
#ifndef TS_FORMULA_RANDOM_STREAM_H
#define TS_FORMULA_RANDOM_STREAM_H

#include <stdint.h>

#include "base/status.h"

struct ts_archive;
struct ts_formulas;

struct ts_random_stream {
	int64_t seed;
	int64_t draws;	/* single numbers drawn outside of runs */
	int64_t rounds; /* formulas of particles outside of runs, in each of which every particle draws one */
};

/* The stream of a seed, which must be a positive whole number. */
enum ts_status ts_random_stream_of(struct ts_formulas *formulas, double seed, struct ts_random_stream **out);
/* Saves or restores the positions of all streams. */
enum ts_status ts_random_streams_archive(struct ts_formulas *formulas, struct ts_archive *archive);

#endif
