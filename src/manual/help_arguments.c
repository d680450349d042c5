/* The parts of a manual page about arguments: the few that everybody needs come first, the others in groups. */
#include "manual/help_arguments.h"

#include <string.h>

#include "manual/help_text.h"

#include "base/banned.h"

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

static void add_row(const struct ts_arg *row, size_t depth, bool markdown, struct ts_str *out);

static void add_rows(const struct ts_arg *row, size_t depth, bool markdown, struct ts_str *out)
{
	for (; row && row->type != TS_ARG_END; row++)
		add_row(row, depth, markdown, out);
}

static void add_row(const struct ts_arg *row, size_t depth, bool markdown, struct ts_str *out)
{
	struct ts_str name = { 0 }, text = { 0 };

	ts_arg_synopsis(row, &name);
	ts_str_add(&text, row->help ? row->help : "");
	add_notes(row, &text);
	ts_help_entry(&name, &text, depth, markdown, out);
	for (const struct ts_mode *mode = row->modes; mode && mode->name; mode++) {
		ts_str_clear(&name);
		ts_str_clear(&text);
		ts_str_add(&name, mode->name);
		add_synopsis(mode->args, &name);
		ts_str_add(&text, mode->help ? mode->help : "");
		ts_help_entry(&name, &text, depth + 1, markdown, out);
		add_rows(mode->args, depth + 2, markdown, out);
	}
	out->failed |= name.failed || text.failed;
	ts_str_release(&name);
	ts_str_release(&text);
}

/* ---- groups of arguments */

/* A style with at most so many arguments, or so few that its example does not need, has no groups. */
enum { FEW_ARGUMENTS = 8, FEW_FURTHER = 3, LONG_SYNOPSIS = 40 };
static const char further[] = "Further keywords";

/* Whether a line needs the argument, or the example of the style has it. */
static bool is_needed(const struct ts_style *style, const struct ts_arg *row)
{
	bool required = !row->fallback && !(row->flags & TS_OPTIONAL) && row->type != TS_ARG_FLAG;

	return (row->flags & TS_POSITIONAL) || required ||
	       (style->example && ts_has_word(style->example, row->name));
}

static bool has_groups(const struct ts_style *style)
{
	size_t all = 0, more = 0;

	if (style->groups)
		return true;
	for (const struct ts_arg *row = style->args; row && row->type != TS_ARG_END; row++) {
		all++;
		more += !is_needed(style, row);
	}
	return all > FEW_ARGUMENTS && more > FEW_FURTHER;
}

/* The title of the group of the argument; NULL: it is one of those that everybody needs. */
static const char *group_of(const struct ts_style *style, const struct ts_arg *row)
{
	if (!has_groups(style))
		return NULL;
	for (const struct ts_arg_group *g = style->groups; g && g->words; g++)
		if (ts_has_word(g->words, row->name))
			return g->title;
	return style->groups || !is_needed(style, row) ? further : NULL;
}

/* Appends the arguments of the group; `title` NULL: those that everybody needs, without a title. */
static void add_group(const struct ts_style *style, const char *title, bool markdown, struct ts_str *out)
{
	bool first = title;

	for (const struct ts_arg *row = style->args; row && row->type != TS_ARG_END; row++) {
		const char *group = group_of(style, row);

		if (title ? !group || !ts_streq(group, title) : group != NULL)
			continue;
		if (first)
			ts_help_subheading(title, markdown, out);
		first = false;
		add_row(row, 0, markdown, out);
	}
}

/* ---- parts of a page */

/* Appends the arguments that everybody needs; the others are mentioned. Long lists of choices are left to the
 * list of arguments. */
static void add_needed_synopsis(const struct ts_style *style, struct ts_str *out)
{
	struct ts_str one = { 0 };
	bool more = false;

	for (const struct ts_arg *row = style->args; row && row->type != TS_ARG_END; row++) {
		if (group_of(style, row)) {
			more = true;
			continue;
		}
		ts_str_clear(&one);
		ts_arg_synopsis(row, &one);
		if (one.length > LONG_SYNOPSIS && row->type == TS_ARG_ENUM)
			ts_str_addf(out, row->fallback ? " [%s ...]" : " %s ...", row->name);
		else
			ts_str_addf(out, " %s", ts_str_text(&one));
	}
	ts_str_add(out, more ? " [further keywords]" : "");
	out->failed |= one.failed;
	ts_str_release(&one);
}

void ts_help_syntax(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	struct ts_str line = { 0 }, lines = { 0 };

	ts_help_heading("Syntax", markdown, out);
	add_prefix(style, &line);
	add_needed_synopsis(style, &line);
	ts_help_wrapped(ts_str_text(&line), markdown ? 0 : 2, 4, &lines);
	if (style->coeff) {
		ts_str_clear(&line);
		ts_str_add(&line, style->kind == TS_KIND_PAIR ? "pair_coeff I J" : "bond_coeff I");
		add_synopsis(style->coeff, &line);
		ts_help_wrapped(ts_str_text(&line), markdown ? 0 : 2, 4, &lines);
	}
	ts_str_addf(out, markdown ? "```\n%s\n```\n" : "%s\n", ts_str_text(&lines));
	out->failed |= line.failed || lines.failed;
	ts_str_release(&line);
	ts_str_release(&lines);
}

void ts_help_arguments(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	if (!style->args || style->args->type == TS_ARG_END)
		return;
	ts_help_heading("Arguments", markdown, out);
	add_group(style, NULL, markdown, out);
}

void ts_help_further_arguments(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	if (!has_groups(style))
		return;
	ts_help_heading("Further arguments", markdown, out);
	for (const struct ts_arg_group *g = style->groups; g && g->words; g++)
		if (g->title)
			add_group(style, g->title, markdown, out);
	add_group(style, further, markdown, out);
}

void ts_help_coefficients(const struct ts_style *style, bool markdown, struct ts_str *out)
{
	if (!style->coeff || style->coeff->type == TS_ARG_END)
		return;
	ts_help_heading("Coefficients", markdown, out);
	add_rows(style->coeff, 0, markdown, out);
}
