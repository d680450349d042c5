/* The Poisson equation of the pressure, and the interface of its solvers (pressure styles).
 *
 * For each cell P, summed over its faces f with the neighbour N across:
 *
 *   sum_f  w_f A_f/d_f (p_N - p_P)  =  rhs_P V_P
 *
 * with A_f the area of the face, d_f the distance between the centres, V_P the volume of the cell, w_f the
 * weight of the face (the void fraction with particles; else 1). This is the discrete div(w grad p) = rhs.
 * Boundary conditions: periodic, zero gradient, or a pressure given on the face, half a cell from the
 * centre. The value given is p = 0; the caller adds other values to rhs. If no face gives a pressure the
 * system is singular: the caller has made rhs sum to zero, and solvers return the solution whose
 * volume-weighted mean is zero.
 *
 * Sources: Chorin, Math. Comp. 22 (1968) 745; Harlow & Welch, Phys. Fluids 8 (1965) 2182. */
#ifndef TS_POISSON_POISSON_H
#define TS_POISSON_POISSON_H

#include "core/sim.h"
#include "grid/grid.h"
#include "rank/slabs.h"

enum ts_pressure_condition {
	TS_PRESSURE_PERIODIC,
	/* zero gradient: the velocity across the face is given (wall, slip, inlet) */
	TS_PRESSURE_NO_GRADIENT,
	TS_PRESSURE_GIVEN /* outlet */
};

struct ts_poisson {
	const struct ts_grid *grid;
	enum ts_pressure_condition condition[3][2]; /* [axis][0 low, 1 high] */
	/* Weights at the lower faces of cells, fields as velocity components; NULL: 1 everywhere. Weights
	 * may change between solves; grid and conditions only with a new call of `prepare`. */
	const double *weight[3];
	bool singular; /* no face gives a pressure */
	int threads;
	struct ts_slabs *slabs; /* planes of cells across the last axis, of ranks; NULL: no ranks */
	bool apart;		/* each rank has weights of its own planes, and those beside them, only */
};

struct ts_poisson_report {
	int iterations;	 /* 0: a direct solver */
	double residual; /* max |rhs - div(w grad p)|, where the solver knows it, else NaN */
};

/* A style of kind "pressure": one solver. `pressure_style auto` (no style of its own) is resolved by
 * ts_pressure_choose (poisson/pressure_choice.h). */
struct ts_pressure_style {
	struct ts_style style;
	/* Whether the solver is applicable; if not, *why is set to the reason ("weights vary"). NULL:
	 * always. */
	bool (*suits)(const struct ts_poisson *problem, const char **why);
	/* Called for a new grid or new conditions: allocates memory and makes plans. `problem` stays valid
	 * until the next call. */
	enum ts_status (*prepare)(struct ts_instance *self, struct tsim *sim,
				  const struct ts_poisson *problem);
	/* rhs: only inner cells are read. p: the initial guess, then the solution; ghosts are not written.
	 * The result is bitwise the same for any number of threads. */
	enum ts_status (*solve)(struct ts_instance *self, struct tsim *sim, const double *rhs, double *p,
				struct ts_poisson_report *report);
	/* While ranks have slabs: whether `solve` reads rhs and sets p in the planes of this rank only; else it does in all
	 * planes. NULL: it never does. */
	bool (*divided)(const struct ts_instance *self);
	/* The same for all weights that the problem may have; NULL: as `divided`. */
	bool (*always_divided)(const struct ts_instance *self);
	/* While ranks have slabs: exchanges what a solve of so many iterations exchanges, without solving, for the present
	 * rank of their communicator (rank/rehearsal.h). NULL: it exchanges nothing. */
	enum ts_status (*rehearse)(struct ts_instance *self, int iterations);
	/* Iterations from one computation of the residual to the next; 0: a direct solver. */
	int looks;
	/* Estimated time of a solve in seconds, for the choice of the default and for -explain. `self` may
	 * be NULL: with the default arguments. */
	double (*cost)(const struct ts_instance *self, const struct ts_poisson *problem);
	int fields; /* memory it needs, as a number of fields of one double per cell, approximate */
};

static inline const struct ts_pressure_style *ts_pressure_style_of(const struct ts_instance *inst)
{
	return (const struct ts_pressure_style *)inst->style;
}

static inline bool ts_pressure_suits(const struct ts_pressure_style *style, const struct ts_poisson *problem,
				     const char **why)
{
	return !style->suits || style->suits(problem, why);
}

/* out = div(w grad p) in the inner cells, for residuals and tests. Reads p in inner cells only. */
void ts_poisson_apply(const struct ts_poisson *problem, const double *p, double *out);

/* 1/d_f of the lower face of cell i along axis d, 0 <= i <= n (1/length). At a boundary d_f is half a
 * cell; 0 with zero gradient. */
double ts_poisson_conductance(const struct ts_poisson *problem, int d, int i);

#endif
