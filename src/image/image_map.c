/* Colour maps: `amap lo hi style delta N entries` or `amap lo hi NAME`, and the like for bonds, surfaces ... */
#include <math.h>

#include "image/image.h"

#include "base/banned.h"

enum { LO, HI, STYLE, DELTA, NUMBER, ENTRIES };

static enum ts_status fail(struct tsim *sim, const char *what, const struct ts_word *word,
			   const char *expected)
{
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "dump_modify: %s: found '%s', expected %s", what,
		       word->text, expected);
}

/* A number, or the word that stands for an end of the range. */
static bool read_end(const char *text, const char *word, double end, double *out)
{
	*out = end;
	return ts_streq(text, word) || ts_parse_real(text, out);
}

static enum ts_status read_style(struct tsim *sim, const char *what, const struct ts_word *word,
				 struct ts_colour_map *map)
{
	static const char letters[] = "cds";

	for (int k = 0; letters[k]; k++)
		if (word->text[0] == letters[k] && (word->text[1] == 'a' || word->text[1] == 'f') &&
		    !word->text[2]) {
			map->style = (enum ts_colour_map_style)k;
			map->fractional = word->text[1] == 'f';
			return TS_OK;
		}
	return fail(sim, what, word, "one of ca, cf, da, df, sa, sf, viridis, coolwarm, gray");
}

/* Words of an entry: value color; lo hi color; color. */
static size_t entry_words(enum ts_colour_map_style style)
{
	return style == TS_MAP_CONTINUOUS ? 2 : style == TS_MAP_DISCRETE ? 3 : 1;
}

static enum ts_status read_entry(struct ts_instance *self, struct tsim *sim, const char *what,
				 const struct ts_colour_map *map, const struct ts_word *word,
				 struct ts_colour_map_entry *e)
{
	const size_t n = entry_words(map->style);

	/* `min` and `max` may stand at either place of a continuous entry */
	if (map->style == TS_MAP_CONTINUOUS && !read_end(word[0].text, "min", -INFINITY, &e->from) &&
	    !read_end(word[0].text, "max", INFINITY, &e->from))
		return fail(sim, what, &word[0], "a number, min or max");
	if (map->style == TS_MAP_DISCRETE && !read_end(word[0].text, "min", -INFINITY, &e->from))
		return fail(sim, what, &word[0], "a number or min");
	if (map->style == TS_MAP_DISCRETE && !read_end(word[1].text, "max", INFINITY, &e->to))
		return fail(sim, what, &word[1], "a number or max");
	return ts_image_find_colour(sim, self->state, &word[n - 1], &e->colour);
}

/* The entries of a continuous map rise from min to max; the last of a discrete one is for all values. */
static enum ts_status check_entries(struct tsim *sim, const char *what, const struct ts_colour_map *map,
				    const struct ts_word *word)
{
	const struct ts_colour_map_entry *e = map->entry;
	const size_t last = map->n - 1;

	if (map->style == TS_MAP_CONTINUOUS &&
	    (map->n < 2 || e[0].from > -INFINITY || e[last].from < INFINITY))
		return fail(sim, what, word, "that the first entry begins with min and the last with max");
	for (size_t k = 1; map->style == TS_MAP_CONTINUOUS && k <= last; k++)
		if (!(e[k].from > e[k - 1].from))
			return fail(sim, what, &word[2 * k], "values that rise from entry to entry");
	if (map->style == TS_MAP_DISCRETE && (e[last].from > -INFINITY || e[last].to < INFINITY))
		return fail(sim, what, &word[3 * last],
			    "that the last entry is `min max COLOR`, for all other values");
	return TS_OK;
}

static enum ts_status read_range(struct tsim *sim, const char *what, const struct ts_word *word,
				 struct ts_colour_map *map)
{
	if (!read_end(word[LO].text, "min", NAN, &map->lo))
		return fail(sim, what, &word[LO], "a number or min");
	if (!read_end(word[HI].text, "max", NAN, &map->hi))
		return fail(sim, what, &word[HI], "a number or max");
	if (map->lo > map->hi)
		return fail(sim, what, &word[HI], "an upper end that is not below the lower one");
	return TS_OK;
}

static enum ts_status read_head(struct tsim *sim, const char *what, const struct ts_word *word,
				struct ts_colour_map *map, size_t *n)
{
	int64_t number;

	TS_TRY(read_style(sim, what, &word[STYLE], map));
	if (!ts_parse_real(word[DELTA].text, &map->bin) ||
	    (map->style == TS_MAP_SEQUENTIAL && !(map->bin > 0)))
		return fail(sim, what, &word[DELTA],
			    map->style == TS_MAP_SEQUENTIAL ? "the width of the bins > 0" : "a number");
	if (!ts_parse_int(word[NUMBER].text, &number) || number < 1 || number > 10000)
		return fail(sim, what, &word[NUMBER], "the number of entries");
	*n = (size_t)number;
	return TS_OK;
}

enum ts_status ts_image_read_map(struct ts_instance *self, struct tsim *sim, const char *what,
				 struct ts_words words, struct ts_colour_map *map, size_t *used)
{
	struct ts_colour_map new = { 0 };
	const struct ts_colour_map *named = ts_colour_map_named(words.word[STYLE].text);
	struct ts_colour_map_entry *entry;
	size_t width;

	TS_TRY(read_range(sim, what, words.word, &new));
	if (named) {
		const double lo = new.lo, hi = new.hi;

		*map = *named;
		map->lo = lo;
		map->hi = hi;
		*used = STYLE + 1;
		return TS_OK;
	}
	if (words.n < ENTRIES) {
		TS_TRY(read_style(sim, what, &words.word[STYLE], &new));
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[STYLE].place,
			       "dump_modify: %s takes 6 words or more: LO HI STYLE DELTA N ENTRIES, or LO HI "
			       "and the name of a map",
			       what);
	}
	TS_TRY(read_head(sim, what, words.word, &new, &new.n));
	width = entry_words(new.style);
	*used = ENTRIES + new.n *width;
	if (words.n < *used)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[NUMBER].place,
			       "dump_modify: %s: %zu entries of %zu words are announced, found %zu words",
			       what, new.n, width, words.n - ENTRIES);
	entry = ts_arena_alloc(&self->arena, new.n, sizeof *entry);
	if (!entry)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < new.n; k++)
		TS_TRY(read_entry(self, sim, what, &new, &words.word[ENTRIES + k * width], &entry[k]));
	new.entry = entry;
	TS_TRY(check_entries(sim, what, &new, &words.word[ENTRIES]));
	*map = new;
	return TS_OK;
}
