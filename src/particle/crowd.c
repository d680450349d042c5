#include "particle/crowd.h"

#include <math.h>

#include "box/domain.h"

#include "base/banned.h"

static double mean_diameter(const struct ts_particles *p, size_t *mobile)
{
	double sum = 0;

	*mobile = 0;
	for (size_t i = 0; i < p->n; i++) {
		if (!(p->imass[i] > 0))
			continue;
		++*mobile;
		sum += 2 * p->radius[i];
	}
	return *mobile ? sum / (double)*mobile : 0;
}

enum ts_status ts_particles_crowd(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = self->state;
	const struct ts_box *box = &sim->domain->box;
	size_t mobile, along[3] = { 1, 1, 1 }, k = 0;
	double spacing = 0.999 * mean_diameter(p, &mobile), room = 1;

	for (int d = 0; d < sim->dimension && mobile; d++) {
		double n = floor(ts_box_length(box, d) / spacing);

		room *= n;
		along[d] = n < 1 ? 1 : n < (double)mobile ? (size_t)n : mobile;
	}
	for (size_t i = 0; i < p->n && room >= (double)mobile; i++) {
		size_t rest = k;

		if (!(p->imass[i] > 0))
			continue;
		for (int d = 0; d < sim->dimension; d++) {
			p->x[i][d] = box->lo[d] + spacing * (0.5 + (double)(rest % along[d]));
			p->v[i][d] = 0;
			rest /= along[d];
		}
		k++;
	}
	return TS_OK;
}
