#include "manual/search_query.h"

#include <ctype.h>
#include <string.h>

#include "base/banned.h"

enum { SHORT = 3 }; /* letters */
static const double synonym_weight = 0.6;

void ts_query_small_letters(const char *text, struct ts_str *out)
{
	size_t from = out->length;

	ts_str_add(out, text);
	for (size_t k = from; k < out->length; k++)
		out->text[k] = (char)tolower((unsigned char)out->text[k]);
}

/* Words that say nothing about the subject. */
static bool is_stop_word(const char *word)
{
	static const char *const words[] = { "a",   "an",   "and",  "are",   "as",  "at",  "by",
					     "do",  "does", "for",  "from",  "how", "i",   "in",
					     "is",  "it",   "of",   "on",    "or",  "the", "to",
					     "use", "what", "when", "which", "with" };

	for (size_t k = 0; k < sizeof words / sizeof *words; k++)
		if (ts_streq(words[k], word))
			return true;
	return false;
}

/* What the pages say instead of these words; both as stems. */
static const char *synonym_of(const char *stem)
{
	static const struct {
		const char *stem, *other;
	} pairs[] = {
		{ "silo", "hopper" },	  { "bin", "hopper" },	     { "powder", "grain" },
		{ "wet", "liquid" },	  { "moist", "liquid" },     { "sticky", "cohes" },
		{ "glue", "bond" },	  { "picture", "image" },    { "video", "movi" },
		{ "conveyor", "belt" },	  { "blast", "jet" },	     { "parallel", "thread" },
		{ "core", "thread" },	  { "explod", "unstabl" },   { "unstabl", "stabil" },
		{ "export", "dump" },	  { "continu", "restart" },  { "resum", "restart" },
		{ "crack", "break" },	  { "crush", "break" },	     { "fractur", "break" },
		{ "tablet", "compact" },  { "press", "compact" },    { "nonspheric", "clump" },
		{ "shape", "clump" },	  { "paraview", "vtk" },     { "csv", "comma" },
		{ "mill", "drum" },	  { "slope", "angl" },	     { "abras", "wear" },
		{ "erod", "eros" },	  { "conduct", "heat" },     { "thermal", "heat" },
		{ "geometri", "mesh" },	  { "cad", "mesh" },	     { "blow", "unstabl" },
		{ "spray", "stream" },	  { "feed", "insert" },	     { "fill", "insert" },
		{ "oil", "lubric" },	  { "crash", "interrupt" },  { "slow", "speed" },
		{ "fast", "speed" },	  { "sandblast", "eros" },   { "stick", "cohes" },
		{ "diverg", "unstabl" },  { "blend", "mix" },	     { "mixer", "mix" },
		{ "segreg", "mix" },	  { "cutter", "scratch" },   { "tribomet", "friction" },
		{ "asper", "rough" },	  { "topographi", "rough" }, { "dryer", "heat" },
		{ "oven", "heat" },	  { "tumbler", "drum" },     { "kiln", "drum" },
		{ "auger", "screw" },	  { "shovel", "mesh" },	     { "grit", "eros" },
		{ "fluidiz", "fluidis" }, { "pile", "heap" },	     { "color", "colour" },
		{ "spheric", "sphere" },  { "viscos", "viscous" },
	};

	for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++)
		if (ts_streq(pairs[k].stem, stem))
			return pairs[k].other;
	return NULL;
}

/* Appends the word without its ending, at least four letters of it. Names with / and _ are kept. */
static void add_stem(const char *word, struct ts_str *out)
{
	static const char *const endings[] = { "ations", "ation", "ings", "ing", "ions", "ion",
					       "ed",	 "es",	  "s",	  "e",	 "y" };
	size_t n = strlen(word);

	for (size_t k = 0; !strpbrk(word, "/_") && k < sizeof endings / sizeof *endings; k++) {
		size_t m = strlen(endings[k]);

		if (n >= 4 + m && ts_streq(word + n - m, endings[k])) {
			n -= m;
			break;
		}
	}
	ts_str_add_n(out, word, n);
}

static bool is_word_letter(char c)
{
	return isalnum((unsigned char)c) || c == '_' || c == '/';
}

void ts_query_make(struct ts_query *query, const char *words)
{
	*query = (struct ts_query){ 0 };
	ts_query_small_letters(words, &query->phrase);
	for (const char *at = ts_str_text(&query->phrase); *at && query->n < TS_QUERY_WORDS;) {
		struct ts_str *word = &query->word[query->n], *stem = &query->stem[query->n];
		size_t n = 0;

		while (is_word_letter(at[n]))
			n++;
		ts_str_clear(word);
		ts_str_add_n(word, at, n);
		at += n ? n : 1;
		if (!n || (n == 1 && query->n) || is_stop_word(ts_str_text(word)))
			continue;
		ts_str_clear(stem);
		add_stem(ts_str_text(word), stem);
		query->synonym[query->n++] = synonym_of(ts_str_text(stem));
	}
}

void ts_query_release(struct ts_query *query)
{
	ts_str_release(&query->phrase);
	for (size_t k = 0; k < TS_QUERY_WORDS; k++) {
		ts_str_release(&query->word[k]);
		ts_str_release(&query->stem[k]);
	}
	*query = (struct ts_query){ 0 };
}

/* Number of words that begin with the stem, and, by half, of those that have a long one within, as
 * coefficientRestitution. A short one is a word of its own or its plural: "bit" is not Bitter. */
static double beginnings(const char *stem, const char *text, size_t length)
{
	size_t n = strlen(stem);
	double count = 0, within = n > 6 ? 0.5 : 0; /* weight */

	for (const char *at = text; n && (at = memmem(at, length - (size_t)(at - text), stem, n)); at += n) {
		const char *end = at + n, *last = text + length;
		bool begins = at == text || !isalnum((unsigned char)at[-1]);

		if (n <= SHORT) {
			end += end < last && *end == 's';
			count += begins && (end == last || !isalnum((unsigned char)*end));
		} else {
			count += begins ? 1 : within;
		}
	}
	return count;
}

double ts_query_count(const struct ts_query *query, size_t k, const char *text, size_t length)
{
	double count = beginnings(ts_str_text(&query->stem[k]), text, length);

	if (query->synonym[k])
		count += synonym_weight * beginnings(query->synonym[k], text, length);
	return count;
}

double ts_query_near(const struct ts_query *query, const char *text, size_t length)
{
	enum { LETTERS = 30 };
	double pairs = 0;

	for (size_t k = 0; k + 1 < query->n; k++) {
		const char *stem = ts_str_text(&query->stem[k]);
		size_t n = strlen(stem);

		for (const char *at = text; (at = memmem(at, length - (size_t)(at - text), stem, n));
		     at += n) {
			size_t before = (size_t)(at - text) < LETTERS ? (size_t)(at - text) : LETTERS;
			size_t after = length - (size_t)(at - text);

			after = after < n + LETTERS ? after : n + LETTERS;
			if (beginnings(ts_str_text(&query->stem[k + 1]), at - before, before + after) > 0) {
				pairs++;
				break;
			}
		}
	}
	return query->n > 1 ? pairs / (double)(query->n - 1) : 0;
}

size_t ts_query_find(const struct ts_query *query, const char *word, bool *stop)
{
	size_t n = strlen(word);

	*stop = is_stop_word(word);
	for (size_t k = 0; k < query->n; k++)
		if (beginnings(ts_str_text(&query->stem[k]), word, n) > 0 ||
		    (query->synonym[k] && beginnings(query->synonym[k], word, n) > 0))
			return k;
	return query->n;
}
