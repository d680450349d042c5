/* Changes of bodies by fixes that change particles: motion and place, which members follow; of size and mass, which are refused. */
#ifndef TS_RIGID_RIGID_CHANGE_H
#define TS_RIGID_RIGID_CHANGE_H

#include "rigid/rigid.h"

/* A rigid motion: the velocity v + omega x (x - centre) at x. */
struct ts_rigid_motion {
	double v[3], omega[3], centre[3];
};

/* Fails if a body has some, but not all of its members in the group. `who`: whose group it is, for the message. */
enum ts_status ts_rigid_require_whole(struct tsim *sim, int group, const char *who,
				      const struct ts_place *where);

/* Fails if the group has members of bodies, whose mass and moments of inertia would not follow other sizes and masses of
 * their particles. */
enum ts_status ts_rigid_refuse_resizing(struct tsim *sim, int group, const char *who,
					const struct ts_place *where);

/* Subtracts a motion from that of the bodies with all members in the group, or of the clumps among them, but not in
 * directions in which a body is held. */
enum ts_status ts_rigid_subtract_motion(struct tsim *sim, int group, bool clumps,
					const struct ts_rigid_motion *motion);
/* Multiplies velocities of these bodies; of clumps, which have no other velocity of translation, that of the centre of mass;
 * of others those of all members. */
enum ts_status ts_rigid_scale_motion(struct tsim *sim, int group, double factor);

/* Displaces the bodies that have a member in the group. */
enum ts_status ts_rigid_shift(struct tsim *sim, int group, const double shift[3]);

#endif
