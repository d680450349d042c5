#include "render/tile.h"

#include <math.h>

#include "base/clones.h"
#include "base/inline.h"
#include "render/round.h"

#include "base/banned.h"

enum { LOOK_AFTER = 16 /* items, then the farthest sample of the tile is looked for again */ };

struct span {
	int first, last;
};

/* Samples of a tile whose middle is within lo..hi, relative to the tile. */
static struct span samples_within(double lo, double hi)
{
	struct span s = { 0, TS_TILE - 1 };

	if (lo > 0.5)
		s.first = lo > TS_TILE ? TS_TILE : (int)ceil(lo - 0.5);
	if (hi < TS_TILE - 0.5)
		s.last = hi < 0 ? -1 : (int)floor(hi - 0.5);
	return s;
}

/* ---- spheres: z = c_z + sqrt(r^2 - (x - c_x)^2 - (y - c_y)^2) */

TS_CLONES
static void sphere_row(float *restrict depth, uint32_t *restrict seen, uint32_t item, int n, float x, float z,
		       float q)
{
	/* x: of the first sample from the centre; q = r^2 - y^2 */
#pragma omp simd
	for (int i = 0; i < n; i++) {
		const float dx = x + (float)i, rest = q - dx * dx, at = z + sqrtf(rest > 0 ? rest : 0);
		const int nearer = (rest >= 0) & (at > depth[i]);

		depth[i] = nearer ? at : depth[i];
		seen[i] = nearer ? item : seen[i];
	}
}

static void cover_sphere(struct ts_tile *tile, const struct ts_item_round *s, uint32_t item)
{
	const double cx = s->a[0] - tile->x, cy = s->a[1] - tile->y, r2 = s->radius * s->radius;
	const struct span rows = samples_within(cy - s->radius, cy + s->radius);

	for (int j = rows.first; j <= rows.last; j++) {
		const double dy = j + 0.5 - cy, q = r2 - dy * dy, half = sqrt(fmax(q, 0));
		const struct span along = samples_within(cx - half, cx + half);

		if (q >= 0 && along.first <= along.last)
			sphere_row(tile->depth + j * TS_TILE + along.first,
				   tile->seen + j * TS_TILE + along.first, item, along.last - along.first + 1,
				   (float)(along.first + 0.5 - cx), (float)s->a[2], (float)q);
	}
}

/* ---- planes that cut */

/* The face of a cut is drawn a little in front of its plane, so that what lies in the plane does not show through. */
static const double IN_FRONT = 0.01;

/* The depth of a plane at a sample, and whether it removes what is in front (1), behind (-1), all (2) or nothing (0). */
static int meet_cut(const struct ts_item_cut *cut, double x, double y, double *z)
{
	const double rest = cut->offset - cut->place[0] * x - cut->place[1] * y;

	if (fabs(cut->place[2]) < 1e-9)
		return rest < 0 ? 2 : 0;
	*z = rest / cut->place[2];
	if (cut->place[2] > 0)
		*z += IN_FRONT;
	return cut->place[2] > 0 ? 1 : -1;
}

static void find_cuts(struct ts_tile *tile, const struct ts_items *items)
{
	for (int s = 0; items->ncuts && s < TS_TILE_SAMPLES; s++) {
		float high = HUGE_VALF, low = -HUGE_VALF;

		for (int k = 0; k < items->ncuts; k++) {
			double z = 0;
			const int side = meet_cut(&items->cut[k], (double)tile->x + s % TS_TILE + 0.5,
						  tile->y + (double)(s / TS_TILE) + 0.5, &z);

			if (side == 1)
				high = fminf(high, (float)z);
			else if (side == -1)
				low = fmaxf(low, (float)z);
			else if (side == 2)
				high = -HUGE_VALF;
		}
		tile->high[s] = high;
		tile->low[s] = low;
	}
}

bool ts_tile_is_cut_face(const struct ts_tile *tile, const struct ts_items *items, const struct ts_item *item,
			 uint32_t sample, float z, float normal[3])
{
	if (item->whole || item->kind == TS_ITEM_TRIANGLE || z < tile->high[sample])
		return false;
	for (int k = 0; k < items->ncuts; k++) {
		const double *place = items->cut[k].place;
		double at = 0;
		const int side = meet_cut(&items->cut[k], tile->x + sample % TS_TILE + 0.5,
					  tile->y + (double)(sample / TS_TILE) + 0.5, &at);

		if (side != 1 || (float)at > z)
			continue;
		normal[0] = (float)place[0];
		normal[1] = (float)-place[1];
		normal[2] = (float)place[2];
		return true;
	}
	return false;
}

/* ---- spheres that are cut or transparent, rods and cones */

static void visit_round(const struct ts_tile *tile, const struct ts_item *item, const struct ts_item_round *s,
			ts_tile_visit_fn *visit, void *context)
{
	const struct ts_round r = ts_round_make(s, (enum ts_item_kind)item->kind, tile->x, tile->y);
	const struct span rows =
		samples_within(fmin(r.a[1], r.b[1]) - s->radius, fmax(r.a[1], r.b[1]) + s->radius);
	const struct span along =
		samples_within(fmin(r.a[0], r.b[0]) - s->radius, fmax(r.a[0], r.b[0]) + s->radius);

	for (int j = rows.first; j <= rows.last; j++)
		for (int i = along.first; i <= along.last; i++) {
			const int k = j * TS_TILE + i;
			double near, far;
			float z;

			if (!ts_round_span(&r, i + 0.5, j + 0.5, &near, &far))
				continue;
			z = (float)near;
			if (!item->whole) {
				z = fminf(z, tile->high[k]);
				if (z < (float)far || z < tile->low[k])
					continue;
			}
			if (z > tile->depth[k])
				visit(context, (uint32_t)k, z);
		}
}

/* ---- triangles */

/* The line through two corners of a triangle: value(x, y) > 0 inside. Both triangles at an edge compute the same number but
 * for its sign, since the corners are taken in an order that does not depend on the triangle; a sample on the line belongs
 * to one of them. */
struct edge {
	double p[2], d[2], sign;
	bool owns; /* samples on the line */
};

static struct edge make_edge(const double a[3], const double b[3], double orientation)
{
	const bool swap = a[1] > b[1] || (a[1] == b[1] && a[0] > b[0]);
	const double *p = swap ? b : a, *q = swap ? a : b;
	struct edge e = { .p = { p[0], p[1] }, .d = { q[0] - p[0], q[1] - p[1] }, .sign = swap ? -1 : 1 };

	e.sign *= orientation;
	e.owns = e.sign > 0;
	return e;
}

TS_INLINE bool is_inside(const struct edge *e, double x, double y)
{
	const double value = e->sign * (e->d[0] * (y - e->p[1]) - e->d[1] * (x - e->p[0]));

	return value > 0 || (value == 0 && e->owns);
}

static void visit_triangle(const struct ts_tile *tile, const struct ts_item *item,
			   const struct ts_item_triangle *t, ts_tile_visit_fn *visit, void *context)
{
	const double(*c)[3] = (const double(*)[3])t->corner;
	const double ex = c[1][0] - c[0][0], ey = c[1][1] - c[0][1], fx = c[2][0] - c[0][0],
		     fy = c[2][1] - c[0][1];
	const double area = ex * fy - ey * fx, ez = c[1][2] - c[0][2], fz = c[2][2] - c[0][2];
	const double zx = (ez * fy - fz * ey) / area, zy = (fz * ex - ez * fx) / area;
	struct edge edge[3];
	struct span rows, along;

	if (!(fabs(area) > 0)) /* seen from the side */
		return;
	for (int k = 0; k < 3; k++)
		edge[k] = make_edge(c[k], c[(k + 1) % 3], area > 0 ? 1 : -1);
	rows = samples_within(fmin(fmin(c[0][1], c[1][1]), c[2][1]) - tile->y,
			      fmax(fmax(c[0][1], c[1][1]), c[2][1]) - tile->y);
	along = samples_within(fmin(fmin(c[0][0], c[1][0]), c[2][0]) - tile->x,
			       fmax(fmax(c[0][0], c[1][0]), c[2][0]) - tile->x);
	for (int j = rows.first; j <= rows.last; j++)
		for (int i = along.first; i <= along.last; i++) {
			const double x = (double)tile->x + i + 0.5, y = (double)tile->y + j + 0.5;
			const int k = j * TS_TILE + i;
			float z;

			if (!is_inside(&edge[0], x, y) || !is_inside(&edge[1], x, y) ||
			    !is_inside(&edge[2], x, y))
				continue;
			z = (float)(c[0][2] + zx * (x - c[0][0]) + zy * (y - c[0][1]));
			if (!item->whole && (z > tile->high[k] || z < tile->low[k]))
				continue;
			if (z > tile->depth[k])
				visit(context, (uint32_t)k, z);
		}
}

/* ---- a tile */

void ts_tile_visit(const struct ts_tile *tile, const struct ts_items *items, const struct ts_item *item,
		   ts_tile_visit_fn *visit, void *context)
{
	if (item->kind == TS_ITEM_TRIANGLE)
		visit_triangle(tile, item, &items->triangle[item->index], visit, context);
	else
		visit_round(tile, item, &items->round[item->index], visit, context);
}

struct cover {
	struct ts_tile *tile;
	uint32_t item;
};

static void cover_sample(void *context, uint32_t sample, float z)
{
	const struct cover *c = context;

	c->tile->depth[sample] = z;
	c->tile->seen[sample] = c->item;
}

static float farthest(const struct ts_tile *tile)
{
	float z = tile->depth[0];

	for (int k = 1; k < TS_TILE_SAMPLES; k++)
		z = tile->depth[k] < z ? tile->depth[k] : z;
	return z;
}

static void cover(struct ts_tile *tile, const struct ts_items *items, uint32_t number)
{
	const struct ts_item *item = &items->item[number];
	struct cover context = { tile, number };

	if (item->glass)
		return;
	if (item->kind == TS_ITEM_SPHERE && item->whole)
		cover_sphere(tile, &items->round[item->index], number);
	else
		ts_tile_visit(tile, items, item, cover_sample, &context);
}

void ts_tile_cover(struct ts_tile *tile, const struct ts_items *items, size_t number)
{
	const uint32_t end = items->first[number + 1];
	float far = TS_TILE_FAR;

	tile->x = (uint32_t)(number % items->columns) * TS_TILE;
	tile->y = (uint32_t)(number / items->columns) * TS_TILE;
	for (int k = 0; k < TS_TILE_SAMPLES; k++) {
		tile->depth[k] = TS_TILE_FAR;
		tile->seen[k] = TS_TILE_NOTHING;
	}
	find_cuts(tile, items);
	/* from the nearest item on: those behind the farthest sample are not seen, nor are all after them */
	for (uint32_t k = items->first[number], n = 0; k < end; k++, n++) {
		if (n % LOOK_AFTER == 0)
			far = farthest(tile);
		if (items->item[items->touch[k]].nearest < far)
			break;
		cover(tile, items, items->touch[k]);
	}
}
