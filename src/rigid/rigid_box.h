/* Rigid bodies in a box that changes its size. */
#ifndef TS_RIGID_RIGID_BOX_H
#define TS_RIGID_RIGID_BOX_H

#include "rigid/rigid.h"

/* To be called before the box gets the faces lo, hi: bodies stay where they are in the box, as single particles do, so that
 * their unwrapped positions change by that of their images. With `map` the centres of mass of bodies with a member in
 * the group are mapped affinely with the box; their members keep their places in the body. */
enum ts_status ts_rigid_change_box(struct tsim *sim, const double lo[3], const double hi[3], bool map,
				   int group);

#endif
