#include "script/diagnostic.h"

#include <string.h>

#include "base/banned.h"

/* Blanks as wide as the first n bytes of the line: tabs remain tabs, continuation bytes of UTF-8 have no
 * width. */
static void append_indent(struct ts_str *out, const char *text, int n)
{
	for (int k = 0; k < n && text[k]; k++) {
		if (text[k] == '\t')
			ts_str_add(out, "\t");
		else if (((unsigned char)text[k] & 0xc0) != 0x80)
			ts_str_add(out, " ");
	}
}

static void append_mark(struct ts_str *out, const char *text, const struct ts_place *place)
{
	int length = place->length > 0 ? place->length : 1;

	ts_str_add(out, "  ");
	append_indent(out, text, place->column - 1);
	ts_str_add(out, "^");
	for (int k = 1; k < length; k++)
		if (((unsigned char)text[place->column - 1 + k] & 0xc0) != 0x80)
			ts_str_add(out, "~");
	ts_str_add(out, "\n");
}

/* Of a long line only the part around the place is shown; the place is made relative to it. */
static void shorten_line(struct ts_place *place, struct ts_str *part)
{
	enum { WIDTH = 200, BEFORE = 80 };
	size_t width = strlen(place->text), first, n;

	if (width <= WIDTH)
		return;
	first = place->column > BEFORE ? (size_t)(place->column - BEFORE) : 0;
	n = width - first < WIDTH ? width - first : WIDTH;
	ts_str_add(part, first ? "..." : "");
	ts_str_add_n(part, place->text + first, n);
	ts_str_add(part, first + n < width ? "..." : "");
	if (part->failed)
		return;
	if (place->column)
		place->column += (first ? 3 : 0) - (int)first;
	if (place->column + place->length > (int)part->length)
		place->length = (int)part->length - place->column + 1;
	place->text = part->text;
}

void ts_diagnostic(const struct ts_error *error, struct ts_str *out)
{
	struct ts_place place = error->place;
	struct ts_str part = { 0 };
	size_t width;

	if (place.line && place.column)
		ts_str_addf(out, "%s:%d:%d: ", place.file, place.line, place.column);
	else if (place.line)
		ts_str_addf(out, "%s:%d: ", place.file, place.line);
	else if (place.file)
		ts_str_addf(out, "%s: ", place.file);
	ts_str_addf(out, "error: %s\n", error->message);
	if (!place.line || !place.text || !place.text[0])
		return;
	shorten_line(&place, &part);
	width = strlen(place.text);
	ts_str_addf(out, "  %s\n", place.text);
	if (place.column > 0 && (size_t)(place.column + place.length) <= width + 2)
		append_mark(out, place.text, &place);
	ts_str_release(&part);
}
