#include "manual/help.h"

#include <ctype.h>
#include <string.h>

#include "manual/help_arguments.h"
#include "manual/help_text.h"

#include "base/banned.h"

void ts_help_file_name(const struct ts_style *style, struct ts_str *out)
{
	ts_str_addf(out, "%s_", ts_kind_name(style->kind));
	for (const char *c = style->name; *c; c++)
		ts_str_add_n(out, *c == '/' ? "_" : c, 1);
	ts_str_add(out, ".md");
}

/* Appends the reference of an output in scripts: c_ID, f_ID[k] ... */
static void add_reference(const struct ts_style *style, const struct ts_value *v, struct ts_str *out)
{
	bool indexed = v->shape == TS_VECTOR || (v->shape != TS_SCALAR && v->column_names);
	const char *brackets = v->shape == TS_ARRAY ? "[i][j]" : indexed ? "[k]" : "";

	ts_str_addf(out, "%s%s", style->kind == TS_KIND_COMPUTE ? "c_ID" : "f_ID", brackets);
}

/* The same output as the one before, of another length: an instance gives one of them. */
static bool is_variant(const struct ts_value *values, const struct ts_value *v)
{
	return v > values && v->shape == v[-1].shape && ts_streq(v->name, v[-1].name);
}

static void add_values(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	static const char *const shapes[] = { [TS_SCALAR] = "a number",
					      [TS_VECTOR] = "a list of numbers",
					      [TS_PERATOM] = "one per particle",
					      [TS_LOCAL] = "rows for dump local",
					      [TS_ARRAY] = "a table",
					      [TS_SURFACE] = "a row for each triangle" };
	struct ts_str name = { 0 }, text = { 0 };

	if (!style->values || !style->values->name)
		return;
	ts_help_heading("Output", markdown, out);
	for (const struct ts_value *v = style->values; v->name; v++) {
		if (is_variant(style->values, v))
			continue;
		ts_str_clear(&name);
		ts_str_clear(&text);
		add_reference(style, v, &name);
		ts_str_addf(&text, "%s: %s (%s%s%s)", v->name, v->help ? v->help : "", shapes[v->shape],
			    v->unit && *v->unit ? ", in " : "", v->unit ? v->unit : "");
		for (size_t k = 0; v->column_names && k < v->columns; k++)
			ts_str_addf(&text, "%s[%zu] %s", k ? ", " : ": ", k + 1, v->column_names[k]);
		ts_help_entry(&name, &text, 0, markdown, out);
	}
	out->failed |= name.failed || text.failed;
	ts_str_release(&name);
	ts_str_release(&text);
}

/* The first letter is made a capital. */
static void add_summary(const struct ts_style *style, struct ts_str *out)
{
	char first[2] = { (char)toupper((unsigned char)style->summary[0]), '\0' };

	ts_str_addf(out, "%s%s", first, style->summary[0] ? style->summary + 1 : "");
}

static void add_other_names(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	const char *name;

	for (size_t k = 0; (name = ts_style_other_name(style, k)); k++)
		ts_str_addf(out,
			    markdown ? "\n`%s` is another name of it.\n" : "\n  %s is another name of it.\n",
			    name);
}

static void add_description(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	if (!style->doc)
		return;
	ts_help_heading("Description", markdown, out);
	ts_help_paragraphs(style->doc, markdown, out);
	for (const char *const *more = style->doc_more; more && *more; more++) {
		ts_str_add(out, "\n");
		ts_help_paragraphs(*more, markdown, out);
	}
	add_other_names(style, markdown, out);
}

void ts_help_page(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "# %s %s\n\n" : "%s %s: ", ts_kind_name(style->kind), style->name);
	add_summary(style, out);
	ts_str_add(out, markdown ? ".\n" : "\n");
	if (style->purpose) {
		ts_str_add(out, "\n");
		ts_help_paragraphs(style->purpose, markdown, out);
	}
	if (style->example) {
		ts_help_heading("Example", markdown, out);
		ts_help_block(style->example, markdown, out);
	}
	ts_help_syntax(style, markdown, out);
	ts_help_arguments(style, markdown, out);
	ts_help_coefficients(style, markdown, out);
	add_description(style, markdown, out);
	ts_help_further_arguments(style, markdown, out);
	add_values(style, markdown, out);
	if (style->cite) {
		ts_help_heading("Source", markdown, out);
		ts_help_paragraphs(style->cite, markdown, out);
	}
}

void ts_help_list(const struct ts_tables *tables, enum ts_kind kind, bool markdown, struct ts_str *out)
{
	for (const struct ts_style *const *s = tables->styles; *s; s++) {
		if ((*s)->kind != kind)
			continue;
		if (markdown) {
			ts_str_addf(out, "- [%s](", (*s)->name);
			ts_help_file_name(*s, out);
			ts_str_add(out, ") — ");
		} else {
			ts_str_addf(out, "  %-16s ", (*s)->name);
		}
		add_summary(*s, out);
		ts_str_add(out, "\n");
	}
}
