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

/* Far away coordinates share the outermost cells: slow, but right. */
static void cell_of(const struct ts_pointhash *hash, const double x[3], int64_t cell[3])
{
	for (int d = 0; d < 3; d++)
		cell[d] = (int64_t)fmax(-0x1p60, fmin(0x1p60, floor(x[d] / hash->cell)));
}

static void chain(struct ts_pointhash *hash, size_t k)
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
		chain(hash, k);
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
	chain(hash, hash->n - 1);
	return TS_OK;
}

int32_t ts_pointhash_find(const struct ts_pointhash *hash, const double x[3], double distance)
{
	int64_t home[3];

	cell_of(hash, x, home);
	for (int k = 0; k < 27; k++) {
		const int64_t cell[3] = { home[0] + k % 3 - 1, home[1] + k / 3 % 3 - 1,
					  home[2] + k / 9 - 1 };

		for (int32_t i = hash->bucket[bucket_of(hash, cell)]; i >= 0; i = hash->next[i])
			if (ts_distance2(x, hash->x[i]) < distance * distance)
				return i;
	}
	return -1;
}

bool ts_pointhash_near(const struct ts_pointhash *hash, const double x[3], double distance)
{
	return ts_pointhash_find(hash, x, distance) >= 0;
}

bool ts_pointhash_near_periodic(const struct ts_pointhash *hash, const struct ts_box *box,
				const double x[3], double distance)
{
	for (int k = 0; k < 27; k++) {
		const int shift[3] = { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 };
		double image[3];
		bool possible = true;

		for (int d = 0; d < 3; d++) {
			image[d] = x[d] + shift[d] * ts_box_length(box, d);
			if (shift[d])
				possible &= ts_box_periodic(box, d) &&
					    image[d] > box->lo[d] - distance &&
					    image[d] < box->hi[d] + distance;
		}
		if (possible && ts_pointhash_near(hash, image, distance))
			return true;
	}
	return false;
}
