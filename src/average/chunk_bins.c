/* Spatial bins: their position in the current box, and the bin of a point. */
#include <math.h>

#include "average/chunk_bins.h"
#include "box/domain.h"
#include "math/constants.h"

#include "base/banned.h"

/* Bins of equal width aligned with the origin that cover lo to hi: sets the lower end and their number. */
static void cover_range(struct ts_chunk_axis *a, double origin, double lo, double hi)
{
	double from, to, w = a->width;

	if (origin < lo) {
		from = origin + floor((lo - origin) / w) * w;
	} else {
		from = origin - floor((origin - lo) / w) * w;
		if (from > lo)
			from -= w;
	}
	if (origin < hi) {
		to = origin + floor((hi - origin) / w) * w;
		if (to < hi)
			to += w;
	} else {
		to = origin - floor((origin - hi) / w) * w;
	}
	a->lo = from;
	a->n = (int64_t)floor((to - from) / w + 0.5);
}

static enum ts_status place_axis(struct tsim *sim, const struct ts_instance *self, struct ts_chunks *c,
				 struct ts_chunk_axis *a)
{
	const struct ts_box *box = &sim->domain->box;
	const struct ts_chunk_bound *bound = c->bound[a->dim];
	double lo = bound[0].given ? bound[0].at : box->lo[a->dim];
	double hi = bound[1].given ? bound[1].at : box->hi[a->dim];
	double length = ts_box_length(box, a->dim), origin = lo;
	double unit = c->units == TS_LENGTHS_REDUCED
			      ? length
			      : ts_domain_scale(sim, c->units == TS_LENGTHS_BOX, a->dim);

	a->width = a->delta * unit;
	if (a->origin == TS_ORIGIN_CENTER)
		origin = 0.5 * (lo + hi);
	else if (a->origin == TS_ORIGIN_UPPER)
		origin = hi;
	else if (a->origin == TS_ORIGIN_VALUE)
		origin = a->at * unit + (c->units == TS_LENGTHS_REDUCED ? box->lo[a->dim] : 0);
	if (!(lo < hi) || (hi - lo) / a->width > 1e9)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "%s %s: no bins, or too many, of width %g from %g to %g",
			       ts_kind_name(self->style->kind), self->style->name, a->width, lo, hi);
	cover_range(a, origin, lo, hi);
	return TS_OK;
}

void ts_chunks_hold(struct ts_chunks *c, int64_t until)
{
	if (!ts_chunks_held(c))
		c->once = 0;
	if (until > c->held_until)
		c->held_until = until;
}

bool ts_chunks_held(const struct ts_chunks *c)
{
	return c->number == TS_NUMBER_ONCE || c->sim->clock.step <= c->held_until;
}

/* The bins stay those of the first placement. */
static void keep_first_bins(struct ts_chunks *c, int k)
{
	struct ts_chunk_axis *a = &c->axis[k];

	if (c->once) {
		a->lo = c->once_lo[k];
		a->n = c->once_n[k];
	} else {
		c->once_lo[k] = a->lo;
		c->once_n[k] = a->n;
	}
}

enum ts_status ts_chunk_bins_place(const struct ts_instance *self, struct ts_chunks *c)
{
	double total = (double)(c->shells ? c->shells : 1);
	bool held = ts_chunks_held(c);

	for (int k = 0; k < c->naxes; k++) {
		struct ts_chunk_axis *a = &c->axis[k];

		TS_TRY(place_axis(c->sim, self, c, a));
		if (held)
			keep_first_bins(c, k);
		total *= (double)a->n;
	}
	c->once = held;
	if (total > 1e9)
		return ts_fail(&c->sim->error, TS_RANGE, &self->where, "%s %s: %g bins are too many",
			       ts_kind_name(self->style->kind), self->style->name, total);
	c->n = (size_t)total;
	return TS_OK;
}

/* Bin number from 0 of a bin coordinate; -1: discarded. */
static int64_t clamp_bin(double at, int64_t n, bool discard_below, bool discard_above)
{
	if (!(at >= 0))
		return discard_below ? -1 : 0;
	if (at >= (double)n)
		return discard_above ? -1 : n - 1;
	return (int64_t)at;
}

static int64_t bin_along(const struct ts_chunks *c, const struct ts_chunk_axis *a, const double x[3])
{
	const struct ts_box *box = &c->sim->domain->box;
	double at = x[a->dim];
	/* the default is what LAMMPS does: `mixed` below, `yes` above */
	bool all = c->discard == TS_DISCARD_YES, usual = c->discard == TS_DISCARD_DEFAULT;
	bool mixed = c->discard == TS_DISCARD_MIXED;

	/* positions are wrapped at rebuilds only: in between a particle may be slightly outside */
	if (ts_box_periodic(box, a->dim))
		at -= floor((at - box->lo[a->dim]) / ts_box_length(box, a->dim)) * ts_box_length(box, a->dim);
	return clamp_bin(floor((at - a->lo) * (1 / a->width)), a->n,
			 all || ((mixed || usual) && c->bound[a->dim][0].given),
			 all || usual || (mixed && c->bound[a->dim][1].given));
}

/* Shell of a point by its distance from the centre, or from the axis of the cylinder. */
static int64_t shell_of(const struct ts_chunks *c, const double x[3])
{
	const struct ts_box *box = &c->sim->domain->box;
	bool sphere = c->style == TS_CHUNK_SPHERE;
	double r2 = 0, width = (c->outer - c->inner) / (double)c->shells, d[3] = { 0 };
	int k = 0;

	for (int dim = 0; dim < 3; dim++)
		if (sphere || dim != c->axis[0].dim)
			d[dim] = x[dim] - c->centre[k++];
	if (c->periodic)
		ts_box_nearest(box, d);
	for (int dim = 0; dim < 3; dim++) {
		if (!sphere && dim == c->axis[0].dim)
			continue;
		r2 += d[dim] * d[dim];
	}
	return clamp_bin(floor((sqrt(r2) - c->inner) / width), c->shells, c->discard == TS_DISCARD_YES,
			 c->discard == TS_DISCARD_YES);
}

int64_t ts_chunk_bin_of(const struct ts_chunks *c, const double x[3])
{
	int64_t bin = 0;

	if (c->style != TS_CHUNK_BINS)
		bin = shell_of(c, x);
	for (int k = 0; k < c->naxes && bin >= 0; k++) {
		int64_t along = bin_along(c, &c->axis[k], x);

		bin = along < 0 ? -1 : bin * c->axis[k].n + along;
	}
	return bin + 1;
}

int ts_chunks_dimension(const struct ts_chunks *c)
{
	return c->naxes + (c->style == TS_CHUNK_SPHERE || c->style == TS_CHUNK_CYLINDER);
}

/* Indices of a bin from its number: of the shell first, then along the axes; the last varies fastest. */
static void bin_indices(const struct ts_chunks *c, size_t chunk, int64_t index[4])
{
	int64_t bin = (c->compress ? c->original[chunk - 1] : (int64_t)chunk) - 1;
	int n = ts_chunks_dimension(c), shells = n - c->naxes;

	for (int k = n - 1; k >= 0; k--) {
		int64_t size = k < shells ? c->shells : c->axis[k - shells].n;

		index[k] = bin % size;
		bin /= size;
	}
}

double ts_chunks_coordinate(const struct ts_chunks *c, size_t chunk, int k)
{
	int shells = ts_chunks_dimension(c) - c->naxes;
	const struct ts_chunk_axis *a;
	int64_t index[4];
	double x;

	bin_indices(c, chunk, index);
	if (k < shells)
		return c->inner + ((double)index[0] + 0.5) * (c->outer - c->inner) / (double)c->shells;
	a = &c->axis[k - shells];
	x = a->lo + ((double)index[k] + 0.5) * a->width;
	if (c->units == TS_LENGTHS_REDUCED)
		x = (x - c->sim->domain->box.lo[a->dim]) / ts_box_length(&c->sim->domain->box, a->dim);
	return x;
}

/* Volume of a spherical shell, or area of a ring. */
static double shell_volume(const struct ts_chunks *c, int64_t shell, bool ball)
{
	double width = (c->outer - c->inner) / (double)c->shells;
	double from = c->inner + (double)shell * width, to = c->inner + (double)(shell + 1) * width;

	return ball ? 4 * TS_PI / 3 * (to * to * to - from * from * from) : TS_PI * (to * to - from * from);
}

double ts_chunks_volume(const struct ts_chunks *c, size_t chunk)
{
	const struct tsim *sim = c->sim;
	bool round = c->style == TS_CHUNK_SPHERE || c->style == TS_CHUNK_CYLINDER;
	bool done[3] = { false, false, sim->dimension == 2 };
	double volume = 1;
	int64_t index[4];

	if (round) {
		bin_indices(c, chunk, index);
		volume = shell_volume(c, index[0], c->style == TS_CHUNK_SPHERE && sim->dimension == 3);
		for (int dim = 0; dim < 3; dim++)
			done[dim] |= c->style == TS_CHUNK_SPHERE || dim != c->axis[0].dim;
	}
	for (int k = 0; k < c->naxes; k++)
		if (!done[c->axis[k].dim]) {
			volume *= c->axis[k].width;
			done[c->axis[k].dim] = true;
		}
	for (int dim = 0; dim < 3; dim++)
		if (!done[dim])
			volume *= ts_box_length(&sim->domain->box, dim);
	return volume;
}
