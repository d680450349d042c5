#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"

#include "base/banned.h"

/* Shortens a message that does not fit: long words, which come from the input, are cut to their first
 * part. */
static void copy_shortened(char *to, size_t size, const char *from)
{
	enum { LONGEST = 200, KEPT = 60 };
	size_t n = 0;

	while (*from && n + KEPT + 4 < size) {
		size_t length = strcspn(from, " \n"), kept = length > LONGEST ? KEPT : length;

		if (n + kept + 4 >= size)
			break;
		memcpy(to + n, from, kept);
		n += kept;
		from += length;
		if (kept < length) {
			memcpy(to + n, "...", 3);
			n += 3;
			if (from[-1] == '\'')
				to[n++] = '\'';
		}
		if (*from)
			to[n++] = *from++;
	}
	to[n] = '\0';
}

enum ts_status ts_vfail_at(struct ts_error *err, enum ts_status code, const struct ts_place *place,
			   const char *source, int source_line, const char *format, va_list args)
{
	va_list again;
	char *whole;
	int n;

	if (err->status != TS_OK)
		return code;
	err->status = code;
	err->place = place ? *place : (struct ts_place){ 0 };
	err->source = source;
	err->source_line = source_line;
	va_copy(again, args);
	n = vsnprintf(err->message, sizeof err->message, format, args);
	whole = n < (int)sizeof err->message ? NULL : ts_alloc((size_t)n + 1, 1);
	if (whole) {
		vsnprintf(whole, (size_t)n + 1, format, again);
		copy_shortened(err->message, sizeof err->message, whole);
		ts_free(whole);
	}
	va_end(again);
	return code;
}

enum ts_status ts_fail_at(struct ts_error *err, enum ts_status code, const struct ts_place *place,
			  const char *source, int source_line, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	ts_vfail_at(err, code, place, source, source_line, format, args);
	va_end(args);
	return code;
}

enum ts_status ts_missing_at(struct ts_error *err, const char *kind, const char *name,
			     const struct ts_place *place, const char *source, int source_line,
			     const char *format, ...)
{
	va_list args;

	if (err->status == TS_OK)
		snprintf(err->missing, sizeof err->missing, "%s %s", kind, name);
	va_start(args, format);
	ts_vfail_at(err, TS_UNKNOWN, place, source, source_line, format, args);
	va_end(args);
	return TS_UNKNOWN;
}

enum ts_status ts_conflict_at(struct ts_error *err, const struct ts_place *place, const char *source,
			      int source_line, const char *format, ...)
{
	va_list args;

	err->conflict |= err->status == TS_OK;
	va_start(args, format);
	ts_vfail_at(err, TS_STATE, place, source, source_line, format, args);
	va_end(args);
	return TS_STATE;
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
