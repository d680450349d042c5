#include "base/alloc.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/banned.h"

enum { PAGE = 4096, LARGE_PAGE = 2 << 20, LARGE = 3 << 19 };
/* Blocks of MAPPED bytes and more are mapped outside of the heap: below LARGE they would be mapped and returned page by page
 * in each build of the neighbor lists. So is free memory at the end of the heap beyond KEPT_FREE, by default MAPPED / 8. */
enum { MAPPED = LARGE, KEPT_FREE = 4 << 20 };

static atomic_long live_blocks;
static atomic_long fail_countdown;

static int must_fail(void)
{
	if (atomic_load_explicit(&fail_countdown, memory_order_relaxed) <= 0)
		return 0;
	return atomic_fetch_sub(&fail_countdown, 1) == 1;
}

/* A block that nearly fills its last large page is enlarged to fill it. */
static size_t round_up_to_page(size_t bytes)
{
	size_t rest = bytes % LARGE_PAGE;

	return rest >= LARGE && bytes <= SIZE_MAX - LARGE_PAGE ? bytes + (LARGE_PAGE - rest) : bytes;
}

/* Large pages reduce address translation misses for the random access to particle columns. */
static void request_large_pages(void *p, size_t bytes)
{
#ifdef MADV_HUGEPAGE
	if (p && bytes >= LARGE)
		(void)madvise(p, bytes, MADV_HUGEPAGE);
#else
	(void)p, (void)bytes;
#endif
}

void ts_alloc_tune(void)
{
#ifdef M_MMAP_THRESHOLD
	(void)mallopt(M_MMAP_THRESHOLD, MAPPED);
	(void)mallopt(M_TRIM_THRESHOLD, KEPT_FREE);
#endif
}

double ts_alloc_available(void)
{
	double all = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
	struct rlimit limit;

	if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
	    (double)limit.rlim_cur < all)
		all = (double)limit.rlim_cur;
	return all;
}

void ts_alloc_trim(void)
{
#ifdef __GLIBC__
	(void)malloc_trim(0);
#endif
}

static bool countable(size_t n, size_t size)
{
	return !must_fail() && !(size && n > (SIZE_MAX - TS_CACHE_LINE) / size);
}

void *ts_alloc(size_t n, size_t size)
{
	void *p = countable(n, size) ? calloc(n && size ? n * size : 1, 1) : NULL;

	if (p)
		atomic_fetch_add_explicit(&live_blocks, 1, memory_order_relaxed);
	return p;
}

/* Blocks have no header, so aligned blocks can be freed like any other. *bytes: the size of the block. */
static void *allocate_aligned(size_t n, size_t size, size_t *bytes)
{
	void *p;

	if (!countable(n, size))
		return NULL;
	/* see ts_alloc_aligned */
	*bytes = round_up_to_page(((n && size ? n * size : 1) / TS_CACHE_LINE + 1) * TS_CACHE_LINE);
	/* if the heap cannot grow, a mapped block may still be possible */
	if (posix_memalign(&p, *bytes >= LARGE ? LARGE_PAGE : TS_CACHE_LINE, *bytes) != 0 &&
	    (*bytes > MAPPED || posix_memalign(&p, TS_CACHE_LINE, MAPPED) != 0))
		return NULL;
	request_large_pages(p, *bytes);
	atomic_fetch_add_explicit(&live_blocks, 1, memory_order_relaxed);
	return p;
}

void *ts_alloc_aligned(size_t n, size_t size)
{
	size_t bytes;
	void *p = allocate_aligned(n, size, &bytes);

	if (p)
		memset(p, 0, bytes);
	return p;
}

void *ts_alloc_unset(size_t n, size_t size)
{
	size_t bytes;

	return allocate_aligned(n, size, &bytes);
}

/* Before each block of ts_alloc_pages, at the beginning of a cache line. */
union pages_header {
	size_t mapped; /* bytes of the mapping; 0: memory of ts_alloc_aligned */
	char line[TS_CACHE_LINE];
};

static void *map_sparse(size_t bytes)
{
	void *p = must_fail() ? MAP_FAILED
			      : mmap(NULL, bytes, PROT_READ | PROT_WRITE,
				     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);

	if (p == MAP_FAILED)
		return NULL;
#ifdef MADV_NOHUGEPAGE
	(void)madvise(p, bytes, MADV_NOHUGEPAGE);
#endif
	atomic_fetch_add_explicit(&live_blocks, 1, memory_order_relaxed);
	return p;
}

void *ts_alloc_pages(size_t n, size_t size, bool sparse)
{
	union pages_header *header;
	size_t bytes;

	if (size && n > (SIZE_MAX - 2 * TS_CACHE_LINE) / size)
		return NULL;
	bytes = n * size + sizeof *header;
	sparse = sparse && bytes >= MAPPED;
	header = sparse ? map_sparse(bytes) : ts_alloc_aligned(bytes, 1);
	if (!header)
		return NULL;
	header->mapped = sparse ? bytes : 0;
	return header + 1;
}

void ts_free_pages(void *p)
{
	union pages_header *header = p ? (union pages_header *)p - 1 : NULL;

	if (!header || !header->mapped) {
		ts_free(header);
		return;
	}
	atomic_fetch_sub_explicit(&live_blocks, 1, memory_order_relaxed);
	(void)munmap(header, header->mapped);
}

char *ts_strdup(const char *s)
{
	size_t n = strlen(s) + 1;
	char *copy = ts_alloc(n, 1);

	if (copy)
		memcpy(copy, s, n);
	return copy;
}

void ts_free(void *p)
{
	if (!p)
		return;
	atomic_fetch_sub_explicit(&live_blocks, 1, memory_order_relaxed);
	free(p);
}

/* Short arrays are doubled, long ones, of at least PATIENT elements, grow by a half: spare elements are zeroed and so take
 * memory. It does not depend on the size of elements, since arrays that grow together may have one capacity. */
enum { PATIENT = 1 << 14 };

enum ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size)
{
	size_t bigger = *capacity < PATIENT ? *capacity * 2 : *capacity + *capacity / 2;
	void *p;

	if (need <= *capacity)
		return TS_OK;
	bigger = bigger > need ? bigger : need;
	if (bigger < 8)
		bigger = 8;
	p = ts_alloc_aligned(bigger, size);
	if (!p)
		return TS_NOMEM;
	if (*capacity)
		memcpy(p, *array, *capacity * size);
	ts_free(*array);
	*array = p;
	*capacity = bigger;
	return TS_OK;
}

enum ts_status ts_grow_text(char **text, size_t *capacity, size_t need)
{
	size_t bigger = *capacity * 2 > need ? *capacity * 2 : need;
	char *p;

	if (need <= *capacity)
		return TS_OK;
	p = must_fail() ? NULL : realloc(*text, bigger);
	if (!p)
		return TS_NOMEM;
	if (!*text)
		atomic_fetch_add_explicit(&live_blocks, 1, memory_order_relaxed);
	*text = p;
	*capacity = bigger;
	return TS_OK;
}

/* *bytes: the size of a new block, 0: the old one is large enough. */
static enum ts_status renew(void **array, size_t *capacity, size_t need, size_t size, size_t *bytes)
{
	size_t bigger = need + need / 16 + 8;

	*bytes = 0;
	if (need <= *capacity)
		return TS_OK;
	ts_free(*array);
	*capacity = 0;
	*array = allocate_aligned(bigger, size, bytes);
	if (!*array)
		return TS_NOMEM;
	*capacity = bigger;
	return TS_OK;
}

enum ts_status ts_renew(void **array, size_t *capacity, size_t need, size_t size)
{
	size_t bytes;

	TS_TRY(renew(array, capacity, need, size, &bytes));
	if (bytes)
		memset(*array, 0, bytes);
	return TS_OK;
}

enum ts_status ts_renew_unset(void **array, size_t *capacity, size_t need, size_t size)
{
	size_t bytes;

	return renew(array, capacity, need, size, &bytes);
}

void ts_alloc_clear(void *p, size_t bytes)
{
#ifdef MADV_DONTNEED
	uintptr_t begin = (uintptr_t)p, end = begin + bytes, from = (begin + PAGE - 1) / PAGE * PAGE,
		  to = end / PAGE * PAGE;

	/* fails on systems with larger pages, and then changes nothing */
	if (to > from && madvise((char *)p + (from - begin), to - from, MADV_DONTNEED) == 0) {
		memset(p, 0, from - begin);
		memset((char *)p + (to - begin), 0, end - to);
		return;
	}
#endif
	if (bytes)
		memset(p, 0, bytes);
}

long ts_alloc_balance(void)
{
	return atomic_load(&live_blocks);
}

void ts_alloc_fail_at(long k)
{
	atomic_store(&fail_countdown, k);
}

struct ts_arena_block {
	struct ts_arena_block *next;
	max_align_t data[];
};

void *ts_arena_alloc(struct ts_arena *arena, size_t n, size_t size)
{
	struct ts_arena_block *block;

	if (size && n > (SIZE_MAX - sizeof *block) / size)
		return NULL;
	block = ts_alloc(1, sizeof *block + n * size);
	if (!block)
		return NULL;
	block->next = arena->first;
	arena->first = block;
	return block->data;
}

char *ts_arena_strdup(struct ts_arena *arena, const char *s)
{
	size_t n = strlen(s) + 1;
	char *copy = ts_arena_alloc(arena, n, 1);

	if (copy)
		memcpy(copy, s, n);
	return copy;
}

void ts_arena_release(struct ts_arena *arena)
{
	while (arena->first) {
		struct ts_arena_block *block = arena->first;

		arena->first = block->next;
		ts_free(block);
	}
}
