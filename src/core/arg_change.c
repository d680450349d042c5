#include "core/arg_change.h"

#include <string.h>

#include "core/sim.h"

#include "base/banned.h"

struct comparison {
	struct tsim *sim;
	const struct ts_instance *inst;
	const char *what, *lines;
	const char *next;	   /* line behind the last one that was found */
	const struct ts_arg *mode; /* the argument whose mode has the present ones; NULL: none */
	struct ts_words words;
	struct ts_str *out;
	struct ts_str before, now; /* values of the present argument in the restart file and in the script */
};

static void add_argument_line(const struct tsim *sim, const struct ts_arg *row, const void *base,
			      struct ts_str *out)
{
	struct ts_str value = { 0 };

	if (ts_arg_record(sim, row, base, &value)) {
		for (size_t k = 0; k < value.length; k++)
			if (value.text[k] == '\n')
				value.text[k] = ' ';
		ts_str_addf(out, "%s%s\n", row->name, ts_str_text(&value));
	}
	out->failed |= value.failed;
	ts_str_release(&value);
}

void ts_args_lines(const struct tsim *sim, const struct ts_arg *rows, const void *base, struct ts_str *out)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		int mode = row->type == TS_ARG_MODE ? *(const int *)((const char *)base + row->offset) : -1;

		add_argument_line(sim, row, base, out);
		if (mode >= 0)
			ts_args_lines(sim, row->modes[mode].args, base, out);
	}
}

/* A number with as few digits as give the same value again. */
static void add_shortest_number(const char *text, size_t n, struct ts_str *out)
{
	char word[64], brief[40];
	double value, again;

	snprintf(word, sizeof word, "%.*s", (int)(n < 63 ? n : 63), text);
	if (n < 63 && ts_parse_real(word, &value)) {
		snprintf(brief, sizeof brief, "%.15g", value);
		if (ts_parse_real(brief, &again) && again == value) {
			ts_str_add(out, brief);
			return;
		}
	}
	ts_str_add_n(out, text, n);
}

/* The words of a value, separated by one blank, numbers in their shortest form. */
static void normalise_value(struct ts_str *out, const char *text, size_t n)
{
	ts_str_clear(out);
	for (size_t at = 0, length; at < n; at += length + 1) {
		length = strcspn(text + at, " \n");
		if (length > n - at)
			length = n - at;
		if (length && out->length)
			ts_str_add(out, " ");
		if (length)
			add_shortest_number(text + at, length, out);
	}
}

/* The line with the argument's name between two lines, or NULL. */
static const char *find_line(const char *from, const char *to, const struct ts_arg *row)
{
	size_t n = strlen(row->name);

	for (const char *line = from; *line && line != to; line += strcspn(line, "\n"), line += *line != 0)
		if (strncmp(line, row->name, n) == 0 && line[n] == ' ')
			return line;
	return NULL;
}

/* Lines are in the order of the rows, and arguments of modes have the same names in each of them: the search begins behind the
 * last line. Only rows of the style itself may be in another order, in the file of another version. */
static bool find_saved_value(struct comparison *c, const struct ts_arg *row)
{
	const char *line = find_line(c->next, NULL, row);
	size_t n = strlen(row->name), length;

	if (!line && !c->mode)
		line = find_line(c->lines, c->next, row);
	if (!line)
		return false;
	length = strcspn(line, "\n");
	normalise_value(&c->before, line + n, length - n);
	c->next = line + length + (line[length] != 0);
	return true;
}

/* Index of the word behind the keyword of an argument; 0: none, or no keyword. */
static size_t find_keyword(const struct comparison *c, const struct ts_arg *row)
{
	for (size_t k = 0; k + 1 < c->words.n && !(row->flags & TS_POSITIONAL); k++)
		if (ts_streq(c->words.word[k].text, row->name))
			return k + 1;
	return 0;
}

/* The place of the word that sets the argument: the one behind its keyword, or the one with its value. */
static const struct ts_place *place_of_argument(const struct comparison *c, const struct ts_arg *row)
{
	struct ts_str word = { 0 };
	const struct ts_place *place = NULL;
	size_t k = find_keyword(c, row);

	if (k)
		return &c->words.word[k].place;
	for (k = c->mode ? find_keyword(c, c->mode) : 0; k < c->words.n && !place; k++) {
		normalise_value(&word, c->words.word[k].text, strlen(c->words.word[k].text));
		if (word.length && c->now.length >= word.length &&
		    strncmp(ts_str_text(&word), ts_str_text(&c->now), word.length) == 0)
			place = &c->words.word[k].place;
	}
	ts_str_release(&word);
	return place ? place : &c->inst->where;
}

static enum ts_status refuse_change(const struct comparison *c, const struct ts_arg *row, bool was, bool is)
{
	const char *kind = ts_kind_name(c->inst->style->kind);
	const bool has_id = c->inst->id && *c->inst->id;
	const bool named = c->mode && !(c->mode->flags & TS_POSITIONAL);

	return ts_fail(&c->sim->error, TS_STATE, place_of_argument(c, row),
		       "%s: %s%s%s is '%s' here but '%s' in the restart file, and the saved state is valid "
		       "only with that; use it again, or %s%s%s",
		       c->what, row->name, named ? " of " : "", named ? c->mode->name : "",
		       is ? ts_str_text(&c->now) : "not given", was ? ts_str_text(&c->before) : "not given",
		       has_id ? "give this " : "start without a restart file", has_id ? kind : "",
		       has_id ? " another id to start without that state" : "");
}

static enum ts_status compare_argument(struct comparison *c, const struct ts_arg *row)
{
	struct ts_str value = { 0 };
	bool is = ts_arg_record(c->sim, row, c->inst->state, &value), was = find_saved_value(c, row);

	normalise_value(&c->now, ts_str_text(&value), value.length);
	c->now.failed |= value.failed;
	ts_str_release(&value);
	if (!was && row->fallback) { /* the file is of a version without this argument */
		normalise_value(&c->before, row->fallback, strlen(row->fallback));
		was = true;
	}
	if (c->before.failed || c->now.failed)
		return ts_nomem(&c->sim->error);
	if (was == is && (!is || ts_streq(ts_str_text(&c->before), ts_str_text(&c->now))))
		return TS_OK;
	if (row->flags & TS_STATEFUL)
		return refuse_change(c, row, was, is);
	ts_str_addf(c->out, "%s%s %s -> %s", c->out->length ? ", " : "", row->name,
		    was ? ts_str_text(&c->before) : "none", is ? ts_str_text(&c->now) : "none");
	return TS_OK;
}

static enum ts_status compare_arguments(struct comparison *c, const struct ts_arg *rows)
{
	const struct ts_arg *outer = c->mode;

	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)c->inst->state + row->offset;

		TS_TRY(compare_argument(c, row));
		if (row->type != TS_ARG_MODE || *(const int *)field < 0)
			continue;
		c->mode = row;
		TS_TRY(compare_arguments(c, row->modes[*(const int *)field].args));
		c->mode = outer;
	}
	return TS_OK;
}

enum ts_status ts_args_changes(struct tsim *sim, const struct ts_instance *inst, const char *what,
			       const char *lines, struct ts_words words, struct ts_str *out)
{
	struct comparison c = { .sim = sim,
				.inst = inst,
				.what = what,
				.lines = lines,
				.next = lines,
				.words = words,
				.out = out };
	enum ts_status status = compare_arguments(&c, inst->style->args);

	ts_str_release(&c.before);
	ts_str_release(&c.now);
	if (status == TS_OK && out->failed)
		return ts_nomem(&sim->error);
	return status;
}
