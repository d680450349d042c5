/* `tsim -crosscheck liggghts|lammps`: runs a script with tsim and with the other program, each in a folder
 * of its own, and compares all output files. */
#ifndef TS_CROSSCHECK_CROSSCHECK_H
#define TS_CROSSCHECK_CROSSCHECK_H

#include "core/sim.h"

enum ts_verdict { TS_AGREE, TS_FAILED, TS_USAGE, TS_DIFFER, TS_ABSENT };

/* Returns the verdict, which is the exit status of the program. `words`: arguments of -crosscheck; `vars`:
 * -var NAME VALUE ... for both programs; `own`: options for tsim only; `called`: argv[0]. Appends the
 * report to `text`; sets sim->error if the comparison itself fails. */
struct ts_crosscheck_input {
	const char *script, *called;
	struct ts_words words, vars, own;
};
enum ts_verdict ts_crosscheck(struct tsim *sim, const struct ts_crosscheck_input *input, struct ts_str *text);

/* Appends the help on the arguments of -crosscheck, for tsim -help. */
void ts_crosscheck_help(struct ts_str *out);

#endif
