/* Wall time. */
#ifndef TS_BASE_CLOCK_H
#define TS_BASE_CLOCK_H

#include <stdint.h>

/* Seconds of wall time since an arbitrary start; never runs backwards. */
double ts_clock(void);

/* Counts of a clock that is read in a few nanoseconds, where there is one; how many make a second is found by
 * comparing with ts_clock over a while. */
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
