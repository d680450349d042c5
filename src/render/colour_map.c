#include "render/colour_map.h"

#include <math.h>

#include "base/banned.h"

static const struct ts_colour_map_entry blue_red[] = { { -INFINITY, 0, { { 0, 0, 1 } } },
						       { INFINITY, 0, { { 1, 0, 0 } } } };
const struct ts_colour_map ts_colour_map_default = {
	.lo = NAN, .hi = NAN, .style = TS_MAP_CONTINUOUS, .fractional = true, .entry = blue_red, .n = 2
};

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
