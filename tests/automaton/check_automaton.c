/* The rules of the granular automaton: laws for all pairs of directions, walls, paths of single granules, the order of
 * updates, conservation, independence of threads; both orders of updates give the same flow. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "automaton/draws.h"
#include "automaton/step.h"
#include "base/alloc.h"
#include "deck.h"

static struct ts_laws laws_of(double ep, double ew, double r)
{
	return (struct ts_laws){ .pair = (uint32_t)lround(65536 * (1 + ep) / 2),
				 .wall_restitution = (uint32_t)lround(65536 * ew),
				 .roughness = (uint32_t)lround(65536 * r) };
}

static struct ts_automaton_lattice lattice_of(int nx, int ny, double fill, uint64_t seed, int order)
{
	struct ts_automaton_lattice l = { 0 };

	ck_assert(ts_automaton_make(&l, nx, ny));
	l.open = ts_automaton_count_open(&l);
	ts_automaton_place(&l, seed, lround(fill * (double)l.open), TS_CELL_ONE / 10);
	ck_assert(ts_automaton_step_make(&l, (enum ts_automaton_order)order));
	return l;
}

static int64_t count_granules(const struct ts_automaton_lattice *l)
{
	int64_t n = 0;

	for (int y = 0; y < l->ny; y++)
		for (int x = 0; x < l->nx; x++)
			n += ts_cell_is_granule(l->cell[ts_automaton_at(l, x, y)]);
	return n;
}

START_TEST(cells_keep_what_is_put)
{
	for (unsigned d = 0; d < 8; d++) {
		const uint32_t w = ts_cell_granule(TS_CELL_ONE, TS_CELL_LOW - 3, d);
		const double angle = atan2(ts_cell_dy(d), ts_cell_dx(d));

		ck_assert(ts_cell_is_granule(w) && ts_cell_state(w) == TS_CELL_GRANULE);
		ck_assert(ts_cell_speed(w) == TS_CELL_ONE && ts_cell_direction(w) == d);
		ck_assert(ts_cell_direction_of(ts_cell_dx(d), ts_cell_dy(d)) == d);
		DECK_NEAR(remainder(angle - 0.25 * d * acos(-1), 2 * acos(-1)), 0, 1e-12);
		ck_assert(ts_cell_turned(w, 7, 7 - d) == ts_cell_granule(7, TS_CELL_LOW - 3, 7 - d));
	}
	ck_assert(!ts_cell_is_granule(ts_cell_fixed(TS_CELL_OBSTACLE)));
}
END_TEST

static bool pair(const struct ts_laws *laws, unsigned normal, struct ts_laws_velocity *v1,
		 struct ts_laws_velocity *v2)
{
	const int closing = ts_laws_closing(normal, *v1, *v2);
	const int d = closing > 0 ? ts_laws_impulse(laws, normal, closing) : 0;

	*v1 = ts_laws_changed(*v1, normal, -d);
	*v2 = ts_laws_changed(*v2, normal, d);
	return closing > 0;
}

/* (8) and (9) for all directions of both granules and all lines of centres: momentum is kept exactly, the component
 * across the line is kept, the relative velocity along it is reversed and multiplied by e, and the energy lost is
 * (1 - e^2)/4 of the square of the relative velocity along the line. */
START_TEST(pair_laws)
{
	static const double e[] = { 0, 0.385, 0.85, 1 };

	for (int k = 0; k < 4; k++)
		for (int all = 0; all < 512; all++) {
			const struct ts_laws laws = laws_of(e[k], 0, 0);
			const unsigned n = (unsigned)all & 7;
			const uint32_t w1 = ts_cell_granule(5387, 0, (unsigned)all >> 3 & 7),
				       w2 = ts_cell_granule(2719, 0, (unsigned)all >> 6);
			const struct ts_laws_velocity a = ts_laws_velocity_of(w1),
						      b = ts_laws_velocity_of(w2);
			struct ts_laws_velocity v = a, w = b;
			const int dx = ts_cell_dx(n), dy = ts_cell_dy(n), norm = dx * dx + dy * dy;
			const int before = (a.x - b.x) * dx + (a.y - b.y) * dy;
			const bool met = pair(&laws, n, &v, &w);
			const int after = (v.x - w.x) * dx + (v.y - w.y) * dy;
			const double energy = 0.5 * (a.x * (double)a.x + a.y * (double)a.y +
						     b.x * (double)b.x + b.y * (double)b.y),
				     left = 0.5 * (v.x * (double)v.x + v.y * (double)v.y + w.x * (double)w.x +
						   w.y * (double)w.y);

			ck_assert(met == (before > 0));
			ck_assert(v.x + w.x == a.x + b.x && v.y + w.y == a.y + b.y);
			ck_assert((v.x - a.x) * dy == (v.y - a.y) * dx); /* along the line */
			if (!met) {
				ck_assert(v.x == a.x && v.y == a.y);
				continue;
			}
			/* impulses are integers: half a unit each, twice on a diagonal */
			ck_assert_msg(fabs(after + e[k] * before) <= norm + 0.2, "%d -> %d", before, after);
			DECK_NEAR(energy - left, (1 - e[k] * e[k]) / 4 * (double)before * before / norm,
				  1.1 * before + 2);
		}
}
END_TEST

/* The speed and the direction that stand for a velocity: their mean over all random numbers is the velocity. */
START_TEST(directions_have_the_right_mean)
{
	static const struct ts_laws_velocity v[] = { { 5000, 1234 },  { -1234, 5000 }, { -77, -78 },
						     { 3000, -3000 }, { 0, -1 },       { 8192, 1 } };
	struct ts_laws laws = laws_of(1, 1, 0);

	for (size_t k = 0; k < DECK_LENGTH(v); k++) {
		double sx = 0, sy = 0;

		for (unsigned r = 0; r < 65536; r++) {
			const uint32_t w = ts_laws_turn(&laws, ts_cell_granule(1, 5, 0), v[k], r);
			const struct ts_laws_velocity u = ts_laws_velocity_of(w);

			ck_assert(!ts_laws_is_clipped(v[k]) &&
				  ts_cell_speed(w) == abs(abs(v[k].x) > abs(v[k].y) ? v[k].x : v[k].y));
			sx += u.x / 65536.0;
			sy += u.y / 65536.0;
		}
		DECK_NEAR(sx, v[k].x, 0.2);
		DECK_NEAR(sy, v[k].y, 0.2);
	}
	laws.directions = TS_LAWS_NEAREST; /* tan 22.5 degrees = 0.41421 */
	ck_assert(ts_cell_direction(ts_laws_turn(&laws, 0, (struct ts_laws_velocity){ 1000, 410 }, 0)) == 0);
	ck_assert(ts_cell_direction(ts_laws_turn(&laws, 0, (struct ts_laws_velocity){ 1000, 418 }, 0)) == 1);
	/* beyond one cell a step; at rest the direction stays */
	ck_assert(ts_cell_speed(ts_laws_turn(&laws, 0, (struct ts_laws_velocity){ 9000, 10 }, 0)) ==
		  TS_CELL_ONE);
	ck_assert(ts_laws_is_clipped((struct ts_laws_velocity){ -8193, 10 }) &&
		  ts_laws_is_clipped((struct ts_laws_velocity){ 0, 8193 }));
	ck_assert(ts_laws_turn(&laws, ts_cell_granule(9, 5, 6), (struct ts_laws_velocity){ 0, 0 }, 0) ==
		  ts_cell_granule(0, 5, 6));
}
END_TEST

/* (6) and (7), with both readings of U in (7). */
START_TEST(wall_laws)
{
	const struct ts_laws_velocity v = { -1500, -4000 };
	struct ts_laws laws = laws_of(1, 0.65, 0.35);
	struct ts_laws_velocity u = ts_laws_wall(&laws, 1, 8192, v);

	DECK_NEAR(u.x, -1500 + 0.35 * (8192 + 1500), 0.5);
	DECK_NEAR(u.y, 8192 - 0.65 * (8192 - 4000), 0.5);
	laws.normal = TS_LAWS_WALL_NORMAL;
	u = ts_laws_wall(&laws, 1, 8192, v);
	DECK_NEAR(u.y, 0.65 * 4000, 0.5);
	u = ts_laws_wall(&laws, 0, 0, v); /* a face across x, at rest */
	DECK_NEAR(u.x, 0.65 * 1500, 0.5);
	DECK_NEAR(u.y, -4000 * 0.65, 0.5);
	laws = laws_of(1, 1, 0); /* smooth and elastic, at rest: reflection */
	u = ts_laws_wall(&laws, 1, 0, v);
	ck_assert(u.x == v.x && u.y == -v.y);
	laws = laws_of(1, 0, 1); /* no slip, no rebound */
	u = ts_laws_wall(&laws, 1, -3000, v);
	ck_assert(u.x == -3000 && u.y == 3000);
}
END_TEST

/* Between smooth elastic walls a granule goes to and fro; it takes one step in each 1/s steps. */
START_TEST(path_of_one_granule)
{
	for (int every = 1; every <= 4; every++)
		for (unsigned d = 0; d < 8; d++) {
			struct ts_automaton_lattice l = { 0 };
			const struct ts_laws laws = laws_of(1, 1, 0);
			struct ts_automaton_count count = { 0 };
			int x = 6, y = 2, dy = ts_cell_dy(d);

			ck_assert(ts_automaton_make(&l, 7, 5));
			l.granules = 1;
			ck_assert(ts_automaton_step_make(&l, TS_AUTOMATON_EXACT));
			l.cell[ts_automaton_at(&l, x, y)] =
				ts_cell_granule((TS_CELL_ONE + every - 1) / every, 0, d);
			for (int t = 1; t <= 60; t++) {
				ts_automaton_step(&l, &laws, TS_AUTOMATON_EXACT, 1, t, 1, &count);
				if (t % every == 0) {
					if (y + dy < 0 || y + dy > 4)
						dy = -dy;
					x = (x + ts_cell_dx(d) + 7) % 7;
					y += dy;
				}
				ck_assert(ts_cell_is_granule(l.cell[ts_automaton_at(&l, x, y)]));
			}
			ck_assert(count.moved == 60 / every && count.due == count.moved &&
				  count.collided == 0);
			ts_automaton_release(&l);
		}
}
END_TEST

/* Around an obstacle: from its face along x, its face along y and its corner. */
START_TEST(faces_of_obstacles)
{
	/* from, direction; direction after the first step */
	static const struct {
		int x, y;
		unsigned from, to;
	} c[] = { { 3, 4, 0, 4 }, { 5, 2, 2, 6 }, { 3, 3, 1, 5 }, { 3, 4, 1, 3 }, { 5, 3, 3, 5 } };

	for (size_t k = 0; k < DECK_LENGTH(c); k++) {
		struct ts_automaton_lattice l = { 0 };
		const struct ts_laws laws = laws_of(1, 1, 0);
		struct ts_automaton_count count = { 0 };
		int x = c[k].x, y = c[k].y;

		ck_assert(ts_automaton_make(&l, 11, 9));
		for (int i = 4; i <= 6; i++)
			for (int j = 4 - (k == 1 || k == 4); j <= 6; j++)
				l.cell[ts_automaton_at(&l, i, j)] = ts_cell_fixed(TS_CELL_OBSTACLE);
		if (k == 4) { /* below: the face along x */
			y = 2;
			x = 6;
		}
		l.granules = 1;
		ck_assert(ts_automaton_step_make(&l, TS_AUTOMATON_EXACT));
		l.cell[ts_automaton_at(&l, x, y)] = ts_cell_granule(TS_CELL_ONE, 0, c[k].from);
		ts_automaton_step(&l, &laws, TS_AUTOMATON_EXACT, 1, 1, 1, &count);
		ck_assert_msg(l.cell[ts_automaton_at(&l, x + ts_cell_dx(c[k].to), y + ts_cell_dy(c[k].to))] ==
				      ts_cell_granule(TS_CELL_ONE, 0, c[k].to),
			      "case %zu", k);
		ts_automaton_release(&l);
	}
}
END_TEST

/* Directions by the table: (8) and (9) for speeds, whose sum is kept; the two ways back are equally frequent. */
START_TEST(table_of_directions)
{
	const struct ts_laws laws = laws_of(0.85, 0.65, 0.35);
	uint32_t w1, w2;

	for (unsigned d = 0; d < 8; d++)
		for (unsigned r = 0; r < 2; r++) {
			w1 = ts_cell_granule(5000, 3, d);
			w2 = ts_cell_granule(1000, 4, 7 - d);
			ts_laws_table_pair(&laws, &w1, &w2, r);
			ck_assert(w1 == ts_cell_granule(1300, 3, (d + (r ? 3 : 5)) % 8));
			ck_assert(w2 == ts_cell_granule(4700, 4, 7 - d));
		}
	/* straight down, and down to the right, on a wall along x with the speed 8000 */
	ck_assert(ts_laws_table_wall(&laws, ts_cell_granule(4000, 0, 6), true, false, 8000) ==
		  ts_cell_granule(8000 - 2600, 0, 2));
	ck_assert(ts_laws_table_wall(&laws, ts_cell_granule(4000, 0, 7), true, false, -8000) ==
		  ts_cell_granule(4000 + 1400, 0, 1));
	ck_assert(ts_laws_table_wall(&laws, ts_cell_granule(4000, 0, 7), true, true, 0) ==
		  ts_cell_granule(2600, 0, 3));
}
END_TEST

static double chi_square(const int *count, int n, double expected)
{
	double sum = 0;

	for (int k = 0; k < n; k++)
		sum += (count[k] - expected) * (count[k] - expected) / expected;
	return sum;
}

/* Upper limit of chi-square with n - 1 degrees of freedom, exceeded with probability 1e-4: E. B. Wilson, M. M. Hilferty,
 * PNAS 17 (1931) 684. */
static double limit(int n)
{
	const double f = n - 1, c = 2 / (9 * f);

	return f * pow(1 - c + 3.719 * sqrt(c), 3);
}

/* All 120 orders of five are equally frequent; of 70, more than are drawn at a time, each entry is equally often at each
 * place. */
START_TEST(orders_are_uniform)
{
	enum { TIMES = 24000, LONG = 70 };
	static int orders[3125], seen[120], places[LONG][LONG];
	int n = 0;

	for (int t = 0; t < TIMES; t++) {
		uint32_t e[5] = { 0, 1, 2, 3, 4 }, f[LONG];
		uint32_t code = 0;

		ts_automaton_shuffle(e, 5, 2385, t);
		for (int k = 0; k < 5; k++)
			code = 5 * code + e[k];
		orders[code]++;
		for (uint32_t k = 0; k < LONG; k++)
			f[k] = k;
		ts_automaton_shuffle(f, LONG, 77, t);
		for (int k = 0; k < LONG; k++)
			places[f[k]][k]++;
	}
	for (int k = 0; k < 3125; k++)
		if (orders[k] > 0 && n < 120)
			seen[n++] = orders[k];
	ck_assert_int_eq(n, 120);
	ck_assert(chi_square(seen, 120, TIMES / 120.0) < limit(120));
	/* sums of rows and of columns are given: (n - 1)^2 degrees of freedom */
	ck_assert(chi_square(&places[0][0], LONG * LONG, (double)TIMES / LONG) <
		  limit((LONG - 1) * (LONG - 1) + 1));
}
END_TEST

/* Granules are neither lost nor made, and none moves by more than one cell: behind each there was one in reach. */
START_TEST(granules_are_kept)
{
	for (int order = 0; order < 2; order++) {
		struct ts_automaton_lattice l = lattice_of(37, 11, 0.6, 5, order);
		struct ts_laws laws = laws_of(0.85, 0.65, 0.65);
		struct ts_automaton_count count = { 0 };
		uint32_t *before = malloc(l.stride * 13 * sizeof *before);

		laws.wall[0] = TS_CELL_ONE;
		ck_assert(before && count_granules(&l) == lround(0.6 * 37 * 11));
		for (int t = 1; t <= 300; t++) {
			memcpy(before, l.cell, l.stride * 13 * sizeof *before);
			ts_automaton_step(&l, &laws, (enum ts_automaton_order)order, 3, t, 1, &count);
			ck_assert(count_granules(&l) == l.granules);
			for (int y = 0; y < l.ny; y++)
				for (int x = 0; x < l.nx; x++) {
					bool near = !ts_cell_is_granule(l.cell[ts_automaton_at(&l, x, y)]);

					for (int k = 0; k < 9; k++)
						near |= ts_cell_is_granule(
							before[ts_automaton_at(&l,
									       (x + k % 3 - 1 + l.nx) % l.nx,
									       y + k / 3 - 1)]);
					ck_assert(near);
					ck_assert(ts_cell_state(l.cell[ts_automaton_at(&l, x, y)]) !=
						  TS_CELL_DUE);
				}
		}
		ck_assert(count.moved > 0 && count.moved <= count.due && count.collided > 0);
		ck_assert(count.due <= 300 * l.granules);
		free(before);
		ts_automaton_release(&l);
	}
}
END_TEST

/* No empty cell: nothing moves, but the row at the wall takes up its velocity. */
START_TEST(full_lattice)
{
	for (int order = 0; order < 2; order++) {
		struct ts_automaton_lattice l = lattice_of(32, 4, 1, 1, order);
		struct ts_laws laws = laws_of(0.85, 0.65, 0.65);
		struct ts_automaton_count count = { 0 };
		struct ts_automaton_row row;

		laws.wall[0] = TS_CELL_ONE;
		for (int t = 1; t <= 500; t++)
			ts_automaton_step(&l, &laws, (enum ts_automaton_order)order, 3, t, 1, &count);
		ck_assert(count_granules(&l) == 128 && count.moved == 0 && count.collided > 0);
		ts_automaton_sum_row(&l, 0, &row);
		ck_assert(row.granules == 32 && row.open == 32 && row.x > 0);
		ts_automaton_release(&l);
	}
}
END_TEST

/* On one thread blocks are updated in lockstep, on four one after the other, as there are few for each. */
START_TEST(threads_do_not_matter)
{
	for (int order = 0; order < 2; order++) {
		struct ts_automaton_lattice one = lattice_of(331, 203, 0.7, 5, order),
					    many = lattice_of(331, 203, 0.7, 5, order);
		int64_t granules;
		struct ts_laws laws = laws_of(0.85, 0.65, 0.65);
		struct ts_automaton_count c1 = { 0 }, c4 = { 0 };

		laws.wall[0] = TS_CELL_ONE;
		for (int k = 0; k < 900; k++) { /* obstacles in place of granules */
			const size_t c = ts_automaton_at(&one, 37 * k % 331, 11 * k % 203);

			one.cell[c] = many.cell[c] = ts_cell_fixed(TS_CELL_OBSTACLE);
		}
		granules = count_granules(&one);
		for (int t = 1; t <= 30; t++) {
			ts_automaton_step(&one, &laws, (enum ts_automaton_order)order, 3, t, 1, &c1);
			ts_automaton_step(&many, &laws, (enum ts_automaton_order)order, 3, t, 4, &c4);
		}
		ck_assert(memcmp(one.cell, many.cell, one.stride * 205 * sizeof *one.cell) == 0);
		ck_assert(memcmp(&c1, &c4, sizeof c1) == 0);
		ck_assert(count_granules(&one) == granules && granules < one.granules);
		ts_automaton_release(&one);
		ts_automaton_release(&many);
	}
}
END_TEST

/* ---- both orders give the same flow */

static int by_value(const void *a, const void *b)
{
	const double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* Probability that two samples of n from one distribution differ at least as much (Kolmogorov, Smirnov): the series with
 * the correction of M. A. Stephens, J. R. Stat. Soc. B 32 (1970) 115. Sorts the samples. */
static double smirnov(double *a, double *b, size_t n)
{
	double most = 0, lambda, p = 0, root = sqrt((double)n / 2);
	size_t i = 0, j = 0;

	qsort(a, n, sizeof *a, by_value);
	qsort(b, n, sizeof *b, by_value);
	while (i < n && j < n) {
		const double x = fmin(a[i], b[j]);

		while (i < n && a[i] <= x)
			i++;
		while (j < n && b[j] <= x)
			j++;
		most = fmax(most, fabs((double)i - (double)j) / (double)n);
	}
	lambda = (root + 0.12 + 0.11 / root) * most;
	for (int k = 1; k < 100; k++)
		p += (k % 2 ? 2 : -2) * exp(-2.0 * k * k * lambda * lambda);
	return lambda < 0.2 ? 1 : fmin(fmax(p, 0), 1);
}

enum { SEEDS = 48, ROWS = 10 };

/* Means of u, nu and T of each row over the last half of 600 steps. */
static void profile(int order, const struct ts_laws *laws, uint64_t seed, double out[3][ROWS])
{
	struct ts_automaton_lattice l = lattice_of(128, ROWS, 0.85, seed, order);
	struct ts_automaton_count count = { 0 };
	double sum[4][ROWS] = { 0 };

	for (int t = 1; t <= 600; t++) {
		ts_automaton_step(&l, laws, (enum ts_automaton_order)order, seed, t, 1, &count);
		for (int y = 0; t > 300 && t % 5 == 0 && y < ROWS; y++) {
			struct ts_automaton_row row;

			ts_automaton_sum_row(&l, y, &row);
			sum[0][y] += (double)row.x / TS_CELL_ONE;
			sum[1][y] += (double)row.granules;
			sum[2][y] += (double)row.squares / TS_CELL_ONE / TS_CELL_ONE;
			sum[3][y] += (double)row.y / TS_CELL_ONE;
		}
	}
	for (int y = 0; y < ROWS; y++) {
		const double u = sum[0][y] / sum[1][y], v = sum[3][y] / sum[1][y];

		out[0][y] = u;
		out[1][y] = sum[1][y];
		out[2][y] = (sum[2][y] / sum[1][y] - u * u - v * v) / 2;
	}
	ts_automaton_release(&l);
}

/* Distributions over seeds of each point of the three profiles. 30 probabilities are computed, which for equal
 * distributions are uniform: the least is below 0.05/30 in 5 % of all cases, their mean has the standard deviation 0.053
 * or, as neighbouring rows are correlated, about twice that. */
START_TEST(orders_give_the_same_flow)
{
	static double value[2][SEEDS][3][ROWS];
	struct ts_laws laws = laws_of(0.85, 0.65, 0.65);
	FILE *table =
		deck_table("order exact and blocks: Kolmogorov-Smirnov probabilities of u, nu, T by row");
	double mean = 0;

	laws.wall[0] = TS_CELL_ONE;
	for (int order = 0; order < 2; order++)
		for (int k = 0; k < SEEDS; k++)
			profile(order, &laws, (uint64_t)(1000 * order + k + 1), value[order][k]);
	for (int what = 0; what < 3; what++)
		for (int y = 0; y < ROWS; y++) {
			double a[SEEDS], b[SEEDS], p;

			for (int k = 0; k < SEEDS; k++) {
				a[k] = value[0][k][what][y];
				b[k] = value[1][k][what][y];
			}
			p = smirnov(a, b, SEEDS);
			mean += p / (3 * ROWS);
			if (table)
				fprintf(table, "%s %d %.3f\n",
					what == 0   ? "u"
					: what == 1 ? "nu"
						    : "T",
					y, p);
			ck_assert_msg(p > 0.05 / 30, "%d of row %d: probability %g", what, y, p);
		}
	if (table)
		fprintf(table, "mean %.3f\n", mean);
	ck_assert_msg(mean > 0.25, "mean probability %g", mean);
}
END_TEST

/* Cells from a file are checked: walls, states, speeds. */
START_TEST(impossible_cells)
{
	struct ts_automaton_lattice l = lattice_of(20, 10, 0.5, 1, TS_AUTOMATON_EXACT);
	const size_t places[] = { ts_automaton_at(&l, 3, 4), ts_automaton_at(&l, -1, 4),
				  ts_automaton_at(&l, 20, 4), ts_automaton_at(&l, 5, -1),
				  ts_automaton_at(&l, 5, 10) };
	const uint32_t values[] = { 17, ts_cell_fixed(TS_CELL_LEFT_PORTAL), 0xc0000000u, 0x80000001u,
				    ts_cell_granule(TS_CELL_ONE + 1, 0, 3) };

	l.granules = 0;
	ck_assert(ts_automaton_accept(&l) && l.granules == 100 && l.open == 200);
	for (size_t k = 0; k < DECK_LENGTH(places); k++)
		for (size_t v = 0; v < DECK_LENGTH(values); v++) {
			const uint32_t before = l.cell[places[k]];

			l.cell[places[k]] = values[v];
			ck_assert(ts_automaton_accept(&l) == (before == values[v]));
			l.cell[places[k]] = before;
		}
	ts_automaton_release(&l);
}
END_TEST

START_TEST(out_of_memory)
{
	for (long k = 1; k <= 2; k++) {
		const long balance = ts_alloc_balance();
		struct ts_automaton_lattice l = { 0 };
		bool made;

		ts_alloc_fail_at(k);
		made = ts_automaton_make(&l, 20, 20);
		if (made) {
			l.granules = 10;
			made = ts_automaton_step_make(&l, TS_AUTOMATON_EXACT);
		}
		ts_alloc_fail_at(0);
		ck_assert(!made);
		ts_automaton_release(&l);
		ck_assert(ts_alloc_balance() == balance);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("automaton");
	TCase *tcase = tcase_create("automaton");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, cells_keep_what_is_put);
	tcase_add_test(tcase, pair_laws);
	tcase_add_test(tcase, directions_have_the_right_mean);
	tcase_add_test(tcase, wall_laws);
	tcase_add_test(tcase, path_of_one_granule);
	tcase_add_test(tcase, faces_of_obstacles);
	tcase_add_test(tcase, table_of_directions);
	tcase_add_test(tcase, orders_are_uniform);
	tcase_add_test(tcase, granules_are_kept);
	tcase_add_test(tcase, full_lattice);
	tcase_add_test(tcase, threads_do_not_matter);
	tcase_add_test(tcase, orders_give_the_same_flow);
	tcase_add_test(tcase, impossible_cells);
	tcase_add_test(tcase, out_of_memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
