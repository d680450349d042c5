/* Parts of the film solver that its files share. */
#ifndef TS_FILM_INTERNAL_H
#define TS_FILM_INTERNAL_H

#include "film/film.h"

/* The two cells of a face, -1: none (edge of the grid), and whether the face is between fluid or given cells. */
struct ts_film_sides {
	int low, high;
	bool open;
};

/* ---- film_section.c */

/* Of a cross-section with the gap h: q = couette[0] U1 + couette[1] U2 - poiseuille/(12 eta) grad p. The shear force per
 * area on the surface k is +-eta drag[k] (U2 - U1) - grip[k] grad p. couette[0] + couette[1] is the volume per area; grip =
 * couette between smooth surfaces. */
struct ts_film_section {
	double drag[2], poiseuille, couette[2], grip[2];
};
struct ts_film_section ts_film_section(const struct ts_film *f, int axis, double h);
/* Whether the section is that of smooth surfaces without slip. */
bool ts_film_is_plain(const struct ts_film *f);
/* Whether a slip length is given. */
static inline bool ts_film_slips(const struct ts_film *f)
{
	return f->slip[0] > 0 || f->slip[1] > 0;
}

/* Velocities of the fluid at both surfaces along an axis, whose own velocities are `wall`; `mean` = q/h. */
void ts_film_slip_velocity(const struct ts_film *f, double h, double mean, const double wall[2],
			   double fluid[2]);

/* ---- film_roughness.c */

bool ts_film_is_rough(const struct ts_film *f);
/* Multiplies a section of smooth surfaces by the flow and shear stress factors. */
void ts_film_add_roughness(const struct ts_film *f, int axis, double h, struct ts_film_section *s);
/* Volume per area, and its derivative by the gap. */
double ts_film_volume(const struct ts_film *f, double h, double *derivative);
enum ts_status ts_film_check_roughness(const struct ts_film *f, struct ts_error *error);

/* ---- film_viscosity.c */

/* Viscosity at a pressure. */
double ts_film_viscosity(const struct ts_film *f, double p);
/* The reduced pressure of a pressure, and the inverse: NaN if there is none. Without dependence the same. */
double ts_film_reduce(const struct ts_film *f, double p);
double ts_film_expand(const struct ts_film *f, double q);
/* Whether a pressure given is in the range of the law. */
bool ts_film_can_reduce(const struct ts_film *f, double p);
enum ts_status ts_film_check_viscosity(const struct ts_film *f, struct ts_error *error);
/* Solves for the reduced pressure by `solve`, which is for constant viscosity, and sets p. */
typedef enum ts_status ts_film_solve_fn(struct ts_film *f, struct ts_error *error);
enum ts_status ts_film_solve_reduced(struct ts_film *f, ts_film_solve_fn *solve, struct ts_error *error);

/* ---- film_faces.c */

/* Cells on both sides of the lower face of cell (i, j) along the axis; periodic faces have two cells. */
struct ts_film_sides ts_film_sides_of(const struct ts_film *f, int axis, int i, int j);
/* Gap on an edge of the grid next to a cell: extrapolated linearly from two cells, at least h/2. */
double ts_film_edge_gap(const struct ts_film *f, int axis, int i, int j, bool high);
/* Gaps of both cells of a face; the one on an edge is that of ts_film_edge_gap, that of a solid cell the one before it. */
void ts_film_end_gaps(const struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s,
		      double h[2]);
/* The cell with fluid beside a face that is an edge of the grid or the side of a solid cell; -1: there is none. */
int ts_film_cell_before(const struct ts_film *f, const struct ts_film_sides *s);
/* Pressure on such a face: the one given; where it is closed, that of the flow in the half cell before it. */
double ts_film_end_pressure(const struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s);
/* Length of a face. */
double ts_film_face_length(const struct ts_film *f, int axis, int i, int j);
/* Velocities of both surfaces along the axis at a face. */
void ts_film_face_velocity(const struct ts_film *f, int axis, const struct ts_film_sides *s, int i, int j,
			   double u[2]);
/* Computes conductance, transport and source. */
void ts_film_set_faces(struct ts_film *f);
/* Calls visit for all faces along axis 0, then axis 1. A periodic face is visited at both ends. */
typedef void ts_film_face_fn(struct ts_film *f, int axis, int i, int j, const struct ts_film_sides *s);
void ts_film_each_face(struct ts_film *f, ts_film_face_fn *visit);

/* ---- film_balance.c */

/* Computes flow from p and empty, and residual = flow out of each cell + source. */
void ts_film_set_flow(struct ts_film *f);
/* The flow through a face, if the gap were full also in the cavity. */
double ts_film_full_flow(const struct ts_film *f, int axis, int i, int j);
/* Rows of the matrix of the fluid cells: derivatives of their balances by p of free cells and by -theta of the
 * others. With `transported` false the others have p = pc, theta = 0 and no unknown. */
void ts_film_set_rows(struct ts_film *f, bool transported);
/* Whether surfaces that slide or approach each other, or pressures given, drive a flow. */
bool ts_film_is_driven(const struct ts_film *f);
/* Round-off of the balance of a cell: of the largest conductance times the largest pressure, the largest transport and
 * the largest content. */
double ts_film_round_off(const struct ts_film *f);
/* Fills the report from flow and residual, but for solves and driven. */
void ts_film_set_report(struct ts_film *f);

/* ---- film_parts.c */

/* Fails if there is a part of the film whose pressure is not determined. */
enum ts_status ts_film_check_parts(const struct ts_film *f, struct ts_error *error);
/* With `floating`: gives one cell of each such part the ambient pressure; takes it back after the solution; checks that
 * the balance of these cells holds, too. */
enum ts_status ts_film_pin_parts(struct ts_film *f, struct ts_error *error);
void ts_film_unpin_parts(struct ts_film *f);
enum ts_status ts_film_check_pinned(const struct ts_film *f, struct ts_error *error);

/* ---- film_guess.c */

/* Whether the grid has enough cells for the following. */
bool ts_film_can_coarsen(const struct ts_film *f);
/* Makes the same problem on half the cells along each axis that has enough of them, with means of the fields. To be
 * released also after a failure. */
enum ts_status ts_film_coarsen(const struct ts_film *f, struct ts_film *coarse);
/* Sets free, p and empty of the fluid cells to a solution on the coarser grid. */
void ts_film_take_guess(struct ts_film *f, const struct ts_film *coarse);

/* ---- film_jfo.c */

/* Solves the problem of enum TS_FILM_JFO from the present p, empty and free, those of TS_FILM_REYNOLDS or a guess. */
enum ts_status ts_film_solve_jfo(struct ts_film *f, struct ts_error *error);

#endif
