/* Styles: everything a script can name. One file, one constant table, one exported symbol.
 *
 * The core allocates the state, fills in defaults, parses the arguments, documents, archives and
 * frees; the style's own code is its physics. Life cycle:
 *   parse -> init (when created, except pair and bond, and before each run: resolve names, derive
 *   constants; may be called again) -> setup and other stage hooks -> fini (only what init and hooks allocated).
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
	X(PRESSURE, "pressure")
/* clang-format on */
#define TS_KIND_ENUM(name, text) TS_KIND_##name,
enum ts_kind { TS_KIND_LIST(TS_KIND_ENUM) TS_NKIND };
#undef TS_KIND_ENUM
const char *ts_kind_name(enum ts_kind kind);
/* "fix" -> TS_KIND_FIX; false: no kind has this name. */
bool ts_kind_find(const char *name, enum ts_kind *out);

/* The stages of a run, in order. SETUP comes once, after the first forces. Of a step, PRE_EXCHANGE to
 * POST_BUILD are done when sim->rebuild is set (CHECK decides), else FORWARD. Particles are made in
 * PRE_EXCHANGE, which a set-up does not have. Within a stage
 * systems act first, then pair, bond, flow, pressure, fixes in script order, computes, dumps. */
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

/* The order of late hooks: first sums over contacts, which change no force; then forces that relax velocities; last
 * forces that depend on the acceleration. */
enum ts_late { TS_LATE_CONTACTS, TS_LATE_RELAX, TS_LATE_INERTIA, TS_NLATE };

struct ts_restraint;
struct ts_mesh_surface;
typedef enum ts_status ts_hook_fn(struct ts_instance *self, struct tsim *sim);

/* Which motion of the particles of its group a fix steps forward. */
enum ts_integrates { TS_MOVES = 1, TS_TURNS = 2, TS_OBEYS = 4 /* as forces say */ };

/* What all styles have in common; first member of the tables of each kind. */
struct ts_style {
	const char *name;
	enum ts_kind kind;
	const char *summary; /* one line, no full stop */
	const char *doc;     /* paragraphs for the manual page: what it does, equations */
	const char *example; /* script lines */
	const char *cite;    /* source of the method, or NULL */
	/* The struct that its state begins with, by which other styles find live styles of one sort: "wall",
	 * "mesh" ...; see ts_sim_next_of. NULL: none. */
	const char *family;
	const struct ts_arg *args;
	size_t state_size;
	const struct ts_arg *coeff;   /* pair and bond: one line of coefficients; core/coeff.h */
	const struct ts_saved *saved; /* state for restart files; see core/archive.h */
	/* For state that rows cannot describe; same function for writing and reading. */
	enum ts_status (*archive)(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
	/* Adds to the fingerprint whatever forces depend on besides the arguments. */
	void (*fingerprint)(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash);
	const struct ts_value *values;
	/* The mesh whose triangles are the rows of outputs of TS_SURFACE; valid after init. */
	const struct ts_mesh_surface *(*surface)(const struct ts_instance *self);
	/* Which of them there are with the arguments given (one value: a vector, several: an array);
	 * NULL: all. */
	bool (*gives)(const struct ts_instance *self, const struct ts_value *value);
	bool boxless;	  /* a fix that may be made before the box */
	unsigned columns; /* particle columns it needs: bits of particle/particles.h */
	ts_hook_fn *init;
	ts_hook_fn *hook[TS_NSTAGE];
	/* Called at the end of POST_FORCE, after all its hooks and functions of the outside program, in
	 * script order: forces that depend on the sum of all others. */
	ts_hook_fn *late[TS_NLATE];
	bool (*is_late)(const struct ts_instance *self); /* asked after init; NULL: always */
	/* Fixes: which part of a force on a particle takes effect. See force/restraint.h. */
	const struct ts_restraint *restraint;
	/* TS_DEFERS of stages in whose hooks passes over particles may wait: core/deferred_loops.h */
	unsigned defers;
	/* Fixes: observes each step from INITIAL_INTEGRATE to END_OF_STEP: called when a stage begins and
	 * after each action of others (sim->acted). It changes nothing. */
	ts_hook_fn *watch;
	/* Potential energy; NULL: there is none. Of a fix it counts as far as fix_modify says so. */
	enum ts_status (*energy)(struct ts_instance *self, struct tsim *sim, double *out);
	/* Computes: resets the reference of the past, as initial positions (dump_modify refresh). */
	ts_hook_fn *refresh;
	/* The words of fix_modify or compute_modify that are its own: reads the first ones, says how many. */
	enum ts_status (*modify)(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				 size_t *used);
	/* Appends limits of the time step and other lines to the plan; see core/plan.h. Also asked while
	 * the run goes on, after any step: must not change anything then. */
	enum ts_status (*plan)(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *);
	/* What a check of the table in review/table.c cannot see: told by ts_review_find, see
	 * core/review.h. */
	ts_hook_fn *review;
	unsigned integrates; /* fixes: enum ts_integrates */
	/* Fixes: widens lo..hi of one dimension by the space that it takes up, which faces of the box that
	 * move (boundary s, m) enclose. */
	void (*extent)(const struct ts_instance *self, int dim, double *lo, double *hi);
	void (*fini)(struct ts_instance *self);
};

/* A live style: owned by the simulation. */
struct ts_instance {
	const struct ts_style *style;
	const char *id;		     /* "" where the kind has none */
	int group;		     /* bit number; 0 = all */
	void *state;		     /* style->state_size bytes */
	struct ts_place where;	     /* the line that made it: for messages while running */
	struct ts_words words;	     /* its arguments as written */
	struct ts_arena arena;	     /* strings of its arguments */
	struct ts_table table;	     /* for its outputs */
	const struct ts_value *held; /* what the table holds, since sim->epoch was held_since */
	uint64_t held_since;
	int64_t every;	    /* dumps: interval in steps */
	bool counts_energy; /* fixes: fix_modify energy yes */
};

/* The place of the argument written so, for messages; of the line if there is none. */
const struct ts_place *ts_instance_word(const struct ts_instance *inst, const char *text);

/* A command: parsed like any style, run once, freed. */
struct ts_command_style {
	struct ts_style style;
	bool needs_box; /* refused before create_box or read_restart */
	/* NULL: accepted for compatibility, has no effect */
	enum ts_status (*run)(struct tsim *sim, void *state, const struct ts_place *where);
};

/* A system: a part of the simulation that exists once (particles, contact rows, thermo ...). Its
 * state is also reachable as a typed pointer of struct tsim. */
struct ts_system_style {
	struct ts_style style;
	size_t slot; /* offset of that pointer in struct tsim; 0: it has no state that others see */
	/* It only gives names to formulas, or functions to other systems: it has no live instance, state
	 * or stages. */
	bool no_instance;
	/* Sets the functions of its folder that systems of the folders below call; called when all systems
	 * live. */
	void (*connect)(struct tsim *sim);
	/* Adds what commands have set, for the record in the log; core/settings.h. */
	void (*settings)(const struct ts_instance *self, const struct tsim *sim, struct ts_str *out);
	const struct ts_keyword *keywords;
	const struct ts_function *functions;
	/* For -explain: moves particles together as a bed of them would be. */
	ts_hook_fn *crowd;
	/* Per-particle numbers by script name (x, vy, radius ...): one row per local particle. */
	bool (*has_quantity)(const struct tsim *sim, const char *name);
	bool (*keeps_quantity)(const struct tsim *sim, const char *name); /* for a fix */
	enum ts_status (*quantity)(struct tsim *sim, const char *name, struct ts_table *out);
	void (*suggest_quantity)(struct ts_suggest *suggest);
	const struct ts_quantity *(*quantity_text)(size_t k); /* NULL: there are no more */
	/* Material properties by name, for `if property_NAME`. */
	bool (*has_property)(const struct tsim *sim, const char *name);
};

/* Marks a table for the generator; expands to its declaration. */
#define TS_STYLE(kind, type, symbol) extern const struct type symbol;

#endif
