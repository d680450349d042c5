/* Values that only a run can give, in a script that is gone through without running (sim->reading.explain): the
 * height of a bed that is not there yet. In formulas such a value is a NaN, which no other value can be,
 * and what is computed from it is another. Put into a line it is a number that is written as no other is:
 * the line can be read, and later ones know. */
#ifndef TS_FORMULA_UNKNOWN_H
#define TS_FORMULA_UNKNOWN_H

#include <math.h>

#include "formula/formulas.h"

static inline bool ts_unknown(const struct tsim *sim, double value)
{
	return (sim->reading.explain || sim->reading.dry) && isnan(value);
}

/* Whether the value of that name, which is read now, is one. */
bool ts_unknown_read(struct ts_formulas *formulas, const char *name);
/* Whether a value of the simulation is one, as ts_unknown_read says: then *status, of its evaluation, is
 * only kept if the name or the words of it are wrong. */
bool ts_unknown_value(struct ts_formulas *formulas, const char *name, enum ts_status *status);
/* The text of a number: `format` has one conversion of a double. */
void ts_unknown_add(const struct tsim *sim, struct ts_str *out, const char *format, double value);
/* Whether some unknown value was put into the text; if so, it is what is read now. */
bool ts_unknown_in(struct ts_formulas *formulas, const char *text);
/* The same without a note of it. */
bool ts_unknown_text(const struct tsim *sim, const char *text);
/* The text for people: `what` where there is an unknown value. */
void ts_unknown_show(const struct tsim *sim, const char *text, const char *what, struct ts_str *out);
#endif
