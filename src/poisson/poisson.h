/* Pressure: what a projection asks to be solved, and what solvers (pressure styles) offer.
 *
 * For each cell P the balance of its faces f with the neighbour N across:
 *
 *   sum_f  w_f A_f/d_f (p_N - p_P)  =  rhs_P V_P
 *
 * A_f the area of the face, d_f the distance of the centres, V_P the volume, w_f the weight of the face (the
 * void fraction in beds; 1 without). That is the discrete div(w grad p) = rhs. At boundaries: periodic, no
 * gradient, or a pressure given on the face itself (at half a cell; its value is p = 0: who has another one puts it
 * into rhs). If no face gives a pressure the system is singular: rhs has been made to sum to zero by who asks, and
 * solvers return the solution whose volume-weighted mean is zero.
 *
 * Sources: Chorin, Math. Comp. 22 (1968) 745; Harlow & Welch, Phys. Fluids 8 (1965) 2182. */
#ifndef TS_POISSON_POISSON_H
#define TS_POISSON_POISSON_H

#include "core/sim.h"
#include "grid/grid.h"

enum ts_pressure_condition {
	TS_PRESSURE_PERIODIC,
	TS_PRESSURE_NO_GRADIENT, /* the velocity across the face is given: wall, slip, inlet */
	TS_PRESSURE_GIVEN        /* outlet */
};

struct ts_poisson {
	const struct ts_grid *grid;
	enum ts_pressure_condition condition[3][2]; /* [axis][0 low, 1 high] */
	/* Weights at lower faces of cells, as velocity components are; NULL: 1 everywhere. They may change from
	 * solve to solve, grid and conditions only with a new prepare. */
	const double *weight[3];
	bool singular;
	int threads;
};

struct ts_poisson_report {
	int iterations;  /* 0: a direct solver */
	double residual; /* max |rhs - div(w grad p)|, where the solver knows it, else NaN */
};

/* A style of kind "pressure": one solver. `pressure_style auto` (no style of its own) is resolved by
 * ts_pressure_choose. */
struct ts_pressure_style {
	struct ts_style style;
	/* Whether it can solve this; else *why says why not ("weights vary"). NULL: it can solve all. */
	bool (*suits)(const struct ts_poisson *problem, const char **why);
	/* New grid or conditions: takes memory, makes plans. `problem` stays valid until the next prepare. */
	enum ts_status (*prepare)(struct ts_instance *self, struct tsim *sim,
				  const struct ts_poisson *problem);
	/* rhs: inner cells count, ghosts are not read. p: the first guess, then the solution; ghosts are not
	 * written. Bitwise the same for any number of threads. */
	enum ts_status (*solve)(struct ts_instance *self, struct tsim *sim, const double *rhs,
				double *p, struct ts_poisson_report *report);
	/* Seconds a solve will cost, roughly, for the choice of the default and -explain. self may be NULL: with
	 * the arguments' defaults. */
	double (*cost)(const struct ts_instance *self, const struct ts_poisson *problem);
	int fields; /* that it keeps, about, in numbers of the cells */
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

/* The live pressure style, or the default for this problem (made on the first call; rules in its doc and in
 * -explain). */
enum ts_status ts_pressure_choose(struct tsim *sim, const struct ts_poisson *problem,
				  const struct ts_place *where, struct ts_instance **out);

/* A line of the plan: which solver, why, and how long a solve will take. `weights`: there will be some. */
struct ts_plan_report;
void ts_pressure_explain(const struct tsim *sim, const struct ts_poisson *problem, bool weights,
			 struct ts_plan_report *report);

/* out = div(w grad p) in the inner cells: the operator itself, for residuals and tests. Reads p of inner cells
 * only. */
void ts_poisson_apply(const struct ts_poisson *problem, const double *p, double *out);

/* 1/d of the lower face of cell i, 0 <= i <= n: across a boundary half a cell, or 0 where no gradient is. */
double ts_poisson_conductance(const struct ts_poisson *problem, int d, int i);

#endif
