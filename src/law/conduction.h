/* Heat conduction through a contact: Q = h (T_j - T_i) into i, -Q into j, with
 *
 *   h = 4 k_i k_j/(k_i + k_j) sqrt(A),
 *
 * k the thermal conductivities and A the contact area (B. Chaudhuri, F. J. Muzzio, M. S. Tomassone,
 * Chem. Eng. Sci. 61 (2006) 6348; after G. K. Batchelor, R. W. O'Brien, Proc. R. Soc. London A 355
 * (1977) 313, whose 2 k* a with the radius a of the contact area is smaller by sqrt(pi)).
 *
 *   overlap     A = circle of intersection of the surfaces; pi min(R)^2 if the centre of the smaller
 *               sphere is inside the larger one
 *   constant    A as given
 *   projection  A = pi R^2 of the larger sphere, as LIGGGHTS computes it (its manual says the smaller
 *               one)
 *
 * Stability: in a step of explicit Euler, T_i += dt/(m c) sum_j h_ij (T_j - T_i), T_i becomes a
 * weighted mean of the temperatures if dt sum_j h_ij <= m c. Above this limit temperatures overshoot
 * those of the neighbours; by Gershgorin's theorem they cannot diverge below it. */
#ifndef TS_LAW_CONDUCTION_H
#define TS_LAW_CONDUCTION_H

#include <math.h>

#include "law/lens.h"
#include "math/constants.h"

enum ts_heat_area { TS_HEAT_OVERLAP, TS_HEAT_CONSTANT, TS_HEAT_PROJECTION };

struct ts_heat_contact {
	int kind; /* enum ts_heat_area */
	double constant;
};

/* Contact area. `softening` is the factor that corrects the overlap to that of the original material,
 * (Y* / Y*_original)^(1/a) for F ~ overlap^a. r: distance of the centres. */
static inline double ts_heat_area_of_spheres(const struct ts_heat_contact *c, double r, double ri, double rj,
					     double softening)
{
	switch (c->kind) {
	case TS_HEAT_CONSTANT:
		return c->constant;
	case TS_HEAT_PROJECTION:
		return TS_PI * fmax(ri, rj) * fmax(ri, rj);
	default:
		r = ri + rj - softening * (ri + rj - r);
		return r < fmax(ri, rj) ? TS_PI * fmin(ri, rj) * fmin(ri, rj) : ts_lens_of_spheres(r, ri, rj);
	}
}

/* Contact area at a wall; r: distance of the centre from the wall. */
static inline double ts_heat_area_at_wall(const struct ts_heat_contact *c, double r, double radius,
					  double softening)
{
	switch (c->kind) {
	case TS_HEAT_CONSTANT:
		return c->constant;
	case TS_HEAT_PROJECTION:
		return TS_PI * radius * radius;
	default:
		return ts_lens_of_plane(radius - softening * (radius - r), radius);
	}
}

/* 4 k_i k_j/(k_i + k_j); 0 if one partner is an insulator. */
static inline double ts_heat_pair_conductivity(double ki, double kj)
{
	return ki > 0 && kj > 0 ? 4 * ki * kj / (ki + kj) : 0;
}

/* Conductance h, energy/(time temperature). */
static inline double ts_heat_conductance(double pair_conductivity, double area)
{
	return pair_conductivity * sqrt(area);
}

#endif
