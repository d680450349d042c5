#include "base/clones.h"
TS_UNROLLED
#include "coupling/volume_batch.h"

#include <math.h>
#include <string.h>

#include "base/four.h"
#include "geom/ball_corner.h"
#include "geom/ball_edges.h"

#include "base/banned.h"

enum { N = TS_VOLUME_BATCH };

bool ts_volume_batch_possible(const struct ts_grid *grid, const struct ts_coupling_volume *how)
{
	if (how->method != TS_VOLUME_DIVIDED || how->disc || grid->dimensions < 3 || grid->size > INT32_MAX)
		return false;
	return grid->uniform[0] && grid->uniform[1] && grid->uniform[2];
}

/* ---- cells. Indices are doubles, so that all columns have the same width */

#define AT(array, k) (*(ts_four_anywhere *)&(array)[k])
#define MARKS_AT(array, k) (*(ts_four_marks_anywhere *)&(array)[k])

/* yes where marked, else no */
#define CHOOSE(marks, yes, no) \
	((ts_four)(((ts_four_marks)(yes) & (marks)) | ((ts_four_marks)(no) & ~(marks))))
#define WHERE(marks, yes) ((ts_four)((ts_four_marks)(yes) & (marks)))

/* One or two cells along each axis: the first, whether there are two, the face between them in units of the radius. */
struct spans {
	double cell[3][N], face[3][N]; /* of the place: index, and its lower face */
	double first[3][N], cut[3][N];
	long long two[3][N];
	long long general[N]; /* there are more than two along an axis */
};

/* Fills the last four: they are computed as the last particle. */
static void complete(struct ts_volume_batch *b)
{
	for (size_t k = b->n; k % 4; k++) {
		for (int d = 0; d < 3; d++)
			b->x[d][k] = b->x[d][k - 1];
		b->radius[k] = b->radius[k - 1];
		b->where[k] = b->where[k - 1];
	}
}

static void find_faces(const struct ts_volume_batch *b, const struct ts_grid *grid, struct spans *s)
{
	for (size_t k = 0; k < (b->n + 3) / 4 * 4; k++)
#pragma GCC unroll 3
		for (int d = 0; d < 3; d++) {
			const int cell = ts_halves_of(b->where[k], d) / 2;

			s->cell[d][k] = cell;
			s->face[d][k] = grid->face[d][cell];
		}
}

/* find_few of volume_distribution.c, along axis d. */
TS_INLINE void find_span(const struct ts_volume_batch *b, const struct ts_grid *grid, int d, size_t k,
			 struct spans *s)
{
	const double n = grid->n[d], width = grid->width[d][0];
	const long long periodic = grid->periodic[d] ? -1 : 0;
	const ts_four r = AT(b->radius, k), cell = AT(s->cell[d], k);
	const ts_four at = AT(s->face[d], k) - AT(b->x[d], k), stepped = at - width;
	const ts_four_marks below = (at > -r) & ((cell > 0) | periodic);
	const ts_four first = cell - WHERE(below, TS_FOUR_BROADCAST(1.0));
	const ts_four low = CHOOSE(below, stepped, at) + width, high = low + width;
	const ts_four_marks two = (low < r) & ((first + 1 < n) | periodic);

	MARKS_AT(s->general, k) |= (below & (stepped > -r) & ((first > 0) | periodic)) |
				   (two & (high < r) & ((first + 2 < n) | periodic));
	MARKS_AT(s->two[d], k) = two;
	AT(s->cut[d], k) = WHERE(two, low / r);
	AT(s->first[d], k) = first + WHERE(first < 0, TS_FOUR_BROADCAST(n));
}

TS_CLONES
static void find_spans(const struct ts_volume_batch *b, const struct ts_grid *grid, struct spans *s)
{
	for (size_t k = 0; k < b->n; k += 4) {
		MARKS_AT(s->general, k) = (ts_four_marks){ 0 };
#pragma GCC unroll 3
		for (int d = 0; d < 3; d++)
			find_span(b, grid, d, k, s);
	}
}

/* Positions in a field. */
struct positions {
	int32_t first[N], step[3][N]; /* from the first cell to the second along each axis */
	int32_t kind[N];	      /* 1, 2, 4: there are two along x, y, z */
};

TS_CLONES
static void find_positions(size_t n, const struct ts_grid *grid, const struct spans *s, struct positions *p)
{
	const int32_t origin = (int32_t)grid->origin;

	for (size_t k = 0; k < n; k++) {
		p->first[k] = origin;
		p->kind[k] = 0;
	}
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++) {
		const double cells = grid->n[d];
		const int32_t stride = (int32_t)grid->stride[d];

#pragma omp simd
		for (size_t k = 0; k < n; k++) {
			const double first = s->first[d][k], step = first + 1 < cells ? 1 : -first;

			p->first[k] += (int32_t)first * stride;
			p->step[d][k] = (int32_t)step * stride;
			p->kind[k] -= (int32_t)s->two[d][k] * (1 << d);
		}
	}
}

/* ---- volumes beyond corners, as ts_ball_corners */

/* Edges of the two faces other than across axis d: the volume beyond them if both faces are at positive coordinates; 0
 * where one is missing, or the edge is outside the ball. */
static void find_edges(size_t n, const struct spans *s, double positive[3][N])
{
	struct ts_ball_edges edges;
	int place[3 * N];
	size_t m = 0;

	_Static_assert(TS_BALL_EDGES >= 3 * N, "edges of a batch");
	for (size_t k = 0; k < n; k++)
#pragma GCC unroll 3
		for (int d = 0; d < 3; d++) {
			const int one = d == 0 ? 1 : 0, other = d == 2 ? 1 : 2;

			const double a = fabs(s->cut[one][k]), b = fabs(s->cut[other][k]);

			edges.a[m] = a;
			edges.b[m] = b;
			place[m] = d * N + (int)k;
			m += ((s->two[one][k] & s->two[other][k]) != 0) & (a * a + b * b < 1);
		}
	memset(positive, 0, 3 * sizeof *positive);
	ts_ball_edges_find(&edges, m);
	for (size_t e = 0; e < m; e++)
		(&positive[0][0])[place[e]] = 2 * edges.volume[e];
}

static void find_inner_corners(size_t n, const struct spans *s, const struct positions *p, double inner[N])
{
	for (size_t k = 0; k < n; k++)
		inner[k] = p->kind[k] == 7 ? ts_ball_corner(fabs(s->cut[0][k]), fabs(s->cut[1][k]),
							    fabs(s->cut[2][k]))
					   : 0;
}

/* Volumes beyond a face at x, and at -x, of four particles. */
struct cap {
	ts_four x, beyond, below;
	ts_four_marks negative;
};

TS_INLINE void cap_volumes(const ts_four *x, ts_four *volume)
{
	const ts_four low = CHOOSE(*x < -1, TS_FOUR_BROADCAST(-1.0), *x);
	const ts_four a = CHOOSE(low > 1, TS_FOUR_BROADCAST(1.0), low);

	*volume = TS_PI / 3 * (1 - a) * (1 - a) * (2 + a);
}

TS_INLINE void find_cap(const double *at, struct cap *cap)
{
	ts_four other;

	cap->x = TS_FOUR_LOAD(at);
	other = -cap->x;
	cap_volumes(&cap->x, &cap->beyond);
	cap_volumes(&other, &cap->below);
	cap->negative = cap->x < 0;
}

/* x >= a, y >= b, from the volume beyond (|a|, |b|). */
TS_INLINE void reflect_edge(const struct cap *a, const struct cap *b, const ts_four *positive,
			    ts_four *volume)
{
	const ts_four under = b->beyond - CHOOSE(b->negative, a->below - *positive, *positive);
	const ts_four over = CHOOSE(b->negative, a->beyond - *positive, *positive);

	*volume = CHOOSE(a->negative, under, over);
}

/* The same beyond |a|. */
TS_INLINE void reflect_edge_beside(const struct cap *a, const struct cap *b, const ts_four *positive,
				   ts_four *volume)
{
	const ts_four cap = CHOOSE(a->negative, a->below, a->beyond);

	*volume = CHOOSE(b->negative, cap - *positive, *positive);
}

TS_INLINE void reflect_cap(const struct cap *a, double whole, ts_four *volume)
{
	*volume = CHOOSE(a->negative, whole - a->below, a->beyond);
}

TS_INLINE void reflect_corner(const struct cap c[3], const ts_four positive[3], const ts_four *inner,
			      ts_four *volume)
{
	const ts_four over_z = CHOOSE(c[2].negative, positive[2] - *inner, *inner);
	ts_four beside, edge, over_y;

	reflect_edge_beside(&c[0], &c[2], &positive[1], &beside);
	over_y = CHOOSE(c[1].negative, beside - over_z, over_z);
	reflect_edge(&c[1], &c[2], &positive[0], &edge);
	*volume = CHOOSE(c[0].negative, edge - over_y, over_y);
}

/* Beyond both faces across x and y. */
TS_INLINE void reflect_first_edge(const struct cap c[3], double whole, const ts_four *positive,
				  ts_four *volume)
{
	ts_four cap, edge;

	reflect_cap(&c[1], whole, &cap);
	reflect_edge(&c[0], &c[1], positive, &edge);
	*volume = CHOOSE(c[0].negative & c[1].negative, cap - (c[0].below - *positive), edge);
}

/* The eight corners of four particles; those without a face are 0. */
TS_INLINE void find_corners(const struct spans *s, const double positive[3][N], const double inner[N],
			    size_t k, ts_four out[8])
{
	const double whole = ts_ball_cap(-1);
	const ts_four edge[3] = { TS_FOUR_LOAD(&positive[0][k]), TS_FOUR_LOAD(&positive[1][k]),
				  TS_FOUR_LOAD(&positive[2][k]) };
	const ts_four in = TS_FOUR_LOAD(&inner[k]);
	const ts_four_marks x = MARKS_AT(s->two[0], k), y = MARKS_AT(s->two[1], k),
			    z = MARKS_AT(s->two[2], k);
	struct cap c[3];

#pragma GCC unroll 3
	for (int d = 0; d < 3; d++)
		find_cap(&s->cut[d][k], &c[d]);
	out[0] = TS_FOUR_BROADCAST(whole);
	reflect_cap(&c[0], whole, &out[1]);
	reflect_cap(&c[1], whole, &out[2]);
	reflect_first_edge(c, whole, &edge[2], &out[3]);
	out[4] = c[2].beyond;
	reflect_edge(&c[0], &c[2], &edge[1], &out[5]);
	reflect_edge(&c[1], &c[2], &edge[0], &out[6]);
	reflect_corner(c, edge, &in, &out[7]);
#pragma GCC unroll 8
	for (int m = 1; m < 8; m++)
		out[m] = WHERE((m & 1 ? x : x | -1) & (m & 2 ? y : y | -1) & (m & 4 ? z : z | -1), out[m]);
}

/* Parts of the cells from what is beyond corners, part_of_corners of volume_distribution.c. */
TS_INLINE void find_parts(const ts_four corner[8], ts_four part[8])
{
	ts_four layer[2][4];

#pragma GCC unroll 2
	for (int side = 0; side < 2; side++) {
		const ts_four *at = corner + 4 * side;

		layer[side][0] = at[0] - at[1] - at[2] + at[3];
		layer[side][1] = at[1] - at[3];
		layer[side][2] = at[2] - at[3];
		layer[side][3] = at[3];
	}
#pragma GCC unroll 4
	for (int m = 0; m < 4; m++) {
		part[m] = layer[0][m] - layer[1][m];
		part[4 + m] = layer[1][m];
	}
}

/* What each particle adds to its eight cells. */
TS_CLONES
static void find_fractions(size_t n, const struct spans *s, const double positive[3][N],
			   const double inner[N], const double radius[N], double volume,
			   double fraction[8][N])
{
	for (size_t k = 0; k < n; k += 4) {
		const ts_four r = TS_FOUR_LOAD(&radius[k]), unit = r * r * r;
		ts_four corner[8], part[8];

		find_corners(s, positive, inner, k, corner);
		find_parts(corner, part);
#pragma GCC unroll 8
		for (int m = 0; m < 8; m++)
			AT(fraction[m], k) = WHERE(part[m] > 0, part[m]) * unit / volume;
	}
}

/* ---- sums */

TS_INLINE void add_kind(int kind, const struct positions *p, const double part[8][N], size_t k,
			double *fraction)
{
	double *first = fraction + p->first[k];

#pragma GCC unroll 8
	for (int m = 0; m < 8; m++)
		if ((m & ~kind) == 0)
			first[(m & 1 ? p->step[0][k] : 0) + (m & 2 ? p->step[1][k] : 0) +
			      (m & 4 ? p->step[2][k] : 0)] += part[m][k];
}

static void add_parts(const struct positions *p, const double part[8][N], size_t k, double *fraction)
{
	switch (p->kind[k]) {
	case 0:
		add_kind(0, p, part, k, fraction);
		break;
	case 1:
		add_kind(1, p, part, k, fraction);
		break;
	case 2:
		add_kind(2, p, part, k, fraction);
		break;
	case 3:
		add_kind(3, p, part, k, fraction);
		break;
	case 4:
		add_kind(4, p, part, k, fraction);
		break;
	case 5:
		add_kind(5, p, part, k, fraction);
		break;
	case 6:
		add_kind(6, p, part, k, fraction);
		break;
	default:
		add_kind(7, p, part, k, fraction);
	}
}

static void add_any(const struct ts_volume_batch *b, const struct ts_grid *grid,
		    const struct ts_coupling_volume *how, size_t k, double *fraction)
{
	const double place[3] = { b->x[0][k], b->x[1][k], b->x[2][k] };
	int cell[3];

	for (int d = 0; d < 3; d++)
		cell[d] = ts_halves_of(b->where[k], d) / 2;
	ts_coupling_volume_add(grid, how, place, cell, b->radius[k], fraction);
}

void ts_volume_batch_add(struct ts_volume_batch *b, const struct ts_grid *grid,
			 const struct ts_coupling_volume *how, double *fraction)
{
	double positive[3][N], inner[N], part[8][N];
	struct positions positions;
	struct spans spans;

	complete(b);
	find_faces(b, grid, &spans);
	find_spans(b, grid, &spans);
	find_positions(b->n, grid, &spans, &positions);
	find_edges(b->n, &spans, positive);
	find_inner_corners(b->n, &spans, &positions, inner);
	find_fractions(b->n, &spans, (const double(*)[N])positive, inner, b->radius,
		       ts_grid_volume(grid, 0, 0, 0), part);
	for (size_t k = 0; k < b->n; k++) {
		if (spans.general[k])
			add_any(b, grid, how, k, fraction);
		else
			add_parts(&positions, (const double(*)[N])part, k, fraction);
	}
}
