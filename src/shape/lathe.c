#include "shape/lathe.h"

#include <math.h>

#include "math/constants.h"

#include "base/banned.h"

struct ring {
	double r, z;
	int n; /* segments */
};
enum { FEWEST = 8, STEP = 4, STRETCH = 6 };

static double width(const struct ring *ring)
{
	return ring->r > 0 ? 2 * TS_PI * ring->r / ring->n : INFINITY;
}

/* Between two rings of a flat annulus or disc: moves the one with the finer segments towards the other by a few
 * of them, and halves their number, so that triangles become larger away from the edges. */
static void coarsen(struct ring *ring, double to)
{
	double step = fmin(STEP * width(ring), 0.5 * fabs(to - ring->r));

	ring->r += to > ring->r ? step : -step;
	if (ring->n >= 2 * FEWEST)
		ring->n /= 2;
}

static void zip_rings(struct ts_facets *f, const struct ring *a, const struct ring *b)
{
	struct ts_rim lower = { 0 }, upper = { 0 };

	ts_rim_circle(f, &lower, a->r, a->z, a->n);
	ts_rim_circle(f, &upper, b->r, b->z, b->n);
	ts_facets_zip(f, &lower, &upper);
	ts_rim_release(&lower);
	ts_rim_release(&upper);
}

/* Flat annulus between a and b, whose triangles grow from both edges. */
static void add_annulus(struct ts_facets *f, struct ring a, struct ring b)
{
	while (f->status == TS_OK && fabs(a.r - b.r) > STRETCH * fmin(width(&a), width(&b))) {
		struct ring *fine = width(&a) <= width(&b) ? &a : &b, before = *fine;

		coarsen(fine, fine == &a ? b.r : a.r);
		if (fine == &a)
			zip_rings(f, &before, &a);
		else
			zip_rings(f, &b, &before);
	}
	zip_rings(f, &a, &b);
}

/* Flat annulus of cells with sides near `size`. */
static void add_fine_annulus(struct ts_facets *f, const struct ring *a, const struct ring *b)
{
	int rows = ts_facets_count(f, fabs(a->r - b->r), INFINITY, 1);
	struct ring from = *a;

	for (int k = 1; k <= rows && f->status == TS_OK; k++) {
		struct ring to = { .r = ts_facets_between(a->r, b->r, k, rows), .z = a->z, .n = a->n };

		if (k < rows)
			to.n = (int)fmax(FEWEST, fmin(a->n, ceil(2 * TS_PI * to.r / f->size)));
		zip_rings(f, &from, &to);
		from = to;
	}
}

/* Side of a cylinder or cone. Without `size` the rows of a cone have the same ratio of height to width:
 * (r, z) of row k = that of the smaller end times q^k. */
static void add_side(struct ts_facets *f, const struct ring *a, const struct ring *b)
{
	double slant = hypot(b->r - a->r, b->z - a->z), across = width(a);
	bool pointed = !(a->r > 0) || !(b->r > 0), graded = !pointed && a->r != b->r && !isfinite(f->size);
	struct ring from = *a;
	int rows;

	if (graded)
		across *= (b->r / a->r - 1) / log(b->r / a->r);
	rows = ts_facets_count(f, slant, pointed ? INFINITY : across, TS_LATHE_ASPECT);
	rows = rows < f->rows ? f->rows : rows;
	for (int k = 1; k <= rows && f->status == TS_OK; k++) {
		double part = graded ? (pow(b->r / a->r, (double)k / rows) - 1) / (b->r / a->r - 1) : 0;
		struct ring to = { .r = ts_facets_between(a->r, b->r, k, rows),
				   .z = ts_facets_between(a->z, b->z, k, rows),
				   .n = a->n };

		if (graded && k < rows) {
			to.r = a->r + part * (b->r - a->r);
			to.z = a->z + part * (b->z - a->z);
		}
		zip_rings(f, &from, &to);
		from = to;
	}
}

void ts_lathe(struct ts_facets *f, const double (*profile)[2], size_t n)
{
	for (size_t k = 0; k + 1 < n && f->status == TS_OK; k++) {
		struct ring a = { profile[k][0], profile[k][1], f->segments };
		struct ring b = { profile[k + 1][0], profile[k + 1][1], f->segments };

		if (a.z != b.z)
			add_side(f, &a, &b);
		else if (isfinite(f->size))
			add_fine_annulus(f, &a, &b);
		else
			add_annulus(f, a, b);
	}
}
