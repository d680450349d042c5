#include "wall/wall_flight.h"

#include "math/vec3.h"
#include "wall/exact_surface.h"
#include "wall/wall.h"

#include "base/banned.h"

/* A wall with `impact exact` takes overlaps up to this part of the radius for rounding errors. */
static const double NEGLIGIBLE = 1e-9;

/* Whether a particle that touched the wall `since` ago cannot be left to its forces. */
static bool is_missed(const struct tsim *sim, const struct ts_wall *w, double radius, const double v[3],
		      const struct ts_exact_touch *touch, double since)
{
	double speed = ts_dot(touch->velocity, touch->hit.n) - ts_dot(v, touch->hit.n);
	double depth = touch->hit.overlap + speed * since;

	if (w->exact)
		return depth > NEGLIGIBLE * radius;
	return since > (1 + 1e-9) * sim->clock.dt || depth > radius;
}

static enum ts_status look_at(struct tsim *sim, const struct ts_instance *by, const struct ts_wall *w,
			      size_t i, double flown, struct ts_mesh_list *list, struct ts_missed_wall *out)
{
	const struct ts_particles *p = sim->particles;
	struct ts_sweep path = { .radius = p->radius[i], .span = flown };
	struct ts_exact_touch touch;
	bool found;

	if (!(flown > 0) || !ts_wall_interacts(by, sim, i, false))
		return TS_OK;
	ts_scale(1, p->v[i], path.v);
	ts_scale(1, p->x[i], path.x);
	ts_axpy(-flown, p->v[i], path.x);
	TS_TRY(w->shape->exact->sweep(sim, w->geometry, i, &path, list, &found, &touch));
	if (found && is_missed(sim, w, path.radius, path.v, &touch, flown - touch.hit.time))
		*out = (struct ts_missed_wall){ by->id, i, flown, touch.hit.time };
	return TS_OK;
}

enum ts_status ts_wall_flight(struct tsim *sim, size_t from, size_t n, const double *flown,
			      struct ts_missed_wall *out)
{
	struct ts_mesh_list list = { 0 };
	enum ts_status status = TS_OK;
	const struct ts_instance *by;
	const struct ts_wall *w;

	*out = (struct ts_missed_wall){ 0 };
	for (size_t at = 0; status == TS_OK && !out->id && (w = ts_walls_next(sim, &at, &by));) {
		if (w->shape->exact->update)
			status = w->shape->exact->update(sim, w->geometry);
		for (size_t k = 0; k < n && status == TS_OK && !out->id; k++)
			status = look_at(sim, by, w, from + k, flown[k], &list, out);
	}
	ts_free(list.item);
	return status;
}
