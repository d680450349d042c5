#include "manual/search_entries.h"

#include <ctype.h>
#include <string.h>

#include "base/banned.h"

/* Two kinds of lines: `| task, other words for it | answer |` and `**Term, another word for it** - meaning`. The answer
 * names pages: as `fix insert/pack`, by links as (bonds.md), or as examples/everyday/in.drum. */
static const double later_page = 0.85; /* weight of each further page in an answer, by the one before */

/* The pages with such lines, and their own weight for them. */
static const struct {
	const char *page;
	double weight;
} sources[] = { { "doc/how-to", 0.5 }, { "doc/glossary", 0.8 }, { "doc/cannot", 1 } };

struct entry {
	const char *key, *answer;
	size_t key_length, answer_length;
};

static bool read_line(const char *line, size_t n, const char *from, const char *to, struct entry *out)
{
	size_t begin = strlen(from), end = strlen(to);
	const char *closed;

	if (n <= begin || strncmp(line, from, begin) != 0)
		return false;
	closed = memmem(line + begin, n - begin, to, end);
	if (!closed)
		return false;
	*out = (struct entry){ line + begin, closed + end, (size_t)(closed - line) - begin,
			       n - (size_t)(closed - line) - end };
	return true;
}

/* Agreement of one phrase of the key: the part of the query that it has, squared, times the part of its words that are in
 * the query. */
static double phrase_value(const struct ts_query *query, const double *rarity, const char *phrase,
			   size_t length)
{
	bool seen[TS_QUERY_WORDS] = { false };
	double found = 0, total = 0, words = 0, common = 0;
	struct ts_str word = { 0 };

	for (size_t k = 0; k < length;) {
		size_t n = 0, which;
		bool stop;

		while (k + n < length && (isalnum((unsigned char)phrase[k + n]) || phrase[k + n] == '_'))
			n++;
		ts_str_clear(&word);
		ts_str_add_n(&word, phrase + k, n);
		k += n ? n : 1;
		if (!n)
			continue;
		which = ts_query_find(query, ts_str_text(&word), &stop);
		words += !stop;
		if (stop || which == query->n)
			continue;
		common++;
		found += seen[which] ? 0 : rarity[which];
		seen[which] = true;
	}
	ts_str_release(&word);
	for (size_t k = 0; k < query->n; k++)
		total += rarity[k];
	return words > 0 && total > 0 ? found * found / (total * total) * common / words : 0;
}

/* The best of the phrases, which commas divide. */
static double key_value(const struct ts_query *query, const double *rarity, const struct entry *e)
{
	double best = 0;

	for (size_t k = 0; k < e->key_length;) {
		const char *comma = memchr(e->key + k, ',', e->key_length - k);
		size_t n = comma ? (size_t)(comma - e->key) - k : e->key_length - k;
		double value = phrase_value(query, rarity, e->key + k, n);

		best = value > best ? value : best;
		k += n + 1;
	}
	return best;
}

static bool is_name_letter(char c)
{
	return isalnum((unsigned char)c) || c == '/' || c == '_' || c == '.';
}

/* Where the answer names the page, or NULL. */
static const char *find_name(const struct entry *e, const char *command)
{
	bool document = strncmp(command, "doc/", 4) == 0;
	const char *name = document ? command + 4 : command, *end = e->answer + e->answer_length;
	size_t n = strlen(name);

	for (const char *at = e->answer; (at = memmem(at, (size_t)(end - at), name, n)); at += n) {
		size_t rest = (size_t)(end - at) - n;
		bool begins = at == e->answer || !is_name_letter(at[-1]);
		bool ends = document ? rest > 3 && strncmp(at + n, ".md)", 4) == 0
				     : !rest || !is_name_letter(at[n]);

		if (begins && ends)
			return at;
	}
	return NULL;
}

/* Weight of the page in the answer by the number of commas before it; 0 if it is not named. */
static double place_in_answer(const struct entry *e, const char *command)
{
	const char *at = find_name(e, command);
	double weight = 1;

	for (const char *c = e->answer; at && c < at; c++)
		weight *= *c == ',' || *c == ';' ? later_page : 1;
	return at ? weight : 0;
}

/* The weight of a page that has such lines; 0 for others. */
static double source_weight(const char *command)
{
	for (size_t k = 0; k < sizeof sources / sizeof *sources; k++)
		if (ts_streq(sources[k].page, command))
			return sources[k].weight;
	return 0;
}

static double line_value(const struct ts_query *query, const double *rarity, const char *line, size_t n,
			 const char *command, double own)
{
	struct entry e;
	double place;

	if (!read_line(line, n, "**", "**", &e) && !read_line(line, n, "| ", " |", &e))
		return 0;
	place = own > 0 ? own : place_in_answer(&e, command);
	return place > 0 ? place * key_value(query, rarity, &e) : 0;
}

double ts_search_entry_value(const struct ts_search_text *text, const struct ts_query *query,
			     const double *rarity, size_t page)
{
	const char *command = ts_str_text(&text->page[page].command);
	double best = 0;

	for (size_t p = 0; p < text->pages; p++) {
		double weight = source_weight(ts_str_text(&text->page[p].command));
		const char *line = ts_str_text(&text->page[p].small);

		for (size_t n; weight > 0 && *line; line += n + (line[n] == '\n')) {
			double value;

			n = strcspn(line, "\n");
			value = line_value(query, rarity, line, n, command, p == page ? weight : 0);
			best = value > best ? value : best;
		}
	}
	return best;
}
