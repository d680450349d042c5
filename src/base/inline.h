/* Functions that are inlined always: laws and steps of hot loops, of which the compiler is to keep only
 * what a constant argument leaves, and which it is to compute for several elements at once. */
#ifndef TS_BASE_INLINE_H
#define TS_BASE_INLINE_H

#if defined(__GNUC__)
#define TS_INLINE static inline __attribute__((always_inline))
#else
#define TS_INLINE static inline
#endif

#endif
