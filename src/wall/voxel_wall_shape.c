/* Height fields as a shape of walls. */
#include <math.h>

#include "box/domain.h"
#include "math/vec3.h"
#include "voxel/voxel_recede.h"
#include "wall/voxel_foundation.h"
#include "wall/voxel_wall.h"
#include "wall/voxel_wall_queue.h"

#include "base/banned.h"

/* ---- definition */

static int given(const void *geometry)
{
	return ((const struct ts_voxel_wall *)geometry)->id != NULL;
}

static enum ts_status find(struct ts_instance *self, struct tsim *sim)
{
	struct ts_wall *w = self->state;
	struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	struct ts_word id = { .text = vw->id, .place = *ts_instance_word(self, vw->id) };
	struct ts_voxel_surface *surface;

	if (w->type != INT64_MIN)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "type"),
			       "fix wall/gran: a height field has the type that its fix says");
	TS_TRY(ts_voxel_surface_require(sim, &id, &surface));
	vw->surface = surface;
	vw->by = ts_sim_find(sim, TS_KIND_FIX, vw->id);
	w->warm = !isnan(surface->temperature);
	w->yields = !isnan(surface->winkler);
	return ts_wall_check_type(self, sim, surface->type, vw->id);
}

static void release(void *geometry)
{
	struct ts_voxel_wall *vw = geometry;

	ts_free(vw->neighbor);
	ts_free(vw->at);
	ts_free(vw->column);
	ts_free(vw->slot);
	ts_free(vw->used);
}

/* ---- surface */

static const struct ts_instance *fix_of_surface(const struct ts_wall *w, size_t surface)
{
	(void)surface;
	return ts_voxel_wall_of(w)->by;
}

/* Number of periodic images by which x is away from the interval [lo, hi] of a column. */
static int32_t image_at(double x, double lo, double hi, double length)
{
	return (int32_t)lround((x - 0.5 * (lo + hi)) / length);
}

static void place_of_contact(const struct ts_wall *w, size_t k, struct ts_wall_place *out)
{
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	const struct ts_voxel_surface *s = vw->surface;
	const struct ts_voxel_field *f = &s->field;
	const double *x = w->contacts.report[k].point;
	int64_t column = ts_voxel_column_index(ts_voxel_memory(&w->contacts, k)[TS_VOXEL_COLUMN]);
	int64_t index[2] = { column % f->n[0], column / f->n[0] };

	*out = (struct ts_wall_place){ .element = (size_t)column };
	for (int d = 0; d < 2; d++) {
		int a = f->axis[d];

		out->shift[a] = image_at(x[a] - s->shift[a], ts_voxel_border(f, d, index[d]),
					 ts_voxel_border(f, d, index[d] + 1), vw->length[a]);
	}
	if (isfinite(f->base))
		out->shift[f->axis[2]] = image_at(x[f->axis[2]] - s->shift[f->axis[2]], f->base,
						  ts_voxel_heights(f)[column], vw->length[f->axis[2]]);
}

static const struct ts_voxel_surface *field_of(const struct ts_instance *by)
{
	return by->state;
}

static size_t count_columns(const struct ts_instance *by)
{
	return (size_t)(field_of(by)->field.n[0] * field_of(by)->field.n[1]);
}

static double column_area(const struct ts_instance *by, const struct tsim *sim, size_t element)
{
	(void)sim;
	(void)element;
	return field_of(by)->field.width[0] * field_of(by)->field.width[1];
}

static void column_centre(const struct ts_instance *by, const struct tsim *sim, size_t element, double out[3])
{
	const struct ts_voxel_surface *s = field_of(by);
	const struct ts_voxel_field *f = &s->field;
	int64_t index[2] = { (int64_t)element % f->n[0], (int64_t)element / f->n[0] };

	(void)sim;
	for (int d = 0; d < 2; d++)
		out[f->axis[d]] = f->origin[d] + ((double)index[d] + 0.5) * f->width[d];
	out[f->axis[2]] = ts_voxel_heights(f)[element];
	ts_add(out, s->shift, out);
}

static int field_type(const struct ts_instance *by)
{
	return (int)field_of(by)->type;
}

static double field_temperature(const struct ts_instance *by)
{
	return field_of(by)->temperature;
}

static enum ts_status check_recession(struct tsim *sim, const struct ts_instance *by,
				      const struct ts_recession *how, const struct ts_place *where)
{
	return ts_voxel_recede_check(sim, by->state, how, where);
}

static enum ts_status recede(struct tsim *sim, const struct ts_instance *by, const struct ts_recession *how,
			     const struct ts_place *where, struct ts_recession_element *e, size_t n)
{
	(void)sim;
	(void)where;
	ts_voxel_recede(by->state, how, e, n);
	return TS_OK;
}

/* ---- contacts */

static double contact_distance(const struct ts_wall *w, const struct tsim *sim, size_t k, int *type)
{
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	size_t i = (size_t)w->contacts.row[k];

	*type = (int)vw->surface->type;
	return ts_voxel_wall_distance(vw, sim, sim->particles->x[i], sim->particles->radius[i]);
}

struct taking {
	const struct ts_voxel_surface *surface;
	ts_wall_near_fn *take;
	void *context;
};

static void take_contact(void *context, const struct ts_voxel_contact *c)
{
	const struct taking *t = context;
	struct ts_wall_near_point point = { .distance = c->distance };

	if (!(c->distance > 0))
		return;
	ts_scale(1, c->n, point.n);
	ts_scale(1, t->surface->velocity, point.velocity);
	t->take(t->context, &point);
}

static void near_points(const struct ts_wall *w, const struct tsim *sim, size_t i, double reach,
			ts_wall_near_fn *take, void *context)
{
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	struct taking t = { vw->surface, take, context };
	struct ts_voxel_images images;

	if (!ts_in_group(sim->particles, i, vw->by->group))
		return;
	ts_voxel_images(vw->surface, &sim->domain->box, sim->particles->x[i], &images);
	for (int k = 0; k < images.n; k++)
		ts_voxel_contacts_visit(&vw->surface->field, images.x[k], reach, take_contact, &t);
}

static void name_column(const struct ts_wall *w, size_t k, struct ts_str *out)
{
	const struct ts_voxel_wall *vw = ts_voxel_wall_of(w);
	double column = ts_voxel_memory(&w->contacts, k)[TS_VOXEL_COLUMN];
	int64_t nx = vw->surface->field.n[0];

	if (column > 0)
		ts_str_addf(out, ", column %lld %lld of surface %s",
			    (long long)(ts_voxel_column_index(column) % nx + 1),
			    (long long)(ts_voxel_column_index(column) / nx + 1), vw->by->id);
}

const struct ts_wall_shape ts_voxel_wall_shape = {
	.made_of = "a height field",
	.solid = true,
	.given = given,
	.find = find,
	.check_law = ts_voxel_foundation_check,
	.release = release,
	.surfaces = ts_wall_one_surface,
	.fix = fix_of_surface,
	.place = place_of_contact,
	.surface = { .family = TS_FAMILY_VOXEL,
		     .elements = count_columns,
		     .area = column_area,
		     .centre = column_centre,
		     .type = field_type,
		     .temperature = field_temperature,
		     .check_recession = check_recession,
		     .recede = recede },
	.list = ts_voxel_wall_list,
	.has_moved = ts_voxel_wall_has_moved,
	.check_displacement = ts_voxel_wall_check_displacement,
	.enqueue = ts_voxel_wall_enqueue_contacts,
	.distance = contact_distance,
	.gap = ts_voxel_wall_gap,
	.near = near_points,
	.name = name_column,
	.exact = &ts_voxel_wall_exact,
	.not_exact = ts_voxel_foundation_not_exact,
};
