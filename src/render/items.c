#include "render/items.h"

#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "math/vec3.h"

#include "base/banned.h"

/* ---- projection */

static void add(struct ts_items *items, struct ts_item item, size_t index, double nearest)
{
	item.index = (uint32_t)index;
	item.nearest = (float)nearest;
	items->item[items->n++] = item;
}

/* Whether all of a ball is beyond a plane that cuts. */
static bool is_cut_off(const struct ts_items *items, const double at[3], double radius)
{
	for (int k = 0; k < items->ncuts; k++)
		if (ts_dot(items->cut[k].place, at) - items->cut[k].offset >
		    radius * ts_norm(items->cut[k].place))
			return true;
	return false;
}

static void project_sphere(struct ts_items *items, const struct ts_camera *camera,
			   const struct ts_scene_sphere *from, size_t k)
{
	struct ts_item_round *to = &items->round[k];
	const struct ts_item item = { .kind = TS_ITEM_SPHERE,
				      .glass = from->opacity < 1,
				      .whole = from->whole || !items->ncuts };

	ts_camera_project(camera, from->x, to->a);
	memcpy(to->b, to->a, sizeof to->b);
	to->radius = camera->scale * from->radius;
	if (item.whole || !is_cut_off(items, to->a, to->radius))
		add(items, item, k, to->a[2] + to->radius);
}

static void project_rod(struct ts_items *items, const struct ts_camera *camera,
			const struct ts_scene_rod *from, size_t k)
{
	struct ts_item_round *to = &items->round[k];
	const struct ts_item item = { .kind = from->cone ? TS_ITEM_CONE : TS_ITEM_ROD,
				      .whole = from->whole || !items->ncuts };

	ts_camera_project(camera, from->end[0], to->a);
	ts_camera_project(camera, from->end[1], to->b);
	to->radius = camera->scale * from->radius;
	add(items, item, k, fmax(to->a[2], to->b[2]) + to->radius);
}

/* In the directions of the camera, on the side of the triangle that is seen. */
static void turn_corner_normals(struct ts_item_triangle *to, const struct ts_camera *camera,
				const struct ts_scene_triangle *from)
{
	for (int c = 0; c < 3; c++) {
		const double n[3] = { (double)from->normal[c][0], (double)from->normal[c][1],
				      (double)from->normal[c][2] };
		const double seen[3] = { ts_dot(n, camera->right), ts_dot(n, camera->up),
					 ts_dot(n, camera->towards) };
		double side = 0;

		for (int d = 0; d < 3; d++)
			side += seen[d] * (double)to->normal[d];
		for (int d = 0; d < 3; d++)
			to->corner_normal[c][d] = (float)(side < 0 ? -seen[d] : seen[d]);
	}
}

static void project_triangle(struct ts_items *items, const struct ts_camera *camera,
			     const struct ts_scene_triangle *from, size_t k)
{
	struct ts_item_triangle *to = &items->triangle[k];
	const struct ts_item item = { .kind = TS_ITEM_TRIANGLE,
				      .glass = from->opacity < 1,
				      .whole = from->whole || !items->ncuts };
	double e[3], f[3], n[3], length, sign;

	for (int c = 0; c < 3; c++)
		ts_camera_project(camera, from->corner[c], to->corner[c]);
	ts_sub(to->corner[1], to->corner[0], e);
	ts_sub(to->corner[2], to->corner[0], f);
	ts_cross(e, f, n);
	length = ts_norm(n);
	if (!(length > 0) || isinf(length)) /* no area */
		return;
	sign = n[2] < 0 ? -1 : 1;
	to->normal[0] = (float)(sign * n[0] / length);
	to->normal[1] = (float)(-sign * n[1] / length);
	to->normal[2] = (float)(sign * n[2] / length);
	if (from->smooth)
		turn_corner_normals(to, camera, from);
	add(items, item, k, fmax(fmax(to->corner[0][2], to->corner[1][2]), to->corner[2][2]));
}

/* ---- order */

/* The bits of a float as an unsigned number that grows as the float falls. */
static uint32_t falling(float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof bits);
	return bits & 0x80000000u ? bits : ~bits & 0x7fffffffu;
}

/* From the nearest to the farthest; equal ones in the order of the scene. */
static enum ts_status sort(struct ts_items *items)
{
	const size_t n = items->n;
	struct ts_item *sorted;

	TS_TRY(TS_GROW(items->key, items->key_capacity, 2 * n));
	sorted = ts_alloc(n, sizeof *sorted);
	if (!sorted)
		return TS_NOMEM;
	for (size_t k = 0; k < n; k++)
		items->key[k] = (uint64_t)falling(items->item[k].nearest) << 32 | k;
	ts_sort_keys(items->key, items->key + n, n);
	for (size_t k = 0; k < n; k++)
		sorted[k] = items->item[items->key[k] & 0xffffffffu];
	if (n)
		memcpy(items->item, sorted, n * sizeof *sorted);
	ts_free(sorted);
	return TS_OK;
}

/* ---- tiles */

struct rectangle {
	double lo[2], hi[2];
};

static struct rectangle extent(const struct ts_items *items, const struct ts_item *item)
{
	struct rectangle r;

	for (int d = 0; d < 2; d++) {
		if (item->kind != TS_ITEM_TRIANGLE) {
			const struct ts_item_round *s = &items->round[item->index];

			r.lo[d] = fmin(s->a[d], s->b[d]) - s->radius;
			r.hi[d] = fmax(s->a[d], s->b[d]) + s->radius;
		} else {
			const double(*c)[3] = (const double(*)[3])items->triangle[item->index].corner;

			r.lo[d] = fmin(fmin(c[0][d], c[1][d]), c[2][d]);
			r.hi[d] = fmax(fmax(c[0][d], c[1][d]), c[2][d]);
		}
	}
	return r;
}

/* The first and last tile along an edge of n tiles; false: none. */
static bool tiles_along(double lo, double hi, uint32_t n, uint32_t *first, uint32_t *last)
{
	const double most = (double)n * TS_TILE;

	if (!(hi >= 0 && lo <= most))
		return false;
	*first = lo > 0 ? (uint32_t)fmin(lo / TS_TILE, n - 1) : 0;
	*last = hi < most ? (uint32_t)(hi / TS_TILE) : n - 1;
	return true;
}

/* Whether a rod is near the tile; a long one crosses few of the tiles of its rectangle. */
static bool rod_touches(const struct ts_item_round *s, uint32_t column, uint32_t row)
{
	const double x = (column + 0.5) * TS_TILE, y = (row + 0.5) * TS_TILE,
		     reach = 0.7072 * TS_TILE + s->radius;
	double d[2] = { s->b[0] - s->a[0], s->b[1] - s->a[1] }, length = d[0] * d[0] + d[1] * d[1], t = 0,
	       e[2];

	if (length > 0)
		t = fmin(fmax(((x - s->a[0]) * d[0] + (y - s->a[1]) * d[1]) / length, 0), 1);
	e[0] = s->a[0] + t * d[0] - x;
	e[1] = s->a[1] + t * d[1] - y;
	return e[0] * e[0] + e[1] * e[1] <= reach * reach;
}

/* Calls `visit` for each tile that item k touches. */
typedef void visit_fn(struct ts_items *items, uint32_t tile, size_t k);
static void visit_tiles(struct ts_items *items, size_t k, visit_fn *visit)
{
	const struct ts_item *item = &items->item[k];
	const struct rectangle r = extent(items, item);
	uint32_t first[2], last[2];

	if (!tiles_along(r.lo[0], r.hi[0], items->columns, &first[0], &last[0]) ||
	    !tiles_along(r.lo[1], r.hi[1], items->rows, &first[1], &last[1]))
		return;
	for (uint32_t row = first[1]; row <= last[1]; row++)
		for (uint32_t column = first[0]; column <= last[0]; column++)
			if ((item->kind != TS_ITEM_ROD && item->kind != TS_ITEM_CONE) ||
			    rod_touches(&items->round[item->index], column, row))
				visit(items, row * items->columns + column, k);
}

static void count(struct ts_items *items, uint32_t tile, size_t k)
{
	(void)k;
	items->first[tile + 1]++;
	items->ntouch++;
}

/* first[t] counts up to the begin of the next tile; ts_items_collect shifts it back. */
static void enter(struct ts_items *items, uint32_t tile, size_t k)
{
	items->touch[items->first[tile]++] = (uint32_t)k;
}

static enum ts_status find_tiles(struct ts_items *items)
{
	const size_t tiles = (size_t)items->columns * items->rows;

	TS_TRY(TS_GROW(items->first, items->first_capacity, tiles + 1));
	memset(items->first, 0, (tiles + 1) * sizeof *items->first);
	items->ntouch = 0;
	for (size_t k = 0; k < items->n; k++)
		visit_tiles(items, k, count);
	if (items->ntouch > UINT32_MAX)
		return TS_NOMEM;
	TS_TRY(TS_GROW(items->touch, items->touch_capacity, items->ntouch));
	for (size_t t = 0; t < tiles; t++)
		items->first[t + 1] += items->first[t];
	for (size_t k = 0; k < items->n; k++)
		visit_tiles(items, k, enter);
	memmove(items->first + 1, items->first, tiles * sizeof *items->first);
	items->first[0] = 0;
	return TS_OK;
}

/* The planes in the coordinates of samples: x = centre + ((X - W/2) right - (Y - H/2) up + Z towards) / scale. */
static void project_cuts(struct ts_items *items, const struct ts_scene *scene, const struct ts_camera *camera)
{
	items->ncuts = scene->ncuts;
	for (int k = 0; k < scene->ncuts; k++) {
		const struct ts_scene_cut *from = &scene->cut[k];
		struct ts_item_cut *to = &items->cut[k];

		to->place[0] = ts_dot(from->normal, camera->right);
		to->place[1] = -ts_dot(from->normal, camera->up);
		to->place[2] = ts_dot(from->normal, camera->towards);
		to->offset = camera->scale * (from->offset - ts_dot(from->normal, camera->centre)) +
			     0.5 * (camera->width * to->place[0] + camera->height * to->place[1]);
	}
}

enum ts_status ts_items_collect(struct ts_items *items, const struct ts_scene *scene,
				const struct ts_camera *camera)
{
	const size_t nround = scene->nspheres + scene->nrods, most = nround + scene->ntriangles;

	if (most > UINT32_MAX)
		return TS_NOMEM;
	items->n = 0;
	items->columns = (camera->width + TS_TILE - 1) / TS_TILE;
	items->rows = (camera->height + TS_TILE - 1) / TS_TILE;
	TS_TRY(TS_GROW(items->item, items->capacity, most));
	TS_TRY(TS_GROW(items->round, items->round_capacity, nround));
	TS_TRY(TS_GROW(items->triangle, items->triangle_capacity, scene->ntriangles));
	project_cuts(items, scene, camera);
	for (size_t k = 0; k < scene->nspheres; k++)
		project_sphere(items, camera, &scene->sphere[k], k);
	for (size_t k = 0; k < scene->nrods; k++)
		project_rod(items, camera, &scene->rod[k], scene->nspheres + k);
	for (size_t k = 0; k < scene->ntriangles; k++)
		project_triangle(items, camera, &scene->triangle[k], k);
	TS_TRY(sort(items));
	return find_tiles(items);
}

void ts_items_release(struct ts_items *items)
{
	ts_free(items->item);
	ts_free(items->round);
	ts_free(items->triangle);
	ts_free(items->first);
	ts_free(items->touch);
	ts_free(items->key);
	memset(items, 0, sizeof *items);
}
