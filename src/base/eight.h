/* Vectors of eight doubles; compilers map them to the instructions of the processor. */
#ifndef TS_BASE_EIGHT_H
#define TS_BASE_EIGHT_H

#include <stdint.h>

#include "base/four.h"

typedef double ts_eight __attribute__((vector_size(64)));
typedef double ts_eight_anywhere __attribute__((vector_size(64), aligned(8), may_alias));
typedef long long ts_eight_marks __attribute__((vector_size(64)));
typedef double ts_two_anywhere __attribute__((vector_size(16), aligned(8), may_alias));

#if defined(__clang__) || __GNUC__ >= 12
#define TS_TWO_JOIN(a, b) __builtin_shufflevector(a, b, 0, 1, 2, 3)
#define TS_FOUR_JOIN(a, b) __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7)
/* the first half of a, and the second of b */
#define TS_EIGHT_HALVES(a, b) __builtin_shufflevector(a, b, 0, 1, 2, 3, 12, 13, 14, 15)
#else
#define TS_EIGHT_HALVES(a, b) ((ts_eight){ (a)[0], (a)[1], (a)[2], (a)[3], (b)[4], (b)[5], (b)[6], (b)[7] })
#define TS_TWO_JOIN(a, b) ((ts_four){ (a)[0], (a)[1], (b)[0], (b)[1] })
#define TS_FOUR_JOIN(a, b) ((ts_eight){ (a)[0], (a)[1], (a)[2], (a)[3], (b)[0], (b)[1], (b)[2], (b)[3] })
#endif

/* Loads eight doubles from any address. */
#define TS_EIGHT_LOAD(from) (*(const ts_eight_anywhere *)(from))

/* The components of four vectors x[row[0]] .. x[row[3]]. Numbers are loaded in twos and joined, which takes fewer
 * shuffles than a transposition of vectors of four. */
TS_INLINE void ts_four_gather(const double (*x)[3], const int32_t *row, ts_four column[3])
{
#define TWO(k, c) (*(const ts_two_anywhere *)&x[row[k]][c])
	ts_four xy[2] = { TS_TWO_JOIN(TWO(0, 0), TWO(2, 0)), TS_TWO_JOIN(TWO(1, 0), TWO(3, 0)) };
	ts_four yz[2] = { TS_TWO_JOIN(TWO(0, 1), TWO(2, 1)), TS_TWO_JOIN(TWO(1, 1), TWO(3, 1)) };
#undef TWO

	column[0] = TS_FOUR_SHUFFLE(xy[0], xy[1], 0, 4, 2, 6);
	column[1] = TS_FOUR_SHUFFLE(xy[0], xy[1], 1, 5, 3, 7);
	column[2] = TS_FOUR_SHUFFLE(yz[0], yz[1], 1, 5, 3, 7);
}

/* The same for eight vectors. */
TS_INLINE void ts_eight_gather(const double (*x)[3], const int32_t *row, ts_eight column[3])
{
	ts_four half[2][3];

	ts_four_gather(x, row, half[0]);
	ts_four_gather(x, row + 4, half[1]);
	for (int c = 0; c < 3; c++)
		column[c] = TS_FOUR_JOIN(half[0][c], half[1][c]);
}

#endif
