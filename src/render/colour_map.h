/* Maps from numbers to colours, as `dump_modify amap` of LAMMPS describes them. */
#ifndef TS_RENDER_COLOUR_MAP_H
#define TS_RENDER_COLOUR_MAP_H

#include "render/colour.h"

enum ts_colour_map_style {
	TS_MAP_CONTINUOUS, /* colours between values: `from` of each entry */
	TS_MAP_DISCRETE,   /* the first entry with from <= value <= to */
	TS_MAP_SEQUENTIAL  /* bins of equal width, the colours repeat */
};

struct ts_colour_map_entry {
	double from, to; /* -INFINITY: the lower end of the range; INFINITY: the upper one */
	struct ts_colour colour;
};

struct ts_colour_map {
	double lo, hi; /* range; NaN: that of the values drawn */
	enum ts_colour_map_style style;
	bool fractional;			 /* entries and bins are given as parts of the range */
	double bin;				 /* width of the bins of a sequential map */
	const struct ts_colour_map_entry *entry; /* [n], n > 0 */
	size_t n;
};

/* Blue at the least, red at the largest value drawn. */
extern const struct ts_colour_map ts_colour_map_default;

/* Maps that have a name: viridis, coolwarm, gray; entries as fractions of the range. NULL: there is none of this name. */
const struct ts_colour_map *ts_colour_map_named(const char *name);
/* Offers their names as corrections. */
void ts_colour_map_suggest(struct ts_suggest *suggest);

/* Enlarges lo..hi by the finite numbers among n values with this stride. Start with lo > hi. */
void ts_colour_map_extend(const double *value, size_t n, size_t stride, double *lo, double *hi);
/* The range of the map: its own ends, else lo..hi of the values drawn. */
void ts_colour_map_range(const struct ts_colour_map *map, double *lo, double *hi);
/* Colour of a value within the range lo..hi; values outside have the colours of the ends. Not for NaN. */
struct ts_colour ts_colour_map_at(const struct ts_colour_map *map, double lo, double hi, double value);

#endif
