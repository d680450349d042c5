/* `tsim -crosscheck liggghts|lammps`: runs a script with tsim and with the other program, each in a folder
 * of its own, and compares all that both wrote. */
#ifndef TS_CROSSCHECK_CROSSCHECK_H
#define TS_CROSSCHECK_CROSSCHECK_H

#include "core/sim.h"
#include "crosscheck/compare.h"
#include "crosscheck/folder.h"

enum ts_verdict { TS_AGREE, TS_FAILED, TS_USAGE, TS_PART, TS_ABSENT };

/* Returns the verdict, which is the exit status of the program. `words` follow -crosscheck; `vars` is
 * -var NAME VALUE ... for both programs, `own` goes to tsim alone. What is to be said is added to `text`;
 * sim->error is set where the comparison itself went wrong. */
struct ts_crosscheck_input {
	const char *script, *called; /* the latter: how this program was called */
	struct ts_words words, vars, own;
};
enum ts_verdict ts_crosscheck(struct tsim *sim, const struct ts_crosscheck_input *input, struct ts_str *text);

/* Lines on the words after -crosscheck, for tsim -help. */
void ts_crosscheck_help(struct ts_str *out);

/* outputs.c: files of both sides with the same names, those numbered in their names together. */
struct ts_outputs {
	struct ts_listing listing[TS_BOTH];
	struct ts_pairing *pairing;
	size_t n, capacity;
	const char **only[TS_BOTH], **skipped; /* in one of them; in both and not to be read as text */
	const char **empty[TS_BOTH];	       /* in both, and of that one without a word */
	size_t nonly[TS_BOTH], nskipped, only_capacity[TS_BOTH], skipped_capacity;
	size_t nempty[TS_BOTH], empty_capacity[TS_BOTH];
	struct ts_arena arena;
};
enum ts_status ts_outputs_pair(struct ts_outputs *o, const char *const folder[TS_BOTH], struct ts_error *err,
			       struct ts_pool *pool);
void ts_outputs_release(struct ts_outputs *o);

/* report.c: the table of one output. */
void ts_report_pairing(const struct ts_pairing *p, bool statistics, const char *peer, struct ts_str *out);

#endif
