#include "flow/imposed_flow.h"

#include <math.h>

#include "box/domain.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { FIELDS = 8 }; /* number of fields of the cheapest solver */

/* Estimates the number of cells of a grid in the box, with cells of two mean diameters. */
static double estimated_cells(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	double sum = 0, edge, n = 1;

	for (size_t i = 0; i < p->n; i++)
		sum += p->radius[i];
	if (!p->n)
		return 0;
	edge = 4 * sum / (double)p->n;
	for (int d = 0; d < sim->dimension; d++)
		n *= ceil((box->hi[d] - box->lo[d]) / edge);
	return n;
}

void ts_imposed_flow_report(struct ts_plan_report *report, const struct tsim *sim)
{
	ts_report_left_out(report, "fluid solver", 0, FIELDS * sizeof(double) * estimated_cells(sim),
			   "the velocity is imposed, particles do not act on it (cells of two diameters)");
}
