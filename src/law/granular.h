/* The contact model of granular materials: which laws it is made of, and their constants for a pair
 * of materials. The laws themselves: law/normal.h, cohesion.h, tangential.h, rolling.h;
 * law/granular_force.h puts them together in the order normal, cohesion, tangential, rolling. */
#ifndef TS_LAW_GRANULAR_H
#define TS_LAW_GRANULAR_H

#include <stdbool.h>

enum ts_normal_law {
	TS_NORMAL_OFF,
	TS_NORMAL_SPRING,
	TS_NORMAL_HOOKE,
	TS_NORMAL_HERTZ,
	TS_NORMAL_HOOKE_STIFFNESS,
	TS_NORMAL_HERTZ_STIFFNESS,
	TS_NORMAL_HOOKE_HYSTERESIS,
	/* by the radius of the contact area: law/normal_area.h */
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
	/* their spring turns with the contact: law/tangential_turning.h */
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
	/* bridges of liquid, which reach beyond the touch: law/capillary.h */
	TS_COHESION_EASO,
	TS_COHESION_WASHINO
};

struct ts_granular_model {
	int normal, tangential, rolling, cohesion, twisting;
	int damping;		       /* of the laws by the contact area */
	bool no_tension;	       /* limitForce: F_n >= 0 */
	bool no_tangential_damping;    /* tangential_damping off */
	bool absolute_damping;	       /* of the stiffness laws: gamma is not multiplied by m* */
	bool tangential_stiffness_2_7; /* ktToKnUser: k_t = 2/7 k_n */
	bool viscous;		       /* hooke: restitution by the Stokes number */
	/* modifyLbVolume: the user says which share of its liquid a particle gives to a bridge */
	bool shares;
	bool reduce;	/* tangential_reduce: cohesion lowers the limit of friction */
	bool torsion;	/* torsionTorque: rolling friction resists spinning too */
	bool plane;	/* two dimensions: discs roll */
	bool full_arms; /* the arms of torque are the radii, not those less delta/2 */
	bool full_slip; /* the arms of slip alone are */
	bool located;	/* begin and end of contacts are found within the step: law/substep.h */
	bool solved; /* touch.solved has what takes a root or an iteration: k_n of hooke, the area of jkr */
	bool multi;  /* contacts of one grain act on each other: law/halfspace.h */
	bool wide;   /* memory has room for all laws, as contacts of other types may have others */
};

/* Member by member: between them there may be anything. */
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
	       a->multi == b->multi && a->wide == b->wide && a->shares == b->shares;
}

/* Whether there are bridges of liquid. */
static inline bool ts_cohesion_bridges(const struct ts_granular_model *m)
{
	return m->cohesion >= TS_COHESION_EASO;
}

/* Constants of a pair of materials; each law uses its own few. */
struct ts_granular_pair {
	double young, shear;	       /* Y*, G* */
	double log_restitution;	       /* ln e */
	double damping;		       /* beta = ln e / sqrt(ln^2 e + pi^2), <= 0 */
	double velocity;	       /* characteristic velocity V */
	double kn, kt, gamman, gammat; /* as given by the user */
	double gamman_root;	       /* spring: gamma_n += gamman_root sqrt(m*) */
	double friction;	       /* mu */
	double rolling_friction, rolling_viscosity, rolling_stiffness; /* mu_r, eta_r */
	double cohesion;					       /* energy density */
	double viscosity, critical_stokes, largest_restitution;	       /* of the fluid between */
	double unloading, adhesion, plasticity;			       /* k2max/k1, kc/k1, phi */
	double surface_energy;					       /* energy per area */
	double surface_tension, contact_angle, liquid_viscosity;       /* of bridges; the angle in radians */
	double least_gap, most_gap;	     /* minSeparationDistanceRatio, maxSeparationDistanceRatio */
	double bridge_share;		     /* of the liquid of a particle in a bridge, of washino */
	double roll_stiffness, roll_damping; /* of sds; its limit is rolling_friction |F_n| */
	double twist_stiffness, twist_damping, twist_friction;
};

#endif
