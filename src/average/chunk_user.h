/* What computes that sum over the chunks of a compute chunk/atom have in common. */
#ifndef TS_AVERAGE_CHUNK_USER_H
#define TS_AVERAGE_CHUNK_USER_H

#include "average/chunk.h"

/* First member of their state. */
struct ts_chunk_user {
	const char *id;
	struct ts_table centre; /* of mass, and mass */
	struct tsim *sim;
};
#define TS_CHUNK_USER_ARG(T) \
	TS_WORD("chunkID", T, user.id, .flags = TS_POSITIONAL | TS_STATEFUL, .help = "the compute chunk/atom")

/* Slots of struct ts_style. */
enum ts_status ts_chunk_user_init(struct ts_instance *self, struct tsim *sim);
void ts_chunk_user_fini(struct ts_instance *self);

/* The chunks as of now. */
enum ts_status ts_chunk_user_now(const struct ts_instance *self, struct ts_chunks **chunks);
/* Their centres of mass, without periodic wrapping, and their masses: 4 columns. */
enum ts_status ts_chunk_centres(const struct ts_instance *self, const struct ts_chunks *chunks,
				struct ts_table *out);
/* The chunks and, in user.centre, their centres; then the sums of `width` numbers with the centres as
 * context. */
enum ts_status ts_chunk_moments(const struct ts_instance *self, size_t width, ts_chunk_term *term,
				struct ts_chunks **chunks, struct ts_table *out);
/* Vector from the centre of a chunk, in a context made by ts_chunk_moments, to particle i. */
void ts_chunk_arm(const struct tsim *sim, size_t i, size_t chunk, const void *context, double d[3]);

#endif
