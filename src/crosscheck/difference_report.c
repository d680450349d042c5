/* The report of -crosscheck on one output. */
#include <inttypes.h>
#include <string.h>

#include "crosscheck/difference_report.h"

#include "base/banned.h"

enum { NAME_WIDTH = 20 };

static const char *plural(size_t n)
{
	return n == 1 ? "" : "s";
}

static const char *frame_unit(const struct ts_pairing *p)
{
	return p->lines ? "line" : "step";
}

static void add_column_row(const struct ts_compared *c, bool statistics, struct ts_str *out)
{
	if (c->most > 0)
		ts_str_addf(out, "  %-*s %9.1e %10" PRId64, NAME_WIDTH, c->name, c->most, c->at);
	else
		ts_str_addf(out, "  %-*s %9s %10s", NAME_WIDTH, c->name, "0", "");
	if (statistics && c->diverged)
		ts_str_addf(out, " %10" PRId64, c->diverged_at);
	else if (statistics)
		ts_str_addf(out, " %10s", "-");
	if (statistics && c->frames > 0)
		ts_str_addf(out, " %9.1e %9.1e %9.1e", c->mean, c->deviation, c->quantiles);
	ts_str_add(out,
		   c->differs_on_purpose && c->diverged ? "  intended difference, see -help legacy\n" : "\n");
}

/* Whether both have only frames without rows, or no frame at all. */
static bool all_empty(const struct ts_pairing *p)
{
	for (size_t k = 0; k < p->columns; k++)
		if (p->column[k].side[0].n || p->column[k].side[1].n)
			return false;
	return !p->unmatched_frames[0] && !p->unmatched_frames[1];
}

static void add_unmatched(const struct ts_pairing *p, const char *const who[TS_NPROGRAMS], struct ts_str *out)
{
	for (int k = 0; k < TS_NPROGRAMS; k++)
		if (p->unmatched_frames[k])
			ts_str_addf(out, "  %zu %s%s only in %s\n", p->unmatched_frames[k], frame_unit(p),
				    plural(p->unmatched_frames[k]), who[k]);
	if (p->unmatched_rows)
		ts_str_addf(out, "  %zu unmatched row%s\n", p->unmatched_rows, plural(p->unmatched_rows));
	if (p->unmatched_at >= 0)
		ts_str_addf(out, "  first of them at %s %" PRId64 "\n", frame_unit(p), p->unmatched_at);
	for (size_t k = 0; k < p->columns; k++)
		for (int side = 0; side < TS_NPROGRAMS; side++)
			if (ts_compare_lacks(&p->column[k], side))
				ts_str_addf(out, "  column %s only in %s\n", p->column[k].name, who[!side]);
}

void ts_report_pairing(const struct ts_pairing *p, bool statistics, const char *peer, struct ts_str *out)
{
	const char *const who[TS_NPROGRAMS] = { "tsim", peer };

	if (all_empty(p)) {
		ts_str_addf(out, "\n%s: %zu %s%s, empty in both\n", p->name, p->frames, frame_unit(p),
			    plural(p->frames));
		return;
	}
	ts_str_addf(out, "\n%s: %zu %s%s%s\n", p->name, p->frames, frame_unit(p), plural(p->frames),
		    p->wall_times_skipped ? ", wall times not compared" : "");
	ts_str_addf(out, "  %-*s %9s    at %s", NAME_WIDTH, "column", "largest", frame_unit(p));
	if (statistics)
		ts_str_addf(out, " %10s %9s %9s %9s", "diverges", "mean", "stddev", "quantiles");
	ts_str_add(out, "\n");
	for (size_t k = 0; k < p->columns; k++)
		if (p->column[k].side[TS_SELF].n && p->column[k].side[TS_PEER].n)
			add_column_row(&p->column[k], statistics, out);
	if (p->swapped)
		ts_str_addf(out,
			    "  %zu contact%s with the particles in reverse order: forces compared with "
			    "opposite sign, history without sign, torques not compared\n",
			    p->swapped, plural(p->swapped));
	add_unmatched(p, who, out);
}
