#include "core/help.h"

#include <string.h>

#include "base/banned.h"

bool ts_kind_find(const char *name, enum ts_kind *out)
{
	for (int kind = 0; kind < TS_NKIND; kind++) {
		*out = (enum ts_kind)kind;
		if (ts_streq(ts_kind_name(*out), name))
			return true;
	}
	return false;
}

void ts_help_file_name(const struct ts_style *style, struct ts_str *out)
{
	ts_str_addf(out, "%s_", ts_kind_name(style->kind));
	for (const char *c = style->name; *c; c++)
		ts_str_add_n(out, *c == '/' ? "_" : c, 1);
	ts_str_add(out, ".md");
}

static void heading(const char *text, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "\n## %s\n\n" : "\n%s\n", text);
}

/* What stands before the arguments of the table. */
static void add_prefix(const struct ts_style *style, struct ts_str *out)
{
	static const char *const before[TS_NKIND] = {
		[TS_KIND_FIX] = "fix ID GROUP ", [TS_KIND_COMPUTE] = "compute ID GROUP ",
		[TS_KIND_REGION] = "region ID ", [TS_KIND_DUMP] = "dump ID GROUP ",
		[TS_KIND_PAIR] = "pair_style ",	 [TS_KIND_BOND] = "bond_style ",
		[TS_KIND_FLOW] = "flow_style ",
	};

	ts_str_addf(out, "%s%s", before[style->kind] ? before[style->kind] : "", style->name);
}

static void add_synopsis(const struct ts_arg *row, struct ts_str *out)
{
	for (; row && row->type != TS_ARG_END; row++) {
		ts_str_add(out, " ");
		ts_arg_synopsis(row, out);
	}
}

static const char *type_text(enum ts_arg_type type)
{
	static const char *const texts[] = {
		[TS_ARG_REAL] = "number",
		[TS_ARG_INT] = "whole number",
		[TS_ARG_BOOL] = "yes or no",
		[TS_ARG_FLAG] = "a word by itself",
		[TS_ARG_WORD] = "word",
		[TS_ARG_ENUM] = "one of the words",
		[TS_ARG_VEC3] = "three numbers",
		[TS_ARG_COORD] = "number, INF or EDGE",
		[TS_ARG_NUMBER] = "number or v_NAME",
		[TS_ARG_TYPES] = "particle types: n, *, n*, *m or n*m",
		[TS_ARG_GROUP] = "group",
		[TS_ARG_REGION] = "region",
		[TS_ARG_REF] = "c_ID, c_ID[k], f_ID, v_NAME or thermo keyword",
		[TS_ARG_MODE] = "one of the words",
		[TS_ARG_REST] = "words",
	};

	return type < sizeof texts / sizeof *texts && texts[type] ? texts[type] : "";
}

static void add_range(const struct ts_arg *row, struct ts_str *out)
{
	static const char *const ranges[] = {
		[TS_POSITIVE] = "> 0", [TS_NOT_NEGATIVE] = ">= 0", [TS_FRACTION] = "0 to 1"
	};

	if (row->range == TS_WITHIN)
		ts_str_addf(out, ", %g to %g", row->lo, row->hi);
	else if (row->range != TS_ANY)
		ts_str_addf(out, ", %s", ranges[row->range]);
}

static void add_row(const struct ts_arg *row, bool markdown, const char *indent, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "%s- `" : "  %s", indent);
	ts_arg_synopsis(row, out);
	ts_str_addf(out, markdown ? "` — %s (%s" : "\n      %s (%s", row->help ? row->help : "",
		    type_text(row->type));
	if (row->unit && *row->unit)
		ts_str_addf(out, ", in %s", row->unit);
	add_range(row, out);
	if (row->flags & TS_NULLABLE)
		ts_str_add(out, ", or NULL");
	if (row->fallback)
		ts_str_addf(out, "; default %s", row->fallback);
	else if (row->flags & TS_OPTIONAL)
		ts_str_add(out, "; may be left out");
	ts_str_add(out, ")\n");
}

static void add_rows(const struct ts_arg *row, bool markdown, const char *indent,
		     struct ts_str *out)
{
	for (; row && row->type != TS_ARG_END; row++) {
		add_row(row, markdown, indent, out);
		if (row->type != TS_ARG_MODE)
			continue;
		for (const struct ts_mode *mode = row->modes; mode->name; mode++) {
			ts_str_addf(out, markdown ? "  - `%s" : "    %s", mode->name);
			add_synopsis(mode->args, out);
			ts_str_addf(out, markdown ? "` — %s\n" : "\n      %s\n",
				    mode->help ? mode->help : "");
			add_rows(mode->args, markdown, "    ", out);
		}
	}
}

static void add_values(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	static const char *const shapes[] = { [TS_SCALAR] = "a number",
					      [TS_VECTOR] = "a vector",
					      [TS_PERATOM] = "values of each particle",
					      [TS_LOCAL] = "rows" };

	if (!style->values || !style->values->name)
		return;
	heading("Output", markdown, out);
	for (const struct ts_value *v = style->values; v->name; v++) {
		ts_str_addf(out, markdown ? "- `%s` — %s: %s" : "  %s: %s: %s", v->name,
			    shapes[v->shape], v->help ? v->help : "");
		if (v->unit && *v->unit)
			ts_str_addf(out, " (%s)", v->unit);
		for (size_t k = 0; v->column_names && k < v->columns; k++)
			ts_str_addf(out, "%s[%zu] %s", k ? ", " : "; ", k + 1, v->column_names[k]);
		ts_str_add(out, "\n");
	}
}

/* The lines of the text, each behind the indent. */
static void add_lines(const char *text, const char *indent, struct ts_str *out)
{
	while (*text) {
		size_t n = strcspn(text, "\n");

		ts_str_add(out, n ? indent : "");
		ts_str_add_n(out, text, n);
		ts_str_add(out, "\n");
		text += n + (text[n] == '\n');
	}
}

/* Lines of at most 78 characters; line ends that stand in the text are kept. */
static void add_paragraphs(const char *text, bool markdown, struct ts_str *out)
{
	size_t column = 0;

	if (markdown) {
		ts_str_addf(out, "%s\n", text);
		return;
	}
	while (*text) {
		size_t blanks = strspn(text, " "), n = blanks + strcspn(text + blanks, " \n");

		if (column && column + n > 76) {
			text += blanks;
			n -= blanks;
			column = 0;
			ts_str_add(out, "\n");
		}
		ts_str_add(out, column || !n ? "" : "  ");
		ts_str_add_n(out, text, n);
		column += n;
		text += n;
		if (*text == '\n') {
			ts_str_add(out, "\n");
			column = 0;
			text++;
		}
	}
	ts_str_add(out, column ? "\n" : "");
}

void ts_help_page(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "# %s %s\n\n%s.\n" : "%s %s: %s\n", ts_kind_name(style->kind),
		    style->name, style->summary);
	heading("Syntax", markdown, out);
	ts_str_add(out, markdown ? "```\n" : "  ");
	add_prefix(style, out);
	add_synopsis(style->args, out);
	ts_str_add(out, markdown ? "\n```\n" : "\n");
	if (style->args && style->args->type != TS_ARG_END) {
		heading("Arguments", markdown, out);
		add_rows(style->args, markdown, "", out);
	}
	add_values(style, markdown, out);
	if (style->doc) {
		heading("Description", markdown, out);
		add_paragraphs(style->doc, markdown, out);
	}
	if (style->example) {
		heading("Example", markdown, out);
		ts_str_add(out, markdown ? "```\n" : "");
		add_lines(style->example, markdown ? "" : "  ", out);
		ts_str_add(out, markdown ? "```\n" : "");
	}
	if (style->cite) {
		heading("Source", markdown, out);
		add_paragraphs(style->cite, markdown, out);
	}
}

void ts_help_list(enum ts_kind kind, bool markdown, struct ts_str *out)
{
	for (const struct ts_style *const *s = ts_style_table; *s; s++) {
		if ((*s)->kind != kind)
			continue;
		if (markdown) {
			ts_str_addf(out, "- [%s](", (*s)->name);
			ts_help_file_name(*s, out);
			ts_str_addf(out, ") — %s\n", (*s)->summary);
		} else {
			ts_str_addf(out, "  %-24s %s\n", (*s)->name, (*s)->summary);
		}
	}
}
