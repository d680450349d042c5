/* Drag of a fluid on a sphere, isolated or in a dispersion: the coefficient c of F = c w, where w = u -
 * v is the slip velocity between the interstitial fluid and the sphere.
 *
 * In a dispersion F is the drag without the pressure force V_p (-grad p), which particles feel in
 * addition ("model A": -e grad p in the momentum balance of the fluid). A fixed bed then has the
 * momentum exchange coefficient beta = (1-e) c/V_p and the pressure gradient -grad p = beta w/e.
 * Notation: d the diameter, e the void fraction, mu the dynamic viscosity and rho the density of the
 * fluid, and
 *
 *   Re = rho e |w| d/mu,
 *
 * the Reynolds number of the superficial velocity e w. All coefficients are finite at w = 0. For e = 1
 * Schiller-Naumann, Wen-Yu and Gidaspow agree. */
#ifndef TS_LAW_DRAG_H
#define TS_LAW_DRAG_H

#include <math.h>

#include "law/lens.h"
#include "math/constants.h"

struct ts_slip {
	double diameter, speed; /* diameter d, slip speed |w| */
	double empty;		/* void fraction e; 1 for an isolated sphere */
	double density, viscosity;
};

static inline double ts_slip_reynolds(const struct ts_slip *s)
{
	return s->density * s->empty * s->speed * s->diameter / s->viscosity;
}

/* 3 pi mu d (G. G. Stokes, Trans. Camb. Phil. Soc. 9 (1851) 8) */
static inline double ts_drag_stokes(const struct ts_slip *s)
{
	return 3 * TS_PI * s->viscosity * s->diameter;
}

/* Cd Re/24 with Cd = 24/Re (1 + 0.15 Re^0.687) below Re = 1000, 0.44 from there on (L. Schiller, A. Naumann,
 * Z. VDI 77 (1935) 318). */
static inline double ts_drag_sphere_factor(double re)
{
	return re < 1000 ? 1 + 0.15 * pow(re, 0.687) : 0.44 * re / 24;
}

/* F = pi/8 d^2 Cd rho |w| w */
static inline double ts_drag_schiller_naumann(const struct ts_slip *s)
{
	struct ts_slip alone = *s;

	alone.empty = 1;
	return ts_drag_stokes(s) * ts_drag_sphere_factor(ts_slip_reynolds(&alone));
}

/* Drag of Schiller and Naumann below Re = 1000, in a gas at the Mach number M = |w|/sound:
 *   F = 3 pi mu d w (1 + 0.15 Re^0.687) (1 + exp(-0.427/M^4.63 - 3/Re^0.88))
 *       /(1 + M/Re (3.82 + 1.28 exp(-1.25 Re/M)))
 * The last factor of the numerator is for compressibility, the denominator for rarefaction: for small spheres
 * it is a slip correction (D. J. Carlson, R. F. Hoglund, AIAA J. 2 (1964) 1980). M/Re does not depend on w. */
static inline double ts_drag_carlson_hoglund(const struct ts_slip *s, double sound)
{
	double re = s->density * s->speed * s->diameter / s->viscosity, mach = s->speed / sound;
	double rare = s->viscosity / (s->density * s->diameter * sound);
	double fast = re > 0 ? exp(-0.427 / pow(mach, 4.63) - 3 / pow(re, 0.88)) : 0;

	return ts_drag_stokes(s) * ts_drag_sphere_factor(re) * (1 + fast) /
	       (1 + rare * (3.82 + 1.28 * exp(-1.25 / rare)));
}

/* beta = C1 (1-e)^2 mu/(e d^2) + C2 (1-e) rho |w|/d (S. Ergun, Chem. Eng. Prog. 48 (1952) 89; C1 = 150,
 * C2 = 1.75. C1 = 180, C2 = 0: Carman-Kozeny). The pressure gradient is that of Ergun's equation,
 * C1 mu (1-e)^2 U/(e^3 d^2) + C2 (1-e) rho U^2/(e^3 d), U = e w. */
static inline double ts_drag_ergun(const struct ts_slip *s, double c1, double c2)
{
	double d = s->diameter;

	return TS_PI / 6 * d *
	       (c1 * (1 - s->empty) / s->empty * s->viscosity + c2 * s->density * s->speed * d);
}

/* beta = 3/4 Cd(Re) e (1-e) rho |w|/d e^-2.65 (C. Y. Wen, Y. H. Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966)
 * 100) */
static inline double ts_drag_wen_yu(const struct ts_slip *s)
{
	return ts_drag_stokes(s) * ts_drag_sphere_factor(ts_slip_reynolds(s)) * pow(s->empty, -2.65);
}

/* Wen-Yu for e > 0.8, Ergun below (D. Gidaspow, Multiphase Flow and Fluidization, 1994). */
static inline double ts_drag_gidaspow(const struct ts_slip *s)
{
	return s->empty > 0.8 ? ts_drag_wen_yu(s) : ts_drag_ergun(s, 150, 1.75);
}

/* F = pi/8 d^2 Cd rho e^(2-X) |w| w, Cd = (0.63 + 4.8/sqrt(Re))^2, X = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2)
 * (R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153) */
static inline double ts_drag_di_felice(const struct ts_slip *s)
{
	double re = ts_slip_reynolds(s), root = 0.63 * sqrt(re) + 4.8; /* root^2 = Cd Re */
	double away = re > 0 ? 1.5 - log10(re) : INFINITY;
	double x = 3.7 - 0.65 * exp(-0.5 * away * away);

	return TS_PI / 8 * s->viscosity * s->diameter * root * root * pow(s->empty, 1 - x);
}

/* beta = 18 mu e^2 (1-e)/d^2 (F0 + F3 Re/2) (R. J. Hill, D. L. Koch, A. J. C. Ladd, J. Fluid Mech. 448
 * (2001) 243; summarised by D. L. Koch, R. J. Hill, Annu. Rev. Fluid Mech. 33 (2001) 619) */
static inline double ts_drag_koch_hill(const struct ts_slip *s)
{
	double phi = 1 - s->empty, e3 = s->empty * s->empty * s->empty, f0, f3;

	if (phi < 0.4)
		f0 = (1 + 3 * sqrt(phi / 2) + (phi > 0 ? 135.0 / 64 * phi * log(phi) : 0) + 16.14 * phi) /
		     (1 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));
	else
		f0 = 10 * phi / e3;
	f3 = 0.0673 + 0.212 * phi + 0.0232 / (e3 * s->empty * s->empty);
	return ts_drag_stokes(s) * s->empty * s->empty * (f0 + 0.5 * f3 * ts_slip_reynolds(s));
}

/* F = 3 pi mu d e w (10 phi/e^2 + e^2 (1 + 1.5 sqrt(phi))
 *     + 0.413 Re/(24 e^2) (1/e + 3 e phi + 8.4 Re^-0.343)/(1 + 10^(3 phi) Re^(-(1 + 4 phi)/2))), phi = 1 - e
 * (R. Beetstra, M. A. van der Hoef, J. A. M. Kuipers, AIChE J. 53 (2007) 489) */
static inline double ts_drag_beetstra(const struct ts_slip *s)
{
	double e = s->empty, phi = 1 - e, re = ts_slip_reynolds(s);
	double slow = 10 * phi / (e * e) + e * e * (1 + 1.5 * sqrt(phi));
	double fast = 0;

	if (re > 0)
		fast = 0.413 * re / (24 * e * e) * (1 / e + 3 * e * phi + 8.4 * pow(re, -0.343)) /
		       (1 + pow(10, 3 * phi) * pow(re, -0.5 - 2 * phi));
	return ts_drag_stokes(s) * e * (slow + fast);
}

#endif
