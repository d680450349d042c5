/* `tsim -advise`: short trial runs of the user's script at several settings; a table of the cost of each and
 * of the change of the columns of the thermo output.
 *
 * The script is executed in a child process and a temporary folder up to some step. From there each trial is
 * a fork of that process: it starts from the same state, changes one setting as a script line would, and
 * integrates over the same physical time. Results are returned through shared memory. */
#ifndef TS_ADVISE_ADVISE_H
#define TS_ADVISE_ADVISE_H

#include "core/sim.h"

/* `words`: arguments of -advise; `vars`: -var NAME VALUE ... Appends the report to `text`. Returns the exit
 * status: 0, 1 after an error, 2 for wrong arguments. After an error sim->error is set, or `trouble` has the
 * error message of the script. */
struct ts_advise_input {
	const char *script;
	struct ts_words words, vars;
};
int ts_advise(struct tsim *sim, const struct ts_advise_input *input, struct ts_str *text,
	      struct ts_str *trouble);

/* Appends the help on the arguments of -advise, for tsim -help. */
void ts_advise_help(struct ts_str *out);

#endif
