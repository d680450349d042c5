/* Blocks of space, one for each rank: the box is cut into Px x Py x Pz of them - into Px slabs along x, each of these into
 * Py along y at places of its own, and each of these into Pz along z - or by recursive bisection. */
#ifndef TS_RANK_BLOCKS_H
#define TS_RANK_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>

enum { TS_BLOCKS_MOST = 4096 }; /* ranks along one dimension */

/* A face of recursive bisection between the ranks m and m + 1: the ranks first .. first + n - 1, n > 1, have a part of the
 * box that is cut once, below rank first + n/2, so that each face is one such cut, that number first + n/2 - 1
 * (M. J. Berger, S. H. Bokhari, IEEE Trans. Comput. C-36, 570 (1987)). */
struct ts_rank_cut {
	int dim;
	double at;
};

struct ts_rank_blocks {
	int count[3];		       /* blocks along each dimension; with recursive bisection ranks, 1, 1 */
	struct ts_rank_cut *bisection; /* [ranks - 1]; NULL: it is a grid */
	/* Faces along d, count[d] + 1 of them for each part that is cut along d (0: the box, 1: a slab, 2: a column);
	 * the outer ones are those of the box. */
	double *cut[3];
	double lo[3], length[3]; /* of the box */
	bool periodic[3];
};

static inline int ts_rank_blocks_number(const struct ts_rank_blocks *blocks)
{
	return blocks->count[0] * blocks->count[1] * blocks->count[2];
}

/* A block, or a part of the box, along one dimension: outer faces of dimensions that are not periodic do not limit it. */
struct ts_rank_side {
	double face[2];
	bool open[2];
};

/* A block of the box. */
struct ts_rank_block {
	struct ts_rank_side side[3];
};

/* The numbers of blocks along each dimension, for n ranks: those given (0: free) with the least area of the cuts, each of them
 * area[d] across the dimension d; false: there are none. In two dimensions one along z. */
bool ts_rank_blocks_choose(int n, const int given[3], const double area[3], int dimension, int out[3]);

/* Cuts the box into equal blocks; false: out of memory. */
bool ts_rank_blocks_cut(struct ts_rank_blocks *blocks, const int count[3], const double lo[3],
			const double hi[3], const bool periodic[3]);
/* The same for recursive bisection into n blocks, whose cuts are all in the middle of their parts, along x. */
bool ts_rank_blocks_bisect(struct ts_rank_blocks *blocks, int n, const double lo[3], const double hi[3],
			   const bool periodic[3]);
/* Moves the inner cuts: each part has, as far as equal coordinates allow, the same number of these points for each of its
 * blocks. The order of the points changes; false: out of memory. */
bool ts_rank_blocks_balance(struct ts_rank_blocks *blocks, double (*x)[3], size_t n);
/* The lengths of the space of n > 0 points without so few at each side; false: out of memory. */
bool ts_rank_points_filled(double (*x)[3], size_t n, size_t few, double length[3]);
/* By how much more space the one half of n > 0 points fills than the other one, cut across each dimension: 0, the same, to 1; 0 of
 * so few that it is not known. False: out of memory. */
bool ts_rank_points_unlike(double (*x)[3], size_t n, double unlike[3]);
/* A copy, in place of what `to` was; false: out of memory. */
bool ts_rank_blocks_copy(struct ts_rank_blocks *to, const struct ts_rank_blocks *from);
/* The outer faces follow the box. */
void ts_rank_blocks_fit(struct ts_rank_blocks *blocks, const double lo[3], const double hi[3]);
void ts_rank_blocks_release(struct ts_rank_blocks *blocks);

/* The faces along d of the part that has block k[0..d-1], count[d] + 1 of them; of a grid. */
double *ts_rank_blocks_faces(const struct ts_rank_blocks *blocks, int d, const int k[3]);
/* Block `rank` along d. */
struct ts_rank_side ts_rank_blocks_side(const struct ts_rank_blocks *blocks, int rank, int d);
struct ts_rank_block ts_rank_blocks_block(const struct ts_rank_blocks *blocks, int rank);

/* The block, and so the rank, that has the point. Points outside of the box belong to the nearest block. */
int ts_rank_blocks_owner(const struct ts_rank_blocks *blocks, const double x[3]);

/* Whether the point is within `reach` of block `rank` in dimension d, without periodic images. The outer faces of
 * dimensions that are not periodic do not limit a block. */
bool ts_rank_blocks_near(const struct ts_rank_blocks *blocks, int rank, int d, double x, double reach);
/* Whether the point, or a periodic image of it, is within `reach` of block `rank` in each dimension. */
bool ts_rank_blocks_reach(const struct ts_rank_blocks *blocks, int rank, const double x[3], double reach);
/* Whether the point is in the block, at least `reach` above its lower faces, and more than that below the upper ones: so
 * with reach 0, whether the block has it, if it is in the box. */
static inline bool ts_rank_block_inside(const struct ts_rank_block *block, const double x[3], double reach)
{
	bool inside = true;

	for (int d = 0; d < 3; d++) {
		const struct ts_rank_side *side = &block->side[d];

		inside &= (side->open[0] || x[d] >= side->face[0] + reach) &&
			  (side->open[1] || x[d] < side->face[1] - reach);
	}
	return inside;
}

/* Calls `visit` with each block that the point, or a periodic image of it, is within `reach` of, without looking at all
 * others. */
typedef void ts_rank_visit_fn(void *context, int rank);
void ts_rank_blocks_visit(const struct ts_rank_blocks *blocks, const double x[3], double reach,
			  ts_rank_visit_fn *visit, void *context);

#endif
