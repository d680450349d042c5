/* The parts of a manual page about arguments. */
#ifndef TS_MANUAL_HELP_ARGUMENTS_H
#define TS_MANUAL_HELP_ARGUMENTS_H

#include <stdbool.h>

#include "base/str.h"
#include "core/style.h"

/* The line of a script, with the arguments that everybody needs. */
void ts_help_syntax(const struct ts_style *style, bool markdown, struct ts_str *out);
/* These arguments one by one, and the others in their groups. */
void ts_help_arguments(const struct ts_style *style, bool markdown, struct ts_str *out);
void ts_help_further_arguments(const struct ts_style *style, bool markdown, struct ts_str *out);
/* The arguments of a line of coefficients. */
void ts_help_coefficients(const struct ts_style *style, bool markdown, struct ts_str *out);

#endif
