/* Formats of scripts for one number: "%.4g", "%08.3f m", "%5.1f%%". */
#ifndef TS_FORMULA_NUMBER_FORMAT_H
#define TS_FORMULA_NUMBER_FORMAT_H

#include "base/status.h"
#include "base/str.h"

/* Accepts exactly one conversion of a number (e, f, g, a capital of these, or d), so that printf is safe
 * with it. */
enum ts_status ts_number_format_check(struct ts_error *error, const char *format,
				      const struct ts_place *place);
/* Appends the number; d rounds it to an integer. The format has been checked. */
void ts_number_format_add(struct ts_str *out, const char *format, double value);

#endif
