/* Functions that are always inlined: contact laws and parts of hot loops, which the compiler
 * specialises for constant arguments and vectorises. */
#ifndef TS_BASE_INLINE_H
#define TS_BASE_INLINE_H

#if defined(__GNUC__)
#define TS_INLINE static inline __attribute__((always_inline))
#else
#define TS_INLINE static inline
#endif

#endif
