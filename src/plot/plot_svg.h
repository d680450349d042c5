/* Plots as SVG 1.1: text is text, no fonts, no scripts and no network are needed. The picture has a viewBox and no size, so
 * it takes the width of the page; in a page limit it, e.g. `.ts-plot { max-width: 45em }`.
 *
 * It may stand in a file of its own or in HTML, also many times: it has no identifiers, and its style sheet refers to
 * the class ts-plot only. Colours are light or dark as the reader's system asks (prefers-color-scheme), and light in
 * print. A page can set them itself: .ts-plot { color } for letters and lines, .ts-plot .ground { fill }. */
#ifndef TS_PLOT_PLOT_SVG_H
#define TS_PLOT_PLOT_SVG_H

#include <stdio.h>

#include "plot/plot.h"

#include "base/str.h"

/* Writes the element <svg>, without an XML declaration. Returns TS_OK, TS_NOMEM or TS_IO. */
enum ts_status ts_plot_svg(const struct ts_plot *plot, FILE *out);
/* Appends the same text. */
enum ts_status ts_plot_svg_add(const struct ts_plot *plot, struct ts_str *out);
/* Several plots in one picture, so many in a row. n >= 1. */
enum ts_status ts_plot_svg_panels(const struct ts_plot *plot, size_t n, size_t columns, struct ts_str *out);

#endif
