/* The simulation: everything that a run reads or changes. Several can live in one process; nothing is
 * global. */
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
#include "core/recorder.h"
#include "core/ref.h"
#include "core/review.h"
#include "core/script_api.h"
#include "core/style.h"
#include "core/tables.h"
#include "rank/world.h"

/* Systems, defined in the folders of their names; the core stores only pointers to them. */
struct ts_domain;
struct ts_particles;
struct ts_materials;
struct ts_neigh;
struct ts_bonds;
struct ts_rigid;
struct ts_thermo;
struct ts_library;
struct ts_guard;
struct ts_division;

enum ts_units { TS_UNITS_LJ, TS_UNITS_SI, TS_UNITS_CGS, TS_UNITS_MICRO };

/* Estimated wall time of a run, for -explain: explain/price.h. */
struct ts_price {
	double seconds; /* wall time of a step from the present state, s; NaN: not known */
	double crowded; /* the same with the particles packed as a bed, if that takes longer, s */
	double frames;	/* wall time of all frames of dumps that were not among the steps tried, s */
	int64_t steps;	/* steps tried; 0: the times are those of an earlier run */
	char why[256];	/* where they are not known: what the steps did, and their error */
};

/* Estimated cost of all runs of the script so far, for -explain. */
struct ts_total_cost {
	double seconds;	      /* wall time from the present states, s */
	double most;	      /* the same with the particles packed as a bed, s */
	double bytes;	      /* files written */
	struct ts_price last; /* of the last run */
	double tried;	      /* wall time spent on trials, s */
	bool open;	      /* the number or length of some runs is not known */
};

/* Callbacks around run commands (-advise): `before` gets the last step of the run, which it may lower; an
 * error of either ends the script. */
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

/* Random numbers that formulas draw in a run are functions of the seed, the step, the instance and stage
 * that draw, and the number of draws before in this step: a run cut in two by a restart draws the same as
 * the whole run. */
struct ts_draws {
	uint64_t site;	/* hash of instance and stage; 0 outside of runs: one draw after the other */
	uint64_t count; /* draws of this hook in this step */
};

struct ts_clock {
	int64_t step;		/* the step counter                                    */
	int64_t first_step;	/* of the current run                                  */
	int64_t last_step;	/* of the current run                                  */
	int64_t elapsed_before; /* steps that `elapsed` counts before first_step: of `rerun start`, else 0 */
	int64_t ramp_first;	/* steps at which quantities that vary over a run begin */
	int64_t ramp_last;	/* and end: of this run, or `run N start S stop E`     */
	int64_t command_step;	/* step at which the last run command began           */
	int64_t goal;		/* last step of the last run command                   */
	int64_t resets;		/* of the counter, by reset_timestep                   */
	int64_t base_step;	/* time = base_time + (step - base_step) dt: one       */
	double base_time;	/* rounding for a constant dt, not one in each step; [time] */
	double dt;		/* [time] */
	double wall_start;	/* ts_clock() at the start of the current run, s */
};

/* The step that a number of a script means; from 9e18 on one that is never reached. */
static inline int64_t ts_clock_step_of(double step)
{
	return step < 9e18 ? (int64_t)step : INT64_MAX;
}

/* Counter of the first of `each` random numbers in this step; after reset_timestep those of steps of the same number differ. */
static inline uint64_t ts_clock_counter(const struct ts_clock *clock, uint64_t each)
{
	return each * (uint64_t)clock->step + ((uint64_t)clock->resets << 56);
}

/* The last hook called, for styles with the slot `watch`. */
struct ts_acted {
	struct ts_instance *self; /* NULL: the stage begins */
	int stage;		  /* enum ts_stage */
};

/* Thermo keywords that a compute can replace; see core/standard.h. */
enum ts_standard { TS_STANDARD_TEMPERATURE, TS_STANDARD_PRESSURE, TS_NSTANDARD };

/* -full: work that tsim leaves out because results do not depend on it, done nevertheless: tests compare
 * results with and without it, -explain measures what it would cost. */
enum ts_full {
	TS_FULL_COLUMNS = 1,	   /* all columns of particles */
	TS_FULL_CONTACTS = 2,	   /* the contact list, where there is no pair style */
	TS_FULL_HISTORY = 4,	   /* contact history, where the law has none */
	TS_FULL_REBUILDS = 8,	   /* the contact list is rebuilt in each step */
	TS_FULL_THREADS = 16,	   /* even the shortest loops are divided among threads */
	TS_FULL_ACTIVE_PAIRS = 32, /* all candidate pairs are computed in each step */
	TS_FULL_ALL = 63
};

/* How the script is read: to be run, explained or checked. */
struct ts_reading {
	bool explain;	   /* -explain: plan runs, do not step or write */
	bool check;	   /* -check: as explain, but errors do not end the script */
	int ranks;	   /* -explain, -check: as with so many ranks; 0: as with those that there are */
	bool broken;	   /* -check: a line has failed on which runs may depend: they are not set up */
	bool planned;	   /* -explain: a run has been left out, after which the state is unknown */
	bool open_clock;   /* -explain: the present step is unknown, since the length of some run is */
	char from_run[48]; /* -explain: name of a value read by this line that only a run can give */
	bool unreached;	   /* -check: reads a line that is not executed: names need not exist */
	bool dry;	   /* formulas are checked, not evaluated: do names exist, are shapes right? */
	bool probing;	   /* evaluation must have no side effect: next() does not advance */
	int64_t faults;	   /* -explain, -check: errors of plans so far that were recorded, not returned */
};

/* State of the run and of the present step, set and read by the run command, live styles and stages. */
struct ts_run_state {
	bool inside;	     /* between the start and the end of a run */
	bool in_pieces;	     /* this run is stepped by an outside program: core/stepping.h */
	bool in_setup;	     /* forces before the first step are computed: contact history is not advanced */
	bool halted;	     /* by fix halt or timer timeout: later runs do nothing */
	bool unsafe;	     /* this run only warns of a time step beyond the stability limit */
	bool box_moves;	     /* a run changes the box */
	bool explicit_euler; /* a live integrator is explicit Euler, which has stability limits of its own */
	bool clamped;	     /* a live integrator limits the displacement of particles in a step */
	bool rebuild;	     /* this step exchanges particles and rebuilds the contact list */
	bool relist;	     /* the contact list alone is to be rebuilt: no particle is deleted */
	bool runaways;	     /* a particle has moved by more than its radius in this step */
	bool seeks;  /* while the particles are divided: one has moved so far that it may have left the box */
	bool looks;  /* all ranks have all particles for outputs, but each has lists of its own only */
	bool pauses; /* the script is the whole program: core/ranks_pause.h */
	bool made; /* each rank has its own of the particles that commands have made; nothing has been computed */
	bool rowwise; /* a command acts on these, each by itself: formulas of particles read those of this rank */
	bool apart;	/* with several ranks: formulas are evaluated that may read nothing of particles */
	bool timed_out; /* the first of several ranks has found in this step that the wall time is up */
	bool undivided; /* with several ranks: all do all steps of this run with all particles (core/ranks.h) */
	bool uneven;	/* some ranks have so many particles that all are to be divided again */
	bool complete;	     /* the run may end with this step: it stores all that can be read afterwards */
	bool shows_contacts; /* an output reads forces of contacts, or an outside program may do so */
	bool shows_lists;    /* an output reads lists of pairs: core/due_lists.h tells in which steps */
	bool needs_lists;    /* all outputs may read lists of pairs */
	/* Nothing that forces depend on has changed since the last step: the run continues with the forces
	 * and the contact list of that step. */
	bool resuming;
	/* Number of the present hook call, during which nothing changes that outputs depend on: each
	 * output is evaluated once. 0: outputs may change at any time. */
	uint64_t epoch;
	uint64_t epochs;	    /* numbers given so far */
	uint64_t fingerprint;	    /* hash of all that forces depend on, at the end of the last run */
	double timeout;		    /* ts_clock() at which runs end (timer timeout), s; 0: never */
	int64_t timeout_every;	    /* steps between comparisons with the clock */
	struct ts_run_watch *watch; /* or NULL */
	struct ts_plan *
		paused; /* of the last run, if it has left particles divided, or a look: core/ranks_pause.h */
	uint64_t force_ticks; /* of ts_ticks(), for forces in this run, or in the last one */
};

/* Requests from signal handlers. */
struct ts_requests {
	volatile int stop;	/* finish the step, then stop */
	volatile int save;	/* save the state after this step or command */
	bool stopped_whole;	/* stopped between two steps or commands, so that the state is consistent */
	bool saving;		/* this step ends with a restart file */
	struct ts_saver *saver; /* writes the restart file; NULL: requests to save are ignored */
	/* File written when a signal stops the run; "": none; NULL: tsim.interrupted.restart beside the
	 * log. */
	const char *restart_file;
};

/* Whose results those of a run are, where algorithms differ: command legacy. */
enum ts_legacy { TS_LEGACY_NO, TS_LEGACY_LIGGGHTS, TS_LEGACY_LAMMPS };

struct tsim {
	const struct ts_tables *tables; /* of styles, systems, checks */

	/* services */
	struct ts_error error;
	struct ts_log log;
	struct ts_files files;	/* all access to files; restricted by -sandbox */
	struct ts_world *world; /* ranks: core/ranks.h; NULL: this process is alone */
	/* The particles of this rank and the copies near it: particle/division.h; NULL: this process has all
	 * particles. */
	struct ts_division *division;
	struct ts_pool
		*pool; /* owns strings that live as long as the simulation: file names, script lines ... */
	int threads;
	int grain; /* least number of iterations per thread of a parallel loop */
	struct ts_deferred_loops deferred;
	struct ts_shared_buffers holds; /* columns of particles whose pointers the library has given out */
	struct ts_draws draws;
	/* How often the step counter has been set (reset_timestep, clear): part of the key of random
	 * numbers, so that a step with the same number draws others. */
	int64_t era;

	/* global settings of the script */
	struct ts_clock clock;
	enum ts_units units;
	bool units_given; /* by the command `units` */
	int dimension;	  /* 2 or 3 */
	bool has_box;	  /* there is a simulation box; set by the domain */
	bool continued;	  /* from a restart file, whose steps it goes on counting */
	/* commands of these names: Young's moduli above or below the usual range are intended */
	bool hard_particles, soft_particles;
	/* `newton on`, `communicate ... vel no`: no effect, but pair gran refuses them */
	bool newton_on, still_ghosts;
	enum ts_legacy legacy;
	enum ts_legacy legacy_option; /* with which the program was started: `clear` returns to it */
	unsigned full;		      /* bits of enum ts_full */

	struct ts_reading reading;
	struct ts_run_state run;
	struct ts_requests requests;
	struct ts_acted acted;
	struct ts_total_cost cost;

	/* live instances */
	struct ts_instances
		instances[TS_NKIND]; /* systems, pair, bond, flow, pressure, automaton: at most one live */
	struct ts_instances retired; /* deleted regions to which live styles may still point */
	uint64_t instances_made;
	uint64_t defining; /* serial number of the instance that is being defined; 0: none */
	uint64_t removals; /* of instances so far: a pointer stored before the last one is looked up anew */
	struct ts_instance
		*outside; /* hooks of the program around the library, called last in their stages */
	struct ts_unclaimed *unclaimed;	    /* state from a restart file for styles not yet defined again */
	const char *standard[TS_NSTANDARD]; /* names of computes; NULL: none */
	unsigned columns; /* columns of particles that live styles need; bits of particle/particles.h */
	/* Incremented when particles are added, deleted or reordered or their columns move in memory;
	 * never reset, not by `clear` either. */
	uint64_t generation;
	struct ts_groups groups;

	/* the systems, by type: set when they are created */
	struct ts_domain *domain;
	struct ts_particles *particles;
	struct ts_materials *materials; /* owned by the system `particles` */
	struct ts_neigh *neigh;
	struct ts_bonds *bonds;
	struct ts_rigid *rigid;
	struct ts_thermo *thermo;
	struct ts_guard *guard;

	struct ts_library *library;   /* state of the C library; NULL without it */
	struct ts_review review;      /* checks of the scene before a run */
	struct ts_recorder *recorder; /* or NULL */
	struct ts_row_listener row_listener;
	const char *settings; /* the last record of settings in the log; core/settings.h */
	struct ts_words line; /* words of the command being executed */
	const struct ts_script_api *script_api;
	void *script_api_data;
};

/* Number of threads for a loop of n iterations: starting a team costs as much as some thousand simple
 * iterations. Results do not depend on it. */
static inline int ts_team(const struct tsim *sim, size_t n)
{
	size_t most = n / (size_t)sim->grain;

	return most >= (size_t)sim->threads ? sim->threads : most > 1 ? (int)most : 1;
}

double ts_sim_time(const struct tsim *sim);	 /* [time] */
void ts_sim_set_dt(struct tsim *sim, double dt); /* dt [time] */

/* The step of the next output by its variable, as `thermo v_NAME`: an error in the name of `what` ("thermo") if that step, of the
 * next `output` ("row"), is reached already. */
enum ts_status ts_sim_next_step(struct tsim *sim, const char *what, const char *output, const char *variable,
				const struct ts_place *where, int64_t *next);

/* timer timeout: whether the wall time of runs is up, in steps in which it is read. */
bool ts_sim_time_is_up(const struct tsim *sim);

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

/* For reporting several errors at once: with -check the error is recorded, and TS_OK is returned. */
enum ts_status ts_sim_defer_error(struct tsim *sim, enum ts_status status);
/* Whether the value of this name, which is read now, depends on a run that -explain has left out; records
 * the name in sim->reading.from_run. */
bool ts_sim_awaits_run(struct tsim *sim, const char *name);
/* Whether some system has a material property of that name (fix property/global). */
bool ts_sim_has_property(const struct tsim *sim, const char *name);

/* Hash of instance and stage, for random numbers: see struct ts_draws; never 0. */
uint64_t ts_instance_site(const struct ts_instance *inst, int stage);
/* The place of the argument with this text, for messages; of the line if there is none. */
const struct ts_place *ts_instance_word(const struct ts_instance *inst, const char *text);

/* The place of the k-th word of the command being executed (word 0 is its name), or `where`. */
const struct ts_place *ts_sim_word(const struct tsim *sim, size_t k, const struct ts_place *where);
/* The place of its first word with this text, or `where`. */
const struct ts_place *ts_sim_word_of(const struct tsim *sim, const char *text, const struct ts_place *where);
#endif
