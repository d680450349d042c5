#include "neigh/runaways.h"

#include <inttypes.h>
#include <math.h>

#include "base/str.h"
#include "core/ranks.h"
#include "math/vec3.h"
#include "neigh/neigh.h"

#include "base/banned.h"

/* Ends a run with diverging motion before anything more is written. */
static enum ts_status fail_runaway(struct tsim *sim, size_t i, const char *past)
{
	struct ts_particles *p = sim->particles;
	const double *v = p->v[i], *x = p->x[i];
	double speed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
	struct ts_str contacts = { 0 };
	bool finite = isfinite(speed) && isfinite(x[0] + x[1] + x[2]);
	enum ts_status status;

	p->describe_contacts(sim, i, &contacts);
	status = ts_fail(&sim->error, TS_PHYSICS, NULL,
			 "particle %d (type %d) %s at step %" PRId64
			 "%s: position (%g %g %g), velocity (%g %g %g); last contacts: %.300s; probable "
			 "cause: %s",
			 p->tag[i], p->type[i],
			 finite ? "moves more than its radius in one step"
				: "has a position or velocity that is not a number",
			 sim->clock.step, past, x[0], x[1], x[2], v[0], v[1], v[2],
			 contacts.length ? contacts.text : "none",
			 contacts.length
				 ? "the time step is too large for the stiffness, or particles overlapped "
				   "when they were created"
				 : "a force or a velocity that was set is too large for the time step");
	ts_str_release(&contacts);
	return status;
}

bool ts_runaways_has(const struct ts_particles *p, size_t i, double dt2)
{
	const double *v = p->v[i], *x = p->x[i];
	double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

	return !(v2 * dt2 <= p->radius[i] * p->radius[i]) || !isfinite(x[0] + x[1] + x[2]);
}

/* Of the particles of all ranks whose position or speed is no number that of the least identity: its index on the rank that
 * has it. SIZE_MAX: another rank has it, or there is none, and *any is false. */
static size_t find_not_finite(const struct tsim *sim, bool *any)
{
	const struct ts_particles *p = sim->particles;
	size_t first = SIZE_MAX;
	double least;

	for (size_t i = 0; i < p->n; i++)
		if (!isfinite(ts_norm(p->v[i]) + ts_norm(p->x[i])) &&
		    (first == SIZE_MAX || p->tag[i] < p->tag[first]))
			first = i;
	least = -ts_ranks_most(sim, first == SIZE_MAX ? -INFINITY : -(double)p->tag[first]);
	*any = isfinite(least);
	return first != SIZE_MAX && p->tag[first] == least ? first : SIZE_MAX;
}

enum ts_status ts_runaways_stop(struct tsim *sim)
{
	char past[100] = "";
	bool any;
	size_t hit = find_not_finite(sim, &any);

	if (!any)
		TS_TRY(sim->neigh->callback.find_hit(sim, &hit, past, sizeof past));
	return hit != SIZE_MAX ? fail_runaway(sim, hit, past) : TS_OK;
}
