/* The fields of a fluid whose flow is solved for, and the interface of the fixes that take part in its
 * steps.
 *
 * Incompressible and Newtonian. With particles the equations are averaged over volumes; e is the void
 * fraction and u the interstitial velocity:
 *   de/dt + div(e u) = 0
 *   e rho (du/dt + u.grad u) = -e grad p + div(e tau) + e rho g + f - k u
 * The particles exert f and k, per volume of the cell: f is the explicit part of their force, k >= 0 the
 * coefficient of the semi-implicit part. Forces of immersed bodies are applied between predictor and
 * projection.
 *
 * Order of a time step of the simulation: particles move; in POST_FORCE the coupling fixes compute forces
 * with the velocity of the last step of the fluid and add the reaction to f and k; in END_OF_STEP, before
 * all fixes, the fluid makes its step (or several, or one every N steps: `substeps`, `every`). The fields
 * f and k are set to zero after the step that used them. */
#ifndef TS_FLOW_FLUID_H
#define TS_FLOW_FLUID_H

#include "core/sim.h"
#include "flow/fluid_near.h"
#include "grid/grid.h"
#include "rank/slabs.h"

/* Boundary condition of a face of the grid. */
enum ts_flow_face {
	TS_FLOW_PERIODIC,
	TS_FLOW_WALL,  /* no slip; the wall may move */
	TS_FLOW_SLIP,  /* no flow across, no shear; also a plane of symmetry */
	TS_FLOW_INLET, /* velocity given */
	/* pressure given, zero normal gradient of velocity; backflow enters without momentum along the face, as far as viscosity does
	 * not pass it on: fluid_ghosts.c */
	TS_FLOW_OUTLET,
	TS_FLOW_INTAKE /* pressure given; fluid that enters has the normal velocity of the first cell */
};

/* Whether the condition gives the pressure, and leaves the velocity across the face to be solved for. */
static inline bool ts_flow_face_open(enum ts_flow_face face)
{
	return face == TS_FLOW_OUTLET || face == TS_FLOW_INTAKE;
}

/* Pressure given on one face of the grid. */
struct ts_flow_face_pressure {
	double constant;
	/* if it varies over the face: values indexed by ts_flow_plane_at; NULL: constant. Owned */
	double *plane;
};

/* Velocity given at one face of the grid, for walls and inlets. */
struct ts_flow_face_velocity {
	double constant[3];
	/* if it varies over the face: values indexed by ts_flow_plane_at; NULL: constant. Owned */
	double *plane[3];
};

struct ts_fluid {
	struct ts_grid grid;
	uint64_t grids;		      /* number of grids it has had; fields are kept from one to the next */
	bool stretched;		      /* the grid of this run is not that of the fields with which it began */
	enum ts_flow_face face[3][2]; /* [axis][enum ts_grid_side] */
	struct ts_flow_face_velocity face_velocity[3][2];
	/* Pressure on open faces in the last projection, without pressure_base (pressure units). */
	struct ts_flow_face_pressure pressure[3][2];
	double pressure_base;
	/* Tangential component in the first ghost cell at a wall or inlet: ghost_weights[0] times the
	 * velocity given plus ghost_weights[1] and [2] times the velocities in the first and second cell
	 * inside. */
	double ghost_weights[3][2][3];
	double density, viscosity; /* viscosity: dynamic */
	double *u[3];		   /* at lower faces; ghosts hold what the boundary conditions say */
	double *p;		   /* at centres */

	/* Optional fields, allocated by ts_fluid_require_fields; NULL if no fix needs them. Particles add
	 * to f and k in each step of the simulation, but not in its set-up (sim->run.in_setup); the fluid
	 * takes the means over the steps since its last one. */
	double *force[3];    /* f above, at lower faces: force per volume */
	double *exchange[3]; /* k above, at lower faces: force per volume and velocity */
	/* With exchange: mean of the velocity that multiplied k in the last step, as the projection has
	 * it; with time euler the velocity at the end of the step. */
	double *exchange_velocity[3];
	double *void_fraction; /* e at centres; fix void_fraction sets it in the inner cells */
	bool void_of_fix;      /* a fix sets e, no program around the library */
	bool void_anew;	       /* the fix has been defined anew: e is no successor of that of the last step */
	/* de/dt since the last step of the fluid, at centres; set by the fluid */
	double *void_fraction_rate;
	double *void_fraction_face[3]; /* e at lower faces; set by the fluid */
	/* form conservative, at lower faces: e in the product e u after the last step */
	double *momentum_void_fraction[3];
	struct ts_cell_owners
		*owners; /* while the particles are divided among ranks; owned. NULL: none yet */
	bool apart; /* `force` and `exchange` have the sums of the particles in the cells of this rank only */
	/* While ranks have slabs and nothing needs the whole grid: the fields, and their ghosts, have the present values in
	 * these ranges of planes across the last axis only, from .. to - 1, if there are any; those more than TS_GRID_GHOSTS
	 * beside the planes of the rank only where a fix gets them (planes_beside of struct ts_flow_part). Other planes take no
	 * memory. A second range has the images of planes at the other end of a periodic grid. */
	struct ts_fluid_planes {
		int ranges;
		struct ts_fluid_range {
			int from, to;
		} range[2];
	} planes;
	struct ts_fluid_near near;
	const struct ts_slabs *slabs; /* of ranks that make a step together: fluid_slabs.h; NULL: none */
	double *p_mean;		      /* mean of the pressure over the stages and substeps of the last step */

	double dt;	   /* length of the last step of the fluid (time units); 0: there was none */
	double time;	   /* of the fields */
	int64_t steps;	   /* number of steps of the fluid since its beginning */
	double courant;	   /* largest sum |u| dt/h in the last step */
	double divergence; /* largest |div(e u) + de/dt| after the last projection (1/time) */
	/* div(e u) + de/dt as the projection requires it, everywhere (1/time): not 0 if particles change the volume of the fluid
	 * in a closed grid, which it cannot leave. */
	double excess;
	double residual;  /* largest |change of u|/dt in the last step (velocity/time) */
	int iterations;	  /* of the pressure solver in the last projection */
	bool incremental; /* incremental projection: the predictor contains the old pressure gradient, and the
			    * projection solves for the change of the pressure */
	/* acceleration of all fluid: mean over this substep, or step (body_force of the style) */
	double body_force[3];
	int threads, grain; /* of the simulation; 0: one thread */
	struct ts_fluid_outside {
		size_t most;   /* largest number of particles outside the grid at once in this run */
		int64_t steps; /* number of steps of the simulation with particles outside */
		int64_t last;  /* the last of these steps */
	} outside;
	/* Those of this rank that fixes have counted in this step: all ranks sum them at once. Owned */
	struct ts_fluid_counted {
		const struct ts_instance *self;
		size_t n;
		int64_t tag;
	} * counted;
	size_t ncounted, counted_capacity;
};

/* Number of threads to use for a loop of n iterations; as ts_team. */
static inline int ts_fluid_team(const struct ts_fluid *fluid, size_t n)
{
	size_t most = fluid->grain > 0 ? n / (size_t)fluid->grain : 1;

	return fluid->threads < 1 || most < 1  ? 1
	       : most < (size_t)fluid->threads ? (int)most
					       : fluid->threads;
}

/* Whether this rank has the fluid in some planes only. */
static inline bool ts_fluid_divided(const struct ts_fluid *fluid)
{
	return fluid->planes.ranges > 0;
}

enum ts_fluid_field { TS_FLUID_FORCE = 1, TS_FLUID_EXCHANGE = 2, TS_FLUID_VOID = 4, TS_FLUID_P_MEAN = 8 };

/* Index of a point of a face across axis d in the planes of its values; ia, ib: its indices along the
 * other two axes, a < b. */
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

/* ---- fluid.c */

/* Allocates u and p on the grid, which exists; the fluid is at rest. */
enum ts_status ts_fluid_make(struct ts_fluid *fluid);
void ts_fluid_release(struct ts_fluid *fluid);
/* The fluid is everywhere: the void fraction is 1, and not stored. */
void ts_fluid_release_void_fraction(struct ts_fluid *fluid);
/* Frees the planes. */
void ts_fluid_face_velocity_release(struct ts_flow_face_velocity *velocity);

/* Sets a field to which particles add to zero. */
void ts_fluid_clear(const struct ts_fluid *fluid, double *field);

/* All ranks get `force` and `exchange` of all cells, or of those in their planes. */
enum ts_status ts_fluid_share_sources(struct ts_fluid *fluid, struct tsim *sim);

/* Fraction of a force that is added in END_OF_STEP which the velocities still receive before the next
 * forces are computed: 1/2 with velocity Verlet, whose first half kick has already been made, else 1. */
double ts_fluid_kick_fraction(const struct tsim *sim);

/* Allocates optional fields (enum ts_fluid_field). Called in the init of fixes that need them. */
enum ts_status ts_fluid_require_fields(struct ts_fluid *fluid, struct tsim *sim, unsigned fields);

struct ts_mesh_surface;
struct ts_coupling_volume;
struct ts_cell_order;
struct ts_closed_search;

/* Interface of the fixes that take part in a step of the fluid. The state of such a fix begins with this
 * struct, and the family of its style is TS_FAMILY_FLOW_PART. The slots are called in script order; NULL:
 * nothing to do. */
#define TS_FAMILY_FLOW_PART "flow part"
enum { TS_FLOW_PART_NUMBERS = 6, TS_FLOW_PART_FIELDS = 3 };
struct ts_flow_part_fields {
	double *near[TS_FLOW_PART_FIELDS];  /* read near particles, after each step of the fluid */
	double *sum[TS_FLOW_PART_FIELDS];   /* particles add to it, until it is set to 0 in after_step */
	double *plane[TS_FLOW_PART_FIELDS]; /* last from step to step */
	double *work[TS_FLOW_PART_FIELDS];  /* made anew in each step */
};
struct ts_flow_part {
	/* After each predictor, before its projection: may change u to u + dt f (direct forcing). `dt` is
	 * that of the (sub)step, `time` the time of the fields after it. */
	enum ts_status (*force)(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				double time, double dt);
	/* After each substep of the fluid, of length dt: advances scalars, sums forces. */
	enum ts_status (*after_substep)(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
					double dt);
	/* How the volume of a particle is distributed over the cells, for e; NULL: the fix does not set e. */
	void (*volume_distribution)(const struct ts_instance *self, const struct tsim *sim,
				    struct ts_coupling_volume *how);
	/* Set by `force`: it has changed no velocity on which those in ghost cells depend. */
	bool keeps_ghosts;
	/* With several ranks: `force` changes the velocities in the planes that a rank computes, and reads fields in so many beside
	 * them, which it gets there by ts_fluid_slabs_share_beside; 0: it needs all planes. Set in its init. */
	int planes_beside;
	/* The particles as the fix sorts them by cells, for the fixes after it (coupling/cell_order.h); NULL:
	 * it does not. */
	struct ts_cell_order *order;
	/* With several ranks: bytes of each particle that the fix sends to all of them in a step; 0: none. */
	size_t shared;
	/* With several ranks: what it sends in a step of particles that add to cells (coupling/cell_order.h). Set in its
	 * init. */
	struct ts_flow_part_sends {
		bool particles; /* it has particles that do */
		int numbers; /* of each, to the ranks with cells that it reaches; at most TS_FLOW_PART_NUMBERS */
		/* fields that it sets in the cells of particles, and to which it adds (ts_cell_order_spread, _gather) */
		int fields, sums;
		bool reaction; /* it adds to f and k of the fluid */
		/* It reads and changes the fluid only near particles (flow/fluid_near.h), after ts_near_particles_ready; also the
		 * pressure there. */
		bool nearby, pressure;
	} sends;
	/* With several ranks: the fields that the fix keeps, of which ranks have planes as of those of the fluid; NULL: it keeps
	 * none. Entries NULL: none. */
	void (*fields)(struct ts_instance *self, struct ts_flow_part_fields *out);
	/* The largest stable dt of the fluid as far as this fix is concerned, or INFINITY. */
	double (*limit)(const struct ts_instance *self, const struct ts_fluid *fluid);
	/* After all substeps, of total length `length`: exchange_velocity is the mean over them, and f and
	 * k still hold the values that were used. */
	enum ts_status (*after_step)(struct ts_instance *self, struct tsim *sim, struct ts_fluid *fluid,
				     double length);
	/* Adds the faces whose velocity the body gives to the search for closed regions
	 * (immersed/closed_regions.h). */
	void (*mark_closed)(const struct ts_instance *self, struct ts_closed_search *search);
	/* The scalar field that the fix advances, at centres, ghosts set: f_ID in dumps and probes
	 * (flow/transported_scalars.h). */
	const double *(*scalar)(struct ts_instance *self);
	/* Whether its value on the lower or upper face across axis d is given: it is the mean of the values on both sides. NULL:
	 * on none. */
	bool (*scalar_given)(const struct ts_instance *self, int d, int side);
	/* Adds the force of the last step on the mesh (load[0]) and the torque about the anchor of the
	 * mesh (load[1]); raises *virtual_density to the virtual mass per volume of a freely moving body
	 * (immersed/virtual_mass_stabilization.h). */
	void (*mesh_load)(const struct ts_instance *self, const struct ts_mesh_surface *mesh,
			  double load[2][3], double *virtual_density);
	/* Lowers distance[k] to that of the surface of the body from x[k], < 0 inside; beyond `reach` its size is not
	 * exact. No effect before the body has its place. */
	enum ts_status (*distance)(struct ts_instance *self, struct tsim *sim, size_t n, const double (*x)[3],
				   double reach, double *distance);
	/* Exchange among ranks what after_substep, force, and after_step exchange, without computing it (flow/step_rehearsal.h). */
	void (*rehearse)(const struct ts_instance *self, const struct ts_fluid *fluid, double dt);
	void (*rehearse_force)(const struct ts_instance *self, const struct ts_fluid *fluid);
	enum ts_status (*rehearse_step)(const struct ts_instance *self, const struct ts_fluid *fluid);
	/* Called when a step of length dt has become unstable: returns whether the speed of freely moving
	 * bodies may be the cause, and writes the cause and the remedy to `cause`. */
	bool (*explain_instability)(const struct ts_instance *self, const struct ts_fluid *fluid, double dt,
				    char *cause, size_t size);
};

/* ---- fluid_ghosts.c */

/* Sets the ghosts of a velocity field (fluid->u or another), and the components across boundaries that
 * give them. */
void ts_fluid_fill_velocity(const struct ts_fluid *fluid, double *const u[3]);
/* Whether ghosts beside an open face across axis d depend on velocities across it that come from the other end of a later axis,
 * which is periodic. */
bool ts_fluid_leans_on_images(const struct ts_fluid *fluid, int d);
/* Sets only the ghosts: components on the boundary keep their values. */
void ts_fluid_fill_ghosts(const struct ts_fluid *fluid, double *const u[3]);
/* Sets the ghosts of a centred scalar: zero gradient at faces that are not periodic. */
void ts_fluid_fill_centred(const struct ts_fluid *fluid, double *field);
/* Sets the ghosts of the pressure: as of a scalar, but by `pressure` + `pressure_base` at open faces. */
void ts_fluid_fill_pressure(const struct ts_fluid *fluid, double *p);
/* The same without pressure_base. */
void ts_fluid_fill_relative(const struct ts_fluid *fluid, double *p);
/* Sets only the periodic ghosts, of any field. */
void ts_fluid_fill_periodic(const struct ts_fluid *fluid, double *field);

/* ---- fluid_interpolation.c */

/* Velocity at x: each component is interpolated trilinearly between its points; exact at boundary faces
 * with their conditions. A place outside the grid gets the velocity of the nearest place in it. */
void ts_fluid_velocity(const struct ts_fluid *fluid, const double x[3], double u[3]);
/* The same at a place in the grid whose cell is known, and the value of a centred field (NULL: none). */
void ts_fluid_velocity_in_cell(const struct ts_fluid *fluid, const double x[3], const int cell[3],
			       double u[3], const double *field, double *value);
/* The places along axis d, from *low to *high, with two points for each component: not those between a wall and the first
 * point inside. In three dimensions. */
void ts_fluid_two_points(const struct ts_fluid *fluid, int d, double *low, double *high);
/* Value of a centred field at x, interpolated likewise, and its gradient (NULL: not computed). */
double ts_fluid_value(const struct ts_fluid *fluid, const double *field, const double x[3],
		      double gradient[3]);

#endif
