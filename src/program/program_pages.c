/* Pages that the program prints: usage, manual pages, grammars of editors. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "advise/advise.h"
#include "base/files.h"
#include "crosscheck/crosscheck.h"
#include "library/tsim_tables.h"
#include "manual/grammar.h"
#include "manual/help.h"
#include "manual/manual.h"
#include "manual/topics.h"
#include "program/program.h"
#include "program/program_ranks.h"
#include "study/study.h"
#include "tsim.h"
#include "view/view.h"

#include "base/banned.h"

int ts_program_print(struct ts_str *text)
{
	bool bad = text->failed;

	fputs(ts_str_text(text), stdout);
	ts_str_release(text);
	return bad ? EXIT_FAILURE : EXIT_SUCCESS;
}

static void print_usage(void)
{
	struct ts_str text = { 0 };

	puts("usage: tsim [options] -in FILE\n\noptions");
	ts_program_list_options();
	puts("\nafter -advise");
	ts_advise_help(&text);
	ts_program_print(&text);
	puts("\n-sweep and -calibrate");
	ts_study_help(&text);
	ts_program_print(&text);
	puts("\n-plot");
	ts_view_help(&text);
	ts_program_print(&text);
	puts("\nafter -sandbox");
	ts_program_sandbox_help(&text);
	ts_program_print(&text);
	puts("\nafter -crosscheck liggghts or -crosscheck lammps");
	ts_crosscheck_help(&text);
	ts_program_print(&text);
	puts("\nmanual pages: tsim -help NAME for anything that has a name, tsim -help KIND for a list of "
	     "its styles,\ntsim -help KIND STYLE for one of them, tsim -help SOME WORDS for the best "
	     "passages about them. Kinds are");
	for (int kind = TS_KIND_COMMAND; kind < TS_NKIND; kind++)
		printf("  %s\n", ts_kind_name((enum ts_kind)kind));
	puts("and further pages");
	for (const struct ts_topic *t = ts_topics; t->name; t++)
		printf("  %-12s %s\n", t->name, t->summary);
}

int ts_program_help(const struct ts_setup *setup)
{
	struct ts_str text = { 0 }, words = { 0 };
	int status;

	if (!setup->help_count) {
		print_usage();
		return EXIT_SUCCESS;
	}
	for (int k = 0; k < setup->help_count; k++)
		ts_str_addf(&words, "%s%s", k ? " " : "", setup->help_words[k]);
	if (ts_manual_find(&ts_tables, ts_str_text(&words), &text))
		status = ts_program_print(&text);
	else
		status = ts_program_usage_error("%s%s", ts_str_text(&text), "");
	ts_str_release(&text);
	ts_str_release(&words);
	return status;
}

int ts_program_grammar(const char *editor)
{
	struct ts_str text = { 0 };

	if (ts_streq(editor, "vim"))
		ts_grammar_vim(&ts_tables, &text);
	else if (ts_streq(editor, "vscode"))
		ts_grammar_textmate(&ts_tables, &text);
	else if (ts_streq(editor, "bash"))
		ts_program_bash(&text);
	else
		return ts_program_usage_error("expected vim, vscode or bash after -grammar, found '%s'%s",
					      editor, "");
	return ts_program_print(&text);
}

int ts_program_version(void)
{
	const char *name, *text;

	printf("tsim %s\n", tsim_version());
	for (size_t k = 0; (name = tsim_feature(k, &text)); k++)
		printf("  %-10s %s\n", name, text);
	printf("  %-10s %s\n", "ranks", ts_program_ranks_standard());
	return EXIT_SUCCESS;
}

static int write_page(const char *directory, const char *name, const struct ts_str *text)
{
	struct ts_str path = { 0 };
	FILE *file;
	int bad = 1;

	ts_str_addf(&path, "%s/%s", directory, name);
	file = path.failed || text->failed ? NULL : ts_files_open(NULL, path.text, "w");
	if (file) {
		bad = fputs(ts_str_text(text), file) < 0;
		bad |= fclose(file) != 0;
	}
	if (bad)
		fprintf(stderr, "tsim: cannot write '%s'\n", ts_str_text(&path));
	ts_str_release(&path);
	return bad ? EXIT_FAILURE : EXIT_SUCCESS;
}

int ts_program_manual(const char *directory)
{
	struct ts_str text = { 0 }, name = { 0 };
	int status = EXIT_SUCCESS;

	for (const struct ts_style *const *s = ts_tables.styles; *s && !status; s++) {
		ts_str_clear(&text);
		ts_str_clear(&name);
		ts_help_file_name(*s, &name);
		ts_help_page(*s, true, &text);
		status = write_page(directory, ts_str_text(&name), &text);
	}
	for (const struct ts_topic *t = ts_topics; t->name && !status; t++) {
		ts_str_clear(&text);
		ts_str_clear(&name);
		ts_str_addf(&name, "%s.md", t->name);
		t->page(&ts_tables, true, &text);
		status = write_page(directory, ts_str_text(&name), &text);
	}
	ts_str_clear(&text);
	ts_manual_index(&ts_tables, &text);
	if (!status)
		status = write_page(directory, "index.md", &text);
	ts_str_release(&text);
	ts_str_release(&name);
	return status;
}
