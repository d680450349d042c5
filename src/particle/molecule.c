#include "particle/molecule.h"

#include <math.h>

#include "core/ranks.h"
#include "particle/quantity.h"

#include "base/banned.h"

double *ts_particles_molecules_to_set(struct ts_particles *p)
{
	size_t k;
	const struct ts_column *c = ts_particles_named_column(p, "mol", &k);

	return c && c->width == 1 ? c->data : NULL;
}

const double *ts_particles_molecules(const struct ts_particles *p)
{
	return ts_particles_molecules_to_set((struct ts_particles *)p);
}

double ts_particles_most_molecule(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const double *molecule = ts_particles_molecules(p);
	double most = 0;

	for (size_t i = 0; molecule && i < p->n; i++)
		most = fmax(most, molecule[i]);
	return ts_ranks_most(sim, most);
}

enum ts_status ts_particles_need_molecules(struct tsim *sim, const char *what, const struct ts_place *where)
{
	if (!sim->particles->n || ts_particles_molecules(sim->particles))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "%s: particles belong to no molecules: `fix ID all property/atom mol` and `set ... "
		       "mol` say to which",
		       what);
}
