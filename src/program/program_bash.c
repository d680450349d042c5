/* Completion of the command line by bash, made from the tables of options and styles. */
#include <ctype.h>
#include <string.h>

#include "core/style.h"
#include "library/tsim_tables.h"
#include "manual/topics.h"
#include "program/program.h"

#include "base/banned.h"

/* Whether the values of an option are words to choose from, as `yes|no`. */
static bool are_choices(const char *values)
{
	bool bar = false;

	for (const char *c = values; *c; c++) {
		if (!islower((unsigned char)*c) && *c != '|')
			return false;
		bar |= *c == '|';
	}
	return bar;
}

static void add_words(struct ts_str *out, const char *values)
{
	for (const char *c = values; *c; c++)
		ts_str_addf(out, "%c", *c == '|' ? ' ' : *c);
}

/* How the first value of an option is completed. */
static void add_values(struct ts_str *out, const struct ts_program_option *option)
{
	static const struct {
		const char *begins, *how;
	} kinds[] = { { "FILE", "-f" }, { "DIR", "-d" }, { "FOLDER", "-d" } };

	if (are_choices(option->values)) {
		ts_str_addf(out, "\t-%s) COMPREPLY=($(compgen -W '", option->name);
		add_words(out, option->values);
		ts_str_add(out, "' -- \"$cur\")); return ;;\n");
	}
	for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
		if (strncmp(option->values, kinds[k].begins, strlen(kinds[k].begins)) == 0)
			ts_str_addf(out, "\t-%s) COMPREPLY=($(compgen %s -- \"$cur\")); return ;;\n",
				    option->name, kinds[k].how);
}

static void add_names(struct ts_str *out, enum ts_kind kind)
{
	for (const struct ts_style *const *s = ts_tables.styles; *s; s++)
		if ((*s)->kind == kind)
			ts_str_addf(out, "%s ", (*s)->name);
}

static void add_help(struct ts_str *out)
{
	ts_str_add(out, "\t-help)\n\t\twords='");
	for (int kind = TS_KIND_COMMAND; kind < TS_NKIND; kind++) {
		ts_str_addf(out, "%s ", ts_kind_name((enum ts_kind)kind));
		add_names(out, (enum ts_kind)kind);
	}
	for (const struct ts_topic *t = ts_topics; t->name; t++)
		ts_str_addf(out, "%s ", t->name);
	ts_str_add(out, "'\n\t\tCOMPREPLY=($(compgen -W \"$words\" -- \"$cur\")); return ;;\n\tesac\n"
			"\tif [ \"$before\" = -help ]; then\n\t\tcase $prev in\n");
	for (int kind = TS_KIND_COMMAND; kind < TS_NKIND; kind++) {
		ts_str_addf(out, "\t\t%s) words='", ts_kind_name((enum ts_kind)kind));
		add_names(out, (enum ts_kind)kind);
		ts_str_add(out, "' ;;\n");
	}
	ts_str_add(out, "\t\t*) words= ;;\n\t\tesac\n\t\tCOMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
			"\t\treturn\n\tfi\n");
}

void ts_program_bash(struct ts_str *out)
{
	const struct ts_program_option *option;

	ts_str_add(out, "# Completion of tsim for bash, made by `tsim -grammar bash`\n"
			"_tsim()\n{\n"
			"\tlocal cur=${COMP_WORDS[COMP_CWORD]} prev= before= words\n"
			"\t[ \"$COMP_CWORD\" -lt 1 ] || prev=${COMP_WORDS[COMP_CWORD-1]}\n"
			"\t[ \"$COMP_CWORD\" -lt 2 ] || before=${COMP_WORDS[COMP_CWORD-2]}\n"
			"\tcase $prev in\n");
	for (size_t k = 0; (option = ts_program_option(k)); k++)
		add_values(out, option);
	add_help(out);
	ts_str_add(out, "\tcase $cur in\n\t-*)\n\t\tCOMPREPLY=($(compgen -W '");
	for (size_t k = 0; (option = ts_program_option(k)); k++)
		ts_str_addf(out, "%s-%s", k ? " " : "", option->name);
	ts_str_add(out, "' -- \"$cur\"))\n\t\treturn ;;\n\tesac\n"
			"\tCOMPREPLY=($(compgen -f -- \"$cur\"))\n}\n"
			"complete -o filenames -F _tsim tsim\n");
}
