#include "rigid/rigid_box.h"

#include "base/parallel.h"
#include "box/domain.h"

#include "base/banned.h"

struct change {
	double lo, hi; /* of the box after it */
	bool map;
};

/* Along one axis. The place of a body in the box is that of its centre of mass in the image of its first member, which was
 * wrapped, as single particles were, when the contact list was built. */
static void move_body(struct tsim *sim, size_t b, int axis, const struct change *c)
{
	const struct ts_box *box = &sim->domain->box;
	struct ts_rigid *r = sim->rigid;
	struct ts_particles *p = sim->particles;
	struct ts_body *body = &r->body[b];
	const double length = ts_box_length(box, axis), grown = (c->hi - c->lo) - length;
	const int32_t image = p->image[r->member[r->start[b]]][axis];
	const double place = body->x[axis] - image * length;
	const double mapped = c->lo + (c->hi - c->lo) / length * (place - box->lo[axis]);
	const double shift = (c->map ? mapped - place : 0) + image * grown;

	body->x[axis] += shift;
	for (size_t k = r->start[b]; k < r->start[b + 1]; k++) {
		const size_t i = (size_t)r->member[k];

		p->x[i][axis] += shift - p->image[i][axis] * grown;
	}
}

enum ts_status ts_rigid_change_box(struct tsim *sim, const double lo[3], const double hi[3], bool map,
				   int group)
{
	const struct ts_rigid *r = sim->rigid;
	const struct ts_box *box = &sim->domain->box;

	if (!r->n)
		return TS_OK;
	TS_TRY(ts_rigid_list(sim));
#pragma omp parallel for num_threads(ts_team(sim, r->n)) schedule(static)
	for (size_t b = 0; b < r->n; b++) {
		struct change c = { .map = map && ts_rigid_in_group(r, sim->particles, b, group) };

		if (r->start[b] == r->start[b + 1])
			continue;
		for (int k = 0; k < 3; k++) {
			c.lo = lo[k];
			c.hi = hi[k];
			if (c.lo < box->lo[k] || c.lo > box->lo[k] || c.hi < box->hi[k] || c.hi > box->hi[k])
				move_body(sim, b, k, &c);
		}
	}
	return TS_OK;
}
