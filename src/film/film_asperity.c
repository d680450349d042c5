/* Elastic contact of the asperities of two rough surfaces: J. A. Greenwood & J. H. Tripp, Proc. Inst. Mech. Eng. 185 (1970)
 * 625. With n asperities per area on each surface, of radius b, Gaussian heights, H = h/sigma and F_m(H) the integral of
 * (s - H)^m over the normal density from H:
 *
 *   p = 16 sqrt(2) pi/15 (n b sigma)^2 E' sqrt(sigma/b) F_5/2(H),   area = pi^2 (n b sigma)^2 F_2(H),
 *   1/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2. */
#include <math.h>

#include "film/internal.h"
#include "math/constants.h"

#include "base/banned.h"

/* F_5/2 and F_3/2 with s = H + u^2, an even function of u: the trapezoidal rule converges exponentially. */
static void integrate_half_powers(double H, double *five, double *three)
{
	const double end = sqrt(fmax(9 - H, 3)), step = end / 64;

	*five = *three = 0;
	for (int k = 1; k <= 64; k++) {
		double u = k * step, s = H + u * u,
		       weight = 2 * step * u * u * exp(-s * s / 2) / sqrt(2 * TS_PI);

		*three += weight * u * u;
		*five += weight * u * u * u * u;
	}
}

/* F_2 */
static double second(double H)
{
	return (1 + H * H) * erfc(H / sqrt(2)) / 2 - H * exp(-H * H / 2) / sqrt(2 * TS_PI);
}

struct ts_film_touch ts_film_touch(const struct ts_film *f, double h)
{
	const struct ts_film_asperity *a = &f->asperity;
	double sigma = hypot(f->roughness[0], f->roughness[1]), crowd = a->density * a->radius * sigma, five,
	       three;
	double scale = 16 * sqrt(2) * TS_PI / 15 * crowd * crowd * a->modulus * sqrt(sigma / a->radius);

	if (!(a->density > 0))
		return (struct ts_film_touch){ 0 };
	integrate_half_powers(h / sigma, &five, &three);
	return (struct ts_film_touch){ .pressure = scale * five,
				       .slope = -2.5 * scale * three / sigma,
				       .area = TS_PI * TS_PI * crowd * crowd * second(h / sigma) };
}
