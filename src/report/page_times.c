/* Where time went, and the energy ledgers. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "report/page.h"

#include "base/banned.h"

/* ---- times */

/* Seconds in each part of all runs, then outside of runs. */
static void sum_parts(const struct ts_page *page, double out[TS_PLAN_PARTS + 1])
{
	const struct ts_record *r = page->record;
	double left = page->now - r->start - r->rest.wall;

	for (int part = 0; part < TS_PLAN_PARTS; part++)
		out[part] = r->rest.part[part];
	for (size_t k = 0; k < r->nruns; k++) {
		for (int part = 0; part < TS_PLAN_PARTS; part++)
			out[part] += r->run[k].part[part];
		left -= r->run[k].wall;
	}
	out[TS_PLAN_PARTS] = fmax(left, 0);
}

static const char *name_of(int part)
{
	static const char *const names[] = { "integration",	"contact search", "copies at periodic faces",
					     "contacts, bonds", "fixes",	  "output" };

	_Static_assert(sizeof names / sizeof *names == TS_PLAN_PARTS, "a name for each part");
	return part < TS_PLAN_PARTS ? names[part] : "outside of runs";
}

static void add_parts(struct ts_page *page)
{
	double part[TS_PLAN_PARTS + 1], sum = 0;
	struct ts_str *out = &page->out;

	sum_parts(page, part);
	for (int k = 0; k <= TS_PLAN_PARTS; k++)
		sum += part[k];
	if (!(sum > 0))
		return;
	ts_str_add(out, "<div class=\"stack\">");
	for (int k = 0; k <= TS_PLAN_PARTS; k++)
		ts_str_addf(out, "<i class=\"q%d\" style=\"width:%.2f%%\" title=\"%s\"></i>", k,
			    100 * part[k] / sum, name_of(k));
	ts_str_add(out, "</div>\n<div class=\"key\">");
	for (int k = 0; k <= TS_PLAN_PARTS; k++) {
		if (part[k] < 5e-4 * sum)
			continue;
		ts_str_addf(out, "<span><i class=\"q%d\"></i>%s %.3g %% (", k, name_of(k),
			    100 * part[k] / sum);
		ts_page_duration(out, part[k]);
		ts_str_add(out, ")</span>\n");
	}
	ts_str_add(out, "</div>\n");
}

static void add_run(struct ts_str *out, const struct ts_record_run *run, size_t number)
{
	const double work = (double)(run->last - run->first) * (double)run->particles;

	ts_str_addf(out,
		    "<tr><td>%zu</td><td class=\"n\">%" PRId64 "</td><td class=\"n\">%" PRId64
		    "</td><td class=\"n\">%zu</td><td class=\"n\">",
		    number, run->first, run->last, run->particles);
	ts_page_duration(out, run->wall);
	ts_str_addf(out, "</td><td class=\"n\">");
	if (work > 0)
		ts_str_addf(out, "%.3g", 1e9 * run->wall / work);
	ts_str_add(out, "</td></tr>\n");
}

static void add_runs(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	struct ts_str *out = &page->out;

	ts_str_addf(out,
		    "<details%s><summary>%" PRId64
		    " run%s</summary><div><table>\n<thead><tr><th>Run</th><th class=\"n\">first step</th><th "
		    "class=\"n\">last</th><th class=\"n\">particles</th><th class=\"n\">wall time</th><th "
		    "class=\"n\">ns per particle and step</th></tr></thead>\n"
		    "<tbody>\n",
		    r->nruns <= 6 ? " open" : "", r->runs, r->runs == 1 ? "" : "s");
	for (size_t k = 0; k < r->nruns; k++)
		add_run(out, &r->run[k], k + 1);
	ts_str_add(out, "</tbody>\n</table>");
	if ((size_t)r->runs > r->nruns) {
		ts_str_addf(out, "<p class=\"soft\">%" PRId64 " more runs took ",
			    r->runs - (int64_t)r->nruns);
		ts_page_duration(out, r->rest.wall);
		ts_str_add(out, ".</p>");
	}
	ts_str_add(out, "</div></details>\n");
}

void ts_page_times(struct ts_page *page)
{
	if (!page->record->nruns)
		return;
	ts_page_section(&page->out, "times", "Where time went");
	add_parts(page);
	add_runs(page);
	ts_page_end_section(&page->out);
}

/* ---- energy ledgers */

static void add_name(struct ts_str *out, const char *name)
{
	for (; *name; name++) {
		const char c = *name == '_'		      ? ' '
			       : *name >= 'A' && *name <= 'Z' ? (char)(*name - 'A' + 'a')
							      : *name;

		ts_page_text_n(out, &c, 1);
	}
}

static void add_ledger(struct ts_page *page, const struct ts_record_ledger *l)
{
	struct ts_str *out = &page->out;
	double largest = 0;

	for (size_t k = 0; k < l->n; k++)
		largest = fmax(largest, isfinite(l->value[k]) ? fabs(l->value[k]) : 0);
	ts_str_add(out, "<p>fix ");
	ts_page_text(out, l->id);
	ts_str_addf(out,
		    " energy/ledger at step %" PRId64
		    "; zeros are left out</p>\n<div class=\"scroll\"><table>\n<tbody>\n",
		    l->step);
	for (size_t k = 0; k < l->n; k++) {
		const double v = l->value[k];

		if (!(v < 0) && !(v > 0))
			continue;
		ts_str_add(out, "<tr><td>");
		add_name(out, l->name ? l->name[k] : "");
		ts_str_addf(out,
			    "</td><td class=\"n\">%.6g</td><td class=\"bar\"><i%s "
			    "style=\"width:%.2f%%\"></i></td></tr>\n",
			    v, v < 0 ? " class=\"minus\"" : "", 100 * fmin(fabs(v) / largest, 1));
	}
	ts_str_add(out, "</tbody>\n</table></div>\n");
}

void ts_page_ledgers(struct ts_page *page)
{
	const struct ts_record *r = page->record;

	if (!r->nledgers)
		return;
	ts_page_section(&page->out, "energy", "Energy");
	ts_str_add(&page->out, "<p class=\"soft\">total - total(0) = forces + drive + moved - lost + closure "
			       "+ drift</p>\n");
	for (size_t k = 0; k < r->nledgers; k++)
		add_ledger(page, &r->ledger[k]);
	ts_page_end_section(&page->out);
}
