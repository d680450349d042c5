/* Common parts of iterative pressure styles: tolerance, system of equations, end of the iterations. */
#ifndef TS_POISSON_PRESSURE_STYLE_H
#define TS_POISSON_PRESSURE_STYLE_H

#include "poisson/poisson.h"
#include "poisson/stencil.h"

/* Number of threads to use for the problem. */
int ts_pressure_team(const struct tsim *sim, const struct ts_poisson *problem);

enum ts_iteration_unfinished { TS_UNFINISHED_STOP, TS_UNFINISHED_WARN };

/* First member of the state of iterative solvers. */
struct ts_iteration {
	double tolerance; /* largest residual by largest right-hand side */
	int64_t most;	  /* largest number of iterations */
	int unfinished;	  /* enum ts_iteration_unfinished */
	bool warned;	  /* the warning has been written */
	bool weighed;	  /* the links have been set; without weights that is done once */
	bool part;	  /* those of the planes of this rank only */
	bool changed;	  /* the last ts_iteration_begin has changed the links */
	struct ts_stencil stencil;
	const struct ts_poisson *problem;
	double *b, *p;	/* right-hand side and solution, fields of the stencil; owned */
	double largest; /* largest |b| per volume */
};

extern const char *const ts_iteration_unfinished_names[];
#define TS_ITERATION_ARGS(T, f, tolerance_, most_)                                                         \
	TS_REAL("tolerance", T, f.tolerance, .range = TS_WITHIN, .lo = 1e-16, .hi = 1e-3,                  \
		.fallback = tolerance_, .unit = "",                                                        \
		.help = "largest residual divided by the largest right-hand side, at which the iteration " \
			"stops; above 1e-3 the volume of the fluid would not be conserved"),               \
		TS_INT("iterations", T, f.most, .range = TS_POSITIVE, .fallback = most_, .unit = "",       \
		       .help = "largest number of iterations"),                                            \
		TS_ENUM("unfinished", T, f.unfinished, ts_iteration_unfinished_names, .fallback = "stop",  \
			.help = "if the tolerance is not reached: stop the run, or print a warning once")

enum ts_status ts_iteration_prepare(struct ts_iteration *it, struct tsim *sim,
				    const struct ts_poisson *problem);
void ts_iteration_release(struct ts_iteration *it);
/* Sets links, right-hand side and initial guess, and the residual to be reached; *goal 0: the solution is
 * 0. */
enum ts_status ts_iteration_begin(struct ts_iteration *it, struct ts_instance *self, struct tsim *sim,
				  const double *rhs, const double *p, double *goal);
/* What ts_iteration_begin and ts_iteration_end exchange among ranks. */
void ts_iteration_rehearse(struct ts_iteration *it);
/* Copies the solution to `p`; an error or a warning if the residual is larger than the goal. */
enum ts_status ts_iteration_end(struct ts_iteration *it, struct ts_instance *self, struct tsim *sim,
				double goal, const struct ts_poisson_report *report, double *p);

#endif
