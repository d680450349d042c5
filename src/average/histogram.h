/* Histograms over samples in time: shared by fix ave/histo and fix ave/histo/weight. */
#ifndef TS_AVERAGE_HISTOGRAM_H
#define TS_AVERAGE_HISTOGRAM_H

#include "average/average.h"
#include "average/average_file.h"
#include "core/ref_list.h"

/* First member of the state. The numbers that are averaged: counts of the bins, total, missing, smallest and
 * largest value. */
struct ts_histogram {
	struct ts_average average;
	struct ts_average_file file;
	double lo, hi;		/* range of the bins, in the unit of the values */
	int64_t bins;		/* Nbin, without the extra ones of `beyond extra` */
	struct ts_words words;	/* the values as given */
	int mode, kind, beyond; /* indices of ts_histogram_modes, _kinds, _beyond */
	bool weighted;		/* set by the style: the second value is the weight of the first */
	struct ts_ref_list input;
	struct ts_table values, weights;
};
#define TS_HISTOGRAM_ARGS(T, text)                                                                          \
	TS_AVERAGE_STEPS(T, histogram.average),                                                             \
		TS_REAL("lo", T, histogram.lo, .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "",            \
			.help = "lower end of the first bin"),                                              \
		TS_REAL("hi", T, histogram.hi, .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "",            \
			.help = "upper end of the last bin"),                                               \
		TS_INT("Nbin", T, histogram.bins, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_WITHIN, \
		       .lo = 1, .hi = 1e7, .help = "number of bins"),                                       \
		TS_LIST_STATEFUL("values", T, histogram.words, .help = text),                               \
		TS_ENUM("mode", T, histogram.mode, ts_histogram_modes, .flags = TS_STATEFUL,                \
			.fallback = "default",                                                              \
			.help = "whether values are scalars, or vectors, per-particle and local "           \
				"arrays (vector); default: scalars where possible"),                        \
		TS_ENUM("kind", T, histogram.kind, ts_histogram_kinds, .flags = TS_STATEFUL,                \
			.fallback = "any", .help = "which output, of styles that have several kinds"),      \
		TS_ENUM("beyond", T, histogram.beyond, ts_histogram_beyond, .flags = TS_STATEFUL,           \
			.fallback = "ignore",                                                               \
			.help = "whether values outside are ignored, counted in the first and last "        \
				"bin, or in two extra bins"),                                               \
		TS_AVERAGE_KEYWORDS(T, histogram.average), TS_AVERAGE_FILE_ARGS(T, histogram.file)
extern const char *const ts_histogram_modes[], *const ts_histogram_kinds[], *const ts_histogram_beyond[];
extern const struct ts_value ts_histogram_values[];

enum ts_status ts_histogram_init(struct ts_instance *self, struct tsim *sim);
/* Stage function for SETUP and END_OF_STEP. */
enum ts_status ts_histogram_sample(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_histogram_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
enum ts_status ts_histogram_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_histogram_fini(struct ts_instance *self);

#endif
