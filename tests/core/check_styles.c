/* The contract every style keeps, checked in a loop over the table of styles. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "core/life.h"
#include "core/unsupported_names.h"
#include "library/tsim_tables.h"

/* Names of the row being looked at, for messages: a test looks at all styles, as a process of its own for each took more
 * time than the looking. */
static char here[256];

static void at(const struct ts_style *style, const char *row)
{
	snprintf(here, sizeof here, "%s %s%s%s", ts_kind_name(style->kind), style->name, row ? ": " : "",
		 row ? row : "");
}

#define EXPECT(condition, what) ck_assert_msg(condition, "%s: %s", here, what)

static bool filled(const char *text)
{
	return text && *text;
}

static void described(const struct ts_style *s)
{
	at(s, NULL);
	EXPECT(filled(s->name), "no name");
	EXPECT(s->kind > TS_KIND_SYSTEM && s->kind < TS_NKIND, "impossible kind");
	EXPECT(filled(s->summary), "no summary");
	EXPECT(!ts_ends_with(s->summary, "."), "the summary ends with a full stop");
	EXPECT(!strchr(s->summary, '\n'), "the summary is longer than a line");
	EXPECT(filled(s->doc), "no doc");
	for (const char *const *more = s->doc_more; more && *more; more++)
		EXPECT(filled(*more) && !ts_ends_with(*more, "\n"),
		       "a part of doc is empty or ends in a newline");
	EXPECT(!s->doc_more || !ts_ends_with(s->doc, "\n"), "doc ends in a newline before doc_more");
	EXPECT(filled(s->example), "no example");
	EXPECT(!s->args || s->state_size > 0, "arguments, but no state to put them in");
	EXPECT(s->kind != TS_KIND_COMMAND || ((const struct ts_command_style *)s)->run ||
		       strstr(s->summary, "no effect"),
	       "does nothing and does not say so");
	EXPECT(ts_style_find(&ts_tables, s->kind, s->name) == s,
	       "not found by its name: is it twice in the table?");
}

static void example_names_style(const struct ts_style *s)
{
	at(s, NULL);
	EXPECT(strstr(s->example, s->name), "the example does not name the style");
}

static void check_row(const struct ts_style *style, const struct ts_arg *row, bool in_mode)
{
	at(style, row->name);
	EXPECT(filled(row->name), "a row without name");
	EXPECT(filled(row->help), "no help");
	EXPECT(row->offset < style->state_size, "lands outside the state");
	if (row->type == TS_ARG_ENUM)
		EXPECT(row->choices && row->choices[0], "no choices");
	if (row->type == TS_ARG_MODE) {
		EXPECT(row->modes && row->modes[0].name, "no modes");
		EXPECT(!in_mode, "a mode within a mode");
	}
	if (row->range == TS_WITHIN)
		EXPECT(row->lo < row->hi, "an empty range");
	EXPECT(!(row->flags & TS_OPTIONAL) || !row->fallback, "both optional and with a default");
}

/* How many groups have the argument. */
static size_t groups_of(const struct ts_style *style, const char *name)
{
	size_t n = 0, length = strlen(name);

	for (const struct ts_arg_group *g = style->groups; g->words; g++)
		for (const char *at = g->words; *at; at += strcspn(at, " "), at += strspn(at, " "))
			n += strcspn(at, " ") == length && strncmp(at, name, length) == 0;
	return n;
}

/* Each argument is in one group of the manual page, and the groups have no other words. */
static void groups(const struct ts_style *s)
{
	size_t words = 0, rows = 0;
	bool needed = false;

	at(s, NULL);
	for (const struct ts_arg_group *g = s->groups; g && g->words; g++) {
		EXPECT(!g->title || filled(g->title), "a group with an empty title");
		needed |= !g->title;
		for (const char *w = g->words; *w; w += strcspn(w, " "), w += strspn(w, " "))
			words++;
	}
	for (const struct ts_arg *row = s->args; s->groups && row->type != TS_ARG_END; row++) {
		at(s, row->name);
		EXPECT(groups_of(s, row->name) == 1, "is not in one group of the manual page");
		rows++;
	}
	at(s, NULL);
	EXPECT(words == (s->groups ? rows : 0), "a group has a word that is no argument");
	EXPECT(!s->groups || needed, "no group of words that everybody needs");
}

static void check_rows(const struct ts_style *style, const struct ts_arg *rows, bool in_mode)
{
	bool keywords = false, may_lack = false, rest = false;

	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		bool positional = row->flags & TS_POSITIONAL;
		bool optional = (row->flags & TS_OPTIONAL) || row->fallback;

		check_row(style, row, in_mode);
		EXPECT(!positional || !keywords, "positional after a keyword");
		EXPECT(!positional || !rest, "positional after the row that takes all words");
		EXPECT(!positional || optional || !may_lack, "required after one that may lack");
		keywords |= !positional;
		may_lack |= positional && optional;
		rest |= row->type == TS_ARG_REST;
		for (const struct ts_arg *other = rows; other < row; other++)
			EXPECT(!ts_streq(other->name, row->name), "two rows of this name");
		for (const struct ts_mode *m = row->modes; m && m->name; m++) {
			EXPECT(filled(m->help), "a mode without help");
			check_rows(style, m->args, true);
		}
	}
}

static void arguments(const struct ts_style *s)
{
	check_rows(s, s->args, false);
}

/* All defaults can be read and lie in their ranges: the parser that reads the user's words reads
 * them too. */
static void defaults(const struct ts_style *s)
{
	struct tsim *sim = ts_sim_new(&ts_tables);
	struct ts_arena arena = { 0 };
	void *state = ts_alloc_aligned(1, s->state_size + 1);

	at(s, NULL);
	ck_assert(sim && state);
	ts_args_defaults(sim, s->args, &arena, state);
	ck_assert_msg(sim->error.status == TS_OK, "%s: %s", here, sim->error.message);
	ts_arena_release(&arena);
	ts_free(state);
	ts_sim_free(sim);
}

static void values(const struct ts_style *s)
{
	unsigned shapes = 0;

	for (const struct ts_value *v = s->values; v && v->name; v++) {
		at(s, v->name);
		EXPECT(filled(v->help), "an output without help");
		EXPECT(v->unit, "an output without unit (\"\" for a pure number)");
		EXPECT(v->eval, "an output that cannot be evaluated");
		EXPECT(v->shape >= TS_SCALAR && v->shape <= TS_SURFACE, "impossible shape");
		EXPECT((v->shape == TS_SURFACE) <= (s->surface != NULL), "rows of triangles of which mesh?");
		/* of outputs whose number of columns depends on the arguments an instance gives one */
		EXPECT(!(shapes & 1u << v->shape) || (s->gives && v->columns != v[-1].columns),
		       "two outputs of the same shape");
		shapes |= 1u << v->shape;
		for (size_t k = 0; v->column_names && k < v->columns; k++)
			EXPECT(filled(v->column_names[k]), "a column without name");
	}
}

static void saved_rows(const struct ts_style *s)
{
	for (const struct ts_saved *row = s->saved; row && row->type != TS_SAVED_END; row++) {
		at(s, row->name);
		EXPECT(row->offset < s->state_size, "lies outside the state");
		EXPECT(row->count > 0, "saves nothing");
	}
}

static void manual_page(const struct ts_style *s)
{
	const char *top = getenv("top_srcdir");
	struct ts_str path = { 0 };
	FILE *file;

	at(s, NULL);
	ts_str_addf(&path, "%s/doc/styles/%s_%s.md", top ? top : ".", ts_kind_name(s->kind), s->name);
	for (char *c = strstr(path.text, "/doc/styles/") + strlen("/doc/styles/"); *c; c++)
		if (*c == '/')
			*c = '_';
	file = fopen(path.text, "r");
	ck_assert_msg(file, "%s: no manual page %s", here, path.text);
	fclose(file);
	ts_str_release(&path);
}

START_TEST(sorted)
{
	for (size_t k = 0; ts_style_table[k] && ts_style_table[k + 1]; k++) {
		const struct ts_style *a = ts_style_table[k], *b = ts_style_table[k + 1];
		int order = strcmp(ts_kind_name(a->kind), ts_kind_name(b->kind));

		at(b, NULL);
		EXPECT(order < 0 || (order == 0 && strcmp(a->name, b->name) < 0),
		       "out of order, or twice in the table");
	}
}
END_TEST

START_TEST(accelerated_variant)
{
	here[0] = '\0';
	EXPECT(ts_style_find(&ts_tables, TS_KIND_FIX, "gravity/omp") ==
		       ts_style_find(&ts_tables, TS_KIND_FIX, "gravity"),
	       "gravity/omp is not gravity");
	EXPECT(!ts_style_find(&ts_tables, TS_KIND_FIX, "gravit"), "the start of a name was found");
	EXPECT(!ts_style_find(&ts_tables, TS_KIND_FIX, "/omp"), "an ending alone was found");
}
END_TEST

/* A word said to be missing is. */
static void not_known_as_missing(const struct ts_style *s)
{
	at(s, NULL);
	EXPECT(!ts_unsupported_find(s->kind, s->name), "core/unsupported_names.c says tsim does not have it");
}

START_TEST(missing_words)
{
	struct tsim *sim = ts_sim_new(&ts_tables);
	const struct ts_style *found;

	for (const struct ts_unsupported *k = ts_unsupported_table; k->names; k++) {
		const char *names = k->names;
		char name[64];

		for (int used; sscanf(names, "%63s%n", name, &used) == 1; names += used) {
			struct ts_word word = { .text = name };

			snprintf(here, sizeof here, "%s %s", ts_kind_name(k->kind), name);
			EXPECT(filled(k->remark), "no remark");
			ts_error_clear(&sim->error);
			EXPECT(ts_style_require(sim, k->kind, &word, &found) == TS_UNKNOWN, "found");
			EXPECT(strstr(sim->error.message, "is known from"), "not told that it is known");
			EXPECT(strstr(sim->error.message, k->remark), "not told why");
		}
	}
	ts_sim_free(sim);
}
END_TEST

static void (*const clauses[])(const struct ts_style *) = {
	described,   example_names_style,  groups, arguments, defaults, values, saved_rows,
	manual_page, not_known_as_missing,
};

START_TEST(each_style)
{
	for (const struct ts_style *const *s = ts_style_table; *s; s++)
		clauses[_i](*s);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("styles");
	TCase *each = tcase_create("each style"), *all = tcase_create("the table");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(each, each_style, 0, (int)(sizeof clauses / sizeof *clauses));
	tcase_add_test(all, sorted);
	tcase_add_test(all, missing_words);
	tcase_add_test(all, accelerated_variant);
	suite_add_tcase(suite, each);
	suite_add_tcase(suite, all);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
