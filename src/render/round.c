#include "render/round.h"

#include <math.h>

#include "math/vec3.h"

#include "base/banned.h"

struct ts_round ts_round_make(const struct ts_item_round *s, enum ts_item_kind kind, double x, double y)
{
	struct ts_round r = { .kind = kind, .from = { x, y }, .radius = s->radius };

	for (int d = 0; d < 3; d++) {
		const double origin = d < 2 ? r.from[d] : 0;

		r.a[d] = s->a[d] - origin;
		r.b[d] = s->b[d] - origin;
	}
	ts_sub(r.b, r.a, r.u);
	r.length = ts_norm(r.u);
	if (r.length > 0)
		ts_scale(1 / r.length, r.u, r.u);
	return r;
}

/* The part of the ray within a convex body, from points where it may enter or leave. */
struct range {
	double nearest, farthest;
};

static void extend(struct range *range, double z)
{
	range->nearest = fmax(range->nearest, z);
	range->farthest = fmin(range->farthest, z);
}

/* z = c_z +- sqrt(r^2 - (x - c_x)^2 - (y - c_y)^2) */
static void meet_ball(struct range *range, const double c[3], double radius, double x, double y)
{
	const double dx = x - c[0], dy = y - c[1], rest = radius * radius - dx * dx - dy * dy;

	if (!(rest >= 0))
		return;
	extend(range, c[2] + sqrt(rest));
	extend(range, c[2] - sqrt(rest));
}

/* The mantle of a cylinder (slope 0) or cone: |w|^2 - (w.u)^2 = (r - slope w.u)^2 with w from the end a and 0 <= w.u <= L,
 * a quadratic for t = w_z. */
static void meet_mantle(struct range *range, const struct ts_round *r, double slope, double x, double y)
{
	const double w[2] = { x - r->a[0], y - r->a[1] }, along = w[0] * r->u[0] + w[1] * r->u[1];
	const double wide = r->radius - slope * along, k = 1 + slope * slope, q = r->u[2];
	const double a = r->u[0] * r->u[0] + r->u[1] * r->u[1] - slope * slope * q * q,
		     b = slope * wide * q - along * q;
	const double c = w[0] * w[0] + w[1] * w[1] - along * along - wide * wide, root = b * b - a * c;

	if (!(root >= 0) || !(fabs(a) > 1e-12 * k))
		return;
	for (int sign = -1; sign <= 1; sign += 2) {
		const double t = (-b + sign * sqrt(root)) / a, s = along + t * q;

		if (s >= 0 && s <= r->length)
			extend(range, r->a[2] + t);
	}
}

/* The base of a cone: a disc around a, perpendicular to u. */
static void meet_base(struct range *range, const struct ts_round *r, double x, double y)
{
	const double w[2] = { x - r->a[0], y - r->a[1] };
	double t;

	if (!(fabs(r->u[2]) > 1e-12))
		return;
	t = -(w[0] * r->u[0] + w[1] * r->u[1]) / r->u[2];
	if (w[0] * w[0] + w[1] * w[1] + t * t <= r->radius * r->radius)
		extend(range, r->a[2] + t);
}

bool ts_round_span(const struct ts_round *r, double x, double y, double *nearest, double *farthest)
{
	struct range range = { -HUGE_VAL, HUGE_VAL };

	if (r->kind == TS_ITEM_CONE && r->length > 0) {
		meet_mantle(&range, r, r->radius / r->length, x, y);
		meet_base(&range, r, x, y);
	} else {
		meet_ball(&range, r->a, r->radius, x, y);
		if (r->kind == TS_ITEM_ROD) {
			meet_ball(&range, r->b, r->radius, x, y);
			meet_mantle(&range, r, 0, x, y);
		}
	}
	*nearest = range.nearest;
	*farthest = range.farthest;
	return range.nearest >= range.farthest;
}

static void store(const double from[3], float n[3])
{
	const double length = ts_norm(from), size = length > 0 ? length : 1;

	n[0] = (float)(from[0] / size);
	n[1] = (float)(-from[1] / size);
	n[2] = (float)(from[2] / size);
}

void ts_round_normal(const struct ts_round *r, double x, double y, double z, float n[3])
{
	double w[3] = { x - r->a[0], y - r->a[1], z - r->a[2] };
	const double s = ts_dot(w, r->u), inside = fmin(fmax(s, 0), r->length);
	double away;

	for (int k = 0; k < 3; k++)
		w[k] -= (r->kind == TS_ITEM_CONE ? s : inside) * r->u[k];
	away = ts_norm(w);
	if (r->kind == TS_ITEM_CONE && r->length > 0) {
		const double slope = r->radius / r->length;

		if (fabs(s) < fabs(away - (r->radius - slope * s))) { /* the base */
			ts_scale(-1, r->u, w);
		} else if (away > 0) {
			for (int k = 0; k < 3; k++)
				w[k] = w[k] / away + slope * r->u[k];
		}
	}
	store(w, n);
}
