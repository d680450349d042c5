/* Where the parts of a plot are. Units are those of the plot, y downwards. From top to bottom: title, legend, titles of
 * the y axes, frame, numbers, title of the x axis, note. Nothing is written over the curves except names of marks. */
#ifndef TS_PLOT_PLOT_LAYOUT_H
#define TS_PLOT_PLOT_LAYOUT_H

#include "plot/plot_scale.h"

/* Mean width of a letter and distance of lines of text in the font of the writer. */
struct ts_plot_font {
	double letter, line;
};

enum { TS_PLOT_TEXT_LINES = 3 };
/* A text broken into lines: slices of it. */
struct ts_plot_lines {
	struct {
		const char *text;
		int length; /* bytes */
		double y;   /* base line */
	} line[TS_PLOT_TEXT_LINES];
	int n;
};

/* Place of an entry of the legend: of its line at the left, on the base line of its text. */
struct ts_plot_entry {
	double x, y;
};

struct ts_plot_layout {
	struct ts_plot_font font;
	double width, height;		 /* of the whole */
	double left, right, top, bottom; /* of the frame */
	struct ts_plot_scale x, y, y2;	 /* y2: of the right, if it has one */
	bool has_right;
	struct ts_plot_entry *entry; /* [series]; those without a name are not drawn */
	struct ts_str x_text, y_text, right_text, note_text;
	struct ts_plot_lines title, x_title, y_title, right_title, note;
};

/* Length of the line in the legend, gap to the text included. */
enum { TS_PLOT_SAMPLE = 26 };

/* Returns TS_OK or TS_NOMEM; in both cases the layout is to be released. */
enum ts_status ts_plot_layout_set(struct ts_plot_layout *l, const struct ts_plot *plot,
				  const struct ts_plot_font *font);
/* The scale of y of a series. */
const struct ts_plot_scale *ts_plot_layout_scale(const struct ts_plot_layout *l,
						 const struct ts_plot_series *s);
void ts_plot_layout_release(struct ts_plot_layout *l);

/* Several plots as one picture: the place of the upper left corner of each, rows as high as their highest plot. */
struct ts_plot_panels {
	double width, height;
	double (*place)[2]; /* [n] */
};
/* n >= 1, columns >= 1. Returns TS_OK or TS_NOMEM; in both cases the panels are to be released. */
enum ts_status ts_plot_panels_set(struct ts_plot_panels *p, const struct ts_plot *plot, size_t n,
				  size_t columns, const struct ts_plot_font *font);
void ts_plot_panels_release(struct ts_plot_panels *p);

/* Appends how many points are not shown; nothing if all are. */
void ts_plot_note(const struct ts_plot *plot, const struct ts_plot_extent *extent, struct ts_str *out);
/* Number of letters, not bytes. */
size_t ts_plot_letters(const char *text, size_t bytes);

#endif
