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
#include "flow/poisson.h"

#define TS_FAMILY_PROJECTION "projection"

enum ts_wall_form { TS_WALL_QUADRATIC, TS_WALL_LINEAR };
extern const char *const ts_flow_face_names[]; /* of enum ts_flow_face */

/* flow_boundary, for one face. Strings belong to the instance. */
struct ts_flow_condition {
	enum ts_flow_face kind;
	bool said; /* else the default */
	struct ts_number velocity[3];
	const char *set[3]; /* internal variables that get coordinates, or NULL */
	struct ts_place where;
};

struct ts_projection {
	struct ts_fluid fluid; /* first */

	/* as given */
	double viscosity, density, gamma;
	struct ts_instance *region;
	struct ts_words cell_words, body_words;
	int convection, form, wall;
	struct ts_flow_condition condition[3][2];

	bool read; /* the words, into: */
	int64_t cells[3];
	struct ts_number body_force[3];
	double *graded[3]; /* faces by flow_grid, from 0 to 1; NULL: uniform */

	double *work[3]; /* the predictor */
	double *rhs;
	struct ts_operators operators;
	struct ts_poisson poisson;
	struct ts_instance *pressure; /* who solves; NULL: not asked yet */
	uint64_t removals;	      /* of instances, when it was chosen */
};

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
enum ts_status ts_projection_prepare(struct ts_instance *self, struct tsim *sim);
void ts_projection_release(struct ts_projection *projection);

/* Makes the velocity free of divergence: u -= dt/rho grad p. */
enum ts_status ts_projection_project(struct ts_instance *self, struct tsim *sim, double dt);
/* The same for a field that was set: the pressure does not count. */
enum ts_status ts_projection_start(struct ts_instance *self, struct tsim *sim);
/* One step of the fluid. */
enum ts_status ts_projection_advance(struct ts_instance *self, struct tsim *sim, double dt);

/* Evaluates what variables say about the faces: velocities given, now. boundary.c */
enum ts_status ts_projection_boundary(struct ts_instance *self, struct tsim *sim);
/* Kinds of the faces by settings and box; refuses what cannot be. */
enum ts_status ts_projection_faces(struct ts_instance *self, struct tsim *sim);
/* Flow through the whole boundary outwards per volume of the grid, by the velocities given; refused where
 * nothing can leave and it is not zero. */
enum ts_status ts_projection_balance(struct ts_instance *self, struct tsim *sim, double *mean);

#endif
