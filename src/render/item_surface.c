#include "render/item_surface.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"
#include "render/round.h"

#include "base/banned.h"

/* Magenta: values that are no numbers. */
static const struct ts_colour no_number = { { 1, 0, 1 } };

bool ts_item_is_unlit(const struct ts_scene *scene, const struct ts_item *item)
{
	return item->kind == TS_ITEM_TRIANGLE && scene->triangle[item->index].unlit;
}

float ts_item_opacity(const struct ts_scene *scene, const struct ts_item *item)
{
	if (item->kind == TS_ITEM_TRIANGLE)
		return scene->triangle[item->index].opacity;
	return item->kind == TS_ITEM_SPHERE ? scene->sphere[item->index].opacity : 1;
}

/* The shares of the corners in a number at x, y that is linear between them. */
static void find_shares(const struct ts_item_triangle *at, double x, double y, double share[3])
{
	const double(*c)[3] = (const double(*)[3])at->corner;
	const double ex = c[1][0] - c[0][0], ey = c[1][1] - c[0][1], fx = c[2][0] - c[0][0],
		     fy = c[2][1] - c[0][1];
	const double area = ex * fy - ey * fx, dx = x - c[0][0], dy = y - c[0][1];
	const double p = (dx * fy - dy * fx) / area, q = (ex * dy - ey * dx) / area;

	share[0] = 1 - p - q;
	share[1] = p;
	share[2] = q;
}

static double number_at(const struct ts_scene_triangle *t, const struct ts_item_triangle *at, double x,
			double y)
{
	double share[3];

	find_shares(at, x, y, share);
	return share[0] * (double)t->value[0] + share[1] * (double)t->value[1] +
	       share[2] * (double)t->value[2];
}

/* The normal between those of the corners; that of the triangle where it would point away from the camera. */
static void smooth_normal(const struct ts_item_triangle *t, double x, double y, float n[3])
{
	double share[3], sum[3] = { 0 }, size;

	find_shares(t, x, y, share);
	for (int c = 0; c < 3; c++)
		for (int d = 0; d < 3; d++)
			sum[d] += share[c] * (double)t->corner_normal[c][d];
	size = ts_norm(sum);
	for (int d = 0; d < 3; d++)
		n[d] = size > 0 && sum[2] > 0 ? (float)(sum[d] / size) : t->normal[d];
}

struct ts_colour ts_item_colour(const struct ts_scene *scene, const struct ts_items *items,
				const struct ts_item *item, double x, double y)
{
	const struct ts_scene_triangle *t;
	double number;

	if (item->kind == TS_ITEM_SPHERE)
		return scene->sphere[item->index].colour;
	if (item->kind != TS_ITEM_TRIANGLE)
		return scene->rod[item->index - scene->nspheres].colour;
	t = &scene->triangle[item->index];
	if (!t->scale)
		return t->colour;
	number = number_at(t, &items->triangle[item->index], x, y);
	return isnan(number) ? no_number
			     : ts_colour_map_at(t->scale->map, t->scale->lo, t->scale->hi, number);
}

void ts_item_normal(const struct ts_scene *scene, const struct ts_items *items, const struct ts_item *item,
		    double x, double y, double z, float n[3])
{
	struct ts_round r;

	if (item->kind == TS_ITEM_SPHERE) {
		const double *c = items->round[item->index].a, w[3] = { x - c[0], c[1] - y, z - c[2] };
		const double size = ts_norm(w), scale = size > 0 ? 1 / size : 0;

		for (int k = 0; k < 3; k++)
			n[k] = (float)(scale * w[k]);
		return;
	}
	if (item->kind == TS_ITEM_TRIANGLE) {
		if (scene->triangle[item->index].smooth)
			smooth_normal(&items->triangle[item->index], x, y, n);
		else
			memcpy(n, items->triangle[item->index].normal, sizeof items->triangle->normal);
		return;
	}
	r = ts_round_make(&items->round[item->index], (enum ts_item_kind)item->kind, 0, 0);
	ts_round_normal(&r, x, y, z, n);
}
