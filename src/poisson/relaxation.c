#include "poisson/relaxation.h"

#include <math.h>

#include "math/constants.h"

#include "base/banned.h"

double ts_relaxation_optimal(const struct ts_poisson *problem)
{
	double diagonal = 0, slowest = 0, slow, rho, least = INFINITY;

	for (int d = 0; d < problem->grid->dimensions; d++) {
		const enum ts_pressure_condition *end = problem->condition[d];
		int n = problem->grid->n[d], given;
		double h = (problem->grid->face[d][n] - problem->grid->face[d][0]) / n, angle;

		/* phase of the longest wave along the axis that is not constant: a = 2 pi/n, pi/n or pi/2n */
		given = (end[0] == TS_PRESSURE_GIVEN) + (end[1] == TS_PRESSURE_GIVEN);
		angle = end[0] == TS_PRESSURE_PERIODIC ? 2 * TS_PI / n
			: given == 1		       ? 0.5 * TS_PI / n
						       : TS_PI / n;
		diagonal += 2 / (h * h);
		slow = pow(2 / h * sin(angle / 2), 2);
		if (given)
			slowest += slow;
		else if (n > 1)
			least = fmin(least, slow);
	}
	/* along axes without a given pressure the slowest mode is constant, unless all are so */
	if (slowest == 0)
		slowest = least;
	rho = isfinite(slowest) ? 1 - slowest / diagonal : 0;
	return 2 / (1 + sqrt(fmax(0, 1 - rho * rho)));
}

struct ts_poisson_report ts_relaxation_solve(const struct ts_stencil *s, double omega, const double *b,
					     double *p, double *spare, double largest, double goal, int most)
{
	struct ts_poisson_report report = { .iterations = 0 };
	double beginning;

	ts_stencil_ghosts(s, p);
	beginning = report.residual = ts_stencil_residual_of_guess(s, p, b, largest, spare);
	while (report.residual > goal && report.residual <= 1e6 * beginning && report.iterations < most) {
		for (int colour = 0; colour < s->colours; colour++)
			ts_stencil_sweep(s, p, b, colour, omega);
		report.iterations++;
		if (report.iterations % TS_RELAXATION_LOOKS == 0 || report.iterations == most)
			report.residual = ts_stencil_residual(s, p, b, spare);
	}
	return report;
}

void ts_relaxation_rehearse(const struct ts_stencil *s, double *p, int iterations)
{
	ts_stencil_ghosts(s, p);
	ts_stencil_max_rows(s);
	for (int k = 0; k < iterations * s->colours; k++)
		ts_stencil_ghosts(s, p);
	for (int k = 0; k < iterations / TS_RELAXATION_LOOKS; k++)
		ts_stencil_max_rows(s);
}
