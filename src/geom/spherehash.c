#include "geom/spherehash.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "math/vec3.h"

#include "base/banned.h"

void ts_spherehash_release(struct ts_spherehash *hash)
{
	for (int k = 0; k < hash->nlevels; k++) {
		ts_pointhash_release(&hash->level[k].points);
		ts_free(hash->level[k].radius);
		ts_free(hash->level[k].item);
	}
	*hash = (struct ts_spherehash){ 0 };
}

/* Level of a radius; if all levels are in use, the one of the most similar size. */
static enum ts_status find_or_add_level(struct ts_spherehash *hash, double radius,
					struct ts_spherehash_level **out)
{
	int exponent = 0, best = 0;
	struct ts_spherehash_level *level;

	(void)frexp(radius, &exponent);
	for (int k = 0; k < hash->nlevels; k++) {
		if (abs(hash->level[k].exponent - exponent) < abs(hash->level[best].exponent - exponent))
			best = k;
	}
	*out = &hash->level[best];
	if (hash->nlevels && ((*out)->exponent == exponent || hash->nlevels == TS_SPHEREHASH_LEVELS))
		return TS_OK;
	level = &hash->level[hash->nlevels];
	*level = (struct ts_spherehash_level){ .exponent = exponent };
	TS_TRY(ts_pointhash_start(&level->points, ldexp(2, exponent)));
	hash->nlevels++;
	*out = level;
	return TS_OK;
}

enum ts_status ts_spherehash_add(struct ts_spherehash *hash, const double x[3], double radius)
{
	struct ts_spherehash_level *level;

	TS_TRY(find_or_add_level(hash, radius, &level));
	TS_TRY(TS_GROW(level->radius, level->capacity, level->points.n + 1));
	TS_TRY(TS_GROW(level->item, level->item_capacity, level->points.n + 1));
	level->radius[level->points.n] = radius;
	level->item[level->points.n] = hash->n++;
	level->largest = fmax(level->largest, radius);
	return ts_pointhash_add(&level->points, x);
}

struct overlap_query {
	const struct ts_spherehash_level *level;
	const double *x;
	double radius;
	ts_pointhash_fn *visit;
	void *context;
};

static bool visit_point(void *context, size_t k)
{
	const struct overlap_query *q = context;
	double reach = q->radius + q->level->radius[k];

	return ts_distance2(q->x, q->level->points.x[k]) <= reach * reach &&
	       q->visit(q->context, q->level->item[k]);
}

bool ts_spherehash_visit(const struct ts_spherehash *hash, const double x[3], double radius,
			 ts_pointhash_fn *visit, void *context)
{
	for (int k = 0; k < hash->nlevels; k++) {
		const struct ts_spherehash_level *level = &hash->level[k];
		struct overlap_query q = { level, x, radius, visit, context };

		if (ts_pointhash_visit(&level->points, x, radius + level->largest, visit_point, &q) >= 0)
			return true;
	}
	return false;
}

static bool accept(void *context, size_t k)
{
	(void)context;
	(void)k;
	return true;
}

bool ts_spherehash_overlaps(const struct ts_spherehash *hash, const double x[3], double radius)
{
	return ts_spherehash_visit(hash, x, radius, accept, NULL);
}

double ts_spherehash_largest(const struct ts_spherehash *hash)
{
	double most = 0;

	for (int k = 0; k < hash->nlevels; k++)
		most = fmax(most, hash->level[k].largest);
	return most;
}

bool ts_spherehash_overlaps_periodic(const struct ts_spherehash *hash, const struct ts_box *box,
				     const double x[3], double radius)
{
	double reach = radius + ts_spherehash_largest(hash);

	for (int k = 0; k < 27; k++) {
		double image[3];

		if (ts_box_image(box, x, k, reach, image) && ts_spherehash_overlaps(hash, image, radius))
			return true;
	}
	return false;
}
