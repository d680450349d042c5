/* Every rejection provoked: from the argument rows of every style correct lines are made, which
 * must be accepted, and from those all kinds of wrong ones, which must be refused with a message
 * and a place. Lines of styles that touch no file are also run as a script would. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "deck.h"

#include "core/sim.h"
#include "library/tsim_tables.h"

enum { MOST_ITEMS = 64 };

/* One word of a line, and the row it is a value of (NULL: the name of a keyword or a mode). */
struct item {
	char text[64];
	const struct ts_arg *row;
};

struct line {
	struct item item[MOST_ITEMS];
	size_t n;
	bool rest; /* ends with any number of words: nothing is unknown then */
	bool list; /* the same, but keywords may follow */
};

static void put(struct line *line, const struct ts_arg *row, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

static void put(struct line *line, const struct ts_arg *row, const char *format, ...)
{
	struct item *item = &line->item[line->n++];
	va_list args;

	ck_assert_uint_lt(line->n, MOST_ITEMS);
	item->row = row;
	va_start(args, format);
	vsnprintf(item->text, sizeof item->text, format, args);
	va_end(args);
}

static double inside(const struct ts_arg *row)
{
	if (row->range == TS_WITHIN)
		return row->lo + 0.5 * fmin(row->hi - row->lo, 10);
	return 0.5;
}

static void put_mode(struct line *line, const struct ts_arg *row, int mode);

/* A correct value. */
static void put_value(struct line *line, const struct ts_arg *row, int mode)
{
	switch (row->type) {
	case TS_ARG_REAL:
	case TS_ARG_NUMBER:
	case TS_ARG_COORD:
		put(line, row, "%g", inside(row));
		break;
	case TS_ARG_INT:
		put(line, row, "%g", row->range == TS_WITHIN ? ceil(row->lo) : 1);
		break;
	case TS_ARG_VEC3:
		for (int k = 0; k < 3; k++)
			put(line, row, "0.%d", k + 1);
		break;
	case TS_ARG_BOOL:
		put(line, row, "yes");
		break;
	case TS_ARG_ENUM:
		put(line, row, "%s", row->choices[0]);
		break;
	case TS_ARG_TYPES:
		put(line, row, "1*2");
		break;
	case TS_ARG_GROUP:
		put(line, row, "some");
		break;
	case TS_ARG_REGION:
		put(line, row, "part");
		break;
	case TS_ARG_REF:
		put(line, row, "c_k");
		break;
	case TS_ARG_MODE:
		put_mode(line, row, mode);
		break;
	case TS_ARG_REST:
		for (size_t k = 0; k < (row->least ? row->least : 1); k++)
			put(line, row, "c_k");
		line->rest |= !(row->flags & TS_TO_KEYWORD);
		line->list = true;
		break;
	case TS_ARG_WORD:
		put(line, row, "word");
		break;
	case TS_ARG_FLAG:
	case TS_ARG_END:
		break;
	}
}

static bool required(const struct ts_arg *row)
{
	return !(row->flags & TS_OPTIONAL) && !row->fallback && row->type != TS_ARG_FLAG;
}

static void put_keyword(struct line *line, const struct ts_arg *row, int mode)
{
	put(line, NULL, "%s", row->name);
	put_value(line, row, mode);
}

/* All positional rows and those keywords that must be there; rest rows last. */
static void put_rows(struct line *line, const struct ts_arg *rows, int mode)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++)
		if (row->flags & TS_POSITIONAL)
			put_value(line, row, mode);
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END && !line->rest; row++)
		if (!(row->flags & TS_POSITIONAL) && required(row))
			put_keyword(line, row, mode);
}

static void put_mode(struct line *line, const struct ts_arg *row, int mode)
{
	int n = 0;

	while (row->modes[n].name)
		n++;
	mode = mode < n ? mode : n - 1;
	put(line, row, "%s", row->modes[mode].name);
	put_rows(line, row->modes[mode].args, 0);
}

static int modes_of(const struct ts_arg *rows)
{
	int most = 1;

	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++)
		for (int n = 0; row->modes && row->modes[n].name; n++)
			most = n + 1 > most ? n + 1 : most;
	return most;
}

/* ---- giving a line to the parser */

struct trial {
	const struct ts_style *style;
	const struct ts_arg *rows; /* its arguments or its coefficients */
	struct tsim *sim;
	size_t refused;
};
enum { MOST_STATE = 1 << 16 };

static const char *text_of(const struct line *line)
{
	static char text[MOST_ITEMS * 66];
	size_t at = 0;

	text[0] = '\0';
	for (size_t k = 0; k < line->n; k++)
		at += (size_t)snprintf(text + at, sizeof text - at, " %s", line->item[k].text);
	return text;
}

static enum ts_status parse(struct trial *t, const struct line *line)
{
	struct ts_place where = { "script", text_of(line), 7, 1, 1 };
	struct ts_arena arena = { 0 };
	void *state = ts_alloc_aligned(1, MOST_STATE);
	struct ts_words words;
	enum ts_status status;

	ck_assert_ptr_nonnull(state);
	ck_assert_uint_lt(t->style->state_size, MOST_STATE);
	tsim_error_clear(t->sim);
	status = ts_words_split(&arena, where.text, &where, &words);
	if (status == TS_OK)
		status = ts_args_parse(t->sim, t->style->name, t->rows, words, &where, &arena, state);
	ts_arena_release(&arena);
	ts_free(state);
	return status;
}

/* As a script has it; NULL where running it could leave something behind. */
static const char *script_line(const struct trial *t, const struct line *line)
{
	static const char *const not_run[] = { "shell",	     "quit",  "log",	       "jump",
					       "include",    "clear", "write_restart", "write_dump",
					       "thermo_log", "next",  "label",	       NULL };
	static char text[5000];

	if (t->rows != t->style->args)
		return NULL;
	for (int k = 0; t->style->kind == TS_KIND_COMMAND && not_run[k]; k++)
		if (ts_streq(not_run[k], t->style->name))
			return NULL;
	switch ((int)t->style->kind) {
	case TS_KIND_COMMAND:
		snprintf(text, sizeof text, "%s%s", t->style->name, text_of(line));
		return text;
	case TS_KIND_FIX:
	case TS_KIND_COMPUTE:
		snprintf(text, sizeof text, "%s new all %s%s", ts_kind_name(t->style->kind), t->style->name,
			 text_of(line));
		return text;
	case TS_KIND_REGION:
		snprintf(text, sizeof text, "region new %s%s", t->style->name, text_of(line));
		return text;
	default:
		return NULL;
	}
}

static void accepted(struct trial *t, const struct line *line)
{
	ck_assert_msg(parse(t, line) == TS_OK, "%s %s: refused%s\n%s", ts_kind_name(t->style->kind),
		      t->style->name, text_of(line), tsim_error(t->sim));
}

enum { NOBODY = MOST_ITEMS };
static size_t blamed = NOBODY;

/* The mark must stand under the very word, and the message must show it. */
static void check_blame(const struct trial *t, const struct line *line)
{
	const struct ts_error *error = &t->sim->error;
	int column = 2;

	if (blamed == NOBODY)
		return;
	for (size_t k = 0; k < blamed; k++)
		column += (int)strlen(line->item[k].text) + 1;
	ck_assert_msg(error->place.column == column &&
			      error->place.length == (int)strlen(line->item[blamed].text),
		      "%s: column %d, expected %d:%s: %s", t->style->name, error->place.column, column,
		      text_of(line), error->message);
	ck_assert_msg(strstr(error->message, line->item[blamed].text) != NULL,
		      "the message does not show '%s': %s", line->item[blamed].text, error->message);
}

static void refused(struct trial *t, const struct line *line, const char *what)
{
	enum ts_status status = parse(t, line);
	const char *script;

	ck_assert_msg(status != TS_OK, "%s %s: %s is accepted:%s", ts_kind_name(t->style->kind),
		      t->style->name, what, text_of(line));
	ck_assert_msg(status == t->sim->error.status && t->sim->error.message[0], "%s: %s: no message:%s",
		      t->style->name, what, text_of(line));
	ck_assert_msg(t->sim->error.place.line == 7, "%s: %s: no place: %s", t->style->name, what,
		      t->sim->error.message);
	ck_assert_msg(strncmp(t->sim->error.message, t->style->name, strlen(t->style->name)) == 0 ||
			      t->sim->error.status == TS_UNKNOWN,
		      "the message does not say what it is about: %s", t->sim->error.message);
	check_blame(t, line);
	t->refused++;
	script = script_line(t, line);
	if (!script)
		return;
	tsim_error_clear(t->sim);
	ck_assert_msg(tsim_line(t->sim, script), "a script can say: %s", script);
	ck_assert_msg(t->sim->error.place.line == 1, "no place: %s", t->sim->error.message);
	tsim_error_clear(t->sim);
}

/* ---- wrong lines */

static void with_word(struct trial *t, const struct line *good, size_t k, const char *what,
		      const char *format, ...) __attribute__((format(printf, 5, 6)));

static void with_word(struct trial *t, const struct line *good, size_t k, const char *what,
		      const char *format, ...)
{
	struct line bad = *good;
	va_list args;

	va_start(args, format);
	vsnprintf(bad.item[k].text, sizeof bad.item[k].text, format, args);
	va_end(args);
	blamed = k;
	refused(t, &bad, what);
	blamed = NOBODY;
}

static void out_of_range(struct trial *t, const struct line *good, size_t k)
{
	const struct ts_arg *row = good->item[k].row;

	switch (row->range) {
	case TS_POSITIVE:
		with_word(t, good, k, "zero", "0");
		with_word(t, good, k, "a negative number", "-1");
		break;
	case TS_NOT_NEGATIVE:
		with_word(t, good, k, "a negative number", "-1");
		break;
	case TS_FRACTION:
		with_word(t, good, k, "less than 0", "-0.01");
		with_word(t, good, k, "more than 1", "1.01");
		break;
	case TS_WITHIN:
		with_word(t, good, k, "too little", "%.0f", floor(row->lo) - 1);
		with_word(t, good, k, "too much", "%.0f", ceil(row->hi) * 2 + 1);
		break;
	case TS_ANY:
		break;
	}
}

static void wrong_number(struct trial *t, const struct line *good, size_t k)
{
	static const char *const words[] = { "1.5x", "x",   "--1",  "1e",  "1e999", "-1e999", "nan",
					     "NaN",  "inf", "-inf", "1,5", "0x",    "1.5.5" };

	for (size_t w = 0; w < DECK_LENGTH(words); w++)
		with_word(t, good, k, "no number", "%s", words[w]);
}

/* Outputs are looked up when the style is made, not when its line is read. */
static void unknown_output(struct trial *t, const struct line *good, size_t k)
{
	static const char *const names[] = {
		"c_nothing", "f_nothing", "v_nothing", "nothing", "c_k[x]", "c_"
	};
	struct line bad = *good;

	for (size_t w = 0; w < DECK_LENGTH(names); w++) {
		const char *script;

		snprintf(bad.item[k].text, sizeof bad.item[k].text, "%s", names[w]);
		script = script_line(t, &bad);
		if (!script)
			return;
		tsim_error_clear(t->sim);
		ck_assert_msg(tsim_line(t->sim, script), "a script can say: %s", script);
		ck_assert_msg(t->sim->error.place.line == 1, "no place: %s", t->sim->error.message);
		t->refused++;
	}
	tsim_error_clear(t->sim);
}

static void wrong_value(struct trial *t, const struct line *good, size_t k)
{
	switch (good->item[k].row->type) {
	case TS_ARG_INT:
		with_word(t, good, k, "no whole number", good->item[k].row->flags & TS_CUT ? "1e1" : "1.5");
		with_word(t, good, k, "too large a number", "99999999999999999999");
		with_word(t, good, k, "too small a number", "-9223372036854775809");
		/* fallthrough */
	case TS_ARG_REAL:
	case TS_ARG_NUMBER:
	case TS_ARG_COORD:
		out_of_range(t, good, k);
		/* fallthrough */
	case TS_ARG_VEC3:
		wrong_number(t, good, k);
		break;
	case TS_ARG_BOOL:
		with_word(t, good, k, "neither yes nor no", "perhaps");
		break;
	case TS_ARG_ENUM:
	case TS_ARG_MODE:
		with_word(t, good, k, "none of the choices", "%s_", good->item[k].text);
		break;
	case TS_ARG_TYPES:
		for (int w = 0; w < 4; w++)
			with_word(t, good, k, "no types", "%s",
				  (const char *[]){ "0", "1:2", "2*1", "x" }[w]);
		break;
	case TS_ARG_GROUP:
		with_word(t, good, k, "no group", "som");
		break;
	case TS_ARG_REF:
		unknown_output(t, good, k);
		break;
	case TS_ARG_REGION:
		with_word(t, good, k, "no region", "parts");
		break;
	default:
		break;
	}
}

/* Cut off after each word before the last that must be there. */
static void too_short(struct trial *t, const struct line *good)
{
	for (size_t n = 0; n < good->n; n++) {
		struct line bad = *good;
		bool needed = false;

		for (size_t k = n; k < good->n && !needed; k++) {
			const struct ts_arg *row = good->item[k].row;

			needed = !row || required(row);
			if (row && row->type == TS_ARG_MODE && !needed)
				break; /* what follows belongs to it */
		}
		bad.n = n;
		if (needed && !good->rest)
			refused(t, &bad, "a line that is too short");
	}
}

static void all_wrong(struct trial *t, const struct line *good)
{
	struct line bad = *good;

	for (size_t k = 0; k < good->n; k++)
		if (good->item[k].row)
			wrong_value(t, good, k);
	if (good->list)
		return;
	put(&bad, NULL, "nonsense_");
	refused(t, &bad, "an unknown word");
}

/* Each keyword by itself after the rest of the line; then without value, and twice. */
static void each_keyword(struct trial *t, const struct ts_arg *rows, const struct line *base)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		struct line good = *base, bad;
		bool there = !(row->flags & TS_POSITIONAL) && required(row);

		if ((row->flags & TS_POSITIONAL) || base->rest)
			continue;
		if (!there)
			put_keyword(&good, row, 0);
		accepted(t, &good);
		if (row->type == TS_ARG_REST)
			continue;
		for (size_t k = base->n; k < good.n; k++)
			if (good.item[k].row)
				wrong_value(t, &good, k);
		bad = good;
		if (row->type != TS_ARG_FLAG && !there) {
			bad.n = base->n + 1;
			refused(t, &bad, "a keyword without value");
			bad = good;
		}
		put_keyword(&bad, row, 0);
		refused(t, &bad, "a keyword given twice");
	}
}

static const char scene[] = "units si\n"
			    "boundary f f f\n"
			    "lattice sc 0.5\n"
			    "region part block 0 1 0 1 0 1 units box\n"
			    "create_box 3 part\n"
			    "create_atoms 1 single 0.5 0.5 0.5 units box\n"
			    "create_atoms 2 single 0.7 0.5 0.5 units box\n"
			    "set group all diameter 0.1 density 1000\n"
			    "group some type 1\n"
			    "pair_style spring/dashpot\n"
			    "pair_coeff * * stiffness 100 restitution 0.5\n"
			    "compute k all ke\n";

/* Tests run in processes of their own: the sum is kept in a file. */
static void count(size_t refused)
{
	const char *path = getenv("TS_REJECTIONS");
	FILE *file = path ? fopen(path, "a") : NULL;

	if (!file)
		return;
	fprintf(file, "%zu\n", refused);
	fclose(file);
}

static void try_rows(struct trial *t)
{
	for (int mode = 0; mode < modes_of(t->rows); mode++) {
		struct line good = { 0 };

		put_rows(&good, t->rows, mode);
		accepted(t, &good);
		too_short(t, &good);
		all_wrong(t, &good);
		each_keyword(t, t->rows, &good);
		for (const struct ts_arg *row = t->rows; row && row->type != TS_ARG_END; row++)
			if (row->type == TS_ARG_MODE && (row->flags & TS_POSITIONAL)) {
				int n = 0;

				while (row->modes[n].name)
					n++;
				if (mode < n)
					each_keyword(t, row->modes[mode].args, &good);
			}
	}
}

START_TEST(rejections)
{
	const struct ts_style *style = ts_style_table[_i];
	struct trial t = { .style = style, .rows = style->args, .sim = deck_open("%s", scene) };

	try_rows(&t);
	t.rows = style->coeff;
	if (t.rows)
		try_rows(&t);
	/* the simulation is still in order */
	tsim_error_clear(t.sim);
	ck_assert_msg(tsim_count(t.sim) == 2, "%s has changed the particles", t.style->name);
	count(t.refused);
	tsim_close(t.sim);
}
END_TEST

/* Coefficients of pairs and bonds have rows too. */
START_TEST(coefficients)
{
	struct tsim *sim = deck_open("%sbond_style contact", scene);
	static const char *const wrong[] = {
		"pair_coeff * * stiffness 100",
		"pair_coeff * * stiffness 100 damping 1 restitution 0.5",
		"pair_coeff * * stiffness 100 restitution 0",
		"pair_coeff * * stiffness 0 damping 1",
		"pair_coeff * * stiffness 1 stiffness 1 damping 1",
		"pair_coeff * * stifness 1 damping 1",
		"pair_coeff 4 1 stiffness 1 damping 1",
		"pair_coeff 1 stiffness 1 damping 1",
		"pair_coeff * * file nowhere",
		"bond_coeff 1 stiffness 1",
		"bond_coeff 1 stiffness -1 ultimate 1",
		"bond_coeff 1 stiffness 1 ultimate x",
		"bond_coeff 0 stiffness 1 ultimate 1",
		"create_bonds single/bond 1 1 1",
		"create_bonds single/bond 1 1 9",
		"create_bonds many all all 1 2 1",
	};

	for (size_t k = 0; k < DECK_LENGTH(wrong); k++) {
		ck_assert_msg(!deck_accepts(sim, "%s", wrong[k]), "accepted: %s", wrong[k]);
		ck_assert_msg(sim->error.place.line == 1, "no place: %s", wrong[k]);
		tsim_error_clear(sim);
	}
	tsim_close(sim);
}
END_TEST

static size_t counted(const char *path)
{
	FILE *file = fopen(path, "r");
	size_t sum = 0, n;

	while (file && fscanf(file, "%zu", &n) == 1)
		sum += n;
	if (file)
		fclose(file);
	return sum;
}

int main(void)
{
	Suite *suite = suite_create("arguments");
	TCase *each = tcase_create("each style");
	int n = 0, status;

	while (ts_style_table[n])
		n++;
	tcase_set_timeout(each, 60);
	tcase_add_loop_test(each, rejections, 0, n);
	tcase_add_test(each, coefficients);
	suite_add_tcase(suite, each);
	remove("rejections.count");
	setenv("TS_REJECTIONS", "rejections.count", 1);
	status = deck_main(suite);
	printf("%zu rejections of arguments of %d styles and commands\n", counted("rejections.count"), n);
	remove("rejections.count");
	return status;
}
