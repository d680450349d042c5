/* What several laws of wear have in common: the impact in the terms of law/erosion.h, and material numbers of the surface
 * and of the particles, given as arguments or as properties of the materials (material/property.h). */
#ifndef TS_WEAR_WEAR_MATERIAL_H
#define TS_WEAR_WEAR_MATERIAL_H

#include "law/erosion.h"
#include "wear/wear.h"

#define TS_WEAR_HARDNESS_ARG(T, f)                                                                         \
	TS_REAL("hardness", T, f, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure",          \
		.help = "of the surface, 9.80665 MPa for each unit of HV; default: the property hardness " \
			"of its material")
#define TS_WEAR_MODULUS_ARG(T, f)                                                                    \
	TS_REAL("modulus", T, f, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "pressure",     \
		.help = "effective modulus E*; default: 1/((1 - nu1^2)/Y1 + (1 - nu2^2)/Y2) by the " \
			"properties youngsModulus Y and poissonsRatio nu of particle and surface")
#define TS_WEAR_FACTOR_ARG(T, f)                                                                            \
	TS_REAL("factor", T, f, .fallback = "1", .range = TS_NOT_NEGATIVE, .unit = "",                      \
		.help = "multiplies the volume: for another shape of the particles than that of the law's " \
			"data")

/* Effective moduli of particles of each type with the surface. */
struct ts_wear_moduli {
	double given; /* argument; NaN: by properties */
	double *of;   /* [types + 1], from 1 */
};

static inline struct ts_erosion_impact ts_wear_erosion_impact(const struct ts_impact_event *e)
{
	return (struct ts_erosion_impact){ e->mass, 2 * e->radius, ts_impact_normal_speed(e),
					   ts_impact_tangential_speed(e) };
}

/* For init functions, after ts_wear_init. */
enum ts_status ts_wear_hardness(const struct ts_instance *self, struct tsim *sim, double given, double *out);
enum ts_status ts_wear_moduli_find(const struct ts_instance *self, struct tsim *sim,
				   struct ts_wear_moduli *moduli);
void ts_wear_moduli_release(struct ts_wear_moduli *moduli);

#endif
