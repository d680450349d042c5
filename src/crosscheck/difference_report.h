/* The report of the differences in one output. */
#ifndef TS_CROSSCHECK_DIFFERENCE_REPORT_H
#define TS_CROSSCHECK_DIFFERENCE_REPORT_H

#include "crosscheck/compare.h"

/* Appends the table of one output. `statistics`: with the columns of the statistics; `peer`: name of the
 * other program. */
void ts_report_pairing(const struct ts_pairing *p, bool statistics, const char *peer, struct ts_str *out);

#endif
