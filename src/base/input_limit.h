/* Limit of input sizes: -input-limit, or the environment variable TSIM_INPUT_LIMIT, in GB. */
#ifndef TS_BASE_INPUT_LIMIT_H
#define TS_BASE_INPUT_LIMIT_H

#include <stddef.h>

#define TS_INPUT_LIMIT "TSIM_INPUT_LIMIT"

/* Largest size of a decompressed input, bytes (default 4 GB). */
double ts_input_limit(void);
/* Largest length of an input line, bytes: a thousandth of it. */
size_t ts_input_longest_line(void);

#endif
