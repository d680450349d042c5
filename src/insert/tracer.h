/* Particles that are marked, by fix property/atom/tracer and its kin, to see where they go and when. */
#ifndef TS_INSERT_TRACER_H
#define TS_INSERT_TRACER_H

#include "particle/particles.h"

#define TS_FAMILY_TRACER "tracer"

/* First member of the state of every style of the family. */
struct ts_tracer {
	size_t column; /* of the particles: 1 marked, 0 not */
	bool started;
	/* saved */
	int64_t marked;		  /* so far */
	int64_t told;		  /* of them, when they were last asked for */
	int64_t answer, answered; /* in one step the answer stays; the step + 1 */
};
#define TS_TRACER_SAVED(T)                                                                         \
	TS_SAVE_I64(T, tracer.marked), TS_SAVE_I64(T, tracer.told), TS_SAVE_I64(T, tracer.answer), \
		TS_SAVE_I64(T, tracer.answered)

enum ts_status ts_tracer_init(struct ts_instance *self, struct tsim *sim);
/* For the archive function of the fix. */
enum ts_status ts_tracer_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive);
/* f_ID: how many have been marked since it was last asked, and of each particle whether it is. */
extern const struct ts_value ts_tracer_values[];

/* The marks of all particles, 1 or 0. */
double *ts_tracer_marks(const struct tsim *sim, const struct ts_tracer *tracer);
void ts_tracer_mark(const struct tsim *sim, struct ts_tracer *tracer, size_t i);
/* The tracer that the word names, or an error. */
enum ts_status ts_tracer_require(struct tsim *sim, const struct ts_word *id, struct ts_tracer **out);

#endif
