/* Styles: everything a script can name (fix gravity, pair gran ...). One file, one constant table, one
 * exported symbol.
 *
 * The core allocates the state, fills in defaults, parses the arguments, documents, archives and
 * frees; the style's own code is its physics. Life cycle:
 *   parse -> init (when defined, except pair and bond, and before each run: resolve names, derive
 *   constants; may be called again) -> setup and other stage hooks -> fini (frees only what init and hooks
 *   allocated).
 * A slot left NULL means: nothing to do. */
#ifndef TS_CORE_STYLE_H
#define TS_CORE_STYLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/hash.h"
#include "core/archive.h"
#include "core/arg.h"
#include "core/value.h"

struct tsim;
struct ts_tables;

/* clang-format off */
#define TS_KIND_LIST(X)                                                                            \
	X(SYSTEM, "system")                                                                        \
	X(COMMAND, "command")                                                                      \
	X(FIX, "fix")                                                                              \
	X(PAIR, "pair")                                                                            \
	X(BOND, "bond")                                                                            \
	X(COMPUTE, "compute")                                                                      \
	X(REGION, "region")                                                                        \
	X(DUMP, "dump")                                                                            \
	X(FLOW, "flow")                                                                            \
	X(PRESSURE, "pressure")                                                                    \
	X(AUTOMATON, "automaton")
/* clang-format on */
#define TS_KIND_ENUM(name, text) TS_KIND_##name,
enum ts_kind { TS_KIND_LIST(TS_KIND_ENUM) TS_NKIND };
#undef TS_KIND_ENUM
const char *ts_kind_name(enum ts_kind kind);
/* "fix" -> TS_KIND_FIX; false: no kind has this name. */
bool ts_kind_find(const char *name, enum ts_kind *out);

/* The stages of a run, in order. SETUP is executed once, after the forces of the first step have been
 * computed. Of each step, PRE_EXCHANGE to POST_BUILD are executed if sim->run.rebuild is set (CHECK
 * decides), otherwise FORWARD. Particles are inserted in PRE_EXCHANGE, which the set-up of a run leaves
 * out. Within a stage hooks are called in this order: systems, pair, bond, flow, pressure, automaton, regions, fixes
 * in script order, computes, dumps; those with `saves_outputs` last. */
/* clang-format off */
#define TS_STAGE_LIST(X)                                                                           \
	X(INITIAL_INTEGRATE)                                                                       \
	X(POST_INTEGRATE)                                                                          \
	X(CHECK)                                                                                   \
	X(PRE_EXCHANGE)                                                                            \
	X(EXCHANGE)                                                                                \
	X(BUILD)                                                                                   \
	X(POST_BUILD)                                                                              \
	X(FORWARD)                                                                                 \
	X(PRE_FORCE)                                                                               \
	X(FORCE)                                                                                   \
	X(POST_FORCE)                                                                              \
	X(FINAL_INTEGRATE)                                                                         \
	X(END_OF_STEP)                                                                             \
	X(OUTPUT)                                                                                  \
	X(SETUP)                                                                                   \
	X(FINISH)
/* clang-format on */
#define TS_STAGE_ENUM(name) TS_STAGE_##name,
enum ts_stage { TS_STAGE_LIST(TS_STAGE_ENUM) TS_NSTAGE };
#undef TS_STAGE_ENUM
#define TS_DEFERS(stage) (1u << TS_STAGE_##stage)

/* The order of late hooks: first sums over contacts, which change no force; then drag forces that relax
 * velocities over the step; last forces proportional to the acceleration (added mass). */
enum ts_late { TS_LATE_CONTACTS, TS_LATE_RELAX, TS_LATE_INERTIA, TS_NLATE };

/* What a style reads of the surface that its slot `surface` names; bits. Walls keep it only then. */
enum ts_observes {
	TS_OBSERVES_CONTACTS = 1, /* wall/surface_contacts.h */
	TS_OBSERVES_IMPACTS = 2,  /* impact/impacts.h */
	TS_OBSERVES_BRIEF = 4 /* also contacts that begin and end within a step: wall/surface_contacts.h */
};

/* What the hooks of a style do with several ranks (core/ranks.h); bits. 0: the style is refused then. */
enum ts_rank_use {
	/* They act on each particle of their rank, and on the copies near it, alone. */
	TS_RANKS_OWN = 1,
	/* Those of END_OF_STEP and OUTPUT, and its outputs, are called while each rank has all particles; it has none in
	 * other stages of a step. */
	TS_RANKS_WHOLE = 2,
	/* Fixes that act on their own particles: outputs are columns of particles, or the same on all ranks. */
	TS_RANKS_OUTPUTS = 4,
	/* With TS_RANKS_WHOLE: these hooks and outputs read the columns of particles, but no lists of pairs or contacts, and
	 * change nothing; else that of SETUP. */
	TS_RANKS_PARTICLES = 8,
	/* All ranks do the steps in which `due` says so with all particles, as one rank does: what is rare and looks at the
	 * particles of all ranks, such as insertions of clumps. */
	TS_RANKS_STEPS = 16,
	/* Its `review` reads no particles and no contacts, but with -explain. */
	TS_RANKS_REVIEW = 32,
	/* Commands that read nothing of particles and contacts but by formulas, and change nothing: core/ranks_pause.h. */
	TS_RANKS_FORMULAS = 64,
	/* Neither its `init` nor its hooks of SETUP and FINISH read or change particles: ranks call them while the particles are
	 * divided. */
	TS_RANKS_ROWLESS = 128,
	/* Commands that act on each particle by itself, so that ranks call them while each has its own of the particles that
	 * commands have made, before the first run: core/ranks_pause.h. They call ts_ranks_unite where they need all. */
	TS_RANKS_ROWS = 256,
	/* Computes whose outputs are exact sums over a group: all ranks may evaluate them together while the particles are
	 * divided. */
	TS_RANKS_SUMS = 512
};

struct ts_carrier;
struct ts_copy_map;
struct ts_claims;
struct ts_restraint;
typedef enum ts_status ts_hook_fn(struct ts_instance *self, struct tsim *sim);

/* What a fix integrates for the particles of its group; bits. */
enum ts_integrates {
	TS_MOVES = 1, /* positions */
	TS_TURNS = 2, /* rotation */
	TS_OBEYS = 4  /* by the equations of motion; not set: motion is prescribed */
};

/* Springs and dashpots between a particle and the ground, without those of contacts, divided by its mass. */
struct ts_ground_springs {
	double frequency2[3]; /* of the springs along x, y, z: squared angular frequency, 1/time^2 */
	double rate[3];	      /* of the dashpots along x, y, z, 1/time */
	double turning;	      /* of the dashpots of its rotation, 1/time */
	double added;	      /* mass of the fluid that moves with the particle, by its own */
	bool estimated;	      /* some of it is an upper bound */
};

/* What all styles have in common; first member of the tables of each kind. */
struct ts_style {
	const char *name;
	enum ts_kind kind;
	const char *summary; /* one line, no full stop */
	const char
		*purpose; /* what it is used for, and what else a script needs; NULL: the summary says it */
	const char *doc;  /* paragraphs for the manual page: what it does, equations */
	/* further paragraphs, NULL-terminated: a string literal has at most 4095 characters (C11 5.2.4.1) */
	const char *const *doc_more;
	const char *example; /* script lines */
	const char *cite;    /* source of the method, or NULL */
	/* Name of the struct that its state begins with ("wall", "mesh" ...): by it other styles find the
	 * live styles of one sort, see ts_sim_next_of. NULL: none. */
	const char *family;
	const struct ts_arg *args;
	/* The order of the arguments in the manual page. NULL: all together or, if there are many, those that
	 * the example has first. */
	const struct ts_arg_group *groups;
	size_t state_size;	      /* bytes */
	const struct ts_arg *coeff;   /* pair and bond: arguments of a line of coefficients; core/coeff.h */
	const struct ts_saved *saved; /* fields of the state for restart files; see core/archive.h */
	/* For state that `saved` cannot describe; the same function writes and reads. */
	enum ts_status (*archive)(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
	/* Adds to the fingerprint of the run whatever forces depend on besides the arguments. */
	void (*fingerprint)(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash);
	const struct ts_value *values; /* its outputs */
	/* The fix whose surface has the elements that are the rows of outputs of shape TS_SURFACE: a mesh, a
	 * wall (wall/surface.h); valid after init. */
	const struct ts_instance *(*surface)(const struct ts_instance *self);
	unsigned observes; /* what it reads of that surface: bits of enum ts_observes */
	/* Whether it has this output with the arguments given (e.g. a scalar for one value, a vector for
	 * several); NULL: it has all. */
	bool (*gives)(const struct ts_instance *self, const struct ts_value *value);
	bool boxless;	  /* fix, compute: may be defined before the simulation box */
	unsigned columns; /* columns of particles it needs: bits of particle/particles.h */
	ts_hook_fn *init;
	ts_hook_fn *hook[TS_NSTAGE];
	/* Called at the end of POST_FORCE, in script order, after all its hooks and the functions of the
	 * outside program: forces that depend on the sum of all others. */
	ts_hook_fn *late[TS_NLATE];
	bool (*is_late)(
		const struct ts_instance *self); /* whether it has late hooks, after init; NULL: always */
	/* Fixes: which component of the force on a particle takes effect (setforce, freeze). See
	 * force/restraint.h. */
	const struct ts_restraint *restraint;
	/* TS_DEFERS of the stages in whose hooks loops over particles may stay deferred:
	 * core/deferred_loops.h */
	unsigned defers;
	bool saves_outputs; /* dumps: its OUTPUT comes last, after that of all others */
	/* Fixes: observes each step from INITIAL_INTEGRATE to END_OF_STEP: called when a stage begins and
	 * after each hook of another style (sim->acted). It changes nothing. */
	ts_hook_fn *watch;
	/* Potential energy [energy]; NULL: there is none. That of a fix is part of pe only after
	 * fix_modify energy yes. */
	enum ts_status (*energy)(struct ts_instance *self, struct tsim *sim, double *out);
	/* Computes: takes the present state as the new reference, e.g. initial positions (dump_modify
	 * refresh). */
	ts_hook_fn *refresh;
	/* Dumps: the keywords of dump_modify that change their frames, separated by blanks, but those that tell when and
	 * where frames are written. */
	const char *dump_words;
	/* Options of fix_modify, compute_modify or dump_modify of this style: reads the first of `words`; *used: how
	 * many words belong to it, 0: it is not an option of this style. */
	enum ts_status (*modify)(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				 size_t *used);
	/* Appends limits of the time step and other lines to the report of the plan; see core/report.h.
	 * Also called after steps of a run, and must not change anything then. */
	enum ts_status (*plan)(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *);
	/* Fixes: adds the springs and dashpots that it puts between particle i of its group and the ground: for the
	 * limit of the step of all fixes, contacts and bonds together. NULL: there are none. */
	void (*ground)(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum);
	/* Fixes: the largest type that it may give to particles in a run; before init, too. NULL: they keep theirs. */
	int (*gives_type)(const struct ts_instance *self, const struct tsim *sim);
	/* Fixes: whether something moves by the time since its definition, and would jump if the time were set. NULL: no. */
	bool (*moves_by_time)(const struct ts_instance *self);
	/* Fixes: takes `n` numbers of the outside program (tsim_external); `what` is a word of the fix. */
	enum ts_status (*take)(struct ts_instance *self, struct tsim *sim, const char *what, double *value,
			       size_t n);
	/* The number of columns of its outputs, or of elements of its vector, by its arguments, if ts_value does not have it; 0 or
	 * NULL: evaluation tells. */
	size_t (*width)(const struct ts_instance *self);
	/* Checks of the scene that only this style can make; reported by ts_review_report, see
	 * core/review.h. */
	ts_hook_fn *review;
	unsigned integrates; /* fixes: enum ts_integrates */
	/* Fixes: enlarges lo..hi [length] of one dimension (0..2) to include its geometry, for faces of
	 * the box that follow what they enclose (boundary s, m). */
	void (*extent)(const struct ts_instance *self, int dim, double *lo, double *hi);
	/* Completes files that are not complete after each step (movies): called when it is removed and after the script.
	 * fini, which follows, does the same after an error, but cannot report another one. */
	ts_hook_fn *close;
	unsigned
		ranks; /* enum ts_rank_use; commands need none, as each rank has all particles then; some have TS_RANKS_FORMULAS */
	/* Whether a hook of END_OF_STEP or OUTPUT, of systems SETUP, has anything to do in this step, with TS_RANKS_STEPS any hook, asked when
	 * the step begins; NULL: always. */
	bool (*due)(const struct ts_instance *self, const struct tsim *sim);
	/* Calls `tell` with each text, besides the arguments, whose outputs and variables it reads, as those of dump_modify:
	 * core/due_lists.h. */
	void (*names)(const struct ts_instance *self, void (*tell)(void *data, const char *text), void *data);
	/* While the particles are divided among ranks, before all ranks get all particles: sums over the particles of this
	 * rank become those over all of them (particle/rank_sums.h), for outputs. */
	ts_hook_fn *join;
	/* While the particles are divided among ranks: does what its hook of END_OF_STEP would do in this step if that needs
	 * no particles of other ranks, so that `due` is false then. All ranks call it. */
	ts_hook_fn *settle;
	const struct ts_carrier
		*carrier; /* state by particle that changes ranks with it; NULL: there is none */
	/* Adds the particles of other ranks that this one needs copies of besides those near it: particle/copies.h. */
	enum ts_status (*claim)(struct ts_instance *self, struct tsim *sim, const struct ts_copy_map *copies,
				struct ts_claims *claims);
	/* What of it advances in time by its hooks of END_OF_STEP or by its own history, although rerun integrates nothing ("the fluid"):
	 * rerun refuses it. NULL: nothing; so may be what it returns. */
	const char *(*advances)(const struct ts_instance *self);
	void (*fini)(struct ts_instance *self);
};

/* A live style, such as a fix that the script has defined: owned by the simulation. */
struct ts_instance {
	const struct ts_style *style;
	const char *id;		       /* "" where the kind has none */
	int group;		       /* bit number; 0: all */
	void *state;		       /* style->state_size bytes */
	struct ts_place where;	       /* the script line that defined it: for messages while running */
	struct ts_words words;	       /* its arguments as written */
	struct ts_arena arena;	       /* strings of its arguments */
	struct ts_table table;	       /* values of its last evaluated output */
	const struct ts_value *cached; /* the output in `table`; valid while sim->run.epoch == cached_epoch */
	uint64_t cached_epoch;
	uint64_t serial;   /* number of the instance, from 1 */
	uint64_t removals; /* sim->removals at its last init: what it points to may have been deleted since */
	int64_t every;	   /* dumps: interval in steps */
	bool counts_energy; /* fixes: fix_modify energy yes */
};

/* The only look-up of styles by name; NULL if unknown. */
const struct ts_style *ts_style_find(const struct ts_tables *tables, enum ts_kind kind, const char *name);
/* The same, or an error with a suggestion. */
enum ts_status ts_style_require(struct tsim *sim, enum ts_kind kind, const struct ts_word *name,
				const struct ts_style **out);
/* The k-th alias of a style; NULL: there are no more. */
const char *ts_style_other_name(const struct ts_style *style, size_t k);

/* A command: parsed like any style, run once, freed. */
struct ts_command_style {
	struct ts_style style;
	bool needs_box; /* refused before create_box or read_restart */
	/* NULL: accepted for compatibility, has no effect */
	enum ts_status (*run)(struct tsim *sim, void *state, const struct ts_place *where);
};

/* A system: a part of the simulation that exists once (particles, contact list, thermo ...). */
struct ts_system_style {
	struct ts_style style;
	/* Offset in struct tsim of the typed pointer to its state; 0: no other part of the program reads
	 * its state. */
	size_t slot;
	/* It only provides names for formulas, or functions for other systems: it has no live instance,
	 * state or stages. */
	bool no_instance;
	/* Sets the function pointers by which systems of folders below call this one; called when all
	 * systems have been created. */
	void (*connect)(struct tsim *sim);
	/* Reports limits of the time step by several styles together; called after the slots `plan` of all styles. */
	enum ts_status (*limits)(struct ts_plan_report *report, struct tsim *sim);
	/* Appends what commands have set to the record of settings in the log; core/settings.h. */
	void (*settings)(const struct ts_instance *self, const struct tsim *sim, struct ts_str *out);
	const struct ts_keyword *keywords;
	/* Before a run: refuses a keyword that can have no value in it; NULL: none. */
	enum ts_status (*check_keyword)(struct tsim *sim, const struct ts_keyword *keyword,
					const struct ts_place *where);
	const struct ts_function *functions;
	/* What acts in each step of the run by a value that depends on the particles of all ranks, as the subject of a message;
	 * NULL: nothing. */
	const char *(*undivided)(const struct tsim *sim);
	/* Whether all ranks do this step, or the set-up of a run, with all particles. */
	bool (*whole_step)(const struct tsim *sim, bool set_up);
	/* For -explain: packs the particles as in a settled bed, to time the most expensive step. */
	ts_hook_fn *crowd;
	/* Per-particle quantities by script name (x, vy, radius ...): one row per local particle. */
	bool (*has_quantity)(const struct tsim *sim, const char *name);
	bool (*keeps_quantity)(const struct tsim *sim, const char *name); /* stored by a fix: f_NAME */
	enum ts_status (*quantity)(struct tsim *sim, const char *name, struct ts_table *out);
	void (*suggest_quantity)(struct ts_suggest *suggest);
	const struct ts_quantity *(*quantity_text)(size_t k); /* NULL: there are no more */
	/* Whether there is a material property of that name, for `if property_NAME`. */
	bool (*has_property)(const struct tsim *sim, const char *name);
};

/* Marks a table for the generator of the table of styles; expands to its declaration. */
#define TS_STYLE(kind, type, symbol) extern const struct type symbol;

#endif
