/* tsim: granular particles, bonds and drilling, as a C library.
 *
 *   struct tsim *sim = tsim_open();
 *   if (!sim || tsim_file(sim, "in.drilling") || tsim_value(sim, "ke", &ke))
 *           fputs(tsim_error(sim), stderr);
 *   tsim_close(sim);
 *
 * Functions of type int return 0 on success, else a code from 1 on; tsim_error then says what was
 * wrong and where. After an error the simulation may be closed, or used on after
 * tsim_error_clear. Several simulations can live in one process, each used by one thread at a time.
 * Nothing is printed unless tsim_screen or tsim_log asks for it. */
#ifndef TSIM_H
#define TSIM_H

#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

struct tsim;

/* A new simulation; NULL: out of memory. */
struct tsim *tsim_open(void);
/* Ends it and closes its files. sim may be NULL. */
void tsim_close(struct tsim *sim);

/* "1.2.3" */
const char *tsim_version(void);

/* Runs one script line, a text of several, a file, or a stream to its end. */
int tsim_line(struct tsim *sim, const char *line);
int tsim_string(struct tsim *sim, const char *text);
int tsim_file(struct tsim *sim, const char *path);
int tsim_stream(struct tsim *sim, FILE *stream, const char *name);

/* Sets an index variable, which wins over the script's own `variable NAME index ...`. */
int tsim_variable(struct tsim *sim, const char *name, const char *value);
/* The value of a formula: "v_name", "c_ID[2]", "ke", "2*PI*v_radius" ... */
int tsim_value(struct tsim *sim, const char *formula, double *out);

/* Particles. A column is a per-particle quantity by its script name: id, type, x, y, z, vx, vy, vz,
 * fx, fy, fz, mass, radius ... in the order of the particles at this moment; n must be the number
 * tsim_count gives. x, y, z, vx, vy, vz can be written. */
size_t tsim_count(struct tsim *sim);
int tsim_column_read(struct tsim *sim, const char *name, double *out, size_t n);
int tsim_column_write(struct tsim *sim, const char *name, const double *in, size_t n);

/* The last error, with file, line, column and the line itself; "" if there was none. The text is
 * valid until the next call. sim may be NULL: out of memory. */
const char *tsim_error(struct tsim *sim);
void tsim_error_clear(struct tsim *sim);

/* Where output goes; NULL: nowhere, which is so at the start. The stream stays the caller's. */
void tsim_screen(struct tsim *sim, FILE *stream);
/* path NULL: no log file. */
int tsim_log(struct tsim *sim, const char *path);

/* Lets a running simulation stop after its present step. May be called from a signal handler. */
void tsim_stop(struct tsim *sim);

#ifdef __cplusplus
}
#endif
#endif
