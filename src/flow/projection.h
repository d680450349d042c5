/* The projection method on a staggered grid: the state of flow_style projection, and the internal
 * interface of the files that make its step.
 *
 * Chorin, Math. Comp. 22 (1968) 745; Harlow & Welch, Phys. Fluids 8 (1965) 2182. The predictor u* contains
 * all terms but the pressure; then div(w grad p) = rho/dt (div(e u*) + de/dt), and u = u* - dt/rho grad p. */
#ifndef TS_FLOW_PROJECTION_H
#define TS_FLOW_PROJECTION_H

#include "flow/boundary.h"
#include "flow/flow.h"
#include "flow/fluid.h"
#include "flow/operators.h"
#include "flow/predictor.h"
#include "flow/time_schemes.h"
#include "poisson/poisson.h"

#define TS_FAMILY_PROJECTION "projection"

enum ts_flow_wall_form { TS_WALL_QUADRATIC, TS_WALL_LINEAR };

struct ts_projection {
	struct ts_fluid fluid; /* first */

	/* arguments */
	double viscosity, density, gamma, courant;
	int64_t every;
	const char *substeps_word;
	struct ts_instance *region;
	struct ts_words cell_words, body_words;
	int convection, form, wall, time, viscous;
	struct ts_flow_condition condition[3][2]; /* [axis][enum ts_grid_side] */

	/* Velocities given on the faces at the last step of the fluid and at this one; fluid.face_velocity
	 * is interpolated between them. */
	struct ts_flow_face_velocity velocity_before[3][2], velocity_now[3][2];
	uint8_t before_known;
	int64_t before_resets; /* clock.resets then */
	/* The same for pressures on open faces, and those of the next projection. */
	struct ts_flow_face_pressure pressure_before[3][2], pressure_now[3][2], pressure_next[3][2];
	double next_pressure_base; /* pressure_base of the fluid in the next projection */
	/* time of the next projection's pressure within the step, from 0 (start) to 1 (end) */
	double pressure_time;
	struct ts_number level; /* mean pressure if no face is open */
	double level_now;
	bool initial_projection; /* the projection is that of an initial field: no pressure drives the flow */

	bool settled; /* while the particles are divided among ranks: this step has been made */
	/* limits of the time step (struct ts_flow_limits) that were found before it, in this step of the simulation */
	double limits_before[3];
	int64_t limits_step;
	bool moved; /* a run has made steps with it, or would have (-check) */
	bool given; /* flow_set has given its initial velocity */
	bool read;  /* the words have been read, into: */
	int64_t cells[3];
	int64_t substeps; /* 0: chosen in each step by the limits */
	struct ts_number body_force[3];
	/* The body force at the last step of the fluid and at this one; fluid.body_force is interpolated between them. */
	double force_before[3], force_now[3];
	bool force_known;  /* force_before is that of the last step */
	double *graded[3]; /* faces by flow_grid, from 0 to 1, n + 1 values; NULL: uniform. Owned */
	/* Faces of the grid to which the fields belong: that of flow_set, of the last run or of the restart file. n + 1
	 * values; NULL: there are no fields yet. Owned. */
	double *field_face[3];

	/* Work fields, allocated as the schemes need them. */
	double *work[3];	 /* the predictor */
	double *second_stage[3]; /* a second predictor, for schemes of several stages */
	double *history[3];	 /* ab2: rate of change of u in the step before */
	double history_dt;	 /* ab2: length of that step; 0: there is none */
	double history_force[3]; /* ab2: the body force in that rate; NaN: not known */
	bool read_by_formulas;	 /* in this run: of fixes or boundary conditions */
	bool history_apart;	 /* ab2: each rank has the history of its own planes only */
	double *increment;	 /* implicit viscosity: change of the pressure */
	double theta;		 /* implicit viscosity: weight of the new velocity, 1/2 or 1 */
	/* Set by the search for regions that bodies close off (immersed/closed_regions.h) if what is given
	 * there changes with time: called before each step of the fluid. NULL: nothing to check. */
	enum ts_status (*check_closed)(struct tsim *sim);
	bool warned_walls;  /* warned that walls hold a fluid without viscosity */
	bool ghosts_filled; /* ghosts of u are those of the faces as they are */
	double *rhs;
	/* weights of the faces in the projection, if particles exchange momentum with the fluid */
	double *weight[3];
	double *void_fraction_before; /* e at the last step of the fluid */
	/* form conservative, at lower faces: e at the last step, its rate then, and the e in the product e
	 * u at the beginning of the substep and at the last stage */
	double *void_before[3], *void_rate[3], *void_start[3], *void_stage[3];
	double void_elapsed;  /* time between void_before and now */
	uint8_t empty_known;  /* void_fraction_before has been set */
	int64_t source_steps; /* number of steps of the simulation whose forces f and k contain */
	double source_scale;  /* 1/source_steps, while sources are used */
	int64_t done;	      /* number of substeps in this step */
	int64_t now_at;	      /* index of the present substep, from 0 */
	int64_t waited;	      /* steps of the simulation since the last step of the fluid, */
	double elapsed;	      /* the time over which they go, */
	double waited_dt;     /* and their length; 0: they have several */
	struct ts_operators operators;
	struct ts_poisson poisson;
	struct ts_slabs slabs;	      /* of ranks, in a step that they divide */
	struct ts_instance *pressure; /* the pressure solver; NULL: not chosen yet */
	/* number of instances removed when it was chosen: a change means to choose again */
	uint64_t removals;
	bool weights_vary; /* the solver was prepared for faces of different weights */
};

/* Whether neither the fluid nor the simulation has made a step. */
static inline bool ts_projection_not_started(const struct ts_projection *p)
{
	return p->fluid.steps == 0 && p->waited == 0;
}

/* ---- projection_setup.c */

/* The live flow style with its projection, for commands that change it; an error in the name of `who` if
 * there is none. */
enum ts_status ts_projection_require(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_instance **instance, struct ts_projection **out);
/* Makes grid, fields, boundary values and operators for the present settings and box. */
enum ts_status ts_projection_setup(struct ts_instance *self, struct tsim *sim);
/* At the beginning of a run: warns if the grid is not that of the fields, which belong to it from now on. */
enum ts_status ts_projection_begin_on_grid(struct ts_instance *self, struct tsim *sim);
/* The fields are those of the present grid. TS_NOMEM or TS_OK. */
enum ts_status ts_projection_keep_faces(struct ts_projection *projection);
void ts_projection_release(struct ts_projection *projection);

/* ---- projection_step.c */

/* One substep of the fluid; `carry`: that of ts_projection_average_exchange in its first stage. */
enum ts_status ts_projection_substep(struct ts_instance *self, struct tsim *sim, double dt, double carry);
/* Sets projection->done, the number of substeps over this length. */
enum ts_status ts_projection_choose_substeps(struct ts_instance *self, struct tsim *sim, double length);
/* Whether a fix changes the velocity between predictor and projection. */
bool ts_projection_parts_have_forces(const struct tsim *sim);
/* All substeps of the fluid over the time `length`. */
enum ts_status ts_projection_step(struct ts_instance *self, struct tsim *sim, double length);

#endif
