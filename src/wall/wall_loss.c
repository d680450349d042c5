#include "wall/wall_loss.h"

#include "box/domain.h"
#include "core/group.h"
#include "particle/particles.h"
#include "wall/primitive_wall.h"

#include "base/banned.h"

/* A plane wall between the particle and the middle of the box: the particle has passed it. */
static bool explain_plane(struct tsim *sim, size_t i, int dim, struct ts_str *out)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	const struct ts_instance *by;
	const struct ts_wall *w;
	double middle = 0.5 * (box->lo[dim] + box->hi[dim]), position;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, &by));) {
		const struct ts_primitive_wall *at = ts_primitive_wall_of(w);

		if (!at || !ts_primitive_wall_between(sim, at, dim, p->x[i][dim], middle, &position))
			continue;
		if (!ts_in_group(p, i, by->group))
			ts_str_addf(out, "wall %s at %c = %g acts on group %s only, and it is not in it",
				    by->id, 'x' + dim, position, ts_group_name(sim, by->group));
		else
			ts_str_addf(out,
				    "its centre was beyond wall %s at %c = %g, which repels particles on "
				    "both sides: it was placed there, or the contact is too soft for its "
				    "speed",
				    by->id, 'x' + dim, position);
		return true;
	}
	return false;
}

void ts_wall_explain_loss(struct tsim *sim, size_t i, int face, struct ts_str *out)
{
	const struct ts_wall *w;
	bool others = false;

	if (explain_plane(sim, i, face / 2, out))
		return;
	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));) {
		const struct ts_primitive_wall *at = ts_primitive_wall_of(w);

		others |= !at || at->primitive[0].shape >= TS_XCYLINDER;
	}
	if (others)
		ts_str_add(out, "no plane wall stands at that face, and it was outside of the other walls, "
				"or these have a gap");
}
