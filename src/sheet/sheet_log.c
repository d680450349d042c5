/* Logs of tsim, LIGGGHTS and LAMMPS. The table of a run begins with a line of titles, the next line has as many numbers; it
 * ends with "Loop time". Lines in between that are no rows are messages of the script. The programs write numbers in columns
 * of fixed widths, the step in eight letters, which tells rows from messages of numbers. With `line multi` a row is a block:
 *   ---------------- Step       60 ----- CPU =      0.0000 (sec) ----------------
 *   Temp     =         0.4828 TotEng   =        -5.2536
 * and with `thermo_style yaml` of LAMMPS the titles and the rows are lists:
 *   keywords: ['Step', 'Temp', ]
 *     - [0, 1.0, ] */
#include <stdio.h>
#include <string.h>

#include "sheet/internal.h"

#include "base/banned.h"

struct log {
	struct ts_sheet_reader *reader;
	struct ts_sheet_names titles; /* of the line before, or of the blocks */
	struct ts_sheet_names values; /* of a block that is being read */
	bool inside, multi, block;    /* in a table; it has blocks; one of them has begun */
	/* its first row: begins without a blank; where its first number ends; its second number has a column of some width */
	bool bare, wide;
	size_t first_end;
	int runs;
};

static enum ts_status begin_table(struct log *g, size_t n)
{
	char title[32];

	snprintf(title, sizeof title, "run %d", ++g->runs);
	g->inside = true;
	return ts_sheet_begin(g->reader, &g->titles, n, title);
}

/* A line of words that are no numbers. */
static enum ts_status keep_titles(struct log *g)
{
	const struct ts_lines *l = &g->reader->lines;
	double value;

	g->titles.n = 0;
	for (size_t k = 0; k < l->nwords; k++)
		if (ts_sheet_number(l->word[k], &value) || strchr("=:", *l->word[k]))
			return TS_OK;
	for (size_t k = 0; k < l->nwords; k++)
		TS_TRY(ts_sheet_add_name(g->reader, &g->titles, l->word[k], strlen(l->word[k])));
	return TS_OK;
}

enum { STEP_LETTERS = 8 };

static bool is_padded(const struct ts_lines *l)
{
	return l->word[0] > l->line || strlen(l->word[0]) >= STEP_LETTERS;
}

/* Number of letters of the line up to the end of word k. */
static size_t end_of(const struct ts_lines *l, size_t k)
{
	return (size_t)(l->word[k] - l->line) + strlen(l->word[k]);
}

static bool is_wide(const struct ts_lines *l)
{
	return l->nwords > 1 && end_of(l, 1) - end_of(l, 0) >= STEP_LETTERS;
}

static void remember_columns(struct log *g)
{
	const struct ts_lines *l = &g->reader->lines;

	g->bare = !is_padded(l);
	g->wide = is_wide(l);
	g->first_end = end_of(l, 0);
}

/* Whether the numbers stand in the columns of the first row; one that is longer than its column begins the line. */
static bool is_in_columns(const struct log *g)
{
	const struct ts_lines *l = &g->reader->lines;
	const size_t end = end_of(l, 0);

	if (g->bare)
		return true;
	return (end == g->first_end || (end > g->first_end && l->word[0] == l->line)) &&
	       (!g->wide || is_wide(l));
}

static bool begins_with_step(const struct ts_sheet_names *titles)
{
	return titles->n > 1 && ts_streq(titles->name[0], "Step");
}

/* Whether a table begins with this row, which stands below as many titles. A row that does not begin with a blank (a format
 * of thermo_modify without a width) may be a message, as may be one within a table that has not ended; then the titles
 * must be those of a thermo table. */
static bool begins_table(const struct log *g)
{
	const struct ts_lines *l = &g->reader->lines;

	if (g->titles.n != l->nwords)
		return false;
	return (!g->inside && is_padded(l)) || begins_with_step(&g->titles);
}

/* ---- blocks */

static enum ts_status end_block(struct log *g)
{
	struct ts_sheets *t = g->reader->sheets;

	if (!g->block)
		return TS_OK;
	g->block = false;
	if (!g->inside)
		TS_TRY(begin_table(g, g->titles.n));
	if (g->values.n != t->sheet[t->n - 1].columns)
		return ts_lines_fail(&g->reader->lines, TS_SYNTAX, SIZE_MAX,
				     "the block above has %zu numbers, expected %zu as the first one of the "
				     "run",
				     g->values.n, t->sheet[t->n - 1].columns);
	return ts_sheet_add_row(g->reader, g->values.name, g->reader->lines.number);
}

static enum ts_status add_pair(struct log *g, const char *name, const char *value)
{
	if (!g->inside)
		TS_TRY(ts_sheet_add_name(g->reader, &g->titles, name, strlen(name)));
	return ts_sheet_add_name(g->reader, &g->values, value, strlen(value));
}

/* "---- Step 60 ---- CPU = 0.1 (sec) ----" begins a block. */
static enum ts_status begin_block(struct log *g)
{
	const struct ts_lines *l = &g->reader->lines;

	TS_TRY(end_block(g));
	g->block = g->multi = true;
	g->values.n = 0;
	if (!g->inside)
		g->titles.n = 0;
	TS_TRY(add_pair(g, "Step", l->word[2]));
	return add_pair(g, "CPU", l->word[6]);
}

static bool begins_block(const struct ts_lines *l)
{
	return l->nwords >= 7 && strncmp(l->word[0], "----", 4) == 0 && ts_streq(l->word[1], "Step") &&
	       ts_streq(l->word[4], "CPU");
}

/* NAME = VALUE NAME = VALUE ... */
static bool is_pairs(const struct ts_lines *l)
{
	double value;

	if (!l->nwords || l->nwords % 3)
		return false;
	for (size_t k = 0; k < l->nwords; k += 3)
		if (!ts_streq(l->word[k + 1], "=") || !ts_sheet_number(l->word[k + 2], &value))
			return false;
	return true;
}

static enum ts_status add_pairs(struct log *g)
{
	const struct ts_lines *l = &g->reader->lines;

	for (size_t k = 0; k < l->nwords; k += 3)
		if (!ts_streq(l->word[k], "Step")) /* is in the first line */
			TS_TRY(add_pair(g, l->word[k], l->word[k + 2]));
	return TS_OK;
}

/* ---- lists */

/* Words from index `from` on without brackets, quotes and commas. */
static enum ts_status read_list(struct log *g, size_t from, struct ts_sheet_names *list)
{
	static const char around[] = "[]',\"";
	const struct ts_lines *l = &g->reader->lines;

	list->n = 0;
	for (size_t k = from; k < l->nwords; k++) {
		const char *word = l->word[k] + strspn(l->word[k], around);

		if (*word)
			TS_TRY(ts_sheet_add_name(g->reader, list, word, strcspn(word, around)));
	}
	return TS_OK;
}

static bool is_list(const struct ts_lines *l, const char *first)
{
	return l->nwords > 1 && ts_streq(l->word[0], first) && *l->word[1] == '[';
}

static enum ts_status add_list(struct log *g)
{
	struct ts_sheets *t = g->reader->sheets;

	TS_TRY(read_list(g, 1, &g->values));
	if (g->values.n != t->sheet[t->n - 1].columns)
		return ts_lines_fail(&g->reader->lines, TS_SYNTAX, SIZE_MAX,
				     "the row has %zu numbers, expected %zu as the keywords", g->values.n,
				     t->sheet[t->n - 1].columns);
	return ts_sheet_add_row(g->reader, g->values.name, g->reader->lines.number);
}

/* ---- the whole */

static enum ts_status read_line(struct log *g)
{
	struct ts_sheet_reader *r = g->reader;
	const struct ts_lines *l = &r->lines;
	const struct ts_sheets *t = r->sheets;

	if (l->nwords > 2 && ts_streq(l->word[0], "Loop") && ts_streq(l->word[1], "time")) {
		TS_TRY(end_block(g));
		g->inside = g->multi = false;
		g->titles.n = 0;
		return TS_OK;
	}
	if (begins_block(l))
		return begin_block(g);
	if (is_list(l, "keywords:")) {
		TS_TRY(read_list(g, 1, &g->titles));
		g->multi = true;
		return begin_table(g, g->titles.n);
	}
	if (g->inside && is_list(l, "-"))
		return add_list(g);
	if (g->block && is_pairs(l))
		return add_pairs(g);
	if (g->multi)
		return TS_OK;
	if (ts_sheet_is_row(l)) {
		if (begins_table(g)) {
			TS_TRY(begin_table(g, l->nwords));
			remember_columns(g);
		}
		g->titles.n = 0;
		if (g->inside && l->nwords == t->sheet[t->n - 1].columns && is_in_columns(g))
			return ts_sheet_add_row(r, (const char *const *)l->word, l->number);
		return TS_OK;
	}
	return keep_titles(g);
}

static enum ts_status read_all(struct log *g)
{
	struct ts_lines *l = &g->reader->lines;
	bool more;

	for (;;) {
		TS_TRY(ts_lines_next(l, &more));
		if (!more)
			break;
		if (l->nwords || !*l->comment)
			TS_TRY(read_line(g));
	}
	return end_block(g);
}

enum ts_status ts_sheet_read_log(struct ts_sheet_reader *r)
{
	struct log g = { .reader = r };
	enum ts_status status = read_all(&g);

	ts_free(g.titles.name);
	ts_free(g.values.name);
	return status;
}
