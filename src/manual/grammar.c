/* Grammar files for editors: commands at the beginning of a line, styles at their position, keywords,
 * functions, references. */
#include <stdio.h>
#include <string.h>

#include "base/map.h"
#include "core/sim.h"
#include "formula/expr.h"
#include "formula/variable.h"
#include "manual/grammar.h"

#include "base/banned.h"

/* A list of different words in order of their first occurrence. */
struct word_list {
	struct ts_map seen;
	const char **word;
	size_t n, capacity;
	bool failed;
};

static void add_word(struct word_list *list, const char *word)
{
	bool plain = strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_/-") ==
		     strlen(word);
	bool number = strspn(word, "0123456789") == strlen(word);

	if (!plain || number || ts_map_get(&list->seen, word))
		return;
	list->failed |= TS_GROW(list->word, list->capacity, list->n + 1) != TS_OK ||
			ts_map_set(&list->seen, word, list) != TS_OK;
	if (!list->failed)
		list->word[list->n++] = word;
}

static void release_words(struct word_list *list)
{
	ts_map_release(&list->seen);
	ts_free(list->word);
	*list = (struct word_list){ 0 };
}

static void add_arguments(struct word_list *list, const struct ts_arg *row)
{
	for (; row && row->type != TS_ARG_END; row++) {
		if (!(row->flags & TS_POSITIONAL))
			add_word(list, row->name);
		for (size_t k = 0; row->choices && row->choices[k]; k++)
			add_word(list, row->choices[k]);
		for (const struct ts_mode *m = row->modes; m && m->name; m++) {
			add_word(list, m->name);
			add_arguments(list, m->args);
		}
	}
}

static void add_keywords(const struct ts_tables *tables, struct word_list *list)
{
	static const char *const fixed[] = { "all", "NULL", "INF", "EDGE", "SELF", "yes",
					     "no",  "on",   "off", "then", "elif", "else" };

	for (size_t k = 0; k < sizeof fixed / sizeof *fixed; k++)
		add_word(list, fixed[k]);
	for (const struct ts_style *const *s = tables->styles; *s; s++) {
		add_arguments(list, (*s)->args);
		add_arguments(list, (*s)->coeff);
	}
	for (const struct ts_variable_style *const *v = ts_variable_styles; *v; v++)
		add_word(list, (*v)->name);
}

static void add_style(struct word_list *list, const struct ts_style *style)
{
	const char *other;

	add_word(list, style->name);
	for (size_t k = 0; (other = ts_style_other_name(style, k)); k++)
		add_word(list, other);
}

static void add_styles(const struct ts_tables *tables, struct word_list *list, enum ts_kind kind)
{
	for (const struct ts_style *const *s = tables->styles; *s; s++)
		if ((*s)->kind == kind)
			add_style(list, *s);
}

static void add_functions(const struct ts_tables *tables, struct word_list *list)
{
	for (const struct ts_expr_function *const *t = ts_expr_functions; *t; t++)
		for (const struct ts_expr_function *f = *t; f->name; f++)
			add_word(list, f->name);
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (const struct ts_function *f = (*s)->functions; f && f->name; f++)
			add_word(list, f->name);
}

static void add_names(const struct ts_tables *tables, struct word_list *list)
{
	const struct ts_quantity *q;

	for (const struct ts_system_style *const *s = tables->systems; *s; s++) {
		for (const struct ts_keyword *k = (*s)->keywords; k && k->name; k++)
			add_word(list, k->name);
		for (size_t k = 0; (*s)->quantity_text && (q = (*s)->quantity_text(k)); k++)
			add_word(list, q->name);
	}
	for (const struct ts_constant *c = ts_constants; c->name; c++)
		add_word(list, c->name);
}

/* Position of the style in a line: after the command and this number of words. */
static const struct {
	enum ts_kind kind;
	const char *command;
	int words;
} places[] = {
	{ TS_KIND_FIX, "fix", 2 },
	{ TS_KIND_COMPUTE, "compute", 2 },
	{ TS_KIND_REGION, "region", 1 },
	{ TS_KIND_DUMP, "dump", 2 },
	{ TS_KIND_PAIR, "pair_style", 0 },
	{ TS_KIND_BOND, "bond_style", 0 },
	{ TS_KIND_FLOW, "flow_style", 0 },
	{ TS_KIND_PRESSURE, "pressure_style", 0 },
	{ TS_KIND_AUTOMATON, "automaton_style", 0 },
};
enum { NPLACES = sizeof places / sizeof *places };

/* ---- vim */

/* Words such as `contained` are read as options in a list of keywords. */
static bool is_vim_option(const char *word)
{
	static const char *const options[] = { "contained", "transparent", "skipwhite", "skipnl", "skipempty",
					       "conceal",   "display",	   "extend",	"fold",	  "oneline" };

	for (size_t k = 0; k < sizeof options / sizeof *options; k++)
		if (ts_streq(options[k], word))
			return true;
	return false;
}

/* Appends the words as alternatives of a pattern. */
static void vim_alternatives(struct ts_str *out, const struct word_list *list)
{
	for (size_t k = 0; k < list->n; k++)
		ts_str_addf(out, "%s%s", k ? "\\|" : "", list->word[k]);
	out->failed |= list->failed;
}

/* In Vim a keyword has precedence over a match, so words that are also commands are written as matches. */
static void vim_keywords(const struct ts_tables *tables, struct ts_str *out, const char *group,
			 const char *options, const struct word_list *list)
{
	size_t column = 100;

	for (size_t k = 0; k < list->n; k++) {
		if (is_vim_option(list->word[k]) || ts_style_find(tables, TS_KIND_COMMAND, list->word[k])) {
			ts_str_addf(out, "\nsyn match %s /\\<%s\\>/ %s", group, list->word[k], options);
			column = 100;
			continue;
		}
		if (column + strlen(list->word[k]) > 96) {
			ts_str_addf(out, "\nsyn keyword %s %s", group, options);
			column = 30;
		}
		ts_str_addf(out, " %s", list->word[k]);
		column += strlen(list->word[k]) + 1;
	}
	ts_str_add(out, "\n");
	out->failed |= list->failed;
}

static void vim_styles(const struct ts_tables *tables, struct ts_str *out)
{
	struct word_list list = { 0 };

	for (size_t k = 0; k < NPLACES; k++) {
		char group[32];

		ts_str_addf(out, "syn match tsimHead /^\\s*%s\\s\\+", places[k].command);
		for (int w = 0; w < places[k].words; w++)
			ts_str_add(out, "\\S\\+\\s\\+");
		snprintf(group, sizeof group, "tsim_%s", ts_kind_name(places[k].kind));
		ts_str_addf(out, "/ contains=tsimCommand,tsimVariable nextgroup=%s", group);
		add_styles(tables, &list, places[k].kind);
		vim_keywords(tables, out, group, "contained", &list);
		ts_str_addf(out, "hi def link %s Type\n", group);
		release_words(&list);
	}
}

void ts_grammar_vim(const struct ts_tables *tables, struct ts_str *out)
{
	static const char start[] =
		"\" Vim syntax file for scripts of tsim, made by `tsim -grammar vim`\n"
		"if exists(\"b:current_syntax\")\n  finish\nendif\n"
		"syn case match\n"
		"syn iskeyword @,48-57,_,/,-\n"
		"syn sync minlines=50\n\n"
		"syn match tsimNumber /\\<[-+]\\=\\d\\+\\%(\\.\\d*\\)\\=\\%([eE][-+]\\=\\d\\+\\)\\=\\>/\n"
		"syn match tsimNumber /[-+]\\=\\.\\d\\+\\%([eE][-+]\\=\\d\\+\\)\\=\\>/\n"
		"syn match tsimReference /\\<[cfv]_[A-Za-z0-9_]\\+\\%(\\[[0-9*]\\+\\]\\)*/\n"
		"syn match tsimVariable /\\$\\%({[^}]*}\\|[A-Za-z0-9_]\\)/\n"
		"syn region tsimFormula matchgroup=tsimVariable start=/\\$(/ end=/)/ "
		"contains=tsimInner,tsimNumber,tsimReference,tsimVariable,tsimFunction,tsimName\n"
		"syn region tsimInner contained start=/(/ end=/)/ transparent "
		"contains=tsimInner,tsimNumber,tsimReference,tsimVariable,tsimFunction,tsimName\n"
		"syn region tsimString start=/\"/ end=/\"/ contains=tsimVariable,tsimFormula\n"
		"syn region tsimString start=/'/ end=/'/ contains=tsimVariable,tsimFormula\n"
		"syn region tsimString start=/\"\"\"/ end=/\"\"\"/ contains=tsimVariable,tsimFormula\n"
		"syn match tsimContinuation /&\\s*$/\n"
		"syn match tsimComment /#.*$/ contains=@Spell\n";
	static const char end[] = "\nhi def link tsimCommand Statement\nhi def link tsimKeyword Identifier\n"
				  "hi def link tsimName Constant\nhi def link tsimFunction Function\n"
				  "hi def link tsimNumber Number\nhi def link tsimReference Special\n"
				  "hi def link tsimVariable PreProc\nhi def link tsimString String\n"
				  "hi def link tsimContinuation Delimiter\nhi def link tsimComment Comment\n"
				  "\nlet b:current_syntax = \"tsim\"\n";
	struct word_list list = { 0 };

	ts_str_add(out, start);
	ts_str_add(out, "\n\" keywords and words to choose from");
	add_keywords(tables, &list);
	vim_keywords(tables, out, "tsimKeyword", "", &list);
	release_words(&list);
	ts_str_add(out, "\n\" numbers of the simulation and of particles");
	add_names(tables, &list);
	vim_keywords(tables, out, "tsimName", "", &list);
	release_words(&list);
	add_functions(tables, &list);
	ts_str_add(out, "\nsyn match tsimFunction /\\<\\%(");
	vim_alternatives(out, &list);
	ts_str_add(out, "\\)\\ze(/\n");
	release_words(&list);
	add_styles(tables, &list, TS_KIND_COMMAND);
	ts_str_add(out, "\n\" commands, at the start of a line\nsyn match tsimCommand /^\\s*\\%(");
	vim_alternatives(out, &list);
	ts_str_add(out, "\\)\\ze\\%(\\s\\|$\\)/\n");
	release_words(&list);
	ts_str_add(out, "\n\" styles, behind their command, name and group\n");
	vim_styles(tables, out);
	ts_str_add(out, end);
}

/* ---- TextMate, as VS Code reads it */

static void json_alternatives(struct ts_str *out, const struct word_list *list)
{
	/* longer words first: the first alternative that matches is taken */
	for (size_t length = 64; length > 0; length--)
		for (size_t k = 0; k < list->n; k++)
			if (strlen(list->word[k]) == length)
				ts_str_addf(out, "%s|", list->word[k]);
	if (list->n)
		out->text[--out->length] = '\0';
	out->failed |= list->failed;
}

static void json_rule(struct ts_str *out, const char *scope, const char *before, const struct word_list *list,
		      const char *after)
{
	ts_str_addf(out, "    { \"name\": \"%s.tsim\", \"match\": \"%s(?:", scope, before);
	json_alternatives(out, list);
	ts_str_addf(out, ")%s\" },\n", after);
}

static void json_styles(const struct ts_tables *tables, struct ts_str *out)
{
	struct word_list list = { 0 };

	for (size_t k = 0; k < NPLACES; k++) {
		ts_str_addf(out, "    { \"match\": \"^\\\\s*(%s)\\\\s+", places[k].command);
		for (int w = 0; w < places[k].words; w++)
			ts_str_add(out, "\\\\S+\\\\s+");
		ts_str_add(out, "(");
		add_styles(tables, &list, places[k].kind);
		json_alternatives(out, &list);
		ts_str_addf(out,
			    ")(?=\\\\s|$)\", \"captures\": { \"1\": { \"name\": \"keyword.control.tsim\" }, "
			    "\"2\": { \"name\": \"support.type.%s.tsim\" } } },\n",
			    ts_kind_name(places[k].kind));
		release_words(&list);
	}
}

void ts_grammar_textmate(const struct ts_tables *tables, struct ts_str *out)
{
	static const char start[] =
		"{\n"
		"  \"name\": \"tsim\",\n  \"scopeName\": \"source.tsim\",\n"
		"  \"fileTypes\": [\"tsim\", \"in\", \"liggghts\", \"lmp\"],\n"
		"  \"patterns\": [\n"
		"    { \"name\": \"comment.line.number-sign.tsim\", \"match\": \"#.*$\" },\n"
		"    { \"name\": \"punctuation.separator.continuation.tsim\", \"match\": \"&\\\\s*$\" },\n"
		"    { \"name\": \"string.quoted.triple.tsim\", \"begin\": \"\\\"\\\"\\\"\", \"end\": "
		"\"\\\"\\\"\\\"\", \"patterns\": [ { \"include\": \"#variable\" } ] },\n"
		"    { \"name\": \"string.quoted.double.tsim\", \"begin\": \"\\\"\", \"end\": \"\\\"|$\", "
		"\"patterns\": [ { \"include\": \"#variable\" } ] },\n"
		"    { \"name\": \"string.quoted.single.tsim\", \"begin\": \"'\", \"end\": \"'|$\", "
		"\"patterns\": [ { \"include\": \"#variable\" } ] },\n"
		"    { \"include\": \"#variable\" },\n";
	static const char end[] =
		"    { \"name\": \"variable.other.reference.tsim\", \"match\": "
		"\"\\\\b[cfv]_[A-Za-z0-9_]+(?:\\\\[[0-9*]+\\\\])*\" },\n"
		"    { \"name\": \"constant.numeric.tsim\", \"match\": "
		"\"(?<![A-Za-z0-9_/"
		"])[-+]?(?:[0-9]+\\\\.?[0-9]*|\\\\.[0-9]+)(?:[eE][-+]?[0-9]+)?(?![A-Za-z0-9_/])\" }\n"
		"  ],\n"
		"  \"repository\": {\n"
		"    \"variable\": { \"patterns\": [\n"
		"      { \"name\": \"variable.parameter.tsim\", \"match\": "
		"\"\\\\$(?:\\\\{[^}]*\\\\}|[A-Za-z0-9_])\" },\n"
		"      { \"name\": \"meta.formula.tsim\", \"match\": \"\\\\$\\\\([^)]*\\\\)\" }\n"
		"    ] }\n"
		"  }\n"
		"}\n";
	struct word_list list = { 0 };

	ts_str_add(out, start);
	json_styles(tables, out);
	add_styles(tables, &list, TS_KIND_COMMAND);
	json_rule(out, "keyword.control", "^\\\\s*", &list, "(?=\\\\s|$)");
	release_words(&list);
	add_functions(tables, &list);
	json_rule(out, "support.function", "\\\\b", &list, "(?=\\\\()");
	release_words(&list);
	add_keywords(tables, &list);
	json_rule(out, "variable.language.keyword", "(?<![A-Za-z0-9_/])", &list, "(?![A-Za-z0-9_/])");
	release_words(&list);
	add_names(tables, &list);
	json_rule(out, "constant.language", "(?<![A-Za-z0-9_/])", &list, "(?![A-Za-z0-9_/])");
	release_words(&list);
	ts_str_add(out, end);
}
