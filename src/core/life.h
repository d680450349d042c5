/* The life of a simulation and of its styles: they are made from lines of a script, replaced, deleted. */
#ifndef TS_CORE_LIFE_H
#define TS_CORE_LIFE_H

#include "core/sim.h"

/* threads 0: as OMP_NUM_THREADS says, else 1. NULL: out of memory. */
struct tsim *ts_sim_new(const struct ts_tables *tables);
void ts_sim_free(struct tsim *sim);
/* `clear`: everything but log, error, strings, host. */
enum ts_status ts_sim_clear(struct tsim *sim);

/* Creates, parses and initialises an instance. On failure nothing stays behind. An id in use is
 * replaced in place if it is of the same style (LIGGGHTS), else refused. `id` may be "" (pair, bond,
 * flow: replaces the one that lives). `out` may be NULL. */
enum ts_status ts_sim_create(struct tsim *sim, enum ts_kind kind, const struct ts_style *style,
			     const char *id, int group, struct ts_words args, const struct ts_place *where,
			     struct ts_instance **out);
/* For kinds of which one lives at most: creates it from a line `STYLE arguments`; `none`: there is none. */
enum ts_status ts_sim_choose(struct tsim *sim, enum ts_kind kind, struct ts_words line,
			     const struct ts_place *where);
enum ts_status ts_sim_destroy(struct tsim *sim, enum ts_kind kind, const struct ts_word *id);
/* The same for one that others refer to: it is found no more, and freed with all. */
enum ts_status ts_sim_retire(struct tsim *sim, enum ts_kind kind, const struct ts_word *id);

/* Runs a command by its words (word 0 is its name). */
enum ts_status ts_sim_command(struct tsim *sim, struct ts_words words);

#endif
