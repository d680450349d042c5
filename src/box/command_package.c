/* Command package: number of threads. */
#include "core/sim.h"

#include "base/banned.h"

struct package {
	int kind;
	int64_t threads, grain;
	bool neigh;
};

static enum ts_status set_threads(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct package *s = state;

	(void)where;
	if (s->threads)
		sim->threads = (int)s->threads;
	sim->grain = (int)s->grain;
	return TS_OK;
}

static const char *const kinds[] = { "omp", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("kind", struct package, kind, kinds, .flags = TS_POSITIONAL,
		.help = "omp: threads of one process"),
	TS_INT("threads", struct package, threads, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1024, .help = "number of threads; 0: as many as without this command"),
	TS_BOOL("neigh", struct package, neigh, .fallback = "yes", .help = "of LAMMPS, no effect"),
	TS_INT("grain", struct package, grain, .range = TS_WITHIN, .lo = 1, .hi = 1e9, .fallback = "8192",
	       .help = "minimum number of loop iterations per thread: shorter loops use fewer threads"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_package)
const struct ts_command_style ts_command_package = {
	.style = { .name = "package",
		   .kind = TS_KIND_COMMAND,
		   .ranks = TS_RANKS_FORMULAS,
		   .summary = "sets the number of threads",
		   .doc = "The same as -threads on the command line. Results are bitwise identical for any "
			  "number of threads and any grain. Loops with fewer than `grain` iterations per "
			  "thread use fewer threads, as starting a thread costs more than it gains.",
		   .example = "package omp 2\npackage omp 4 grain 500",
		   .args = args,
		   .state_size = sizeof(struct package) },
	.run = set_threads,
};
