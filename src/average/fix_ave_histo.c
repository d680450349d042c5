/* Fix ave/histo: histograms of values, over time. */
#include "average/histogram.h"

#include "base/banned.h"

struct state {
	struct ts_histogram histogram;
};

static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(struct state, histogram.average),
					    TS_ARGS_END };
static const struct ts_mode combinations[] = TS_AVERAGE_MODES;

static const struct ts_arg args[] = {
	TS_HISTOGRAM_ARGS(struct state, "x, vx, fx ..., c_ID, c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_AVERAGE_SAVED(struct state, histogram.average),
					 TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_ave_histo)
const struct ts_style ts_fix_ave_histo = {
	.name = "ave/histo",
	.kind = TS_KIND_FIX,
	.summary = "Histograms of values, over time",
	.doc = "Every Nfreq steps a histogram of all numbers the values had in Nrepeat samples, Nevery steps "
	       "apart, the last at the\nstep itself: those of the particles of the group, elements of "
	       "vectors, rows of local tables; with `mode scalar`\nsingle numbers. Nbin bins divide lo to "
	       "hi; hi itself is in the last one. Values outside, and those that are no\nnumbers, are "
	       "missing, or with `beyond end` in the outermost bins, or with `beyond extra` in one bin more "
	       "on\neither side. `ave running` and `window` add up histograms. f_ID[1] is the count in all "
	       "bins, f_ID[2] the missing\nones, f_ID[3] and f_ID[4] the least and largest value; "
	       "f_ID[i][1], f_ID[i][2], f_ID[i][3] are middle, count\n"
	       "and part of the total of bin i. Histograms under way are saved in restart files.",
	.example = "fix speeds all ave/histo 10 100 1000 0 2.5 50 v_speed file post/speeds.txt",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_histogram_archive,
	.values = ts_histogram_values,
	.init = ts_histogram_init,
	.hook = {
		[TS_STAGE_SETUP] = ts_histogram_sample,
		[TS_STAGE_END_OF_STEP] = ts_histogram_sample,
	},
	.fini = ts_histogram_fini,
};
