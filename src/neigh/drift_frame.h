/* Displacements relative to a moving frame.
 *
 * Two particles approach each other by at most |d_i - u| + |d_j - u|, d their displacements since the last rebuild and u
 * any vector. So the list is valid while no particle has moved farther than half the skin from the displacement u of a
 * frame, which moves with the mean of the least and the largest velocity at the rebuild: where particles fall onto a bed,
 * half as fast as they. Walls do not move with the frame. Their lists contain the particles within one skin; therefore
 * |u| is at most half the skin, and a wall may move by the rest of this half (ts_drift_frame_room_of_walls). */
#ifndef TS_NEIGH_DRIFT_FRAME_H
#define TS_NEIGH_DRIFT_FRAME_H

#include <stdbool.h>

struct tsim;

struct ts_drift_frame {
	double velocity[3]; /* length/time; 0: the frame is at rest */
	double shift[3];    /* u, its displacement since the last rebuild, length */
};

/* Velocities of the local particles, length/time. */
struct ts_drift_frame_speeds {
	double centre[3];     /* of the box around all velocities */
	double most;	      /* the largest |v| */
	double most_relative; /* the largest |v - centre| */
};
void ts_drift_frame_speeds(const struct tsim *sim, struct ts_drift_frame_speeds *out);

/* Whether a moving frame is worth its cost: the particles are much slower relative to it. */
bool ts_drift_frame_pays(const struct ts_drift_frame_speeds *speeds);
/* Moves the frame by one step, unless it would be farther than half of the skin from where it was. */
void ts_drift_frame_advance(struct ts_drift_frame *frame, double dt, double skin);
/* How far walls may have moved since the last rebuild before the next one is due, length. */
double ts_drift_frame_room_of_walls(const struct tsim *sim);

#endif
