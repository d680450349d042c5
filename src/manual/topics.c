#include "manual/topics.h"

#include "core/sim.h"
#include "manual/help_text.h"
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
	static const char *const groups[] = { "Functions of numbers", "Functions of the time step",
					      "Functions of lists of numbers (v_NAME, c_ID, f_ID)",
					      "Functions of names" };
	size_t group = 0;

	add_title("Functions", "Functions, operators and constants of formulas", markdown, out);
	for (const struct ts_expr_function *const *t = ts_expr_functions; *t; t++, group++) {
		ts_help_heading(groups[group], markdown, out);
		for (const struct ts_expr_function *f = *t; f->name; f++)
			ts_topic_entry(f->name, f->arguments, f->help, NULL, markdown, out);
	}
	ts_help_heading("Functions of groups and regions", markdown, out);
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (const struct ts_function *f = (*s)->functions; f && f->name; f++)
			ts_topic_entry(f->name, f->arguments, f->help, NULL, markdown, out);
	ts_help_heading("Operators, in order of increasing precedence", markdown, out);
	for (const struct ts_operator *o = ts_operators; o->text; o++)
		ts_topic_entry(o->text, NULL, o->help, NULL, markdown, out);
	ts_topic_entry("-x !x", NULL,
		       "negation; logical not (1 if x is 0). They have the highest precedence: -2^2 is 4",
		       NULL, markdown, out);
	ts_help_heading("Constants", markdown, out);
	for (const struct ts_constant *c = ts_constants; c->name; c++)
		ts_topic_entry(c->name, NULL, c->help, NULL, markdown, out);
}

static void variables(const struct ts_tables *tables, bool markdown, struct ts_str *out)
{
	struct ts_str name = { 0 };

	(void)tables;
	add_title("Variables", "Styles of variables and their use", markdown, out);
	ts_help_heading("Styles", markdown, out);
	for (const struct ts_variable_style *const *v = ts_variable_styles; *v; v++) {
		ts_str_clear(&name);
		ts_str_addf(&name, "%s %s", (*v)->name, (*v)->values ? (*v)->values : "");
		ts_topic_entry(ts_str_text(&name), NULL, (*v)->help, NULL, markdown, out);
	}
	out->failed |= name.failed;
	ts_str_release(&name);
	ts_help_heading("Use", markdown, out);
	ts_topic_entry("${name} $x", NULL,
		       "replaced by the value of the variable before the line is executed", NULL, markdown,
		       out);
	ts_topic_entry("$(formula)", NULL,
		       "replaced by the value of the formula; $(formula:%.3f) in that format", NULL, markdown,
		       out);
	ts_topic_entry("v_name", NULL, "the value of the variable in a formula or as an argument", NULL,
		       markdown, out);
}

static void keywords(const struct ts_tables *tables, bool markdown, struct ts_str *out)
{
	add_title("Keywords", "Global values, for thermo_style and formulas", markdown, out);
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
		  "Per-particle values, for dumps, atom-style variables and compute property/atom", markdown,
		  out);
	ts_str_add(out, "\n");
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (size_t k = 0; (*s)->quantity_text && (q = (*s)->quantity_text(k)); k++)
			ts_topic_entry(q->name, NULL, q->help, q->unit, markdown, out);
}

const struct ts_topic ts_topics[] = {
	{ "functions", "functions, operators and constants of formulas", functions },
	{ "variables", "styles of variables and their use", variables },
	{ "keywords", "global values of the simulation", keywords },
	{ "quantities", "per-particle values", quantities },
	{ .name = NULL },
};
