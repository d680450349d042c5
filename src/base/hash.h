/* A 64-bit hash of bytes to detect changes of state; not cryptographic. */
#ifndef TS_BASE_HASH_H
#define TS_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

struct ts_hash {
	uint64_t state;
};

struct ts_hash ts_hash_start(void);
void ts_hash_add(struct ts_hash *hash, const void *bytes, size_t n);
void ts_hash_text(struct ts_hash *hash, const char *text);
uint64_t ts_hash_value(const struct ts_hash *hash);
/* The sum, modulo 2^64, of hashes of n rows of so many bytes, each with the number key[i]: it does not depend on their order. */
uint64_t ts_hash_rows(const struct ts_hash *hash, const int32_t *key, const void *rows, size_t bytes,
		      size_t n);

#endif
