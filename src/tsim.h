/* tsim: granular particles, bonds and drilling, as a C library. doc/library.md is the manual.
 *
 *   struct tsim *sim = tsim_open();
 *   if (!sim || tsim_file(sim, "in.drilling") || tsim_value(sim, "ke", &ke))
 *           fputs(tsim_error(sim), stderr);
 *   tsim_close(sim);
 *
 * Errors. Functions of type int return 0 on success, otherwise a code of enum tsim_status; the message and
 * its place are stored in the simulation. The first error is kept until tsim_error_clear. A NULL argument is
 * an error (TSIM_RANGE) unless stated otherwise; functions that do not return a status return 0 or NULL if
 * sim is NULL. An array of no elements may be NULL.
 *
 * Memory. Arrays belong to the caller. Returned strings and tables belong to the simulation; their lifetime
 * is stated with each function. Structures that may be extended begin with their size, which the caller sets
 * (TSIM_INIT).
 *
 * Threads. Simulations share no data: different threads may use different simulations at the same time, but
 * only one thread at a time may use a simulation. Only tsim_stop may be called from another thread or from a
 * signal handler.
 *
 * Output. Nothing is printed by default, and no function ends the process. */
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
	TSIM_SYNTAX,  /* syntax error                                   */
	TSIM_UNKNOWN, /* unknown name                                   */
	TSIM_RANGE,   /* wrong value, or wrong size of an array         */
	TSIM_STATE,   /* not possible now                               */
	TSIM_IO,      /* a file cannot be read or written               */
	TSIM_DAMAGED, /* a file is damaged                              */
	TSIM_NOMEM,   /* out of memory                                  */
	TSIM_PHYSICS, /* the simulation left its valid region           */
	TSIM_STOPPED  /* tsim_stop, or a function of tsim_on_step       */
};

/* The error as the command line prints it: place, message, the script line with the wrong word marked; "" if
 * there is none. Valid until the next call. sim may be NULL: out of memory. */
TSIM_API const char *tsim_error(struct tsim *sim);
/* The parts of the error. Strings are valid until tsim_error_clear. Line and column are counted from 1;
 * column 0: the whole line. If no place is known file and text are "" and the numbers 0. */
struct tsim_error_place {
	size_t size;
	int status;
	int line, column, length;
	const char *message, *file, *text;
};
TSIM_API void tsim_error_where(struct tsim *sim, struct tsim_error_place *out);
/* Clears the error and a stop request, so that the simulation can be continued. */
TSIM_API void tsim_error_clear(struct tsim *sim);
/* "value out of range" */
TSIM_API const char *tsim_status_text(int status);

/* ---- creation and end of a simulation ---- */

/* A new simulation; NULL: out of memory. */
TSIM_API struct tsim *tsim_open(void);
/* Closes the files of a simulation and frees it. sim may be NULL. Has no effect in a function of
 * tsim_on_step. */
TSIM_API void tsim_close(struct tsim *sim);

/* Receives the output of a simulation. text: screen output, in pieces that need not be whole lines; or a
 * warning, or a line of progress, without line end. */
enum tsim_log_level { TSIM_LOG_TEXT, TSIM_LOG_WARNING, TSIM_LOG_PROGRESS };
typedef void tsim_log_fn(void *data, enum tsim_log_level level, const char *text);

/* With all members 0 the same as tsim_open. */
struct tsim_options {
	size_t size;
	int threads;	 /* 0: OMP_NUM_THREADS, otherwise 1 */
	int explain;	 /* do not run: print the plan of each run */
	FILE *screen;	 /* the caller closes it; NULL: none */
	const char *log; /* path of the log file; NULL: none */
	tsim_log_fn *on_log;
	void *on_log_data;
	int check; /* do not run: scripts are only checked, see tsim_check_report */
};
/* The same with options. After an error *out is NULL (out of memory), or a simulation with the error message,
 * which must be closed. */
TSIM_API int tsim_open_with(const struct tsim_options *options, struct tsim **out);

/* Sets the screen output and the log file; NULL: none, which is the default. The caller closes the stream. */
TSIM_API void tsim_screen(struct tsim *sim, FILE *stream);
TSIM_API int tsim_log(struct tsim *sim, const char *path);
/* Sets the function that receives the output; NULL: none. fn must not call the library. */
TSIM_API void tsim_on_log(struct tsim *sim, tsim_log_fn *fn, void *data);

/* ---- scripts ---- */

/* Executes a script line, a string of several lines, a file, or a stream. `name` is the name of the text in
 * messages. Ends a run of tsim_step. */
TSIM_API int tsim_line(struct tsim *sim, const char *line);
TSIM_API int tsim_string(struct tsim *sim, const char *text);
TSIM_API int tsim_text(struct tsim *sim, const char *text, const char *name);
TSIM_API int tsim_file(struct tsim *sim, const char *path);
TSIM_API int tsim_stream(struct tsim *sim, FILE *stream, const char *name);
/* For a simulation opened with `check`, after its scripts: the number of errors, and a text with all errors
 * and their places and then what the scripts would do, truncated to `room` bytes; *length: length of the
 * full text (may be NULL). */
TSIM_API int tsim_check_report(struct tsim *sim, int *errors, char *out, size_t room, size_t *length);
/* Whether the script has executed `quit` (further lines are not executed), and its status. */
TSIM_API int tsim_has_quit(struct tsim *sim, int *status);
/* Stops a running simulation after the present step, with TSIM_STOPPED. May be called from a signal handler
 * and from another thread. */
TSIM_API void tsim_stop(struct tsim *sim);

/* ---- time steps, and functions called in a step ---- */

/* Runs n steps. Successive calls are one run: the results are bitwise those of `run` with the sum of the
 * steps, without set-up in between. If data that forces depend on (a column, a variable, particles ...)
 * have changed since the last call, a new run begins, which computes the forces anew. A script line ends
 * the run. Thermo output is printed only at the intervals of `thermo`, not at the end of a call. `fix halt`
 * may end a call earlier: see tsim_clock. */
TSIM_API int tsim_step(struct tsim *sim, int64_t n);

enum tsim_stage {
	TSIM_BEFORE_FORCE, /* positions of the new step, velocities of the half step; f is 0 */
	/* after all fixes except drags with scheme exact or implicit; forces added to f act in this step */
	TSIM_AFTER_FORCE,
	TSIM_END_OF_STEP /* velocities of the full step; before dumps and thermo output */
};
enum { TSIM_STAGES = 3 };
/* Calls fn in all later steps, of `run` and of tsim_step; functions of a stage are called in the order in
 * which they were added. BEFORE_FORCE and AFTER_FORCE are also called when a run begins and computes
 * forces. fn may read all data, write forces (BEFORE_FORCE, AFTER_FORCE) or positions, velocities and
 * forces (END_OF_STEP), set variables and call tsim_stop; script lines, creation and deletion of particles,
 * and tsim_close are refused. It returns 0, or a code of its own, which ends the run with TSIM_STOPPED. It
 * must not throw C++ exceptions. */
typedef int tsim_step_fn(struct tsim *sim, void *data);
TSIM_API int tsim_on_step(struct tsim *sim, enum tsim_stage stage, tsim_step_fn *fn, void *data);
/* Reverts one call of tsim_on_step with the same arguments; TSIM_UNKNOWN if there was none. */
TSIM_API int tsim_off_step(struct tsim *sim, enum tsim_stage stage, tsim_step_fn *fn, void *data);

/* ---- values by name ---- */

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
/* Evaluates an output, quantity or formula. */
TSIM_API int tsim_evaluate(struct tsim *sim, const char *name, enum tsim_shape shape, struct tsim_table *out);
/* The same, copied to the array of the caller; rows and columns must be those of the result (otherwise
 * TSIM_RANGE). */
TSIM_API int tsim_read(struct tsim *sim, const char *name, enum tsim_shape shape, double *out, size_t rows,
		       size_t columns);
/* The present number of rows and columns; this evaluates the output. */
TSIM_API int tsim_extent(struct tsim *sim, const char *name, enum tsim_shape shape, size_t *rows,
			 size_t *columns);

/* Output k, from 0, of a compute or fix ("c_ID", "f_ID"); TSIM_UNKNOWN: none. Strings are valid as long as
 * the program. columns 0: not known before the evaluation. If there are several outputs of a shape, the
 * functions above evaluate the first one. */
struct tsim_output {
	size_t size;
	const char *name, *unit, *help;
	int shape;
	size_t columns;
	const char *const *column_names; /* `columns` of them, or NULL */
};
TSIM_API int tsim_output(struct tsim *sim, const char *name, size_t k, struct tsim_output *out);

/* ---- variables ---- */

/* Sets an index variable, with precedence over `variable NAME index ...` of the script, like the option
 * -var. */
TSIM_API int tsim_variable(struct tsim *sim, const char *name, const char *value);
/* Like `variable NAME STYLE VALUE`; replaces a variable of that name. Styles: index, string, equal, atom
 * ... */
TSIM_API int tsim_variable_set(struct tsim *sim, const char *name, const char *style, const char *value);
/* Sets the variable to a number, exactly; creates one of style equal if it does not exist. Fast enough for
 * every step. */
TSIM_API int tsim_variable_number(struct tsim *sim, const char *name, double value);
/* The value of ${NAME} as text, truncated to `room` bytes; *length: full length without the final 0 (may be
 * NULL). For numbers use tsim_value with "v_NAME". */
TSIM_API int tsim_variable_text(struct tsim *sim, const char *name, char *out, size_t room, size_t *length);
/* Name of variable k, from 0; NULL at the end. */
TSIM_API const char *tsim_variable_name(struct tsim *sim, size_t k);

/* ---- rows of the log, and tables in files ---- */

/* A row of the log (thermo_style). Names are the titles of the columns. */
struct tsim_row {
	size_t size;
	int64_t step;
	double time;
	size_t columns;
	const char *const *names; /* [columns] */
	const double *values;	  /* [columns] */
};
/* Calls fn with each row of the log, before it is printed, with all digits; NULL: none, which is the default. fn
 * returns 0, or a code of its own, which ends the run with TSIM_STOPPED; it must not call the library. */
typedef int tsim_row_fn(void *data, const struct tsim_row *row);
TSIM_API void tsim_on_row(struct tsim *sim, tsim_row_fn *fn, void *data);

/* Reads the tables of a file: a log of tsim, LIGGGHTS or LAMMPS (one for each run), a file of fix ave/time, ave/chunk,
 * ave/histo, ave/correlate or print (one for each block), comma-separated values; *n: their number, at least 1. */
TSIM_API int tsim_tables(struct tsim *sim, const char *path, size_t *n);
/* Table k, from 0, of the last tsim_tables, whose memory it is, valid until the next one. */
struct tsim_sheet {
	size_t size;
	const char *title; /* "run 2", "step 500"; "": the only table */
	size_t rows, columns;
};
TSIM_API int tsim_table(struct tsim *sim, size_t k, struct tsim_sheet *out);
/* Column c of table k: its name and its numbers, one for each row (each may be NULL). A NaN is a missing number. */
TSIM_API int tsim_table_column(struct tsim *sim, size_t k, size_t c, const char **name,
			       const double **values);

/* ---- particles ---- */

/* Number of particles. */
TSIM_API size_t tsim_count(struct tsim *sim);

/* Read or write a quantity by its script name, one number for each particle, in the present order of
 * particles in memory; n must be tsim_count. All quantities of tsim_quantity_name can be read. Can be
 * written: between runs type, x y z, vx vy vz, omegax .., ix iy iz, radius, diameter, mass, density; in
 * functions of tsim_on_step fx fy fz, tqx .. (a run begins by computing forces); NAME or NAME[k] of fix
 * property/atom like x. Writing a radius keeps the density; writing a density or mass keeps the radius. All
 * values are checked before the first one is written. */
TSIM_API int tsim_column_read(struct tsim *sim, const char *name, double *out, size_t n);
TSIM_API int tsim_column_write(struct tsim *sim, const char *name, const double *in, size_t n);
/* The same for the particles with these identities, in this order; id NULL: all particles, sorted by
 * identity (n = tsim_count). */
TSIM_API int tsim_gather(struct tsim *sim, const char *name, const int32_t *id, double *out, size_t n);
TSIM_API int tsim_scatter(struct tsim *sim, const char *name, const int32_t *id, const double *in, size_t n);
/* Name of quantity k, from 0; NULL at the end. */
TSIM_API const char *tsim_quantity_name(size_t k);

/* Direct access to a stored column: x, v, f, omega, torque, image (3 numbers for each particle), tag
 * (identity), type, mask (groups), radius, mass, and columns of styles. `data` points to count * width
 * elements and is valid while tsim_generation returns `generation`, which changes when particles are added,
 * deleted or reordered, also in steps. x, v and omega may be written between runs and at END_OF_STEP, f and
 * torque at any stage of a step, others not at all (use tsim_column_write, tsim_group_set). After a
 * writable view has been returned, each tsim_step compares all columns with those of the last step to
 * detect changes. */
enum tsim_type { TSIM_F64 = 1, TSIM_I32 = 3, TSIM_U32 = 4 };
struct tsim_view {
	size_t size;
	void *data;
	int type;	/* enum tsim_type */
	int writable;	/* at present */
	size_t element; /* bytes of one number */
	size_t width;	/* numbers for each particle */
	size_t count;	/* particles */
	uint64_t generation;
};
TSIM_API int tsim_column_view(struct tsim *sim, const char *name, struct tsim_view *out);
/* Keeps the memory of a view until tsim_release has been called as many times, even if the simulation uses
 * other memory by then: an outdated view has old values, and writing to it has no effect. tsim_close frees
 * all. For bindings to languages with references. */
TSIM_API int tsim_hold(struct tsim *sim, void *data);
TSIM_API void tsim_release(struct tsim *sim, const void *data);
TSIM_API uint64_t tsim_generation(struct tsim *sim);
/* Name of the stored column k, from 0; NULL at the end. */
TSIM_API const char *tsim_column_name(struct tsim *sim, size_t k);

/* Pairs of the contact list, as it was built last: all particles that were nearer to each other than the sum of their
 * radii plus the skin, but two immobile ones and pairs that are excluded. Each pair is there once, also across a periodic
 * face, with two indices in the present order of particles in memory. *n: number of pairs; the first `room` of them are
 * written to pair[0], pair[1] ..., 2 * room numbers (NULL if room is 0). TSIM_STATE: no list has been built since
 * particles were created, deleted or reordered. */
TSIM_API int tsim_pairs(struct tsim *sim, int32_t *pair, size_t room, size_t *n);

/* Numbers for the fix external of this ID, n of them: "force", three for each particle in the present order; "energies",
 * one for each; "energy", one for all together; "vector", any number, which scripts read as f_ID[k]. They are kept until
 * they are given again. "due": *value becomes 1 if this is a step in which pf/callback asks for forces, otherwise 0; a
 * function of tsim_on_step at TSIM_BEFORE_FORCE then gives them. */
TSIM_API int tsim_external(struct tsim *sim, const char *fix, const char *what, double *value, size_t n);

/* Particles to be created. Arrays of n elements, x and v of 3 n: x0 y0 z0 x1 ... All but x may be NULL,
 * with the defaults below. */
struct tsim_particles {
	size_t size;
	size_t n;
	const double *x;
	const double *v;       /* 0 */
	const int32_t *type;   /* 1 */
	const double *radius;  /* 0.5 */
	const double *density; /* from the `mass` of the type, else 1 */
};
/* Creates particles. Needs a box, in which the positions must be; along periodic axes they are wrapped. If
 * a value is wrong no particle is created. id: the n identities of the new particles, or NULL. Ends a run
 * of tsim_step. */
TSIM_API int tsim_create(struct tsim *sim, const struct tsim_particles *particles, int32_t *id);
/* Deletes the particles with these identities; if one does not exist TSIM_UNKNOWN, and none is deleted. */
TSIM_API int tsim_delete(struct tsim *sim, const int32_t *id, size_t n);

/* ---- groups ---- */

/* Bit of the group in the column `mask`, 0 to 31. */
TSIM_API int tsim_group_bit(struct tsim *sim, const char *name, int *bit);
/* Name of the group with this bit; NULL: none. */
TSIM_API const char *tsim_group_name(struct tsim *sim, int bit);
/* Sets member[i] to 1 if particle i, in the order of memory, is in the group, else to 0. */
TSIM_API int tsim_group_get(struct tsim *sim, const char *name, unsigned char *member, size_t n);
/* Sets the members of the group; creates it if it does not exist. */
TSIM_API int tsim_group_set(struct tsim *sim, const char *name, const unsigned char *member, size_t n);

/* ---- the state of the simulation ---- */

struct tsim_box {
	size_t size;
	int exists; /* after create_box or read_restart */
	int dimension;
	double lo[3], hi[3];
	int periodic[3];
	char face[3][2]; /* p, f, s or m as in `boundary`, for the low and the high face */
};
TSIM_API void tsim_box(struct tsim *sim, struct tsim_box *out);

/* Step counter, time and time step; each may be NULL. */
TSIM_API void tsim_clock(struct tsim *sim, int64_t *step, double *time, double *dt);

/* The value of a setting (tsim_setting_name). For thermo keywords use tsim_value. */
TSIM_API int tsim_setting(struct tsim *sim, const char *name, double *out);
/* Name of setting k, from 0, and its description (may be NULL); NULL at the end. */
TSIM_API const char *tsim_setting_name(size_t k, const char **help);

/* Instance k, from 0, of a kind (fix, compute, region, dump, pair, bond, flow), in script order: its ID,
 * and its style (may be NULL). NULL at the end, or if there is no such kind. */
TSIM_API const char *tsim_live(struct tsim *sim, const char *kind, size_t k, const char **style);

/* ---- kinds, styles and arguments: no simulation needed; strings are valid as long as the program ---- */

/* "1.2.3" */
TSIM_API const char *tsim_version(void);
/* Feature k, from 0, of this build ("threads", "png", "hdf5" ...), and the library and version that it is made
 * with, or "no" (may be NULL); NULL at the end. */
TSIM_API const char *tsim_feature(size_t k, const char **text);
/* "command", "fix", "pair" ...; NULL at the end. */
TSIM_API const char *tsim_kind(size_t k);
/* Style k, from 0, of a kind, sorted by name, and its summary (may be NULL); NULL at the end. */
TSIM_API const char *tsim_style(const char *kind, size_t k, const char **summary);
/* The manual page of a style, as plain text or as Markdown, truncated to `room` bytes; *length: full length
 * (may be NULL). TSIM_UNKNOWN: no such style; then the text is a message that suggests similar names. */
TSIM_API int tsim_help(const char *kind, const char *style, int markdown, char *out, size_t room,
		       size_t *length);

/* Argument k, from 0, of a style. Arguments of a mode (`create_atoms 1 random ...`) follow the argument that
 * selects the mode, and have its name in `mode`. */
struct tsim_argument {
	size_t size;
	const char *name, *help;
	const char *type;     /* "number", "whole number", "word" ... */
	const char *unit;     /* "" if it has none */
	const char *fallback; /* default as in a script, or NULL */
	const char *mode;     /* the mode it belongs to, or NULL */
	int positional, optional, nullable;
	double least, most; /* range, inclusive except 0 if `positive`; infinite: no limit */
	int positive;
	const char *const *choices; /* possible words, NULL-terminated; or NULL */
};
TSIM_API int tsim_argument(const char *kind, const char *style, size_t k, struct tsim_argument *out);

/* Initializer that sets the size: struct tsim_view view = TSIM_INIT(struct tsim_view); */
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
