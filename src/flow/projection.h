/* The projection method on a staggered grid: what flow_style projection keeps, and how a step is made.
 *
 * Chorin, Math. Comp. 22 (1968) 745; Harlow & Welch, Phys. Fluids 8 (1965) 2182.
 * A predictor u* with all but the pressure; then div(w grad p) = rho/dt (div(e u*) + de/dt), and
 * u = u* - dt/rho grad p. */
#ifndef TS_FLOW_PROJECTION_H
#define TS_FLOW_PROJECTION_H

#include "flow/flow.h"
#include "flow/fluid.h"
#include "flow/operators.h"
#include "flow/time_schemes.h"
#include "poisson/poisson.h"

#define TS_FAMILY_PROJECTION "projection"

enum ts_flow_wall_form { TS_WALL_QUADRATIC, TS_WALL_LINEAR };

/* Whether the pressure on an open face grows with depth. */
enum ts_flow_depth { TS_FLOW_PRESSURE_UNSAID, TS_FLOW_EVEN, TS_FLOW_HYDROSTATIC };

/* flow_boundary, for one face. Strings belong to the instance. */
struct ts_flow_condition {
	enum ts_flow_face kind;
	bool said; /* else the default */
	bool once; /* velocities are evaluated when a run begins, not in each step */
	struct ts_number velocity[3];
	struct ts_number pressure;
	enum ts_flow_depth hydrostatic;
	const char *set[3]; /* internal variables that get coordinates, or NULL */
	struct ts_place where;
};

static inline bool ts_flow_condition_shaped(const struct ts_flow_condition *condition)
{
	return condition->set[0] || condition->set[1] || condition->set[2];
}

enum { TS_FLOW_CENTRES = -1 }; /* points of a face that are no component's */

/* One number given on a face, which may be a formula: what it is, and at the points of which component. */
struct ts_flow_formula {
	const struct ts_number *number;
	const char *what;
	int component;
};

struct ts_projection {
	struct ts_fluid fluid; /* first */

	/* as given */
	double viscosity, density, gamma, courant;
	int64_t every;
	const char *substeps_word;
	struct ts_instance *region;
	struct ts_words cell_words, body_words;
	int convection, form, wall, time, viscous;
	struct ts_flow_condition condition[3][2];

	/* Velocities given at the last step of the fluid and now; fluid.given is between them. */
	struct ts_flow_face_velocity before[3][2], now[3][2];
	uint8_t before_known;
	/* The same for pressures on open faces, and those of the projection to come. */
	struct ts_flow_face_pressure pressure_before[3][2], pressure_now[3][2], pressure_next[3][2];
	double next_base;      /* pressure_base of the fluid in that projection */
	double pressure_share; /* how far that is from the last step of the fluid (0) to now (1) */
	struct ts_number level; /* mean pressure where no face is open */
	double level_now;
	bool still; /* the projection is one of a field that was set: no pressure drives it */

	bool moved; /* a run has made steps with it, or would have (-check) */
	bool read;  /* the words, into: */
	int64_t cells[3];
	int64_t substeps; /* 0: as many as its limits want */
	struct ts_number body_force[3];
	double *graded[3]; /* faces by flow_grid, from 0 to 1; NULL: uniform */

	double *work[3];    /* the predictor */
	double *second[3];  /* and a second one, for schemes of several stages */
	double *history[3]; /* the rate of the step before, for ab2 */
	double history_dt;  /* how long that was; 0: there is none */
	double *increment;  /* change of the pressure, where viscosity is implicit */
	double theta;	    /* how far it is: 1/2 or 1 */
	/* Set by the search for regions that bodies close off (immersed/closed_regions.h) if what is given there changes with
	 * time: called before each step of the fluid. NULL: nothing to check. */
	enum ts_status (*check_closed)(struct tsim *sim);
	bool told_walls;    /* that walls hold a fluid without viscosity */
	bool filled;	    /* ghosts of u are those of the faces as they are */
	double *rhs;
	double *weight[3];    /* of faces in the projection, where particles take part in it */
	double *empty_before; /* void fraction at the last step */
	/* form conservative, at lower faces: e of the step before and its rate, what the velocities at the beginning of the
	 * step and of the stage before are multiplied by */
	double *room_before[3], *room_rate[3], *room_start[3], *room_last[3];
	double room_elapsed; /* between e of the step before and now */
	uint8_t empty_known;  /* it has been set */
	int64_t source_steps; /* steps of the simulation since the last one of the fluid */
	double source_share;  /* 1/source_steps, while sources are used */
	int64_t done;	      /* substeps in the last step */
	int64_t now_at;	      /* which of them it is, from 0 */
	int64_t waited;	      /* steps of the simulation since the last step of the fluid */
	struct ts_operators operators;
	struct ts_poisson poisson;
	struct ts_instance *pressure; /* who solves; NULL: not asked yet */
	uint64_t removals;	      /* of instances, when it was chosen */
	bool weighted;		      /* for faces of different weights */
};

/* Nothing has happened yet: not a step of the simulation. */
static inline bool ts_projection_not_started(const struct ts_projection *p)
{
	return p->fluid.steps == 0 && p->waited == 0;
}

/* The live flow style with its projection, for commands that change it. */
enum ts_status ts_projection_require(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_instance **instance, struct ts_projection **out);

/* Three numbers or v_NAMEs; strings go to the arena. */
enum ts_status ts_flow_read_vector(struct tsim *sim, const char *what, struct ts_words words,
				   const struct ts_place *where, struct ts_arena *arena,
				   struct ts_number out[3]);
/* `x NAME` and so on: internal variables that get coordinates. */
enum ts_status ts_flow_read_set(struct tsim *sim, const char *what, struct ts_words words,
				const struct ts_place *where, struct ts_arena *arena,
				const char *out[3]);
/* Gives these variables the coordinates of x. */
enum ts_status ts_flow_set_coordinates(struct tsim *sim, const char *const set[3], const double x[3],
				       const struct ts_place *where);

/* Grid, fields, boundary values and operators as settings and box are now. */
enum ts_status ts_projection_setup(struct ts_instance *self, struct tsim *sim);
void ts_projection_release(struct ts_projection *projection);

/* void_fraction.c. From `empty`: its ghosts, faces and rate; `elapsed` since the last step. */
enum ts_status ts_projection_update_void_fraction(struct ts_projection *projection, double elapsed);
/* Whether e u is stepped forward. */
static inline bool ts_projection_conservative(const struct ts_projection *projection)
{
	return projection->form == TS_FORM_CONSERVATIVE && projection->fluid.empty;
}
/* The void fraction in the product e u of a stage, for the predictor. */
void ts_projection_stage_void_fraction(struct ts_projection *projection, struct ts_predictor *stage, int s);
/* Sum of de/dt over the grid. */
double ts_projection_void_rate_integral(const struct ts_projection *projection);
/* Weights of the faces in the projection of a stage of length dt. */
enum ts_status ts_projection_face_weights(struct ts_projection *projection, double dt);
/* Forces of the particles act on the velocity for dt. */
void ts_projection_apply_particle_forces(struct ts_projection *projection, double dt);
/* used <- take (carry used + u): what stages make of the velocities that k multiplied. */
void ts_projection_average_exchange(struct ts_projection *projection, double carry, double take);
void ts_projection_clear_sources(struct ts_projection *projection);

/* Who solves for the pressure, prepared for the faces and weights of now. */
enum ts_status ts_projection_solver(struct ts_instance *self, struct tsim *sim, double held);
/* Makes the velocity, whose boundary is filled, free of divergence: u -= dt/rho grad p. `held`: for how long particles hold the fluid in
 * it by their k, dt or 0. */
enum ts_status ts_projection_project_velocity(struct ts_instance *self, struct tsim *sim, double dt, double held);
/* div(e u) + de/dt in a row of cells. */
void ts_flow_divergence_row(const struct ts_fluid *fluid, int j, int k, double *out);
/* The same for a field that was set: the pressure does not count. */
enum ts_status ts_projection_project_initial(struct ts_instance *self, struct tsim *sim);
/* One step of the fluid; `carry`: see ts_projection_average_exchange, what its first stage takes over. */
enum ts_status ts_projection_substep(struct ts_instance *self, struct tsim *sim, double dt, double carry);
/* All the steps of the fluid that a step of the simulation of this length has. */
enum ts_status ts_projection_step(struct ts_instance *self, struct tsim *sim, double length);
/* Courant number, change and divergence of the last step; an error when it went wrong. */
enum ts_status ts_projection_check_substep(struct ts_instance *self, struct tsim *sim, double *const before[3],
				   double dt);

/* Evaluates what variables say about the faces: velocities given, now. boundary.c */
enum ts_status ts_projection_evaluate_boundary(struct ts_instance *self, struct tsim *sim);
/* The faces get what is given between the last step of the fluid (0) and now (1). */
void ts_projection_interpolate_boundary(struct ts_projection *projection, double share);
/* What is given now becomes what was given at the last step. */
enum ts_status ts_projection_store_boundary(struct ts_projection *projection);
/* Planes of velocities given, for restart files. */
enum ts_status ts_projection_archive_boundary(struct ts_projection *projection, struct tsim *sim,
					   struct ts_archive *archive);
/* One of these numbers as it is now; an error where it is not finite. */
enum ts_status ts_flow_formula_value(struct tsim *sim, const struct ts_flow_condition *condition,
				   const struct ts_flow_formula *formula, double *out);
/* At all points of the face. */
enum ts_status ts_flow_fill_plane(struct tsim *sim, const struct ts_flow_condition *condition,
				  const struct ts_flow_formula *formula, const struct ts_grid *grid, int d,
				  enum ts_grid_side side, double *plane);
/* Where point i of a component (TS_FLOW_CENTRES: of cells) stands along axis a; beyond the grid as its last point, or
 * periodically. */
double ts_flow_coordinate(const struct ts_grid *grid, int a, int c, int i);

/* Exact at both ends, and where nothing changes. */
static inline double ts_flow_interpolate_time(double a, double b, double share)
{
	return share < 1 ? a + share * (b - a) : b;
}

/* face_pressure.c. What variables say about the pressure on a face, now. */
enum ts_status ts_projection_evaluate_pressure(struct ts_projection *projection, struct tsim *sim, int d,
					   enum ts_grid_side side);
enum ts_status ts_projection_store_pressure(struct ts_projection *projection);
/* Before a solve, with rhs made: the pressure on open faces goes into it; the field to be found, and its ghosts, are
 * without pressure_base, and a change from the last one where the pressure is ahead. After it: as it was. */
enum ts_status ts_projection_impose_pressure(struct ts_projection *projection);
void ts_projection_restore_pressure(struct ts_projection *projection);
enum ts_status ts_projection_archive_pressure(struct ts_projection *projection, struct tsim *sim,
					      struct ts_archive *archive);
void ts_projection_release_pressure(struct ts_projection *projection);
/* Refuses a body force along a face of even pressure, and a level beside one. */
enum ts_status ts_projection_check_pressure(struct ts_instance *self, struct tsim *sim);

/* Kinds of the faces by settings and box; refuses what cannot be. */
enum ts_status ts_projection_set_face_types(struct ts_instance *self, struct tsim *sim);
/* Flow through the whole boundary outwards per volume of the grid, by the velocities given; refused where
 * nothing can leave and it is not zero. */
enum ts_status ts_projection_net_outflow(struct ts_instance *self, struct tsim *sim, double *mean);

#endif
