/* Variables read from a file, one value (file) or one value for each particle (atomfile) at a time. The
 * format is that of LAMMPS: `#` begins a comment, blank lines are skipped. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/input_limit.h"
#include "base/sort.h"
#include "formula/formulas.h"

#include "base/banned.h"

struct ts_variable_feed {
	FILE *stream;
	struct ts_str row;    /* the last line read */
	struct ts_place line; /* its place, for messages */
	struct ts_str text;   /* file: the first word of the line, which is the present value */
	double *id, *value;   /* atomfile: identities and values of the present set, n each */
	size_t n, id_capacity, value_capacity;
	int64_t position; /* number of values or sets read */
};

static void release_feed(struct ts_variable *variable)
{
	struct ts_variable_feed *feed = variable->feed;

	if (!feed)
		return;
	if (feed->stream)
		fclose(feed->stream);
	ts_str_release(&feed->row);
	ts_str_release(&feed->text);
	ts_free(feed->id);
	ts_free(feed->value);
	ts_free(feed);
}

/* Reads a line without its end; *end: there is none. */
static enum ts_status read_row(struct ts_formulas *formulas, struct ts_variable_feed *feed, bool *end)
{
	size_t most = ts_input_longest_line();
	int c;

	ts_str_clear(&feed->row);
	feed->line.line++;
	while ((c = getc(feed->stream)) != EOF && c != '\n') {
		char byte = (char)c;

		if (!c)
			return ts_fail(&formulas->sim->error, TS_SYNTAX, &feed->line,
				       "this is not a text file: it has a byte 0 here");
		if (feed->row.length == most) {
			feed->line.text = "";
			return ts_fail(&formulas->sim->error, TS_RANGE, &feed->line,
				       "the line has more than %zu bytes; if that is intended, raise the "
				       "limit by -input-limit GB, of which a line may have a thousandth",
				       most);
		}
		ts_str_add_n(&feed->row, &byte, 1);
	}
	*end = c == EOF && !feed->row.length;
	feed->line.text = ts_str_text(&feed->row);
	if (c == EOF && ferror(feed->stream))
		return ts_fail(&formulas->sim->error, TS_IO, &feed->line, "cannot read: %s", strerror(errno));
	return feed->row.failed ? ts_nomem(&formulas->sim->error) : TS_OK;
}

/* The words of the next line that is not blank; memory comes from the arena. */
static enum ts_status read_words_of_next_line(struct ts_formulas *formulas, struct ts_variable_feed *feed,
					      struct ts_arena *arena, struct ts_words *words, bool *end)
{
	*end = false;
	for (words->n = 0; !words->n;) {
		TS_TRY(read_row(formulas, feed, end));
		if (*end)
			return TS_OK;
		if (ts_words_split(arena, feed->line.text, &feed->line, words) != TS_OK)
			return ts_nomem(&formulas->sim->error);
	}
	return TS_OK;
}

/* Copies the line of an error to the string pool, since the error outlives it. */
static enum ts_status keep_line(struct ts_formulas *formulas, const struct ts_variable_feed *feed,
				enum ts_status status)
{
	struct ts_place *place = &formulas->sim->error.place;

	if (status != TS_OK && place->text == feed->line.text)
		place->text = place->text ? ts_pool_get(formulas->sim->pool, place->text) : NULL;
	return status;
}

static enum ts_status next_file_value(struct ts_formulas *formulas, struct ts_variable *variable,
				      bool *exhausted)
{
	struct ts_variable_feed *feed = variable->feed;
	struct ts_arena arena = { 0 };
	struct ts_words words;
	enum ts_status status = read_words_of_next_line(formulas, feed, &arena, &words, exhausted);

	if (status == TS_OK && !*exhausted) {
		ts_str_clear(&feed->text);
		ts_str_add(&feed->text, words.word[0].text);
		feed->position++;
		if (feed->text.failed)
			status = ts_nomem(&formulas->sim->error);
	}
	ts_arena_release(&arena);
	return keep_line(formulas, feed, status);
}

/* One line `id value` of a set. */
static enum ts_status read_pair(struct ts_formulas *formulas, struct ts_variable_feed *feed,
				struct ts_arena *arena, int64_t left)
{
	struct ts_error *error = &formulas->sim->error;
	struct ts_words words;
	double number[2] = { 0 };
	bool end;

	TS_TRY(read_words_of_next_line(formulas, feed, arena, &words, &end));
	if (end)
		return ts_fail(error, TS_SYNTAX, &feed->line,
			       "the file ends within a set of values: %lld more were announced",
			       (long long)left);
	if (words.n != 2)
		return ts_fail(error, TS_SYNTAX, &words.word[0].place,
			       "expected the identity of a particle and a value, found %zu words", words.n);
	for (size_t k = 0; k < 2; k++)
		if (!ts_parse_real(words.word[k].text, &number[k]))
			return ts_fail(error, TS_SYNTAX, &words.word[k].place,
				       "expected a number, found '%s'", words.word[k].text);
	if (TS_GROW(feed->id, feed->id_capacity, feed->n + 1) != TS_OK ||
	    TS_GROW(feed->value, feed->value_capacity, feed->n + 1) != TS_OK)
		return ts_nomem(error);
	feed->id[feed->n] = number[0];
	feed->value[feed->n++] = number[1];
	return TS_OK;
}

static enum ts_status next_atomfile_set(struct ts_formulas *formulas, struct ts_variable *variable,
					bool *exhausted)
{
	struct ts_variable_feed *feed = variable->feed;
	struct ts_arena arena = { 0 };
	struct ts_words words;
	int64_t count = 0;
	enum ts_status status = read_words_of_next_line(formulas, feed, &arena, &words, exhausted);

	if (status == TS_OK && !*exhausted) {
		feed->n = 0;
		feed->position++;
		if (!ts_parse_int(words.word[0].text, &count) || count < 0)
			status = ts_fail(&formulas->sim->error, TS_SYNTAX, &words.word[0].place,
					 "expected the number of values that follow, found '%s'",
					 words.word[0].text);
	}
	for (int64_t k = 0; status == TS_OK && k < count; k++) {
		ts_arena_release(&arena);
		status = read_pair(formulas, feed, &arena, count - k);
	}
	ts_arena_release(&arena);
	return keep_line(formulas, feed, status);
}

static bool save_feed(const struct ts_variable *variable, double *number)
{
	*number = variable->feed ? (double)variable->feed->position : 0;
	return variable->in_run;
}

/* Reads on to the position saved in the restart file. Only files read during runs have one; others depend
 * on the script. */
static enum ts_status restore_feed(struct ts_formulas *formulas, struct ts_variable *variable, double number)
{
	struct ts_variable_feed *feed = variable->feed;
	bool exhausted = false;

	if ((double)feed->position > number) {
		rewind(feed->stream);
		feed->line.line = 0;
		feed->position = 0;
	}
	while ((double)feed->position < number && !exhausted)
		TS_TRY(variable->style->next(formulas, variable, &exhausted));
	if (exhausted)
		return ts_fail(&formulas->sim->error, TS_IO, &variable->where,
			       "variable '%s': the file '%s' has %lld values, but the run saved in the "
			       "restart file had read number %.0f",
			       variable->name, variable->values.word[0].text, (long long)feed->position,
			       number);
	variable->in_run = true;
	return TS_OK;
}

static enum ts_status open_feed(struct ts_formulas *formulas, struct ts_variable *variable)
{
	const struct ts_word *path = &variable->values.word[0];
	struct ts_error *error = &formulas->sim->error;
	bool empty = false, resumed;

	variable->feed = ts_alloc(1, sizeof *variable->feed);
	if (!variable->feed)
		return ts_nomem(error);
	variable->feed->line.file = ts_pool_get(formulas->sim->pool, path->text);
	if (!variable->feed->line.file)
		return ts_nomem(error);
	variable->feed->stream = ts_files_open(&formulas->sim->files, path->text, "r");
	if (!variable->feed->stream)
		return ts_fail(error, TS_IO, &path->place, "cannot open '%s': %s", path->text,
			       ts_files_why(&formulas->sim->files));
	TS_TRY(variable->style->next(formulas, variable, &empty));
	if (empty)
		return ts_fail(error, TS_IO, &path->place, "the file '%s' has no values", path->text);
	return ts_variable_resume(formulas, variable, &resumed);
}

static enum ts_status file_text(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out)
{
	(void)formulas, (void)where;
	ts_str_add(out, ts_str_text(&variable->feed->text));
	return TS_OK;
}

struct id_value {
	double id, value;
	size_t at; /* position in the file: of several values the last counts */
};

static int compare_id(const void *a, const void *b)
{
	const struct id_value *p = a, *q = b;

	if (p->id < q->id || p->id > q->id)
		return p->id < q->id ? -1 : 1;
	return p->at < q->at ? -1 : p->at > q->at;
}

/* The last value of that identity, or 0. */
static double find_value(const struct id_value *list, size_t n, double id)
{
	size_t lo = 0, hi = n;

	while (lo < hi) {
		size_t middle = lo + (hi - lo) / 2;

		if (list[middle].id <= id)
			lo = middle + 1;
		else
			hi = middle;
	}
	return lo && !(list[lo - 1].id < id) ? list[lo - 1].value : 0;
}

/* Particles that the set does not have get the value 0. */
static enum ts_status atomfile_peratom(struct ts_formulas *formulas, struct ts_variable *variable,
				       const struct ts_place *where, struct ts_table *out)
{
	const struct ts_variable_feed *feed = variable->feed;
	struct id_value *list;

	(void)where;
	TS_TRY(ts_quantity_eval(formulas->sim, "id", out));
	list = ts_alloc(feed->n + 1, sizeof *list);
	if (!list)
		return ts_nomem(&formulas->sim->error);
	for (size_t k = 0; k < feed->n; k++)
		list[k] = (struct id_value){ feed->id[k], feed->value[k], k };
	ts_sort(list, feed->n, sizeof *list, compare_id);
	for (size_t i = 0; i < out->rows; i++)
		out->data[i] = find_value(list, feed->n, out->data[i]);
	ts_free(list);
	return TS_OK;
}

const struct ts_variable_style ts_var_file = {
	.reads_all = true,
	.name = "file",
	.values = "PATH",
	.help = "the first word of a line of a file; `next` or next() advances to the next line",
	.least = 1,
	.most = 1,
	.keeps = true,
	.define = open_feed,
	.text = file_text,
	.next = next_file_value,
	.save = save_feed,
	.restore = restore_feed,
	.release = release_feed,
};

const struct ts_variable_style ts_var_atomfile = {
	.reads_all = true,
	.name = "atomfile",
	.values = "PATH",
	.help = "a value for each particle from a file of sets: a line with a number N and N lines `id "
		"value`; `next` or next() advances to the next set; 0 for particles that a set does not have",
	.least = 1,
	.most = 1,
	.keeps = true,
	.define = open_feed,
	.peratom = atomfile_peratom,
	.next = next_atomfile_set,
	.save = save_feed,
	.restore = restore_feed,
	.release = release_feed,
};
