#include "insert/memory_check.h"

#include "base/alloc.h"
#include "particle/particles.h"

#include "base/banned.h"

/* Memory of a particle in all active columns. */
static double bytes_per_particle(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double bytes = 0;

	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			bytes += (double)(p->column[k].width * p->column[k].element);
	return bytes;
}

enum ts_status ts_memory_check(struct tsim *sim, const char *who, double n, size_t extra,
			       const struct ts_place *where, double *bytes)
{
	static const double LITTLE = 1e7; /* as there always is */
	double there;

	*bytes = n * (bytes_per_particle(sim) + (double)extra);
	if (*bytes < LITTLE)
		return TS_OK;
	there = ts_alloc_available();
	if (*bytes > there && there > 0)
		return ts_fail(&sim->error, TS_NOMEM, where,
			       "%s: out of memory: %.10g particles take %.3g GB, and there are %.3g GB; "
			       "create "
			       "fewer",
			       who, n, *bytes / 1e9, there / 1e9);
	return TS_OK;
}
