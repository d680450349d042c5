/* Theories of the elastic contact of a nominally flat, isotropic Gaussian surface with a plane, from the moments of its
 * spectrum. Pressures are in units of the contact modulus E*.
 *
 * Moments (P. R. Nayak, J. Lubr. Technol. 93 (1971) 398): m0 = <h^2>, m2 = <(dh/dx)^2> = <|grad h|^2>/2,
 * m4 = <(d2h/dx2)^2> = 3/8 <(laplace h)^2>; the breadth of the spectrum is alpha = m0 m4/m2^2. */
#ifndef TS_ROUGH_ASPERITY_THEORY_H
#define TS_ROUGH_ASPERITY_THEORY_H

#include <stddef.h>

#include "base/status.h"

struct ts_rough_moments {
	double m0, m2, m4; /* length^2, 1, 1/length^2 */
};

/* Mean square of the heights from their mean. */
double ts_rough_variance(size_t n, const double *height);

/* Of a periodic field of heights [n[1]][n[0]] with cells of these widths, derivatives taken in Fourier space. Returns
 * TS_OK or TS_NOMEM. */
enum ts_status ts_rough_moments(const int n[2], const double width[2], const double *height,
				struct ts_rough_moments *out);

/* Part of the area in contact at a mean pressure p/E*.
 * B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840: erf(p/(E* sqrt(m2))), as <|grad h|^2> = 2 m2. */
double ts_rough_persson_area(const struct ts_rough_moments *m, double pressure);
/* A. W. Bush, R. D. Gibson, T. R. Thomas, Wear 35 (1975) 87, for small pressures: sqrt(pi/m2) p/E*. */
double ts_rough_bush_area(const struct ts_rough_moments *m, double pressure);

/* J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295 (1966) 300: spherical asperities of one radius with
 * normally distributed heights; their density, radius and deviation from the moments by J. I. McCool, Wear 107 (1986)
 * 37. */
struct ts_rough_asperities {
	double density;	  /* 1/length^2 */
	double radius;	  /* length */
	double deviation; /* of the heights of summits, length */
	double offset;	  /* mean height of summits above the mean plane, length */
};
void ts_rough_asperities(const struct ts_rough_moments *m, struct ts_rough_asperities *out);
/* Part of the area in contact, and mean pressure/E*, where the plane is `distance` above the mean height of summits. */
double ts_rough_greenwood_area(const struct ts_rough_asperities *a, double distance);
double ts_rough_greenwood_pressure(const struct ts_rough_asperities *a, double distance);
/* The distance at which they carry this mean pressure/E* > 0; returns NAN if it cannot be found. */
double ts_rough_greenwood_distance(const struct ts_rough_asperities *a, double pressure);

#endif
