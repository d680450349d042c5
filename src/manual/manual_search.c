/* Full-text search in the pages of the manual. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "manual/help.h"
#include "manual/manual.h"
#include "manual/topics.h"

#include "base/banned.h"

enum { SHOWN = 12, WIDTH = 76 };

struct hit {
	const struct ts_style *style; /* NULL: a topic */
	const struct ts_topic *topic;
	size_t count;
	char line[WIDTH + 1]; /* the first line that contains it */
};

static void make_lower_case(struct ts_str *text)
{
	for (size_t k = 0; k < text->length; k++)
		text->text[k] = (char)tolower((unsigned char)text->text[k]);
}

static size_t count_of(const char *text, const char *word)
{
	size_t n = 0, length = strlen(word);

	for (const char *at = text; (at = strstr(at, word)); at += length)
		n++;
	return n;
}

/* Number of occurrences of the whole phrase or, if there are none, of the rarest of its words. */
static size_t occurrences(const char *text, const char *words)
{
	size_t least = count_of(text, words);
	struct ts_str word = { 0 };

	if (least || !strchr(words, ' '))
		return least;
	least = SIZE_MAX;
	for (const char *at = words; *at && least; at += strspn(at, " ")) {
		size_t n = strcspn(at, " "), count;

		ts_str_clear(&word);
		ts_str_add_n(&word, at, n);
		count = count_of(text, ts_str_text(&word));
		least = count < least ? count : least;
		at += n;
	}
	ts_str_release(&word);
	return least;
}

/* Copies the line of the page with the first occurrence. */
static void copy_line(const char *page, const char *small, const char *words, char line[WIDTH + 1])
{
	size_t first = strcspn(words, " ");
	struct ts_str word = { 0 };
	const char *at = strstr(small, words);
	size_t begin, n;

	ts_str_add_n(&word, words, first);
	if (!at)
		at = strstr(small, ts_str_text(&word));
	ts_str_release(&word);
	begin = at ? (size_t)(at - small) : 0;
	while (begin && page[begin - 1] != '\n')
		begin--;
	begin += strspn(page + begin, " ");
	n = strcspn(page + begin, "\n");
	snprintf(line, WIDTH + 1, "%.*s", (int)(n < WIDTH ? n : WIDTH), page + begin);
}

/* Appends the page to the hits if it contains the words. */
static void search_page(const struct ts_tables *tables, struct hit hit, const char *words,
			struct ts_str *page, struct ts_str *small, struct hit *hits, size_t *n)
{
	ts_str_clear(page);
	ts_str_clear(small);
	if (hit.style)
		ts_help_page(hit.style, false, page);
	else
		hit.topic->page(tables, false, page);
	ts_str_add(small, ts_str_text(page));
	if (page->failed || small->failed || !small->length)
		return;
	make_lower_case(small);
	hit.count = occurrences(ts_str_text(small), words);
	if (!hit.count)
		return;
	copy_line(ts_str_text(page), ts_str_text(small), words, hit.line);
	hits[(*n)++] = hit;
}

static int compare_hits(const void *a, const void *b)
{
	const struct hit *p = a, *q = b;

	if (p->count != q->count)
		return p->count < q->count ? 1 : -1;
	if (!p->style || !q->style)
		return p->style ? 1 : q->style ? -1 : strcmp(p->topic->name, q->topic->name);
	return p->style->kind != q->style->kind ? (int)p->style->kind - (int)q->style->kind
						: strcmp(p->style->name, q->style->name);
}

static void add_hits(const struct hit *hits, size_t n, const char *words, struct ts_str *out)
{
	ts_str_addf(out, "'%s' is found on %zu page%s of the manual:\n\n", words, n, n == 1 ? "" : "s");
	for (size_t k = 0; k < n && k < SHOWN; k++)
		ts_str_addf(out, "  tsim -help %s%s%s\n      %s\n",
			    hits[k].style ? ts_kind_name(hits[k].style->kind) : "", hits[k].style ? " " : "",
			    hits[k].style ? hits[k].style->name : hits[k].topic->name, hits[k].line);
	if (n > SHOWN)
		ts_str_addf(out, "\nand %zu further pages with fewer occurrences\n", n - SHOWN);
}

bool ts_manual_search(const struct ts_tables *tables, const char *words, struct ts_str *out)
{
	struct ts_str page = { 0 }, small = { 0 }, wanted = { 0 };
	size_t n = 0, all = 0;
	struct hit *hits;

	for (const struct ts_topic *t = ts_topics; t->name; t++)
		all++;
	for (const struct ts_style *const *s = tables->styles; *s; s++)
		all++;
	hits = ts_alloc(all, sizeof *hits);
	ts_str_add(&wanted, words);
	if (!hits || wanted.failed) {
		ts_str_release(&wanted);
		ts_free(hits);
		return false;
	}
	make_lower_case(&wanted);
	for (const struct ts_topic *t = ts_topics; t->name; t++)
		search_page(tables, (struct hit){ .topic = t }, ts_str_text(&wanted), &page, &small, hits,
			    &n);
	for (const struct ts_style *const *s = tables->styles; *s; s++)
		search_page(tables, (struct hit){ .style = *s }, ts_str_text(&wanted), &page, &small, hits,
			    &n);
	ts_sort(hits, n, sizeof *hits, compare_hits);
	if (n)
		add_hits(hits, n, words, out);
	ts_str_release(&page);
	ts_str_release(&small);
	ts_str_release(&wanted);
	ts_free(hits);
	return n > 0;
}
