#include "study/study_words.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { LONGEST_PART = 4096, MOST_VALUES = 100000 };

/* One part `NAME=ITEMS` of the words. */
struct part {
	struct ts_study_words *w;
	struct ts_error *err;
	const char *option, *name;
	char *items;
};

/* Calls a function for each part. */
static enum ts_status for_each_part(struct part *p, struct ts_words words,
				    enum ts_status (*take)(struct part *, void *), void *data)
{
	for (size_t k = 0; k < words.n; k++) {
		const char *text = words.word[k].text;

		for (text += strspn(text, " \t\n"); *text; text += strspn(text, " \t\n")) {
			size_t n = strcspn(text, " \t\n"), name = strcspn(text, "= \t\n");
			char *copy = ts_arena_alloc(&p->w->arena, n + 1, 1);

			if (!copy)
				return ts_nomem(p->err);
			memcpy(copy, text, n);
			if (name == 0 || name + 1 >= n)
				return ts_fail(p->err, TS_SYNTAX, NULL,
					       "%s: expected NAME=VALUE, found '%.80s'", p->option, copy);
			copy[name] = '\0';
			p->name = copy;
			p->items = copy + name + 1;
			TS_TRY(take(p, data));
			text += n;
		}
	}
	return TS_OK;
}

size_t ts_study_words_find(const struct ts_study_words *w, const char *name)
{
	for (size_t k = 0; k < w->variables; k++)
		if (ts_streq(w->variable[k].name, name))
			return k;
	return SIZE_MAX;
}

const char *ts_study_words_number(struct ts_study_words *w, double value)
{
	char text[32];

	snprintf(text, sizeof text, "%.9g", value);
	return ts_arena_strdup(&w->arena, text);
}

static enum ts_status add_value(struct ts_study_variable *v, size_t *capacity, const char *text,
				struct ts_error *err)
{
	if (!text || TS_GROW(v->value, *capacity, v->n + 1) != TS_OK)
		return ts_nomem(err);
	for (size_t k = 0; k < v->n; k++)
		if (ts_streq(v->value[k], text))
			return ts_fail(err, TS_RANGE, NULL, "the value %s of '%s' is given twice", text,
				       v->name);
	v->value[v->n++] = text;
	return TS_OK;
}

/* Splits at ':' into at most `most` numbers; the number of fields, 0 if one is no number. `logarithmic`: the fourth may be the
 * word log. */
static size_t split_numbers(char *item, double *number, size_t most, bool *logarithmic)
{
	size_t n = 0;

	for (char *field = item, *next; field; field = next) {
		next = strchr(field, ':');
		if (next)
			*next++ = '\0';
		if (logarithmic && n == 3 && !next && ts_streq(field, "log"))
			*logarithmic = true;
		else if (n == most || !ts_parse_real(field, &number[n]))
			return 0;
		n++;
	}
	return n;
}

/* LO:HI:N or LO:HI:N:log */
static enum ts_status add_range(struct part *p, struct ts_study_variable *v, size_t *capacity, char *item)
{
	double number[3] = { 0 };
	bool logarithmic = false;
	char *shown = ts_arena_strdup(&p->w->arena, item);
	size_t n = split_numbers(item, number, 3, &logarithmic);
	double lo = number[0], hi = number[1], count = number[2];

	if (!shown)
		return ts_nomem(p->err);
	if (n < 3 || count < 2 || count > MOST_VALUES || count != floor(count))
		return ts_fail(p->err, TS_SYNTAX, NULL,
			       "%s: expected LO:HI:N or LO:HI:N:log with N from 2 to %d for '%s', found "
			       "'%.80s'",
			       p->option, MOST_VALUES, p->name, shown);
	if (logarithmic && !(lo * hi > 0))
		return ts_fail(p->err, TS_RANGE, NULL,
			       "%s: the ends of a logarithmic range have one sign and are not zero, found "
			       "'%.80s' for '%s'",
			       p->option, shown, p->name);
	for (double k = 0; k < count; k++) {
		double part = k / (count - 1), value = lo * (1 - part) + hi * part;

		if (logarithmic)
			value = copysign(exp(log(fabs(lo)) * (1 - part) + log(fabs(hi)) * part), lo);
		TS_TRY(add_value(v, capacity, ts_study_words_number(p->w, value), p->err));
	}
	return TS_OK;
}

static enum ts_status parse_list(struct part *p, struct ts_study_variable *v)
{
	size_t capacity = 0;

	for (char *item = p->items, *next; item; item = next) {
		next = strchr(item, ',');
		if (next)
			*next++ = '\0';
		if (!*item)
			return ts_fail(p->err, TS_SYNTAX, NULL,
				       "%s: a value of '%s' is missing beside a comma", p->option, p->name);
		TS_TRY(strchr(item, ':') ? add_range(p, v, &capacity, item)
					 : add_value(v, &capacity, item, p->err));
	}
	return TS_OK;
}

/* START[:LO:HI] */
static enum ts_status parse_varied(struct part *p, struct ts_study_variable *v)
{
	char *shown = ts_arena_strdup(&p->w->arena, p->items);
	double number[3] = { 0 };
	size_t n = split_numbers(p->items, number, 3, NULL);

	if (!shown)
		return ts_nomem(p->err);
	if (n != 1 && n != 3)
		return ts_fail(p->err, TS_SYNTAX, NULL,
			       "%s: expected START or START:LO:HI for '%s', found '%.80s'", p->option,
			       p->name, shown);
	v->start = number[0];
	v->lo = n == 3 ? number[1] : v->start / 10;
	v->hi = n == 3 ? number[2] : v->start * 10;
	if (!(v->start > 0) || !(v->lo > 0))
		return ts_fail(p->err, TS_RANGE, NULL,
			       "%s: '%s' is varied by factors, so start and bounds are positive, found "
			       "'%.80s'",
			       p->option, p->name, shown);
	if (!(v->lo < v->hi) || v->start < v->lo || v->start > v->hi)
		return ts_fail(p->err, TS_RANGE, NULL,
			       "%s: expected LO < HI with START between them for '%s', found '%.80s'",
			       p->option, p->name, shown);
	return TS_OK;
}

/* OTHER or OTHER*FACTOR; *is: whether it is one. */
static enum ts_status parse_tie(struct part *p, struct ts_study_variable *v, bool *is)
{
	char *star = strchr(p->items, '*');

	if (star)
		*star = '\0';
	v->tied = ts_study_words_find(p->w, p->items);
	*is = v->tied != SIZE_MAX;
	if (star)
		*star = '*';
	if (!*is)
		return TS_OK;
	v->factor = 1;
	v->role = TS_STUDY_TIED;
	if (p->w->variable[v->tied].role == TS_STUDY_TIED)
		return ts_fail(p->err, TS_RANGE, NULL, "%s: '%s' is tied to '%s', which is tied itself",
			       p->option, p->name, p->w->variable[v->tied].name);
	if (star && !ts_parse_real(star + 1, &v->factor))
		return ts_fail(p->err, TS_SYNTAX, NULL,
			       "%s: expected a number behind the * of '%s', found '%.80s'", p->option,
			       p->name, star + 1);
	return TS_OK;
}

static enum ts_status check_name(const struct part *p, const char *name)
{
	for (const char *c = name; *c; c++)
		if (!isalnum((unsigned char)*c) && *c != '_')
			return ts_fail(p->err, TS_SYNTAX, NULL, "%s: '%.80s' is no name of a variable",
				       p->option, name);
	if (ts_study_words_find(p->w, name) != SIZE_MAX)
		return ts_fail(p->err, TS_RANGE, NULL, "%s: the variable '%.80s' is given twice", p->option,
			       name);
	return TS_OK;
}

static enum ts_status take_variable(struct part *p, void *data)
{
	const enum ts_study_role *role = data;
	struct ts_study_variable *v;
	bool tie = false;

	TS_TRY(check_name(p, p->name));
	if (TS_GROW(p->w->variable, p->w->variable_capacity, p->w->variables + 1) != TS_OK)
		return ts_nomem(p->err);
	v = &p->w->variable[p->w->variables];
	*v = (struct ts_study_variable){ .name = p->name, .role = *role };
	TS_TRY(parse_tie(p, v, &tie));
	p->w->variables++; /* from here on released with the others */
	if (tie)
		return TS_OK;
	return *role == TS_STUDY_VARIED ? parse_varied(p, v) : parse_list(p, v);
}

enum ts_status ts_study_words_variables(struct ts_study_words *w, const char *option, enum ts_study_role role,
					struct ts_words words, struct ts_error *err)
{
	struct part p = { .w = w, .err = err, .option = option };

	return for_each_part(&p, words, take_variable, &role);
}

enum ts_status ts_study_words_fixed(struct ts_study_words *w, struct ts_words words, struct ts_error *err)
{
	struct part p = { .w = w, .err = err, .option = "-var" };

	for (size_t k = 0; k < words.n;) {
		struct ts_str text = { 0 };
		struct ts_study_variable v = { .role = TS_STUDY_FIXED };
		size_t capacity = 0;

		v.name = words.word[++k].text; /* behind the word -var */
		TS_TRY(check_name(&p, v.name));
		for (k++; k < words.n && !ts_streq(words.word[k].text, "-var"); k++)
			ts_str_addf(&text, "%s%s", text.length ? " " : "", words.word[k].text);
		p.items = text.failed ? NULL : ts_arena_strdup(&w->arena, ts_str_text(&text));
		ts_str_release(&text);
		if (TS_GROW(w->variable, w->variable_capacity, w->variables + 1) != TS_OK)
			return ts_nomem(err);
		w->variable[w->variables] = v;
		TS_TRY(add_value(&w->variable[w->variables++], &capacity, p.items, err));
	}
	return TS_OK;
}

static enum ts_status take_target(struct part *p, void *data)
{
	struct ts_study_target t = { .name = p->name, .tolerance = *(const double *)data };
	char *shown = ts_arena_strdup(&p->w->arena, p->items);
	double number[2] = { 0, t.tolerance };
	size_t n = split_numbers(p->items, number, 2, NULL);

	if (!shown)
		return ts_nomem(p->err);
	t.value = number[0];
	t.tolerance = number[1];
	if (n == 0)
		return ts_fail(p->err, TS_SYNTAX, NULL,
			       "%s: expected VALUE or VALUE:TOLERANCE for '%s', found '%.80s'", p->option,
			       p->name, shown);
	if (t.value == 0)
		return ts_fail(p->err, TS_RANGE, NULL,
			       "%s: the target of '%s' is 0, of which no tolerance is a part", p->option,
			       p->name);
	if (!(t.tolerance > 0) || t.tolerance >= 1)
		return ts_fail(p->err, TS_RANGE, NULL,
			       "%s: expected a tolerance above 0 and below 1 for '%s', found %g", p->option,
			       p->name, t.tolerance);
	for (size_t k = 0; k < p->w->targets; k++)
		if (ts_streq(p->w->target[k].name, t.name))
			return ts_fail(p->err, TS_RANGE, NULL, "%s: the target '%s' is given twice",
				       p->option, t.name);
	if (TS_GROW(p->w->target, p->w->target_capacity, p->w->targets + 1) != TS_OK)
		return ts_nomem(p->err);
	p->w->target[p->w->targets++] = t;
	return TS_OK;
}

enum ts_status ts_study_words_targets(struct ts_study_words *w, struct ts_words words, double tolerance,
				      struct ts_error *err)
{
	struct part p = { .w = w, .err = err, .option = "-calibrate" };

	return for_each_part(&p, words, take_target, &tolerance);
}

void ts_study_words_release(struct ts_study_words *w)
{
	for (size_t k = 0; k < w->variables; k++)
		ts_free(w->variable[k].value);
	ts_free(w->variable);
	ts_free(w->target);
	ts_arena_release(&w->arena);
	*w = (struct ts_study_words){ 0 };
}
