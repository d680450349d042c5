#include "base/quotes.h"

#include <string.h>

#include "base/banned.h"

struct ts_place ts_place_inside(const struct ts_place *whole, size_t length, size_t at, size_t n)
{
	struct ts_place place = *whole;
	long quotes = (long)place.length - (long)length; /* 2 if quoted, 6 if in triple quotes */

	if (!place.column || (quotes != 0 && quotes != 2 && quotes != 6) || at > length)
		return place;
	place.column += (int)(quotes / 2) + (int)at;
	place.length = n ? (int)n : 1;
	return place;
}

size_t ts_quote_end(const char *text, size_t at)
{
	const char *end;

	if (strncmp(text + at, "\"\"\"", 3) == 0) {
		end = strstr(text + at + 3, "\"\"\"");
		return end ? (size_t)(end - text) + 3 : at;
	}
	if (text[at] != '"' && text[at] != '\'')
		return at;
	end = strchr(text + at + 1, text[at]);
	return end ? (size_t)(end - text) + 1 : at;
}
