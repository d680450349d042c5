/* Forces of the fluid on particles beside drag: what these fixes share. Each gives the force on one particle from
 * the flow around it; the fluid gets the opposite, by the weights of coupling/interpolation_weights.h, unless the force is part of
 * its own equations (the pressure gradient) or two_way is no. */
#ifndef TS_COUPLING_COUPLING_FORCE_H
#define TS_COUPLING_COUPLING_FORCE_H

#include "average/particle_tally.h"
#include "coupling/cell_order.h"
#include "coupling/interpolation_weights.h"
#include "flow/flow.h"
#include "flow/fluid.h"

struct ts_coupling_force {
	struct ts_flow_part part; /* first */
	bool two_way;
	struct ts_instance *flow;
	struct ts_fluid *fluid; /* NULL: imposed */
	struct ts_cell_order order;
	struct ts_tally total;
};

/* The flow at a particle. */
struct ts_coupling_local_flow {
	double place[3]; /* in the grid, and its cell */
	int cell[3];
	double density, viscosity;
	double slip[3];		/* u - v */
	double u[3], slope[3][3]; /* velocity, and du_c/dx_a as slope[c][a] */
};

struct ts_coupling_force_style {
	struct ts_style style;
	/* f += its force, also a torque where it makes one, on particle i; `f` is what the tally notes. */
	void (*act)(const struct ts_instance *self, const struct tsim *sim, size_t i,
		    const struct ts_coupling_local_flow *around, double f[3], double torque[3]);
	bool sheared; /* asks for the slope */
	bool solved;  /* asks for a fluid that is solved for */
	bool internal; /* the reaction is in the equations of the fluid */
};

void ts_coupling_curl(const double slope[3][3], double curl[3]);

#define TS_COUPLING_FORCE_ARGS(T, f)                                                                    \
	TS_BOOL("two_way", T, f.two_way, .fallback = "yes",                                    \
		.help = "whether a fluid that is solved for feels the particles")
extern const struct ts_value ts_coupling_force_values[];
enum ts_status ts_coupling_force_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_coupling_force_post_force(struct ts_instance *self, struct tsim *sim);
/* Gives the fluid what is noted: done by act, but for a style with a late hook, which adds to its notes. */
enum ts_status ts_coupling_force_add_to_fluid(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_coupling_force_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_coupling_force_fini(struct ts_instance *self);

#define TS_COUPLING_FORCE_SLOTS                                                                        \
	.kind = TS_KIND_FIX, .family = TS_FAMILY_FLOW_PART, .values = ts_coupling_force_values,        \
	.hook = { [TS_STAGE_POST_FORCE] = ts_coupling_force_post_force }

#endif
