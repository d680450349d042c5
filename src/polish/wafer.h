/* A rigid wafer on a ball joint, pressed onto a pad of springs (Winkler foundation).
 *
 * The face of the wafer has the height z + s_1 x_1 + s_2 x_2 at the place x, measured from below the joint; slopes are
 * small. Column k of the pad, of height h_k, area A_k and place x_k, presses with
 *
 *   p_k = min(stiffness (h_k - z - s x_k), hardness) >= 0.
 *
 * Back pressure P on the area A of the face, and friction mu N of the pad that slides in the direction u, on the face, a
 * distance `arm` below the joint, give the generalized forces on z and s_d
 *
 *   sum p_k A_k - P A,   sum p_k A_k x_kd + mu N arm u_d:
 *
 * friction presses the leading edge, which the pad meets first, into the pad. */
#ifndef TS_POLISH_WAFER_H
#define TS_POLISH_WAFER_H

#include <stddef.h>

#include "base/status.h"

/* A column of the pad below the wafer, or a part of one. */
struct ts_wafer_column {
	double x[2], area, height; /* length, length^2, length */
};

struct ts_wafer {
	const struct ts_wafer_column *column;
	size_t n;
	double stiffness, hardness; /* pressure/length; pressure, INFINITY: elastic */
	double load;		    /* P A, force, > 0 */
	double friction[2];	    /* mu arm u, length */
};

struct ts_wafer_pose {
	double z, slope[2];
};

struct ts_wafer_forces {
	double normal, moment[2]; /* sums of p A and p A x_d */
	double area;		  /* of the columns in contact */
	double energy;		  /* of the springs and of what has yielded */
	double stiffness[3][3];	  /* change of -(normal, moment) with (z, slope) */
};

void ts_wafer_forces(const struct ts_wafer *w, const struct ts_wafer_pose *pose, struct ts_wafer_forces *out);
/* The pose in which all forces balance, N = P A, from any pose. The energy is convex, so it is the only one. Returns
 * TS_OK, or TS_PHYSICS: the pad cannot carry the load, or not the moment of friction. */
enum ts_status ts_wafer_settle(const struct ts_wafer *w, struct ts_wafer_pose *pose);

#endif
