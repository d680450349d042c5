/* Shared by the computes .../chunk, which sum over the chunks of a compute chunk/atom. */
#ifndef TS_AVERAGE_CHUNK_USER_H
#define TS_AVERAGE_CHUNK_USER_H

#include "average/chunk.h"

/* Family of these computes. First member of their state. */
#define TS_FAMILY_CHUNK_USER "chunk_user"
struct ts_chunk_user {
	const char *id;		/* of the compute chunk/atom */
	struct ts_table centre; /* [chunk][4]: centre of mass, mass; vcm and temp/chunk: momentum, mass */
	struct tsim *sim;
};
#define TS_CHUNK_USER_ARG(T)                                                 \
	TS_WORD("chunkID", T, user.id, .flags = TS_POSITIONAL | TS_STATEFUL, \
		.help = "ID of the compute chunk/atom")

#define TS_CHUNK_OF_CLUMPS \
	"A clump (fix multisphere) counts as a body: each of its spheres in the chunk adds its share of it."

/* Slots of struct ts_style. */
enum ts_status ts_chunk_user_init(struct ts_instance *self, struct tsim *sim);
void ts_chunk_user_fini(struct ts_instance *self);

/* For the first sample of an average of the input: the chunks of a compute .../chunk stay until this step. */
enum ts_status ts_chunk_user_hold(struct tsim *sim, const struct ts_ref_input *input, int64_t until);

/* Assigns the particles to chunks at their current positions. */
enum ts_status ts_chunk_user_assign(const struct ts_instance *self, struct ts_chunks **chunks);
/* Centre of mass of each chunk, from unwrapped positions, and its mass: 4 columns. */
enum ts_status ts_chunk_centres(const struct ts_instance *self, const struct ts_chunks *chunks,
				struct ts_table *out);
/* Assigns particles to chunks, computes the centres of mass into user.centre, then the sums of `width`
 * numbers by ts_chunk_sum; `context` of `term` is the table of centres. */
enum ts_status ts_chunk_moments(const struct ts_instance *self, size_t width, ts_chunk_term *term,
				struct ts_chunks **chunks, struct ts_table *out);
/* Centre of mass of the chunk, for a `term` of ts_chunk_moments. */
const double *ts_chunk_centre(const void *context, size_t chunk);

/* *keeps: whether an evaluation of this input determines its chunks, or which particles they have, for good (`nchunk once`,
 * `ids once`). */
enum ts_status ts_chunk_user_keeps(struct tsim *sim, const struct ts_ref_input *input, bool *keeps);

#endif
