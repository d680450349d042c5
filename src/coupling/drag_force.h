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
#define TS_DRAG_ARGS                                                                                     \
	TS_ENUM("axes", struct ts_drag, axes, ts_drag_axes, .fallback = "xyz",                           \
		.help = "components in which the drag acts"),                                            \
		TS_ENUM("scheme", struct ts_drag, scheme, ts_drag_schemes, .fallback = "explicit",       \
			.help = "force at the present velocity, exact relaxation over the step, or "     \
				"implicit"),                                                             \
		TS_BOOL("two_way", struct ts_drag, two_way, .fallback = "yes",                           \
			.help = "whether a fluid that is solved for feels the particles"),               \
		TS_BOOL("lagged", struct ts_drag, lagged, .fallback = "no",                              \
			.help = "whether the fluid gets the force as it is, not at its new velocity: "   \
				"leaves any pressure solver, but bounds the step"),                      \
		TS_ENUM("interpolation", struct ts_drag, interpolation, ts_coupling_interpolation_names, \
			.fallback = "linear",                                                            \
			.help = "of the fluid's fields to the particle: between points, or of its cell")
#define TS_DRAG_CROWD_ARGS                                                                                \
	TS_DRAG_ARGS, TS_REAL("void", struct ts_drag, fraction, .flags = TS_OPTIONAL, .range = TS_WITHIN, \
			      .lo = 1e-3, .hi = 1, .unit = "",                                            \
			      .help = "void fraction everywhere, where no fix void_fraction finds it")

/* The second half of each manual page. */
#define TS_DRAG_DOC                                                                                          \
	"u is the velocity of the fluid at the particle's centre, interpolated linearly or, with\n"          \
	"`interpolation cell`, that of the cell that holds it. f_ID[1] ... [3] is the force on all\n"        \
	"particles of the group, f_ID[4] the largest Re of a particle.\n\n"                                  \
	"scheme explicit takes the force at the present velocity: stable for steps below 2 tau, tau =\n"     \
	"m/c the relaxation time, c = F/(u - v). scheme exact makes the velocity follow the exponential\n"   \
	"relaxation under drag and all other forces exactly over each step, scheme implicit takes the\n"     \
	"velocity at the end of the step; both are stable for any step. They act after all fixes that add\n" \
	"forces, wherever these stand in the script, and after tsim_on_step functions; several on one\n"     \
	"particle relax it together. With velocity Verlet it is the half-step velocity that is exact.\n"     \
	"Where a fix after this one sets the force (setforce, freeze, planeforce, lineforce, enforce2d), "   \
	"or\n"                                                                                               \
	"the motion is prescribed (fix move, nve/noforce), the drag is explicit and only the fluid feels\n"  \
	"it. Particles that are frozen, that no fix moves, or that belong to rigid bodies get the "          \
	"explicit\n"                                                                                         \
	"force, in rigid bodies stable below 2 tau.\n"                                                       \
	"fix aveforce after this fix is refused with these two schemes.\n\n"                                 \
	"Where the fluid is solved for (flow_style projection) it loses what the particles gain, to\n"       \
	"round-off, unless two_way is no, and takes part in the exchange implicitly; with `lagged yes` it\n" \
	"gets the force as it is, which is cheaper where particles are few (direct pressure solvers need\n"  \
	"equal weights of all faces) and stable for h < 2 e rho/k, k the sum of F/(u - v) by volume; with\n" \
	"scheme explicit for h (k/(e rho) + 1/tau) < 2. The plan of a run warns of larger steps. See\n"      \
	"doc/coupling.md."
#define TS_DRAG_CROWD_DOC                                                                                  \
	"The void fraction is that of fix void_fraction, which must come before this fix, or the one\n"    \
	"given by `void`. F is the drag beside the force of the pressure gradient\n"                       \
	"(fix flow/pressure_gradient): a bed at rest has dp/L = beta w/e, beta = (1-e) F/(V_p w), w the\n" \
	"slip between the particles.\n\n"

/* Slots of struct ts_style. */
extern const struct ts_value ts_drag_values[];
enum ts_status ts_drag_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_drag_post_force(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_drag_relax(struct ts_instance *self, struct tsim *sim);
bool ts_drag_is_late(const struct ts_instance *self);
enum ts_status ts_drag_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_drag_fini(struct ts_instance *self);

#define TS_DRAG_SLOTS                                                                                        \
	.kind = TS_KIND_FIX, .family = TS_FAMILY_FLOW_PART, .state_size = sizeof(struct ts_drag),            \
	.init = ts_drag_init, .archive = ts_drag_archive, .values = ts_drag_values,                          \
	.hook = { [TS_STAGE_POST_FORCE] = ts_drag_post_force }, .late = { [TS_LATE_RELAX] = ts_drag_relax }, \
	.is_late = ts_drag_is_late, .plan = ts_drag_report_limits, .fini = ts_drag_fini

#endif
