#include "script/manual.h"

#include <string.h>

#include "core/help.h"
#include "core/known.h"
#include "core/sim.h"
#include "script/expr.h"
#include "script/variable.h"

#include "base/banned.h"

static void item(const char *name, const char *arguments, const char *help, const char *unit,
		 bool markdown, struct ts_str *out)
{
	struct ts_str title = { 0 }, text = { 0 };

	ts_str_addf(&title, arguments ? "%s(%s)" : "%s", name, arguments);
	ts_str_add(&text, help ? help : "");
	if (unit && *unit)
		ts_str_addf(&text, " (%s)", unit);
	ts_help_item(ts_str_text(&title), ts_str_text(&text), markdown, out);
	out->failed |= title.failed || text.failed;
	ts_str_release(&title);
	ts_str_release(&text);
}

static void title(const char *text, const char *summary, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "# %s\n\n%s.\n" : "%s: %s\n", text, summary);
}

static void functions(bool markdown, struct ts_str *out)
{
	static const char *const groups[] = { "Of numbers", "Of the step",
					      "Of lists of numbers (v_NAME, c_ID, f_ID)",
					      "Of names" };
	size_t group = 0;

	title("Functions", "what formulas can call", markdown, out);
	for (const struct ts_expr_function *const *t = ts_expr_functions; *t; t++, group++) {
		ts_help_heading(groups[group], markdown, out);
		for (const struct ts_expr_function *f = *t; f->name; f++)
			item(f->name, f->arguments, f->help, NULL, markdown, out);
	}
	ts_help_heading("Of groups and regions", markdown, out);
	for (const struct ts_system_style *const *s = ts_system_table; *s; s++)
		for (const struct ts_function *f = (*s)->functions; f && f->name; f++)
			item(f->name, f->arguments, f->help, NULL, markdown, out);
	ts_help_heading("Operators, those that bind least first", markdown, out);
	for (const struct ts_operator *o = ts_operators; o->text; o++)
		item(o->text, NULL, o->help, NULL, markdown, out);
	item("-x !x", NULL, "negative; 1 if 0. They bind before all others: -2^2 is 4", NULL,
	     markdown, out);
	ts_help_heading("Constants", markdown, out);
	for (const struct ts_constant *c = ts_constants; c->name; c++)
		item(c->name, NULL, c->help, NULL, markdown, out);
}

static void variables(bool markdown, struct ts_str *out)
{
	struct ts_str name = { 0 };

	title("Variables", "what the styles of variables stand for", markdown, out);
	ts_help_heading("Styles", markdown, out);
	for (const struct ts_variable_style *const *v = ts_variable_styles; *v; v++) {
		ts_str_clear(&name);
		ts_str_addf(&name, "%s %s", (*v)->name, (*v)->values ? (*v)->values : "");
		item(ts_str_text(&name), NULL, (*v)->help, NULL, markdown, out);
	}
	out->failed |= name.failed;
	ts_str_release(&name);
	ts_help_heading("Use", markdown, out);
	item("${name} $x", NULL, "puts the value into the line before it is run", NULL, markdown,
	     out);
	item("$(formula)", NULL, "the value of a formula; $(formula:%.3f) with that format", NULL,
	     markdown, out);
	item("v_name", NULL, "the value inside a formula or as an argument", NULL, markdown, out);
}

static void keywords(bool markdown, struct ts_str *out)
{
	title("Keywords", "numbers of the whole simulation, for thermo_style and formulas", markdown,
	      out);
	for (const struct ts_system_style *const *s = ts_system_table; *s; s++) {
		if (!(*s)->keywords)
			continue;
		ts_help_heading((*s)->style.name, markdown, out);
		for (const struct ts_keyword *k = (*s)->keywords; k->name; k++)
			item(k->name, NULL, k->help, k->unit, markdown, out);
	}
}

static void quantities(bool markdown, struct ts_str *out)
{
	const struct ts_quantity *q;

	title("Quantities",
	      "numbers of each particle, for dumps, atom-style variables and compute property/atom",
	      markdown, out);
	ts_str_add(out, "\n");
	for (const struct ts_system_style *const *s = ts_system_table; *s; s++)
		for (size_t k = 0; (*s)->quantity_text && (q = (*s)->quantity_text(k)); k++)
			item(q->name, NULL, q->help, q->unit, markdown, out);
}

const struct ts_topic ts_topics[] = {
	{ "functions", "functions, operators and constants of formulas", functions },
	{ "variables", "styles of variables and their use", variables },
	{ "keywords", "numbers of the whole simulation", keywords },
	{ "quantities", "numbers of each particle", quantities },
	{ .name = NULL },
};

void ts_manual_index(struct ts_str *out)
{
	ts_str_add(out, "# Commands and styles\n\nMade from the tables of the program; `tsim -help "
			"NAME` shows the same pages. Endings of accelerated variants\n(/omp, /opt, "
			"/kk, /intel, /gpu) are the style itself.\n\n## language\n\n");
	for (const struct ts_topic *t = ts_topics; t->name; t++)
		ts_str_addf(out, "- [%s](%s.md) — %s\n", t->name, t->name, t->summary);
	for (int kind = TS_KIND_COMMAND; kind < TS_NKIND; kind++) {
		ts_str_addf(out, "\n## %s\n\n", ts_kind_name((enum ts_kind)kind));
		ts_help_list((enum ts_kind)kind, true, out);
	}
}

/* "pair_style" is how scripts say the kind. */
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

/* One line for everything in the tables that is not a style. */
static void find_words(const char *name, struct ts_str *out)
{
	const struct ts_quantity *q;
	const struct ts_expr_function *f = ts_expr_function_find(name);
	const struct ts_keyword *k = ts_keyword_find(NULL, name);
	const struct ts_function *g = ts_function_find(NULL, name);

	if (f)
		item(f->name, f->arguments, f->help, "function of formulas", false, out);
	if (g)
		item(g->name, g->arguments, g->help, "function of formulas", false, out);
	if (k)
		item(k->name, NULL, k->help, "keyword of thermo_style and formulas", false, out);
	for (const struct ts_system_style *const *s = ts_system_table; *s; s++)
		for (size_t i = 0; (*s)->quantity_text && (q = (*s)->quantity_text(i)); i++)
			if (ts_streq(q->name, name))
				item(q->name, NULL, q->help, "quantity of each particle", false,
				     out);
	for (const struct ts_variable_style *const *v = ts_variable_styles; *v; v++)
		if (ts_streq((*v)->name, name))
			item((*v)->name, NULL, (*v)->help, "style of variables", false, out);
	for (const struct ts_known *w = ts_known_table; w->name; w++)
		if (ts_glob(w->name, name))
			ts_str_addf(out, "  %s %s of LIGGGHTS or LAMMPS: %s\n", ts_kind_name(w->kind),
				    name, w->remark);
}

/* Styles in whose name the word stands, and further pages with it. */
static void find_similar(const char *name, struct ts_str *out)
{
	for (const struct ts_style *const *s = ts_style_table; *s; s++)
		if (strstr((*s)->name, name))
			ts_str_addf(out, "  %-8s %-20s %s\n", ts_kind_name((*s)->kind), (*s)->name,
				    (*s)->summary);
	ts_str_add(out, out->length ? "\n" : "");
	ts_manual_search(name, out);
}

static void find_pages(const char *name, const enum ts_kind *of, struct ts_str *out)
{
	for (const struct ts_style *const *s = ts_style_table; *s; s++)
		if ((!of || (*s)->kind == *of) && ts_style_find((*s)->kind, name) == *s) {
			ts_str_add(out, out->length ? "\n\n" : "");
			ts_help_page(*s, false, out);
		}
}

static void suggest(const char *name, const char *of, struct ts_str *out)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	for (const struct ts_style *const *s = ts_style_table; *s; s++)
		if (!of || ts_streq(ts_kind_name((*s)->kind), of))
			ts_suggest_try(&suggest, (*s)->name);
	for (const struct ts_topic *t = ts_topics; !of && t->name; t++)
		ts_suggest_try(&suggest, t->name);
	for (int kind = TS_KIND_COMMAND; !of && kind < TS_NKIND; kind++)
		ts_suggest_try(&suggest, ts_kind_name((enum ts_kind)kind));
	ts_str_addf(out, "there is no %s '%s'%s", of ? of : "kind or style", name,
		    ts_suggest_text(&suggest));
}

/* A style of a kind: its page, or why there is none. */
static bool find_style(const char *name, enum ts_kind kind, struct ts_str *out)
{
	const struct ts_known *known = ts_known_find(kind, name);

	find_pages(name, &kind, out);
	if (!out->length && known)
		ts_str_addf(out, "  %s %s of LIGGGHTS or LAMMPS: %s\n", ts_kind_name(kind), name,
			    known->remark);
	if (out->length)
		return true;
	suggest(name, ts_kind_name(kind), out);
	return false;
}

static void find_word(const char *name, struct ts_str *out)
{
	enum ts_kind kind;

	find_pages(name, NULL, out);
	if (ts_kind_find(name, &kind)) {
		ts_str_add(out, out->length ? "\n\n" : "");
		ts_help_list(kind, false, out);
		ts_str_addf(out, "\n'tsim -help %s NAME' shows the page of one of them\n", name);
	}
	find_words(name, out);
	if (!out->length)
		find_similar(name, out);
}

bool ts_manual_find(const char *words, struct ts_str *out)
{
	const char *blank = strchr(words, ' ');
	struct ts_str first = { 0 };
	enum ts_kind kind;
	bool style;

	for (const struct ts_topic *t = ts_topics; t->name; t++)
		if (ts_streq(t->name, words)) {
			t->page(false, out);
			return true;
		}
	ts_str_add_n(&first, words, blank ? (size_t)(blank - words) : 0);
	style = blank && find_kind(ts_str_text(&first), &kind) && !strchr(blank + 1, ' ');
	ts_str_release(&first);
	if (style)
		return find_style(blank + 1, kind, out);
	if (!blank)
		find_word(words, out);
	if (out->length || ts_manual_search(words, out))
		return true;
	suggest(words, NULL, out);
	return false;
}
