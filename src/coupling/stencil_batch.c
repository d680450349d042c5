#include "base/clones.h"
TS_UNROLLED
#include "coupling/stencil_batch.h"

#include <math.h>
#include <string.h>

#include "base/eight.h"

#include "base/banned.h"

enum { N = TS_STENCIL_BATCH, ROWS = 4, CENTRE = 0, FACE = 1 };

/* ---- stencils */

/* Fills the last four: they are computed as the last particle. Those elsewhere are computed as if in the first cell. */
static void complete(struct ts_stencil_batch *b)
{
	const size_t full = (b->n + 3) / 4 * 4;

	b->some_general = false;
	for (size_t k = b->n; k < full; k++) {
		for (int d = 0; d < 3; d++)
			b->x[d][k] = b->x[d][b->n - 1];
		b->where[k] = b->where[b->n - 1];
	}
	for (size_t k = 0; k < full; k++) {
		b->general[k] = -(long long)(b->where[k] >> 63);
		b->where[k] &= ~TS_HALVES_ELSEWHERE;
	}
}

void ts_stencil_batch_find(struct ts_stencil_batch *b, const struct ts_grid *grid, const double (*x)[3],
			   const size_t *of, size_t n)
{
	b->n = n;
	for (size_t k = 0; k < n; k++)
		for (int d = 0; d < 3; d++)
			b->x[d][k] = x[of[k]][d];
	for (size_t k = n; k % 4; k++)
		for (int d = 0; d < 3; d++)
			b->x[d][k] = 0;
	ts_halves_find_all(grid, (const double *const[3]){ b->x[0], b->x[1], b->x[2] }, n, b->where);
}

typedef const struct ts_grid_half *halves[4];

TS_INLINE void find_halves(const struct ts_grid *grid, const struct ts_stencil_batch *b, int d, size_t k,
			   halves of)
{
#pragma GCC unroll 4
	for (int j = 0; j < 4; j++)
		of[j] = grid->half[d] + ts_halves_of(b->where[k + (size_t)j], d);
}

/* Four numbers of four halves, as columns. */
TS_INLINE void load_columns(const void *const of[4], ts_four column[4])
{
#pragma GCC unroll 4
	for (int j = 0; j < 4; j++)
		column[j] = TS_FOUR_LOAD((const double *)of[j]);
	ts_four_transpose(column);
}

#define COLUMNS_FROM(of, member, column)                                                           \
	load_columns((const void *const[4]){ &(of)[0]->member, &(of)[1]->member, &(of)[2]->member, \
					     &(of)[3]->member },                                   \
		     column)
#define AT(array, k) (*(ts_four_anywhere *)&(array)[k])
#define MARKS_AT(array, k) (*(ts_four_marks_anywhere *)&(array)[k])

/* Shares along axis d. */
TS_INLINE void find_shares(struct ts_stencil_batch *b, halves of, int d, size_t k)
{
	ts_four c[4];

	COLUMNS_FROM(of, centre, c);
	AT(b->share[CENTRE][d], k) = (AT(b->x[d], k) - c[0]) / c[1];
	AT(b->share[FACE][d], k) = (AT(b->x[d], k) - c[2]) / c[3];
}

TS_INLINE void mark_zeros(const struct ts_stencil_batch *b, int d, size_t k, ts_four_marks *general)
{
	for (int p = 0; p < 2; p++)
		*general |= (AT(b->share[p][d], k) == 0) | (1 - AT(b->share[p][d], k) == 0);
}

/* Low and high positions of centres, and of faces, along an axis. */
struct positions {
	ts_four_marks at[4];
};

TS_INLINE void find_positions(halves of, struct positions *p)
{
	ts_four c[4];

	COLUMNS_FROM(of, centre_at, c);
	memcpy(p->at, c, sizeof c);
}

TS_INLINE void set_rows(struct ts_stencil_batch *b, size_t k, const struct positions p[3], ptrdiff_t origin)
{
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++)
#pragma GCC unroll 4
		for (int r = 0; r < ROWS; r++)
			MARKS_AT(b->row[c][r], k) = p[0].at[c == 0 ? 2 : 0] + origin +
						    p[1].at[(c == 1 ? 2 : 0) + (r & 1)] +
						    p[2].at[(c == 2 ? 2 : 0) + (r >> 1)];
}

/* Shares and rows of the points of interpolation_faces.h. */
TS_CLONES
static void find_stencils(struct ts_stencil_batch *b, const struct ts_grid *grid)
{
	ts_four_marks some = { 0 };

	for (size_t k = 0; k < b->n; k += 4) {
		ts_four_marks general = MARKS_AT(b->general, k);
		struct positions p[3];

#pragma GCC unroll 3
		for (int d = 0; d < 3; d++) {
			halves of;

			find_halves(grid, b, d, k, of);
			find_shares(b, of, d, k);
			mark_zeros(b, d, k, &general);
			find_positions(of, &p[d]);
		}
		general |= (p[0].at[1] - p[0].at[0] != 1) | (p[0].at[3] - p[0].at[2] != 1);
		set_rows(b, k, p, (ptrdiff_t)grid->origin);
		MARKS_AT(b->general, k) = general;
		some |= general;
	}
	b->some_general = (some[0] | some[1] | some[2] | some[3]) != 0;
}

TS_CLONES
static void find_widths(struct ts_stencil_batch *b, const struct ts_grid *grid)
{
	for (size_t k = 0; k < b->n; k += 4)
#pragma GCC unroll 3
		for (int d = 0; d < 3; d++) {
			ts_four c[4];
			halves of;

			find_halves(grid, b, d, k, of);
			COLUMNS_FROM(of, centre_width, c);
			AT(b->width[0][d], k) = c[0];
			AT(b->width[1][d], k) = c[1];
			AT(b->gap[0][d], k) = c[2];
			AT(b->gap[1][d], k) = c[3];
		}
}

/* ---- values and weights of four particles */

/* Numbers of a field at the two points of a row. */
TS_INLINE void load_row(const double *field, const ptrdiff_t *row, ts_four value[2])
{
#define TWO(j) (*(const ts_two_anywhere *)(field + row[j]))
	const ts_four even = TS_TWO_JOIN(TWO(0), TWO(2)), odd = TS_TWO_JOIN(TWO(1), TWO(3));
#undef TWO

	value[0] = TS_FOUR_SHUFFLE(even, odd, 0, 4, 2, 6);
	value[1] = TS_FOUR_SHUFFLE(even, odd, 1, 5, 3, 7);
}

/* Weights of component c along the axes: [low, high]. */
struct weights {
	ts_four of[3][2];
};

TS_INLINE void load_weights(const struct ts_stencil_batch *b, int c, size_t k, struct weights *w)
{
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++) {
		w->of[d][1] = AT(b->share[d == c ? FACE : CENTRE][d], k);
		w->of[d][0] = 1 - w->of[d][1];
	}
}

/* Of the two points of row r. */
TS_INLINE void row_weights(const struct weights *w, int r, ts_four weight[2])
{
	weight[0] = w->of[0][0] * w->of[1][r & 1] * w->of[2][r >> 1];
	weight[1] = w->of[0][1] * w->of[1][r & 1] * w->of[2][r >> 1];
}

TS_INLINE void interpolate_four(const struct ts_stencil_batch *b, int c, size_t k, const double *field,
				double *out)
{
	ts_four sum = { 0 };
	struct weights w;

	load_weights(b, c, k, &w);
#pragma GCC unroll 4
	for (int r = 0; r < ROWS; r++) {
		ts_four value[2], weight[2];

		load_row(field, &b->row[c][r][k], value);
		row_weights(&w, r, weight);
		sum += weight[0] * value[0];
		sum += weight[1] * value[1];
	}
	AT(out, k) = sum;
}

TS_CLONES
static void interpolate_all(const struct ts_stencil_batch *b, double *const field[3], double out[3][N])
{
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++)
		for (size_t k = 0; k < b->n; k += 4)
			interpolate_four(b, c, k, field[c], out[c]);
}

TS_INLINE void gradient_four(const struct ts_stencil_batch *b, int c, size_t k, const double *field,
			     ptrdiff_t stride, double *out)
{
	ts_four sum = { 0 };
	struct weights w;

	load_weights(b, c, k, &w);
#pragma GCC unroll 4
	for (int r = 0; r < ROWS; r++) {
		ts_four above[2], below[2], weight[2];

		load_row(field, &b->row[c][r][k], above);
		load_row(field - stride, &b->row[c][r][k], below);
		row_weights(&w, r, weight);
#pragma GCC unroll 2
		for (int i = 0; i < 2; i++) {
			const int side = c == 0 ? i : c == 1 ? r & 1 : r >> 1;

			sum += weight[i] * (above[i] - below[i]) / AT(b->gap[side][c], k);
		}
	}
	AT(out, k) = sum;
}

TS_CLONES
static void gradient_all(const struct ts_stencil_batch *b, const ptrdiff_t stride[3], const double *field,
			 double out[3][N])
{
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++)
		for (size_t k = 0; k < b->n; k += 4)
			gradient_four(b, c, k, field, stride[c], out[c]);
}

/* ---- particles that are not usual ones */

TS_INLINE bool locate(const struct ts_stencil_batch *b, const struct ts_fluid *fluid, size_t k,
		      struct ts_coupling_place *at)
{
	const double x[3] = { b->x[0][k], b->x[1][k], b->x[2][k] };

	at->how = TS_INTERPOLATE_LINEAR;
	return ts_coupling_locate(fluid, x, at->x, at->cell);
}

typedef void one_particle_fn(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
			     const void *field, double value[3]);

static void interpolate_one(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
			    const void *field, double value[3])
{
	ts_coupling_faces_interpolate(fluid, at, field, value);
}

static void gradient_one(const struct ts_fluid *fluid, const struct ts_coupling_place *at, const void *field,
			 double value[3])
{
	ts_coupling_faces_gradient(fluid, at, field, value);
}

/* Sets out[c][k] and inside[k] of the particles that are no usual ones. */
static void take_general(const struct ts_stencil_batch *b, const struct ts_fluid *fluid, one_particle_fn *one,
			 const void *field, double out[3][N], bool inside[N])
{
	memset(inside, true, b->n);
	for (size_t k = 0; k < b->n && b->some_general; k++) {
		struct ts_coupling_place at;
		double value[3];

		if (!b->general[k] || !(inside[k] = locate(b, fluid, k, &at)))
			continue;
		one(fluid, &at, field, value);
		for (int c = 0; c < 3; c++)
			out[c][k] = value[c];
	}
}

void ts_stencil_batch_interpolate(struct ts_stencil_batch *b, const struct ts_fluid *fluid,
				  double *const field[3], double out[3][N], bool inside[N])
{
	complete(b);
	find_stencils(b, &fluid->grid);
	interpolate_all(b, field, out);
	take_general(b, fluid, interpolate_one, field, out, inside);
}

void ts_stencil_batch_gradient(struct ts_stencil_batch *b, const struct ts_fluid *fluid, const double *field,
			       double out[3][N], bool inside[N])
{
	complete(b);
	find_stencils(b, &fluid->grid);
	find_widths(b, &fluid->grid);
	gradient_all(b, fluid->grid.stride, field, out);
	take_general(b, fluid, gradient_one, field, out, inside);
}

/* ---- velocity with the conditions of boundaries */

/* Whether the place is between two points for all components, lest a condition of a wall counts. */
struct bounds {
	double low[3], high[3];
};

/* Along an axis: centres and faces. */
struct open_positions {
	ts_four_marks centre, face;
};

TS_INLINE void find_open_stencil(struct ts_stencil_batch *b, halves of, int d, size_t k,
				 struct open_positions *p)
{
	ts_four c[4], more[4];

	COLUMNS_FROM(of, centre, c);
	COLUMNS_FROM(of, face_distance, more);
	AT(b->share[CENTRE][d], k) = (AT(b->x[d], k) - c[0]) / c[1];
	AT(b->share[FACE][d], k) = (AT(b->x[d], k) - c[2]) / more[0];
	memcpy(&p->centre, &more[1], sizeof p->centre);
	memcpy(&p->face, &more[2], sizeof p->face);
}

/* The first point of each component in row[c][0], of centres in row[0][1]. */
TS_CLONES
static void find_open_stencils(struct ts_stencil_batch *b, const struct ts_grid *grid,
			       const struct bounds *bounds)
{
	const ptrdiff_t origin = (ptrdiff_t)grid->origin;
	ts_four_marks some = { 0 };

	for (size_t k = 0; k < b->n; k += 4) {
		ts_four_marks general = MARKS_AT(b->general, k);
		struct open_positions p[3];

#pragma GCC unroll 3
		for (int d = 0; d < 3; d++) {
			const ts_four x = AT(b->x[d], k);
			halves of;

			find_halves(grid, b, d, k, of);
			find_open_stencil(b, of, d, k, &p[d]);
			general |= ~((x >= bounds->low[d]) & (x <= bounds->high[d]));
		}
		MARKS_AT(b->row[0][0], k) = p[0].face + p[1].centre + p[2].centre + origin;
		MARKS_AT(b->row[1][0], k) = p[0].centre + p[1].face + p[2].centre + origin;
		MARKS_AT(b->row[2][0], k) = p[0].centre + p[1].centre + p[2].face + origin;
		MARKS_AT(b->row[0][1], k) = p[0].centre + p[1].centre + p[2].centre + origin;
		MARKS_AT(b->general, k) = general;
		some |= general;
	}
	b->some_general = (some[0] | some[1] | some[2] | some[3]) != 0;
}

/* c 3: all axes with centres. The order of sum_eight of flow/fluid_interpolation.c. */
TS_INLINE void sum_four(const struct ts_stencil_batch *b, int c, size_t k, const ptrdiff_t *first,
			const ptrdiff_t stride[3], const double *field, double *out)
{
	ts_four sum = { 0 };
	struct weights w;

	load_weights(b, c, k, &w);
#pragma GCC unroll 4
	for (int r = 0; r < ROWS; r++) {
		ts_four value[2];

		load_row(field + (r & 1) * stride[1] + (r >> 1) * stride[2], first, value);
		sum += w.of[2][r >> 1] * w.of[1][r & 1] * (w.of[0][0] * value[0] + w.of[0][1] * value[1]);
	}
	AT(out, k) = sum;
}

TS_CLONES
static void sum_all(const struct ts_stencil_batch *b, const ptrdiff_t stride[3], double *const u[3],
		    double out[3][N])
{
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++)
		for (size_t k = 0; k < b->n; k += 4)
			sum_four(b, c, k, &b->row[c][0][k], stride, u[c], out[c]);
}

TS_CLONES
static void sum_centred(const struct ts_stencil_batch *b, const ptrdiff_t stride[3], const double *field,
			double value[N])
{
	for (size_t k = 0; k < b->n; k += 4)
		sum_four(b, 3, k, &b->row[0][1][k], stride, field, value);
}

void ts_stencil_batch_velocity(struct ts_stencil_batch *b, const struct ts_fluid *fluid, double u[3][N],
			       const double *field, double value[N], bool inside[N])
{
	struct bounds bounds;

	for (int d = 0; d < 3; d++)
		ts_fluid_two_points(fluid, d, &bounds.low[d], &bounds.high[d]);
	complete(b);
	find_open_stencils(b, &fluid->grid, &bounds);
	sum_all(b, fluid->grid.stride, fluid->u, u);
	if (field)
		sum_centred(b, fluid->grid.stride, field, value);
	memset(inside, true, b->n);
	for (size_t k = 0; k < b->n && b->some_general; k++) {
		struct ts_coupling_place at;
		double all[3];

		if (!b->general[k] || !(inside[k] = locate(b, fluid, k, &at)))
			continue;
		ts_fluid_velocity_in_cell(fluid, at.x, at.cell, all, field, field ? &value[k] : NULL);
		for (int c = 0; c < 3; c++)
			u[c][k] = all[c];
	}
}

/* ---- reaction */

/* What one component of a batch adds to the points of its stencils. */
struct terms {
	double force[ROWS][2][N], rate[ROWS][2][N];
};

/* Of the control volumes of component c along axis d: [low, high]. */
TS_INLINE void load_widths(const struct ts_stencil_batch *b, int c, size_t k, struct weights *w)
{
#pragma GCC unroll 3
	for (int d = 0; d < 3; d++)
#pragma GCC unroll 2
		for (int i = 0; i < 2; i++)
			w->of[d][i] = d == c ? AT(b->gap[i][d], k) : AT(b->width[i][d], k);
}

TS_INLINE void react_four(const struct ts_stencil_batch *b, int c, size_t k, const double *u,
			  const double *amount, const double *slope, bool rates, struct terms *terms,
			  double *velocity)
{
	const ts_four force = AT(amount, k), by = AT(slope, k);
	struct weights w, width;
	ts_four sum = { 0 };

	load_weights(b, c, k, &w);
	load_widths(b, c, k, &width);
#pragma GCC unroll 4
	for (int r = 0; r < ROWS; r++) {
		ts_four value[2], weight[2], volume[2];

		load_row(u, &b->row[c][r][k], value);
		row_weights(&w, r, weight);
		row_weights(&width, r, volume);
#pragma GCC unroll 2
		for (int i = 0; i < 2; i++) {
			sum += weight[i] * value[i];
			AT(terms->force[r][i], k) = weight[i] * (by * value[i] - force) / volume[i];
			if (rates)
				AT(terms->rate[r][i], k) = weight[i] * by / volume[i];
		}
	}
	AT(velocity, k) = sum;
}

/* Forces, slopes and velocities in columns. */
struct reaction_columns {
	double amount[3][N], slope[3][N], velocity[3][N];
};

TS_CLONES
static void find_terms(const struct ts_stencil_batch *b, const struct ts_fluid *fluid, bool rates,
		       struct reaction_columns *r, struct terms terms[3])
{
#pragma GCC unroll 3
	for (int c = 0; c < 3; c++)
		for (size_t k = 0; k < b->n; k += 4)
			react_four(b, c, k, fluid->u[c], r->amount[c], r->slope[c], rates, &terms[c],
				   r->velocity[c]);
}

static void load_reactions(const struct ts_stencil_reactions *from, size_t n, struct reaction_columns *to)
{
	static const double none[3] = { 0 };

	for (size_t k = 0; k < (n + 3) / 4 * 4; k++) {
		const size_t at = k < n ? k : n - 1;
		const double *slope = from->sloped ? from->slope[at] : none;

		for (int c = 0; c < 3; c++) {
			to->amount[c][k] = from->amount[at][c];
			to->slope[c][k] = slope[c];
		}
	}
}

/* One number after the other: a load of two would wait for the stores of the particle before. */
TS_INLINE void add_terms(const struct ts_stencil_batch *b, int c, size_t k, const double terms[ROWS][2][N],
			 double *field)
{
#pragma GCC unroll 4
	for (int r = 0; r < ROWS; r++) {
		double *at = field + b->row[c][r][k];

		at[0] += terms[r][0][k];
		at[1] += terms[r][1][k];
	}
}

static void react_general(const struct ts_stencil_batch *b, struct ts_fluid *fluid, size_t k,
			  const struct ts_stencil_reactions *from)
{
	const struct ts_coupling_reaction reaction = { from->amount[k],
						       from->sloped ? from->slope[k] : NULL,
						       { from->along[0], from->along[1], from->along[2] } };
	struct ts_coupling_place at;

	if (locate(b, fluid, k, &at))
		ts_coupling_faces_react(fluid, &at, &reaction, from->velocity[k]);
}

void ts_stencil_batch_react(struct ts_stencil_batch *b, struct ts_fluid *fluid,
			    const struct ts_stencil_reactions *from)
{
	struct reaction_columns columns;
	struct terms terms[3];

	complete(b);
	find_stencils(b, &fluid->grid);
	find_widths(b, &fluid->grid);
	load_reactions(from, b->n, &columns);
	find_terms(b, fluid, from->sloped, &columns, terms);
	for (size_t k = 0; k < b->n; k++) {
		if (b->general[k]) {
			react_general(b, fluid, k, from);
			continue;
		}
		for (int c = 0; c < 3; c++) {
			if (!from->along[c])
				continue;
			add_terms(b, c, k, (const double(*)[2][N])terms[c].force, fluid->force[c]);
			if (from->sloped)
				add_terms(b, c, k, (const double(*)[2][N])terms[c].rate, fluid->exchange[c]);
			if (from->velocity[k])
				from->velocity[k][c] = columns.velocity[c][k];
		}
	}
}
