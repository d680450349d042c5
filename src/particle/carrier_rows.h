/* Rows of the styles with a carrier (core/carried.h), which go to the ranks of their particles. */
#ifndef TS_PARTICLE_CARRIER_ROWS_H
#define TS_PARTICLE_CARRIER_ROWS_H

#include "particle/division.h"

/* The live styles with a carrier, in the order of kinds: *kind and *k start at 0; NULL: there are no more. */
struct ts_instance *ts_carrier_next(const struct tsim *sim, int *kind, size_t *k);

/* d->carried become the rows that all carriers give, see struct ts_carrier; are taken by them; are forgotten. */
enum ts_status ts_carrier_rows_give(struct tsim *sim, struct ts_division *d, bool results,
				    const struct ts_leaving *leaving);
enum ts_status ts_carrier_rows_take(struct tsim *sim, struct ts_division *d);
void ts_carrier_rows_release(struct ts_division *d);

/* Puts each row into the parcel of rank to[i], where i is its particle; without `to` into parcel 0. Rows of particles
 * that this rank does not have are appended to `away`, or left out if it is NULL. */
enum ts_status ts_carrier_rows_sort(struct tsim *sim, const struct ts_carried *rows, const int32_t *to,
				    struct ts_parcel *out, struct ts_carried *away);
/* The parcels of the division for other ranks, empty. */
struct ts_parcel *ts_carrier_rows_parcels(const struct tsim *sim);
/* Sends out[r] to each rank r; the rows become what is received. */
enum ts_status ts_carrier_rows_deliver(struct tsim *sim, struct ts_carried *rows, struct ts_parcel *out);
/* Leaves out the rows of particles of other ranks. */
enum ts_status ts_carrier_rows_keep_local(struct tsim *sim, struct ts_carried *rows);
/* Rows of copies are sent to the ranks of their originals. */
enum ts_status ts_carrier_rows_send_home(struct tsim *sim, struct ts_carried *rows,
					 const struct ts_copy_map *copy);

#endif
