/* Liquid on the surfaces of particles, for bridges (law/capillary.h): how much there is, and where
 * it goes when bridges break.
 *
 * Columns, by the particle's own volume: surfaceLiquidContent, what there is; liquidFlux, what
 * comes by time from the bridges that broke in the last step; liquidSource, what the user lets come
 * by time. Fluxes and sources arrive at the beginning of the next step: so all forces of a step,
 * and those of the set-up of a run that goes on, see the same liquid. */
#ifndef TS_CONTACT_LIQUID_H
#define TS_CONTACT_LIQUID_H

#include "core/sim.h"

struct ts_pair;

struct ts_liquid {
	size_t content, flux, source; /* columns */
};

/* The columns; then, in init, what particles start with that have no liquid yet:
 * surfaceLiquidContentInitial. */
enum ts_status ts_liquid_columns(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *liquid);
enum ts_status ts_liquid_init(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *liquid);
enum ts_status ts_liquid_archive(struct tsim *sim, struct ts_archive *archive, struct ts_liquid *liquid);
/* In INITIAL_INTEGRATE: what is under way arrives. */
void ts_liquid_advance(struct tsim *sim, const struct ts_liquid *liquid);

/* After the forces: bridges have broken (rows->bridges_broken). Their liquid goes to the partners as their
 * volumes are. */
enum ts_status ts_liquid_share(struct tsim *sim, const struct ts_pair *pair);

/* While forces are computed: the row, whose surfaces have just come apart, had a bridge that broke.
 */
enum { TS_BRIDGE_BROKEN = -1 };

#endif
