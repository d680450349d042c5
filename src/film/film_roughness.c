/* Mean flow between rough surfaces: flow factors of N. Patir & H. S. Cheng, J. Lubr. Tech. 100 (1978) 12 and 101 (1979) 220,
 * for Gaussian roughness of standard deviation sigma = sqrt(sigma1^2 + sigma2^2), H = h/sigma:
 *
 *   q = h (U1 + U2)/2 + sigma phi_s (U1 - U2)/2 - phi_p h^3/(12 eta) grad p,
 *   phi_p = 1 - C exp(-r H) for Peklenik numbers up to 1, 1 + C H^-r above,
 *   phi_s = (sigma1^2 - sigma2^2)/sigma^2 (A1 H^a1 exp(-a2 H + a3 H^2) for H <= 5, A2 exp(-H/4) above).
 *
 * The Peklenik number is the ratio of the correlation lengths along x and y; for flow along y it is the inverse. */
#include <math.h>

#include "film/internal.h"

#include "base/banned.h"

struct factors {
	double c, r;		   /* phi_p */
	double a1, e1, e2, e3, a2; /* phi_s */
};

/* By enum ts_film_peklenik. */
static const struct factors factors[] = {
	{ 1.48, 0.42, 2.046, 1.12, 0.78, 0.03, 1.856 }, { 1.38, 0.42, 1.962, 1.08, 0.77, 0.03, 1.754 },
	{ 1.18, 0.42, 1.858, 1.01, 0.76, 0.03, 1.561 }, { 0.90, 0.56, 1.899, 0.98, 0.92, 0.05, 1.126 },
	{ 0.225, 1.5, 1.560, 0.85, 1.13, 0.08, 0.556 }, { 0.520, 1.5, 1.290, 0.62, 1.09, 0.08, 0.388 },
	{ 0.870, 1.5, 1.011, 0.54, 1.07, 0.08, 0.295 },
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

void ts_film_add_roughness(const struct ts_film *f, int axis, double h, struct ts_film_section *s)
{
	double lower = f->roughness[0], upper = f->roughness[1], sigma = hypot(lower, upper);
	double difference = (lower - upper) / sigma * ((lower + upper) / sigma);
	double shift = sigma * difference * shear_factor(f, axis, h / sigma) / 2;

	s->poiseuille *= pressure_factor(f, axis, h / sigma);
	s->couette[0] += shift;
	s->couette[1] -= shift;
	s->drag = NAN;
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
