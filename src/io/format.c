#include "io/format.h"

#include <stdio.h>
#include <string.h>

#include "base/banned.h"

bool ts_format_check(const char *format, bool integer, char out[TS_FORMAT_SIZE])
{
	const char *percent = strchr(format, '%');
	size_t head, n;
	int wrote;
	char kind;

	if (!percent)
		return false;
	head = (size_t)(percent - format) + 1;
	head += strspn(format + head, "-+ #0");
	n = strspn(format + head, "0123456789");
	head += n;
	if (n > 3)
		return false;
	if (format[head] == '.') {
		n = strspn(format + head + 1, "0123456789");
		head += n + 1;
		if (n > 3)
			return false;
	}
	n = integer ? strspn(format + head, "lh") : 0;
	kind = format[head + n];
	if (!kind || !strchr(integer ? "di" : "eEfFgG", kind) || strchr(format + head + n, '%'))
		return false;
	wrote = snprintf(out, TS_FORMAT_SIZE, "%.*s%s%c%s", (int)head, format, integer ? "ll" : "",
			 kind, format + head + n + 1);
	return wrote > 0 && wrote < TS_FORMAT_SIZE;
}

#pragma GCC diagnostic ignored "-Wformat-nonliteral"
void ts_format_add(struct ts_str *out, const char *format, bool integer, double value)
{
	if (integer)
		ts_str_addf(out, format, (long long)value);
	else
		ts_str_addf(out, format, value);
}
