/* Disjoint sets of 0..n-1 (B. A. Galler, M. J. Fischer, Commun. ACM 7 (1964) 301) with path halving.
 * The root of a set is its member with the smallest key, independent of the order of unions. */
#ifndef TS_MATH_UNIONFIND_H
#define TS_MATH_UNIONFIND_H

#include <stddef.h>
#include <stdint.h>

static inline void ts_sets_start(int32_t *parent, size_t n)
{
	for (size_t i = 0; i < n; i++)
		parent[i] = (int32_t)i;
}

static inline size_t ts_sets_root(int32_t *parent, size_t i)
{
	while (parent[i] != (int32_t)i) {
		parent[i] = parent[parent[i]];
		i = (size_t)parent[i];
	}
	return i;
}

static inline void ts_sets_join(int32_t *parent, const int32_t *key, size_t i, size_t j)
{
	size_t a = ts_sets_root(parent, i), b = ts_sets_root(parent, j);

	if (key[a] < key[b])
		parent[b] = (int32_t)a;
	else
		parent[a] = (int32_t)b;
}

#endif
