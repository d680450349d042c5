#include "polish/gap.h"

#include <math.h>

#include "voxel/voxel_touch.h"
#include "wall/primitive_wall.h"

#include "base/banned.h"

/* ---- the surfaces ---- */

static bool is_of(const struct ts_instance *fix, const char *family)
{
	return fix->style->family && ts_streq(fix->style->family, family);
}

/* The face of a wall: a single plane across the axis of the heights. */
static enum ts_status check_plane(struct ts_instance *self, struct tsim *sim, const struct ts_gap *g,
				  const struct ts_instance *by, const struct ts_place *where)
{
	const struct ts_primitive_wall *w = ts_primitive_wall_of(g->plane);
	int axis = g->lower->field.axis[2];
	struct ts_primitive_plane plane;

	if (!w || w->n != 1 || !ts_primitive_wall_plane(sim, w, 0, &plane) || plane.dim != axis)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix %s: wall %s is no face of the gap: expected a fix wall/gran primitive "
			       "with one %cplane",
			       self->style->name, by->id, 'x' + axis);
	return TS_OK;
}

/* The underside of a second field: it has a base, is above the whole of the first one, and has no holes. */
static enum ts_status check_slab(struct ts_instance *self, struct tsim *sim, const struct ts_gap *g,
				 const struct ts_instance *by, const struct ts_place *where)
{
	const struct ts_voxel_field *a = &g->lower->field, *b = &g->slab->field;
	const double *height = ts_voxel_heights(b);

	if (g->slab == g->lower)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix %s: `lower` and `upper` are the same surface %s", self->style->name,
			       by->id);
	if (!isfinite(b->base))
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix %s: the columns of %s have no underside: give the upper surface a `base`",
			       self->style->name, by->id);
	for (int d = 0; d < 3; d++)
		if (a->axis[d] != b->axis[d] ||
		    (d < 2 && (fabs(a->origin[d] - b->origin[d]) > 1e-9 * a->width[d] ||
			       fabs((double)a->n[d] * a->width[d] - (double)b->n[d] * b->width[d]) >
				       1e-9 * a->width[d])))
			return ts_fail(&sim->error, TS_STATE, where,
				       "fix %s: %s does not lie on the same rectangle as the lower surface",
				       self->style->name, by->id);
	for (int64_t k = 0; k < b->n[0] * b->n[1]; k++)
		if (!(height[k] > b->base))
			return ts_fail(&sim->error, TS_STATE, where,
				       "fix %s: column %lld, %lld of %s is empty: the gap has no upper face "
				       "there",
				       self->style->name, (long long)(k % b->n[0] + 1),
				       (long long)(k / b->n[0] + 1), by->id);
	return TS_OK;
}

static enum ts_status find_face(struct ts_instance *self, struct tsim *sim, const char *name,
				struct ts_gap *out)
{
	const struct ts_word id = { .text = name, .place = *ts_instance_word(self, name) };
	struct ts_instance *by;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &id, &by));
	if (is_of(by, TS_FAMILY_WALL)) {
		out->plane = by->state;
		return check_plane(self, sim, out, by, &id.place);
	}
	if (is_of(by, TS_FAMILY_VOXEL)) {
		out->slab = by->state;
		return check_slab(self, sim, out, by, &id.place);
	}
	return ts_fail(&sim->error, TS_STATE, &id.place,
		       "fix %s: fix %s, of style %s, is no surface: expected a fix wall/gran with a plane or "
		       "a fix surface/voxel",
		       self->style->name, by->id, by->style->name);
}

static enum ts_status check_columns(struct ts_instance *self, struct tsim *sim, const struct ts_gap *g,
				    const struct ts_place *where)
{
	const struct ts_voxel_field *f = &g->lower->field;

	for (int64_t k = 0; k < f->n[0] * f->n[1]; k++)
		if (!(ts_voxel_heights(f)[k] > f->base))
			return ts_fail(&sim->error, TS_STATE, where,
				       "fix %s: column %lld, %lld of the lower surface is empty: the gap has "
				       "no bottom there",
				       self->style->name, (long long)(k % f->n[0] + 1),
				       (long long)(k / f->n[0] + 1));
	return TS_OK;
}

enum ts_status ts_gap_find(struct ts_instance *self, struct tsim *sim, const char *lower, const char *upper,
			   struct ts_gap *out)
{
	const struct ts_word id = { .text = lower, .place = *ts_instance_word(self, lower) };
	struct ts_voxel_surface *field;

	*out = (struct ts_gap){ .lower = NULL };
	TS_TRY(ts_voxel_surface_require(sim, &id, &field));
	out->lower = field;
	TS_TRY(check_columns(self, sim, out, &id.place));
	return find_face(self, sim, upper, out);
}

/* ---- its room ---- */

static double face_of(const struct ts_gap *g, const struct tsim *sim)
{
	struct ts_primitive_plane plane = { .position = NAN };

	if (g->slab)
		return g->slab->field.base + g->slab->shift[g->slab->field.axis[2]];
	ts_primitive_wall_plane(sim, ts_primitive_wall_of(g->plane), 0, &plane);
	return plane.position;
}

struct ts_gap_room ts_gap_room(const struct ts_gap *g, const struct tsim *sim, double diameter)
{
	const struct ts_voxel_field *f = &g->lower->field;
	struct ts_gap_room r = { .face = face_of(g, sim), .columns = f->n[0] * f->n[1], .depth = -INFINITY };
	double sum = 0;

	for (int64_t k = 0; k < r.columns; k++) {
		double h = r.face - (ts_voxel_heights(f)[k] + g->lower->shift[f->axis[2]]);

		r.touching += h <= 0;
		r.depth = fmax(r.depth, -h);
		h = fmax(h, 0);
		r.highest = fmax(r.highest, h);
		r.stacked += (int64_t)floor(h / diameter);
		sum += h;
	}
	r.volume = sum * f->width[0] * f->width[1];
	return r;
}

bool ts_gap_is_free(const struct ts_gap *g, double face, const double x[3], double radius)
{
	const struct ts_voxel_field *f = &g->lower->field;
	double at[3];

	if (!(x[f->axis[2]] + radius <= face))
		return false;
	for (int d = 0; d < 3; d++)
		at[d] = x[d] - g->lower->shift[d];
	return !(ts_voxel_distance(f, at, radius) < radius);
}
