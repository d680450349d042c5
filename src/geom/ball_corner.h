/* Volume of the part of the unit ball beyond a corner: x >= a, y >= b, z >= c, x^2 + y^2 + z^2 <= 1,
 * for any a, b, c. The volume inside a box is the alternating sum over its eight corners. Exact to
 * rounding. */
#ifndef TS_GEOM_BALL_CORNER_H
#define TS_GEOM_BALL_CORNER_H

double ts_ball_corner(double a, double b, double c);

/* The same for the unit disc: area of x >= a, y >= b. */
double ts_ball_corner_disc(double a, double b);

#endif
