/* Fix ave/histo/weight: histograms of weighted values over time. */
#include "average/histogram.h"

#include "base/banned.h"

struct state {
	struct ts_histogram histogram;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	((struct state *)self->state)->histogram.weighted = true;
	return ts_histogram_init(self, sim);
}

static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(struct state, histogram.average),
					    TS_ARGS_END };
static const struct ts_mode combinations[] = TS_AVERAGE_MODES;

static const struct ts_arg args[] = {
	TS_HISTOGRAM_ARGS(struct state, "two values: the one to be binned, and its weight"),
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

TS_STYLE(fix, ts_style, ts_fix_ave_histo_weight)
const struct ts_style ts_fix_ave_histo_weight = {
	.name = "ave/histo/weight",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_average_waits,
	.summary = "Histograms of weighted values over time",
	.doc = "As fix ave/histo for the first value; each number adds the corresponding number of the second value, its weight, to the count of its bin instead of 1.",
	.example = "fix heights all ave/histo/weight 10 100 1000 0 0.1 20 z mass file post/heights.txt",
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_histogram_archive,
	.values = ts_histogram_values,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = ts_histogram_sample,
		[TS_STAGE_END_OF_STEP] = ts_histogram_sample,
	},
	.plan = ts_histogram_plan,
	.fini = ts_histogram_fini,
};
