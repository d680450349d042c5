/* Volume of the part of the unit ball beyond a corner: x >= a, y >= b, z >= c, x^2 + y^2 + z^2 <= 1,
 * for any a, b, c. The volume inside a box is the alternating sum over its eight corners. Exact to
 * rounding. */
#ifndef TS_GEOM_BALL_CORNER_H
#define TS_GEOM_BALL_CORNER_H

#include <stdbool.h>

double ts_ball_corner(double a, double b, double c);

/* The same for all eight corners of a ball that at most one plane across each axis cuts: out[i + 2 j + 4 k], where i,
 * j, k are 0 for a face below the ball and 1 for the plane at cut[0], cut[1], cut[2], -1 < cut < 1; without a plane
 * (`cuts` false) the numbers with this index 1 are not set. Bitwise the numbers of ts_ball_corner, in less time, since
 * corners share edges. */
void ts_ball_corners(const double cut[3], const bool cuts[3], double out[8]);

/* The same for the unit disc: area of x >= a, y >= b. */
double ts_ball_corner_disc(double a, double b);

#endif
