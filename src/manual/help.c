#include "manual/help.h"

#include <ctype.h>
#include <string.h>

#include "base/banned.h"

void ts_help_file_name(const struct ts_style *style, struct ts_str *out)
{
	ts_str_addf(out, "%s_", ts_kind_name(style->kind));
	for (const char *c = style->name; *c; c++)
		ts_str_add_n(out, *c == '/' ? "_" : c, 1);
	ts_str_add(out, ".md");
}

static void add_heading(const char *text, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "\n## %s\n\n" : "\n%s\n", text);
}

/* Appends the part of a script line before the arguments. */
static void add_prefix(const struct ts_style *style, struct ts_str *out)
{
	static const char *const before[TS_NKIND] = {
		[TS_KIND_FIX] = "fix ID GROUP ",	  [TS_KIND_COMPUTE] = "compute ID GROUP ",
		[TS_KIND_REGION] = "region ID ",	  [TS_KIND_DUMP] = "dump ID GROUP ",
		[TS_KIND_PAIR] = "pair_style ",		  [TS_KIND_BOND] = "bond_style ",
		[TS_KIND_FLOW] = "flow_style ",		  [TS_KIND_PRESSURE] = "pressure_style ",
		[TS_KIND_AUTOMATON] = "automaton_style ",
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

/* Length up to the next blank; text in brackets is not broken. */
static size_t word_length(const char *text)
{
	size_t n = strcspn(text, " \n"), all = *text == '[' ? strcspn(text, "]") : 0;

	return all > n && all < 40 && text[all] ? all + strcspn(text + all, " \n") : n;
}

/* Appends the text in lines of at most 78 characters, indented by `indent` blanks, and by `more` further
 * ones after the first line. A single line end is a blank, two separate paragraphs. */
static void add_wrapped(const char *text, size_t indent, size_t more, struct ts_str *out)
{
	size_t column = 0;

	while (*text) {
		size_t blanks = strspn(text, " \n"), n = word_length(text + blanks);

		if (column && blanks > 1 && text[0] == '\n' && text[1] == '\n') {
			ts_str_add(out, "\n");
			column = 0;
		}
		if (!column || column + 1 + n > 78) {
			size_t pad = column ? indent + more : indent;

			ts_str_addf(out, "%s%*s", out->length ? "\n" : "", (int)pad, "");
			column = pad;
		} else {
			ts_str_add(out, " ");
			column++;
		}
		ts_str_add_n(out, text + blanks, n);
		column += n;
		text += blanks + n;
	}
}

/* Type of the value, if the synopsis does not show it. */
static const char *type_text(const struct ts_arg *row)
{
	static const char *const texts[] = {
		[TS_ARG_REAL] = "number",
		[TS_ARG_INT] = "whole number",
		[TS_ARG_FLAG] = "keyword without value",
		[TS_ARG_WORD] = "word",
		[TS_ARG_VEC3] = "three numbers",
		[TS_ARG_COORD] = "number, INF or EDGE",
		[TS_ARG_NUMBER] = "number or v_NAME",
		[TS_ARG_TYPES] = "types: n, *, n*, *m or n*m",
		[TS_ARG_GROUP] = "group",
		[TS_ARG_REGION] = "region",
		[TS_ARG_REF] = "c_ID, c_ID[k], f_ID, v_NAME or thermo keyword",
		[TS_ARG_REST] = "words",
	};

	return row->type < sizeof texts / sizeof *texts && texts[row->type] ? texts[row->type] : "";
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

/* " (number, in length, > 0; default 1)" */
static void add_notes(const struct ts_arg *row, struct ts_str *out)
{
	struct ts_str notes = { 0 };

	ts_str_add(&notes, type_text(row));
	if (row->unit && *row->unit)
		ts_str_addf(&notes, ", in %s", row->unit);
	add_range(row, &notes);
	if (row->flags & TS_NULLABLE)
		ts_str_add(&notes, ", or NULL");
	if (row->fallback)
		ts_str_addf(&notes, "%sdefault %s", notes.length ? "; " : "", row->fallback);
	else if (row->flags & TS_OPTIONAL)
		ts_str_addf(&notes, "%smay be left out", notes.length ? "; " : "");
	if (row->flags & TS_STATEFUL)
		ts_str_addf(&notes, "%sfixed by a restart file", notes.length ? "; " : "");
	if (notes.length)
		ts_str_addf(out, " (%s)", ts_str_text(&notes));
	out->failed |= notes.failed;
	ts_str_release(&notes);
}

/* Appends an item of a list: a name and its description. */
static void add_item(const struct ts_str *name, const struct ts_str *text, size_t depth, bool markdown,
		     struct ts_str *out)
{
	if (markdown) {
		ts_str_addf(out, "%*s- `%s` — %s\n", (int)(2 * depth), "", ts_str_text(name),
			    ts_str_text(text));
		return;
	}
	ts_str_addf(out, "%*s%s", (int)(2 + 4 * depth), "", ts_str_text(name));
	add_wrapped(ts_str_text(text), 6 + 4 * depth, 0, out);
	ts_str_add(out, "\n");
}

static void add_rows(const struct ts_arg *row, size_t depth, bool markdown, struct ts_str *out)
{
	struct ts_str name = { 0 }, text = { 0 };

	for (; row && row->type != TS_ARG_END; row++) {
		ts_str_clear(&name);
		ts_str_clear(&text);
		ts_arg_synopsis(row, &name);
		ts_str_add(&text, row->help ? row->help : "");
		add_notes(row, &text);
		add_item(&name, &text, depth, markdown, out);
		for (const struct ts_mode *mode = row->modes; mode && mode->name; mode++) {
			ts_str_clear(&name);
			ts_str_clear(&text);
			ts_str_add(&name, mode->name);
			add_synopsis(mode->args, &name);
			ts_str_add(&text, mode->help ? mode->help : "");
			add_item(&name, &text, depth + 1, markdown, out);
			add_rows(mode->args, depth + 2, markdown, out);
		}
	}
	out->failed |= name.failed || text.failed;
	ts_str_release(&name);
	ts_str_release(&text);
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
	static const char *const shapes[] = {
		[TS_SCALAR] = "a number",	    [TS_VECTOR] = "a list of numbers",
		[TS_PERATOM] = "one per particle",  [TS_LOCAL] = "rows for dump local",
		[TS_ARRAY] = "a table, c_ID[i][j]", [TS_SURFACE] = "a row for each triangle"
	};
	struct ts_str name = { 0 }, text = { 0 };

	if (!style->values || !style->values->name)
		return;
	add_heading("Output", markdown, out);
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
		add_item(&name, &text, 0, markdown, out);
	}
	out->failed |= name.failed || text.failed;
	ts_str_release(&name);
	ts_str_release(&text);
}

/* Appends the lines of the text, indented. */
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

/* Lines that begin with blanks, such as formulas and tables, are preformatted. */
static bool is_preformatted(const char *line)
{
	return line[0] == ' ' && line[1] == ' ';
}

/* Whether the line is the first one of an item of a list. */
static bool begins_item(const char *text)
{
	return text[0] == '*' && text[1] == ' ';
}

/* Length of the lines up to an empty one, the next item of a list, or one of the other kind (preformatted
 * or not), with the line end. */
static size_t part_length(const char *text)
{
	bool preformatted = is_preformatted(text);
	size_t n = 0;

	while (text[n] && text[n] != '\n' && is_preformatted(text + n) == preformatted &&
	       !(n && begins_item(text + n))) {
		n += strcspn(text + n, "\n");
		n += text[n] == '\n';
	}
	return n;
}

static void add_part(const char *text, bool markdown, struct ts_str *out)
{
	struct ts_str lines = { 0 };

	if (is_preformatted(text)) {
		ts_str_add(out, markdown ? "```\n" : "");
		add_lines(text, markdown ? "" : "  ", out);
		ts_str_add(out, markdown ? "```\n" : "");
	} else if (markdown) {
		ts_str_addf(out, "%s\n", text);
	} else {
		add_wrapped(text, 2, begins_item(text) ? 2 : 0, &lines);
		ts_str_addf(out, "%s\n", ts_str_text(&lines));
	}
	out->failed |= lines.failed;
	ts_str_release(&lines);
}

static void add_paragraphs(const char *text, bool markdown, struct ts_str *out)
{
	struct ts_str part = { 0 };

	while (*text) {
		size_t n = part_length(text);

		ts_str_clear(&part);
		ts_str_add_n(&part, text, n && text[n - 1] == '\n' ? n - 1 : n);
		if (n)
			add_part(ts_str_text(&part), markdown, out);
		text += n;
		if (*text == '\n')
			ts_str_add(out, "\n");
		text += strspn(text, "\n");
	}
	out->failed |= part.failed;
	ts_str_release(&part);
}

static void add_syntax(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	struct ts_str line = { 0 }, lines = { 0 };

	add_heading("Syntax", markdown, out);
	add_prefix(style, &line);
	add_synopsis(style->args, &line);
	add_wrapped(ts_str_text(&line), markdown ? 0 : 2, 4, &lines);
	if (style->coeff) {
		ts_str_clear(&line);
		ts_str_add(&line, style->kind == TS_KIND_PAIR ? "pair_coeff I J" : "bond_coeff I");
		add_synopsis(style->coeff, &line);
		add_wrapped(ts_str_text(&line), markdown ? 0 : 2, 4, &lines);
	}
	ts_str_addf(out, markdown ? "```\n%s\n```\n" : "%s\n", ts_str_text(&lines));
	out->failed |= line.failed || lines.failed;
	ts_str_release(&line);
	ts_str_release(&lines);
}

static void add_table(const char *title, const struct ts_arg *rows, bool markdown, struct ts_str *out)
{
	if (!rows || rows->type == TS_ARG_END)
		return;
	add_heading(title, markdown, out);
	add_rows(rows, 0, markdown, out);
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

void ts_help_page(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "# %s %s\n\n" : "%s %s: ", ts_kind_name(style->kind), style->name);
	add_summary(style, out);
	ts_str_add(out, markdown ? ".\n" : "\n");
	add_syntax(style, markdown, out);
	add_table("Arguments", style->args, markdown, out);
	add_table("Coefficients", style->coeff, markdown, out);
	add_values(style, markdown, out);
	if (style->doc) {
		add_heading("Description", markdown, out);
		add_paragraphs(style->doc, markdown, out);
		for (const char *const *more = style->doc_more; more && *more; more++) {
			ts_str_add(out, "\n");
			add_paragraphs(*more, markdown, out);
		}
		add_other_names(style, markdown, out);
	}
	if (style->example) {
		add_heading("Example", markdown, out);
		ts_str_add(out, markdown ? "```\n" : "");
		add_lines(style->example, markdown ? "" : "  ", out);
		ts_str_add(out, markdown ? "```\n" : "");
	}
	if (style->cite) {
		add_heading("Source", markdown, out);
		add_paragraphs(style->cite, markdown, out);
	}
}

void ts_help_heading(const char *text, bool markdown, struct ts_str *out)
{
	add_heading(text, markdown, out);
}

void ts_help_item(const char *name, const char *text, bool markdown, struct ts_str *out)
{
	size_t n = strlen(name);

	if (markdown)
		ts_str_addf(out, "- `%s` — %s\n", name, text);
	else if (n <= 22)
		ts_str_addf(out, "  %-22s %s\n", name, text);
	else
		ts_str_addf(out, "  %s\n  %-22s %s\n", name, "", text);
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
