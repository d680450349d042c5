/* `tsim -crosscheck liggghts|lammps`: runs a script with tsim and with the other program, each in a folder
 * of its own, and compares all that both wrote. */
#ifndef TS_CROSSCHECK_CROSSCHECK_H
#define TS_CROSSCHECK_CROSSCHECK_H

#include "core/sim.h"

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

#endif
