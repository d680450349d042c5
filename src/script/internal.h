/* Internals of the interpreter, for the files of this folder. */
#ifndef TS_SCRIPT_INTERNAL_H
#define TS_SCRIPT_INTERNAL_H

#include "core/sim.h"
#include "formula/formulas.h"
#include "script/line.h"
#include "script/script.h"
#include "script/source.h"

struct ts_check;

/* The text of a script file, kept to report lines never reached and names never used. */
struct ts_script_text {
	struct ts_script_text *next;
	const char *name, *text;
	bool included; /* by another script */
};

struct ts_script {
	struct tsim *sim;
	struct ts_formulas formulas;
	struct ts_source *source;    /* the innermost script being executed */
	const char *label;	     /* skip lines up to this label; NULL: execute lines */
	struct ts_place label_place; /* of the jump to it */
	bool skip_jump;		     /* `next` has found no further value: the next jump does nothing */
	bool quit;
	int quit_status;
	/* `shell` may start programs, and change files outside of `home` */
	bool programs;
	/* working folder at the first `shell` command, links resolved; NULL: none yet */
	const char *home;
	/* -check, -explain: nesting of the folders, not made by `shell mkdir`, to which `shell cd` has changed */
	int missing_folders;
	int branches;		  /* nesting of `if` commands being executed */
	int depth;		  /* nesting of scripts and commands */
	struct ts_words current;  /* the command being executed */
	struct ts_words expected; /* commands of `run every`, which will be executed during the run */
	struct ts_script_text *text;
	struct ts_arena arena;	/* memory of the texts */
	struct ts_check *check; /* -check and -explain; else NULL */
};

extern const struct ts_script_api ts_script_api_table;

/* The interpreter of the simulation; an error if the simulation has none. */
enum ts_status ts_script_of(struct tsim *sim, const struct ts_place *where, struct ts_script **out);
/* The place of the k-th word of the command being executed, or `where`. */
const struct ts_place *ts_script_place(const struct ts_script *script, size_t k,
				       const struct ts_place *where);

/* Executes a command given by its words; word 0 is its name. */
enum ts_status ts_script_run_words(struct ts_script *script, struct ts_words words);
/* Whether the command does steps of a run of its own. */
static inline bool ts_script_command_runs(const char *command)
{
	return ts_streq(command, "run") || ts_streq(command, "run_time");
}
/* Executes one or several lines, which are the argument of a command at `where`. */
enum ts_status ts_script_execute(struct ts_script *script, const char *text, const struct ts_place *where);
/* Stores the text of a file or a stream, once for each name. */
enum ts_status ts_script_store_text(struct ts_script *script, struct ts_source *source);
/* Executes a script within the present one. */
enum ts_status ts_script_include(struct ts_script *script, const char *path, const struct ts_place *where);

/* Replaces ${name}, $x and $(formula) outside of quotes. echo: print the line after each substitution,
 * like LIGGGHTS. */
enum ts_status ts_substitute(struct ts_script *script, struct ts_line *line, bool echo);
/* The same for a text written at `where`. */
enum ts_status ts_substitute_text(struct ts_script *script, const char *text, const struct ts_place *where,
				  struct ts_str *out);
/* The same for a text that is not executed: what is printed, or compared. Variables that contain words are unknown there, too,
 * if they were set in a branch of which it is unknown whether it is taken; commands get the words, which may be names of styles. */
enum ts_status ts_substitute_shown(struct ts_script *script, const char *text, const struct ts_place *where,
				   struct ts_str *out);
/* The same for the condition of `if`, where quotes are around words: they may be values of variables. */
enum ts_status ts_substitute_condition(struct ts_script *script, const char *text,
				       const struct ts_place *where, struct ts_str *out);

/* condition.c: checks the syntax of the arguments of `if`: conditions, `then`, commands. */
enum ts_status ts_condition_words(struct tsim *sim, struct ts_words words, const struct ts_place *where);

/* later.c: checks commands, or a text, that will be executed or substituted later. */
enum ts_status ts_later_check_commands(struct ts_script *script, struct ts_words commands);
enum ts_status ts_later_check_text(struct ts_script *script, const char *text, const struct ts_place *where);

#endif
