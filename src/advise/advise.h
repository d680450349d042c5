/* `tsim -advise`: short trial runs of the user's own scene at a few settings; a table of what each costs and
 * what it does to the columns of the scene's table of the log.
 *
 * The scene is run in a child process and a folder of its own up to some step; there each trial is a copy
 * (fork) of that process: it starts from the very same state, changes one setting as a script line would,
 * and steps through the same physical time. Results come back through shared memory. */
#ifndef TS_ADVISE_ADVISE_H
#define TS_ADVISE_ADVISE_H

#include "core/sim.h"

/* `words` follow -advise; `vars` is -var NAME VALUE ... What is to be said is added to `text`. Returns an
 * exit status: 0, 1 after an error, 2 for wrong words. sim->error is set, or the scene's error is in
 * `trouble`. */
struct ts_advise_input {
	const char *script;
	struct ts_words words, vars;
};
int ts_advise(struct tsim *sim, const struct ts_advise_input *input, struct ts_str *text,
	      struct ts_str *trouble);

/* Lines on the words after -advise, for tsim -help. */
void ts_advise_help(struct ts_str *out);

#endif
