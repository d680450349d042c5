/* A fluid whose flow is solved for: its fields on the grid, and how others take part.
 *
 * Incompressible, Newtonian; u is the interstitial velocity where particles leave the void fraction e:
 *   d(e)/dt + div(e u) = 0
 *   e rho (du/dt + u.grad u) = -e grad p + div(e tau) + e rho g + f - k u
 * f and k come from particles (per volume of the cell: f the explicit part, k >= 0 the semi-implicit one),
 * forces of immersed bodies enter between predictor and projection.
 *
 * Order of a time step of the simulation: particles move; forces, among them drag with the fluid of the last
 * step, are added up in POST_FORCE, where the coupling fixes put the reaction into f and k; in
 * END_OF_STEP, before all fixes, the fluid makes its step (or several, or one each N: see `every`, `substeps`).
 * Fields f and k are zeroed after the step in which they were used. */
#ifndef TS_FLOW_FLUID_H
#define TS_FLOW_FLUID_H

#include "core/sim.h"
#include "grid/grid.h"

enum ts_grid_side { TS_LOW, TS_HIGH };

enum ts_flow_face {
	TS_FLOW_PERIODIC,
	TS_FLOW_WALL,  /* no slip; may move */
	TS_FLOW_SLIP,  /* no flow across, no shear; symmetry */
	TS_FLOW_INLET, /* velocity given */
	TS_FLOW_OUTLET, /* pressure given, no normal gradient of velocity; what comes back in brings no momentum */
	TS_FLOW_INTAKE /* an inlet by its pressure: as an outlet, but what comes in moves across as inside */
};

/* Whether the pressure is given there, and the flow across not. */
static inline bool ts_flow_face_open(enum ts_flow_face face)
{
	return face == TS_FLOW_OUTLET || face == TS_FLOW_INTAKE;
}

/* Pressure given on one face of the grid. */
struct ts_flow_face_pressure {
	double constant;
	double *plane; /* where it varies over the face, by ts_flow_plane_at; NULL: constant */
};

/* Velocity given at one face of the grid, for walls and inlets. */
struct ts_flow_face_velocity {
	double constant[3];
	double *plane[3]; /* where it varies over the face, by ts_flow_plane_at; NULL: constant */
};

struct ts_fluid {
	struct ts_grid grid;
	enum ts_flow_face face[3][2]; /* [axis][enum ts_grid_side] */
	struct ts_flow_face_velocity given[3][2];
	struct ts_flow_face_pressure pressure[3][2]; /* on open faces, of the last projection, less: */
	double pressure_base;
	/* A component along a wall or an inlet in the first ghost cell: mirror[0] times the velocity given plus
	 * mirror[1], mirror[2] times those of the two cells inside. */
	double mirror[3][2][3];
	double density, viscosity; /* viscosity: dynamic */
	double *u[3]; /* at lower faces; ghosts hold what the boundary conditions say */
	double *p;    /* at centres */

	/* On demand, see ts_fluid_require_fields: NULL where nobody has asked. Particles add to f and k in each step of the
	 * simulation, but not in its set-up (sim->in_setup); the fluid takes the means over the steps since its
	 * last one. */
	double *force[3];    /* f above, at lower faces, force per volume */
	double *exchange[3]; /* k above, at lower faces */
	double *used[3];     /* beside exchange: the mean velocity that k multiplied in the last step, at
			      * which the projection has it: u of the end of the step with time euler */
	double *empty;       /* void fraction e, at centres: particles set it in the cells inside */
	double *empty_rate;  /* de/dt since the last step of the fluid, at centres: made by the fluid */
	double *empty_face[3]; /* e at lower faces: made by the fluid from `empty` */
	double *inertia[3];    /* where e u is stepped forward: the e of this product after the last step */
	double *p_mean;	       /* the pressure that the last step took, mean over its stages and substeps */

	double dt;       /* of the last step of the fluid; 0: there was none */
	double time;     /* of the fields */
	int64_t steps;   /* of the fluid, since its beginning */
	double courant;  /* largest sum |u| dt/h in the last step */
	double divergence; /* largest |div(e u) + de/dt| after the last projection */
	double residual;   /* largest |change of u|/dt in the last step */
	int iterations;    /* of the pressure solver in the last projection */
	bool pressure_ahead; /* predictors have the old pressure in them, and projections find its change */
	double body_force[3]; /* acceleration of all fluid, now (body_force of the style) */
	int threads, grain; /* of the simulation; 0: one thread */
	struct ts_fluid_outside {
		size_t most;   /* particles outside the grid at once in this run */
		int64_t steps; /* in so many steps of the simulation */
		int64_t last;  /* the last one of these */
	} outside;
};

/* How many threads are worth it for a loop of n rounds; as ts_team. */
static inline int ts_fluid_team(const struct ts_fluid *fluid, size_t n)
{
	size_t most = fluid->grain > 0 ? n / (size_t)fluid->grain : 1;

	return fluid->threads < 1 || most < 1 ? 1 : most < (size_t)fluid->threads ? (int)most : fluid->threads;
}

enum ts_fluid_field { TS_FLUID_FORCE = 1, TS_FLUID_EXCHANGE = 2, TS_FLUID_VOID = 4, TS_FLUID_P_MEAN = 8 };

/* Where a point of a face across axis d stands in the planes of its values; a < b are the other two axes. */
static inline size_t ts_flow_plane_at(const struct ts_grid *grid, int d, int ia, int ib)
{
	int a = d == 0, b = d == 2 ? 1 : 2;

	return (size_t)(ia + grid->ghosts[a]) +
	       (size_t)(ib + grid->ghosts[b]) * (size_t)(grid->n[a] + 2 * grid->ghosts[a] + 1);
}

static inline size_t ts_flow_plane_size(const struct ts_grid *grid, int d)
{
	int b = d == 2 ? 1 : 2;

	return ts_flow_plane_at(grid, d, 0, grid->n[b] + grid->ghosts[b] + 1);
}

static inline double ts_flow_face_pressure_at(const struct ts_flow_face_pressure *p, size_t at)
{
	return p->plane ? p->plane[at] : p->constant;
}

/* Takes memory for u and p on the grid, which has been made; all at rest. */
enum ts_status ts_fluid_make(struct ts_fluid *fluid);
void ts_fluid_release(struct ts_fluid *fluid);

/* How much of a force added after a step the velocities get before the next forces: velocity Verlet has given half of
 * the kick already. */
double ts_fluid_kick_fraction(const struct tsim *sim);

/* Makes optional fields, in the init of who needs them. */
enum ts_status ts_fluid_require_fields(struct ts_fluid *fluid, struct tsim *sim, unsigned fields);

struct ts_mesh_surface;
struct ts_coupling_volume;
struct ts_closed_search;

/* Who takes part in a step of the fluid: state of a fix begins with this and its family is TS_FAMILY_FLOW_PART.
 * Called in script order; NULL: nothing to do. */
#define TS_FAMILY_FLOW_PART "flow part"
struct ts_flow_part {
	/* After each predictor, before its projection: may change u to u + dt f (direct forcing). `dt` is that of
	 * the (sub)step, `time` the one the fields will have. */
	enum ts_status (*force)(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				double time, double dt);
	/* After each step of the fluid, of which a step of the simulation may have several: scalars are carried
	 * on, forces summed. */
	enum ts_status (*carry)(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				double dt);
	/* Where the volume of a particle counts, for e; NULL: it makes no e. */
	void (*spread)(const struct ts_instance *self, const struct tsim *sim, struct ts_coupling_volume *how);
	/* Largest stable dt of the fluid as far as it is concerned, or INFINITY. */
	double (*limit)(const struct ts_instance *self, const struct ts_fluid *fluid);
	/* After all of these, `length` in all: `used` is the mean over them; f and k are still there. */
	enum ts_status (*settle)(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				 double length);
	/* Tells the search for closed-off fluid which faces of cells it holds (immersed/closed_regions.h). */
	void (*block)(const struct ts_instance *self, struct ts_closed_search *search);
	/* What it carries along, at centres, ghosts written: f_ID in dumps and probes (flow/transported_scalars.h). */
	const double *(*scalar)(struct ts_instance *self);
	/* Adds the force of the last step on the mesh, and the torque about the mesh's anchor; says how much of the
	 * fluid counts as virtual mass by volume of a body that moves freely (immersed/virtual_mass_stabilization.h). */
	void (*load)(const struct ts_instance *self, const struct ts_mesh_surface *mesh,
		     double load[2][3], double *virtual_density);
	/* Whether bodies that move freely have come to a speed that may be what went wrong in a step of dt; the
	 * cause, and what to do. */
	bool (*blame)(const struct ts_instance *self, const struct ts_fluid *fluid, double dt, char *cause,
		      size_t size);
};

/* Writes ghosts of a velocity field, u or another; and its components across the boundary where these are
 * given. */
void ts_fluid_fill_velocity(const struct ts_fluid *fluid, double *const u[3]);
/* Ghosts only: the boundary itself is left as it is. */
void ts_fluid_fill_ghosts(const struct ts_fluid *fluid, double *const u[3]);
/* Of a scalar at centres: no gradient at faces that are not periodic. */
void ts_fluid_fill_centred(const struct ts_fluid *fluid, double *field);
/* Of the pressure: as a scalar, but as `pressure` and `pressure_base` of the fluid say on open faces. */
void ts_fluid_fill_pressure(const struct ts_fluid *fluid, double *p);
/* The same without pressure_base. */
void ts_fluid_fill_relative(const struct ts_fluid *fluid, double *p);

/* Of any field, where the grid is periodic only. */
void ts_fluid_fill_periodic(const struct ts_fluid *fluid, double *field);

/* Velocity at a place, trilinear between the values of each component; exact at boundary faces with the
 * conditions there. Outside the grid: of the nearest place in it. */
void ts_fluid_velocity(const struct ts_fluid *fluid, const double x[3], double u[3]);
/* The same for a centred field, and for its gradient where it is wanted (NULL: not). */
double ts_fluid_value(const struct ts_fluid *fluid, const double *field, const double x[3],
		      double gradient[3]);

#endif
