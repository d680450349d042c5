#include "average/chunk_user.h"

#include "rigid/mass_moments.h"

#include "base/banned.h"

enum ts_status ts_chunk_user_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_chunk_user *user = self->state;
	struct ts_instance *owner;
	struct ts_chunks *chunks;

	user->sim = sim;
	return ts_chunks_find(sim, self, user->id, &owner, &chunks);
}

void ts_chunk_user_fini(struct ts_instance *self)
{
	ts_table_release(&((struct ts_chunk_user *)self->state)->centre);
}

/* The chunks of the input; NULL: it has none. */
static enum ts_status find_chunks(struct tsim *sim, const struct ts_ref_input *input,
				  struct ts_chunks **chunks)
{
	const struct ts_instance *inst = input->quantity ? NULL : input->ref.inst;
	struct ts_instance *owner;

	*chunks = NULL;
	if (!inst || !inst->style->family || !ts_streq(inst->style->family, TS_FAMILY_CHUNK_USER))
		return TS_OK;
	return ts_chunks_find(sim, inst, ((const struct ts_chunk_user *)inst->state)->id, &owner, chunks);
}

enum ts_status ts_chunk_user_hold(struct tsim *sim, const struct ts_ref_input *input, int64_t until)
{
	struct ts_chunks *chunks;

	TS_TRY(find_chunks(sim, input, &chunks));
	if (chunks)
		ts_chunks_hold(chunks, until);
	return TS_OK;
}

enum ts_status ts_chunk_user_keeps(struct tsim *sim, const struct ts_ref_input *input, bool *keeps)
{
	struct ts_chunks *chunks;

	TS_TRY(find_chunks(sim, input, &chunks));
	*keeps = chunks && (chunks->number == TS_NUMBER_ONCE || chunks->ids == TS_CHUNK_IDS_ONCE);
	return TS_OK;
}

enum ts_status ts_chunk_user_assign(const struct ts_instance *self, struct ts_chunks **chunks)
{
	const struct ts_chunk_user *user = self->state;
	struct ts_instance *owner;

	TS_TRY(ts_chunks_find(user->sim, self, user->id, &owner, chunks));
	return ts_chunks_assign(owner, *chunks, TS_CHUNK_NO_SAMPLE);
}

static void mass_moment(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	(void)chunk, (void)context;
	ts_mass_moment(sim, i, term);
}

enum ts_status ts_chunk_centres(const struct ts_instance *self, const struct ts_chunks *chunks,
				struct ts_table *out)
{
	TS_TRY(ts_chunk_sum(chunks, self->group, 4, mass_moment, NULL, out));
	for (size_t k = 0; k < out->rows; k++) {
		double *row = out->data + 4 * k;

		for (int d = 0; d < 3; d++)
			row[d] = row[3] > 0 ? row[d] / row[3] : 0;
	}
	return TS_OK;
}

enum ts_status ts_chunk_moments(const struct ts_instance *self, size_t width, ts_chunk_term *term,
				struct ts_chunks **chunks, struct ts_table *out)
{
	struct ts_chunk_user *user = self->state;

	TS_TRY(ts_chunk_user_assign(self, chunks));
	TS_TRY(ts_chunk_centres(self, *chunks, &user->centre));
	return ts_chunk_sum(*chunks, self->group, width, term, &user->centre, out);
}

const double *ts_chunk_centre(const void *context, size_t chunk)
{
	const struct ts_table *centre = context;

	return centre->data + 4 * (chunk - 1);
}
