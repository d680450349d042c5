/* Mutations of scripts by lines and words instead of bytes, for libFuzzer. */
#ifndef TS_FUZZ_TOKENS_H
#define TS_FUZZ_TOKENS_H

#include <stddef.h>
#include <stdint.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t room);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t room, unsigned seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t n_one, const uint8_t *other, size_t n_other,
				 uint8_t *out, size_t room, unsigned seed);

#endif
