#include "geom/pointhash.h"

#include <math.h>

#include "base/alloc.h"
#include "math/vec3.h"

#include "base/banned.h"

static size_t bucket_of(const struct ts_pointhash *hash, const int64_t cell[3])
{
	uint64_t h = (uint64_t)cell[0] * UINT64_C(0x9e3779b97f4a7c15) ^
		     (uint64_t)cell[1] * UINT64_C(0xc2b2ae3d27d4eb4f) ^
		     (uint64_t)cell[2] * UINT64_C(0x165667b19e3779f9);

	return (h ^ h >> 29) & (hash->nbuckets - 1);
}

/* Coordinates beyond the range of indices share the outermost cells: slow, but correct. */
static void cell_of(const struct ts_pointhash *hash, const double x[3], int64_t cell[3])
{
	for (int d = 0; d < 3; d++)
		cell[d] = (int64_t)fmax(-0x1p60, fmin(0x1p60, floor(x[d] / hash->cell)));
}

static void insert_in_bucket(struct ts_pointhash *hash, size_t k)
{
	int64_t cell[3];
	size_t b;

	cell_of(hash, hash->x[k], cell);
	b = bucket_of(hash, cell);
	hash->next[k] = hash->bucket[b];
	hash->bucket[b] = (int32_t)k;
}

static enum ts_status rehash(struct ts_pointhash *hash, size_t nbuckets)
{
	int32_t *bucket = ts_alloc(nbuckets, sizeof *bucket);

	if (!bucket)
		return TS_NOMEM;
	ts_free(hash->bucket);
	hash->bucket = bucket;
	hash->nbuckets = nbuckets;
	for (size_t b = 0; b < nbuckets; b++)
		bucket[b] = -1;
	for (size_t k = 0; k < hash->n; k++)
		insert_in_bucket(hash, k);
	return TS_OK;
}

enum ts_status ts_pointhash_start(struct ts_pointhash *hash, double cell)
{
	*hash = (struct ts_pointhash){ .cell = cell };
	return rehash(hash, 64);
}

void ts_pointhash_release(struct ts_pointhash *hash)
{
	ts_free(hash->x);
	ts_free(hash->next);
	ts_free(hash->bucket);
	*hash = (struct ts_pointhash){ 0 };
}

enum ts_status ts_pointhash_add(struct ts_pointhash *hash, const double x[3])
{
	TS_TRY(TS_GROW(hash->x, hash->capacity, hash->n + 1));
	TS_TRY(TS_GROW(hash->next, hash->next_capacity, hash->n + 1));
	for (int d = 0; d < 3; d++)
		hash->x[hash->n][d] = x[d];
	hash->n++;
	if (hash->n > hash->nbuckets)
		return rehash(hash, 4 * hash->nbuckets);
	insert_in_bucket(hash, hash->n - 1);
	return TS_OK;
}

/* With more cells than points all points are visited. */
static int32_t visit_all(const struct ts_pointhash *hash, ts_pointhash_fn *visit, void *context)
{
	for (size_t k = 0; k < hash->n; k++)
		if (visit(context, k))
			return (int32_t)k;
	return -1;
}

/* Squared distance from x to a cell along one axis; -infinity where cells cannot be resolved. */
static double cell_distance2(const struct ts_pointhash *hash, double x, int64_t cell)
{
	double lo = (double)cell * hash->cell, hi = lo + hash->cell;
	double gap = x < lo ? lo - x : x > hi ? x - hi : 0;

	return fabs(lo) < 0x1p40 * hash->cell ? gap * gap : -INFINITY;
}

/* Iterator over the cells around x, `steps` to each side. */
struct cell_iterator {
	const struct ts_pointhash *hash;
	const double *x;
	int64_t home[3], steps;
	int64_t cell[3];
	double gap2[3];
};

static void next_cell(struct cell_iterator *w)
{
	for (int d = 0; d < 3; d++) {
		bool last = w->cell[d] == w->home[d] + w->steps;

		w->cell[d] += last ? -2 * w->steps : 1;
		w->gap2[d] = cell_distance2(w->hash, w->x[d], w->cell[d]);
		if (!last)
			return;
	}
}

/* Starts at the cell of x: most queries stop at the first point, which is most likely there. */
int32_t ts_pointhash_visit(const struct ts_pointhash *hash, const double x[3], double reach,
			   ts_pointhash_fn *visit, void *context)
{
	double steps = fmax(1, ceil(reach / hash->cell)), wide = 2 * steps + 1, far = 1.0001 * reach * reach;
	struct cell_iterator w = { .hash = hash, .x = x };
	int64_t cells;

	if (!(wide * wide * wide <= 27 + (double)hash->n))
		return visit_all(hash, visit, context);
	cells = (int64_t)(wide * wide * wide);
	w.steps = (int64_t)steps;
	cell_of(hash, x, w.home);
	for (int d = 0; d < 3; d++) {
		w.cell[d] = w.home[d];
		w.gap2[d] = cell_distance2(hash, x[d], w.home[d]);
	}
	for (int64_t j = 0; j < cells; j++, next_cell(&w)) {
		if (w.gap2[0] + w.gap2[1] + w.gap2[2] > far)
			continue;
		for (int32_t i = hash->bucket[bucket_of(hash, w.cell)]; i >= 0; i = hash->next[i])
			if (visit(context, (size_t)i))
				return i;
	}
	return -1;
}

struct nearer {
	const struct ts_pointhash *hash;
	const double *x;
	double distance2;
};

static bool is_nearer(void *context, size_t k)
{
	const struct nearer *c = context;

	return ts_distance2(c->x, c->hash->x[k]) < c->distance2;
}

int32_t ts_pointhash_find(const struct ts_pointhash *hash, const double x[3], double distance)
{
	struct nearer c = { hash, x, distance * distance };

	return ts_pointhash_visit(hash, x, distance, is_nearer, &c);
}

bool ts_pointhash_near(const struct ts_pointhash *hash, const double x[3], double distance)
{
	return ts_pointhash_find(hash, x, distance) >= 0;
}

bool ts_pointhash_near_periodic(const struct ts_pointhash *hash, const struct ts_box *box, const double x[3],
				double distance)
{
	for (int k = 0; k < 27; k++) {
		double image[3];

		if (ts_box_image(box, x, k, distance, image) && ts_pointhash_near(hash, image, distance))
			return true;
	}
	return false;
}
