/* Boundary conditions of the faces of the grid: arguments of flow_boundary, and their values in time. */
#ifndef TS_FLOW_BOUNDARY_H
#define TS_FLOW_BOUNDARY_H

#include "flow/fluid.h"

struct ts_projection;

/* Keyword `hydrostatic`: whether the pressure on an open face increases with depth. */
enum ts_flow_depth { TS_FLOW_PRESSURE_UNSAID, TS_FLOW_EVEN, TS_FLOW_HYDROSTATIC };

/* Arguments of flow_boundary for one face. Strings belong to the instance. */
struct ts_flow_condition {
	enum ts_flow_face kind;
	bool given; /* a flow_boundary command has set this face; else the default applies */
	bool once;  /* velocities are evaluated at the beginning of a run, not in each step */
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
/* Whether nothing flows through any face, at any time, but those that are periodic. */
bool ts_projection_is_tight(const struct ts_projection *projection);

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
