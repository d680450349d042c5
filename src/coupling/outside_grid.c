#include "coupling/outside_grid.h"

#include <inttypes.h>

#include "base/alloc.h"
#include "core/ranks.h"

#include "particle/particles.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

static void warn_outside(struct tsim *sim, const struct ts_instance *self, size_t n, int64_t tag)
{
	const struct ts_particles *p = sim->particles;
	size_t i = 0;

	while (i < p->n && p->tag[i] != tag)
		i++;
	if (i == p->n) /* it is on another rank, which warns */
		return;
	ts_warn(&sim->log, &self->where,
		"fix %s: at step %" PRId64 " %zu of its particles are outside the grid of the fluid, where "
		"no force of the fluid acts (particle %" PRId64
		" at %g %g %g); let the region of flow_style reach as far as the particles do (printed once "
		"in a run)",
		self->style->name, sim->clock.step, n, tag, p->x[i][0], p->x[i][1], p->x[i][2]);
}

/* n, tag: of all ranks. */
static void note_outside(struct ts_fluid *fluid, struct tsim *sim, const struct ts_instance *self, size_t n,
			 int64_t tag)
{
	struct ts_fluid_outside *o = &fluid->outside;

	if (!n)
		return;
	if (!o->most)
		warn_outside(sim, self, n, tag);
	if (!o->steps || o->last != sim->clock.step)
		o->steps++;
	o->last = sim->clock.step;
	o->most = n > o->most ? n : o->most;
}

enum ts_status ts_coupling_count_outside(struct ts_fluid *fluid, struct tsim *sim,
					 const struct ts_instance *self, size_t n, int64_t tag)
{
	const struct ts_fluid_counted counted = { self, n, tag };

	if (!sim->division) {
		note_outside(fluid, sim, self, n, tag);
		return TS_OK;
	}
	if (TS_GROW(fluid->counted, fluid->counted_capacity, fluid->ncounted + 1) != TS_OK)
		return ts_nomem(&sim->error);
	fluid->counted[fluid->ncounted++] = counted;
	return sim->run.in_setup ? ts_coupling_sum_outside(fluid, sim) : TS_OK;
}

enum ts_status ts_coupling_sum_outside(struct ts_fluid *fluid, struct tsim *sim)
{
	const size_t n = fluid->ncounted;
	int64_t *all = ts_alloc(n, sizeof *all);

	if (!all)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		all[k] = (int64_t)fluid->counted[k].n;
	if (n)
		ts_world_sums(sim->world, all, n);
	for (size_t k = 0; k < n; k++) {
		const struct ts_fluid_counted *counted = &fluid->counted[k];

		if (all[k])
			note_outside(fluid, sim, counted->self, (size_t)all[k],
				     (int64_t)-ts_ranks_most(sim, -(double)counted->tag));
	}
	fluid->ncounted = 0;
	ts_free(all);
	return TS_OK;
}

void ts_coupling_report_outside(struct ts_fluid *fluid, struct tsim *sim)
{
	const struct ts_fluid_outside *o = &fluid->outside;

	if (o->most)
		ts_log(&sim->log,
		       "Up to %zu particles were outside the grid of the fluid, in %" PRId64 " steps\n",
		       o->most, o->steps);
	fluid->outside = (struct ts_fluid_outside){ 0 };
}
