#include "coupling/interpolation_weights.h"

#include "base/inline.h"
#include "coupling/axis_points.h"

#include "base/banned.h"

const char *const ts_coupling_interpolation_names[] = { "linear", "cell", NULL };

TS_INLINE void set_axis(struct ts_coupling_weights *out, int d, const struct ts_axis_points *points)
{
	out->index[d][0] = points->low;
	out->index[d][1] = points->high;
	out->weight[d][0] = 1 - points->share;
	out->weight[d][1] = points->share;
}

void ts_coupling_weights_centre(const struct ts_fluid *fluid, const double place[3], const int cell[3],
				enum ts_coupling_interpolation how, struct ts_coupling_weights *out)
{
	for (int d = 0; d < 3; d++) {
		struct ts_axis_points points =
			ts_axis_points_centres(&fluid->grid, d, place[d], cell[d], how);

		set_axis(out, d, &points);
	}
}

void ts_coupling_weights_faces(const struct ts_fluid *fluid, const double place[3], const int cell[3],
			       enum ts_coupling_interpolation how, struct ts_coupling_weights out[3])
{
	for (int d = 0; d < 3; d++) {
		struct ts_axis_points centres =
			ts_axis_points_centres(&fluid->grid, d, place[d], cell[d], how);

		for (int c = 0; c < 3; c++)
			set_axis(&out[c], d, &centres);
		if (fluid->grid.ghosts[d]) {
			struct ts_axis_points faces =
				ts_axis_points_faces(&fluid->grid, d, place[d], cell[d], how);

			set_axis(&out[d], d, &faces);
		}
	}
}

/* Two points beside each other along x, and their weights, in registers: a load of two numbers behind stores of one
 * waits for the stores. */
typedef double pair __attribute__((vector_size(16)));
#define PAIR(a) ((pair){ (a)[0], (a)[1] })
#define PAIR_AT(field, row) ((pair){ (field)[(row)->at[0]], (field)[(row)->at[1]] })

enum { ROWS = 4 };

struct row {
	ptrdiff_t at[2]; /* indices in a field */
	pair weight;
};

/* Row k of the points: k & 1 along y, k >> 1 along z. */
TS_INLINE struct row find_row(const struct ts_grid *grid, const struct ts_coupling_weights *s, int k)
{
	const int y = k & 1, z = k >> 1;
	const ptrdiff_t base =
		(ptrdiff_t)grid->origin + s->index[1][y] * grid->stride[1] + s->index[2][z] * grid->stride[2];

	return (struct row){ { base + s->index[0][0], base + s->index[0][1] },
			     PAIR(s->weight[0]) * s->weight[1][y] * s->weight[2][z] };
}

/* Terms of points without weight are 0, whatever their fields are. The order of the sum is fixed. */
TS_INLINE double add_terms(double sum, const struct row *row, pair term)
{
	sum += row->weight[0] != 0 ? term[0] : 0;
	return sum + (row->weight[1] != 0 ? term[1] : 0);
}

double ts_coupling_interpolate(const struct ts_grid *grid, const struct ts_coupling_weights *s,
			       const double *field)
{
	double sum = 0;

#pragma GCC unroll 4
	for (int k = 0; k < ROWS; k++) {
		const struct row row = find_row(grid, s, k);

		sum = add_terms(sum, &row, row.weight * PAIR_AT(field, &row));
	}
	return sum;
}

double ts_coupling_interpolate_gradient(const struct ts_grid *grid, const struct ts_coupling_weights *s,
					int c, const double *field)
{
	const double gap[2] = { grid->gap[c][s->index[c][0]], grid->gap[c][s->index[c][1]] };
	const double *below = field - grid->stride[c];
	double sum = 0;

#pragma GCC unroll 4
	for (int k = 0; k < ROWS; k++) {
		const struct row row = find_row(grid, s, k);
		const double other = gap[c == 1 ? k & 1 : k >> 1];
		const pair by = { c == 0 ? gap[0] : other, c == 0 ? gap[1] : other };

		sum = add_terms(sum, &row, row.weight * (PAIR_AT(field, &row) - PAIR_AT(below, &row)) / by);
	}
	return sum;
}

/* Two of the points may be the same one. */
TS_INLINE void add_to_points(const struct row *row, pair amount, double *field)
{
	if (row->weight[0] != 0)
		field[row->at[0]] += amount[0];
	if (row->weight[1] != 0)
		field[row->at[1]] += amount[1];
}

double ts_coupling_distribute_force(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c,
				    const double *q, double amount, double slope, double *source,
				    double *rate)
{
	double width[3][2], sum = 0;

	for (int d = 0; d < 3; d++) {
		const double *of = d == c && grid->ghosts[d] ? grid->gap[d] : grid->width[d];

		width[d][0] = d == 2 && grid->by_depth ? 1 : of[s->index[d][0]];
		width[d][1] = d == 2 && grid->by_depth ? 1 : of[s->index[d][1]];
	}
#pragma GCC unroll 4
	for (int k = 0; k < ROWS; k++) {
		const struct row row = find_row(grid, s, k);
		const pair volume = PAIR(width[0]) * width[1][k & 1] * width[2][k >> 1];
		const pair value = PAIR_AT(q, &row);

		sum = add_terms(sum, &row, row.weight * value);
		add_to_points(&row, row.weight * (slope * value - amount) / volume, source);
		if (rate)
			add_to_points(&row, row.weight * slope / volume, rate);
	}
	return sum;
}
