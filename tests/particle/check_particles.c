/* Regions against volumes known in closed form, groups, wrapping, loss and shrinking faces. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "deck.h"

#include "box/domain.h"
#include "core/sim.h"
#include "particle/particles.h"

static const double pi = 3.14159265358979323846;

/* ---- volumes: the share of lattice points that lie in a region. A lattice of 40^3 points, set off
 * by an odd amount from all surfaces; the error is that of the surface cells. */

static struct tsim *lattice_box(void)
{
	return deck_open("units si\nboundary f f f\n"
			 "lattice sc 0.025\n"
			 "region box block 0.0 0.9999 0 0.9999 0 0.9999 units box\n"
			 "create_box 1 box\n"
			 "create_atoms 1 box\n");
}

struct shape {
	const char *text;
	double volume, surface;
};

static const struct shape shapes[] = {
	/* spherical cap etc.: textbook formulas */
	{ "region a block 0.1 0.73 0.2 0.61 0.31 0.94 units box", 0.63 * 0.41 * 0.63, 2.1 },
	{ "region a block INF 0.73 EDGE INF 0.31 INF units box", 0.73 * 0.69, 2 },
	{ "region a block 4.1 28.7 2.3 10.9 0 12.3 units lattice", 24.6 * 8.6 * 12.3 * 0.025 * 0.025 * 0.025,
	  1 },
	{ "region a sphere 0.487 0.493 0.501 0.385 units box", 4. / 3 * 3.14159265358979 * 0.057066625, 1.9 },
	{ "region a sphere 0.487 0.493 0.501 0.385 side out units box",
	  1 - 4. / 3 * 3.14159265358979 * 0.057066625, 1.9 },
	{ "region a cylinder z 0.487 0.493 0.2385 0.11 0.83 units box",
	  3.14159265358979 * 0.2385 * 0.2385 * 0.72, 1.5 },
	{ "region a cylinder x 0.487 0.493 0.2385 INF INF units box", 3.14159265358979 * 0.2385 * 0.2385,
	  1.5 },
	{ "region a cylinder y 0.487 0.493 0.2385 0.3 INF side out units box",
	  1 - 3.14159265358979 * 0.2385 * 0.2385 * 0.7, 1.5 },
	{ "region a cone z 0.487 0.493 0.1 0.4 0.11 0.83 units box",
	  3.14159265358979 * 0.72 / 3 * (0.01 + 0.04 + 0.16), 1.5 },
	/* x + y + z <= 1 cuts a corner of 1/6 off the cube */
	{ "region a plane 0.3333 0.3333 0.3333 -2 -2 -2 units box", 1. / 6, 0.9 },
	{ "region a plane 0.3333 0.3333 0.3333 -2 -2 -2 side out units box", 5. / 6, 0.9 },
	/* two blocks: 0.3 + 0.3 less their common part */
	{ "region b block 0 0.31 INF INF INF INF units box\n"
	  "region c block 0.18 0.49 INF INF INF INF units box\n"
	  "region a union 2 b c",
	  0.49, 2 },
	{ "region b block 0 0.31 INF INF INF INF units box\n"
	  "region c block 0.18 0.49 INF INF INF INF units box\n"
	  "region a intersect 2 b c",
	  0.13, 2 },
	{ "region b block 0 0.31 INF INF INF INF units box\n"
	  "region c block 0.18 0.49 INF INF INF INF units box\n"
	  "region a intersect 2 b c side out",
	  0.87, 2 },
	{ "region b sphere 0.487 0.493 0.501 0.385 units box\n"
	  "region c plane 0.487 0.493 0.501 0.3 -0.4 0.7 units box\n"
	  "region a intersect 2 b c",
	  2. / 3 * 3.14159265358979 * 0.057066625, 1.5 },
};

START_TEST(volumes)
{
	struct tsim *sim = lattice_box();
	const struct shape *s = &shapes[_i];
	size_t n = tsim_count(sim);
	double share;

	ck_assert_uint_eq(n, 40 * 40 * 40);
	deck(sim, "%s\ngroup g region a", s->text);
	share = deck_value(sim, "count(g)") / (double)n;
	/* points stand at the lower corners of their cells: half a cell of surface is the bound */
	DECK_NEAR(share, s->volume, 0.6 * s->surface * 0.025);
	/* what is created in it is as many */
	deck(sim, "delete_atoms group all\ncreate_atoms 1 region a");
	ck_assert_double_eq((double)tsim_count(sim), share * (double)n);
	tsim_close(sim);
}
END_TEST

/* Random points: binomial share, within five standard deviations. */
START_TEST(random_points)
{
	struct tsim *sim = deck_open("units si\nboundary f f f\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 1 box\n"
				     "create_atoms 1 random 20000 86028157 NULL\n"
				     "region ball sphere 0.1 -0.1 0.05 0.8 units box\n"
				     "group ball region ball");
	double share = 4. / 3 * pi * 0.512 / 8;

	DECK_NEAR(deck_value(sim, "count(ball)"), 20000 * share, 5 * sqrt(20000 * share * (1 - share)));
	deck(sim, "delete_atoms group all\ncreate_atoms 1 random 500 86028157 ball overlap 0.05\n"
		  "group in region ball");
	ck_assert_double_eq(deck_value(sim, "count(in)"), 500);
	deck(sim, "delete_atoms overlap 0.05 all all");
	ck_assert_uint_eq(tsim_count(sim), 500);
	tsim_close(sim);
}
END_TEST

/* ---- groups */

START_TEST(groups)
{
	struct tsim *sim = deck_open("units si\nlattice sc 0.25\n"
				     "region box block 0 0.99 0 0.99 0 0.99 units box\n"
				     "create_box 3 box\ncreate_atoms 2 box\n"
				     "set atom 1*7 type 1\nset atom 60* type 3\n"
				     "group one type 1\ngroup two type 2:3\ngroup ids id 3 5 9:12:3 64\n"
				     "group low id <= 10\ngroup mid id <> 5 8\ngroup not type != 2\n"
				     "group u union one ids\ngroup i intersect one ids\n"
				     "group s subtract all one ids\n"
				     "variable even atom id%%2==0\ngroup even variable even\n");

	ck_assert_uint_eq(tsim_count(sim), 64);
	ck_assert_double_eq(deck_value(sim, "count(one)"), 7);
	ck_assert_double_eq(deck_value(sim, "count(two)"), 57);
	ck_assert_double_eq(deck_value(sim, "count(ids)"), 5); /* 3 5 9 12 64 */
	ck_assert_double_eq(deck_value(sim, "count(low)"), 10);
	ck_assert_double_eq(deck_value(sim, "count(mid)"), 4);
	ck_assert_double_eq(deck_value(sim, "count(not)"), 12);
	ck_assert_double_eq(deck_value(sim, "count(u)"), 10);
	ck_assert_double_eq(deck_value(sim, "count(i)"), 2);
	ck_assert_double_eq(deck_value(sim, "count(s)"), 54);
	ck_assert_double_eq(deck_value(sim, "count(even)"), 32);
	/* members stay members, others do not become ones; identities are never used again */
	deck(sim, "delete_atoms group i\ncreate_atoms 1 single 0.1 0.1 0.1 units box");
	ck_assert_double_eq(deck_value(sim, "count(one)"), 5);
	ck_assert_int_eq(sim->particles->tag[tsim_count(sim) - 1], 65);
	/* 31 groups beside all */
	for (int k = 0; k < 19; k++)
		deck(sim, "group g%d type 1", k);
	ck_assert(!deck_accepts(sim, "group g19 type 1\ngroup g20 type 1\ngroup g21 type 1"));
	tsim_close(sim);
}
END_TEST

/* ---- faces */

/* Two and a half turns around the box, in both directions: place and number of turns. */
START_TEST(wrapping)
{
	struct tsim *sim = deck_open("units si\nboundary p p p\n"
				     "region box block -0.7 1.3 0 1.7 0.2 1.3 units box\n"
				     "create_box 1 box\n"
				     "create_atoms 1 single 0.1 0.2 0.3 units box\n"
				     "set group all diameter 0.1 density 1000\n"
				     "set atom 1 vx 5.1 vy -4.3 vz 2.6\n"
				     "fix move all nve\ntimestep 1e-3\nrun 1000");
	struct ts_particles *p = sim->particles;
	const double start[] = { 0.1, 0.2, 0.3 }, v[] = { 5.1, -4.3, 2.6 };

	for (int k = 0; k < 3; k++) {
		double length = ts_box_length(&sim->domain->box, k);
		const double skin = 0.015; /* 0.3 r */

		DECK_NEAR(p->x[0][k] + p->image[0][k] * length, start[k] + v[k], 1e-12);
		/* wrapped at the last rebuild, at most half a skin ago */
		ck_assert_double_ge(p->x[0][k], sim->domain->box.lo[k] - skin);
		ck_assert_double_le(p->x[0][k], sim->domain->box.hi[k] + skin);
	}
	ck_assert_int_eq(p->image[0][0], 2);
	ck_assert_int_eq(p->image[0][1], -3);
	ck_assert_int_eq(p->image[0][2], 2);
	tsim_close(sim);
}
END_TEST

/* A set of balls flies apart: fixed faces lose them, in the step they pass; shrinking ones follow;
 * `m` ones never come inside the first box. */
START_TEST(faces)
{
	static const char *const style[] = { "f f f", "s s s", "m m m", "fs sm mf" };
	struct tsim *sim = deck_open("units si\nboundary %s\n"
				     "region box block 0 1 0 1 0 1 units box\n"
				     "create_box 1 box\n"
				     "create_atoms 1 single 0.4 0.5 0.5 units box\n"
				     "create_atoms 1 single 0.6 0.5 0.5 units box\n"
				     "set group all diameter 0.1 density 1000\n"
				     "set atom 1 vx -1.3\nset atom 2 vx 1.7\n"
				     "fix move all nve\nthermo_modify lost ignore\n"
				     "timestep 1e-3\nrun 1000",
				     style[_i]);
	const struct ts_box *box = &sim->domain->box;
	const double x1 = 0.4 - 1.3, x2 = 0.6 + 1.7;

	switch (_i) {
	case 0:
		ck_assert_uint_eq(tsim_count(sim), 0);
		ck_assert_int_eq((int)sim->particles->lost, 2);
		break;
	case 1:
	case 2:
		ck_assert_uint_eq(tsim_count(sim), 2);
		/* as of the last rebuild, half a skin (0.0075) ago at most; margin 1e-4 */
		ck_assert_double_le(box->lo[0], x1 + 0.0076);
		ck_assert_double_ge(box->lo[0], x1 - 2e-4);
		ck_assert_double_ge(box->hi[0], x2 - 0.0076);
		ck_assert_double_le(box->hi[0], x2 + 2e-4);
		if (_i == 1) {
			DECK_NEAR(box->hi[1] - box->lo[1], 2e-4, 1e-16);
		} else {
			ck_assert_double_eq(box->lo[1], 0);
			ck_assert_double_eq(box->hi[1], 1);
		}
		break;
	default:
		ck_assert_uint_eq(tsim_count(sim), 1);
		ck_assert_int_eq(sim->particles->tag[0], 2);
		break;
	}
	tsim_close(sim);
}
END_TEST

/* A particle is lost in the very step in which it passes the face; with `lost ignore`, at the next
 * rebuild. */
START_TEST(lost_at_once)
{
	static const char *const modes[] = { "warn", "ignore" };
	struct tsim *sim = deck_open("units si\nboundary f f f\n"
				     "region box block 0 1 0 1 0 1 units box\n"
				     "create_box 1 box\n"
				     "create_atoms 1 single 0.5 0.5 0.9 units box\n"
				     "set group all diameter 0.1 density 1000\n"
				     "set atom 1 vz 2.385\nneighbor 0.5 bin\n"
				     "fix move all nve\ntimestep 1e-3");

	deck(sim, "thermo_modify lost %s", modes[_i]);
	deck(sim, "run 41"); /* 0.9 + 41 * 0.002385 = 0.9978 */
	ck_assert_uint_eq(tsim_count(sim), 1);
	deck(sim, "run 1");
	ck_assert_uint_eq(tsim_count(sim), (unsigned)_i);
	deck(sim, "run 80"); /* half the skin is 0.25, 105 steps */
	ck_assert_uint_eq(tsim_count(sim), 0);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("particles");
	TCase *all = tcase_create("all");

	tcase_set_timeout(all, 60);
	tcase_add_loop_test(all, volumes, 0, (int)DECK_LENGTH(shapes));
	tcase_add_test(all, random_points);
	tcase_add_test(all, groups);
	tcase_add_test(all, wrapping);
	tcase_add_loop_test(all, faces, 0, 4);
	tcase_add_loop_test(all, lost_at_once, 0, 2);
	suite_add_tcase(suite, all);
	return deck_main(suite);
}
