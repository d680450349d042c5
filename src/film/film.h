/* Lubrication films: the Reynolds equation in the gap h(x, y) between two surfaces 1 (lower) and 2 (upper),
 *
 *   dh/dt + div q = 0,   q = h (U1 + U2)/2 - h^3/(12 eta) grad p
 *
 * (O. Reynolds, Phil. Trans. 177 (1886) 157; B. J. Hamrock, S. R. Schmid & B. O. Jacobson, Fundamentals of Fluid
 * Film Lubrication, 2nd ed. (2004), chapter 7). U1 and U2 are the velocities of the surfaces along the film, q the
 * flow of volume per width. dh/dt is the rate at a fixed point (x, y): it is 0 where a shape at rest faces a
 * sliding plane, and -U2.grad h where a rigid upper surface slides over a plane at rest (ts_film_carry).
 *
 * Grid: n[0] x n[1] cells between the given faces, in Cartesian coordinates, or in polar ones (first index: radius,
 * second: angle in radians; velocities are radial and azimuthal). Fields are values at centres, [n[1]][n[0]].
 * Finite volumes of second order. The flow through a face is the exact solution of the equation in one dimension
 * between the centres, with a gap that is linear between them, or constant in each cell with a step on the face
 * (enum ts_film_shape). So the pressure of a plane slider and of a Rayleigh step is exact at the centres; with slip
 * the integrals over the gap are by a rule of 5 points. Whatever
 * flows out of a cell flows into its neighbour.
 *
 * Cavitation (enum ts_film_cavitation), pc the pressure in the cavity:
 *   none       p is as the equation gives it, also below pc
 *   half       half-Sommerfeld: afterwards p < pc is replaced by pc; volume is not conserved
 *   reynolds   p >= pc; where p = pc, div q + dh/dt >= 0: p and its gradient are continuous at the rupture of the
 *              film. Volume is conserved in the film, not in the cavity. (H. Swift, Proc. Inst. Civ. Eng. 233 (1932)
 *              267; W. Stieber, Das Schwimmlager (1933).) By an active set: M. Hintermueller, K. Ito & K. Kunisch,
 *              SIAM J. Optim. 13 (2002) 865.
 *   jfo        conserves volume: a fraction theta of the gap is void where p = pc, and theta = 0 where p > pc,
 *                d(h (1 - theta))/dt + div[(1 - theta) h (U1 + U2)/2 - h^3/(12 eta) grad p] = 0,
 *              with theta upwind (B. Jakobsson & L. Floberg 1957; K.-O. Olsson 1965; H. G. Elrod, J. Lubr. Tech. 103
 *              (1981) 350; as complementarity problem: M. Giacopini et al., J. Tribol. 132 (2010) 041702; by Newton's
 *              method: T. Woloszynski, P. Podsiadlo & G. W. Stachowiak, Tribol. Lett. 58 (2015) 18). Theta and the
 *              place where the film ruptures or reforms are of first order.
 *
 * With slip lengths the fluid slips over the surfaces: film_section.c has the flow and the stresses.
 *
 * Rough surfaces have the mean flow and friction of Patir and Cheng: film_roughness.c. Nearer than 3 standard deviations
 * asperities touch: film_asperity.c.
 *
 * The viscosity may depend on the pressure: film_viscosity.c; flows, balances and cavitation are as above.
 *
 * The theory neglects inertia, terms of order (h/L)^2, and the curvature of the surfaces. */
#ifndef TS_FILM_FILM_H
#define TS_FILM_FILM_H

#include <stdbool.h>
#include <stddef.h>

#include "film/grid_lu.h"

enum ts_film_edge {
	TS_FILM_PRESSURE, /* pressure given */
	TS_FILM_NO_FLOW,  /* no flow across: a wall or a plane of symmetry */
	TS_FILM_PERIODIC
};

enum ts_film_kind {
	TS_FILM_FLUID, /* p is solved for */
	TS_FILM_GIVEN, /* p is given: a feed hole, the space outside of the film */
	TS_FILM_SOLID  /* surfaces touch: no fluid, no flow across its faces */
};

/* Of a face: the cell on the side of lower coordinates, and the other one. */
enum ts_film_half { TS_FILM_BELOW, TS_FILM_ABOVE };
enum ts_film_shape { TS_FILM_LINEAR, TS_FILM_STEPPED };
enum ts_film_cavitation { TS_FILM_NONE, TS_FILM_HALF, TS_FILM_REYNOLDS, TS_FILM_JFO };

/* How the viscosity depends on the pressure: film_viscosity.c. */
enum ts_film_law { TS_FILM_CONSTANT, TS_FILM_BARUS, TS_FILM_ROELANDS };
struct ts_film_piezo {
	enum ts_film_law law;
	double alpha;		    /* Barus (1/pressure), >= 0 */
	double viscosity, pressure; /* Roelands: eta_r < viscosity of the film, p_r > 0 */
	double exponent;	    /* Roelands: Z, 0 to 1 */
};

/* Peklenik numbers of rough surfaces, correlation length along axis 0 by that along axis 1: 1/9 to 9. */
enum ts_film_peklenik {
	TS_FILM_PEKLENIK_1_9,
	TS_FILM_PEKLENIK_1_6,
	TS_FILM_PEKLENIK_1_3,
	TS_FILM_PEKLENIK_1,
	TS_FILM_PEKLENIK_3,
	TS_FILM_PEKLENIK_6,
	TS_FILM_PEKLENIK_9
};

/* Asperities of rough surfaces: film_asperity.c. */
struct ts_film_asperity {
	double density; /* number per area; 0: the surfaces may not touch */
	double radius, modulus;
	double friction; /* coefficient */
};

struct ts_film_report {
	int solves;	   /* linear systems solved, those on coarser grids included */
	bool driven;	   /* false: no sliding, no squeeze, one pressure at all edges: nothing flows */
	double balance;	   /* largest |sum of flows out of a cell| where the equation holds (volume/time) */
	double imbalance;  /* volume per time that half or reynolds create in the cavity; else 0 */
	double throughput; /* sum of |flow| through all faces by their number: a measure for the two above */
	size_t cavitated;  /* number of cells with p = pc */
};

struct ts_film {
	/* given before ts_film_make */
	int n[2];
	bool polar;
	enum ts_film_edge edge[2][2]; /* [axis][0 low, 1 high] */
	enum ts_film_shape shape;
	enum ts_film_cavitation cavitation;
	double viscosity, density; /* dynamic, at pressure 0; both > 0 */
	struct ts_film_piezo piezo;
	double slip[2];	     /* slip lengths of the surfaces [0 lower, 1 upper]; Cartesian grids only */
	double roughness[2]; /* standard deviations of the heights of the surfaces; h is the mean gap */
	enum ts_film_peklenik peklenik; /* of both surfaces */
	struct ts_film_asperity asperity;
	double cavity_pressure; /* pc */
	double ambient; /* pressure on the other sides of the surfaces: loads are sums of p - ambient */
	/* in parts of the film without any given pressure one cell has `ambient`; false: there must be none */
	bool floating;
	double edge_pressure[2][2];
	double edge_void[2][2]; /* jfo: theta of the film that enters, 0 <= theta < 1 */
	double time_step;	/* jfo: length of the step from `content` to now; 0: steady */

	/* made by ts_film_make, filled by the caller; released by ts_film_release */
	double *face[2];	 /* n + 1 coordinates of the borders of cells, ascending; set to 0 .. n */
	double *gap;		 /* h */
	double *rate;		 /* dh/dt; jfo with a time step uses the change of h (1 - theta) instead */
	double *velocity[2][2];	 /* of the surface [0 lower, 1 upper] along [axis] */
	enum ts_film_kind *kind; /* all TS_FILM_FLUID */
	double *pressure_given;	 /* in cells TS_FILM_GIVEN */
	double *content;	 /* jfo with a time step: h (1 - theta) at its beginning */

	/* results of ts_film_solve */
	double *p;     /* pressure; in solid cells pc */
	double *empty; /* theta; 0 unless jfo */
	double *flow
		[2]; /* volume per time through the lower face of a cell, positive along the axis; on axis 0
			  * [n[1]][n[0] + 1], on axis 1 [n[1] + 1][n[0]] */
	struct ts_film_report report;

	/* internal */
	double *conductance[2], *transport[2]; /* of faces: flow = conductance dp + transport (1 - theta) */
	/* ride[TS_FILM_BELOW][axis], of faces: flow per width in the cell below, less that through the face, as a moving step
	 * takes up the rest; TS_FILM_ABOVE: in the cell above */
	double *ride[2][2];
	double *source; /* volume per time that the motion of the surfaces takes up */
	double *value, *residual, *step;
	double scale[2]; /* jfo: sums of |transport| and of the conductances */
	bool *pinned;	 /* floating: the pressure of the cell is ambient */
	bool *free;	 /* reynolds, jfo: the pressure of the cell is solved for */
	struct ts_grid_row *row;
	struct ts_grid_lu lu;
	bool ordered; /* lu is made for the present kinds */
};

static inline size_t ts_film_cells(const struct ts_film *f)
{
	return (size_t)f->n[0] * (size_t)f->n[1];
}

static inline size_t ts_film_at(const struct ts_film *f, int i, int j)
{
	return (size_t)j * (size_t)f->n[0] + (size_t)i;
}

/* Index in flow[axis] of the lower face of cell (i, j); i or j = n: the upper edge. */
static inline size_t ts_film_face(const struct ts_film *f, int axis, int i, int j)
{
	return (size_t)j * (size_t)(f->n[0] + (axis == 0)) + (size_t)i;
}

static inline double ts_film_centre(const struct ts_film *f, int axis, int i)
{
	return (f->face[axis][i] + f->face[axis][i + 1]) / 2;
}

/* Area of a cell. */
double ts_film_area(const struct ts_film *f, int i, int j);

/* ---- film.c, film_check.c */

/* Allocates all fields, set to 0. Returns TS_OK or TS_NOMEM; to be released also after a failure. */
enum ts_status ts_film_make(struct ts_film *f);
/* Memory of the fields and of the factors of the matrix, about. */
double ts_film_bytes(const struct ts_film *f);
void ts_film_release(struct ts_film *f);
/* Checks all input. Errors: TS_RANGE for values (gap, viscosity ...), TS_STATE for a part of the film whose pressure
 * is not determined, because no pressure is given on its border and it may not float. */
enum ts_status ts_film_check(const struct ts_film *f, struct ts_error *error);
/* Whether any cell is not solid. */
bool ts_film_has_fluid(const struct ts_film *f);

/* The least gap for which the film is known: 0, or a multiple of the roughness. */
double ts_film_least_gap(const struct ts_film *f);

/* ---- film_asperity.c */

/* Pressure of the asperities at a gap, its derivative, and the part of the area in contact. */
struct ts_film_touch {
	double pressure, slope, area;
};
struct ts_film_touch ts_film_touch(const struct ts_film *f, double h);

/* ---- film_faces.c */

/* Adds to `rate` that of z, the gap or the sum of the heights of both surfaces, at the centres of cells whose shape moves
 * along the film with a velocity: -div(V z), z on a face with the weights of the flow through it, times `part` of the cell
 * (NULL: 1). So the flow with both surfaces faster by W is that without and W h: a shape that moves has the pressure of one
 * at rest below a surface that moves the other way, to round-off, also where it has steps. gap and kind are set; Cartesian
 * grids. Adds to `ride`, too. */
void ts_film_carry(struct ts_film *f, const double *z, const double velocity[2], const double *part,
		   double *rate);

/* ---- film_solve.c */

/* Checks the input and solves for p, theta and flows. Further errors: TS_STATE if the equations do not determine
 * theta (jfo, no sliding, no time step), TS_PHYSICS if the iteration does not converge, a floating part
 * of the film changes its volume, or no
 * pressure satisfies the equation with a viscosity that depends on it. */
enum ts_status ts_film_solve(struct ts_film *f, struct ts_error *error);
/* ---- film_response.c: after a solution, of constant viscosity */

/* Between begin and end, gap and rate may be changed by little. respond returns the change of p from that of the solution,
 * to first order, until the next call. Gap and rate are those of the solution again when `end` is called. */
enum ts_status ts_film_begin_response(struct ts_film *f, struct ts_error *error);
const double *ts_film_respond(struct ts_film *f);
void ts_film_end_response(struct ts_film *f);

/* jfo in time: content = h (1 - theta) of the present solution, for the next step. */
void ts_film_keep_content(struct ts_film *f);

/* What the theory neglects, of which the relative errors are multiples: by the mean gap h, the length L of the film between
 * edges of given pressure, the largest difference U of the velocities of the surfaces. 0: L is not known. */
struct ts_film_validity {
	double inertia;	  /* rho U h/eta * h/L */
	double thickness; /* h/L; its square is neglected */
	double slope;	  /* largest slope of the gap between cells; its square is neglected */
};
struct ts_film_validity ts_film_validity(const struct ts_film *f);

#endif
