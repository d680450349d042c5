/* The contact model of granular materials: the laws it is composed of, and the constants of a pair of
 * materials. The laws are in law/normal.h, cohesion.h, tangential.h, rolling.h and twisting.h;
 * law/granular_force.h evaluates them in the order normal, cohesion, tangential, rolling, twisting. */
#ifndef TS_LAW_GRANULAR_H
#define TS_LAW_GRANULAR_H

#include <stdbool.h>

enum ts_normal_law {
	TS_NORMAL_OFF,
	TS_NORMAL_SPRING,
	TS_NORMAL_HOOKE,
	TS_NORMAL_HERTZ,
	TS_NORMAL_HOOKE_STIFFNESS,
	TS_NORMAL_HOOKE_MODULUS,
	TS_NORMAL_HERTZ_STIFFNESS,
	TS_NORMAL_HOOKE_HYSTERESIS,
	TS_NORMAL_EDINBURGH,
	/* based on the radius of the contact area: law/normal_area.h */
	TS_NORMAL_AREA_HOOKE,
	TS_NORMAL_AREA_HERTZ,
	TS_NORMAL_AREA_DMT,
	TS_NORMAL_AREA_JKR,
	TS_NNORMAL
};
enum ts_damping_law {
	TS_DAMPING_VELOCITY,
	TS_DAMPING_MASS_VELOCITY,
	TS_DAMPING_VISCOELASTIC,
	TS_DAMPING_TSUJI,
	TS_DAMPING_RESTITUTION
};
enum ts_tangential_law {
	TS_TANGENTIAL_OFF,
	TS_TANGENTIAL_HISTORY,
	TS_TANGENTIAL_NO_HISTORY,
	TS_TANGENTIAL_INCREMENTAL,
	TS_TANGENTIAL_SLIDER,
	/* the spring rotates with the contact: law/tangential_turning.h */
	TS_TANGENTIAL_LINEAR,
	TS_TANGENTIAL_MINDLIN,
	TS_TANGENTIAL_MINDLIN_FORCE,
	TS_TANGENTIAL_MINDLIN_RESCALE,
	TS_TANGENTIAL_MINDLIN_RESCALE_FORCE,
	TS_NTANGENTIAL
};
enum ts_rolling_law {
	TS_ROLLING_OFF,
	TS_ROLLING_CDT,
	TS_ROLLING_EPSD,
	TS_ROLLING_EPSD2,
	TS_ROLLING_EPSD3,
	TS_ROLLING_SDS
};
enum ts_twisting_law { TS_TWISTING_OFF, TS_TWISTING_SDS, TS_TWISTING_MARSHALL };
enum ts_cohesion_law {
	TS_COHESION_OFF,
	TS_COHESION_SJKR,
	TS_COHESION_SJKR2,
	/* liquid bridges, which act beyond contact: law/capillary.h */
	TS_COHESION_EASO,
	TS_COHESION_WASHINO
};

struct ts_granular_model {
	int normal, tangential, rolling, cohesion, twisting;
	int damping;		       /* damping law of the normal laws based on the contact area */
	bool no_tension;	       /* limitForce: F_n >= 0 */
	bool no_tangential_damping;    /* tangential_damping off */
	bool absolute_damping;	       /* stiffness laws: gamma is not multiplied by m* */
	bool tangential_stiffness_2_7; /* ktToKnUser: k_t = 2/7 k_n */
	bool viscous;		       /* hooke: restitution depends on the Stokes number */
	/* modifyLbVolume: the fraction of its liquid that a particle contributes to a bridge is given */
	bool shares;
	bool reduce; /* tangential_reduce: cohesion reduces the limit of friction */
	/* torsionTorque: rolling friction also acts against the relative spin about the normal */
	bool torsion;
	bool plane;	/* two dimensions: moments of inertia of discs */
	bool full_arms; /* the lever arms of torques are the radii, not R - delta/2 */
	bool full_slip; /* the same for the lever arms of the slip velocity only */
	bool located;	/* sub-step detection of begin and end of contacts: law/substep.h */
	/* ts_touch.solved contains the precomputed root: k_n of hooke, or the contact radius of jkr */
	bool solved;
	bool rooted; /* hertz, hertz/stiffness: ts_touch.solved of pairs contains sqrt(R* delta) */
	/* multi-contact model: contacts of one particle influence each other: law/halfspace.h */
	bool multi;
	bool fades; /* spring: damping times 1 - (r/(R_i + R_j))^8 */
	bool wide;  /* the history has room for all laws, as contacts of other types may have other laws */
};

/* Compares member by member, as padding is undefined. */
static inline bool ts_granular_same_model(const struct ts_granular_model *a,
					  const struct ts_granular_model *b)
{
	return a->normal == b->normal && a->tangential == b->tangential && a->rolling == b->rolling &&
	       a->cohesion == b->cohesion && a->twisting == b->twisting && a->damping == b->damping &&
	       a->no_tension == b->no_tension && a->no_tangential_damping == b->no_tangential_damping &&
	       a->absolute_damping == b->absolute_damping &&
	       a->tangential_stiffness_2_7 == b->tangential_stiffness_2_7 && a->viscous == b->viscous &&
	       a->reduce == b->reduce && a->torsion == b->torsion && a->plane == b->plane &&
	       a->full_arms == b->full_arms && a->full_slip == b->full_slip && a->located == b->located &&
	       a->multi == b->multi && a->wide == b->wide && a->shares == b->shares && a->fades == b->fades;
}

/* Whether the cohesion law is a liquid bridge. */
static inline bool ts_cohesion_bridges(const struct ts_granular_model *m)
{
	return m->cohesion >= TS_COHESION_EASO;
}

/* Constants of a pair of materials; each law uses some of them. */
struct ts_granular_pair {
	double young, shear;	       /* effective moduli Y*, G*, pressure */
	double log_restitution;	       /* ln e */
	double damping;		       /* beta = ln e / sqrt(ln^2 e + pi^2), <= 0 */
	double velocity;	       /* characteristic velocity V */
	double kn, kt, gamman, gammat; /* given stiffness (hooke/modulus: by R*) and damping coefficients */
	double gamman_root;	       /* spring: gamma_n += gamman_root sqrt(m*) */
	double friction;	       /* mu */
	double rolling_friction, rolling_viscosity, rolling_stiffness; /* mu_r, eta_r */
	double cohesion; /* cohesion energy density, energy/volume */
	/* of the interstitial fluid; viscosity, critical Stokes number, largest restitution */
	double viscosity, critical_stokes, largest_restitution;
	double unloading, adhesion, plasticity; /* k2max/k1, kc/k1, phi */
	/* edinburgh: n, chi, f_0; 1 m in the length of the units */
	double overlap_exponent, adhesion_exponent, pull_off, metre;
	double surface_energy; /* energy/area */
	/* of liquid bridges; the contact angle in radians */
	double surface_tension, contact_angle, liquid_viscosity;
	double least_gap, most_gap;	     /* minSeparationDistanceRatio, maxSeparationDistanceRatio */
	double bridge_share;		     /* washino: fraction of the liquid of a particle in a bridge */
	double roll_stiffness, roll_damping; /* rolling by sds; the limit is rolling_friction |F_n| */
	double twist_stiffness, twist_damping, twist_friction;
};

#endif
