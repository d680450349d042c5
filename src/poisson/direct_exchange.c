#include "poisson/direct_exchange.h"

#include "rank/transposition.h"

#include "base/banned.h"

/* Modes of its strips. */
static void modes_of(const void *solver, int rank, size_t from[2])
{
	const struct ts_direct *s = solver;
	const size_t modes = (size_t)s->n[0] * (size_t)s->n[1], width = s->strip;
	const size_t strips = (modes + width - 1) / width;

	for (int k = 0; k < 2; k++) {
		from[k] = width * ts_slabs_part(s->slabs, rank + k, strips);
		from[k] = from[k] < modes ? from[k] : modes;
	}
}

static struct ts_transposition transposition(const struct ts_direct *s)
{
	return (struct ts_transposition){ .slabs = s->slabs,
					  .field = { .first = s->work, .stride = s->plane },
					  .columns = modes_of,
					  .of = s };
}

enum ts_status ts_direct_divide(struct ts_direct *s, struct ts_slabs *slabs)
{
	const bool was = slabs && slabs->active;
	struct ts_transposition t;
	enum ts_status status;

	s->slabs =
		slabs && slabs->world && s->axis[2] == 2 && s->n[1] > 1 && s->n[2] == slabs->n ? slabs : NULL;
	if (!s->slabs)
		return TS_OK;
	slabs->active = true; /* as it will be */
	t = transposition(s);
	status = ts_transposition_room(&t);
	slabs->active = was;
	return status;
}

bool ts_direct_divided(const struct ts_direct *s)
{
	return ts_slabs_ranks(s->slabs) > 1;
}

void ts_direct_exchange(const struct ts_direct *s, bool back)
{
	const struct ts_transposition t = transposition(s);

	if (ts_direct_divided(s))
		ts_transpose(&t, back);
}

void ts_direct_rehearse(const struct ts_direct *s)
{
	ts_direct_exchange(s, false);
	ts_direct_exchange(s, true);
}
