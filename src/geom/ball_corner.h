/* How much of the unit ball lies beyond a corner: the volume of x >= a, y >= b, z >= c, x^2 + y^2 + z^2 <=
 * 1, for any a, b, c. What lies in a box is the alternating sum over its eight corners. Exact to
 * round-off. */
#ifndef TS_GEOM_BALL_CORNER_H
#define TS_GEOM_BALL_CORNER_H

double ts_ball_corner(double a, double b, double c);

/* The same of the unit disc: the area of x >= a, y >= b. */
double ts_ball_corner_disc(double a, double b);

#endif
