/* What is computed for a batch of particles in vectors is bitwise that of the functions of one particle: on grids that are
 * uniform or graded, periodic, between walls or open, at places inside and outside of them, on faces and corners. */
#include <string.h>

#include "base/alloc.h"
#include "coupling/stencil_batch.h"
#include "coupling/volume_batch.h"
#include "deck.h"
#include "geom/ball_corner.h"
#include "geom/ball_edges.h"
#include "math/rng.h"

enum { N = TS_STENCIL_BATCH, WAYS = 8, ROUNDS = 60 };

/* Bit 0: graded; 1, 2: not periodic along x, along y and z. */
static void make_fluid(struct ts_fluid *fluid, int way)
{
	static const int n[3] = { 6, 5, 7 };
	const bool graded = way & 1, periodic[3] = { !(way & 2), !(way & 4), !(way & 4) };
	struct ts_rng rng = ts_rng_start(2385, (uint64_t)way);
	double faces[3][8];

	*fluid = (struct ts_fluid){ .density = 1.3 };
	for (int d = 0; d < 3; d++)
		for (int i = 0; i <= n[d]; i++)
			faces[d][i] = 0.37 * d - 0.5 + 0.2 * i + (graded && i % 3 == 1 ? 0.031 : 0);
	ck_assert_int_eq(ts_grid_make(&fluid->grid, 3, n,
				      (const double *const[3]){ faces[0], faces[1], faces[2] }, periodic),
			 TS_OK);
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++) {
			fluid->face[d][side] = periodic[d]	 ? TS_FLOW_PERIODIC
					       : d == 2 && !side ? TS_FLOW_OUTLET
								 : TS_FLOW_WALL;
			for (int k = 0; k < 3; k++)
				fluid->ghost_weights[d][side][k] = 1.1 + 0.3 * k;
		}
	for (int c = 0; c < 3; c++) {
		fluid->u[c] = ts_grid_field(&fluid->grid);
		fluid->force[c] = ts_grid_field(&fluid->grid);
		fluid->exchange[c] = ts_grid_field(&fluid->grid);
		for (size_t k = 0; k < fluid->grid.size; k++)
			fluid->u[c][k] = ts_rng_uniform(&rng) - 0.5;
	}
}

static void release_fluid(struct ts_fluid *fluid)
{
	for (int c = 0; c < 3; c++) {
		ts_grid_field_free(fluid->u[c]);
		ts_grid_field_free(fluid->force[c]);
		ts_grid_field_free(fluid->exchange[c]);
	}
	ts_grid_release(&fluid->grid);
}

/* Most places are inside, some outside, some on faces or at centres. */
static void choose_place(const struct ts_grid *grid, struct ts_rng *rng, double x[3])
{
	for (int d = 0; d < 3; d++) {
		const double low = grid->face[d][0], length = grid->face[d][grid->n[d]] - low;
		const int cell = (int)(ts_rng_uniform(rng) * (grid->n[d] + 1)),
			  kind = (int)(ts_rng_uniform(rng) * 20);

		x[d] = kind == 0   ? grid->face[d][cell]
		       : kind == 1 ? grid->centre[d][cell]
		       : kind == 2 ? low + length * (3 * ts_rng_uniform(rng) - 1)
				   : low + length * ts_rng_uniform(rng);
	}
}

/* n places. */
static void choose_batch(struct ts_stencil_batch *b, const struct ts_grid *grid, struct ts_rng *rng, size_t n)
{
	double x[N][3];
	size_t of[N];

	for (size_t k = 0; k < n; k++) {
		of[k] = k;
		choose_place(grid, rng, x[k]);
	}
	ts_stencil_batch_find(b, grid, (const double(*)[3])x, of, n);
}

static bool place_of(const struct ts_stencil_batch *b, const struct ts_fluid *fluid, size_t k,
		     struct ts_coupling_place *at)
{
	at->how = TS_INTERPOLATE_LINEAR;
	return ts_coupling_locate(fluid, (const double[3]){ b->x[0][k], b->x[1][k], b->x[2][k] }, at->x,
				  at->cell);
}

static void same_numbers(const double out[3][N], size_t k, const double alone[3])
{
	for (int c = 0; c < 3; c++)
		ck_assert(memcmp(&out[c][k], &alone[c], sizeof *alone) == 0);
}

START_TEST(halves)
{
	struct ts_rng rng = ts_rng_start(7, (uint64_t)_i);
	struct ts_fluid fluid;

	make_fluid(&fluid, _i);
	for (int round = 0; round < ROUNDS; round++) {
		struct ts_stencil_batch b;

		choose_batch(&b, &fluid.grid, &rng, N);
		for (size_t k = 0; k < N; k++) {
			const double x[3] = { b.x[0][k], b.x[1][k], b.x[2][k] };
			struct ts_coupling_place at;
			const bool inside = place_of(&b, &fluid, k, &at);

			ck_assert(b.where[k] == ts_halves_find(&fluid.grid, x));
			ck_assert(!(b.where[k] & TS_HALVES_ELSEWHERE) ==
				  (inside && memcmp(x, at.x, sizeof x) == 0));
			for (int d = 0; d < 3 && !(b.where[k] & TS_HALVES_ELSEWHERE); d++)
				ck_assert(ts_halves_of(b.where[k], d) ==
					  2 * at.cell[d] + (x[d] >= fluid.grid.centre[d][at.cell[d]]));
		}
	}
	release_fluid(&fluid);
}
END_TEST

START_TEST(interpolations)
{
	struct ts_rng rng = ts_rng_start(8, (uint64_t)_i);
	size_t ninside = 0;
	struct ts_fluid fluid;

	make_fluid(&fluid, _i);
	for (int round = 0; round < ROUNDS; round++) {
		struct ts_stencil_batch b;
		double linear[3][N], gradient[3][N], u[3][N], value[N], alone[3], one;
		const size_t n = N - (size_t)round % 7;
		bool inside[3][N];

		choose_batch(&b, &fluid.grid, &rng, n);
		for (int pass = 0; pass < 3; pass++) {
			struct ts_stencil_batch again = b;

			if (pass == 0)
				ts_stencil_batch_interpolate(&again, &fluid, fluid.u, linear, inside[0]);
			else if (pass == 1)
				ts_stencil_batch_gradient(&again, &fluid, fluid.u[1], gradient, inside[1]);
			else
				ts_stencil_batch_velocity(&again, &fluid, u, fluid.u[2], value, inside[2]);
		}
		for (size_t k = 0; k < n; k++) {
			struct ts_coupling_weights weights[3];
			struct ts_coupling_place at;
			const bool in = place_of(&b, &fluid, k, &at);

			ck_assert(inside[0][k] == in && inside[1][k] == in && inside[2][k] == in);
			if (!in)
				continue;
			ninside++;
			ts_coupling_weights_faces(&fluid, at.x, at.cell, at.how, weights);
			for (int c = 0; c < 3; c++)
				alone[c] = ts_coupling_interpolate(&fluid.grid, &weights[c], fluid.u[c]);
			same_numbers((const double(*)[N])linear, k, alone);
			for (int c = 0; c < 3; c++)
				alone[c] = ts_coupling_interpolate_gradient(&fluid.grid, &weights[c], c,
									    fluid.u[1]);
			same_numbers((const double(*)[N])gradient, k, alone);
			ts_fluid_velocity_in_cell(&fluid, at.x, at.cell, alone, fluid.u[2], &one);
			same_numbers((const double(*)[N])u, k, alone);
			ck_assert(memcmp(&value[k], &one, sizeof one) == 0);
		}
	}
	ck_assert(ninside > ROUNDS * N / 3);
	release_fluid(&fluid);
}
END_TEST

static void react_alone(const struct ts_stencil_batch *b, struct ts_fluid *fluid,
			const struct ts_stencil_reactions *of, double velocity[N][3])
{
	for (size_t k = 0; k < b->n; k++) {
		struct ts_coupling_weights weights[3];
		struct ts_coupling_place at;

		if (!place_of(b, fluid, k, &at))
			continue;
		ts_coupling_weights_faces(fluid, at.x, at.cell, at.how, weights);
		for (int c = 0; c < 3; c++) {
			const double u =
				of->along[c]
					? ts_coupling_distribute_force(&fluid->grid, &weights[c], c,
								       fluid->u[c], of->amount[k][c],
								       of->sloped ? of->slope[k][c] : 0,
								       fluid->force[c],
								       of->sloped ? fluid->exchange[c] : NULL)
					: 0;

			velocity[k][c] = of->velocity[k] && of->along[c] ? u : velocity[k][c];
		}
	}
}

/* With slopes and without; some components are left out. */
START_TEST(reactions)
{
	struct ts_rng rng = ts_rng_start(9, (uint64_t)_i);
	struct ts_fluid fluid[2];

	make_fluid(&fluid[0], _i % WAYS);
	make_fluid(&fluid[1], _i % WAYS);
	for (int round = 0; round < ROUNDS; round++) {
		struct ts_stencil_reactions of = { .sloped = _i < WAYS,
						   .along = { true, round % 3, round % 2 } };
		double amount[N][3], slope[N][3], velocity[2][N][3] = { { { 0 } } };
		struct ts_stencil_batch b;

		choose_batch(&b, &fluid[0].grid, &rng, N - (size_t)round % 5);
		for (size_t k = 0; k < N; k++) {
			for (int c = 0; c < 3; c++) {
				amount[k][c] = ts_rng_uniform(&rng) - 0.3;
				slope[k][c] = ts_rng_uniform(&rng);
			}
			of.amount[k] = amount[k];
			of.slope[k] = slope[k];
			of.velocity[k] = k % 5 ? velocity[0][k] : NULL;
		}
		react_alone(&b, &fluid[1], &of, velocity[1]);
		ts_stencil_batch_react(&b, &fluid[0], &of);
		ck_assert(memcmp(velocity[0], velocity[1], sizeof velocity[0]) == 0);
	}
	for (int c = 0; c < 3; c++) {
		const size_t bytes = fluid[0].grid.size * sizeof(double);

		ck_assert(memcmp(fluid[0].force[c], fluid[1].force[c], bytes) == 0);
		ck_assert(memcmp(fluid[0].exchange[c], fluid[1].exchange[c], bytes) == 0);
	}
	release_fluid(&fluid[0]);
	release_fluid(&fluid[1]);
}
END_TEST

/* Particles of all sizes, from a small part of a cell to more than two cells. */
START_TEST(volumes)
{
	const struct ts_coupling_volume how = { .method = TS_VOLUME_DIVIDED };
	struct ts_rng rng = ts_rng_start(10, (uint64_t)_i);
	struct ts_fluid fluid[2];

	make_fluid(&fluid[0], _i);
	make_fluid(&fluid[1], _i);
	ck_assert(ts_volume_batch_possible(&fluid[0].grid, &how) == !(_i & 1));
	for (int round = 0; round < 10 * ROUNDS && !(_i & 1); round++) {
		struct ts_volume_batch b = { .n = N - (size_t)round % 6 };

		for (size_t k = 0; k < b.n; k++) {
			double x[3];

			do
				choose_place(&fluid[0].grid, &rng, x);
			while ((b.where[k] = ts_halves_find(&fluid[0].grid, x)) & TS_HALVES_ELSEWHERE);
			for (int d = 0; d < 3; d++)
				b.x[d][k] = x[d];
			b.radius[k] = ts_rng_uniform(&rng) * (k % 9 ? 0.1 : 0.3);
		}
		for (size_t k = 0; k < b.n; k++) {
			struct ts_coupling_place at;

			ck_assert(ts_coupling_locate(&fluid[1],
						     (const double[3]){ b.x[0][k], b.x[1][k], b.x[2][k] },
						     at.x, at.cell));
			ts_coupling_volume_add(&fluid[1].grid, &how, at.x, at.cell, b.radius[k],
					       fluid[1].force[0]);
		}
		ts_volume_batch_add(&b, &fluid[0].grid, &how, fluid[0].force[0]);
	}
	ck_assert(memcmp(fluid[0].force[0], fluid[1].force[0], fluid[0].grid.size * sizeof(double)) == 0);
	release_fluid(&fluid[0]);
	release_fluid(&fluid[1]);
}
END_TEST

START_TEST(edges_of_a_ball)
{
	static const double cut[] = { 0, 1e-9, 0.13, 0.3, 0.5, 0.6, 0.70710678118654757, 0.8, 0.999 };
	const size_t n = DECK_LENGTH(cut);
	struct ts_ball_edges edges;

	for (size_t k = 0; k < n * n; k++) {
		edges.a[k] = cut[k % n];
		edges.b[k] = cut[k / n];
	}
	ts_ball_edges_find(&edges, n * n);
	for (size_t k = 0; k < n * n; k++) {
		ck_assert(2 * edges.volume[k] == ts_ball_corner(edges.a[k], edges.b[k], -1.3));
		ck_assert(ts_ball_cap(edges.a[k]) == ts_ball_corner(-1.3, edges.a[k], -1.3));
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("batches");
	TCase *c = tcase_create("coupling");

	tcase_add_loop_test(c, halves, 0, WAYS);
	tcase_add_loop_test(c, interpolations, 0, WAYS);
	tcase_add_loop_test(c, reactions, 0, 2 * WAYS);
	tcase_add_loop_test(c, volumes, 0, WAYS);
	tcase_add_test(c, edges_of_a_ball);
	suite_add_tcase(suite, c);
	return deck_main(suite);
}
