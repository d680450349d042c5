#include "render/occlusion.h"

#include <math.h>

#include "base/banned.h"

enum { DIRECTIONS = 8, STEPS = 4 };
static const double PI = 3.14159265358979323846;

/* A number from 0 to 1 of a place (T. Mueller's integer hash). */
static double noise(uint32_t x, uint32_t y, uint32_t seed)
{
	uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca6bu ^ seed * 0xc2b2ae35u;

	h = (h ^ h >> 16) * 0x45d9f3bu;
	h = (h ^ h >> 16) * 0x45d9f3bu;
	return (double)(h ^ h >> 16) / 4294967296.0;
}

/* The sine of the largest elevation above the sample along a direction; surfaces farther than the reach in front of it are
 * not near. */
static double horizon(const struct ts_occlusion *o, uint32_t x, uint32_t y, double angle, double first)
{
	const float here = o->depth[(size_t)y * o->width + x];
	const double dx = cos(angle), dy = sin(angle);
	double most = 0;

	for (int k = 0; k < STEPS; k++) {
		const double r = o->reach * (k + first) / STEPS, at = floor(x + 0.5 + r * dx),
			     down = floor(y + 0.5 + r * dy);
		double rise, sine;

		if (at < 0 || down < 0 || at >= o->width || down >= o->height)
			break;
		rise = (double)o->depth[(size_t)down * o->width + (size_t)at] - (double)here;
		if (!(rise > 0) || rise > 2 * o->reach)
			continue;
		sine = rise / sqrt(rise * rise + r * r) * (1 - r / o->reach * 0.5);
		most = sine > most ? sine : most;
	}
	return most;
}

float ts_occlusion_at(const struct ts_occlusion *o, uint32_t x, uint32_t y)
{
	const double turn = noise(x, y, o->seed), first = 0.25 + 0.75 * noise(y, x, o->seed + 1);
	double sum = 0;

	if (o->depth[(size_t)y * o->width + x] <= o->background)
		return 1;
	for (int k = 0; k < DIRECTIONS; k++)
		sum += horizon(o, x, y, 2 * PI * (k + turn) / DIRECTIONS, first);
	return (float)(1 - o->strength * fmin(1.6 * sum / DIRECTIONS, 1));
}
