/* Internals of the interpreter, for the files of this folder. */
#ifndef TS_SCRIPT_INTERNAL_H
#define TS_SCRIPT_INTERNAL_H

#include "core/sim.h"
#include "formula/formulas.h"
#include "script/line.h"
#include "script/script.h"
#include "script/source.h"

struct ts_check;

/* What a script file says, kept for lines never reached and names never used. */
struct ts_script_text {
	struct ts_script_text *next;
	const char *name, *text;
};

struct ts_script {
	struct tsim *sim;
	struct ts_formulas formulas;
	struct ts_source *source;    /* the innermost script that runs */
	const char *label;	     /* skip lines up to this label; NULL: do not */
	struct ts_place label_place; /* the jump that wants it */
	bool skip_jump;		     /* `next` ran out: the next jump does nothing */
	bool quit;
	int quit_status;
	/* `shell` may start programs, and act outside of the folder of the run */
	bool programs;
	/* that folder: where the first `shell` began, links resolved; NULL: none yet */
	const char *home;
	int branches;		  /* commands of `if` that are being run */
	int depth;		  /* of scripts and commands in each other */
	struct ts_words current;  /* the command that runs */
	struct ts_words expected; /* commands of `run every` */
	struct ts_script_text *text;
	struct ts_arena arena;	/* of the texts */
	struct ts_check *check; /* -check: go through all of it, whatever fails */
};

extern const struct ts_script_api ts_script_api_table;

/* The interpreter a command was called by; fails if there is none. */
enum ts_status ts_script_of(struct tsim *sim, const struct ts_place *where, struct ts_script **out);
/* The place of the k-th word of the running command, or `where`. */
const struct ts_place *ts_script_place(const struct ts_script *script, size_t k,
				       const struct ts_place *where);

/* Runs a command by its words, word 0 being its name. */
enum ts_status ts_script_run_words(struct ts_script *script, struct ts_words words);
/* Runs a line or several, as the argument of a command that stands at `where`. */
enum ts_status ts_script_execute(struct ts_script *script, const char *text, const struct ts_place *where);
/* Keeps the text of a file or a stream; the same name is kept once. */
enum ts_status ts_script_keep(struct ts_script *script, struct ts_source *source);
/* Runs a script inside the one that runs. */
enum ts_status ts_script_include(struct ts_script *script, const char *path, const struct ts_place *where);

/* Replaces ${name}, $x and $(expression) outside of quotes. echo: show every step, as LIGGGHTS. */
enum ts_status ts_substitute(struct ts_script *script, struct ts_line *line, bool echo);
/* The same for a text that stands at `where`. */
enum ts_status ts_substitute_text(struct ts_script *script, const char *text, const struct ts_place *where,
				  struct ts_str *out);

/* condition.c: whether conditions, `then` and commands stand as `if` takes them. */
enum ts_status ts_condition_words(struct tsim *sim, struct ts_words words, const struct ts_place *where);

/* later.c: reads commands, or a text, that are to be executed or substituted later. */
enum ts_status ts_later_check_commands(struct ts_script *script, struct ts_words commands);
enum ts_status ts_later_check_text(struct ts_script *script, const char *text, const struct ts_place *where);

#endif
