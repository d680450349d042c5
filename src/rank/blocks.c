#include "rank/blocks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/sort.h"

#include "base/banned.h"

bool ts_rank_blocks_choose(int n, const int given[3], const double area[3], int dimension, int out[3])
{
	double best = INFINITY;

	for (int a = 1; a <= n; a++) {
		for (int b = 1; n % a == 0 && b <= n / a; b++) {
			int count[3] = { a, b, n / a / b };
			double sum = (a - 1) * area[0] + (b - 1) * area[1] + (count[2] - 1) * area[2];
			bool fits = n / a % b == 0 && (dimension == 3 || count[2] == 1);

			for (int d = 0; d < 3; d++)
				fits &= (!given[d] || given[d] == count[d]) && count[d] <= TS_BLOCKS_MOST;
			if (!fits || !(sum < best))
				continue;
			best = sum;
			for (int d = 0; d < 3; d++)
				out[d] = count[d];
		}
	}
	return best < INFINITY;
}

/* Number of parts that are cut along d. */
static size_t parts_along(const int count[3], int d)
{
	size_t n = 1;

	for (int k = 0; k < d; k++)
		n *= (size_t)count[k];
	return n;
}

double *ts_rank_blocks_faces(const struct ts_rank_blocks *blocks, int d, const int k[3])
{
	size_t part = 0;

	for (int e = d - 1; e >= 0; e--)
		part = part * (size_t)blocks->count[e] + (size_t)k[e];
	return blocks->cut[d] + part * ((size_t)blocks->count[d] + 1);
}

static void set_box(struct ts_rank_blocks *blocks, const double lo[3], const double hi[3])
{
	for (int d = 0; d < 3; d++) {
		blocks->lo[d] = lo[d];
		blocks->length[d] = hi[d] - lo[d];
	}
}

static void begin(struct ts_rank_blocks *blocks, const int count[3], const double lo[3], const double hi[3],
		  const bool periodic[3])
{
	ts_rank_blocks_release(blocks);
	set_box(blocks, lo, hi);
	for (int d = 0; d < 3; d++) {
		blocks->count[d] = count[d];
		blocks->periodic[d] = periodic[d];
	}
}

bool ts_rank_blocks_cut(struct ts_rank_blocks *blocks, const int count[3], const double lo[3],
			const double hi[3], const bool periodic[3])
{
	begin(blocks, count, lo, hi, periodic);
	for (int d = 0; d < 3; d++) {
		size_t parts = parts_along(count, d), n = (size_t)count[d] + 1;

		blocks->cut[d] = ts_alloc(parts * n, sizeof *blocks->cut[d]);
		if (!blocks->cut[d])
			return false;
		for (size_t k = 0; k < parts * n; k++)
			blocks->cut[d][k] =
				k % n == n - 1 ? hi[d] : lo[d] + (hi[d] - lo[d]) * (double)(k % n) / count[d];
	}
	return true;
}

bool ts_rank_blocks_bisect(struct ts_rank_blocks *blocks, int n, const double lo[3], const double hi[3],
			   const bool periodic[3])
{
	begin(blocks, (const int[3]){ n, 1, 1 }, lo, hi, periodic);
	blocks->bisection = ts_alloc((size_t)n, sizeof *blocks->bisection);
	for (int m = 0; blocks->bisection && m < n - 1; m++)
		blocks->bisection[m] = (struct ts_rank_cut){ 0, lo[0] + (hi[0] - lo[0]) * (m + 1) / n };
	return blocks->bisection;
}

static void *copy_of(const void *from, size_t bytes)
{
	void *to = ts_alloc(bytes, 1);

	if (to)
		memcpy(to, from, bytes);
	return to;
}

bool ts_rank_blocks_copy(struct ts_rank_blocks *to, const struct ts_rank_blocks *from)
{
	size_t n = (size_t)ts_rank_blocks_number(from);

	begin(to, from->count, from->lo, (const double[3]){ 0 }, from->periodic);
	memcpy(to->length, from->length, sizeof to->length);
	if (from->bisection) {
		to->bisection = copy_of(from->bisection, n * sizeof *to->bisection);
		return to->bisection;
	}
	for (int d = 0; d < 3; d++) {
		to->cut[d] = copy_of(from->cut[d], parts_along(from->count, d) *
							   ((size_t)from->count[d] + 1) * sizeof *to->cut[d]);
		if (!to->cut[d])
			return false;
	}
	return true;
}

void ts_rank_blocks_fit(struct ts_rank_blocks *blocks, const double lo[3], const double hi[3])
{
	set_box(blocks, lo, hi);
	for (int d = 0; d < 3 && !blocks->bisection; d++) {
		size_t n = (size_t)blocks->count[d] + 1;

		for (size_t part = 0; part < parts_along(blocks->count, d); part++) {
			blocks->cut[d][part * n] = lo[d];
			blocks->cut[d][part * n + n - 1] = hi[d];
		}
	}
}

/* ---- balance */

/* The last block whose lower face is not above x: compared with the same numbers by all ranks, so that a point on a
 * cut belongs to exactly one. */
static int block_along(const double *face, int count, double x)
{
	int lo = 0, hi = count;

	while (hi - lo > 1) {
		int middle = lo + (hi - lo) / 2;

		if (x >= face[middle])
			lo = middle;
		else
			hi = middle;
	}
	return lo;
}

/* Coordinates as integers in the same order. */
static uint64_t key_of(double x)
{
	uint64_t bits;

	memcpy(&bits, &x, sizeof bits);
	return bits >> 63 ? ~bits : bits | UINT64_C(1) << 63;
}

static double coordinate(uint64_t key)
{
	uint64_t bits = key >> 63 ? key & ~(UINT64_C(1) << 63) : ~key;
	double x;

	memcpy(&x, &bits, sizeof x);
	return x;
}

/* key: [2][n]; the sorted ones are the first n. */
static void sort_along(double (*x)[3], size_t n, int d, uint64_t *key)
{
	for (size_t i = 0; i < n; i++)
		key[i] = key_of(x[i][d]);
	ts_sort_equal_keys(key, key + n, n);
}

bool ts_rank_points_filled(double (*x)[3], size_t n, size_t few, double length[3])
{
	uint64_t *key = ts_alloc_unset(2 * n + 1, sizeof *key);

	for (int d = 0; key && d < 3; d++) {
		sort_along(x, n, d, key);
		length[d] = coordinate(key[n - 1 - few]) - coordinate(key[few]);
	}
	ts_free(key);
	return key != NULL;
}

/* The space of the points, divided into cells; by cell which halves of the points it has: bit 2 d + side. */
struct halves {
	double lo[3], length[3], middle[3];
	int cells; /* along each dimension */
	unsigned char *seen;
};

static enum ts_status start_halves(double (*x)[3], size_t n, struct halves *h)
{
	uint64_t *key = ts_alloc_unset(2 * n + 1, sizeof *key);

	for (int d = 0; key && d < 3; d++) {
		sort_along(x, n, d, key);
		h->lo[d] = coordinate(key[0]);
		h->length[d] = coordinate(key[n - 1]) - h->lo[d];
		h->middle[d] = coordinate(key[n / 2]);
	}
	ts_free(key);
	h->seen = ts_alloc((size_t)h->cells * (size_t)h->cells * (size_t)h->cells, 1);
	return key && h->seen ? TS_OK : TS_NOMEM;
}

static size_t cell_of(const struct halves *h, const double x[3])
{
	size_t at = 0;

	for (int d = 2; d >= 0; d--) {
		double part = h->length[d] > 0 ? (x[d] - h->lo[d]) / h->length[d] : 0;

		at = at * (size_t)h->cells + (size_t)fmin(part * h->cells, h->cells - 1);
	}
	return at;
}

/* number[d][side]: cells with points of this half. */
static void count_halves(double (*x)[3], size_t n, const struct halves *h, int64_t number[3][2])
{
	for (size_t i = 0; i < n; i++) {
		unsigned char *seen = &h->seen[cell_of(h, x[i])];

		for (int d = 0; d < 3; d++) {
			int side = x[i][d] >= h->middle[d], bit = 1 << (2 * d + side);

			number[d][side] += !(*seen & bit);
			*seen = (unsigned char)(*seen | bit);
		}
	}
}

bool ts_rank_points_unlike(double (*x)[3], size_t n, double unlike[3])
{
	enum { IN_CELL = 4, FEWEST = 4, MOST = 32 };
	struct halves h = { .cells = (int)fmin(cbrt((double)n / IN_CELL), MOST) };
	int64_t number[3][2] = { { 0 } };
	bool done;

	for (int d = 0; d < 3; d++)
		unlike[d] = 0;
	if (h.cells < FEWEST)
		return true;
	done = start_halves(x, n, &h) == TS_OK;
	if (done)
		count_halves(x, n, &h, number);
	ts_free(h.seen);
	for (int d = 0; done && d < 3; d++)
		unlike[d] = (double)llabs((long long)(number[d][1] - number[d][0])) /
			    (double)(number[d][0] + number[d][1]);
	return done;
}

/* The first point of the upper part, next to point m, if points with the same coordinate, such as a layer of a lattice,
 * stay together. */
static size_t between_layers(const uint64_t *key, size_t n, size_t m)
{
	double layer = coordinate(key[m]);
	size_t lower = m, upper = m;

	while (lower > 0 && coordinate(key[lower - 1]) == layer)
		lower--;
	while (lower < m && upper < n && coordinate(key[upper]) == layer)
		upper++;
	return upper < n && upper - m < m - lower ? upper : lower;
}

/* A coordinate above that of point m - 1 and not above that of point m. */
static double cut_before(const uint64_t *key, size_t m)
{
	double below = coordinate(key[m - 1]), above = coordinate(key[m]);
	double middle = below + (above - below) / 2;

	return middle > below ? middle : above;
}

/* Cuts a part along d, and its blocks along the dimensions that follow. */
struct balancing {
	struct ts_rank_blocks *blocks;
	uint64_t *key;	    /* [2][points] */
	double (*moved)[3]; /* [points] */
	size_t *first[3];   /* [count + 1], by dimension: the first of the points of each block, sorted */
};

/* Sets the cuts of a part from its points; first[k], k <= count: of the points of its blocks. */
static void cut_part(const struct balancing *b, double (*x)[3], size_t n, int d, double *face)
{
	size_t *first = b->first[d], count = (size_t)b->blocks->count[d];

	sort_along(x, n, d, b->key);
	first[0] = 0;
	first[count] = n;
	for (size_t k = 1; k < count; k++) {
		size_t at = between_layers(b->key, n, n * k / count);

		first[k] = at > first[k - 1] ? at : first[k - 1];
		face[k] = first[k] > 0 ? cut_before(b->key, first[k]) : coordinate(b->key[0]);
	}
}

/* Puts the points of each block next to each other. */
static void sort_by_block(const struct balancing *b, double (*x)[3], size_t n, int d, const double *face)
{
	size_t *next = b->first[d], count = (size_t)b->blocks->count[d];

	for (size_t i = 0; i < n; i++)
		memcpy(b->moved[next[block_along(face, (int)count, x[i][d])]++], x[i], sizeof *x);
	memcpy(x, b->moved, n * sizeof *x);
	for (size_t k = count; k > 0; k--) /* each has become the first one of the next block */
		next[k] = next[k - 1];
	next[0] = 0;
}

/* Without points the cuts stay. */
static void balance_part(const struct balancing *b, double (*x)[3], size_t n, int d, int k[3])
{
	double *face;

	if (d == 3 || n == 0)
		return;
	face = ts_rank_blocks_faces(b->blocks, d, k);
	cut_part(b, x, n, d, face);
	if (d == 2)
		return;
	sort_by_block(b, x, n, d, face);
	for (k[d] = 0; k[d] < b->blocks->count[d]; k[d]++)
		balance_part(b, x + b->first[d][k[d]], b->first[d][k[d] + 1] - b->first[d][k[d]], d + 1, k);
}

bool ts_rank_blocks_balance(struct ts_rank_blocks *blocks, double (*x)[3], size_t n)
{
	struct balancing b = { .blocks = blocks,
			       .key = ts_alloc_unset(2 * n + 1, sizeof *b.key),
			       .moved = ts_alloc_unset(n + 1, sizeof *b.moved) };
	bool done = b.key && b.moved;
	int k[3] = { 0 };

	for (int d = 0; d < 3; d++) {
		b.first[d] = ts_alloc((size_t)blocks->count[d] + 1, sizeof *b.first[d]);
		done &= b.first[d] != NULL;
	}
	if (done)
		balance_part(&b, x, n, 0, k);
	for (int d = 0; d < 3; d++)
		ts_free(b.first[d]);
	ts_free(b.moved);
	ts_free(b.key);
	return done;
}

void ts_rank_blocks_release(struct ts_rank_blocks *blocks)
{
	for (int d = 0; d < 3; d++)
		ts_free(blocks->cut[d]);
	ts_free(blocks->bisection);
	*blocks = (struct ts_rank_blocks){ 0 };
}

/* The first rank, and their number, of the lower or upper half of these. */
static void go_down(int *first, int *n, bool upper)
{
	int below = *n / 2;

	*first += upper ? below : 0;
	*n = upper ? *n - below : below;
}

static int find_leaf(const struct ts_rank_blocks *blocks, const double x[3])
{
	int first = 0, n = blocks->count[0];

	while (n > 1) {
		const struct ts_rank_cut *cut = &blocks->bisection[first + n / 2 - 1];

		go_down(&first, &n, x[cut->dim] >= cut->at);
	}
	return first;
}

int ts_rank_blocks_owner(const struct ts_rank_blocks *blocks, const double x[3])
{
	int k[3] = { 0 };

	if (blocks->bisection)
		return find_leaf(blocks, x);
	for (int d = 0; d < 3; d++)
		k[d] = block_along(ts_rank_blocks_faces(blocks, d, k), blocks->count[d], x[d]);
	return k[0] + blocks->count[0] * (k[1] + blocks->count[1] * k[2]);
}

/* Block k[d] of its part; the blocks along the dimensions that follow do not matter. */
static struct ts_rank_side side_of_grid(const struct ts_rank_blocks *blocks, const int k[3], int d)
{
	const double *face = ts_rank_blocks_faces(blocks, d, k) + k[d];
	const bool closed = blocks->periodic[d];

	return (struct ts_rank_side){ { face[0], face[1] },
				      { k[d] == 0 && !closed, k[d] == blocks->count[d] - 1 && !closed } };
}

static struct ts_rank_side whole_side(const struct ts_rank_blocks *blocks, int d)
{
	const bool open = !blocks->periodic[d];

	return (struct ts_rank_side){ { blocks->lo[d], blocks->lo[d] + blocks->length[d] }, { open, open } };
}

static struct ts_rank_side half_of(struct ts_rank_side side, double at, bool upper)
{
	side.face[!upper] = at;
	side.open[!upper] = false;
	return side;
}

static struct ts_rank_side side_of_leaf(const struct ts_rank_blocks *blocks, int rank, int d)
{
	struct ts_rank_side side = whole_side(blocks, d);
	int first = 0, n = blocks->count[0];

	while (n > 1) {
		const struct ts_rank_cut *cut = &blocks->bisection[first + n / 2 - 1];
		bool upper = rank >= first + n / 2;

		if (cut->dim == d)
			side = half_of(side, cut->at, upper);
		go_down(&first, &n, upper);
	}
	return side;
}

static bool is_near(const struct ts_rank_side *side, double x, double reach)
{
	return (side->open[0] || x >= side->face[0] - reach) && (side->open[1] || x <= side->face[1] + reach);
}

static bool image_is_near(const struct ts_rank_blocks *blocks, struct ts_rank_side side, int d, double x,
			  double reach)
{
	double length = blocks->length[d];

	return is_near(&side, x, reach) || (blocks->periodic[d] && (is_near(&side, x - length, reach) ||
								    is_near(&side, x + length, reach)));
}

struct ts_rank_side ts_rank_blocks_side(const struct ts_rank_blocks *blocks, int rank, int d)
{
	const int *n = blocks->count, k[3] = { rank % n[0], rank / n[0] % n[1], rank / n[0] / n[1] };

	return blocks->bisection ? side_of_leaf(blocks, rank, d) : side_of_grid(blocks, k, d);
}

struct ts_rank_block ts_rank_blocks_block(const struct ts_rank_blocks *blocks, int rank)
{
	struct ts_rank_block block;

	for (int d = 0; d < 3; d++)
		block.side[d] = ts_rank_blocks_side(blocks, rank, d);
	return block;
}

bool ts_rank_blocks_near(const struct ts_rank_blocks *blocks, int rank, int d, double x, double reach)
{
	const struct ts_rank_side side = ts_rank_blocks_side(blocks, rank, d);

	return is_near(&side, x, reach);
}

bool ts_rank_blocks_reach(const struct ts_rank_blocks *blocks, int rank, const double x[3], double reach)
{
	for (int d = 0; d < 3; d++)
		if (!image_is_near(blocks, ts_rank_blocks_side(blocks, rank, d), d, x[d], reach))
			return false;
	return true;
}

struct visitor {
	const struct ts_rank_blocks *blocks;
	const double *x;
	double reach;
	ts_rank_visit_fn *visit;
	void *context;
};

static void visit_part(const struct visitor *v, int d, int k[3])
{
	const int *n = v->blocks->count;

	if (d == 3) {
		v->visit(v->context, k[0] + n[0] * (k[1] + n[1] * k[2]));
		return;
	}
	for (k[d] = 0; k[d] < n[d]; k[d]++)
		if (image_is_near(v->blocks, side_of_grid(v->blocks, k, d), d, v->x[d], v->reach))
			visit_part(v, d + 1, k);
}

/* The ranks first .. first + n - 1, which have this part of the box. */
static void visit_halves(const struct visitor *v, int first, int n, const struct ts_rank_side side[3])
{
	const struct ts_rank_cut *cut;

	if (n == 1) {
		v->visit(v->context, first);
		return;
	}
	cut = &v->blocks->bisection[first + n / 2 - 1];
	for (int upper = 0; upper < 2; upper++) {
		struct ts_rank_side half[3] = { side[0], side[1], side[2] };
		int from = first, ranks = n;

		half[cut->dim] = half_of(half[cut->dim], cut->at, upper);
		go_down(&from, &ranks, upper);
		if (image_is_near(v->blocks, half[cut->dim], cut->dim, v->x[cut->dim], v->reach))
			visit_halves(v, from, ranks, half);
	}
}

void ts_rank_blocks_visit(const struct ts_rank_blocks *blocks, const double x[3], double reach,
			  ts_rank_visit_fn *visit, void *context)
{
	const struct visitor v = { blocks, x, reach, visit, context };
	const struct ts_rank_side side[3] = { whole_side(blocks, 0), whole_side(blocks, 1),
					      whole_side(blocks, 2) };
	int k[3] = { 0 };

	if (blocks->bisection)
		visit_halves(&v, 0, blocks->count[0], side);
	else
		visit_part(&v, 0, k);
}
