/* Forces of particles along a line or in a plane: what fix lineforce and planeforce share. */
#ifndef TS_FORCE_FORCE_FILTER_H
#define TS_FORCE_FORCE_FILTER_H

#include "core/sim.h"

/* State of the fixes. */
struct ts_force_filter {
	double direction[3]; /* as given: of the line, or normal to the plane */
	double unit[3];
};

/* Slot init. */
enum ts_status ts_force_filter_init(struct ts_instance *self, struct tsim *sim);

/* f = along (f . e) e + across (f - (f . e) e) for the particles of the group. */
void ts_force_filter_apply(struct ts_instance *self, struct tsim *sim, double along, double across);
/* The same of one force: for restraints. */
void ts_force_filter_one(const struct ts_instance *self, double along, double across, double f[3]);

#endif
