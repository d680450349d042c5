/* Letters in pictures: the usual 5 x 7 dots of character displays, with two more below the line, ASCII only, enlarged by whole
 * numbers. */
#ifndef TS_RENDER_LETTERS_H
#define TS_RENDER_LETTERS_H

#include "render/picture.h"

enum {
	TS_LETTER_ROWS = 9,
	TS_LETTER_WIDTH = 6, /* dots, with the gap to the next */
	TS_LETTER_HEIGHT = 8 /* of a capital, with a gap */
};

/* Whether the dot of an ASCII letter in column 0 to 4 from the left, row 0 to TS_LETTER_ROWS - 1 from the top, is set. */
bool ts_letters_dot(char letter, int column, int row);
/* Width of a text in pixels with `scale` pixels to a dot. */
int64_t ts_letters_width(const char *text, int scale);
/* Writes it with the upper left corner at x, y; what is outside of the picture is left out. */
void ts_letters_draw(struct ts_picture *p, int64_t x, int64_t y, int scale, const char *text,
		     struct ts_colour colour);
/* Fills a rectangle, as far as it is in the picture. */
void ts_letters_fill(struct ts_picture *p, int64_t x, int64_t y, int64_t width, int64_t height,
		     struct ts_colour colour);

/* The same with a colour of this opacity. */
void ts_letters_veil(struct ts_picture *p, int64_t x, int64_t y, int64_t width, int64_t height,
		     struct ts_colour colour, double opacity);

#endif
