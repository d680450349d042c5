/* Vectors of four doubles, and 4 x 4 transposition; compilers map them to the instructions of the
 * processor. */
#ifndef TS_BASE_FOUR_H
#define TS_BASE_FOUR_H

#include <stddef.h>

#include "base/inline.h"

typedef double ts_four __attribute__((vector_size(32)));
typedef double ts_four_anywhere __attribute__((vector_size(32), aligned(8), may_alias));

/* result of a comparison: -1 where true, else 0 */
typedef long long ts_four_marks __attribute__((vector_size(32)));

typedef long long ts_four_marks_anywhere __attribute__((vector_size(32), aligned(8), may_alias));

/* Loads four doubles from any address; of an array [][3] this includes the first number of the next
 * element: columns of particles have room behind their last number. */
#define TS_FOUR_LOAD(from) (*(const ts_four_anywhere *)(from))

#if defined(__clang__) || __GNUC__ >= 12
#define TS_FOUR_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
typedef long long ts_four_places __attribute__((vector_size(32)));
#define TS_FOUR_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, (ts_four_places){ i, j, k, l })
#endif

/* Elementwise maximum: most = max(most, x). By marks, as compilers take conditional expressions apart. */
TS_INLINE void ts_four_max(ts_four *most, const ts_four *x)
{
	const ts_four_marks more = *x > *most;

	*most = (ts_four)(((ts_four_marks)*x & more) | ((ts_four_marks)*most & ~more));
}

#define TS_FOUR_BROADCAST(x) ((ts_four){ x, x, x, x })

/* Elements 0 to 2 of a, element 3 of b. */
#define TS_FOUR_LAST(a, b) TS_FOUR_SHUFFLE(a, b, 0, 1, 2, 7)

/* Transposes a 4 x 4 matrix. */
TS_INLINE void ts_four_transpose(ts_four m[4])
{
	ts_four a = TS_FOUR_SHUFFLE(m[0], m[1], 0, 4, 2, 6), b = TS_FOUR_SHUFFLE(m[0], m[1], 1, 5, 3, 7);
	ts_four c = TS_FOUR_SHUFFLE(m[2], m[3], 0, 4, 2, 6), d = TS_FOUR_SHUFFLE(m[2], m[3], 1, 5, 3, 7);

	m[0] = TS_FOUR_SHUFFLE(a, c, 0, 1, 4, 5);
	m[1] = TS_FOUR_SHUFFLE(b, d, 0, 1, 4, 5);
	m[2] = TS_FOUR_SHUFFLE(a, c, 2, 3, 6, 7);
	m[3] = TS_FOUR_SHUFFLE(b, d, 2, 3, 6, 7);
}

/* Number of elements of a batch in loops over columns. */
enum { TS_BATCH = 64 };

/* Transposes four rows into elements at .. at+3 of four columns, or back. */
TS_INLINE void ts_four_columns(ts_four row[4], double (*column)[TS_BATCH], size_t at)
{
	ts_four_transpose(row);
	for (int c = 0; c < 4; c++)
		*(ts_four *)&column[c][at] = row[c];
}

TS_INLINE void ts_four_rows(const double (*column)[TS_BATCH], size_t at, ts_four row[4])
{
	for (int c = 0; c < 4; c++)
		row[c] = *(const ts_four *)&column[c][at];
	ts_four_transpose(row);
}

/* Stores the first n numbers, n at most 3. */
TS_INLINE void ts_four_store(const ts_four *from, int n, double *to)
{
	for (int c = 0; c < 3 && c < n; c++)
		to[c] = (*from)[c];
}

#endif
