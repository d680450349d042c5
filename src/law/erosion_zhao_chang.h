/* Wear by the groove that an indenting particle ploughs (Y. Zhao, L. Chang, Wear 252 (2002) 220): its
 * cross section times the path of sliding, and a crater. The particle of the diameter d is rigid, the
 * surface elastic-plastic:
 *
 *   delta = (3 F/(4 E* sqrt(d/2)))^(2/3)  elastic, Hertz
 *   delta = F/(pi d H)                    plastic: the hardness H, pressure, on the area pi d delta
 *   A = (4/3) sqrt(d) delta^(3/2)         section of the groove for delta << d
 *   A = R^2 acos(1 - delta/R) - (R - delta) sqrt(2 R delta - delta^2)  circular segment, R = d/2;
 *   A = pi R^2/2 + d (delta - R)                                       for delta > R
 *
 * Choices made here, which the paper (steady polishing) leaves open:
 * - Of the two indentations the larger one holds. They are equal at delta* = R (3 pi H/(2 E*))^2, where
 *   Hertz' mean pressure is 2 H; the indentation is continuous and increases with the force.
 * - A normal impact has no groove, but removes material. The volume of a plastic crater is the energy of
 *   the impact over H, m n^2/(2 H) at the normal speed n (K. L. Johnson, Contact Mechanics, 1985, 11.4).
 *   A fraction c of it is removed: c m (n^2 - K^2)/(2 H), K the speed of first yield (0, or
 *   ts_erosion_yield_speed of law/erosion_bitter.h). c is fitted to measured volumes; most of the
 *   crater's volume is pushed aside.
 *
 * For an impact as a whole the tangential speed t is taken as constant, and the section is integrated
 * over the contact, by one of two forces:
 * - hertz: that of the elastic contact, as a resolved contact with Hertz' law without damping has it. The
 *   elastic groove is 2 sqrt(2) m n t/E*, independent of d. Far beyond delta* it grows as n^1.6 t,
 *   and is too large: the force that a soft surface cannot bear indents it.
 * - plastic: F = pi d H delta, until the particle stops. The largest delta is n sqrt(m/(pi d H)), the
 *   time (pi/2) sqrt(m/(pi d H)). The groove grows as n^1.5 t; over m it is independent of d.
 *
 * E*, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, and H are pressures, m mass, n, t and K speeds, c a number.
 * The paper itself was not at hand; the section and all integrals are exact geometry and mechanics. */
#ifndef TS_LAW_EROSION_ZHAO_CHANG_H
#define TS_LAW_EROSION_ZHAO_CHANG_H

#include <stdbool.h>

#include "law/erosion.h"
#include "math/constants.h"

struct ts_erosion_zhao_chang {
	double modulus, hardness; /* E*, H */
	double crater;		  /* c */
	double yield_speed;	  /* K */
	bool plastic;		  /* force of an impact: plastic, else hertz */
	bool segment;		  /* section: circular segment, else the limit */
};

static inline double ts_zhao_hertz_overlap(double modulus, double diameter, double force)
{
	double a = cbrt(0.75 * force / (modulus * sqrt(0.5 * diameter)));

	return a * a;
}

static inline double ts_zhao_plastic_overlap(double hardness, double diameter, double force)
{
	return force / (TS_PI * diameter * hardness);
}

/* Indentation under a force. */
static inline double ts_zhao_indentation(const struct ts_erosion_zhao_chang *law, double diameter,
					 double force)
{
	double elastic = ts_zhao_hertz_overlap(law->modulus, diameter, force);
	double plastic = ts_zhao_plastic_overlap(law->hardness, diameter, force);

	return elastic > plastic ? elastic : plastic;
}

/* delta* */
static inline double ts_zhao_transition(const struct ts_erosion_zhao_chang *law, double diameter)
{
	double ratio = 1.5 * TS_PI * law->hardness / law->modulus;

	return 0.5 * diameter * ratio * ratio;
}

/* Circular segment over its limit (4/3) sqrt(d) delta^(3/2), x = delta/d <= 1/2. In a shallow one the
 * difference of the closed form cancels: there its series. */
static inline double ts_zhao_segment(double x)
{
	double angle;

	if (x < 0.01)
		return 1 - x * (3.0 / 10 +
				x * (3.0 / 56 + x * (1.0 / 48 + x * (15.0 / 1408 + x * (21.0 / 3328)))));
	angle = 2 * asin(sqrt(x));
	return 0.1875 * (angle - (1 - 2 * x) * sin(angle)) / (x * sqrt(x));
}

/* Section of the groove, area. */
static inline double ts_zhao_section(bool segment, double diameter, double depth)
{
	double radius = 0.5 * diameter, shallow;

	if (depth <= 0)
		return 0;
	if (segment && depth > radius)
		return 0.5 * TS_PI * radius * radius + diameter * (depth - radius);
	shallow = 4.0 / 3.0 * sqrt(diameter * depth) * depth;
	return segment ? shallow * ts_zhao_segment(depth / diameter) : shallow;
}

/* Volume removed along a path of sliding under a force: a step of a resolved contact. */
static inline double ts_zhao_slide_volume(const struct ts_erosion_zhao_chang *law, double diameter,
					  double force, double path)
{
	if (force <= 0)
		return 0;
	return ts_zhao_section(law->segment, diameter, ts_zhao_indentation(law, diameter, force)) *
	       fabs(path);
}

/* Volume of the crater that is removed. */
static inline double ts_zhao_crater_volume(const struct ts_erosion_zhao_chang *law,
					   const struct ts_erosion_impact *i)
{
	double excess = (i->normal - law->yield_speed) * (i->normal + law->yield_speed);

	if (i->normal <= 0 || excess <= 0)
		return 0;
	return law->crater * 0.5 * i->mass * excess / law->hardness;
}

/* Largest overlap of an elastic impact. */
static inline double ts_zhao_hertz_peak(double modulus, const struct ts_erosion_impact *i)
{
	return pow(15.0 / 16.0 * i->mass * i->normal * i->normal / (modulus * sqrt(0.5 * i->diameter)), 0.4);
}

/* Angular frequency of a plastic impact, m x'' = -pi d H x. */
static inline double ts_zhao_plastic_frequency(double hardness, const struct ts_erosion_impact *i)
{
	return sqrt(TS_PI * i->diameter * hardness / i->mass);
}

/* Integral of (1 - s^2)^0.3 from 0 to w, 0 <= w <= 1, by the binomial series of the shorter part. */
static inline double ts_zhao_plastic_part(double w)
{
	double x = w * w, u = 1 - x, term = 1, sum = 0;
	bool low = x < 0.5;

	for (int k = 0; k < 60; k++) {
		sum += low ? term / (2 * k + 1) : term / (1.3 + k);
		term *= low ? (k - 0.3) / (k + 1) * x : (k + 0.5) / (k + 1) * u;
	}
	/* the whole is B(1.3, 0.5)/2 */
	return low ? w * sum : 0.85395807899290724454 - 0.5 * pow(u, 1.3) * sum;
}

/* Time integral of the section over an elastic impact, in the limit of small indentations. Elastic part:
 * A = sqrt(2) F/E*, whose integral is the change of momentum. Plastic part: A ~ F^(3/2); with the speed w
 * n at the indentation x peak, 1 - w^2 = x^(5/2), dt = (4/5) (peak/n) (1 - w^2)^(-3/5) dw, F ~ (1 -
 * w^2)^(3/5). */
static inline double ts_zhao_hertz_limit(const struct ts_erosion_zhao_chang *law,
					 const struct ts_erosion_impact *i)
{
	double peak = ts_zhao_hertz_peak(law->modulus, i),
	       ratio = ts_zhao_transition(law, i->diameter) / peak;
	double w = ratio < 1 ? sqrt(1 - ratio * ratio * sqrt(ratio)) : 0;
	double elastic = 2 * sqrt(2.0) * i->mass * i->normal * (1 - w) / law->modulus, force, deepest;

	if (!(w > 0))
		return elastic;
	force = 4.0 / 3.0 * law->modulus * sqrt(0.5 * i->diameter * peak) * peak;
	deepest = ts_zhao_plastic_overlap(law->hardness, i->diameter, force);
	return elastic + 1.6 * ts_zhao_section(false, i->diameter, deepest) * peak / i->normal *
				 ts_zhao_plastic_part(w);
}

enum { TS_ZHAO_NODES = 8 };

/* Nodes and weights of Gauss' quadrature with 16 points on (-1, 1), the positive half. */
static inline double ts_zhao_gauss(int k, double *weight)
{
	static const double table[TS_ZHAO_NODES][2] = {
		{ 0.0950125098376374402, 0.189450610455068496 },
		{ 0.281603550779258913, 0.182603415044923589 },
		{ 0.458016777657227386, 0.169156519395002538 },
		{ 0.617876244402643748, 0.149595988816576732 },
		{ 0.755404408355003034, 0.124628971255533872 },
		{ 0.865631202387831744, 0.0951585116824927848 },
		{ 0.944575023073232576, 0.0622535239386478929 },
		{ 0.989400934991649933, 0.0271524594117540949 },
	};

	*weight = table[k][1];
	return table[k][0];
}

/* The time integral of the section over the part of an elastic impact between two values of s, by
 * quadrature. The overlap is peak sin^(4/5)(a), a = (pi/2) s^(5/2): in s the integrand is smooth where
 * the contact begins, too. */
static inline double ts_zhao_hertz_panel(const struct ts_erosion_zhao_chang *law,
					 const struct ts_erosion_impact *i, double peak, double from,
					 double to)
{
	double half = 0.5 * (to - from), middle = 0.5 * (to + from), sum = 0;
	double stiffness = 4.0 / 3.0 * law->modulus * sqrt(0.5 * i->diameter);

	for (int k = -TS_ZHAO_NODES; k < TS_ZHAO_NODES; k++) {
		double weight, node = ts_zhao_gauss(k < 0 ? -k - 1 : k, &weight), s = middle, overlap, depth,
			       rate;

		s += (k < 0 ? -node : node) * half;
		overlap = peak * pow(sin(0.5 * TS_PI * s * s * sqrt(s)), 0.8);
		depth = ts_zhao_indentation(law, i->diameter, stiffness * overlap * sqrt(overlap));
		/* dt = (4/5) (peak/n) sin^(-1/5)(a) da, da = (5/4) pi s^(3/2) ds */
		rate = TS_PI * s * sqrt(s) * peak / i->normal / sqrt(sqrt(overlap / peak));
		sum += weight * half * rate * ts_zhao_section(law->segment, i->diameter, depth);
	}
	return 2 * sum;
}

static inline double ts_zhao_hertz_segment(const struct ts_erosion_zhao_chang *law,
					   const struct ts_erosion_impact *i)
{
	double peak = ts_zhao_hertz_peak(law->modulus, i),
	       ratio = ts_zhao_transition(law, i->diameter) / peak;
	double between = ratio < 1 ? pow(2 / TS_PI * asin(pow(ratio, 1.25)), 0.4) : 1;

	return ts_zhao_hertz_panel(law, i, peak, 0, between) +
	       (between < 1 ? ts_zhao_hertz_panel(law, i, peak, between, 1) : 0);
}

/* Time integral of the section over a plastic impact; the integral of sin^(3/2) over a quarter is
 * sqrt(pi)/2 Gamma(5/4)/ Gamma(7/4). */
static inline double ts_zhao_plastic_impact(const struct ts_erosion_zhao_chang *law,
					    const struct ts_erosion_impact *i)
{
	double frequency = ts_zhao_plastic_frequency(law->hardness, i), deepest = i->normal / frequency,
	       sum = 0;

	if (!law->segment)
		return 0.87401918476403993682 * ts_zhao_section(false, i->diameter, deepest) / frequency;
	for (int k = -TS_ZHAO_NODES; k < TS_ZHAO_NODES; k++) {
		double weight, node = ts_zhao_gauss(k < 0 ? -k - 1 : k, &weight);
		double s = 0.5 + (k < 0 ? -0.5 : 0.5) * node;

		/* the angle is (pi/2) s^2, for a smooth integrand where the contact begins */
		sum += weight * 0.5 * TS_PI * s *
		       ts_zhao_section(true, i->diameter, deepest * sin(0.5 * TS_PI * s * s));
	}
	return sum / frequency;
}

/* Volume of the groove of an impact. */
static inline double ts_zhao_groove_volume(const struct ts_erosion_zhao_chang *law,
					   const struct ts_erosion_impact *i)
{
	double integral;

	if (i->normal <= 0)
		return 0;
	if (law->plastic)
		integral = ts_zhao_plastic_impact(law, i);
	else if (law->segment)
		integral = ts_zhao_hertz_segment(law, i);
	else
		integral = ts_zhao_hertz_limit(law, i);
	return integral * i->tangential;
}

static inline double ts_erosion_zhao_chang_volume(const struct ts_erosion_zhao_chang *law,
						  const struct ts_erosion_impact *i)
{
	return ts_zhao_groove_volume(law, i) + ts_zhao_crater_volume(law, i);
}

#endif
