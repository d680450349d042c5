#include "tokens.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sandbox.h"

enum { MOST_WORDS = 1 << 14, MOST_TOKENS = 1 << 12, LONGEST_WORD = 64, LONGEST_INPUT = 1 << 14 };

/* What breaks programs that read numbers and names. */
static const char *const awkward[] = {
	"0",	      "-1",	     "1",	   "2",		 "3",
	"1e308",      "-1e308",	     "1e-308",	   "1e-20",	 "1e20",
	"nan",	      "inf",	     "-inf",	   "0.5",	 "1e9",
	"2147483647", "-2147483648", "2147483648", "4294967296", "9223372036854775807",
	"1e18",	      "0x10",	     "",	   "\"\"",	 "NULL",
	"INF",	      "EDGE",	     "all",	   "none",	 "no",
	"yes",	      "*",	     "1*",	   "*2",	 "v_out",
	"v_nothing",  "c_1",	     "f_1[1]",	   "c_1[*]",	 "$(1/0)",
	"${out}",     "$x",	     "\"",	   "'",		 "&",
	"#",	      "SELF",	     "input",	   "1 1 1",	 "-0.0",
	"1e-5",	      "100000",	     "units",	   "box",	 "id",
	"1.5",
};

static struct {
	char (*word)[LONGEST_WORD];
	size_t n;
	bool tried;
} words;

struct tokens {
	const char *at[MOST_TOKENS];
	size_t length[MOST_TOKENS], n;
};

static uint32_t draw(uint32_t *state, size_t n)
{
	*state ^= *state << 13;
	*state ^= *state >> 17;
	*state ^= *state << 5;
	return n ? *state % (uint32_t)n : 0;
}

/* The file that fuzz.sh makes from the manual: a word in quotes in each line. */
static void load_words(void)
{
	const char *path = getenv("FUZZ_WORDS");
	FILE *file = path ? sandbox_open(path, "r") : NULL;
	char line[LONGEST_WORD + 2];

	words.tried = true;
	if (!file)
		return;
	words.word = malloc(MOST_WORDS * sizeof *words.word);
	while (words.word && words.n < MOST_WORDS && fgets(line, sizeof line, file)) {
		size_t n = strcspn(line + 1, "\"\n");

		memcpy(words.word[words.n], line + 1, n);
		words.word[words.n++][n] = '\0';
	}
	fclose(file);
}

static const char *any_word(uint32_t *state)
{
	if (!words.tried)
		load_words();
	if (words.n && draw(state, 2))
		return words.word[draw(state, words.n)];
	return awkward[draw(state, sizeof awkward / sizeof *awkward)];
}

/* Pieces between the separators: lines, or words of a line. */
static void split(const char *text, size_t n, const char *separators, struct tokens *out)
{
	size_t k = 0;

	out->n = 0;
	while (k < n && out->n < MOST_TOKENS) {
		size_t from = k;

		while (k < n && !strchr(separators, text[k] ? text[k] : 1))
			k++;
		out->at[out->n] = text + from;
		out->length[out->n++] = k - from;
		k++;
	}
}

struct text {
	char bytes[LONGEST_INPUT];
	size_t n, most;
};

static void put(struct text *out, const char *bytes, size_t n, char end)
{
	if (out->n + n + 1 > out->most)
		return;
	memcpy(out->bytes + out->n, bytes, n);
	out->n += n;
	if (end)
		out->bytes[out->n++] = end;
}

/* One line with something changed in it. `donor` gives words. */
static void change_line(struct text *out, const char *line, size_t n, const struct tokens *donor,
			uint32_t *state)
{
	struct tokens *word = malloc(sizeof *word), *other = malloc(sizeof *other);
	size_t k, from = draw(state, donor->n);
	uint32_t what = draw(state, 6);

	if (!word || !other)
		abort();
	split(line, n, " \t", word);
	split(donor->at[from], donor->length[from], " \t", other);
	k = draw(state, word->n);
	for (size_t w = 0; w < word->n; w++) {
		const char *new = any_word(state);
		size_t o = draw(state, other->n), swap = draw(state, word->n);

		if (w != k || what == 1)
			put(out, word->at[w], word->length[w], ' ');
		if (w == k && what == 0)
			put(out, new, strlen(new), ' ');
		else if (w == k && what == 1)
			put(out, new, strlen(new), ' ');
		else if (w == k && what == 2 && other->n)
			put(out, other->at[o], other->length[o], ' ');
		else if (w == k && what == 3)
			put(out, word->at[swap], word->length[swap], ' ');
		else if (w == k && what == 4)
			break; /* and nothing after it */
	}		       /* what == 5: the word is left out */
	put(out, "", 0, '\n');
	free(word);
	free(other);
}

/* Lines taken out, doubled, moved, changed in a word. */
static void change(struct text *out, const struct tokens *line, uint32_t *state)
{
	size_t k = draw(state, line->n), to = draw(state, line->n);
	uint32_t what = draw(state, 8);

	for (size_t l = 0; l < line->n; l++) {
		if (l == to && (what == 1 || what == 2))
			put(out, line->at[k], line->length[k], '\n');
		if (l != k) {
			put(out, line->at[l], line->length[l], '\n');
			continue;
		}
		if (what > 2)
			change_line(out, line->at[l], line->length[l], line, state);
		else if (what == 1)
			put(out, line->at[l], line->length[l], '\n');
	}
}

static size_t give(const struct text *from, uint8_t *to)
{
	memcpy(to, from->bytes, from->n);
	return from->n;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t room, unsigned seed)
{
	uint32_t state = seed * 2654435761u + 1;
	struct tokens *line;
	struct text *text, *old;
	uint32_t rounds;

	if (!size || size > LONGEST_INPUT / 2 || draw(&state, 8) == 0)
		return LLVMFuzzerMutate(data, size, room);
	line = malloc(sizeof *line);
	text = malloc(sizeof *text);
	old = malloc(sizeof *old);
	if (!line || !text || !old)
		abort();
	old->n = size;
	memcpy(old->bytes, data, size);
	rounds = 1 + draw(&state, 3);
	while (rounds--) {
		split(old->bytes, old->n, "\n", line);
		text->n = 0;
		text->most = room < LONGEST_INPUT ? room : LONGEST_INPUT;
		change(text, line, &state);
		memcpy(old->bytes, text->bytes, text->n);
		old->n = text->n;
	}
	size = give(old, data);
	free(line);
	free(text);
	free(old);
	return size;
}

/* Lines of one with lines of the other among them. */
size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t n_one, const uint8_t *other, size_t n_other,
				 uint8_t *out, size_t room, unsigned seed)
{
	uint32_t state = seed * 2654435761u + 1;
	struct tokens *a = malloc(sizeof *a), *b = malloc(sizeof *b);
	struct text *text = malloc(sizeof *text);
	size_t size, from, count;

	if (!a || !b || !text)
		abort();
	split((const char *)one, n_one, "\n", a);
	split((const char *)other, n_other, "\n", b);
	text->n = 0;
	text->most = room < LONGEST_INPUT ? room : LONGEST_INPUT;
	from = draw(&state, b->n);
	count = 1 + draw(&state, 6);
	for (size_t k = 0, to = draw(&state, a->n); k < a->n; k++) {
		put(text, a->at[k], a->length[k], '\n');
		for (size_t l = from; k == to && l < from + count && l < b->n; l++)
			put(text, b->at[l], b->length[l], '\n');
	}
	size = give(text, out);
	free(a);
	free(b);
	free(text);
	return size;
}
