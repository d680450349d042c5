/* CRC-32 of bytes, the one of zlib, at the speed of memory where the processor multiplies without carries. */
#ifndef TS_BASE_CRC32_H
#define TS_BASE_CRC32_H

#include <stddef.h>
#include <stdint.h>

/* `sum`: of the bytes before, 0 at the start. */
uint32_t ts_crc32(uint32_t sum, const void *bytes, size_t n);

#endif
