/* Argument tables: one row per argument of a style or command.
 *
 * The same rows serve parsing, range checks, suggestions, `tsim -help`, the manual pages, the record of
 * resolved values in the log, and the archive of coefficients in restart files.
 *
 * Grammar: positional rows (TS_POSITIONAL) come first, in order; then keywords in any order, each at most
 * once. A TS_MODE row is a positional word that selects further rows (`create_atoms 1 random ...` against
 * `create_atoms 1 single ...`). A TS_REST row takes all remaining words. */
#ifndef TS_CORE_ARG_H
#define TS_CORE_ARG_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/alloc.h"
#include "base/str.h"
#include "base/words.h"

struct tsim;
struct ts_instance;

enum ts_arg_type {
	TS_ARG_END, /* closes a table */
	TS_ARG_REAL,
	TS_ARG_INT,
	TS_ARG_BOOL,  /* yes|no, on|off                                      -> bool        */
	TS_ARG_FLAG,  /* a keyword without value                             -> bool        */
	TS_ARG_WORD,  /* any word; copied                                    -> const char* */
	TS_ARG_ENUM,  /* one of the choices                                  -> int (index) */
	TS_ARG_VEC3,  /* three reals                                         -> double[3]   */
	TS_ARG_COORD, /* a real, INF (infinity) or EDGE (TS_EDGE); negative in rows named "...lo" -> double */
	TS_ARG_NUMBER, /* a real, v_name, or NULL where TS_NULLABLE           -> struct ts_number */
	TS_ARG_TYPES,  /* particle types: n, *, n*, *m, n*m                   -> struct ts_types  */
	TS_ARG_GROUP,  /* an existing group                                   -> int (bit number) */
	TS_ARG_REGION, /* an existing region                                  -> struct ts_instance* */
	TS_ARG_REF,    /* c_ID, c_ID[k], f_ID, v_NAME or thermo keyword; copied -> const char* */
	TS_ARG_MODE,   /* one of the modes, each with its own rows            -> int (index) */
	TS_ARG_REST    /* all remaining words                                 -> struct ts_words */
};

/* A constant or the name of a variable; evaluate with ts_number_now, or with core/number_or_peratom.h where the row has
 * TS_EACH. */
struct ts_number {
	double value;
	const char *variable; /* NULL: constant */
	bool null;	      /* the user wrote NULL */
	size_t at;	      /* number of its word among the arguments, from 1; 0: a default */
};

/* Inclusive range of particle types, counted from 1. hi == 0: up to the last type. */
struct ts_types {
	int lo, hi;
};

/* Value of a coordinate written as EDGE; the style replaces it by the face of the box. */
#define TS_EDGE DBL_MAX

enum ts_range { TS_ANY, TS_POSITIVE, TS_NOT_NEGATIVE, TS_FRACTION /* 0..1 */, TS_WITHIN /* lo..hi */ };

enum ts_arg_flags {
	TS_POSITIONAL = 1,
	TS_OPTIONAL = 2,   /* may be missing: then NaN, INT64_MIN, NULL, -1, null ... is stored */
	TS_NULLABLE = 4,   /* the word NULL is allowed */
	TS_TO_KEYWORD = 8, /* TS_ARG_REST: ends before the first word that is a keyword of the table */
	TS_STATEFUL = 16,  /* state of a restart file is valid only with the same value of this argument */
	TS_WRITES = 32,	   /* TS_ARG_WORD: a file that will be written */
	TS_REPEAT = 64,	   /* TS_ARG_REST: a keyword that may be given several times; words are appended */
	TS_NAMED = 128,	   /* TS_ARG_REST: the keyword itself is stored as the first of the words; a name that
			    * ends in NAME is a pattern: d_NAME matches d_heat */
	TS_CUT = 256,	   /* TS_ARG_INT: 10.7 is 10, with a warning */
	TS_SHARES = 512,   /* with TS_WRITES: several styles may write to the file */
	TS_EACH = 1024	   /* TS_ARG_NUMBER: also a variable with a number for each particle */
};

struct ts_mode;

struct ts_arg {
	const char *name, *help;
	enum ts_arg_type type;
	unsigned flags;
	size_t offset;	  /* of the field in the state of the style, bytes */
	const char *unit; /* dimension: "length", "force/length", "" ... */
	enum ts_range range;
	double lo, hi;		     /* for TS_WITHIN */
	const char *fallback;	     /* default, as the user would write it; NULL: required or TS_OPTIONAL */
	const char *const *choices;  /* TS_ARG_ENUM, closed by NULL */
	const struct ts_mode *modes; /* TS_ARG_MODE, closed by .name NULL */
	/* TS_ARG_REST with TS_TO_KEYWORD: name of a TS_ARG_INT row; if that was given before, at least as
	 * many words are taken, even if they are keywords. */
	const char *count;
	size_t least; /* TS_ARG_REST with TS_TO_KEYWORD: there are so many words, even if they are keywords */
	size_t most;  /* TS_ARG_REST with TS_TO_KEYWORD: no more words are taken; 0: any number */
	/* TS_ARG_REST with TS_TO_KEYWORD: keywords and choices of these rows are taken as words, although
	 * the table has keywords of the same name. */
	const struct ts_arg *inner;
};

struct ts_mode {
	const char *name, *help;
	const struct ts_arg *args;
};

/* Arguments of a style that its manual page shows together; closed by .words NULL. */
struct ts_arg_group {
	const char *title; /* NULL: the words that everybody needs, which the page begins with */
	const char *words; /* names of rows, separated by blanks */
};

/* offsetof that does not compile if the type of the field is not that of the row. */
#define TS_FIELD(T, field, type)                                                                        \
	(offsetof(T, field) + 0 * sizeof(struct {                                                       \
				      int ok;                                                           \
				      _Static_assert(_Generic(&((T *)0)->field, type : 1, default : 0), \
						     "argument row and field differ in type");          \
			      }))

#define TS_REAL(name_, T, f, ...)                                                                     \
	{                                                                                             \
		.name = (name_), .type = TS_ARG_REAL, .offset = TS_FIELD(T, f, double *), __VA_ARGS__ \
	}
#define TS_INT(name_, T, f, ...)                                                                      \
	{                                                                                             \
		.name = (name_), .type = TS_ARG_INT, .offset = TS_FIELD(T, f, int64_t *), __VA_ARGS__ \
	}
#define TS_BOOL(name_, T, f, ...)                                                                   \
	{                                                                                           \
		.name = (name_), .type = TS_ARG_BOOL, .offset = TS_FIELD(T, f, bool *), __VA_ARGS__ \
	}
#define TS_FLAG(name_, T, f, ...)                                                                   \
	{                                                                                           \
		.name = (name_), .type = TS_ARG_FLAG, .offset = TS_FIELD(T, f, bool *), __VA_ARGS__ \
	}
#define TS_WORD(name_, T, f, ...)                                                                          \
	{                                                                                                  \
		.name = (name_), .type = TS_ARG_WORD, .offset = TS_FIELD(T, f, const char **), __VA_ARGS__ \
	}
#define TS_ENUM(name_, T, f, choices_, ...)                                            \
	{                                                                              \
		.name = (name_), .type = TS_ARG_ENUM, .offset = TS_FIELD(T, f, int *), \
		.choices = (choices_), __VA_ARGS__                                     \
	}
#define TS_VEC3(name_, T, f, ...)                                                                         \
	{                                                                                                 \
		.name = (name_), .type = TS_ARG_VEC3, .offset = TS_FIELD(T, f, double(*)[3]), __VA_ARGS__ \
	}
#define TS_COORD(name_, T, f, ...)                                                                     \
	{                                                                                              \
		.name = (name_), .type = TS_ARG_COORD, .offset = TS_FIELD(T, f, double *), __VA_ARGS__ \
	}
#define TS_NUMBER(name_, T, f, ...)                                                                   \
	{                                                                                             \
		.name = (name_), .type = TS_ARG_NUMBER, .offset = TS_FIELD(T, f, struct ts_number *), \
		__VA_ARGS__                                                                           \
	}
#define TS_TYPES(name_, T, f, ...)                                                                  \
	{                                                                                           \
		.name = (name_), .type = TS_ARG_TYPES, .offset = TS_FIELD(T, f, struct ts_types *), \
		__VA_ARGS__                                                                         \
	}
#define TS_GROUP(name_, T, f, ...)                                                                  \
	{                                                                                           \
		.name = (name_), .type = TS_ARG_GROUP, .offset = TS_FIELD(T, f, int *), __VA_ARGS__ \
	}
#define TS_REGION(name_, T, f, ...)                                                                      \
	{                                                                                                \
		.name = (name_), .type = TS_ARG_REGION, .offset = TS_FIELD(T, f, struct ts_instance **), \
		__VA_ARGS__                                                                              \
	}
#define TS_REF(name_, T, f, ...)                                                                          \
	{                                                                                                 \
		.name = (name_), .type = TS_ARG_REF, .offset = TS_FIELD(T, f, const char **), __VA_ARGS__ \
	}
#define TS_MODE(name_, T, f, modes_, ...)                                       \
	{                                                                       \
		.name = (name_), .type = TS_ARG_MODE, .flags = TS_POSITIONAL,   \
		.offset = TS_FIELD(T, f, int *), .modes = (modes_), __VA_ARGS__ \
	}
#define TS_REST(name_, T, f, ...)                                             \
	{                                                                     \
		.name = (name_), .type = TS_ARG_REST, .flags = TS_POSITIONAL, \
		.offset = TS_FIELD(T, f, struct ts_words *), __VA_ARGS__      \
	}
#define TS_LIST(name_, T, f, ...)                                                             \
	{                                                                                     \
		.name = (name_), .type = TS_ARG_REST, .flags = TS_POSITIONAL | TS_TO_KEYWORD, \
		.offset = TS_FIELD(T, f, struct ts_words *), __VA_ARGS__                      \
	}
#define TS_LIST_STATEFUL(name_, T, f, ...)                                                                  \
	{                                                                                                   \
		.name = (name_), .type = TS_ARG_REST, .flags = TS_POSITIONAL | TS_TO_KEYWORD | TS_STATEFUL, \
		.offset = TS_FIELD(T, f, struct ts_words *), __VA_ARGS__                                    \
	}
/* As TS_REST, but there may be no words. */
#define TS_REST_OPTIONAL(name_, T, f, ...)                                                  \
	{                                                                                   \
		.name = (name_), .type = TS_ARG_REST, .flags = TS_POSITIONAL | TS_OPTIONAL, \
		.offset = TS_FIELD(T, f, struct ts_words *), __VA_ARGS__                    \
	}
/* A keyword that takes the words after it: all, or with the flag TS_TO_KEYWORD those before the next
 * keyword. */
#define TS_LIST_KEYWORD(name_, T, f, ...)                                                          \
	{                                                                                          \
		.name = (name_), .type = TS_ARG_REST, .offset = TS_FIELD(T, f, struct ts_words *), \
		__VA_ARGS__                                                                        \
	}
/* A keyword that takes all words after it. */
#define TS_REST_KEYWORD(name_, T, f, ...)                                   \
	{                                                                   \
		.name = (name_), .type = TS_ARG_REST, .flags = TS_OPTIONAL, \
		.offset = TS_FIELD(T, f, struct ts_words *), __VA_ARGS__    \
	}
/* An optional keyword that takes the words before the next keyword; `flags_` may add TS_REPEAT. */
#define TS_SOME_KEYWORD(name_, T, f, flags_, ...)                                                      \
	{                                                                                              \
		.name = (name_), .type = TS_ARG_REST, .flags = TS_OPTIONAL | TS_TO_KEYWORD | (flags_), \
		.offset = TS_FIELD(T, f, struct ts_words *), __VA_ARGS__                               \
	}
#define TS_ARGS_END                \
	{                          \
		.type = TS_ARG_END \
	}

/* Sets the fields of the struct at `base` to their defaults, then to the values in `words`. `what` is the
 * name of the owner for messages ("fix gravity"), `where` the place reported for a missing word. Strings
 * are copied to the arena. rows NULL: no arguments allowed. */
enum ts_status ts_args_parse(struct tsim *sim, const char *what, const struct ts_arg *rows,
			     struct ts_words words, const struct ts_place *where, struct ts_arena *arena,
			     void *base);

/* Sets only the defaults. */
enum ts_status ts_args_defaults(struct tsim *sim, const struct ts_arg *rows, struct ts_arena *arena,
				void *base);

/* Appends "stiffness 20000 restitution 0.8 ...": the resolved values of all rows, given or default, with
 * as many digits as give the same numbers again. For the fingerprint of runs and for restart files: without the names of files
 * that are written, which may be others in a continued run. */
void ts_args_record(const struct tsim *sim, const struct ts_arg *rows, const void *base, struct ts_str *out);

/* Appends only the value, " 20000", or " yes" for a flag that is set; false if the argument is absent. */
bool ts_arg_record(const struct tsim *sim, const struct ts_arg *row, const void *base, struct ts_str *out);

/* -check: reports the files named by rows with TS_WRITES to the script interpreter. */
enum ts_status ts_args_outputs(struct tsim *sim, const char *what, const struct ts_arg *rows,
			       const void *base, struct ts_words words, const struct ts_place *where);

/* Appends the argument as written in a synopsis: "stiffness K", "[side in|out]", "x y z" ... */
void ts_arg_synopsis(const struct ts_arg *row, struct ts_str *out);

/* For integers that are words of a style, as TS_CUT for rows: reads an integer, or the whole part of a number such
 * as 333333.333333333, a time divided by the time step, with a warning: "fix insert/pack: insert_every is 10.7, no
 * integer: 10 is taken, as in LIGGGHTS". */
bool ts_arg_whole_part(const struct ts_instance *self, struct tsim *sim, const char *name, const char *text,
		       int64_t *out);

/* n, *, n*, *m or n*m */
bool ts_parse_types(const char *text, struct ts_types *out);

/* Fails if the number has a variable that cannot be one number; does not evaluate it. */
enum ts_status ts_number_check(struct tsim *sim, const struct ts_number *number,
			       const struct ts_place *where);

/* The present value of the number: evaluates its variable if it has one. */
enum ts_status ts_number_now(struct tsim *sim, const struct ts_number *number, const struct ts_place *where,
			     double *out);

#endif
