#include "report/page.h"

#include "base/clock.h"
#include "io/replace.h"

#include "base/banned.h"

/* What has taken less, s, is not told. */
static const double LEAST_COST = 1e-3;

static void add_link(struct ts_str *out, bool shown, const char *id, const char *text)
{
	if (shown)
		ts_str_addf(out, "<a href=\"#%s\">%s</a>", id, text);
}

static void add_navigation(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	bool pictures = false;

	for (size_t k = 0; k < r->nviews; k++)
		pictures |= r->view[k].first.data || r->view[k].last.data || r->view[k].n;
	ts_str_add(&page->out, "<nav>");
	add_link(&page->out, r->results.n > 0, "results", "Results");
	add_link(&page->out, r->warnings.n > 0, "warnings", "Warnings");
	add_link(&page->out, pictures, "pictures", "Pictures");
	add_link(&page->out, r->ntables > 0, "log", "Log");
	add_link(&page->out, r->nledgers > 0, "energy", "Energy");
	add_link(&page->out, r->nruns > 0, "limits", "Time step");
	add_link(&page->out, r->nruns > 0, "times", "Where time went");
	add_link(&page->out, true, "script", "What was run");
	ts_str_add(&page->out, "</nav>\n");
}

static const char *title_of(const struct ts_record *record, const struct tsim *sim)
{
	const char *name = NULL;

	if (record->title)
		return record->title;
	if (sim->script_api && sim->script_api->script_text(sim->script_api_data, 0, &name))
		return name;
	return "tsim";
}

/* While the script runs the page loads itself anew. */
static void add_begin(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	struct ts_str *out = &page->out;

	ts_str_add(out, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
			"<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n");
	if (r->end == TS_RECORD_RUNNING)
		ts_str_addf(out, "<meta http-equiv=\"refresh\" content=\"%.0f\">\n",
			    r->renew < 5 ? 5 : r->renew);
	ts_str_addf(out, "<meta name=\"generator\" content=\"tsim %s\">\n<title>", PACKAGE_VERSION);
	ts_page_text(out, title_of(r, page->sim));
	ts_str_add(out, "</title>\n<style>\n");
	ts_page_style(out);
	ts_str_add(out, "</style>\n</head>\n<body>\n<header>\n<h1>");
	ts_page_text(out, title_of(r, page->sim));
	ts_str_add(out, "</h1>\n");
}

static void add_footer(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	const double wall = page->now - r->start, cost = r->cost + r->drawing;
	struct ts_str *out = &page->out;

	ts_str_addf(out, "</main>\n<footer>tsim %s.", PACKAGE_VERSION);
	if (wall > 0 && cost > LEAST_COST) {
		ts_str_addf(out, " This report has taken %.2g %% of the time%s", 100 * cost / wall,
			    r->end == TS_RECORD_RUNNING ? " so far" : "");
		if (r->drawing > LEAST_COST)
			ts_str_addf(out, ", %.2g s of it for pictures", r->drawing);
		ts_str_add(out, ".");
	}
	ts_str_add(out, "</footer>\n</body>\n</html>\n");
}

static void make(struct ts_page *page)
{
	add_begin(page);
	ts_page_head(page);
	add_navigation(page);
	ts_str_add(&page->out, "</header>\n<main>\n");
	ts_page_results(page);
	ts_page_warnings(page);
	ts_page_pictures(page);
	ts_page_tables(page);
	ts_page_ledgers(page);
	ts_page_limits(page);
	ts_page_times(page);
	ts_page_script(page);
	add_footer(page);
}

enum ts_status ts_page_write(const struct ts_record *record, struct tsim *sim)
{
	struct ts_page page = { .record = record, .sim = sim, .now = ts_clock() };
	struct ts_replace file = { 0 };
	enum ts_status status;

	make(&page);
	status = page.out.failed || record->failed ? ts_nomem(&sim->error) : TS_OK;
	if (status == TS_OK)
		status = ts_replace_begin(&file, sim, &record->where, record->file);
	if (status == TS_OK)
		status = ts_replace_write(&file, page.out.text, page.out.length);
	if (status == TS_OK)
		status = ts_replace_commit(&file, false);
	ts_replace_abandon(&file);
	ts_str_release(&page.out);
	return status;
}
