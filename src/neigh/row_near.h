/* Which rows are looked at.
 *
 * Rows are built of all pairs that may touch before the next rebuild, but in a few steps only those can that are
 * already near: nearer than `gap` beyond touch. These are listed in blocks of one law each, and the others not
 * looked at until any two particles may have come nearer to each other by the gap. So no touch is missed, and the
 * gap only decides the cost. */
#ifndef TS_NEIGH_ROW_NEAR_H
#define TS_NEIGH_ROW_NEAR_H

#include "neigh/rows.h"

/* Notes where all particles are, and how far they may have come nearer since near rows were chosen; for local ones that
 * have come to their places in this step this may be done before, in a pass that waits (core/sweep.h). */
void ts_rows_place_locals(struct tsim *sim, struct ts_rows *rows);
void ts_rows_place(const struct tsim *sim, struct ts_rows *rows);

/* Whether a row that is not listed may touch. */
bool ts_rows_outdated(const struct ts_rows *rows);

/* Lists the near rows of each of rows->shares shares, with slots that are their own numbers; rows->at says where. */
#define TS_ROW_FAR UINT32_MAX
enum ts_status ts_rows_choose(struct tsim *sim, struct ts_rows *rows);

#endif
