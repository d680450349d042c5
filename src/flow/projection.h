/* The projection method on a staggered grid: the state of flow_style projection, and the internal
 * interface of the files that make its step.
 *
 * Chorin, Math. Comp. 22 (1968) 745; Harlow & Welch, Phys. Fluids 8 (1965) 2182. The predictor u* contains
 * all terms but the pressure; then div(w grad p) = rho/dt (div(e u*) + de/dt), and u = u* - dt/rho grad p. */
#ifndef TS_FLOW_PROJECTION_H
#define TS_FLOW_PROJECTION_H

#include "flow/flow.h"
#include "flow/fluid.h"
#include "flow/operators.h"
#include "flow/predictor.h"
#include "flow/time_schemes.h"
#include "poisson/poisson.h"

#define TS_FAMILY_PROJECTION "projection"

enum ts_flow_wall_form { TS_WALL_QUADRATIC, TS_WALL_LINEAR };

/* Keyword `hydrostatic`: whether the pressure on an open face increases with depth. */
enum ts_flow_depth { TS_FLOW_PRESSURE_UNSAID, TS_FLOW_EVEN, TS_FLOW_HYDROSTATIC };

/* Arguments of flow_boundary for one face. Strings belong to the instance. */
struct ts_flow_condition {
	enum ts_flow_face kind;
	bool said; /* a flow_boundary command has set this face; else the default applies */
	bool once; /* velocities are evaluated at the beginning of a run, not in each step */
	struct ts_number velocity[3];
	struct ts_number pressure;
	enum ts_flow_depth hydrostatic;
	const char *set[3]; /* names of internal variables that receive the coordinates, or NULL */
	struct ts_place where;
};

/* Whether the values of the face may depend on the coordinates. */
static inline bool ts_flow_condition_shaped(const struct ts_flow_condition *condition)
{
	return condition->set[0] || condition->set[1] || condition->set[2];
}

enum { TS_FLOW_CENTRES = -1 }; /* component of a formula at the centres of the cells' faces */

/* A number given on a face, which may be a formula: `component` says at the points of which velocity
 * component it is evaluated; `what` names it in error messages. */
struct ts_flow_formula {
	const struct ts_number *number;
	const char *what;
	int component;
};

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
	/* The same for pressures on open faces, and those of the next projection. */
	struct ts_flow_face_pressure pressure_before[3][2], pressure_now[3][2], pressure_next[3][2];
	double next_pressure_base; /* pressure_base of the fluid in the next projection */
	/* time of the next projection's pressure within the step, from 0 (start) to 1 (end) */
	double pressure_time;
	struct ts_number level; /* mean pressure if no face is open */
	double level_now;
	bool initial_projection; /* the projection is that of an initial field: no pressure drives the flow */

	bool moved; /* a run has made steps with it, or would have (-check) */
	bool read;  /* the words have been read, into: */
	int64_t cells[3];
	int64_t substeps; /* 0: chosen in each step by the limits */
	struct ts_number body_force[3];
	double *graded[3]; /* faces by flow_grid, from 0 to 1, n + 1 values; NULL: uniform. Owned */

	/* Work fields, allocated as the schemes need them. */
	double *work[3];	 /* the predictor */
	double *second_stage[3]; /* a second predictor, for schemes of several stages */
	double *history[3];	 /* ab2: rate of change of u in the step before */
	double history_dt;	 /* ab2: length of that step; 0: there is none */
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
	int64_t waited;	      /* steps of the simulation since the last step of the fluid */
	struct ts_operators operators;
	struct ts_poisson poisson;
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

/* ---- flow_setup.c */

/* The live flow style with its projection, for commands that change it; an error in the name of `who` if
 * there is none. */
enum ts_status ts_projection_require(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_instance **instance, struct ts_projection **out);
/* Makes grid, fields, boundary values and operators for the present settings and box. */
enum ts_status ts_projection_setup(struct ts_instance *self, struct tsim *sim);
void ts_projection_release(struct ts_projection *projection);

/* ---- flow_arguments.c */

/* Reads three numbers or v_NAMEs; strings go to the arena. */
enum ts_status ts_flow_read_vector(struct tsim *sim, const char *what, struct ts_words words,
				   const struct ts_place *where, struct ts_arena *arena,
				   struct ts_number out[3]);
/* Reads `x NAME` and so on: internal variables that receive coordinates. */
enum ts_status ts_flow_read_set(struct tsim *sim, const char *what, struct ts_words words,
				const struct ts_place *where, struct ts_arena *arena, const char *out[3]);
/* Sets these variables to the coordinates x. */
enum ts_status ts_flow_set_coordinates(struct tsim *sim, const char *const set[3], const double x[3],
				       const struct ts_place *where);

/* ---- void_fraction.c */

/* Sets ghosts, face values and rate of the void fraction; `elapsed`: time since the last step of the
 * fluid. */
enum ts_status ts_projection_update_void_fraction(struct ts_projection *projection, double elapsed);
/* Whether e u is stepped forward in place of u. */
static inline bool ts_projection_conservative(const struct ts_projection *projection)
{
	return projection->form == TS_FORM_CONSERVATIVE && projection->fluid.void_fraction;
}
/* form conservative: sets the void fractions in the products e u of stage s of the predictor. */
void ts_projection_stage_void_fraction(struct ts_projection *projection, struct ts_predictor *stage, int s);
/* Integral of de/dt over the grid (volume/time). */
double ts_projection_void_rate_integral(const struct ts_projection *projection);

/* ---- particle_sources.c */

/* Computes the weights of the faces in the projection of a stage of length dt. */
enum ts_status ts_projection_face_weights(struct ts_projection *projection, double dt);
/* Applies f and k to the velocity over the time dt. */
void ts_projection_apply_particle_forces(struct ts_projection *projection, double dt);
/* v <- take (carry v + u) with v = exchange_velocity: accumulates over the stages the mean velocity that
 * multiplied k; the same for p_mean. */
void ts_projection_average_exchange(struct ts_projection *projection, double carry, double take);
void ts_projection_clear_sources(struct ts_projection *projection);

/* ---- pressure_projection.c */

/* Chooses the pressure solver and prepares it for the present faces and weights; `held` as below. */
enum ts_status ts_projection_solver(struct ts_instance *self, struct tsim *sim, double held);
/* Makes the velocity, whose boundary values are set, free of divergence: u -= dt/rho grad p. `held`: time
 * over which the exchange coefficient k acts in it, dt or 0. */
enum ts_status ts_projection_project_velocity(struct ts_instance *self, struct tsim *sim, double dt,
					      double held);
/* Computes div(e u) + de/dt in a row of cells. */
void ts_flow_divergence_row(const struct ts_fluid *fluid, int j, int k, double *out);
/* Projects an initial velocity field; the pressure is zero afterwards. */
enum ts_status ts_projection_project_initial(struct ts_instance *self, struct tsim *sim);

/* ---- flow_step.c */

/* One substep of the fluid; `carry`: that of ts_projection_average_exchange in its first stage. */
enum ts_status ts_projection_substep(struct ts_instance *self, struct tsim *sim, double dt, double carry);
/* All substeps of the fluid over the time `length`. */
enum ts_status ts_projection_step(struct ts_instance *self, struct tsim *sim, double length);

/* ---- step_diagnostics.c */

/* Computes Courant number, residual and divergence of the last substep; an error if it was unstable.
 * `before`: the velocity at its beginning. */
enum ts_status ts_projection_check_substep(struct ts_instance *self, struct tsim *sim,
					   double *const before[3], double dt);

/* ---- boundary.c */

/* Sets the types of the faces from settings and box; refuses combinations that are impossible. */
enum ts_status ts_projection_set_face_types(struct ts_instance *self, struct tsim *sim);
/* Evaluates the velocities and pressures given on the faces, at this time. */
enum ts_status ts_projection_evaluate_boundary(struct ts_instance *self, struct tsim *sim);
/* Interpolates the velocities on the faces in time, from the last step of the fluid (fraction 0) to now
 * (1). */
void ts_projection_interpolate_boundary(struct ts_projection *projection, double fraction);
/* Stores the present boundary values as those of the last step. */
enum ts_status ts_projection_store_boundary(struct ts_projection *projection);
/* Saves or restores the velocities given, for restart files. */
enum ts_status ts_projection_archive_boundary(struct ts_projection *projection, struct tsim *sim,
					      struct ts_archive *archive);
/* Net outward flow through the whole boundary per volume of the grid (1/time), by the velocities given; an
 * error if no face is open and it is not zero. */
enum ts_status ts_projection_net_outflow(struct ts_instance *self, struct tsim *sim, double *mean);

/* ---- boundary_formula.c */

/* Evaluates a formula now; an error if the value is not finite. */
enum ts_status ts_flow_formula_value(struct tsim *sim, const struct ts_flow_condition *condition,
				     const struct ts_flow_formula *formula, double *out);
/* Evaluates it at all points of the face. */
enum ts_status ts_flow_fill_plane(struct tsim *sim, const struct ts_flow_condition *condition,
				  const struct ts_flow_formula *formula, const struct ts_grid *grid, int d,
				  enum ts_grid_side side, double *plane);
/* Coordinate along axis a of point i of component c (TS_FLOW_CENTRES: of a cell centre); ghosts have that
 * of the last point inside, or of their periodic image. */
double ts_flow_coordinate(const struct ts_grid *grid, int a, int c, int i);

/* Linear interpolation in time from a (fraction 0) to b (1); exact at both ends and if a == b. */
static inline double ts_flow_interpolate_time(double a, double b, double fraction)
{
	return fraction < 1 ? a + fraction * (b - a) : b;
}

/* ---- boundary_pressure.c */

/* Evaluates the pressure given on a face, at this time. */
enum ts_status ts_projection_evaluate_pressure(struct ts_projection *projection, struct tsim *sim, int d,
					       enum ts_grid_side side);
enum ts_status ts_projection_store_pressure(struct ts_projection *projection);
/* Called before a solve, after rhs has been made: adds the pressure on open faces to rhs. Until
 * ts_projection_restore_pressure the pressure field, and its ghosts, are without pressure_base; with the
 * incremental projection the values on faces are the changes since the last one. */
enum ts_status ts_projection_impose_pressure(struct ts_projection *projection);
void ts_projection_restore_pressure(struct ts_projection *projection);
enum ts_status ts_projection_archive_pressure(struct ts_projection *projection, struct tsim *sim,
					      struct ts_archive *archive);
void ts_projection_release_pressure(struct ts_projection *projection);
/* Refuses a body force along an open face of constant pressure, and pressure_level with an open face. */
enum ts_status ts_projection_check_pressure(struct ts_instance *self, struct tsim *sim);

#endif
