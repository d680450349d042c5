#include "formula/unknown.h"

#include <stdio.h>
#include <string.h>

#include "formula/number_format.h"

#include "base/banned.h"

/* Text of an unknown value in a line; it parses as the number 1. */
static const char mark[] = "00000000000000001";

bool ts_unknown_read(struct ts_formulas *formulas, const char *name)
{
	return ts_sim_awaits_run(formulas->sim, name);
}

bool ts_unknown_value(struct ts_formulas *formulas, const char *name, enum ts_status *status)
{
	if (*status == TS_NOMEM || *status == TS_STOPPED || *status == TS_UNKNOWN || *status == TS_SYNTAX ||
	    !ts_unknown_read(formulas, name))
		return false;
	if (*status != TS_OK)
		ts_error_clear(&formulas->sim->error);
	*status = TS_OK;
	return true;
}

void ts_unknown_add(const struct tsim *sim, struct ts_str *out, const char *format, double value)
{
	if (ts_unknown(sim, value))
		ts_str_add(out, mark);
	else
		ts_number_format_add(out, format, value);
}

bool ts_unknown_in_text(const struct tsim *sim, const char *text)
{
	return (sim->reading.dry || (sim->reading.explain && sim->reading.planned)) && strstr(text, mark);
}

bool ts_unknown_read_text(struct ts_formulas *formulas, const char *text)
{
	struct tsim *sim = formulas->sim;

	if (!ts_unknown_in_text(sim, text))
		return false;
	ts_sim_awaits_run(sim, formulas->unknown ? formulas->unknown : "a value");
	return true;
}

void ts_unknown_show(const struct tsim *sim, const char *text, const char *what, struct ts_str *out)
{
	const char *at;

	while (ts_unknown_in_text(sim, text)) {
		at = strstr(text, mark);
		ts_str_add_n(out, text, (size_t)(at - text));
		ts_str_add(out, what);
		text = at + sizeof mark - 1;
	}
	ts_str_add(out, text);
}
