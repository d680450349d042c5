#include "render/colour_map.h"

#include <math.h>

#include "base/banned.h"

static const struct ts_colour_map_entry blue_red[] = { { -INFINITY, 0, { { 0, 0, 1 } } },
						       { INFINITY, 0, { { 1, 0, 0 } } } };
const struct ts_colour_map ts_colour_map_default = {
	.lo = NAN, .hi = NAN, .style = TS_MAP_CONTINUOUS, .fractional = true, .entry = blue_red, .n = 2
};

#define HEX(from_, r, g, b)                                        \
	{                                                          \
		from_, 0,                                          \
		{                                                  \
			{                                          \
				r / 255.0F, g / 255.0F, b / 255.0F \
			}                                          \
		}                                                  \
	}
#define MAP(e)                                                                                      \
	{                                                                                           \
		.lo = NAN, .hi = NAN, .style = TS_MAP_CONTINUOUS, .fractional = true, .entry = (e), \
		.n = sizeof(e) / sizeof *(e)                                                        \
	}
/* S. van der Walt, N. Smith, 2015: even steps for the eye, also in gray; ten of its 256 colours. */
static const struct ts_colour_map_entry viridis[] = {
	HEX(-INFINITY, 68, 1, 84),  HEX(1.0 / 9, 72, 40, 120),	HEX(2.0 / 9, 62, 73, 137),
	HEX(3.0 / 9, 49, 104, 142), HEX(4.0 / 9, 38, 130, 142), HEX(5.0 / 9, 31, 158, 137),
	HEX(6.0 / 9, 53, 183, 121), HEX(7.0 / 9, 110, 206, 88), HEX(8.0 / 9, 181, 222, 43),
	HEX(INFINITY, 253, 231, 37)
};
/* K. Moreland, ISVC 2009, LNCS 5876, 92: from blue through gray to red, for numbers of both signs. */
static const struct ts_colour_map_entry coolwarm[] = {
	HEX(-INFINITY, 59, 76, 192), HEX(1.0 / 8, 103, 136, 238), HEX(2.0 / 8, 154, 187, 255),
	HEX(3.0 / 8, 201, 215, 240), HEX(4.0 / 8, 221, 221, 221), HEX(5.0 / 8, 237, 209, 194),
	HEX(6.0 / 8, 247, 168, 137), HEX(7.0 / 8, 226, 105, 82),  HEX(INFINITY, 180, 4, 38)
};
static const struct ts_colour_map_entry gray[] = { HEX(-INFINITY, 0, 0, 0), HEX(INFINITY, 255, 255, 255) };

static const struct {
	const char *name;
	struct ts_colour_map map;
} named[] = { { "viridis", MAP(viridis) }, { "coolwarm", MAP(coolwarm) }, { "gray", MAP(gray) } };
enum { NAMED = sizeof named / sizeof *named };

const struct ts_colour_map *ts_colour_map_named(const char *name)
{
	for (int k = 0; k < NAMED; k++)
		if (ts_streq(named[k].name, name))
			return &named[k].map;
	return NULL;
}

void ts_colour_map_suggest(struct ts_suggest *suggest)
{
	for (int k = 0; k < NAMED; k++)
		ts_suggest_try(suggest, named[k].name);
}

void ts_colour_map_extend(const double *value, size_t n, size_t stride, double *lo, double *hi)
{
	for (size_t k = 0; k < n; k++) {
		double v = value[k * stride];

		if (!isfinite(v))
			continue;
		*lo = v < *lo ? v : *lo;
		*hi = v > *hi ? v : *hi;
	}
}

void ts_colour_map_range(const struct ts_colour_map *map, double *lo, double *hi)
{
	if (!isnan(map->lo))
		*lo = map->lo;
	if (!isnan(map->hi))
		*hi = map->hi;
	if (!(*lo <= *hi)) /* no values, or all beyond the end that is given */
		*hi = *lo = isnan(map->lo) ? (isnan(map->hi) ? 0 : map->hi) : map->lo;
}

/* A place of the map as a value. */
static double place(const struct ts_colour_map *map, double lo, double hi, double at)
{
	if (isinf(at))
		return at < 0 ? lo : hi;
	return map->fractional ? lo + at * (hi - lo) : at;
}

static struct ts_colour between(const struct ts_colour_map *map, double lo, double hi, double value)
{
	for (size_t k = 1; k < map->n; k++) {
		double a = place(map, lo, hi, map->entry[k - 1].from),
		       b = place(map, lo, hi, map->entry[k].from);

		if (value <= b)
			return ts_colour_mix(map->entry[k - 1].colour, map->entry[k].colour,
					     b > a ? fmax((value - a) / (b - a), 0) : 0);
	}
	return map->entry[map->n - 1].colour;
}

struct ts_colour ts_colour_map_at(const struct ts_colour_map *map, double lo, double hi, double value)
{
	value = fmin(fmax(value, lo), hi);
	if (map->style == TS_MAP_CONTINUOUS)
		return between(map, lo, hi, value);
	if (map->style == TS_MAP_SEQUENTIAL) {
		double bin = map->fractional ? map->bin * (hi - lo) : map->bin;
		double number = bin > 0 ? floor((value - lo) / bin) : 0;

		return map->entry[(size_t)fmod(number, (double)map->n)].colour;
	}
	for (size_t k = 0; k < map->n; k++)
		if (place(map, lo, hi, map->entry[k].from) <= value &&
		    value <= place(map, lo, hi, map->entry[k].to))
			return map->entry[k].colour;
	return map->entry[map->n - 1].colour;
}
