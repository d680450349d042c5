#include "wall/wall_coincide.h"

#include <inttypes.h>

#include "neigh/coincide.h"
#include "particle/prescribed.h"

#include "base/banned.h"

static const struct ts_instance *find_instance(const struct tsim *sim, const struct ts_wall *wall)
{
	const struct ts_instance *by = NULL;
	const struct ts_wall *w;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by)) && w != wall;)
		;
	return by;
}

enum ts_status ts_coincide_wall(struct tsim *sim, const struct ts_wall *wall)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_instance *by;
	struct ts_str where = { 0 };
	size_t k = wall->inside, i;
	enum ts_status status;

	if (k == TS_WALL_NONE)
		return TS_OK;
	i = (size_t)wall->contacts.row[k];
	if (p->mask[i] & ts_prescribed(sim))
		return TS_OK;
	by = find_instance(sim, wall);
	if (wall->shape->name)
		wall->shape->name(wall, k, &where);
	status = ts_fail(&sim->error, TS_PHYSICS, by ? &by->where : NULL,
			 "at step %" PRId64
			 " the centre of particle %d (type %d) at (%g %g %g) lies in the %s of wall %s%s: "
			 "%s, and no contact force has a direction there; %s",
			 sim->clock.step, p->tag[i], p->type[i], p->x[i][0], p->x[i][1], p->x[i][2],
			 wall->shape->solid ? "solid" : "surface", by ? by->id : "", ts_str_text(&where),
			 wall->shape->solid ? "it is inside" : "it is on neither side",
			 sim->run.in_setup || sim->reading.explain
				 ? "place it a radius away from the wall, or move the wall"
				 : "the time step is too large or the contact too soft, or the particle was "
				   "put there");
	ts_str_release(&where);
	return status;
}

enum ts_status ts_coincide_review(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;

	if (!sim->reading.explain || sim->review.stale)
		return TS_OK;
	w->inside = TS_WALL_NONE;
	for (size_t k = 0; k < w->contacts.n && w->inside == TS_WALL_NONE; k++) {
		size_t i = (size_t)w->contacts.row[k];
		int type;

		if (sim->particles->imass[i] > 0 &&
		    ts_coincide(w->shape->distance(w, sim, k, &type), sim->particles->radius[i]))
			w->inside = k;
	}
	return ts_coincide_wall(sim, w);
}
