#include "voxel/voxel_recede.h"

#include <string.h>

#include "base/banned.h"

/* A layer is removed when this part of it is still missing, so that rounding errors of the volumes do not decide. */
static const double MISSING = 1e-9;

static size_t columns_of(const struct ts_voxel_field *f)
{
	return (size_t)f->n[0] * (size_t)f->n[1];
}

/* ---- checks */

static enum ts_status keep_original(struct tsim *sim, struct ts_voxel_surface *s)
{
	size_t n = columns_of(&s->field);

	if (s->original)
		return TS_OK;
	s->original = ts_alloc(n, sizeof *s->original);
	if (!s->original)
		return ts_nomem(&sim->error);
	memcpy(s->original, ts_voxel_heights(&s->field), n * sizeof *s->original);
	return TS_OK;
}

/* The first column that ends above the base; SIZE_MAX: none. */
static size_t find_thick(const struct ts_voxel_surface *s, double thickness)
{
	for (size_t k = 0; k < columns_of(&s->field); k++)
		if (s->original[k] - thickness > s->field.base)
			return k;
	return SIZE_MAX;
}

enum ts_status ts_voxel_recede_check(struct tsim *sim, struct ts_voxel_surface *s,
				     const struct ts_recession *how, const struct ts_place *where)
{
	const struct ts_voxel_field *f = &s->field;
	size_t thick;

	if (isinf(f->base) && how->through == TS_THROUGH_OPEN)
		return ts_fail(&sim->error, TS_STATE, where,
			       "through open: the columns of the height field have no bottom, so there is no "
			       "hole through them; give fix surface/voxel a `base`");
	if (isinf(f->base) && isinf(how->thickness))
		return ts_fail(&sim->error, TS_STATE, where,
			       "evolve: the columns of the height field have no bottom; give a `thickness`, "
			       "or fix surface/voxel a `base`");
	TS_TRY(keep_original(sim, s));
	thick = how->through == TS_THROUGH_OPEN ? find_thick(s, how->thickness) : SIZE_MAX;
	if (thick == SIZE_MAX)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "through open: column %lld %lld reaches from %g down to the base %g, so its material "
		       "does not end at the thickness %g; leave `thickness` out, or raise the base",
		       (long long)(thick % (size_t)f->n[0] + 1), (long long)(thick / (size_t)f->n[0] + 1),
		       s->original[thick], f->base, how->thickness);
}

/* ---- recession */

/* The least height of a column: where its material ends. At the base it would be empty; a column that stays is higher by
 * the least number. */
static double least_height(const struct ts_voxel_field *f, const struct ts_recession *how, double original)
{
	double end = how->through == TS_THROUGH_OPEN ? f->base : nextafter(f->base, INFINITY);

	return fmax(original - how->thickness, end);
}

static void lower_column(struct ts_voxel_surface *s, const struct ts_recession *how,
			 struct ts_recession_element *e)
{
	const struct ts_voxel_field *f = &s->field;
	double area = f->width[0] * f->width[1], original = s->original[e->element];
	double height = ts_voxel_heights(f)[e->element], least = least_height(f, how, original);
	double depth = (original - height) + e->due / area, to = original - depth;

	e->through = !(to > least) || !(height > least);
	if (e->through)
		to = least;
	else if (how->layer > 0)
		to = original - how->layer * floor(depth / how->layer + MISSING);
	if (to < height) {
		e->taken = (height - to) * area;
		ts_voxel_surface_set_height(s, (int64_t)e->element % f->n[0], (int64_t)e->element / f->n[0],
					    to);
	}
	if (e->through)
		e->surplus = e->due - e->taken;
}

void ts_voxel_recede(struct ts_voxel_surface *s, const struct ts_recession *how,
		     struct ts_recession_element *e, size_t n)
{
	for (size_t k = 0; k < n; k++)
		lower_column(s, how, &e[k]);
}
