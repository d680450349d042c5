/* Arguments of comm_modify and communicate, which in other programs control the exchange of ghost
 * particles between processes. Here ghosts are periodic images that reach as far as contacts need and
 * carry all data that forces depend on, so the arguments have no effect; those that would lose contacts
 * are refused. */
#ifndef TS_BOX_COMM_H
#define TS_BOX_COMM_H

#include "core/sim.h"

struct ts_comm {
	int mode, group;
	bool velocity, reduced;
	double cutoff;
	struct ts_words cutoffs;
};

extern const char *const ts_comm_modes[];

#define TS_COMM_MODE_HELP "no effect: images reach as far as the largest contact, cells adapt to sizes"
#define TS_COMM_ROWS(T)                                                                                \
	TS_BOOL("vel", T, comm.velocity, .fallback = "yes",                                            \
		.help = "no effect: images always carry velocities; pair gran refuses no"),            \
		TS_REAL("cutoff", T, comm.cutoff, .fallback = "0", .range = TS_NOT_NEGATIVE,           \
			.unit = "length", .help = "no effect: images reach as far as contacts need"),  \
		TS_SOME_KEYWORD("cutoff/multi", T, comm.cutoffs, TS_REPEAT,                            \
				.help = "type and length: no effect, as cutoff"),                      \
		TS_FLAG("reduce/multi", T, comm.reduced, .help = "no effect, as cutoff/multi"),        \
		TS_GROUP("group", T, comm.group, .fallback = "all",                                    \
			 .help = "all; another group is refused, since contacts of the others across " \
				 "periodic faces would be lost")

enum ts_status ts_comm_accept(struct tsim *sim, const struct ts_comm *comm, const struct ts_place *where);

#endif
