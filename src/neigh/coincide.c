#include "neigh/coincide.h"

#include <inttypes.h>
#include <math.h>

#include "math/vec3.h"
#include "neigh/neigh.h"
#include "particle/prescribed.h"

#include "base/banned.h"

/* ---- particles */

static bool same_place(const struct ts_particles *p, size_t i, size_t j)
{
	return ts_coincide(sqrt(ts_distance2(p->xhold[i], p->xhold[j])), fmin(p->radius[i], p->radius[j]));
}

/* Whether no force moves it: it is frozen, or follows a prescribed motion. */
static bool is_prescribed_or_frozen(const struct ts_particles *p, size_t i, uint32_t prescribed)
{
	return p->imass[i] == 0 || (p->mask[i] & prescribed);
}

/* Whether pair a comes before pair b in the order of identities; so the message does not depend on the order
 * in memory. */
static bool precedes(const struct ts_contact_list *list, size_t a, size_t b)
{
	int32_t p[2], q[2];

	for (int k = 0; k < 2; k++) {
		p[k] = ts_contact_tag(list, a, k);
		q[k] = ts_contact_tag(list, b, k);
	}
	if (p[0] > p[1])
		p[0] = ts_contact_tag(list, a, 1), p[1] = ts_contact_tag(list, a, 0);
	if (q[0] > q[1])
		q[0] = ts_contact_tag(list, b, 1), q[1] = ts_contact_tag(list, b, 0);
	return p[0] != q[0] ? p[0] < q[0] : p[1] < q[1];
}

enum ts_status ts_coincide_check_pairs(struct tsim *sim, const struct ts_contact_list *list)
{
	const struct ts_particles *p = sim->particles;
	const uint32_t prescribed = ts_prescribed(sim);
	size_t first = 0, n = 0;
	int32_t tag[2];
	const double *x;

	for (size_t r = 0; r < list->n; r++) {
		size_t i = (size_t)list->i[r], j = (size_t)list->j[r];

		if (!same_place(p, i, j) ||
		    (is_prescribed_or_frozen(p, i, prescribed) &&
		     is_prescribed_or_frozen(p, j, prescribed)) ||
		    !sim->neigh->callback.interact(sim, i, j))
			continue;
		first = n++ && precedes(list, first, r) ? first : r;
	}
	if (!n)
		return TS_OK;
	x = p->x[list->i[first]];
	for (int k = 0; k < 2; k++)
		tag[k] = ts_contact_tag(list, first, k);
	return ts_fail(&sim->error, TS_PHYSICS, NULL,
		       "at step %" PRId64
		       " particles %d and %d are at the same place (%g %g %g)%s: a contact force has no "
		       "direction there; delete one of them (`delete_atoms overlap`), or create them apart",
		       sim->clock.step, tag[0] < tag[1] ? tag[0] : tag[1], tag[0] < tag[1] ? tag[1] : tag[0],
		       x[0], x[1], x[2], n > 1 ? ", and so are others" : "");
}

/* ---- bonds */

enum ts_status ts_coincide_bond(struct tsim *sim, const struct ts_place *where, size_t i, size_t j,
				double distance)
{
	const struct ts_particles *p = sim->particles;
	int32_t a = p->tag[i], b = p->tag[j];

	if (!ts_coincide(distance, fmin(p->radius[i], p->radius[j])))
		return TS_OK;
	return ts_fail(&sim->error, TS_PHYSICS, where,
		       "particles %d and %d are at the same place (%g %g %g): a bond between them has no "
		       "direction; delete one of them (`delete_atoms overlap`), or create them apart",
		       a < b ? a : b, a < b ? b : a, p->x[i][0], p->x[i][1], p->x[i][2]);
}

/* ---- surfaces that move by more than a radius in a step */

enum ts_status ts_coincide_passed(struct tsim *sim, const struct ts_place *where, size_t i, double way,
				  const char *what)
{
	const struct ts_particles *p = sim->particles;

	return ts_fail(&sim->error, TS_PHYSICS, where,
		       "%s moves by %.3g in step %" PRId64
		       ", more than the radius %g of particle %d (type %d) near it at (%g %g %g): it passes "
		       "through particles without a contact; use `timestep %.2g` or less",
		       what, way, sim->clock.step, p->radius[i], p->tag[i], p->type[i], p->x[i][0],
		       p->x[i][1], p->x[i][2], 0.9 * sim->clock.dt * p->radius[i] / way);
}
