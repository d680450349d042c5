/* The sums of the rows' forces and torques over the particles, and where particles are. */
#include "base/clones.h"
#include "base/four.h"
#include "neigh/rows.h"

#include "base/banned.h"

static const double signs[] = { 1, -1 }; /* a table: which side cannot be guessed */

TS_INLINE void add(double to[3], const ts_four *sum)
{
	for (int d = 0; d < 3; d++)
		to[d] += (*sum)[d];
}

/* `parts` as in struct ts_rows. */
TS_INLINE void gather(const struct ts_rows *rows, const struct ts_particles *p, size_t from, size_t to, size_t parts)
{
	const size_t *first = rows->gather.first;
	const uint32_t *sum = rows->sum;
	const ts_four *results = (const ts_four *)rows->result;

	for (size_t i = from; i < to; i++) {
		ts_four f = { 0 }, torque = { 0 };
		double radius = rows->place[i][3];

		for (size_t k = first[i]; k < first[i + 1]; k++) {
			const ts_four *result = results + parts * (sum[k] >> 1);
			double sign = signs[sum[k] & 1];

			f += sign * result[0];
			if (parts > 2)
				torque += (radius - result[0][3]) * result[1] + sign * result[2];
			else if (parts > 1)
				torque += (radius - result[0][3]) * result[1];
		}
		add(p->f[i], &f);
		if (parts > 1)
			add(p->torque[i], &torque);
	}
}

#define GATHER(name, parts)                                                                                  \
	TS_CLONES static void name(const struct ts_rows *rows, const struct ts_particles *p, size_t from,    \
				   size_t to)                                                                \
	{                                                                                                    \
		gather(rows, p, from, to, parts);                                                            \
	}
GATHER(gather_forces, 1)
GATHER(gather_turns, 2)
GATHER(gather_rolls, 3)

ts_rows_gather_fn *ts_rows_gatherer(const struct ts_rows *rows)
{
	return rows->parts > 2 ? gather_rolls : rows->parts > 1 ? gather_turns : gather_forces;
}

TS_CLONES static void place(const struct ts_particles *p, double (*out)[4], size_t from, size_t to)
{
	for (size_t i = from; i < to; i++) {
		ts_four four = TS_FOUR_AT(p->x[i]);

		four[3] = p->radius[i];
		*(ts_four *)out[i] = four;
	}
}

void ts_rows_place(const struct ts_particles *p, struct ts_rows *rows, size_t from, size_t to)
{
	place(p, rows->place, from, to);
}

/* The rows of particles from .. to-1. */
static struct ts_row_chunk rows_of(const struct ts_gather *g, size_t from, size_t to)
{
	struct ts_row_chunk c = { SIZE_MAX, 0 };

	for (size_t k = g->first[from]; k < g->first[to]; k++) {
		size_t r = g->entry[k] >> 1;

		c.first = r < c.first ? r : c.first;
		c.end = r >= c.end ? r + 1 : c.end;
	}
	return c.end ? c : (struct ts_row_chunk){ 0 };
}

enum ts_status ts_rows_chunks(struct ts_rows *rows)
{
	size_t n = rows->particles;

	rows->chunks = (n + TS_ROW_CHUNK - 1) / TS_ROW_CHUNK;
	TS_TRY(TS_GROW(rows->chunk, rows->chunk_capacity, rows->chunks));
	TS_TRY(TS_GROW(rows->gathered, rows->gathered_capacity, rows->chunks));
	for (size_t c = 0; c < rows->chunks; c++)
		rows->chunk[c] = rows_of(&rows->gather, c * TS_ROW_CHUNK,
					 c + 1 < rows->chunks ? (c + 1) * TS_ROW_CHUNK : n);
	return TS_OK;
}
