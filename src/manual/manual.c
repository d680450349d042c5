#include "manual/manual.h"

#include <string.h>

#include "core/sim.h"
#include "core/unsupported_names.h"
#include "manual/help.h"
#include "manual/page_text.h"
#include "manual/topics.h"
#include "formula/expr.h"
#include "formula/variable.h"

#include "base/banned.h"

void ts_manual_index(const struct ts_tables *tables, struct ts_str *out)
{
	ts_str_add(out, "# Commands and styles\n\nGenerated from the tables of the program; `tsim -help "
			"NAME` shows the same pages. Suffixes of accelerated variants\n(/omp, /opt, /kk, "
			"/intel, /gpu) select the style itself.\n\n## language\n\n");
	for (const struct ts_topic *t = ts_topics; t->name; t++)
		ts_str_addf(out, "- [%s](%s.md) — %s\n", t->name, t->name, t->summary);
	for (int kind = TS_KIND_COMMAND; kind < TS_NKIND; kind++) {
		ts_str_addf(out, "\n## %s\n\n", ts_kind_name((enum ts_kind)kind));
		ts_help_list(tables, (enum ts_kind)kind, true, out);
	}
}

/* Finds a kind by its name or, as in scripts, by "pair_style". */
static bool find_kind(const char *word, enum ts_kind *kind)
{
	struct ts_str name = { 0 };
	bool found;

	if (ts_kind_find(word, kind))
		return true;
	if (!ts_ends_with(word, "_style"))
		return false;
	ts_str_add_n(&name, word, strlen(word) - strlen("_style"));
	found = ts_kind_find(ts_str_text(&name), kind);
	ts_str_release(&name);
	return found;
}

/* Appends a line for each entry of the tables with this name that is not a style. */
static void add_other_entries(const struct ts_tables *tables, const char *name, struct ts_str *out)
{
	const struct ts_quantity *q;
	const struct ts_expr_function *f = ts_expr_function_find(name);
	const struct ts_keyword *k = ts_keyword_find(tables, name);
	const struct ts_function *g = ts_function_find(tables, name);

	if (f)
		ts_topic_entry(f->name, f->arguments, f->help, "function of formulas", false, out);
	if (g)
		ts_topic_entry(g->name, g->arguments, g->help, "function of formulas", false, out);
	if (k)
		ts_topic_entry(k->name, NULL, k->help, "keyword of thermo_style and formulas", false, out);
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (size_t i = 0; (*s)->quantity_text && (q = (*s)->quantity_text(i)); i++)
			if (ts_streq(q->name, name))
				ts_topic_entry(q->name, NULL, q->help, "quantity of each particle", false,
					       out);
	for (const struct ts_variable_style *const *v = ts_variable_styles; *v; v++)
		if (ts_streq((*v)->name, name))
			ts_topic_entry((*v)->name, NULL, (*v)->help, "style of variables", false, out);
	for (const struct ts_unsupported *w = ts_unsupported_table; w->names; w++)
		if (ts_unsupported_names(w, name))
			ts_str_addf(out, "  %s %s of LIGGGHTS or LAMMPS: %s\n", ts_kind_name(w->kind), name,
				    w->remark);
}

static void add_suggestion(const struct ts_tables *tables, const char *name, const char *of,
			   struct ts_str *out)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	for (const struct ts_style *const *s = tables->styles; *s; s++)
		if (!of || ts_streq(ts_kind_name((*s)->kind), of))
			ts_suggest_try(&suggest, (*s)->name);
	for (const struct ts_topic *t = ts_topics; !of && t->name; t++)
		ts_suggest_try(&suggest, t->name);
	for (int kind = TS_KIND_COMMAND; !of && kind < TS_NKIND; kind++)
		ts_suggest_try(&suggest, ts_kind_name((enum ts_kind)kind));
	ts_str_addf(out, "there is no %s '%s'%s", of ? of : "kind or style", name, ts_suggest_text(&suggest));
}

/* Appends the styles whose name contains the word, and the passages that contain it; a message if there are none. A
 * word that is like a name, and is on one page only, is misspelled. */
static void add_similar(const struct ts_tables *tables, const char *name, struct ts_str *out,
			struct ts_str *message)
{
	struct ts_str passages = { 0 };
	size_t pages;

	for (const struct ts_style *const *s = tables->styles; *s; s++)
		if (strstr((*s)->name, name))
			ts_str_addf(out, "  %-8s %-20s %s\n", ts_kind_name((*s)->kind), (*s)->name,
				    (*s)->summary);
	add_suggestion(tables, name, NULL, message);
	pages = ts_manual_search(tables, name, &passages);
	if (out->length || pages > 1 || (pages && !strstr(ts_str_text(message), "did you mean"))) {
		ts_str_addf(out, "%s%s", out->length && pages ? "\n" : "",
			    pages ? ts_str_text(&passages) : "");
	} else if (!strstr(ts_str_text(message), "did you mean")) {
		ts_str_clear(message);
		ts_str_add(message, ts_str_text(&passages));
	}
	ts_str_release(&passages);
}

static void add_pages(const struct ts_tables *tables, const char *name, const enum ts_kind *of,
		      struct ts_str *out)
{
	for (const struct ts_style *const *s = tables->styles; *s; s++)
		if ((!of || (*s)->kind == *of) && ts_style_find(tables, (*s)->kind, name) == *s) {
			ts_str_add(out, out->length ? "\n\n" : "");
			ts_help_page(*s, false, out);
		}
}

/* Appends the page of a style, or the reason why there is none. */
static bool add_style_page(const struct ts_tables *tables, const char *name, enum ts_kind kind,
			   struct ts_str *out)
{
	const struct ts_unsupported *unsupported = ts_unsupported_find(kind, name);

	add_pages(tables, name, &kind, out);
	if (!out->length && unsupported)
		ts_str_addf(out, "  %s %s of LIGGGHTS or LAMMPS: %s\n", ts_kind_name(kind), name,
			    unsupported->remark);
	if (out->length)
		return true;
	add_suggestion(tables, name, ts_kind_name(kind), out);
	return false;
}

/* Appends the text of a page of doc/ or of the comment of an example. */
static void add_document(const char *name, struct ts_str *out)
{
	const char *heading = "";

	for (const struct ts_page_text *t = ts_page_texts; t->page; t++) {
		if (!ts_streq(t->page, name))
			continue;
		if (!out->length)
			ts_str_addf(out, "%s: %s\n", t->page, t->title);
		if (!ts_streq(t->heading, heading))
			ts_str_addf(out, "\n%s\n", t->heading);
		heading = t->heading;
		ts_str_addf(out, "\n%s\n", t->text);
	}
}

static void add_word(const struct ts_tables *tables, const char *name, struct ts_str *out,
		     struct ts_str *message)
{
	enum ts_kind kind;

	add_pages(tables, name, NULL, out);
	if (ts_kind_find(name, &kind)) {
		ts_str_add(out, out->length ? "\n\n" : "");
		ts_help_list(tables, kind, false, out);
		ts_str_addf(out, "\n'tsim -help %s NAME' shows the page of one of them\n", name);
	}
	add_other_entries(tables, name, out);
	if (!out->length)
		add_document(name, out);
	if (!out->length)
		add_similar(tables, name, out, message);
}

/* Whether the first word is hardly said of anything but a style: "fix indent", not "flow rate". */
static bool is_kind_only(const char *word, enum ts_kind kind)
{
	return kind == TS_KIND_FIX || kind == TS_KIND_COMPUTE || ts_ends_with(word, "_style");
}

/* There is no such style: what the manual has about the word of its name. */
static bool add_pages_about(const struct ts_tables *tables, const char *name, struct ts_str *out)
{
	struct ts_str hits = { 0 };

	size_t pages = ts_manual_search(tables, name, &hits);

	if (pages)
		ts_str_addf(out, "; %s", ts_str_text(&hits));
	ts_str_release(&hits);
	return pages > 0;
}

/* For "KIND NAME": true if it is such a name, or a misspelled one; otherwise it may be a phrase. */
static bool find_style(const struct ts_tables *tables, const char *words, struct ts_str *out, bool *found)
{
	const char *blank = strchr(words, ' ');
	struct ts_str first = { 0 };
	enum ts_kind kind;
	bool style, only;

	ts_str_add_n(&first, words, blank ? (size_t)(blank - words) : 0);
	style = blank && find_kind(ts_str_text(&first), &kind) && !strchr(blank + 1, ' ');
	only = style && is_kind_only(ts_str_text(&first), kind);
	ts_str_release(&first);
	if (!style)
		return false;
	*found = add_style_page(tables, blank + 1, kind, out);
	if (!*found && only && !strstr(ts_str_text(out), "did you mean"))
		*found = add_pages_about(tables, blank + 1, out);
	return *found || only || strstr(ts_str_text(out), "did you mean");
}

bool ts_manual_find(const struct ts_tables *tables, const char *words, struct ts_str *out)
{
	struct ts_str message = { 0 };
	bool found = false;

	for (const struct ts_topic *t = ts_topics; t->name; t++)
		if (ts_streq(t->name, words)) {
			t->page(tables, false, out);
			return true;
		}
	if (find_style(tables, words, out, &found))
		return found;
	ts_str_clear(out);
	if (!strchr(words, ' '))
		add_word(tables, words, out, &message);
	else if (ts_manual_search(tables, words, &message))
		ts_str_add(out, ts_str_text(&message));
	found = out->length > 0;
	if (!found)
		ts_str_add(out, ts_str_text(&message));
	ts_str_release(&message);
	return found;
}
