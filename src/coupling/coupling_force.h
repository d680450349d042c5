/* Common part of the fixes that exert forces of the fluid on particles other than drag (lift, pressure
 * gradient, added mass, buoyancy). Each style computes the force on one particle from the local flow; the
 * fluid receives the opposite force, by the weights of coupling/interpolation_weights.h, unless the force
 * is part of its own equations (pressure gradient) or two_way is no. */
#ifndef TS_COUPLING_COUPLING_FORCE_H
#define TS_COUPLING_COUPLING_FORCE_H

#include "average/particle_tally.h"
#include "coupling/cell_order.h"
#include "coupling/interpolation_weights.h"
#include "flow/flow.h"
#include "flow/fluid.h"

enum { TS_COUPLING_FORCE_BATCH = 32 }; /* particles at once, if the style computes several */

struct ts_coupling_force {
	struct ts_flow_part part; /* first */
	bool two_way;
	bool batches; /* `forces` of the style is called instead of `force` */
	struct ts_instance *flow;
	struct ts_fluid *fluid; /* NULL: the flow is imposed, not solved for */
	struct ts_cell_order order;
	struct ts_particle_tally total;
};

/* The flow at the centre of a particle. */
struct ts_coupling_local_flow {
	double place[3]; /* the centre, by its image in the grid, and its cell */
	int cell[3];
	double density, viscosity;
	double slip[3];		     /* u - v */
	double u[3], gradient[3][3]; /* velocity; du_c/dx_a is gradient[c][a] */
};

struct ts_coupling_force_style {
	struct ts_style style;
	/* Adds the force on particle i to f, and its torque, if any, to `torque`. */
	void (*force)(const struct ts_instance *self, const struct tsim *sim, size_t i,
		      const struct ts_coupling_local_flow *around, double f[3], double torque[3]);
	/* The same for particles of[0] .. of[n - 1], without torques, if the state has `batches`; inside[k]: whether there
	 * is fluid. NULL: none. */
	void (*forces)(const struct ts_instance *self, const struct tsim *sim, const size_t *of, size_t n,
		       double (*f)[3], bool *inside);
	bool row; /* the force is that of one sphere: in two dimensions a disc has that of a row of them */
	bool at_rest;  /* does not depend on velocities: u, slip and gradient are not computed */
	bool sheared;  /* needs the velocity gradient */
	bool solved;   /* needs a fluid that is solved for */
	bool internal; /* the reaction is part of the equations of the fluid */
};

void ts_coupling_curl(const double gradient[3][3], double curl[3]);

#define TS_COUPLING_FORCE_ARGS(T, f)                        \
	TS_BOOL("two_way", T, f.two_way, .fallback = "yes", \
		.help = "whether the opposite force acts on a fluid that is solved for")
extern const struct ts_value ts_coupling_force_values[];
enum ts_status ts_coupling_force_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_coupling_force_post_force(struct ts_instance *self, struct tsim *sim);
/* Adds the reaction to the tallied forces to the fluid. Called by ts_coupling_force_post_force; a style
 * with a late hook calls it itself, after it has added to the tally. */
enum ts_status ts_coupling_force_add_to_fluid(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_coupling_force_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
enum ts_status ts_coupling_force_join(struct ts_instance *self, struct tsim *sim);
void ts_coupling_force_fini(struct ts_instance *self);

#define TS_COUPLING_FORCE_SLOTS                                                             \
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_ROWLESS | TS_RANKS_REVIEW,      \
	.join = ts_coupling_force_join, .kind = TS_KIND_FIX, .family = TS_FAMILY_FLOW_PART, \
	.values = ts_coupling_force_values, .hook = { [TS_STAGE_POST_FORCE] = ts_coupling_force_post_force }

#endif
