/* The one door to the heap.
 *
 * Allocations are counted, so that a test can demand a balance of zero, and can be made to fail at
 * the k-th call, so that every out-of-memory path is run. The counters are the only mutable static
 * data of the library: like malloc's own, they belong to the process. */
#ifndef TS_BASE_ALLOC_H
#define TS_BASE_ALLOC_H

#include <stddef.h>

#include "base/status.h"

/* Zeroed memory for n elements of the given size, or NULL. n == 0 gives a valid pointer. */
void *ts_alloc(size_t n, size_t size);
/* The same, aligned to a cache line, and with at least eight bytes behind the last element, which may be read
 * (base/four.h). Release with ts_free as well. */
void *ts_alloc_aligned(size_t n, size_t size);
char *ts_strdup(const char *s);
void ts_free(void *p);

/* Makes room for `need` elements in *array (of *capacity elements of `size` bytes), at least
 * doubling it. Old contents are kept, new elements are zero. */
enum ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size);
#define TS_GROW(array, capacity, need) ts_grow((void **)&(array), &(capacity), (need), sizeof *(array))

/* The same where the old contents are not needed: they are lost, and there is little more room than asked
 * for. */
enum ts_status ts_renew(void **array, size_t *capacity, size_t need, size_t size);
#define TS_RENEW(array, capacity, need) ts_renew((void **)&(array), &(capacity), (need), sizeof *(array))

/* For a program that is tsim alone: large blocks go back to the system when they are freed, and leave no
 * holes. */
void ts_alloc_tune(void);

/* For tests. Blocks now allocated and not freed; let the k-th allocation from now fail (0: never). */
long ts_alloc_balance(void);
void ts_alloc_fail_at(long k);

/* An arena: many small pieces, freed together. Zero-initialise before use. */
struct ts_arena {
	struct ts_arena_block *first;
};
void *ts_arena_alloc(struct ts_arena *arena, size_t n, size_t size);
char *ts_arena_strdup(struct ts_arena *arena, const char *s);
void ts_arena_release(struct ts_arena *arena);

#endif
