/* Frictionless contact of a rough surface with a plane, on a grid: pressure and gap of each cell so that
 *
 *   gap = displacement(pressure) - height + plane >= 0,   0 <= pressure <= hardness,
 *   pressure = 0 where gap > 0,
 *
 * for a given mean pressure; the height of the plane is the unknown. Cells at the hardness yield: there the gap is 0
 * and the height is reduced by a permanent indentation (rigid, ideally plastic). With two rough surfaces, height is
 * the sum of both.
 *
 * Two models of the displacement:
 *   half space   each cell displaces all others (rough/half_space.h): the pressures of least energy within these
 *                limits, by projected gradients (Y.-H. Dai, R. Fletcher, Math. Program. 106 (2006) 403): one sum over
 *                all pairs of cells an iteration. The conjugate gradients of I. A. Polonsky, L. M. Keer, Wear 231
 *                (1999) 206 need two, and do not converge where nearly all contacts yield
 *   winkler      each cell is a spring of its own, displacement = pressure/stiffness; solved by bisection */
#ifndef TS_ROUGH_ROUGH_CONTACT_H
#define TS_ROUGH_ROUGH_CONTACT_H

#include <stdbool.h>

#include "rough/half_space.h"

struct ts_rough_problem {
	int n[2];
	double width[2];      /* of the cells, length */
	const double *height; /* [n[1]][n[0]], length; up is towards the plane */
	bool periodic;	      /* half space only */
	double modulus;	      /* half space: E*, pressure */
	/* half space: zero-initialised, keeps the kernel for further problems with the same grid; NULL: not kept */
	struct ts_half_space *half_space;
	double stiffness;     /* winkler: pressure/length */
	double hardness;      /* pressure; INFINITY: elastic */
	double mean_pressure; /* load over the area of the grid, > 0 and < hardness */
	double tolerance; /* half space: of the gap in contacts, in units of the deviation of the heights */
	int iterations;	  /* half space: limit */
	int threads;
};

struct ts_rough_result {
	double *pressure, *gap; /* [n[1]][n[0]]; given by the caller */
	double plane;		/* height of the plane, length; heights of the half space as in `height` */
	double area;		/* part of the area with pressure > 0 */
	/* The same, corrected for the error of counting cells: less (pi - 1 + ln 2)/24 times the length of the borders
	 * of contacts, in cells, over the number of cells (V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int.
	 * 114 (2017) 161) */
	double smooth_area;
	double plastic_area; /* part at the hardness */
	double mean_gap;     /* length */
	double max_pressure;
	int iterations;
	double residual; /* as `tolerance` */
};

/* Returns TS_OK; TS_NOMEM; TS_RANGE: the hardness cannot carry the load, or numbers are too large or too
 * small (half space: pressures, and displacements of a cell by the mean pressure, beyond 1e-140 .. 1e140); TS_PHYSICS: `iterations` were not enough. The
 * result is what was reached. */
enum ts_status ts_rough_half_space(const struct ts_rough_problem *problem, struct ts_rough_result *result);
enum ts_status ts_rough_winkler(const struct ts_rough_problem *problem, struct ts_rough_result *result);

/* Sets the figures of the result that follow from pressure and gap. */
void ts_rough_summarise(const struct ts_rough_problem *problem, struct ts_rough_result *result);

#endif
