/* Where the forces and torques of rows stand.
 *
 * Most runs need them only until both partners have added them up. Then near rows are given slots as a compiler
 * gives registers: particles are gathered in chunks as soon as all their rows are computed, and the slots of rows
 * that both partners have seen are used again. So few slots are in use at any time, and they stay in the caches.
 * Where an output may look at contacts, all results are kept: row r has slot r. */
#ifndef TS_NEIGH_ROW_SLOTS_H
#define TS_NEIGH_ROW_SLOTS_H

#include "base/inline.h"
#include "neigh/rows.h"

/* So many blocks are computed before chunks of particles are looked for whose rows are done. */
enum { TS_ROW_TURN = 8 };

/* Chooses the rows that are looked at, if they have to be chosen anew, and gives them slots; `kept`: all results
 * will be looked at. */
enum ts_status ts_rows_prepare(struct tsim *sim, struct ts_rows *rows, bool kept);
/* Results of all rows that can be looked at, though no force has been computed: zero. */
enum ts_status ts_rows_keep(struct tsim *sim, struct ts_rows *rows);

/* The next chunk, from the *c-th on, whose near rows are all among from .. done-1; behind the last: rows->chunks.
 * *c goes on to the first that has to wait. */
TS_INLINE size_t ts_row_chunk_done(const struct ts_rows *rows, size_t from, size_t done, size_t *c)
{
	for (; *c < rows->chunks && rows->chunk[*c].end <= done; ++*c)
		if (rows->chunk[*c].first >= from && rows->chunk[*c].end > 0)
			return (*c)++;
	return rows->chunks;
}

#endif
