#include "formula/number_format.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum { WIDEST = 3 /* digits of a width or precision */ };

/* The letter of the conversion that begins behind a %, or NULL; *end is the position behind it, or the end of the text. */
static const char *find_conversion(const char *text, const char **end)
{
	const char *c = text + strspn(text, "-+ 0#");
	size_t width = strspn(c, "0123456789"), precision = 0;

	c += width;
	if (*c == '.') {
		precision = strspn(c + 1, "0123456789");
		c += 1 + precision;
	}
	*end = *c ? c + 1 : c; /* the text may end before the letter */
	return *c && strchr("eEfFgGd", *c) && width <= WIDEST && precision <= WIDEST ? c : NULL;
}

enum ts_status ts_number_format_check(struct ts_error *error, const char *format,
				      const struct ts_place *place)
{
	bool good = true;
	int found = 0;

	for (const char *c = strchr(format, '%'); c && good; c = strchr(c, '%')) {
		if (c[1] == '%') {
			c += 2;
			continue;
		}
		good = find_conversion(c + 1, &c) != NULL;
		found++;
	}
	if (good && found == 1)
		return TS_OK;
	return ts_fail(error, TS_SYNTAX, place,
		       "expected a format for one number, such as %%.4f or %%g, found '%s'", format);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
static void append_real(struct ts_str *out, const char *format, double value)
{
	ts_str_addf(out, format, value);
}
#pragma GCC diagnostic pop

void ts_number_format_add(struct ts_str *out, const char *format, double value)
{
	const char *c = format, *letter = NULL, *percent = format, *end;
	struct ts_str whole = { 0 };

	for (c = strchr(c, '%'); c && !letter; c = strchr(c, '%')) {
		if (c[1] == '%')
			c += 2;
		else
			letter = find_conversion((percent = c) + 1, &c);
	}
	if (!letter || *letter != 'd') {
		append_real(out, format, value);
		return;
	}
	/* %.0f prints an integer like %d, and has no overflow for large values; width and flags stay */
	end = memchr(percent, '.', (size_t)(letter - percent));
	ts_str_add_n(&whole, format, (size_t)((end ? end : letter) - format));
	ts_str_addf(&whole, ".0f%s", letter + 1);
	if (whole.failed)
		out->failed = true;
	else
		append_real(out, whole.text, round(value) + 0.0);
	ts_str_release(&whole);
}
