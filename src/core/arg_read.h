/* State of the parse of one line (arg_parse.c), and readers of each argument type (arg_read.c). */
#ifndef TS_CORE_ARG_READ_H
#define TS_CORE_ARG_READ_H

#include "core/arg.h"
#include "core/sim.h"

struct ts_parse {
	struct tsim *sim;
	const char *what;
	struct ts_words words;
	size_t next; /* first word not yet read */
	const struct ts_place *where;
	struct ts_arena *arena;
	char *base;
	bool *is_keyword;	   /* for each word: it has been read as a keyword */
	const struct ts_arg *rows; /* rows being read: those of the innermost mode */
};

/* The next word, which counts as read; NULL: there is none. */
const struct ts_word *ts_arg_next_word(struct ts_parse *p);
/* Fails with "... is 'word', expected ..."; word NULL: the argument is missing. */
enum ts_status ts_arg_refuse(struct ts_parse *p, const struct ts_arg *row, const struct ts_word *word,
			     const char *expected);
/* Read the next word or words as a value of the row's type. */
enum ts_status ts_arg_read_real(struct ts_parse *p, const struct ts_arg *row, double *out);
enum ts_status ts_arg_read_int(struct ts_parse *p, const struct ts_arg *row, int64_t *out);
enum ts_status ts_arg_read_bool(struct ts_parse *p, const struct ts_arg *row, bool *out);
enum ts_status ts_arg_read_word(struct ts_parse *p, const struct ts_arg *row, const char **out);
enum ts_status ts_arg_read_enum(struct ts_parse *p, const struct ts_arg *row, int *out);
enum ts_status ts_arg_read_coord(struct ts_parse *p, const struct ts_arg *row, double *out);
enum ts_status ts_arg_read_number(struct ts_parse *p, const struct ts_arg *row, struct ts_number *out);
enum ts_status ts_arg_read_types(struct ts_parse *p, const struct ts_arg *row, struct ts_types *out);
enum ts_status ts_arg_read_group(struct ts_parse *p, const struct ts_arg *row, int *out);
enum ts_status ts_arg_read_region(struct ts_parse *p, const struct ts_arg *row, struct ts_instance **out);
enum ts_status ts_arg_read_vec3(struct ts_parse *p, const struct ts_arg *row, double out[3]);

#endif
