/* Liquid on the surfaces of particles, for liquid bridges (law/capillary.h): its amount, and its
 * redistribution when bridges break.
 *
 * Columns, relative to the volume of the particle: surfaceLiquidContent, the present amount; liquidFlux, per
 * time, what the bridges that broke in the last step give to the particle; liquidSource, per time, what the
 * user adds. Fluxes and sources are added at the beginning of the next step, so that all forces of a step,
 * and those of the set-up of a continued run, use the same amounts. */
#ifndef TS_CONTACT_LIQUID_H
#define TS_CONTACT_LIQUID_H

#include "core/sim.h"

struct ts_liquid {
	size_t content, flux, source; /* indices of the particle columns */
};

/* Makes the columns; then, in init, sets particles without a liquid content to surfaceLiquidContentInitial.
 */
enum ts_status ts_liquid_columns(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *liquid);
enum ts_status ts_liquid_init(struct tsim *sim, const struct ts_instance *self, struct ts_liquid *liquid);
enum ts_status ts_liquid_archive(struct tsim *sim, struct ts_archive *archive, struct ts_liquid *liquid);
/* In INITIAL_INTEGRATE: adds flux and source of one step to the content. */
void ts_liquid_advance(struct tsim *sim, const struct ts_liquid *liquid);

#endif
