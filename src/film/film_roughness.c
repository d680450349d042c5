/* Mean flow and friction between rough surfaces: N. Patir & H. S. Cheng, J. Lubr. Tech. 100 (1978) 12 and 101 (1979) 220,
 * for Gaussian roughness of standard deviation sigma = sqrt(sigma1^2 + sigma2^2), H = h/sigma:
 *
 *   q = h_T (U1 + U2)/2 + sigma phi_s (U1 - U2)/2 - phi_p h^3/(12 eta) grad p,
 *   phi_p = 1 - C exp(-r H) for Peklenik numbers up to 1, 1 + C H^-r above,
 *   phi_s = (sigma1^2 - sigma2^2)/sigma^2 (A1 H^a1 exp(-a2 H + a3 H^2) for H <= 5, A2 exp(-H/4) above),
 *
 * and the mean shear stresses on the lower and the upper surface
 *
 *   +-eta (U2 - U1)/h (phi_f -+ phi_fs) - phi_fp h/2 grad p,
 *   phi_fs = (sigma1^2 - sigma2^2)/sigma^2 A3 H^b1 exp(-b2 H + b3 H^2) for H <= 7, 0 above,   phi_fp = 1 - D exp(-s H).
 *
 * The rough one of two surfaces is sheared less: the rest of the force on it is that of the pressure on its asperities. h_T is the
 * mean of the gap where it is open, phi_f that of h over the gap, up to gaps of sigma/100; both for heights with the density
 * 35/(96 sigma) (1 - (d/(3 sigma))^2)^3, which ends at 3 sigma, where h_T = h.
 *
 * The Peklenik number is the ratio of the correlation lengths along x and y; for flow along y it is the inverse. */
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

struct factors {
	double c, r;		   /* phi_p */
	double a1, e1, e2, e3, a2; /* phi_s */
	double a3, b1, b2, b3;	   /* phi_fs */
	double d, s;		   /* phi_fp */
	double least;		   /* the factors are known for H above */
};

/* By enum ts_film_peklenik. */
static const struct factors factors[] = {
	{ 1.48, 0.42, 2.046, 1.12, 0.78, 0.03, 1.856, 14.1, 2.45, 2.30, 0.10, 1.51, 0.52, 1 },
	{ 1.38, 0.42, 1.962, 1.08, 0.77, 0.03, 1.754, 13.4, 2.42, 2.30, 0.10, 1.51, 0.54, 1 },
	{ 1.18, 0.42, 1.858, 1.01, 0.76, 0.03, 1.561, 12.3, 2.32, 2.30, 0.10, 1.47, 0.58, 0.75 },
	{ 0.90, 0.56, 1.899, 0.98, 0.92, 0.05, 1.126, 11.1, 2.31, 2.38, 0.11, 1.40, 0.66, 0.5 },
	{ 0.225, 1.5, 1.560, 0.85, 1.13, 0.08, 0.556, 9.8, 2.25, 2.80, 0.18, 0.98, 0.79, 0.5 },
	{ 0.520, 1.5, 1.290, 0.62, 1.09, 0.08, 0.388, 10.1, 2.25, 2.90, 0.18, 0.97, 0.91, 0.5 },
	{ 0.870, 1.5, 1.011, 0.54, 1.07, 0.08, 0.295, 8.7, 2.15, 2.97, 0.18, 0.73, 0.91, 0.5 },
};

bool ts_film_is_rough(const struct ts_film *f)
{
	return f->roughness[0] > 0 || f->roughness[1] > 0;
}

static const struct factors *factors_of(const struct ts_film *f, int axis)
{
	return &factors[axis == 0 ? f->peklenik : TS_FILM_PEKLENIK_9 - f->peklenik];
}

static double pressure_factor(const struct ts_film *f, int axis, double ratio)
{
	const struct factors *k = factors_of(f, axis);

	return k->r < 1 ? 1 - k->c * exp(-k->r * ratio) : 1 + k->c * pow(ratio, -k->r);
}

static double shear_factor(const struct ts_film *f, int axis, double ratio)
{
	const struct factors *k = factors_of(f, axis);

	return ratio <= 5 ? k->a1 * pow(ratio, k->e1) * exp(ratio * (k->e3 * ratio - k->e2))
			  : k->a2 * exp(-ratio / 4);
}

static double shear_stress_factor(const struct ts_film *f, int axis, double ratio)
{
	const struct factors *k = factors_of(f, axis);

	return ratio <= 7 ? k->a3 * pow(ratio, k->b1) * exp(ratio * (k->b3 * ratio - k->b2)) : 0;
}

/* Mean of h/(h + d), z = h/(3 sigma): integrals of the density; by moments where these cancel. */
static double inverse_gap_factor(double z)
{
	const double smallest = 1 / 300.0; /* gap over 3 sigma */
	double y = z * z, cube = (1 - y) * (1 - y) * (1 - y);

	if (z > 10)
		return 1 + (1 / 9.0 + (1 / 33.0 + 5 / 429.0 / y) / y) / y;
	if (z > 1)
		return 35 / 32.0 * z * (cube * log((z + 1) / (z - 1)) + z / 15 * (66 + y * (30 * y - 80)));
	return 35 / 32.0 * z *
	       (cube * log((z + 1) / smallest) +
		(-55 + z * (132 + z * (345 + z * (-160 + z * (-405 + z * (60 + 147 * z)))))) / 60);
}

double ts_film_volume(const struct ts_film *f, double h, double *derivative)
{
	double range = 3 * hypot(f->roughness[0], f->roughness[1]), z = h / range;

	*derivative = 1;
	if (!(h < range))
		return h;
	*derivative = (128 + z * (280 + z * z * (-280 + z * z * (168 - 40 * z * z)))) / 256;
	return range / 256 * (35 + z * (128 + z * (140 + z * z * (-70 + z * z * (28 - 5 * z * z)))));
}

void ts_film_add_roughness(const struct ts_film *f, int axis, double h, struct ts_film_section *s)
{
	double lower = f->roughness[0], upper = f->roughness[1], sigma = hypot(lower, upper);
	double difference = (lower - upper) / sigma * ((lower + upper) / sigma);
	double shift = sigma * difference * shear_factor(f, axis, h / sigma) / 2, unused;
	double mean = inverse_gap_factor(h / (3 * sigma)),
	       less = difference * shear_stress_factor(f, axis, h / sigma);
	const struct factors *k = factors_of(f, axis);

	s->poiseuille *= pressure_factor(f, axis, h / sigma);
	for (int side = 0; side < 2; side++) {
		s->couette[side] = ts_film_volume(f, h, &unused) / 2 + (side ? -shift : shift);
		s->drag[side] = (mean + (side ? less : -less)) / h;
		s->grip[side] = h / 2 * (1 - k->d * exp(-k->s * h / sigma));
	}
}

double ts_film_least_gap(const struct ts_film *f)
{
	double sigma = hypot(f->roughness[0], f->roughness[1]);

	if (!ts_film_is_rough(f))
		return 0;
	return sigma * (f->asperity.density > 0 ? fmax(factors_of(f, 0)->least, factors_of(f, 1)->least) : 3);
}

enum ts_status ts_film_check_roughness(const struct ts_film *f, struct ts_error *error)
{
	const char *why = f->cavitation == TS_FILM_JFO	     ? "cavitation jfo"
			  : ts_film_slips(f)		     ? "slip"
			  : f->piezo.law != TS_FILM_CONSTANT ? "a viscosity that depends on the pressure"
			  : f->polar			     ? "a polar grid"
							     : NULL;

	for (int side = 0; side < 2; side++)
		if (!(f->roughness[side] >= 0 && isfinite(f->roughness[side])))
			return ts_fail(error, TS_RANGE, NULL, "film: roughness %g, expected >= 0",
				       f->roughness[side]);
	if (ts_film_is_rough(f) && why)
		return ts_fail(error, TS_STATE, NULL,
			       "film: flow factors of rough surfaces are not known for %s; expected "
			       "roughness 0",
			       why);
	return TS_OK;
}
