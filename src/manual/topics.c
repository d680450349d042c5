#include "manual/topics.h"

#include "core/sim.h"
#include "manual/help.h"
#include "formula/expr.h"
#include "formula/variable.h"

#include "base/banned.h"

void ts_topic_entry(const char *name, const char *arguments, const char *help, const char *unit,
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

static void add_title(const char *text, const char *summary, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "# %s\n\n%s.\n" : "%s: %s\n", text, summary);
}

static void functions(const struct ts_tables *tables, bool markdown, struct ts_str *out)
{
	static const char *const groups[] = { "Of numbers", "Of the step",
					      "Of lists of numbers (v_NAME, c_ID, f_ID)", "Of names" };
	size_t group = 0;

	add_title("Functions", "what formulas can call", markdown, out);
	for (const struct ts_expr_function *const *t = ts_expr_functions; *t; t++, group++) {
		ts_help_heading(groups[group], markdown, out);
		for (const struct ts_expr_function *f = *t; f->name; f++)
			ts_topic_entry(f->name, f->arguments, f->help, NULL, markdown, out);
	}
	ts_help_heading("Of groups and regions", markdown, out);
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (const struct ts_function *f = (*s)->functions; f && f->name; f++)
			ts_topic_entry(f->name, f->arguments, f->help, NULL, markdown, out);
	ts_help_heading("Operators, those that bind least first", markdown, out);
	for (const struct ts_operator *o = ts_operators; o->text; o++)
		ts_topic_entry(o->text, NULL, o->help, NULL, markdown, out);
	ts_topic_entry("-x !x", NULL, "negative; 1 if 0. They bind before all others: -2^2 is 4", NULL,
		       markdown, out);
	ts_help_heading("Constants", markdown, out);
	for (const struct ts_constant *c = ts_constants; c->name; c++)
		ts_topic_entry(c->name, NULL, c->help, NULL, markdown, out);
}

static void variables(const struct ts_tables *tables, bool markdown, struct ts_str *out)
{
	struct ts_str name = { 0 };

	(void)tables;
	add_title("Variables", "what the styles of variables stand for", markdown, out);
	ts_help_heading("Styles", markdown, out);
	for (const struct ts_variable_style *const *v = ts_variable_styles; *v; v++) {
		ts_str_clear(&name);
		ts_str_addf(&name, "%s %s", (*v)->name, (*v)->values ? (*v)->values : "");
		ts_topic_entry(ts_str_text(&name), NULL, (*v)->help, NULL, markdown, out);
	}
	out->failed |= name.failed;
	ts_str_release(&name);
	ts_help_heading("Use", markdown, out);
	ts_topic_entry("${name} $x", NULL, "puts the value into the line before it is run", NULL, markdown,
		       out);
	ts_topic_entry("$(formula)", NULL, "the value of a formula; $(formula:%.3f) with that format", NULL,
		       markdown, out);
	ts_topic_entry("v_name", NULL, "the value inside a formula or as an argument", NULL, markdown, out);
}

static void keywords(const struct ts_tables *tables, bool markdown, struct ts_str *out)
{
	add_title("Keywords", "numbers of the whole simulation, for thermo_style and formulas", markdown,
		  out);
	for (const struct ts_system_style *const *s = tables->systems; *s; s++) {
		if (!(*s)->keywords)
			continue;
		ts_help_heading((*s)->style.name, markdown, out);
		for (const struct ts_keyword *k = (*s)->keywords; k->name; k++)
			ts_topic_entry(k->name, NULL, k->help, k->unit, markdown, out);
	}
}

static void quantities(const struct ts_tables *tables, bool markdown, struct ts_str *out)
{
	const struct ts_quantity *q;

	add_title("Quantities",
		  "numbers of each particle, for dumps, atom-style variables and compute property/atom",
		  markdown, out);
	ts_str_add(out, "\n");
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (size_t k = 0; (*s)->quantity_text && (q = (*s)->quantity_text(k)); k++)
			ts_topic_entry(q->name, NULL, q->help, q->unit, markdown, out);
}

const struct ts_topic ts_topics[] = {
	{ "functions", "functions, operators and constants of formulas", functions },
	{ "variables", "styles of variables and their use", variables },
	{ "keywords", "numbers of the whole simulation", keywords },
	{ "quantities", "numbers of each particle", quantities },
	{ .name = NULL },
};
