/* The simulation: all that a run has. Two can live in one process; nothing is global. */
#ifndef TS_CORE_SIM_H
#define TS_CORE_SIM_H

#include <stdbool.h>
#include <stdint.h>

#include "base/files.h"
#include "base/log.h"
#include "base/shared_buffer.h"
#include "base/status.h"
#include "base/str.h"
#include "core/deferred_loops.h"
#include "core/group.h"
#include "core/review.h"
#include "core/script_api.h"
#include "core/style.h"
#include "core/tables.h"

/* Systems, owned by the folders of their names; the core knows them by pointer only. */
struct ts_domain;
struct ts_particles;
struct ts_materials;
struct ts_neigh;
struct ts_bonds;
struct ts_rigid;
struct ts_thermo;
struct ts_library;
struct ts_guard;

enum ts_units { TS_UNITS_LJ, TS_UNITS_SI, TS_UNITS_CGS, TS_UNITS_MICRO };

/* What a run will cost, for -explain: explain/price.h. */
struct ts_price {
	double seconds; /* a step from the state here; NaN: not known */
	double crowded; /* a step when the particles have come together, if that is dearer; else the same */
	double frames;	/* seconds for all frames of dumps that were not among the steps tried */
	int64_t steps;	/* that were tried; 0: the value is that of an earlier run */
};

/* What -explain has found so far that the script will cost. */
struct ts_total_cost {
	double seconds, most, bytes; /* of all runs; most: with the particles together */
	struct ts_price last;	     /* of the last run */
	double tried;		     /* seconds spent on trials */
	bool open;		     /* there are runs whose number or length is not known */
};

/* Looks at run commands (-advise): told before one of them how far it goes, which it may shorten, and
 * after it; an error ends the script. */
struct ts_run_watch {
	enum ts_status (*before)(struct ts_run_watch *self, struct tsim *sim, const struct ts_place *where,
				 int64_t *last);
	enum ts_status (*after)(struct ts_run_watch *self, struct tsim *sim);
};

/* Live instances of one kind, in script order. */
struct ts_instances {
	struct ts_instance **item;
	size_t n, capacity;
};

/* Random numbers that formulas draw in a run are functions of the seed, the step, who acts and how many he
 * has drawn in this step: a run cut in two draws what the whole run draws. */
struct ts_draws {
	uint64_t site; /* who acts, and in which stage; 0: nobody, numbers come one after the other */
	uint64_t count;
};

struct ts_clock {
	int64_t step;	    /* the step counter                                    */
	int64_t first_step; /* of the current run                                  */
	int64_t last_step;  /* of the current run                                  */
	int64_t ramp_first; /* where what changes over a run begins and ends: the  */
	int64_t ramp_last;  /* run command's own, or as `run N start S stop E` says */
	int64_t goal;	    /* where the last run command is to end                */
	int64_t base_step;  /* time = base_time + (step - base_step) dt: exact for */
	double base_time;   /* a constant dt, whatever the number of steps         */
	double dt;
	double wall_start; /* ts_clock() at the start of the current run */
};

/* Who has acted last, for styles that watch. */
struct ts_acted {
	struct ts_instance *self; /* NULL: the stage begins */
	int stage;
};

/* What computes may stand for; see core/standard.h. */
enum ts_standard { TS_STANDARD_TEMPERATURE, TS_STANDARD_PRESSURE, TS_NSTANDARD };

/* -full: what is done though results do not depend on it; for tests of that, and to price it. */
enum ts_full {
	TS_FULL_COLUMNS = 1,  /* all columns of particles */
	TS_FULL_ROWS = 2,     /* contact rows, where no law acts on them */
	TS_FULL_HISTORY = 4,  /* their history, where the law remembers nothing */
	TS_FULL_REBUILDS = 8, /* rows are found anew in each step */
	TS_FULL_THREADS = 16, /* the shortest loops are shared among threads */
	TS_FULL_LOOKS = 32,   /* all rows are looked at in each step */
	TS_FULL_ALL = 63
};

/* How the script is read: to be run, explained or checked. */
struct ts_reading {
	bool explain;	   /* -explain: plan runs, do not step or write */
	bool check;	   /* -check: as explain, but errors do not end the script */
	bool planned;	   /* -explain: a run would have changed the state by now */
	bool open_clock;   /* -explain: how many steps were made before, only a run can tell */
	char from_run[48]; /* -explain: a value read by this line that only a run can give */
	bool unreached;	   /* -check: reads a line that is not run: names are not looked up */
	bool dry;	   /* formulas are only read: do names exist, are shapes right? */
	bool looking;	   /* a value is read that does not count: next() stays where it is */
};

/* What the run command, live styles and the stages tell each other about the run and the step. */
struct ts_run_state {
	bool inside;	     /* between the start and the end of a run */
	bool in_pieces;	     /* this run is stepped from outside, its end not known: core/stepping.h */
	bool in_setup;	     /* forces before the first step: contact history stands still */
	bool halted;	     /* by fix halt: later runs do nothing */
	bool unsafe;	     /* this run only warns of a step beyond the stability limit */
	bool box_moves;	     /* a run changes the box */
	bool explicit_euler; /* a live integrator is explicit Euler, which has limits of its own */
	bool clamped;	     /* a live integrator bounds how far particles move in a step */
	bool rebuild;	     /* this step exchanges particles and rebuilds the contact list */
	bool complete;	     /* this step leaves all that may be looked at when a run has ended */
	bool shows_contacts; /* somebody looks at the forces of contacts, or a program may do so */
	/* Nothing forces depend on has changed since the last step: the run goes on with the forces and the contact
	 * list of that step. */
	bool resuming;
	/* While one style acts in a stage, nothing changes that it reads: outputs are evaluated once. 0: something
	 * may change at any time. */
	uint64_t epoch;
	uint64_t epochs;	    /* so far */
	uint64_t fingerprint;	    /* of all that forces depend on, at the end of the last run */
	double timeout;		    /* ts_clock() when runs are to end (timer timeout); 0: never */
	int64_t timeout_every;	    /* steps between looks at the clock */
	struct ts_run_watch *watch; /* or NULL */
};

/* Requests from signal handlers. */
struct ts_requests {
	volatile int stop;	/* finish the step, then stop */
	volatile int save;	/* save the state after this step or command */
	bool stopped_whole;	/* it stopped between two steps or commands, and can be saved */
	bool saving;		/* this step ends with a restart file */
	struct ts_saver *saver; /* writes it; NULL: nobody does */
	/* File written when a signal stops the run; "": none; NULL: tsim.interrupted.restart beside the log. */
	const char *restart_file;
};

struct tsim {
	const struct ts_tables *tables; /* of styles, systems, checks */

	/* services */
	struct ts_error error;
	struct ts_log log;
	struct ts_files files; /* the one door to files; closed for -sandbox */
	struct ts_pool *pool;  /* file names and script lines of places */
	int threads;
	int grain; /* a loop is shared among threads only as far as each gets so many rounds */
	struct ts_deferred_loops deferred;
	struct ts_shared_buffers holds; /* columns that the library has given away */
	struct ts_draws draws;
	/* How often steps have begun to be counted anew, by reset_timestep or clear: random numbers differ then. */
	int64_t era;

	/* what the script says of the scene as a whole */
	struct ts_clock clock;
	enum ts_units units;
	bool units_given; /* by the command */
	int dimension;
	bool has_box;			     /* there is a simulation box; set by the domain */
	bool hard_particles, soft_particles; /* Young's moduli beyond the usual are meant */
	bool newton_on, still_ghosts;	     /* said by the script, of no effect; pair_style gran refuses */
	bool legacy;			     /* LIGGGHTS' numbers: see the command of this name */
	unsigned full;			     /* bits of enum ts_full */

	struct ts_reading reading;
	struct ts_run_state run;
	struct ts_requests requests;
	struct ts_acted acted;
	struct ts_total_cost cost;

	/* live instances */
	struct ts_instances instances[TS_NKIND]; /* systems, pair, bond, flow, pressure: at most one live */
	struct ts_instances retired;		 /* deleted, but others may still refer to them */
	uint64_t removals;		    /* of instances, ever: who refers to one must look it up again */
	struct ts_instance *outside;	    /* acts last in its stages: the program around the library */
	struct ts_unclaimed *unclaimed;	    /* state from a restart file for styles not yet defined again */
	const char *standard[TS_NSTANDARD]; /* names of computes; NULL: none */
	unsigned columns;		    /* all that live styles need */
	/* Grows when particles are added, deleted, reordered or their columns move in memory; never goes back, not
	 * by `clear` either. */
	uint64_t generation;
	struct ts_groups groups;

	/* the systems, by type: set when they are created */
	struct ts_domain *domain;
	struct ts_particles *particles;
	struct ts_materials *materials; /* held by the particles */
	struct ts_neigh *neigh;
	struct ts_bonds *bonds;
	struct ts_rigid *rigid;
	struct ts_thermo *thermo;
	struct ts_guard *guard;

	struct ts_library *library; /* what the C library keeps; NULL without it */
	struct ts_review review;    /* of the scene before a run */
	const char *settings;	    /* the last record of settings in the log; core/settings.h */
	struct ts_words line;	    /* of the command that runs */
	const struct ts_script_api *script_api;
	void *script_api_data;
};

/* How many threads are worth it for a loop of n rounds: sharing one among threads costs as much as some
 * thousand simple rounds. Results do not depend on it. */
static inline int ts_team(const struct tsim *sim, size_t n)
{
	size_t most = n / (size_t)sim->grain;

	return most >= (size_t)sim->threads ? sim->threads : most > 1 ? (int)most : 1;
}

double ts_sim_time(const struct tsim *sim);
void ts_sim_set_dt(struct tsim *sim, double dt);

struct ts_instance *ts_sim_find(const struct tsim *sim, enum ts_kind kind, const char *id);
/* The same, or an error with a suggestion. */
enum ts_status ts_sim_require(struct tsim *sim, enum ts_kind kind, const struct ts_word *id,
			      struct ts_instance **out);
/* Live styles of a family in script order, from the k-th of the kind on: start with *k = 0, call until
 * NULL. */
struct ts_instance *ts_sim_next_of(const struct tsim *sim, enum ts_kind kind, const char *family, size_t *k);
/* The one live pair, bond or flow, or NULL. */
struct ts_instance *ts_sim_only(const struct tsim *sim, enum ts_kind kind);

/* Whether create_box or read_restart has been done. */
static inline bool ts_sim_has_box(const struct tsim *sim)
{
	return sim->has_box;
}

/* For reporting several errors at once: with -check an error is noted and becomes TS_OK. */
enum ts_status ts_defer_error(struct tsim *sim, enum ts_status status);
/* Whether the value of this name, which is read now, hangs on a run that was only planned; notes that it
 * was. */
bool ts_from_run(struct tsim *sim, const char *name);

/* Hash of who acts in which stage, for random numbers: see struct ts_draws; never 0. */
uint64_t ts_instance_site(const struct ts_instance *inst, int stage);

/* The place of the k-th word of the command that runs (word 0 is its name), or `where`; and of the word
 * that is written so. */
const struct ts_place *ts_sim_word(const struct tsim *sim, size_t k, const struct ts_place *where);
const struct ts_place *ts_sim_word_of(const struct tsim *sim, const char *text, const struct ts_place *where);
#endif
