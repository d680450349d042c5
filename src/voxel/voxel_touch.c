#include "voxel/voxel_touch.h"

#include "base/banned.h"

struct search {
	const struct ts_voxel_field *f;
	double x[3];		      /* along the axes of the field */
	double aside;		      /* reach across the axis of the heights, for the highest column */
	double reach, reach2;	      /* reach2: its square, enlarged by more than rounding */
	bool all;		      /* false: only the nearest point is needed */
	struct ts_voxel_contact *out; /* [most] of all */
	size_t n, most;
	ts_voxel_contact_fn *take; /* NULL, or called for each */
	void *context;
	double least2;	    /* square of the least distance found, */
	int64_t nearest[2]; /* its column, */
	double from[3];	    /* and the vector from that point to x, along the axes of the field */
};

/* The nearest point of a column, and on which of its borders that lies. */
struct nearest {
	double p[3];
	int towards[2]; /* the neighbour across the border on which p lies, -1 or 1; 0: p is inside */
	bool beyond[2]; /* the centre is beyond this border, not on it */
};

/* Distance of x[d] from the interval lo .. hi, with the sign of its direction. */
static double offset(double x, double lo, double hi)
{
	return x < lo ? x - lo : x > hi ? x - hi : 0;
}

static void find_nearest(const struct search *s, int64_t i, int64_t j, double top, struct nearest *near)
{
	const int64_t column[2] = { i, j };

	for (int d = 0; d < 2; d++) {
		double lo = ts_voxel_border(s->f, d, column[d]);
		double hi = ts_voxel_border(s->f, d, column[d] + 1), x = s->x[d];

		near->p[d] = x < lo ? lo : x > hi ? hi : x;
		near->towards[d] = x <= lo ? -1 : x >= hi ? 1 : 0;
		near->beyond[d] = x < lo || x > hi;
	}
	near->p[2] = s->x[2] > top ? top : s->x[2] < s->f->base ? s->f->base : s->x[2];
}

/* Steps up to this one are none, see voxel_touch.h. */
static double least_step(const struct ts_voxel_field *f, double height)
{
	return 1e-9 * fmin(f->width[0], f->width[1]) + 1e-14 * fabs(height);
}

/* Whether the neighbour at di, dj contains the point and has a nearer one, or owns it. */
static bool is_covered_by(const struct search *s, int64_t i, int64_t j, const struct nearest *near, int di,
			  int dj)
{
	const double top = ts_voxel_top(s->f, i + di, j + dj), height = near->p[2];
	const bool above = s->x[2] > height, owns = dj > 0 || (dj == 0 && di > 0);

	if ((di && near->beyond[0]) || (dj && near->beyond[1]))
		return top >= (above ? height - least_step(s->f, height) : height);
	return top >= height && ((above && top > height) || owns);
}

static bool is_covered(const struct search *s, int64_t i, int64_t j, const struct nearest *near)
{
	int di = near->towards[0], dj = near->towards[1];

	return (di && is_covered_by(s, i, j, near, di, 0)) || (dj && is_covered_by(s, i, j, near, 0, dj)) ||
	       (di && dj && is_covered_by(s, i, j, near, di, dj));
}

static double length_of(const double r[3])
{
	/* along one axis the distance is exact, as at a plane */
	for (int d = 0; d < 3; d++)
		if (fabs(r[d]) > 0 && !(fabs(r[(d + 1) % 3]) > 0) && !(fabs(r[(d + 2) % 3]) > 0))
			return fabs(r[d]);
	return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}

static void set_contact(const struct search *s, int64_t i, int64_t j, const double r[3], double distance,
			struct ts_voxel_contact *to)
{
	to->column[0] = i;
	to->column[1] = j;
	to->distance = distance;
	for (int d = 0; d < 3; d++)
		to->n[s->f->axis[d]] = distance > 0 ? r[d] / distance : 0;
}

static void add_contact(struct search *s, int64_t i, int64_t j, const double r[3])
{
	double distance = length_of(r);

	if (!(distance < s->reach))
		return;
	if (s->take) {
		struct ts_voxel_contact c;

		set_contact(s, i, j, r, distance, &c);
		s->take(s->context, &c);
	}
	if (s->n++ < s->most)
		set_contact(s, i, j, r, distance, &s->out[s->n - 1]);
}

static void keep_nearest(struct search *s, int64_t i, int64_t j, const double r[3], double r2)
{
	s->least2 = s->reach2 = r2; /* only nearer columns matter from now on */
	s->nearest[0] = i;
	s->nearest[1] = j;
	for (int d = 0; d < 3; d++)
		s->from[d] = r[d];
}

static void visit_column(struct search *s, int64_t i, int64_t j)
{
	double top = ts_voxel_top(s->f, i, j), r[3], r2;
	struct nearest near;

	if (!(top > s->f->base))
		return;
	find_nearest(s, i, j, top, &near);
	for (int d = 0; d < 3; d++)
		r[d] = s->x[d] - near.p[d];
	r2 = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
	if (!(r2 < s->reach2))
		return;
	if (!s->all)
		keep_nearest(s, i, j, r, r2);
	else if (!is_covered(s, i, j, &near))
		add_contact(s, i, j, r);
}

/* The columns from lo to hi, exclusive, of the periodic image whose first column is at `first`. */
struct range {
	int64_t first[2], lo[2], hi[2];
};

static int64_t larger(int64_t a, int64_t b)
{
	return a > b ? a : b;
}

static int64_t smaller(int64_t a, int64_t b)
{
	return a < b ? a : b;
}

/* Whether block b of level l may have a column within reach. */
static bool is_near(const struct search *s, int l, const int64_t b[2], const struct range *range)
{
	const struct ts_voxel_field *f = s->f;
	double top = f->level[l].top[b[1] * f->level[l].n[0] + b[0]], r2 = 0;

	if (!(top > f->base))
		return false;
	for (int d = 0; d < 2; d++) {
		int64_t lo = b[d] << TS_VOXEL_SHIFT * l, hi = (b[d] + 1) << TS_VOXEL_SHIFT * l;
		double r;

		lo = larger(lo, range->lo[d]);
		hi = smaller(hi, range->hi[d]);
		r = offset(s->x[d], ts_voxel_border(f, d, range->first[d] + lo),
			   ts_voxel_border(f, d, range->first[d] + hi));
		r2 += r * r;
	}
	r2 += offset(s->x[2], f->base, top) * offset(s->x[2], f->base, top);
	return r2 < s->reach2;
}

static void visit_block(struct search *s, int l, int64_t bi, int64_t bj, const struct range *range)
{
	const int64_t b[2] = { bi, bj };
	int64_t lo[2], hi[2];

	if (!is_near(s, l, b, range))
		return;
	if (l == 0) {
		visit_column(s, range->first[0] + bi, range->first[1] + bj);
		return;
	}
	for (int d = 0; d < 2; d++) {
		lo[d] = larger(b[d] << TS_VOXEL_SHIFT, range->lo[d] >> TS_VOXEL_SHIFT * (l - 1));
		hi[d] = smaller(((b[d] + 1) << TS_VOXEL_SHIFT) - 1,
				(range->hi[d] - 1) >> TS_VOXEL_SHIFT * (l - 1));
	}
	for (int64_t j = lo[1]; j <= hi[1]; j++)
		for (int64_t i = lo[0]; i <= hi[0]; i++)
			visit_block(s, l - 1, i, j, range);
}

/* Begins at the level of which at most 2 x 2 blocks cover the range. */
static void visit_range(struct search *s, const struct range *range)
{
	int64_t lo[2], hi[2];
	int l = 0;

	for (;; l++) {
		bool few = true;

		for (int d = 0; d < 2; d++) {
			lo[d] = range->lo[d] >> TS_VOXEL_SHIFT * l;
			hi[d] = (range->hi[d] - 1) >> TS_VOXEL_SHIFT * l;
			few &= hi[d] - lo[d] < 2;
		}
		if (few || l == s->f->nlevels - 1)
			break;
	}
	for (int64_t j = lo[1]; j <= hi[1]; j++)
		for (int64_t i = lo[0]; i <= hi[0]; i++)
			visit_block(s, l, i, j, range);
}

/* The first and last periodic image of the field that has columns within reach along index d. */
static void find_images(const struct search *s, int d, int64_t column[2], int64_t image[2])
{
	const struct ts_voxel_field *f = s->f;

	double aside = s->aside + 1e-15 * (fabs(s->x[d]) + fabs(f->origin[d])); /* and rounding */

	column[0] = ts_voxel_index(f, d, s->x[d] - aside);
	column[1] = ts_voxel_index(f, d, s->x[d] + aside);
	for (int k = 0; k < 2; k++)
		image[k] = f->periodic[d] ? ts_voxel_image(f, d, column[k]) : 0;
}

/* Sets the columns of one image along index d; false: there are none within reach. */
static bool set_range(const struct ts_voxel_field *f, int d, int64_t image, const int64_t column[2],
		      struct range *range)
{
	range->first[d] = image * f->n[d];
	range->lo[d] = column[0] - range->first[d];
	range->hi[d] = column[1] + 1 - range->first[d];
	range->lo[d] = larger(range->lo[d], 0);
	range->hi[d] = smaller(range->hi[d], f->n[d]);
	return range->lo[d] < range->hi[d];
}

static void visit_all(struct search *s)
{
	const struct ts_voxel_field *f = s->f;
	double away = offset(s->x[2], f->base, ts_voxel_highest(f));
	int64_t column[2][2], image[2][2];
	struct range range;

	/* above the highest column, as most particles are */
	if (!(away * away < s->reach2))
		return;
	s->aside = sqrt(s->reach2 - away * away);
	for (int d = 0; d < 2; d++)
		find_images(s, d, column[d], image[d]);
	for (int64_t v = image[1][0]; v <= image[1][1]; v++)
		for (int64_t u = image[0][0]; u <= image[0][1]; u++)
			if (set_range(f, 0, u, column[0], &range) && set_range(f, 1, v, column[1], &range))
				visit_range(s, &range);
}

static struct search start_search(const struct ts_voxel_field *f, const double x[3], double reach)
{
	return (struct search){ .f = f,
				.x = { x[f->axis[0]], x[f->axis[1]], x[f->axis[2]] },
				.reach = reach,
				.reach2 = reach * reach * (1 + 1e-12),
				.least2 = INFINITY };
}

size_t ts_voxel_contacts(const struct ts_voxel_field *f, const double x[3], double reach,
			 struct ts_voxel_contact *out, size_t most)
{
	struct search s = start_search(f, x, reach);

	s.all = true;
	s.out = out;
	s.most = most;
	visit_all(&s);
	return s.n;
}

void ts_voxel_contacts_visit(const struct ts_voxel_field *f, const double x[3], double reach,
			     ts_voxel_contact_fn *take, void *context)
{
	struct search s = start_search(f, x, reach);

	s.all = true;
	s.take = take;
	s.context = context;
	visit_all(&s);
}

double ts_voxel_distance(const struct ts_voxel_field *f, const double x[3], double reach)
{
	struct search s = start_search(f, x, reach);

	visit_all(&s);
	return sqrt(s.least2) < reach ? sqrt(s.least2) : INFINITY;
}

bool ts_voxel_nearest(const struct ts_voxel_field *f, const double x[3], double reach,
		      struct ts_voxel_contact *out)
{
	struct search s = start_search(f, x, reach);
	double distance;

	/* most often the nearest one, which leaves few others within reach */
	visit_column(&s, ts_voxel_index(f, 0, s.x[0]), ts_voxel_index(f, 1, s.x[1]));
	if (s.reach2 > 0)
		visit_all(&s);
	if (!isfinite(s.least2))
		return false;
	distance = length_of(s.from);
	set_contact(&s, s.nearest[0], s.nearest[1], s.from, distance, out);
	return distance < reach;
}
