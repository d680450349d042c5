/* Formats for one number, as users write them: "%.4g", "%08.3f m", "%5.1f%%". */
#ifndef TS_FORMULA_NUMBER_FORMAT_H
#define TS_FORMULA_NUMBER_FORMAT_H

#include "base/status.h"
#include "base/str.h"

/* Exactly one conversion of a number (e, f, g, a capital, or d), so that printf may be trusted with it. */
enum ts_status ts_number_format_check(struct ts_error *error, const char *format,
				      const struct ts_place *place);
/* Writes the number; d rounds it to a whole one. The format has been checked. */
void ts_number_format_add(struct ts_str *out, const char *format, double value);

#endif
