#include "bed/heap_surface.h"

#include <math.h>

#include "base/sort.h"
#include "math/exactsum.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

enum ts_status ts_bed_frame_make(struct tsim *sim, const struct ts_instance *self, const double up[3],
				 struct ts_bed_frame *out)
{
	double length;
	int first;

	*out = (struct ts_bed_frame){ .sides = sim->dimension - 1 };
	for (int d = 0; d < 3; d++)
		out->up[d] = isnan(up[d]) ? d == sim->dimension - 1 : up[d];
	length = ts_norm(out->up);
	if (!(length > 0) || (sim->dimension == 2 && out->up[2] != 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "compute %s: expected an upward direction `up x y z` that is not 0%s",
			       self->style->name,
			       sim->dimension == 2 ? ", in two dimensions with z = 0" : "");
	ts_scale(1 / length, out->up, out->up);
	/* the first horizontal direction: x, or y if up is nearer to x; less its part along up */
	first = fabs(out->up[0]) > 0.7;
	for (int d = 0; d < 3; d++)
		out->side[0][d] = d == first;
	ts_axpy(-out->up[first], out->up, out->side[0]);
	ts_scale(1 / ts_norm(out->side[0]), out->side[0], out->side[0]);
	ts_cross(out->up, out->side[0], out->side[1]);
	return TS_OK;
}

static int compare_grains(const void *a, const void *b)
{
	const struct ts_bed_grain *x = a, *y = b;
	int order = ts_compare_double(&x->cell[0], &y->cell[0]);

	order = order ? order : ts_compare_double(&x->cell[1], &y->cell[1]);
	order = order ? order : ts_compare_double(&x->height, &y->height);
	return order ? order : (x->tag > y->tag) - (x->tag < y->tag);
}

static void list_grains(const struct tsim *sim, int group, double column, struct ts_bed_surface *s)
{
	const struct ts_particles *p = sim->particles;
	struct ts_exactsum radii = ts_exactsum_start(), volume = ts_exactsum_start();

	s->n = 0;
	for (size_t i = 0; i < p->n; i++) {
		struct ts_bed_grain g = { .tag = p->tag[i] };
		double x[3], height;
		int32_t image[3];

		if (!ts_in_group(p, i, group))
			continue;
		ts_wrapped(sim, i, x, image);
		height = ts_dot(x, s->frame.up);
		for (int d = 0; d < s->frame.sides; d++)
			g.side[d] = ts_dot(x, s->frame.side[d]);
		g.height = height + p->radius[i];
		g.bottom = height - p->radius[i];
		ts_exactsum_add(&radii, p->radius[i]);
		ts_exactsum_add(&volume, ts_particle_volume(sim, p->radius[i]));
		s->grain[s->n++] = g;
	}
	s->volume = ts_exactsum_value(&volume);
	s->column = column > 0 || !s->n ? column : 4 * ts_exactsum_value(&radii) / (double)s->n;
	for (size_t k = 0; s->column > 0 && k < s->n; k++)
		for (int d = 0; d < s->frame.sides; d++)
			s->grain[k].cell[d] = floor(s->grain[k].side[d] / s->column);
}

/* The quantile of n sorted numbers: the smallest one that is not exceeded by the part. */
static size_t quantile(size_t n, double part)
{
	double at = ceil(part * (double)n) - 1;

	return at > 0 ? (size_t)fmin(at, (double)n - 1) : 0;
}

static enum ts_status find_base(struct ts_bed_surface *s)
{
	double *bottom = ts_alloc(s->n, sizeof *bottom);

	if (!bottom)
		return TS_NOMEM;
	for (size_t k = 0; k < s->n; k++)
		bottom[k] = s->grain[k].bottom;
	ts_sort(bottom, s->n, sizeof *bottom, ts_compare_double);
	s->base = s->n ? bottom[quantile(s->n, 0.01)] : 0;
	ts_free(bottom);
	return TS_OK;
}

static bool are_in_one_column(const struct ts_bed_grain *a, const struct ts_bed_grain *b)
{
	return ts_compare_double(&a->cell[0], &b->cell[0]) == 0 &&
	       ts_compare_double(&a->cell[1], &b->cell[1]) == 0;
}

enum ts_status ts_bed_surface_find(struct tsim *sim, int group, double column, double part,
				   struct ts_bed_surface *s)
{
	if (TS_GROW(s->grain, s->capacity, sim->particles->n + 1) != TS_OK ||
	    TS_GROW(s->top, s->top_capacity, sim->particles->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	list_grains(sim, group, column, s);
	ts_sort(s->grain, s->n, sizeof *s->grain, compare_grains);
	s->ntops = 0;
	for (size_t from = 0, to; from < s->n; from = to) {
		for (to = from + 1; to < s->n && are_in_one_column(&s->grain[from], &s->grain[to]);)
			to++;
		s->top[s->ntops++] = from + quantile(to - from, part);
	}
	return find_base(s) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

void ts_bed_surface_release(struct ts_bed_surface *s)
{
	ts_free(s->grain);
	ts_free(s->top);
}
