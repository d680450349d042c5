/* Numbers as text, as printf writes them with %g and %lld, but several times faster: most of the time of a
 * large dump goes into that. */
#ifndef TS_IO_DECIMAL_H
#define TS_IO_DECIMAL_H

#include <stddef.h>

enum { TS_DECIMAL_SIZE = 32 };

/* Writes the number, and no end of the text; return its length. */
size_t ts_decimal_g(double value, char out[TS_DECIMAL_SIZE]);
size_t ts_decimal_lld(long long value, char out[TS_DECIMAL_SIZE]);

#endif
