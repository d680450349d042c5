/* Formats for numbers given by users: checked before they reach printf. */
#ifndef TS_IO_FORMAT_H
#define TS_IO_FORMAT_H

#include <stdbool.h>

#include "base/str.h"

enum { TS_FORMAT_SIZE = 32 };

/* "%14.8g" or, for integers, "%8d": text with exactly one conversion of that kind. Integers are
 * turned into the conversion of a long long. false: not such a format. */
bool ts_format_check(const char *format, bool integer, char out[TS_FORMAT_SIZE]);
/* Adds the number; `format` comes from ts_format_check. */
void ts_format_add(struct ts_str *out, const char *format, bool integer, double value);

#endif
