/* Fix ave/histo: histograms of values over time. */
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

static const struct ts_arg_group groups[] = {
	{ NULL, "Nevery Nrepeat Nfreq lo hi Nbin values mode ave file" },
	{ "What is counted", "kind beyond start" },
	{ "The file", "append overwrite format title1 title2 title3" },
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_ave_histo)
const struct ts_style ts_fix_ave_histo = {
	.name = "ave/histo",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_average_waits,
	.summary = "Histograms of values over time",
	.doc = "Calculates every Nfreq steps a histogram of all numbers that the values have in Nrepeat samples taken Nevery steps apart, the last at that step: numbers of the particles of the group, elements of vectors, rows of local arrays; with `mode scalar` global scalars. Nbin bins divide the range lo to hi evenly; hi itself belongs to the last bin. Values outside the range, and those that are not a number, are counted as missing; with `beyond end` values outside are counted in the first or last bin, with `beyond extra` in one additional bin on either side. `ave running` and `ave window` add histograms up.\n\n"
	       "f_ID[1] is the total count in all bins, f_ID[2] that of missing values, f_ID[3] and f_ID[4] are the smallest and largest value; f_ID[i][1], f_ID[i][2], f_ID[i][3] are the centre, the count, and the fraction of the total of bin i. Histograms in progress are saved in restart files.",
	.example = "fix speeds all ave/histo 10 100 1000 0 2.5 50 v_speed file post/speeds.txt",
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_histogram_archive,
	.values = ts_histogram_values,
	.init = ts_histogram_init,
	.hook = {
		[TS_STAGE_SETUP] = ts_histogram_sample,
		[TS_STAGE_END_OF_STEP] = ts_histogram_sample,
	},
	.plan = ts_histogram_plan,
	.fini = ts_histogram_fini,
};
