/* tsim: granular particles, bonds and drilling, as a C library. doc/library.md is the manual.
 *
 *   struct tsim *sim = tsim_open();
 *   if (!sim || tsim_file(sim, "in.drilling") || tsim_value(sim, "ke", &ke))
 *           fputs(tsim_error(sim), stderr);
 *   tsim_close(sim);
 *
 * Errors. Functions of type int return 0 on success, else a code of enum tsim_status; the
 * simulation then holds the message and its place. The first error stays until tsim_error_clear.
 * NULL, where nothing else is said about it, is refused with TSIM_RANGE; with sim = NULL other functions
 * give 0 or NULL. An array of no elements may be NULL.
 * Memory. Arrays belong to the caller. Texts and tables that are returned belong to the simulation;
 * how long they last is said at each. Structures that may grow begin with their size, which the
 * caller sets: TSIM_INIT does it.
 * Threads. Simulations share nothing: each may be used by one thread at a time, several at once.
 * Only tsim_stop may come from another thread or from a signal handler.
 * Output. Nothing is printed unless asked for, and nothing here ends the process. */
#ifndef TSIM_H
#define TSIM_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#if defined(__GNUC__)
#define TSIM_API __attribute__((visibility("default")))
#else
#define TSIM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

struct tsim;

/* ---- errors ---- */

enum tsim_status {
	TSIM_OK,
	TSIM_SYNTAX,  /* a word that is not understood                  */
	TSIM_UNKNOWN, /* a name nobody has                              */
	TSIM_RANGE,   /* a value, or the size of an array, that is wrong */
	TSIM_STATE,   /* not possible now                               */
	TSIM_IO,      /* a file cannot be read or written               */
	TSIM_DAMAGED, /* a file is damaged                              */
	TSIM_NOMEM,   /* out of memory                                  */
	TSIM_PHYSICS, /* the simulation left its valid region           */
	TSIM_STOPPED  /* tsim_stop, or a function of tsim_on_step       */
};

/* The error as the command line prints it: place, message, the script line and a mark below the
 * culprit. "" if there was none. Valid until the next call. sim may be NULL: out of memory. */
TSIM_API const char *tsim_error(struct tsim *sim);
/* Its parts. The texts are valid until tsim_error_clear; file and text are "" and the numbers 0
 * where no place is known. Counted from 1; column 0: the whole line. */
struct tsim_error_place {
	size_t size;
	int status;
	int line, column, length;
	const char *message, *file, *text;
};
TSIM_API void tsim_error_where(struct tsim *sim, struct tsim_error_place *out);
/* Forgets the error and a stop, so that the simulation can be used on. */
TSIM_API void tsim_error_clear(struct tsim *sim);
/* "value out of range" */
TSIM_API const char *tsim_status_text(int status);

/* ---- life ---- */

/* A new simulation; NULL: out of memory. */
TSIM_API struct tsim *tsim_open(void);
/* Ends it and closes its files. sim may be NULL. Not from inside a function of tsim_on_step. */
TSIM_API void tsim_close(struct tsim *sim);

/* What is said while a simulation runs. text: what would go to the screen, in pieces that need
 * not be lines; or a warning, or a line of progress, each without line end. */
enum tsim_log_level { TSIM_LOG_TEXT, TSIM_LOG_WARNING, TSIM_LOG_PROGRESS };
typedef void tsim_log_fn(void *data, enum tsim_log_level level, const char *text);

/* All zero is what tsim_open does. */
struct tsim_options {
	size_t size;
	int threads;	 /* 0: as OMP_NUM_THREADS says, else 1 */
	int explain;	 /* run nothing: print the plan of each run */
	FILE *screen;	 /* stays the caller's; NULL: none */
	const char *log; /* path of the log file; NULL: none */
	tsim_log_fn *on_log;
	void *on_log_data;
	int check; /* run nothing: scripts are only read, errors gathered for tsim_check_report */
};
/* The same with options. When it fails *out is NULL (out of memory), or a simulation that tells
 * why and still has to be closed. */
TSIM_API int tsim_open_with(const struct tsim_options *options, struct tsim **out);

/* Where output goes; NULL: nowhere, which is so at the start. The stream stays the caller's. */
TSIM_API void tsim_screen(struct tsim *sim, FILE *stream);
TSIM_API int tsim_log(struct tsim *sim, const char *path);
/* Who is told; NULL: nobody. fn may not call the library. */
TSIM_API void tsim_on_log(struct tsim *sim, tsim_log_fn *fn, void *data);

/* ---- scripts ---- */

/* Runs one script line, a text of several, a file, or a stream to its end. tsim_text says how
 * the text is called in messages. Ends a run of tsim_step. */
TSIM_API int tsim_line(struct tsim *sim, const char *line);
TSIM_API int tsim_string(struct tsim *sim, const char *text);
TSIM_API int tsim_text(struct tsim *sim, const char *text, const char *name);
TSIM_API int tsim_file(struct tsim *sim, const char *path);
TSIM_API int tsim_stream(struct tsim *sim, FILE *stream, const char *name);
/* Of a simulation opened with `check`, after its scripts: how many errors they have, and all of
 * them with places, then what the scripts would do, cut to fit `room` characters; *length: of
 * the whole (may be NULL). */
TSIM_API int tsim_check_report(struct tsim *sim, int *errors, char *out, size_t room, size_t *length);
/* Whether the script said `quit` (no more lines are run then), and with which status. */
TSIM_API int tsim_has_quit(struct tsim *sim, int *status);
/* Lets a simulation that runs stop after its present step, with TSIM_STOPPED. May be called
 * from a signal handler and from another thread. */
TSIM_API void tsim_stop(struct tsim *sim);

/* ---- stepping, and taking part in a step ---- */

/* n more steps. Successive calls are one run: the same bits as `run` of their sum, without
 * set-up in between. If something that forces depend on has changed since the last call (a
 * column, a variable, particles ...), the next call begins a new run, which computes forces
 * anew. A script line ends the run. The table of the log has no row at the end of a call, only
 * those of `thermo`. `fix halt` makes a call shorter: see tsim_clock. */
TSIM_API int tsim_step(struct tsim *sim, int64_t n);

enum tsim_stage {
	TSIM_BEFORE_FORCE, /* positions of the new step, velocities of the half step; f is 0 */
	/* after all fixes but drags that relax velocities; what is added to f acts in this step */
	TSIM_AFTER_FORCE,
	TSIM_END_OF_STEP /* velocities of the full step; before dumps and the table of the log */
};
enum { TSIM_STAGES = 3 };
/* Lets fn take part in all later steps, of `run` and of tsim_step; functions of a stage act in
 * the order in which they were given. BEFORE_FORCE and AFTER_FORCE come once more when a run
 * begins and computes forces. fn may read all, write forces (BEFORE_FORCE, AFTER_FORCE) or
 * positions, velocities and forces (END_OF_STEP), set variables and call tsim_stop; script
 * lines, particles created or deleted and tsim_close are refused there. It returns 0, or a code
 * of its own, which ends the run with TSIM_STOPPED. A C++ exception may not leave it. */
typedef int tsim_step_fn(struct tsim *sim, void *data);
TSIM_API int tsim_on_step(struct tsim *sim, enum tsim_stage stage, tsim_step_fn *fn, void *data);
/* Undoes one tsim_on_step with the same arguments; TSIM_UNKNOWN if there was none. */
TSIM_API int tsim_off_step(struct tsim *sim, enum tsim_stage stage, tsim_step_fn *fn, void *data);

/* ---- numbers by name ---- */

/* The value of a formula: "v_name", "c_ID[2]", "ke", "count(rock)", "2*PI*v_radius" ... */
TSIM_API int tsim_value(struct tsim *sim, const char *formula, double *out);

enum tsim_shape {
	TSIM_SCALAR = 1,   /* 1 x 1: any formula                                            */
	TSIM_VECTOR,	   /* n x 1: c_ID, f_ID; with [k] the k-th column of an array       */
	TSIM_PER_PARTICLE, /* particles x columns: c_ID, f_ID, with [k] one column; atom-style
			    * v_NAME; x, vx, radius ... ; in the order of particles in memory */
	TSIM_LOCAL,	   /* rows x columns: contacts, bonds ... c_ID, f_ID, with [k] one column */
	TSIM_ARRAY	   /* rows x columns: c_ID, f_ID                                    */
};
/* data[row * columns + column]; belongs to the simulation, valid until its next call. */
struct tsim_table {
	size_t size;
	const double *data;
	size_t rows, columns;
};
/* Evaluates it now. */
TSIM_API int tsim_evaluate(struct tsim *sim, const char *name, enum tsim_shape shape, struct tsim_table *out);
/* The same, copied into the caller's array; rows and columns must be what comes out
 * (TSIM_RANGE). */
TSIM_API int tsim_read(struct tsim *sim, const char *name, enum tsim_shape shape, double *out, size_t rows,
		       size_t columns);
/* How large it is now; evaluates it too. */
TSIM_API int tsim_extent(struct tsim *sim, const char *name, enum tsim_shape shape, size_t *rows,
			 size_t *columns);

/* An output of a compute or fix ("c_ID", "f_ID"), the k-th from 0; TSIM_UNKNOWN: there is none.
 * The texts live as long as the program. columns 0: not known before it is evaluated; the first
 * output of a shape is the one that is read. */
struct tsim_output {
	size_t size;
	const char *name, *unit, *help;
	int shape;
	size_t columns;
	const char *const *column_names; /* `columns` of them, or NULL */
};
TSIM_API int tsim_output(struct tsim *sim, const char *name, size_t k, struct tsim_output *out);

/* ---- variables ---- */

/* Sets an index variable, which wins over the script's own `variable NAME index ...`, as the
 * option -var does. */
TSIM_API int tsim_variable(struct tsim *sim, const char *name, const char *value);
/* As `variable NAME STYLE VALUE`, replacing one of that name: index, string, equal, atom ... */
TSIM_API int tsim_variable_set(struct tsim *sim, const char *name, const char *style, const char *value);
/* Gives the variable a number, exactly; makes one of style equal if there is none. Cheap enough
 * for every step. */
TSIM_API int tsim_variable_number(struct tsim *sim, const char *name, double value);
/* What ${NAME} stands for, cut to fit `room` characters; *length: of the whole, without the 0
 * at its end (may be NULL). Numbers: tsim_value "v_NAME". */
TSIM_API int tsim_variable_text(struct tsim *sim, const char *name, char *out, size_t room, size_t *length);
/* Name of the k-th variable from 0; NULL: there are no more. */
TSIM_API const char *tsim_variable_name(struct tsim *sim, size_t k);

/* ---- particles ---- */

TSIM_API size_t tsim_count(struct tsim *sim);

/* A quantity by its script name, one number for each particle, in the order of the particles at
 * this moment; n must be the number tsim_count gives. Read: all of tsim_quantity_name. Written:
 * type, x y z, vx vy vz, omegax .., ix iy iz, radius, diameter, mass, density between runs; fx
 * fy fz, tqx .. in functions of tsim_on_step (between runs forces are computed anew); NAME or
 * NAME[k] of fix property/atom like x. A radius keeps the density, a density and a mass the
 * radius. Values are checked before the first is written. */
TSIM_API int tsim_column_read(struct tsim *sim, const char *name, double *out, size_t n);
TSIM_API int tsim_column_write(struct tsim *sim, const char *name, const double *in, size_t n);
/* The same for the particles with these identities, in this order; id NULL: all by ascending
 * identity (n = tsim_count). */
TSIM_API int tsim_gather(struct tsim *sim, const char *name, const int32_t *id, double *out, size_t n);
TSIM_API int tsim_scatter(struct tsim *sim, const char *name, const int32_t *id, const double *in, size_t n);
/* Name of the k-th quantity from 0; NULL: there are no more. */
TSIM_API const char *tsim_quantity_name(size_t k);

/* A stored column without copying: x, v, f, omega, torque, image (3 numbers for each particle),
 * tag (identity), type, mask (groups), radius, mass, and columns of styles. `data` points to
 * count * width elements and is valid while tsim_generation gives `generation`: adding,
 * deleting and reordering particles, which steps do too, ends it. Written through are x, v,
 * omega between runs and at END_OF_STEP, f and torque at any stage of a step, the others not at
 * all (tsim_column_write, tsim_group_set). Once a writable view was given, each tsim_step
 * compares all columns with those of the last to see changes. */
enum tsim_type { TSIM_F64 = 1, TSIM_I32 = 3, TSIM_U32 = 4 };
struct tsim_view {
	size_t size;
	void *data;
	int type;	/* enum tsim_type */
	int writable;	/* now */
	size_t element; /* bytes of one number */
	size_t width;	/* numbers for each particle */
	size_t count;	/* particles */
	uint64_t generation;
};
TSIM_API int tsim_column_view(struct tsim *sim, const char *name, struct tsim_view *out);
/* Keeps the memory of a view until tsim_release is called as often, although the simulation may
 * long use another: a stale view then shows old values and writing to it does nothing.
 * tsim_close ends all. For bindings to languages whose users keep references. */
TSIM_API int tsim_hold(struct tsim *sim, void *data);
TSIM_API void tsim_release(struct tsim *sim, const void *data);
TSIM_API uint64_t tsim_generation(struct tsim *sim);
/* Name of the k-th stored column that exists, from 0; NULL: there are no more. */
TSIM_API const char *tsim_column_name(struct tsim *sim, size_t k);

/* Particles to be made. Arrays of n; x and v of 3 n: x0 y0 z0 x1 ... All but x may be NULL. */
struct tsim_particles {
	size_t size;
	size_t n;
	const double *x;
	const double *v;       /* 0 */
	const int32_t *type;   /* 1 */
	const double *radius;  /* 0.5 */
	const double *density; /* from the type's `mass`, else 1 */
};
/* Needs a box; positions must lie in it, periodic ones are wrapped. Nothing is made if one
 * value is wrong. id: n identities of the new particles, or NULL. Ends a run of tsim_step. */
TSIM_API int tsim_create(struct tsim *sim, const struct tsim_particles *particles, int32_t *id);
/* Deletes the particles with these identities; TSIM_UNKNOWN and nothing done if one is missing. */
TSIM_API int tsim_delete(struct tsim *sim, const int32_t *id, size_t n);

/* ---- groups ---- */

/* Number of the group's bit in the column `mask`, 0 to 31. */
TSIM_API int tsim_group_bit(struct tsim *sim, const char *name, int *bit);
/* Name of the group of a bit; NULL: free. */
TSIM_API const char *tsim_group_name(struct tsim *sim, int bit);
/* member[i] becomes 1 where particle i, in the order of memory, is in the group, else 0. */
TSIM_API int tsim_group_get(struct tsim *sim, const char *name, unsigned char *member, size_t n);
/* Makes the group if there is none of the name. */
TSIM_API int tsim_group_set(struct tsim *sim, const char *name, const unsigned char *member, size_t n);

/* ---- the state of the simulation ---- */

struct tsim_box {
	size_t size;
	int exists; /* create_box or read_restart was done */
	int dimension;
	double lo[3], hi[3];
	int periodic[3];
	char face[3][2]; /* p, f, s or m for the low and the high face */
};
TSIM_API void tsim_box(struct tsim *sim, struct tsim_box *out);

/* Each may be NULL. */
TSIM_API void tsim_clock(struct tsim *sim, int64_t *step, double *time, double *dt);

/* A number by name: see tsim_setting_name; the thermo keywords are formulas of tsim_value. */
TSIM_API int tsim_setting(struct tsim *sim, const char *name, double *out);
/* The k-th setting from 0, and what it is (help may be NULL); NULL: there are no more. */
TSIM_API const char *tsim_setting_name(size_t k, const char **help);

/* The k-th of the live instances of a kind (fix, compute, region, dump, pair, bond, flow), in
 * script order: its id, and its style (may be NULL). NULL: there are no more, or no such kind. */
TSIM_API const char *tsim_live(struct tsim *sim, const char *kind, size_t k, const char **style);

/* ---- what there is: no simulation needed; texts live as long as the program ---- */

/* "1.2.3" */
TSIM_API const char *tsim_version(void);
/* "command", "fix", "pair" ...; NULL: there are no more. */
TSIM_API const char *tsim_kind(size_t k);
/* The k-th style of a kind, by name, and its summary (may be NULL); NULL: there are no more. */
TSIM_API const char *tsim_style(const char *kind, size_t k, const char **summary);
/* The manual page, as plain text or as Markdown, cut to fit `room` characters; *length: of the
 * whole (may be NULL). TSIM_UNKNOWN: there is no such style; the text then says which one may
 * be meant. */
TSIM_API int tsim_help(const char *kind, const char *style, int markdown, char *out, size_t room,
		       size_t *length);

/* The k-th argument of a style. Arguments of a mode (`create_atoms 1 random ...`) follow the
 * argument that chooses it and name it. */
struct tsim_argument {
	size_t size;
	const char *name, *help;
	const char *type;     /* "number", "whole number", "word" ... */
	const char *unit;     /* "" if it has none */
	const char *fallback; /* default as a user would write it, or NULL */
	const char *mode;     /* the mode it belongs to, or NULL */
	int positional, optional, nullable;
	double least, most; /* inclusive but for 0 of `positive`; infinite: no limit */
	int positive;
	const char *const *choices; /* of a word, closed by NULL; or NULL */
};
TSIM_API int tsim_argument(const char *kind, const char *style, size_t k, struct tsim_argument *out);

/* A structure whose size is set: struct tsim_view view = TSIM_INIT(struct tsim_view); */
#ifdef __cplusplus
}
namespace tsim_detail
{
template <class T> inline T init()
{
	T value = T();
	value.size = sizeof value;
	return value;
}
} // namespace tsim_detail
#undef TSIM_INIT
#define TSIM_INIT(type) tsim_detail::init<type>()
#else
#define TSIM_INIT(type)              \
	{                            \
		.size = sizeof(type) \
	}
#endif

#endif
