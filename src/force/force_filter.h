/* Projection of forces on a line or a plane: the common part of fix lineforce and fix planeforce. */
#ifndef TS_FORCE_FORCE_FILTER_H
#define TS_FORCE_FORCE_FILTER_H

#include "core/sim.h"

/* State of these fixes. */
struct ts_force_filter {
	double direction[3]; /* as in the script: direction of the line, or normal of the plane */
	double unit[3];
};

/* Slot init of these fixes: normalises the direction. */
enum ts_status ts_force_filter_init(struct ts_instance *self, struct tsim *sim);

/* f = along (f . e) e + across (f - (f . e) e) for the particles of the group; the loop is deferred. */
void ts_force_filter_apply(struct ts_instance *self, struct tsim *sim, double along, double across);
/* The same for one force: for restraints. */
void ts_force_filter_one(const struct ts_instance *self, double along, double across, double f[3]);

#endif
