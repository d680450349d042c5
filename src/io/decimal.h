/* Conversion of numbers to text, identical to printf with %g and %lld, but several times faster: it takes
 * most of the time of a large dump. */
#ifndef TS_IO_DECIMAL_H
#define TS_IO_DECIMAL_H

#include <stddef.h>

enum { TS_DECIMAL_SIZE = 32 };

/* Writes the number without a terminating zero; returns its length. */
size_t ts_decimal_g(double value, char out[TS_DECIMAL_SIZE]);
size_t ts_decimal_lld(long long value, char out[TS_DECIMAL_SIZE]);

#endif
