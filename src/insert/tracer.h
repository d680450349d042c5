/* Marks of particles for residence times: fix property/atom/tracer and property/atom/tracer/stream. */
#ifndef TS_INSERT_TRACER_H
#define TS_INSERT_TRACER_H

#include "particle/particles.h"

#define TS_FAMILY_TRACER "tracer"

/* First member of the state of every style of the family. */
struct ts_tracer {
	size_t column; /* index of the column: 1 marked, 0 not */
	bool started;
	/* saved */
	int64_t marked;		  /* particles marked so far */
	int64_t told;		  /* value of `marked` at the last evaluation of f_ID */
	int64_t answer, answered; /* result of that evaluation, the same for all in a step; its step + 1 */
};
#define TS_TRACER_SAVED(T)                                                                         \
	TS_SAVE_I64(T, tracer.marked), TS_SAVE_I64(T, tracer.told), TS_SAVE_I64(T, tracer.answer), \
		TS_SAVE_I64(T, tracer.answered)

/* Adds the column of marks. */
enum ts_status ts_tracer_init(struct ts_instance *self, struct tsim *sim);
/* For the archive function of the fix. */
enum ts_status ts_tracer_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
/* f_ID: number of particles marked since its last evaluation; and the mark of each particle. */
extern const struct ts_value ts_tracer_values[];

/* The marks of all particles, 1 or 0; and marks particle i. */
double *ts_tracer_marks(const struct tsim *sim, const struct ts_tracer *tracer);
void ts_tracer_mark(const struct tsim *sim, struct ts_tracer *tracer, size_t i);
/* Finds the tracer with this fix ID, or fails. */
enum ts_status ts_tracer_require(struct tsim *sim, const struct ts_word *id, struct ts_tracer **out);

#endif
