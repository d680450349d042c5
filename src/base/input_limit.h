/* How much an input may be: -input-limit, or TSIM_INPUT_LIMIT in the environment, in GB. */
#ifndef TS_BASE_INPUT_LIMIT_H
#define TS_BASE_INPUT_LIMIT_H

#include <stddef.h>

#define TS_INPUT_LIMIT "TSIM_INPUT_LIMIT"

/* Bytes that a compressed input may unfold to (4 GB). */
double ts_input_limit(void);
/* Bytes that a line of any input may have: a thousandth of it. */
size_t ts_input_longest_line(void);

#endif
