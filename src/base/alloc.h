/* Memory allocation; all memory of the program is allocated here.
 *
 * Allocations are counted, so that tests can check that all memory is freed, and the k-th allocation
 * can be made to fail, so that all out-of-memory paths are tested. The counters are the only mutable
 * static data of the library: like those of malloc, they belong to the process. */
#ifndef TS_BASE_ALLOC_H
#define TS_BASE_ALLOC_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Bytes. Blocks of ts_alloc_aligned begin at a multiple of it. */
#define TS_CACHE_LINE 64

/* Zero-initialised memory for n elements of the given size, or NULL. n == 0 gives a valid pointer. */
void *ts_alloc(size_t n, size_t size);
/* The same, aligned to a cache line, and with at least eight readable bytes behind the last element
 * (base/four.h). Also freed by ts_free. */
void *ts_alloc_aligned(size_t n, size_t size);
/* The same, whose bytes are not set: for elements that are written before they are read. */
void *ts_alloc_unset(size_t n, size_t size);
char *ts_strdup(const char *s);
void ts_free(void *p);

/* Enlarges *array (of *capacity elements of `size` bytes) to at least `need` elements, and to twice the old number; long
 * arrays to 1.5 times. Contents are kept, new elements are zero. */
enum ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size);
#define TS_GROW(array, capacity, need) ts_grow((void **)&(array), &(capacity), (need), sizeof *(array))

/* The same for text, whose new bytes are not set: a large text is not copied, and takes only the memory of what has
 * been written to it. */
enum ts_status ts_grow_text(char **text, size_t *capacity, size_t need);

/* As ts_grow, but the contents are lost, and little more memory than needed is allocated. */
enum ts_status ts_renew(void **array, size_t *capacity, size_t need, size_t size);
#define TS_RENEW(array, capacity, need) ts_renew((void **)&(array), &(capacity), (need), sizeof *(array))
/* The same for arrays whose elements are written before they are read: they are not set, so that spare capacity takes
 * no memory and each byte is written once. */
enum ts_status ts_renew_unset(void **array, size_t *capacity, size_t need, size_t size);
#define TS_RENEW_UNSET(array, capacity, need) \
	ts_renew_unset((void **)&(array), &(capacity), (need), sizeof *(array))

/* As ts_alloc_aligned, freed by ts_free_pages. `sparse`: a large block takes the memory of a page when it is first written, and may
 * be larger than the memory of the machine. */
void *ts_alloc_pages(size_t n, size_t size, bool sparse);
void ts_free_pages(void *p);

/* Sets so many bytes of a block to zero. Whole pages are given back to the system, and take no memory until they are
 * written again. */
void ts_alloc_clear(void *p, size_t bytes);

/* For the program, not the library: large blocks are returned to the system when they are freed, which
 * avoids fragmentation. */
void ts_alloc_tune(void);

/* Physical memory of the machine, or the limit of the process if that is smaller, in bytes; not above 0: unknown. */
double ts_alloc_available(void);

/* Gives free memory back to the system, for before large blocks are needed for a short time. */
void ts_alloc_trim(void);

/* For tests: number of blocks that are allocated; let the k-th allocation from now on fail (0: none). */
long ts_alloc_balance(void);
void ts_alloc_fail_at(long k);

/* An arena: many small blocks that are freed together. Zero-initialise before use. */
struct ts_arena {
	struct ts_arena_block *first;
};
void *ts_arena_alloc(struct ts_arena *arena, size_t n, size_t size);
char *ts_arena_strdup(struct ts_arena *arena, const char *s);
void ts_arena_release(struct ts_arena *arena);

#endif
