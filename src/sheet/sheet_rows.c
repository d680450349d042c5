/* Rows of numbers, names of whose columns stand in the comment or the line above; and blocks of them, which begin with a
 * line of the step and the number of rows:
 *   # TimeStep Number-of-bins Total-counts ...
 *   # Bin Coord Count Count/Total
 *   500 50 1000 ...
 *   1 0.01 12 0.012 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "sheet/internal.h"

#include "base/banned.h"

struct rows {
	struct ts_sheet_reader *reader;
	struct ts_sheet_names outer, inner; /* the last two comments */
	bool begun;
};

/* Words of a comment; those in parentheses belong to the word before: "speed (m/s)". */
static enum ts_status read_names(struct rows *w, const char *text, struct ts_sheet_names *names)
{
	static const char blanks[] = " \t\r,";

	names->n = 0;
	text += strspn(text, blanks);
	while (*text) {
		size_t n = strcspn(text, blanks), more = n + strspn(text + n, blanks);

		if (text[more] == '(' && strchr(text + more, ')'))
			n = (size_t)(strchr(text + more, ')') - text) + 1;
		TS_TRY(ts_sheet_add_name(w->reader, names, text, n));
		text += n + strspn(text + n, blanks);
	}
	return TS_OK;
}

static enum ts_status read_comment(struct rows *w)
{
	const struct ts_sheet_names swap = w->outer;

	w->outer = w->inner;
	w->inner = swap;
	return read_names(w, w->reader->lines.comment, &w->inner);
}

static bool are_blocks(const struct rows *w)
{
	return w->outer.n > 1 && strncmp(w->outer.name[1], "Number-of-", 10) == 0 &&
	       w->reader->lines.nwords == w->outer.n;
}

/* A last line without a line feed that has too few words: the program has been ended while it wrote it. */
static bool is_torn(struct rows *w, size_t expected)
{
	const struct ts_lines *l = &w->reader->lines;

	if (l->ended || l->nwords >= expected)
		return false;
	w->reader->sheets->torn = l->number;
	return true;
}

static enum ts_status add_row(struct rows *w, bool *torn)
{
	struct ts_sheet_reader *r = w->reader;
	const struct ts_sheet *t = &r->sheets->sheet[r->sheets->n - 1];
	struct ts_lines *l = &r->lines;

	*torn = is_torn(w, t->columns);
	if (*torn)
		return TS_OK;
	if (l->nwords != t->columns)
		return ts_lines_fail(l, TS_SYNTAX, SIZE_MAX,
				     "the row has %zu words, expected %zu as the table", l->nwords,
				     t->columns);
	return ts_sheet_add_row(r, (const char *const *)l->word, l->number);
}

/* The line with the step and the number of rows is the current one. */
static enum ts_status read_block(struct rows *w)
{
	struct ts_sheet_reader *r = w->reader;
	struct ts_lines *l = &r->lines;
	struct ts_str title = { 0 };
	int64_t n;
	enum ts_status status;
	bool more = true, torn = is_torn(w, w->outer.n);

	if (torn)
		return TS_OK;
	if (l->nwords != w->outer.n)
		return ts_lines_fail(l, TS_SYNTAX, SIZE_MAX,
				     "expected the %zu numbers that begin a block, found %zu words",
				     w->outer.n, l->nwords);
	TS_TRY(ts_lines_int(l, 1, "the number of rows", 0, INT32_MAX, &n));
	ts_str_addf(&title, "step %s", l->word[0]);
	status = title.failed ? ts_nomem(r->err) : ts_sheet_begin(r, &w->inner, w->inner.n, title.text);
	ts_str_release(&title);
	for (int64_t k = 0; k < n && status == TS_OK && !torn; k++) {
		status = ts_lines_next_filled(l, &more);
		if (status == TS_OK && !more) /* ended while the block was written */
			r->sheets->torn = l->number;
		if (status != TS_OK || !more)
			break;
		status = add_row(w, &torn);
	}
	if (status == TS_OK && r->sheets->torn)
		ts_sheet_release(&r->sheets->sheet[--r->sheets->n]);
	return status;
}

/* Names of the columns: a line of words, or a comment with as many names as the row has numbers. */
static enum ts_status begin(struct rows *w)
{
	struct ts_sheet_reader *r = w->reader;
	struct ts_lines *l = &r->lines;

	w->begun = true;
	if (are_blocks(w)) {
		r->sheets->kind = TS_SHEET_BLOCKS;
		return TS_OK;
	}
	if (!ts_sheet_is_row(l)) {
		w->inner.n = 0;
		for (size_t k = 0; k < l->nwords; k++)
			TS_TRY(ts_sheet_add_name(r, &w->inner, l->word[k], strlen(l->word[k])));
		return ts_sheet_begin(r, &w->inner, l->nwords, "");
	}
	return ts_sheet_begin(r, w->inner.n == l->nwords ? &w->inner : NULL, l->nwords, "");
}

static enum ts_status read_all(struct rows *w)
{
	struct ts_lines *l = &w->reader->lines;
	bool more, torn = false;

	for (;;) {
		TS_TRY(ts_lines_next(l, &more));
		if (!more || torn)
			return TS_OK;
		if (!l->nwords) {
			if (*l->comment && !w->begun)
				TS_TRY(read_comment(w));
			continue;
		}
		if (!w->begun) {
			const bool names = !ts_sheet_is_row(l);

			TS_TRY(begin(w));
			if (names)
				continue;
		}
		if (w->reader->sheets->kind == TS_SHEET_BLOCKS)
			TS_TRY(read_block(w));
		else
			TS_TRY(add_row(w, &torn));
	}
}

enum ts_status ts_sheet_read_rows(struct ts_sheet_reader *r)
{
	struct rows w = { .reader = r };
	enum ts_status status = read_all(&w);

	ts_free(w.outer.name);
	ts_free(w.inner.name);
	return status;
}
