/* Arrows, and those of vectors of the particles: the keyword arrow. */
#ifndef TS_IMAGE_IMAGE_ARROW_H
#define TS_IMAGE_IMAGE_ARROW_H

#include "image/image_groups.h"

/* How arrows are drawn. The struct is made by the rows TS_IMAGE_ARROW_ROWS of a keyword. */
struct ts_image_arrow_style {
	double longest; /* length of the longest arrow of the frame; NaN: not given */
	double factor;	/* length of an arrow by size of its vector; NaN: not given */
	double width;	/* diameter of the shaft, length; NaN: in proportion to the longest arrow */
	const char *colour_name;
	struct ts_colour colour;
};
/* clang-format off */
#define TS_IMAGE_ARROW_ROWS(T, f, fallback_)                                                                  \
	TS_REAL("length", T, f.longest, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",        \
		.help = "of the longest arrow of the frame"),                                                 \
	TS_REAL("factor", T, f.factor, .flags = TS_OPTIONAL, .range = TS_POSITIVE,                           \
		.help = "length of an arrow by size of its vector, in place of `length`"),                    \
	TS_REAL("width", T, f.width, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",           \
		.help = "diameter of the shaft"),                                                             \
	TS_WORD("color", T, f.colour_name, .fallback = fallback_, .help = "of the arrows")
/* clang-format on */

/* Lengths of the arrows of one frame. */
struct ts_image_arrow_size {
	double factor, longest, width;
};
/* `largest`: size of the largest vector; `usual`: length of its arrow, if the style does not say it. */
struct ts_image_arrow_size ts_image_arrow_size(const struct ts_image_arrow_style *style, double largest,
					       double usual);
/* Adds an arrow from x; nothing for a vector that is not finite, or a fiftieth of the largest or less. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_image_add_arrow(struct ts_scene *scene, const double x[3], const double vector[3],
				  const struct ts_image_arrow_size *size, struct ts_colour colour);
/* Reads the words that several keywords have. */
enum ts_status ts_image_read_arrow_style(struct ts_instance *self, struct tsim *sim,
					 const struct ts_image_group *group,
					 struct ts_image_arrow_style *style);

struct ts_image_arrows {
	struct ts_image_group group;
	const char *name[3]; /* components */
	struct ts_image_arrow_style style;
	struct ts_dump_column component[3];
};
enum ts_status ts_image_read_arrows(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_arrows(struct ts_instance *self, struct tsim *sim);
void ts_image_release_arrows(struct ts_image *d);

#endif
