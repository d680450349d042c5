/* If the corner is inside the ball, the piece is bounded by three plane sectors and a part of the
 * sphere. By Gauss' theorem about the centre its volume is (S - a A_a - b A_b - c A_c)/3, with the area
 * S on the sphere and the area A_a of the plane x = a, a sector of the disc of radius s = sqrt(1 -
 * a^2). S follows from the Gauss-Bonnet theorem: its edges are arcs of small circles of angle t_a and
 * geodesic curvature a/s, which meet at the exterior angles acos(-ab/sqrt((1 - a^2)(1 - b^2))):
 *
 *   S = 2 pi - sum of exterior angles - sum of a t_a.
 *
 * For a corner outside the ball without negative coordinates the volume is 0. Negative coordinates are
 * reflected: the volume beyond (a, b, -c) is the volume beyond (a, b) minus that beyond (a, b, c). */
#include "geom/ball_corner.h"

#include <math.h>

#include "geom/ball_edges.h"

#include "base/banned.h"

/* Area and angle of the sector y >= b, z >= c of a disc of radius^2 s2; the corner must be inside. */
static double sector_area(double s2, double b, double c, double *angle)
{
	double s = sqrt(s2);

	*angle = s > 0 ? acos(ts_ball_clamp(b / s)) - asin(ts_ball_clamp(c / s)) : 0;
	return 0.5 *
	       (s2 * *angle - b * (sqrt(fmax(s2 - b * b, 0)) - c) - c * (sqrt(fmax(s2 - c * c, 0)) - b));
}

static double exterior_angle(double a, double b)
{
	return acos(ts_ball_clamp(-a * b / sqrt((1 - a * a) * (1 - b * b))));
}

/* a, b, c >= 0 */
static double positive_corner_volume(double a, double b, double c)
{
	double ta, tb, tc, flat, round;

	if (a * a + b * b + c * c >= 1)
		return 0;
	flat = a * sector_area(1 - a * a, b, c, &ta) + b * sector_area(1 - b * b, c, a, &tb) +
	       c * sector_area(1 - c * c, a, b, &tc);
	round = 2 * TS_PI - exterior_angle(a, b) - exterior_angle(b, c) - exterior_angle(c, a) - a * ta -
		b * tb - c * tc;
	return fmax((round - flat) / 3, 0);
}

/* x >= a, y >= b, z >= 0 with a, b >= 0: the corner (a, b, 0) in the same arithmetic, without the angles that are
 * right or zero there. */
static double positive_edge_volume(double a, double b)
{
	static const double right = TS_PI / 2;
	double sa = 1 - a * a, sb = 1 - b * b, ra = sqrt(sa), rb = sqrt(sb), ta, tb, flat, round;

	if (a * a + b * b >= 1)
		return 0;
	ta = acos(ts_ball_clamp(b / ra));
	tb = right - asin(ts_ball_clamp(a / rb));
	flat = a * (0.5 * (sa * ta - b * sqrt(fmax(sa - b * b, 0)))) +
	       b * (0.5 * (sb * tb - a * (sqrt(fmax(sb - a * a, 0)))));
	round = 2 * TS_PI - exterior_angle(a, b) - right - right - a * ta - b * tb;
	return fmax((round - flat) / 3, 0);
}

/* x >= a, y >= b */
static double edge_volume(double a, double b)
{
	if (a >= 1 || b >= 1)
		return 0;
	if (a < 0)
		return ts_ball_cap(b) - edge_volume(-a, b);
	if (b < 0)
		return ts_ball_cap(a) - edge_volume(a, -b);
	return 2 * positive_edge_volume(a, b);
}

double ts_ball_corner(double a, double b, double c)
{
	if (a >= 1 || b >= 1 || c >= 1) /* common: faces of cells at the ends of the ball */
		return 0;
	if (a < 0)
		return edge_volume(b, c) - ts_ball_corner(-a, b, c);
	if (b < 0)
		return edge_volume(a, c) - ts_ball_corner(a, -b, c);
	if (c < 0)
		return edge_volume(a, b) - ts_ball_corner(a, b, -c);
	return positive_corner_volume(a, b, c);
}

/* x >= a, y >= b, from the volume `positive` beyond (|a|, |b|) */
static double reflected_edge(double a, double b, double positive)
{
	if (a < 0)
		return ts_ball_cap(b) - (b < 0 ? ts_ball_cap(-a) - positive : positive);
	return b < 0 ? ts_ball_cap(a) - positive : positive;
}

/* x >= a, with the other faces below the ball; in the arithmetic of ts_ball_corner for x and y */
static double reflected_cap(double a)
{
	return a < 0 ? ts_ball_cap(-1) - ts_ball_cap(-a) : ts_ball_cap(a);
}

/* x >= a, y >= b, z >= c, from the volumes beyond (|b|, |c|), (|a|, |c|), (|a|, |b|) */
static double reflected_corner(const double cut[3], const double positive[3])
{
	double a = fabs(cut[0]), b = fabs(cut[1]), c = fabs(cut[2]), volume = positive_corner_volume(a, b, c);

	if (cut[2] < 0)
		volume = positive[2] - volume;
	if (cut[1] < 0)
		volume = reflected_edge(a, cut[2], positive[1]) - volume;
	return cut[0] < 0 ? reflected_edge(cut[1], cut[2], positive[0]) - volume : volume;
}

void ts_ball_corners(const double cut[3], const bool cuts[3], double out[8])
{
	double positive[3] = { 0 };

	for (int d = 0; d < 3; d++)
		if (cuts[d == 0 ? 1 : 0] && cuts[d == 2 ? 1 : 2])
			positive[d] = 2 * positive_edge_volume(fabs(cut[d == 0]), fabs(cut[d == 2 ? 1 : 2]));
	out[0] = ts_ball_cap(-1);
	if (cuts[0])
		out[1] = reflected_cap(cut[0]);
	if (cuts[1])
		out[2] = reflected_cap(cut[1]);
	if (cuts[2])
		out[4] = ts_ball_cap(cut[2]);
	if (cuts[0] && cuts[1])
		out[3] = cut[0] < 0 && cut[1] < 0
				 ? reflected_cap(cut[1]) - (ts_ball_cap(-cut[0]) - positive[2])
				 : reflected_edge(cut[0], cut[1], positive[2]);
	if (cuts[0] && cuts[2])
		out[5] = reflected_edge(cut[0], cut[2], positive[1]);
	if (cuts[1] && cuts[2])
		out[6] = reflected_edge(cut[1], cut[2], positive[0]);
	if (cuts[0] && cuts[1] && cuts[2])
		out[7] = reflected_corner(cut, positive);
}

/* x >= a of the disc */
static double segment_area(double a)
{
	a = ts_ball_clamp(a);
	return acos(a) - a * sqrt(1 - a * a);
}

double ts_ball_corner_disc(double a, double b)
{
	double angle;

	if (a < 0)
		return segment_area(b) - ts_ball_corner_disc(-a, b);
	if (b < 0)
		return segment_area(a) - ts_ball_corner_disc(a, -b);
	return a * a + b * b >= 1 ? 0 : sector_area(1, a, b, &angle);
}
