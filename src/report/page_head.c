/* How the script has ended, the main numbers, results, warnings. */
#include <inttypes.h>
#include <string.h>
#include <sys/resource.h>

#include "particle/particles.h"
#include "report/page.h"

#include "base/banned.h"

/* ---- results */

static size_t count_verdicts(const struct ts_record *record, const char *verdict)
{
	size_t n = 0;

	for (size_t k = 0; k < record->results.n; k++)
		n += ts_ends_with(record->results.line[k].text, verdict);
	return n;
}

/* The next word of a line, *text behind it; false: there is none. */
static bool next_word(const char **text, const char **word, size_t *n)
{
	*word = *text + strspn(*text, " \t");
	*n = strcspn(*word, " \t");
	*text = *word + *n;
	return *n > 0;
}

static void add_result(struct ts_str *out, const char *line)
{
	const char *text = line, *word;
	size_t n;

	ts_str_add(out, "<tr>");
	next_word(&text, &word, &n); /* RESULT */
	for (int k = 0; next_word(&text, &word, &n); k++) {
		const char *rest = text + strspn(text, " \t");
		const bool ok = n == 2 && !memcmp(word, "ok", 2), off = n == 3 && !memcmp(word, "off", 3);

		if (!*rest && (ok || off)) {
			for (; k < 4; k++)
				ts_str_add(out, "<td></td>");
			ts_str_add(out, ok ? "<td class=\"ok\">" : "<td class=\"off\">");
		} else {
			ts_str_add(out, k ? "<td class=\"n\">" : "<td>");
		}
		ts_page_text_n(out, word, n);
		ts_str_add(out, "</td>");
	}
	ts_str_add(out, "</tr>\n");
}

void ts_page_results(struct ts_page *page)
{
	const struct ts_record_lines *r = &page->record->results;
	struct ts_str *out = &page->out;

	if (!r->n)
		return;
	ts_page_section(out, "results", "Results");
	ts_str_add(out, "<div class=\"scroll\"><table>\n<thead><tr><th>Result</th><th "
			"class=\"n\">value</th><th class=\"n\">reference</th><th "
			"class=\"n\">tolerance</th><th></th></tr></thead>\n<tbody>\n");
	for (size_t k = 0; k < r->n; k++)
		add_result(out, r->line[k].text);
	ts_str_add(out, "</tbody>\n</table></div>\n");
	if (r->more)
		ts_str_addf(out, "<p class=\"soft\">%" PRId64 " more are in the log.</p>\n", r->more);
	ts_page_end_section(out);
}

/* ---- warnings */

void ts_page_warnings(struct ts_page *page)
{
	const struct ts_record_lines *w = &page->record->warnings;
	struct ts_str *out = &page->out;

	if (!w->n)
		return;
	ts_page_section(out, "warnings", "Warnings");
	ts_str_add(out, "<div class=\"box warn\"><ul>\n");
	for (size_t k = 0; k < w->n; k++) {
		ts_str_add(out, "<li>");
		ts_page_text(out, w->line[k].text);
		if (w->line[k].count > 1)
			ts_str_addf(out, " <small>(%" PRId64 " times)</small>", w->line[k].count);
		ts_str_add(out, "</li>\n");
	}
	ts_str_add(out, "</ul>");
	if (w->more)
		ts_str_addf(out, "<p class=\"soft\">%" PRId64 " more are in the log.</p>", w->more);
	ts_str_add(out, "</div>\n");
	ts_page_end_section(out);
}

/* ---- head */

static void add_date(struct ts_str *out, time_t at)
{
	struct tm day;
	char text[64] = "";

	if (localtime_r(&at, &day))
		strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &day);
	ts_str_add(out, text);
}

static void add_ending(struct ts_page *page)
{
	static const struct {
		const char *sort, *word;
	} endings[] = { [TS_RECORD_RUNNING] = { "warn", "running" },
			[TS_RECORD_ENDED] = { "ok", "finished" },
			[TS_RECORD_FAILED] = { "off", "failed" },
			[TS_RECORD_STOPPED] = { "warn", "interrupted" } };
	const struct ts_record *r = page->record;
	const size_t ok = count_verdicts(r, " ok"), off = count_verdicts(r, " off");
	struct ts_str *out = &page->out;

	ts_str_addf(out, "<p><span class=\"badge %s\">%s</span> ", endings[r->end].sort,
		    endings[r->end].word);
	if (ok + off > 0)
		ts_str_addf(out, "<span class=\"badge %s\">%zu of %zu results ok</span> ", off ? "off" : "ok",
			    ok, ok + off);
	if (r->warnings.n)
		ts_str_addf(out, "<span class=\"badge warn\">%zu warning%s</span>", r->warnings.n,
			    r->warnings.n == 1 ? "" : "s");
	ts_str_add(out, "</p>\n<p class=\"soft\">Begun ");
	add_date(out, r->begun);
	ts_str_add(out, r->end == TS_RECORD_RUNNING ? "; state of " : ", ended ");
	add_date(out, time(NULL));
	if (r->end == TS_RECORD_RUNNING)
		ts_str_add(out, ". The page is renewed while the script runs; if it is not, the program has "
				"been killed.");
	ts_str_add(out, "</p>\n");
	if (page->sim->run.halted)
		ts_str_addf(out,
			    "<p>The run was ended by the script at step %" PRId64
			    ": fix halt, or the time limit of timer.</p>\n",
			    page->sim->clock.step);
	if (!r->message)
		return;
	ts_str_addf(out, "<div class=\"box %s\"><pre class=\"wrap\">",
		    r->end == TS_RECORD_FAILED ? "off" : "warn");
	ts_page_text(out, r->message);
	ts_str_add(out, "</pre></div>\n");
}

static void begin_tile(struct ts_str *out)
{
	ts_str_add(out, "<div class=\"tile\"><b>");
}

static void end_tile(struct ts_str *out, const char *label)
{
	ts_str_addf(out, "</b><span>%s</span></div>\n", label);
}

static void add_speed(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	double work = 0, wall = 0;

	for (size_t k = 0; k < r->nruns; k++) {
		work += (double)(r->run[k].last - r->run[k].first) * (double)r->run[k].particles;
		wall += r->run[k].wall;
	}
	if (!(work > 0))
		return;
	begin_tile(&page->out);
	ts_str_addf(&page->out, wall / work < 1e-6 ? "%.3g ns" : "%.4g ns", 1e9 * wall / work);
	end_tile(&page->out, "per particle and step");
}

static void add_state(struct ts_page *page)
{
	const struct tsim *sim = page->sim;
	const char *unit = ts_page_time_unit(sim);
	struct ts_str *out = &page->out;

	begin_tile(out);
	if (page->record->end == TS_RECORD_RUNNING && sim->clock.goal > sim->clock.step) {
		ts_str_addf(out, "%" PRId64 " <small>of %" PRId64 "</small>", sim->clock.step,
			    sim->clock.goal);
		end_tile(out, "steps");
	} else {
		ts_str_addf(out, "%" PRId64, page->record->steps);
		end_tile(out, "steps in all");
	}
	begin_tile(out);
	ts_str_addf(out, "%.4g%s%s", ts_sim_time(sim), unit ? " " : "", unit ? unit : "");
	end_tile(out, page->record->end == TS_RECORD_RUNNING ? "time" : "time at the end");
	begin_tile(out);
	ts_str_addf(out, "%zu", sim->particles->n);
	end_tile(out, "particles");
}

void ts_page_head(struct ts_page *page)
{
	struct ts_str *out = &page->out;
	struct rusage usage;

	add_ending(page);
	ts_str_add(out, "<div class=\"tiles\">\n");
	add_state(page);
	begin_tile(out);
	ts_page_duration(out, page->now - page->record->start);
	end_tile(out, "wall time");
	add_speed(page);
	begin_tile(out);
	ts_str_addf(out, "%d", page->sim->threads);
	end_tile(out, page->sim->threads == 1 ? "thread" : "threads");
	if (getrusage(RUSAGE_SELF, &usage) == 0) {
		begin_tile(out);
		ts_str_addf(out, "%.0f MB", (double)usage.ru_maxrss / 1024);
		end_tile(out, "memory, at most");
	}
	ts_str_add(out, "</div>\n");
}
