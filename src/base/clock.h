/* Wall-clock time. */
#ifndef TS_BASE_CLOCK_H
#define TS_BASE_CLOCK_H

#include <stdint.h>

/* Seconds since an arbitrary start; monotonic. */
double ts_clock(void);

/* Counts of a processor clock that is read in a few nanoseconds, where available; its frequency is
 * determined by comparison with ts_clock. */
static inline uint64_t ts_ticks(void)
{
#if defined(__x86_64__)
	return __builtin_ia32_rdtsc();
#elif defined(__aarch64__)
	uint64_t ticks;

	__asm__ volatile("mrs %0, cntvct_el0" : "=r"(ticks));
	return ticks;
#else
	return (uint64_t)(1e9 * ts_clock());
#endif
}

#endif
