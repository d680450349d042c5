/* Errors as the user reads them: place, message, the script line and a mark below the offending words. */
#ifndef TS_SCRIPT_DIAGNOSTIC_H
#define TS_SCRIPT_DIAGNOSTIC_H

#include "base/status.h"
#include "base/str.h"

void ts_diagnostic(const struct ts_error *error, struct ts_str *out);

#endif
