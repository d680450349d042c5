/* Text of the page. */
#include <math.h>
#include <string.h>

#include "report/page.h"

#include "base/banned.h"

/* A sequence of UTF-8 that begins here: its length, 0: it is none (RFC 3629). */
static size_t sequence(const unsigned char *c, size_t n)
{
	const size_t length = c[0] >= 0xc2 && c[0] < 0xe0   ? 2
			      : (c[0] & 0xf0) == 0xe0	    ? 3
			      : c[0] >= 0xf0 && c[0] < 0xf5 ? 4
							    : 0;

	if (!length || length > n)
		return 0;
	for (size_t k = 1; k < length; k++)
		if ((c[k] & 0xc0) != 0x80)
			return 0;
	if ((c[0] == 0xe0 && c[1] < 0xa0) || (c[0] == 0xed && c[1] >= 0xa0) ||
	    (c[0] == 0xf0 && c[1] < 0x90) || (c[0] == 0xf4 && c[1] >= 0x90))
		return 0;
	return length;
}

static const char *entity(unsigned char c)
{
	switch (c) {
	case '<':
		return "&lt;";
	case '>':
		return "&gt;";
	case '&':
		return "&amp;";
	case '"':
		return "&quot;";
	default:
		return NULL;
	}
}

void ts_page_text_n(struct ts_str *out, const char *text, size_t n)
{
	const unsigned char *c = (const unsigned char *)text;

	for (size_t k = 0; k < n;) {
		const char *name = entity(c[k]);
		const size_t length = c[k] < 0x80 ? 0 : sequence(c + k, n - k);

		if (name)
			ts_str_add(out, name);
		else if (length)
			ts_str_add_n(out, text + k, length);
		else if (c[k] >= 0x80 || c[k] == 0x7f || (c[k] < 0x20 && !strchr("\t\n", (int)c[k])))
			ts_str_add(out, "?");
		else
			ts_str_add_n(out, text + k, 1);
		k += length ? length : 1;
	}
}

void ts_page_text(struct ts_str *out, const char *text)
{
	ts_page_text_n(out, text, strlen(text));
}

void ts_page_section(struct ts_str *out, const char *id, const char *title)
{
	ts_str_addf(out, "<section id=\"%s\">\n<h2>%s</h2>\n", id, title);
}

void ts_page_end_section(struct ts_str *out)
{
	ts_str_add(out, "</section>\n");
}

void ts_page_number(struct ts_str *out, double value)
{
	if (isfinite(value))
		ts_str_addf(out, "%.6g", value);
	else
		ts_str_add(out, "-");
}

void ts_page_duration(struct ts_str *out, double seconds)
{
	const double minutes = floor(seconds / 60), hours = floor(seconds / 3600);

	if (seconds < 1)
		ts_str_addf(out, "%.0f ms", 1000 * seconds);
	else if (seconds < 60)
		ts_str_addf(out, "%.1f s", seconds);
	else if (seconds < 3600)
		ts_str_addf(out, "%.0f min %.0f s", minutes, floor(seconds - 60 * minutes));
	else
		ts_str_addf(out, "%.0f h %.0f min", hours, floor(minutes - 60 * hours));
}

const char *ts_page_time_unit(const struct tsim *sim)
{
	static const char *const unit[] = {
		[TS_UNITS_LJ] = NULL, [TS_UNITS_SI] = "s", [TS_UNITS_CGS] = "s", [TS_UNITS_MICRO] = "µs"
	};

	return unit[sim->units];
}
