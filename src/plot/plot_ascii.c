#include "plot/plot_ascii.h"

#include <string.h>

#include "base/banned.h"

struct ts_plot_ascii ts_plot_ascii_next(const char **text, const char *stop)
{
	static const struct {
		const char *sign;
		struct ts_plot_ascii letter;
	} list[] = {
		{ "\u2212", { '-', false } }, { "\u00b7", { '.', true } },  { "\u00b5", { 'u', false } },
		{ "\u03bc", { 'u', false } }, { "\u00b0", { 'o', true } },  { "\u2070", { '0', true } },
		{ "\u00b9", { '1', true } },  { "\u00b2", { '2', true } },  { "\u00b3", { '3', true } },
		{ "\u2074", { '4', true } },  { "\u2075", { '5', true } },  { "\u2076", { '6', true } },
		{ "\u2077", { '7', true } },  { "\u2078", { '8', true } },  { "\u2079", { '9', true } },
		{ "\u207b", { '-', true } },  { "\u2013", { '-', false } }, { "\u00d7", { 'x', false } },
	};
	const size_t left = (size_t)(stop - *text);
	struct ts_plot_ascii out = { **text, false };

	for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
		const size_t n = strlen(list[k].sign);

		if (n <= left && !memcmp(*text, list[k].sign, n)) {
			*text += n;
			return list[k].letter;
		}
	}
	++*text;
	if ((unsigned char)out.shown >= 0x80) {
		out.shown = '?';
		while (*text < stop && ((unsigned char)**text & 0xc0) == 0x80)
			++*text;
	}
	return out;
}

void ts_plot_ascii_add(const char *text, size_t bytes, struct ts_str *out)
{
	const char *stop = text + bytes;
	bool raised = false;

	while (text < stop) {
		const struct ts_plot_ascii letter = ts_plot_ascii_next(&text, stop);
		const char shown[2] = { letter.raised && letter.shown == '.' ? '*' : letter.shown, '\0' };

		if (letter.raised && !raised && letter.shown != '.')
			ts_str_add(out, "^");
		raised = letter.raised && letter.shown != '.';
		ts_str_add(out, (unsigned char)*shown < ' ' ? "?" : shown);
	}
}
