/* Names that a script defines and never mentions again: most often misspelt ones.
 *
 * The search is purely textual and includes lines never reached: a name counts as used wherever it occurs
 * outside of comments and of the line that defines it, also behind c_, f_, v_ or in quotes. So a use in a
 * branch not taken, or in a command composed of variables, is never overlooked. c2$k may be a use of each name
 * that begins with c2. Scripts that are included may define what only others that include them mention: their
 * definitions are not looked at. */
#include <ctype.h>
#include <string.h>

#include "base/map.h"
#include "script/internal.h"

#include "base/banned.h"

static const char *const defining[] = { "variable", "group", "region", "compute" };

enum { LONGEST_NAME = 64 };

struct definition {
	struct definition *next;
	const char *kind, *name;
	struct ts_place where;
};

/* The ends of a name that is composed by substitution: `c2$k`, ${side}_force. */
struct composed {
	struct composed *next;
	const char *head, *tail;
};

struct search {
	struct ts_script *script;
	struct ts_map used;
	struct composed *composed;
	struct definition *first, **last;
	struct ts_arena arena;
	bool failed;
};

static bool is_name_character(char c)
{
	return isalnum((unsigned char)c) || c == '_';
}

static void mark_used(struct search *s, const char *text, size_t n)
{
	char name[LONGEST_NAME];
	const char *kept;

	if (n == 0 || n >= sizeof name)
		return;
	memcpy(name, text, n);
	name[n] = '\0';
	if (ts_map_get(&s->used, name))
		return;
	kept = ts_arena_strdup(&s->arena, name);
	s->failed |= !kept || ts_map_set(&s->used, kept, s) != TS_OK;
}

/* Marks all names in a text as used; c_ID is also a use of ID, and $xy may be one of x. */
static void mark_names_used(struct search *s, const char *text, size_t n)
{
	for (size_t k = 0; k < n;) {
		size_t m = 0;

		while (k + m < n && is_name_character(text[k + m]))
			m++;
		mark_used(s, text + k, m);
		if (m > 2 && text[k + 1] == '_' && strchr("cfv", text[k]))
			mark_used(s, text + k + 2, m - 2);
		if (m > 1 && k > 0 && text[k - 1] == '$')
			mark_used(s, text + k, 1);
		k += m + 1;
	}
}

/* The position behind the substitution at the $ at `at`; `at`: there is none. */
static size_t substitution_end(const char *text, size_t n, size_t at)
{
	const char open = at + 1 < n ? text[at + 1] : ' ', close = open == '{' ? '}' : ')';
	int depth = 0;

	if (open != '{' && open != '(')
		return is_name_character(open) ? at + 2 : at;
	for (size_t k = at + 1; k < n; k++) {
		depth += (text[k] == open) - (text[k] == close);
		if (!depth)
			return k + 1;
	}
	return at;
}

static void add_composed(struct search *s, const char *head, size_t nhead, const char *tail, size_t ntail)
{
	struct composed *new = ts_arena_alloc(&s->arena, 1, sizeof *new);
	char text[2][LONGEST_NAME] = { "", "" };

	if (nhead >= LONGEST_NAME || ntail >= LONGEST_NAME)
		return;
	s->failed |= !new;
	if (!new)
		return;
	memcpy(text[0], head, nhead);
	memcpy(text[1], tail, ntail);
	*new = (struct composed){ s->composed, ts_arena_strdup(&s->arena, text[0]),
				  ts_arena_strdup(&s->arena, text[1]) };
	s->failed |= !new->head || !new->tail;
	s->composed = new;
}

/* Keeps the ends of all names of a text of which a part is substituted. */
static void mark_composed_names(struct search *s, const char *text, size_t n)
{
	for (size_t from = 0, k = 0; from < n; from = ++k) {
		size_t first = n, last = n, end; /* the first $, and the end of the last substitution */

		for (; k < n; k = end) {
			end = is_name_character(text[k]) ? k + 1
			      : text[k] == '$'		 ? substitution_end(text, n, k)
							 : k;
			if (end == k)
				break;
			if (text[k] != '$')
				continue;
			first = first == n ? k : first;
			last = end;
		}
		if (first < n && (first > from || last < k))
			add_composed(s, text + from, first - from, text + last, k - last);
	}
}

static void add_definition(struct search *s, const char *kind, const char *text, size_t n,
			   const struct ts_place *where)
{
	struct definition *new = ts_arena_alloc(&s->arena, 1, sizeof *new);
	char name[LONGEST_NAME];

	if (n >= sizeof name)
		return;
	memcpy(name, text, n);
	name[n] = '\0';
	for (size_t k = 0; k < n; k++)
		if (!is_name_character(name[k])) /* composed of variables, or several words */
			return;
	if (!new) {
		s->failed = true;
		return;
	}
	*new = (struct definition){ .kind = kind, .where = *where };
	new->name = ts_arena_strdup(&s->arena, name);
	s->failed |= !new->name;
	*s->last = new;
	s->last = &new->next;
}

/* The length of the line up to the comment. */
static size_t length_without_comment(const char *line, size_t n)
{
	for (size_t k = 0; k < n; k++)
		if (line[k] == '#' && (k == 0 || isspace((unsigned char)line[k - 1])))
			return k;
	return n;
}

/* mentions: the line only mentions names, as it goes on another one or is of a script that is included. */
static void search_line(struct search *s, const char *line, size_t n, bool mentions,
			const struct ts_place *where)
{
	static const char blanks[] = " \t";
	size_t first = strspn(line, blanks), word, id, end;

	n = length_without_comment(line, n);
	if (first >= n)
		return;
	word = strcspn(line + first, " \t\n");
	id = first + word + strspn(line + first + word, blanks);
	for (size_t k = 0; !mentions && k < sizeof defining / sizeof *defining; k++) {
		if (strlen(defining[k]) != word || strncmp(defining[k], line + first, word) != 0 || id >= n)
			continue;
		end = id + strcspn(line + id, " \t\n");
		if (end > n)
			end = n;
		add_definition(s, defining[k], line + id, end - id, where);
		mark_names_used(s, line + end, n - end);
		mark_composed_names(s, line + end, n - end);
		return;
	}
	mark_names_used(s, line + first, n - first);
	mark_composed_names(s, line + first, n - first);
}

static void search_text(struct search *s, const struct ts_script_text *script)
{
	struct ts_place where = { .file = script->name, .line = 1 };
	const char *text = script->text;
	bool continued = false;

	for (; *text; where.line++) {
		size_t n = strcspn(text, "\n"), end = n;

		search_line(s, text, n, continued || script->included, &where);
		while (end && isspace((unsigned char)text[end - 1]))
			end--;
		continued = end && text[end - 1] == '&';
		text += n + (text[n] == '\n');
	}
}

/* A variable that a branch not taken would define: what uses it may be in a file that was not read. */
static bool is_absent(const struct search *s, const struct definition *d)
{
	return d->kind == defining[0] && !ts_variable_find(&s->script->formulas, d->name);
}

static bool is_number(const char *name)
{
	return strspn(name, "0123456789") == strlen(name);
}

static bool has_ends(const char *name, const char *head, const char *tail)
{
	size_t n = strlen(name), nhead = strlen(head), ntail = strlen(tail);

	if (!nhead && !ntail) /* c_$k */
		return is_number(name);
	return n >= nhead + ntail && strncmp(name, head, nhead) == 0 && ts_streq(name + n - ntail, tail);
}

/* Whether a name that is composed by substitution may be this one. */
static bool may_be_composed(const struct search *s, const char *name)
{
	for (const struct composed *c = s->composed; c; c = c->next) {
		const bool prefixed = strchr("cfv", *c->head) && *c->head && c->head[1] == '_';

		if (has_ends(name, c->head, c->tail) || (prefixed && has_ends(name, c->head + 2, c->tail)))
			return true;
	}
	return false;
}

static void warn_unused(struct search *s)
{
	for (const struct definition *d = s->first; d; d = d->next) {
		if (s->failed || ts_map_get(&s->used, d->name) || is_absent(s, d) ||
		    may_be_composed(s, d->name))
			continue;
		ts_warn(&s->script->sim->log, &d->where, "%s '%s' is never used", d->kind, d->name);
		s->failed |= ts_map_set(&s->used, d->name, s) != TS_OK; /* once */
	}
}

void ts_script_warn_unused(struct ts_script *script)
{
	struct search s = { .script = script };

	s.last = &s.first;
	ts_variables_compact(&script->formulas);
	for (size_t k = 0; k < script->formulas.variables.n; k++) {
		const struct ts_variable *variable = script->formulas.variables.item[k];

		if (variable->given && !variable->used)
			ts_warn(&script->sim->log, NULL,
				"variable '%s' was set from outside, but the script does not use it",
				variable->name);
	}
	for (const struct ts_script_text *t = script->text; t; t = t->next)
		search_text(&s, t);
	warn_unused(&s);
	ts_map_release(&s.used);
	ts_arena_release(&s.arena);
}
