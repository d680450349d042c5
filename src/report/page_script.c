/* What was run: command line, variables, settings, plan, scripts. */
#include <inttypes.h>
#include <string.h>

#include "report/page.h"

#include "base/banned.h"

enum { LONGEST_SCRIPT = 200000, LONGEST_LIST = 60000, MOST_SCRIPTS = 40 }; /* bytes shown of each */

static void begin_details(struct ts_str *out, const char *title)
{
	ts_str_add(out, "<details><summary>");
	ts_page_text(out, title);
	ts_str_add(out, "</summary><div>");
}

static void end_details(struct ts_str *out)
{
	ts_str_add(out, "</div></details>\n");
}

/* The start of a comment: a # outside of quotes; n: there is none. */
static size_t find_comment(const char *line, size_t n)
{
	char quote = 0;

	for (size_t k = 0; k < n; k++) {
		if (quote)
			quote = line[k] == quote ? 0 : quote;
		else if (line[k] == '"' || line[k] == '\'')
			quote = line[k];
		else if (line[k] == '#')
			return k;
	}
	return n;
}

static void add_code(struct ts_page *page, const char *name, const char *text)
{
	const struct ts_place *bad = &page->record->error_at;
	struct ts_str *out = &page->out;
	int line = 1;

	ts_str_add(out, "<pre class=\"code\">");
	for (const char *at = text; *at && at - text < LONGEST_SCRIPT; line++) {
		const size_t n = strcspn(at, "\n"), code = find_comment(at, n);
		const bool marked = bad->line == line && bad->file && ts_streq(bad->file, name);

		ts_str_add(out, marked ? "<b class=\"bad\">" : "<b>");
		ts_page_text_n(out, at, code);
		if (code < n) {
			ts_str_add(out, "<i>");
			ts_page_text_n(out, at + code, n - code);
			ts_str_add(out, "</i>");
		}
		ts_str_add(out, "</b>\n");
		at += n + (at[n] == '\n');
	}
	ts_str_add(out, "</pre>");
	if (strlen(text) >= LONGEST_SCRIPT)
		ts_str_add(out, "<p class=\"soft\">The rest is left out.</p>");
}

static bool is_shown_before(struct ts_page *page, size_t k, const char *name)
{
	const struct tsim *sim = page->sim;
	const char *other;

	while (k-- > 0)
		if (sim->script_api->script_text(sim->script_api_data, k, &other) && ts_streq(other, name))
			return true;
	return false;
}

static void add_scripts(struct ts_page *page)
{
	const struct tsim *sim = page->sim;
	const char *name, *text;

	for (size_t k = 0;
	     k < MOST_SCRIPTS && (text = sim->script_api->script_text(sim->script_api_data, k, &name)); k++) {
		if (is_shown_before(page, k, name))
			continue;
		begin_details(&page->out, name);
		add_code(page, name, text);
		end_details(&page->out);
	}
}

static void add_plain(struct ts_page *page, const char *title, const char *text)
{
	const size_t n = strlen(text), shown = n < LONGEST_LIST ? n : LONGEST_LIST;

	if (!n)
		return;
	begin_details(&page->out, title);
	ts_str_add(&page->out, "<pre>");
	ts_page_text_n(&page->out, text, shown);
	ts_str_add(&page->out, "</pre>");
	if (shown < n)
		ts_str_add(&page->out, "<p class=\"soft\">The rest is left out.</p>");
	end_details(&page->out);
}

static void add_variables(struct ts_page *page)
{
	const struct tsim *sim = page->sim;
	struct ts_str text = { 0 };

	if (sim->script_api->list_variables(sim->script_api_data, &text) == TS_OK)
		add_plain(page, "Variables", ts_str_text(&text));
	page->out.failed |= text.failed;
	ts_str_release(&text);
}

static void add_settings(struct ts_page *page)
{
	const struct ts_record_lines *s = &page->record->settings;

	if (!s->n)
		return;
	begin_details(&page->out, "Settings, with those that are defaults");
	ts_str_add(&page->out, "<pre class=\"wrap\">");
	for (size_t k = 0; k < s->n; k++) {
		ts_page_text(&page->out, s->line[k].text);
		ts_str_add(&page->out, "\n");
	}
	ts_str_add(&page->out, "</pre>");
	if (s->more)
		ts_str_addf(&page->out, "<p class=\"soft\">%" PRId64 " more lines are in the log.</p>",
			    s->more);
	end_details(&page->out);
}

void ts_page_script(struct ts_page *page)
{
	ts_page_section(&page->out, "script", "What was run");
	if (page->record->command) {
		ts_str_add(&page->out, "<div class=\"box\"><pre class=\"wrap\">");
		ts_page_text(&page->out, page->record->command);
		ts_str_add(&page->out, "</pre></div>\n");
	}
	add_plain(page, "Plan of the last run", ts_str_text(&page->record->plan));
	if (page->sim->script_api)
		add_variables(page);
	add_settings(page);
	if (page->sim->script_api)
		add_scripts(page);
	ts_page_end_section(&page->out);
}
