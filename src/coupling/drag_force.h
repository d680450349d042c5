/* Common part of the drag fixes, and the state that the files drag_*.c share. The fluid's velocity is
 * interpolated to each particle of the group, the law of the style gives the drag coefficient, and a fluid
 * that is solved for receives the opposite of the force on the particle, to round-off.
 *
 * Over one step h the drag on a particle is F = B (u - v) + G, by scheme, with coefficient c = F/(u - v),
 * mass m (including added mass) and the sum f of the other forces:
 *   explicit   B = c, G = 0                               stable for h < 2 m/c
 *   implicit   B = c/(1 + c h/m), G = -B h f/m            v at the end of the step
 *   exact      B = m/h (1 - exp(-c h/m)), G = (B/c - 1) f  the mean over the relaxation
 * The last two need the complete f: they act after all other forces (late hooks of struct ts_style);
 * several drags on one particle act as one with the sum of their coefficients. If a later fix in the
 * script sets the force, or the motion is prescribed, the drag has no effect on the particle, and it is
 * computed explicitly. The exchange with the fluid is implicit: the fluid receives -F and the slope B and
 * solves for its new velocity u'; after the step of the fluid the particle receives B (u' - u), by the
 * same weights. So both have exchanged the same momentum, and neither small particles nor dense beds limit
 * the time step. */
#ifndef TS_COUPLING_DRAG_FORCE_H
#define TS_COUPLING_DRAG_FORCE_H

#include "average/particle_tally.h"
#include "coupling/added_mass.h"
#include "coupling/cell_order.h"
#include "coupling/drag_limits.h"
#include "coupling/interpolation_weights.h"
#include "flow/flow.h"
#include "flow/fluid.h"
#include "force/restraint.h"
#include "law/drag.h"

enum { TS_DRAG_EXPLICIT, TS_DRAG_EXACT, TS_DRAG_IMPLICIT };

/* Of one particle, for the exchange with the fluid. */
struct ts_drag_exchange {
	double slope[3];	  /* B of each component (force/velocity) */
	double fluid_velocity[3]; /* velocity of the fluid at the particle before the step of the fluid */
};

/* Of one particle whose velocity a drag relaxes, before all forces are known. */
struct ts_drag_relaxation {
	double c;    /* coefficient (force/velocity); 0: there is no fluid, or the force is explicit */
	double w[3]; /* slip u - v */
};

/* Of one particle whose velocity several drags relax, by component. */
struct ts_drag_combined {
	double c[3];	/* sum of the coefficients */
	double slip[3]; /* mean slip over the step minus slip before */
	double part[3]; /* B/c */
};

/* The state of a drag fix. */
struct ts_drag {
	struct ts_flow_part part; /* first */
	int axes, scheme, interpolation;
	bool two_way, lagged;
	double fraction; /* void fraction given; NaN: that of the fluid */
	double c1, c2;	 /* coefficients of Ergun's equation */
	double sound;	 /* speed of sound of a gas */

	struct ts_instance *flow;
	struct ts_fluid *fluid; /* NULL: the flow is imposed, not solved for */
	struct ts_added_masses added;
	struct ts_restraints restraints;
	uint32_t moving_groups; /* bits of the groups whose particles a fix integrates; others do not move */
	struct ts_drag **late;	/* all drags of the simulation that relax velocities, in script order */
	size_t nlate, late_capacity;
	struct ts_drag_relaxation *relaxation; /* of each particle; schemes exact and implicit. Owned */
	size_t relaxation_capacity;
	struct ts_drag_combined *combined; /* of each particle, kept by the first of several drags. Owned */
	size_t combined_capacity;
	struct ts_cell_order order;
	double (*both)[6]; /* force and slope of particles, as they are sent to other ranks */
	size_t both_capacity;
	bool alone; /* no other drag, no restraint: ts_drag_relax sets all numbers of a particle that is relaxed */
	bool sorted; /* `order` is that of the present positions: from the forces of a step to the reaction */
	struct ts_drag_exchange *exchange; /* of each particle, if the fluid is solved for. Owned */
	size_t exchange_capacity;
	size_t nexchange; /* number of particles with a pending exchange; 0: none */
	struct ts_particle_tally total;
	double reynolds; /* largest Reynolds number of a particle in the last step */
};

struct ts_drag_style {
	struct ts_style style;
	double (*coefficient)(const struct ts_drag *drag, const struct ts_slip *slip);
	bool crowded;  /* needs the void fraction */
	bool inertial; /* needs the density of the fluid */
};

static inline const struct ts_drag_style *ts_drag_style_of(const struct ts_instance *self)
{
	return (const struct ts_drag_style *)self->style;
}

extern const char *const ts_drag_axes[], *const ts_drag_schemes[];
#define TS_DRAG_ARGS                                                                                         \
	TS_ENUM("axes", struct ts_drag, axes, ts_drag_axes, .fallback = "xyz",                               \
		.help = "components in which the drag acts"),                                                \
		TS_ENUM("scheme", struct ts_drag, scheme, ts_drag_schemes, .fallback = "explicit",           \
			.help = "integration in time: force at the present velocity, exact relaxation over " \
				"the step, or implicit"),                                                    \
		TS_BOOL("two_way", struct ts_drag, two_way, .fallback = "yes",                               \
			.help = "whether the opposite force acts on a fluid that is solved for"),            \
		TS_BOOL("lagged", struct ts_drag, lagged, .fallback = "no",                                  \
			.help = "whether the force on the fluid is that at its old velocity instead of its " \
				"new one: any pressure solver remains possible, but the time step is "       \
				"limited"),                                                                  \
		TS_ENUM("interpolation", struct ts_drag, interpolation, ts_coupling_interpolation_names,     \
			.fallback = "linear",                                                                \
			.help = "how fields of the fluid are evaluated at the particle: linear "             \
				"interpolation, or the value of its cell")
#define TS_DRAG_CROWD_ARGS                                                                                \
	TS_DRAG_ARGS, TS_REAL("void", struct ts_drag, fraction, .flags = TS_OPTIONAL, .range = TS_WITHIN, \
			      .lo = 1e-3, .hi = 1, .unit = "",                                            \
			      .help = "uniform void fraction, if there is no fix void_fraction")

/* The second half of each manual page. */
#define TS_DRAG_DOC                                                                                       \
	"u is the velocity of the fluid at the centre of the particle: by default interpolated\n"         \
	"linearly, with `interpolation cell` that of the cell that contains the centre. f_ID[1],\n"       \
	"f_ID[2] and f_ID[3] are the components of the total force on the particles of the group,\n"      \
	"f_ID[4] is the largest particle Reynolds number. The equations of all laws typeset, with\n"      \
	"assumptions, order and limits: doc/theory-drag.md. In two dimensions, where masses and\n"        \
	"forces are per unit depth, F is that of a row of 3/(2 d) spheres per unit depth, whose volume\n" \
	"is that of the disc: forces by volume, relaxation times and terminal velocities are those of\n"  \
	"spheres.\n\n"                                                                                    \
	"The keyword `scheme` selects the integration in time. c = F/(u - v) is the drag coefficient\n"   \
	"and tau = m/c the relaxation time. `explicit` applies the force at the present velocity,\n"      \
	"which is stable for time steps below 2 tau. `exact` integrates the exponential relaxation\n"     \
	"under drag and all other forces exactly over each time step, `implicit` uses the velocity at\n"  \
	"the end of the step; both are stable for any time step. They are applied after all fixes\n"      \
	"that add forces, regardless of the order in the script, and after functions of tsim_on_step;\n"  \
	"several drags on one particle are integrated together. With velocity Verlet it is the\n"         \
	"velocity at the half step that is exact. If a later fix sets the force (setforce, freeze,\n"     \
	"planeforce, lineforce, enforce2d), or if the motion is prescribed (fix move, nve/noforce),\n"    \
	"the drag is computed explicitly and acts on the fluid only. Particles that are frozen, that\n"   \
	"no fix integrates, or that belong to rigid bodies get the explicit force; in rigid bodies it\n"  \
	"is stable below 2 tau. fix aveforce after this fix is refused with `exact` and `implicit`.\n\n"  \
	"If the fluid is solved for (flow_style projection), it receives the opposite of the force on\n"  \
	"the particles, to round-off, unless `two_way` is no. The exchange is implicit: the drag acts\n"  \
	"at the new velocity of the fluid. With `lagged yes` the fluid receives the force at its old\n"   \
	"velocity, which is cheaper if there are few particles, since direct pressure solvers need\n"     \
	"equal weights of all faces, but limits the time step h: h < 2 e rho/k, with k the sum of\n"      \
	"F/(u - v) per volume; with scheme explicit h (k/(e rho) + 1/tau) < 2. The plan of a run\n"       \
	"warns if the time step is larger. See doc/coupling.md."
#define TS_DRAG_CROWD_DOC                                                                                \
	"The void fraction is that of fix void_fraction, which must be defined before this fix, or\n"    \
	"the value of `void`. F is the drag in addition to the force of the pressure gradient (fix\n"    \
	"flow/pressure_gradient): in a bed at rest dp/L = beta w/e, with beta = (1-e) F/(V_p w) and w\n" \
	"the slip velocity between the particles.\n\n"

/* Slots of struct ts_style. */
extern const struct ts_value ts_drag_values[];
enum ts_status ts_drag_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_drag_post_force(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_drag_relax(struct ts_instance *self, struct tsim *sim);
bool ts_drag_is_late(const struct ts_instance *self);
enum ts_status ts_drag_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
enum ts_status ts_drag_join(struct ts_instance *self, struct tsim *sim);
void ts_drag_fini(struct ts_instance *self);

#define TS_DRAG_SLOTS                                                                                        \
	.kind = TS_KIND_FIX, .ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS,                    \
	.join = ts_drag_join, .family = TS_FAMILY_FLOW_PART, .state_size = sizeof(struct ts_drag),           \
	.init = ts_drag_init, .archive = ts_drag_archive, .values = ts_drag_values,                          \
	.hook = { [TS_STAGE_POST_FORCE] = ts_drag_post_force }, .late = { [TS_LATE_RELAX] = ts_drag_relax }, \
	.is_late = ts_drag_is_late, .plan = ts_drag_report_limits, .ground = ts_drag_add_ground,             \
	.fini = ts_drag_fini

#endif
