/* What -crosscheck prints about an output. */
#include <inttypes.h>
#include <string.h>

#include "crosscheck/difference_report.h"

#include "base/banned.h"

enum { NAME_WIDTH = 20 };

static const char *plural(size_t n)
{
	return n == 1 ? "" : "s";
}

static const char *unit(const struct ts_pairing *p)
{
	return p->lines ? "line" : "step";
}

static void add_row(const struct ts_compared *c, bool statistics, struct ts_str *out)
{
	if (c->most > 0)
		ts_str_addf(out, "  %-*s %9.1e %10" PRId64, NAME_WIDTH, c->name, c->most, c->at);
	else
		ts_str_addf(out, "  %-*s %9s %10s", NAME_WIDTH, c->name, "0", "");
	if (statistics && c->parts)
		ts_str_addf(out, " %10" PRId64, c->parts_at);
	else if (statistics)
		ts_str_addf(out, " %10s", "-");
	if (statistics && c->frames > 0)
		ts_str_addf(out, " %9.1e %9.1e %9.1e", c->mean, c->spread, c->profile);
	ts_str_add(out, c->differs && c->parts ? "  differs on purpose, see -help legacy\n" : "\n");
}

/* Nothing but frames without rows, or no frame at all, in both. */
static bool all_empty(const struct ts_pairing *p)
{
	for (size_t k = 0; k < p->columns; k++)
		if (p->column[k].side[0].n || p->column[k].side[1].n)
			return false;
	return !p->alone[0] && !p->alone[1];
}

static void add_alone(const struct ts_pairing *p, const char *const who[TS_BOTH], struct ts_str *out)
{
	for (int k = 0; k < TS_BOTH; k++)
		if (p->alone[k])
			ts_str_addf(out, "  %zu %s%s only from %s\n", p->alone[k], unit(p),
				    plural(p->alone[k]), who[k]);
	if (p->rows_alone)
		ts_str_addf(out, "  %zu row%s without a partner\n", p->rows_alone, plural(p->rows_alone));
	if (p->alone_at >= 0)
		ts_str_addf(out, "  the first of them at %s %" PRId64 "\n", unit(p), p->alone_at);
	for (size_t k = 0; k < p->columns; k++)
		for (int side = 0; side < TS_BOTH; side++)
			if (ts_compare_lacks(&p->column[k], side))
				ts_str_addf(out, "  column %s only from %s\n", p->column[k].name, who[!side]);
}

void ts_report_pairing(const struct ts_pairing *p, bool statistics, const char *peer, struct ts_str *out)
{
	const char *const who[TS_BOTH] = { "tsim", peer };

	if (all_empty(p)) {
		ts_str_addf(out, "\n%s: %zu %s%s, empty in both\n", p->name, p->frames, unit(p),
			    plural(p->frames));
		return;
	}
	ts_str_addf(out, "\n%s: %zu %s%s%s\n", p->name, p->frames, unit(p), plural(p->frames),
		    p->left_out ? ", wall times not compared" : "");
	ts_str_addf(out, "  %-*s %9s    at %s", NAME_WIDTH, "column", "largest", unit(p));
	if (statistics)
		ts_str_addf(out, " %10s %9s %9s %9s", "parts at", "mean", "spread", "profile");
	ts_str_add(out, "\n");
	for (size_t k = 0; k < p->columns; k++)
		if (p->column[k].side[TS_HERE].n && p->column[k].side[TS_PEER].n)
			add_row(&p->column[k], statistics, out);
	if (p->turned)
		ts_str_addf(out,
			    "  %zu contact%s with the partners in the other order: forces are compared with "
			    "the opposite sign, history without sign, torques not\n",
			    p->turned, plural(p->turned));
	add_alone(p, who, out);
}
