/* Unknown values: those that only a run can give, while a script is read without running
 * (sim->reading.explain), such as the height of a bed. In formulas an unknown value is a NaN, which no
 * known value is; what is computed from it is unknown, too. Substituted into a line it is the number 1,
 * written with leading zeros as no other number is, so that the line can be parsed and the unknown value
 * recognised. */
#ifndef TS_FORMULA_UNKNOWN_H
#define TS_FORMULA_UNKNOWN_H

#include <math.h>

#include "formula/formulas.h"

static inline bool ts_unknown(const struct tsim *sim, double value)
{
	return (sim->reading.explain || sim->reading.dry) && isnan(value);
}

/* Whether the value of that name, which is read now, is unknown. */
bool ts_unknown_read(struct ts_formulas *formulas, const char *name);
/* Whether a value read from the simulation is unknown. If so, an error of its evaluation (*status) is
 * cleared, unless the name or the syntax is wrong. */
bool ts_unknown_value(struct ts_formulas *formulas, const char *name, enum ts_status *status);
/* Appends a number as it is substituted into lines: `format` has one conversion of a double. */
void ts_unknown_add(const struct tsim *sim, struct ts_str *out, const char *format, double value);
/* Whether an unknown value was substituted into the text; if so, it is recorded as read now. */
bool ts_unknown_read_text(struct ts_formulas *formulas, const char *text);
/* The same without the record. */
bool ts_unknown_in_text(const struct tsim *sim, const char *text);
/* Appends the text for users: `what` in place of unknown values. */
void ts_unknown_show(const struct tsim *sim, const char *text, const char *what, struct ts_str *out);
#endif
