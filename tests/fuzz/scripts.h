/* Bytes taken as a script, by the targets script, check and explain. */
#ifndef TS_FUZZ_SCRIPTS_H
#define TS_FUZZ_SCRIPTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum fuzz_mode { FUZZ_RUN, FUZZ_CHECK, FUZZ_EXPLAIN };

void fuzz_as_script(const uint8_t *data, size_t size, enum fuzz_mode mode);

#endif
