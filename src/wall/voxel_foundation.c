#include "wall/voxel_foundation.h"

#include "law/foundation.h"
#include "math/vec3.h"

#include "base/banned.h"

static double column_stiffness(const struct ts_voxel_surface *s)
{
	return s->winkler * s->field.width[0] * s->field.width[1];
}

/* The deflected surface as a contact point; `axis` of the heights. */
static void deflect(const struct ts_foundation *f, const double v[3], int axis,
		    struct ts_wall_contact_point *point)
{
	double aside = point->distance / f->distance;

	for (int d = 0; d < 3; d++)
		point->n[d] *= aside;
	point->n[axis] = f->cosine;
	point->distance = f->distance;
	point->velocity[axis] -= ts_foundation_rate(f, ts_dot(v, point->n), v[axis]);
}

void ts_voxel_foundation_yield(const struct ts_voxel_surface *s, const struct ts_wall_queue *q, size_t k,
			       struct ts_wall_contact_point *point)
{
	const struct ts_particles *p = q->sim->particles;
	int axis = s->field.axis[2];
	struct ts_foundation f;
	struct ts_touch t;
	double v[3];

	if (!(point->n[axis] > 0)) /* at a side, or from below */
		return;
	ts_wall_queue_touch(q, k, point, &t);
	ts_foundation_solve(&f, q->model,
			    ts_wall_law(q->w, q->sim, point->type, p->type[q->w->contacts.row[k]]), &t,
			    column_stiffness(s), point->n[axis]);
	if (!(point->distance + f.u * f.cosine > point->distance)) /* less than rounding */
		return;
	ts_sub(p->v[q->w->contacts.row[k]], point->velocity, v);
	deflect(&f, v, axis, point);
}

enum ts_status ts_voxel_foundation_check(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_wall *w = self->state;
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(w);

	if (isnan(vw->surface->winkler) || !ts_wall_has_law(w, sim) ||
	    ts_foundation_takes(ts_wall_model(w, sim)))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix %s: the columns of %s are springs (`winkler`), which need a contact law with the "
		       "normal force k delta or k delta^(3/2): hooke or hertz, without cohesion, hysteresis, "
		       "`located` and `multicontact`",
		       self->style->name, vw->id);
}

const char *ts_voxel_foundation_not_exact(const struct ts_wall *w)
{
	return isnan(ts_voxel_wall_of(w)->surface->winkler)
		       ? NULL
		       : "the columns are springs (`winkler` of fix surface/voxel), and it integrates the "
			 "contact law alone";
}
