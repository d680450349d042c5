#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/banned.h"

enum ts_status ts_fail_at(struct ts_error *err, enum ts_status code, const struct ts_place *place,
			  const char *source, int source_line, const char *format, ...)
{
	va_list args;

	if (err->status != TS_OK)
		return code;
	err->status = code;
	err->place = place ? *place : (struct ts_place){ 0 };
	err->source = source;
	err->source_line = source_line;
	va_start(args, format);
	vsnprintf(err->message, sizeof err->message, format, args);
	va_end(args);
	return code;
}

void ts_error_clear(struct ts_error *err)
{
	*err = (struct ts_error){ 0 };
}

const char *ts_status_text(enum ts_status status)
{
#define TS_STATUS_TEXT(name, text) [TS_##name] = text,
	static const char *const texts[TS_NSTATUS] = { TS_STATUS_LIST(TS_STATUS_TEXT) };
#undef TS_STATUS_TEXT
	return status < TS_NSTATUS ? texts[status] : "unknown status";
}
