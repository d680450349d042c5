/* Conversion of numbers to text, identical to printf but several times faster: it takes most of the time of a
 * large dump. */
#ifndef TS_IO_DECIMAL_H
#define TS_IO_DECIMAL_H

#include <stddef.h>

enum { TS_DECIMAL_DIGITS = 17, TS_DECIMAL_SIZE = 32 };

/* Writes the number as %.*g does, with 1 to TS_DECIMAL_DIGITS significant digits, or as %lld. Without a terminating
 * zero; returns the length. */
size_t ts_decimal_g(double value, int digits, char out[TS_DECIMAL_SIZE]);
size_t ts_decimal_lld(long long value, char out[TS_DECIMAL_SIZE]);
/* The shortest of %.15g, %.16g and %.17g that is read back to the same bits. */
size_t ts_decimal_shortest(double value, char out[TS_DECIMAL_SIZE]);

#endif
