/* Creation and deletion of a simulation and of its live styles. */
#ifndef TS_CORE_LIFE_H
#define TS_CORE_LIFE_H

#include "core/sim.h"

/* sim->threads is OMP_NUM_THREADS if that is set, else 1. NULL: out of memory. */
struct tsim *ts_sim_new(const struct ts_tables *tables);
void ts_sim_free(struct tsim *sim);
/* Command `clear`: resets everything but log, error, string pool and script interpreter. */
enum ts_status ts_sim_clear(struct tsim *sim);
/* Completes the files of all instances (slot `close`), after the script. The first error is returned. */
enum ts_status ts_sim_close(struct tsim *sim);

/* Creates, parses and initialises an instance. On failure the simulation is unchanged. An instance of the
 * same id and style is replaced in its place (LIGGGHTS); the same id with another style is refused. `id`
 * may be "" (pair, bond, flow, automaton: replaces the live one). `out` may be NULL. */
enum ts_status ts_sim_create(struct tsim *sim, enum ts_kind kind, const struct ts_style *style,
			     const char *id, int group, struct ts_words args, const struct ts_place *where,
			     struct ts_instance **out);
/* For kinds with at most one live instance: creates it from a line `STYLE arguments`; `none` deletes it. */
enum ts_status ts_sim_choose(struct tsim *sim, enum ts_kind kind, struct ts_words line,
			     const struct ts_place *where);
enum ts_status ts_sim_destroy(struct tsim *sim, enum ts_kind kind, const struct ts_word *id);
/* Deletes an instance to which others may point: it is not found any more, and is freed with the
 * simulation. */
enum ts_status ts_sim_retire(struct tsim *sim, enum ts_kind kind, const struct ts_word *id);

/* Executes a command given by its words (word 0 is its name). */
enum ts_status ts_sim_command(struct tsim *sim, struct ts_words words);

#endif
