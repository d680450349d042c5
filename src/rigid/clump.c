#include "rigid/clump.h"

#include <math.h>

#include "base/alloc.h"
#include "math/vec3.h"

#include "base/banned.h"

/* Number of random orders in which spheres are added; the smallest bounding sphere is used. */
enum { NORDERS = 200 };

static size_t draw_unused(const unsigned char *seen, size_t n, struct ts_minstd *random)
{
	size_t k;

	do
		k = (size_t)(ts_minstd_uniform(random) * (double)n);
	while (k >= n || seen[k]);
	return k;
}

/* The smallest sphere that contains the bounding sphere so far and one more sphere. */
static void enlarge_bounding_sphere(const struct ts_clump_sphere *one, double middle[3], double *reach)
{
	double d[3], distance, part;

	ts_sub(one->x, middle, d);
	distance = ts_norm(d);
	if (distance + one->radius <= *reach)
		return;
	if (distance == 0) {
		*reach = one->radius;
		return;
	}
	part = (distance + one->radius - *reach) / (2 * distance);
	ts_axpy(part, d, middle);
	*reach += part * distance;
}

static enum ts_status find_bounding_sphere(struct ts_clump *c, struct ts_minstd *random)
{
	unsigned char *seen = ts_alloc(c->n, 1);

	if (!seen)
		return TS_NOMEM;
	c->reach = INFINITY;
	for (int order = 0; order < NORDERS; order++) {
		double middle[3] = { 0 }, reach = 0;

		for (size_t k = 0; k < c->n; k++)
			seen[k] = 0;
		for (size_t k = 0; k < c->n; k++) {
			size_t next = draw_unused(seen, c->n, random);

			seen[next] = 1;
			if (k == 0) {
				ts_scale(1, c->sphere[next].x, middle);
				reach = c->sphere[next].radius;
			} else {
				enlarge_bounding_sphere(&c->sphere[next], middle, &reach);
			}
		}
		if (reach < c->reach) {
			c->reach = reach;
			ts_scale(1, middle, c->middle);
		}
	}
	ts_free(seen);
	return TS_OK;
}

static void find_bounding_box(const struct ts_clump *c, double lo[3], double hi[3])
{
	for (int d = 0; d < 3; d++) {
		lo[d] = INFINITY;
		hi[d] = -INFINITY;
		for (size_t k = 0; k < c->n; k++) {
			lo[d] = fmin(lo[d], c->sphere[k].x[d] - c->sphere[k].radius);
			hi[d] = fmax(hi[d], c->sphere[k].x[d] + c->sphere[k].radius);
		}
	}
}

/* Draws a point of the bounding box; x: relative to `origin`. False if it is in none of the spheres. */
static bool draw_point(const struct ts_clump *c, const double lo[3], const double hi[3],
		       const double origin[3], struct ts_minstd *random, double x[3])
{
	double at[3];

	for (int d = 0; d < 3; d++)
		at[d] = lo[d] + (hi[d] - lo[d]) * ts_minstd_uniform(random);
	ts_sub(at, origin, x);
	for (size_t k = 0; k < c->n; k++)
		if (ts_distance2(at, c->sphere[k].x) < c->sphere[k].radius * c->sphere[k].radius)
			return true;
	return false;
}

static void add_moments(const double x[3], double sum[6])
{
	sum[0] += x[1] * x[1] + x[2] * x[2];
	sum[1] += x[0] * x[0] + x[2] * x[2];
	sum[2] += x[0] * x[0] + x[1] * x[1];
	sum[3] -= x[0] * x[1];
	sum[4] -= x[0] * x[2];
	sum[5] -= x[1] * x[2];
}

enum ts_status ts_clump_measure(struct ts_clump *c, int64_t tries, struct ts_minstd *random)
{
	const double origin[3] = { 0, 0, 0 };
	double lo[3], hi[3], x[3], sum[3] = { 0 }, moments[6] = { 0 }, box = 1;
	int64_t hits = 0;

	TS_TRY(find_bounding_sphere(c, random));
	find_bounding_box(c, lo, hi);
	for (int64_t k = 0; k < tries; k++) {
		if (!draw_point(c, lo, hi, origin, random, x))
			continue;
		hits++;
		ts_add(sum, x, sum);
	}
	if (!hits)
		return TS_RANGE;
	for (int d = 0; d < 3; d++) {
		c->centre[d] = sum[d] / (double)hits;
		box *= hi[d] - lo[d];
	}
	c->volume = box * (double)hits / (double)tries;
	for (int64_t k = 0; k < tries; k++)
		if (draw_point(c, lo, hi, c->centre, random, x))
			add_moments(x, moments);
	for (int k = 0; k < 6; k++)
		c->moments[k] = moments[k] * box / (double)tries;
	return TS_OK;
}
