/* Functions that are always inlined: contact laws and parts of hot loops, which the compiler
 * specialises for constant arguments and vectorises. Without optimisation nothing would be specialised: each is then compiled
 * once instead of once for each use, which takes a tenth of the time in the files with many variants. */
#ifndef TS_BASE_INLINE_H
#define TS_BASE_INLINE_H

#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define TS_INLINE static inline __attribute__((always_inline))
#else
#define TS_INLINE static inline
#endif

#endif
