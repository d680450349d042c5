/* Search for passages of the manual, of the pages in doc/ and of the examples. A passage is ranked by the words it has:
 * rare words count more, more occurrences more with diminishing effect, and less in a long passage (BM25: S. Robertson,
 * H. Zaragoza, Found. Trends Inf. Retr. 3 (2009) 333, eq. 3.15); words in the title of the page and in the heading count,
 * too, and words that stand together. Pages that the list of tasks or the glossary names for the words come first. Each page is
 * shown once, with its best passage. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "manual/manual.h"
#include "manual/search_entries.h"
#include "manual/search_query.h"
#include "manual/search_text.h"

#include "base/banned.h"

enum { SHOWN = 8, WIDTH = 76, LINES = 3 };
/* Parameters of BM25, and the weights of title, heading, whole phrase, neighbouring words, lines of examples, of further
 * passages of the page, and of tasks and terms. */
static const double saturation = 1.2, length_part = 0.75, in_title = 1.6, in_heading = 0.8,
		    phrase_factor = 1.3, near_factor = 0.5, example_factor = 0.5, page_factor = 0.3,
		    entry_factor = 12, title_phrase_factor = 1.5;

struct hit {
	double score;	      /* of its best passage */
	size_t page, passage; /* that one */
	size_t n;	      /* passages of the page that have the words */
};

struct search {
	struct ts_query query;
	struct ts_search_text text;
	double rarity[TS_QUERY_WORDS], total; /* of each word, their sum */
	double mean_length;		      /* of a passage */
	struct hit *hits;
	size_t n;
};

static const char *passage_text(const struct search *s, const struct ts_search_passage *p)
{
	return ts_str_text(&s->text.page[p->page].small) + p->begin;
}

static bool title_has(const struct search *s, size_t page, size_t k)
{
	const struct ts_str *title = &s->text.page[page].title;

	return ts_query_count(&s->query, k, ts_str_text(title), title->length) > 0;
}

/* Sum of the rarities of the words that the title has. */
static double title_rarity(const struct search *s, size_t page)
{
	double sum = 0;

	for (size_t k = 0; k < s->query.n; k++)
		sum += title_has(s, page, k) ? s->rarity[k] : 0;
	return sum;
}

/* Rarity of each word: log(1 + (N - n + 1/2) / (n + 1/2)), n of N passages having it; 0 if none has it. */
static void find_rarities(struct search *s)
{
	double all = (double)s->text.passages, length = 0;

	for (size_t p = 0; p < s->text.passages; p++)
		length += (double)s->text.passage[p].length;
	s->mean_length = length / fmax(all, 1);
	for (size_t k = 0; k < s->query.n; k++) {
		double n = 0;

		for (size_t p = 0; p < s->text.passages; p++) {
			const struct ts_search_passage *q = &s->text.passage[p];

			n += ts_query_count(&s->query, k, passage_text(s, q), q->length) > 0;
		}
		s->rarity[k] = n > 0 ? log(1 + (all - n + 0.5) / (n + 0.5)) : 0;
		s->total += s->rarity[k];
	}
}

static double score_of(const struct search *s, const struct ts_search_passage *p)
{
	const char *text = passage_text(s, p);
	double score = 0, found = 0,
	       norm = 1 - length_part + length_part * fmax((double)p->length / s->mean_length, 1);
	struct ts_str heading = { 0 };
	double title_part = title_rarity(s, p->page) / fmax(s->total, 1e-300);
	bool any = false;

	ts_query_small_letters(p->heading, &heading);
	for (size_t k = 0; k < s->query.n; k++) {
		double count = ts_query_count(&s->query, k, text, p->length);
		bool title = title_has(s, p->page, k);
		bool head = ts_query_count(&s->query, k, ts_str_text(&heading), heading.length) > 0;

		score += s->rarity[k] * (count * (1 + saturation) / (count + saturation * norm) +
					 in_title * title * title_part + in_heading * head);
		found += count > 0 || title || head ? s->rarity[k] : 0;
		any |= count > 0;
	}
	ts_str_release(&heading);
	if (!any || s->total <= 0)
		return 0;
	if (s->query.n > 1 && memmem(text, p->length, s->query.phrase.text, s->query.phrase.length))
		score *= phrase_factor;
	score *= 1 + near_factor * ts_query_near(&s->query, text, p->length);
	return score * (p->example ? example_factor : 1) * found * found / (s->total * s->total);
}

static int compare_hits(const void *a, const void *b)
{
	const struct hit *p = a, *q = b;

	if (p->score != q->score)
		return p->score < q->score ? 1 : -1;
	return p->page < q->page ? -1 : p->page > q->page;
}

/* The best passage of each page; its first one if only a task or a term names the page. */
static void find_hits(struct search *s)
{
	size_t n = 0;

	for (size_t p = 0; p < s->text.passages; p++) {
		const struct ts_search_passage *q = &s->text.passage[p];
		struct hit *hit = &s->hits[q->page];
		double score = score_of(s, q);

		if (!hit->n || score > hit->score) {
			hit->passage = p;
			hit->score = score;
		}
		hit->page = q->page;
		hit->n += score > 0 || !hit->n;
	}
	for (size_t k = 0; k < s->text.pages; k++) {
		const struct ts_str *title = &s->text.page[k].title;
		struct hit hit = s->hits[k];

		hit.score *= 1 + page_factor * log(fmax((double)hit.n, 1));
		hit.score +=
			entry_factor * s->total * ts_search_entry_value(&s->text, &s->query, s->rarity, k);
		if (s->query.n > 1 &&
		    memmem(ts_str_text(title), title->length, s->query.phrase.text, s->query.phrase.length))
			hit.score *= title_phrase_factor;
		if (hit.n && hit.score > 0)
			s->hits[n++] = hit;
	}
	s->n = n;
	ts_sort(s->hits, s->n, sizeof *s->hits, compare_hits);
}

/* Where the passage is best cut: at the line in which the first of the words stands. */
static size_t first_line(const struct search *s, const struct ts_search_passage *p)
{
	const char *text = passage_text(s, p);
	size_t best = 0;
	double most = 0;

	for (size_t k = 0; k < p->length;) {
		size_t n = strcspn(text + k, "\n") + 1;
		double value = 0;

		n = n > p->length - k ? p->length - k : n;
		for (size_t w = 0; w < s->query.n; w++)
			value += s->rarity[w] * (ts_query_count(&s->query, w, text + k, n) > 0);
		if (value > most) {
			most = value;
			best = k;
		}
		k += n;
	}
	return best;
}

/* Appends some lines of the passage, without their indentation. */
static void add_passage(const struct search *s, const struct ts_search_passage *p, struct ts_str *out)
{
	const char *text = ts_str_text(&s->text.page[p->page].text) + p->begin;
	size_t k = first_line(s, p);

	for (int line = 0; line < LINES && k < p->length; line++) {
		size_t n = strcspn(text + k, "\n"), blanks = strspn(text + k, " ");

		n = k + n > p->length ? p->length - k : n;
		if (blanks >= n)
			break;
		ts_str_add(out, "      ");
		ts_str_add_n(out, text + k + blanks, n - blanks > 2 * WIDTH ? 2 * WIDTH : n - blanks);
		ts_str_add(out, n - blanks > 2 * WIDTH ? " ...\n" : "\n");
		k += n + 1;
	}
}

static void add_hits(const struct search *s, const char *words, struct ts_str *out)
{
	ts_str_addf(out, "'%s' is found on %zu page%s of the manual:\n\n", words, s->n, s->n == 1 ? "" : "s");
	for (size_t k = 0; k < s->n && k < SHOWN; k++) {
		const struct ts_search_passage *p = &s->text.passage[s->hits[k].passage];

		ts_str_addf(out, "  tsim -help %s", ts_str_text(&s->text.page[p->page].command));
		if (s->text.page[p->page].shown)
			ts_str_addf(out, "    %s%s%s", s->text.page[p->page].shown, *p->heading ? ": " : "",
				    p->heading);
		ts_str_add(out, "\n");
		add_passage(s, p, out);
	}
	if (s->n > SHOWN)
		ts_str_addf(out, "\nand %zu further pages that fit less\n", s->n - SHOWN);
}

/* A message about a word that is not in the text, with one that is. Returns whether that differs by a letter only: the word
 * is misspelled. */
static bool add_suggestion(const struct search *s, const char *word, struct ts_str *out)
{
	struct ts_suggest suggest = ts_suggest_start(word);
	struct ts_str candidate = { 0 }, best = { 0 };

	for (size_t p = 0; p < s->text.pages; p++)
		for (const char *at = ts_str_text(&s->text.page[p].small); *at;) {
			size_t n = 0;

			while (isalpha((unsigned char)at[n]))
				n++;
			ts_str_clear(&candidate);
			ts_str_add_n(&candidate, at, n);
			at += n ? n : 1;
			if (n < 4)
				continue;
			ts_suggest_try(&suggest, ts_str_text(&candidate));
			if (suggest.best != candidate.text)
				continue;
			ts_str_clear(&best);
			ts_str_add(&best, candidate.text);
			suggest.best = ts_str_text(&best);
		}
	ts_str_addf(out, "no page of the manual has the word '%s'", word);
	if (suggest.best)
		ts_str_addf(out, "; did you mean '%s'?", suggest.best);
	ts_str_release(&candidate);
	ts_str_release(&best);
	return suggest.best && suggest.distance <= 1;
}

/* Messages about words that no page has; the others are searched for unless one is misspelled. */
static bool add_unknown(const struct search *s, struct ts_str *out)
{
	bool misspelled = false;

	for (size_t k = 0; k < s->query.n; k++) {
		if (s->rarity[k] > 0)
			continue;
		ts_str_add(out, out->length ? "\n" : "");
		misspelled |= add_suggestion(s, ts_str_text(&s->query.word[k]), out);
	}
	return misspelled;
}

size_t ts_manual_search(const struct ts_tables *tables, const char *words, struct ts_str *out)
{
	struct search s = { 0 };
	struct ts_str unknown = { 0 };

	ts_query_make(&s.query, words);
	ts_search_text_make(tables, &s.text);
	s.hits = ts_alloc(s.text.pages, sizeof *s.hits);
	if (!s.text.failed && s.hits) {
		find_rarities(&s);
		if (!add_unknown(&s, &unknown))
			find_hits(&s);
	}
	ts_str_add(out, ts_str_text(&unknown));
	if (s.n)
		ts_str_add(out, unknown.length ? "\n\n" : "");
	if (s.n)
		add_hits(&s, words, out);
	else if (!unknown.length)
		ts_str_addf(out, "'%s' has no words to search for", words);
	ts_str_release(&unknown);
	ts_free(s.hits);
	ts_search_text_release(&s.text);
	ts_query_release(&s.query);
	return s.n;
}
