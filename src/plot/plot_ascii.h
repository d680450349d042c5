/* The nearest ASCII letters of a text in UTF-8. */
#ifndef TS_PLOT_PLOT_ASCII_H
#define TS_PLOT_PLOT_ASCII_H

#include "base/str.h"

struct ts_plot_ascii {
	char shown;
	bool raised; /* an exponent, a degree, a multiplication point */
};

/* The next letter before `stop`; moves *text behind it. A letter without a likeness is '?'. */
struct ts_plot_ascii ts_plot_ascii_next(const char **text, const char *stop);
/* Appends the text: exponents as 10^-6, products as 2*10^-6. */
void ts_plot_ascii_add(const char *text, size_t bytes, struct ts_str *out);

#endif
