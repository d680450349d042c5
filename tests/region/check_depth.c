/* Depth of points in regions against the distance from many points of their surface: exact for shapes of one style, for cells of
 * files, and for intersections of convex ones, a bound otherwise. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/sim.h"
#include "deck.h"
#include "region/region.h"

enum { POINTS = 40000, PLACES = 200 };

static struct surface {
	size_t n;
	double x[POINTS][3];
} surface;

/* In the cube from -0.5 to 1.5, which the regions are in. */
static void draw_place(double x[3])
{
	for (int d = 0; d < 3; d++)
		x[d] = 2.0 * rand() / RAND_MAX - 0.5;
}

/* Points of the surface: by bisection between places inside and outside. */
static void find_surface(const struct ts_instance *region)
{
	surface.n = 0;
	while (surface.n < POINTS) {
		double u[3], v[3], m[3];
		bool in;

		draw_place(u);
		draw_place(v);
		in = ts_region_contains(region, u);
		if (ts_region_contains(region, v) == in)
			continue;
		for (int k = 0; k < 45; k++) {
			for (int d = 0; d < 3; d++)
				m[d] = 0.5 * (u[d] + v[d]);
			memcpy(ts_region_contains(region, m) == in ? u : v, m, sizeof m);
		}
		memcpy(surface.x[surface.n++], u, sizeof u);
	}
}

static double distance_from_surface(const double x[3])
{
	double least = INFINITY;

	for (size_t k = 0; k < surface.n; k++) {
		double square = 0;

		for (int d = 0; d < 3; d++)
			square += (surface.x[k][d] - x[d]) * (surface.x[k][d] - x[d]);
		least = fmin(least, square);
	}
	return sqrt(least);
}

/* The points are nowhere farther from one another than `apart`. */
static void compare_depth(struct tsim *sim, const char *name, double apart)
{
	struct ts_instance *region = ts_sim_find(sim, TS_KIND_REGION, name);

	ck_assert_ptr_nonnull(region);
	ck_assert_int_eq(ts_region_update(region, sim), TS_OK);
	find_surface(region);
	for (int k = 0; k < PLACES; k++) {
		double x[3], distance, depth, bound;

		draw_place(x);
		distance = distance_from_surface(x);
		depth = ts_region_depth_at_edges(region, x);
		bound = ts_region_depth(region, x);
		ck_assert_msg(ts_region_contains(region, x) == (depth >= 0), "%s: %g %g %g", name, x[0], x[1],
			      x[2]);
		ck_assert_msg(fabs(depth) <= distance + 1e-6 && fabs(depth) >= distance - apart,
			      "%s: at %g %g %g the depth is %g, the distance %g", name, x[0], x[1], x[2],
			      depth, distance);
		ck_assert_msg(fabs(bound) <= distance + 1e-9 && bound * depth >= 0,
			      "%s: at %g %g %g the bound is %g, the distance %g", name, x[0], x[1], x[2],
			      bound, distance);
	}
}

static struct tsim *open_regions(void)
{
	return deck_open("units si\n"
			 "region box block -1 2 -1 2 -1 2 units box\n"
			 "create_box 1 box\n");
}

START_TEST(shapes)
{
	static const char *const shape[] = {
		"block 0.1 0.6 0.2 0.8 0.3 0.7",
		"prism 0.1 0.6 0.2 0.8 0.3 0.7 0 0 0",
		"prism 0.1 0.6 0.2 0.8 0.3 0.7 0.2 -0.1 0.3",
		"wedge axis z center 0.5 0.5 radius 0.4 bounds 0.2 0.7 angle0 30 angle 70",
		"wedge axis x center 0.5 0.5 radius 0.4 bounds 0.2 0.7 angle0 -40 angle 250",
		"cylinder y 0.5 0.5 0.3 0.1 0.9",
		"cone y 0.5 0.4 0.5 0.2 0.1 0.8",
		"cone z 0.5 0.4 0 0.4 0.1 0.8",
		"sphere 0.5 0.4 0.5 0.4",
	};
	struct tsim *sim = open_regions();

	for (size_t k = 0; k < DECK_LENGTH(shape); k++) {
		deck(sim, "region r %s units box", shape[k]);
		compare_depth(sim, "r", 0.03);
		deck(sim, "region r delete");
	}
	tsim_close(sim);
}
END_TEST

START_TEST(intersections)
{
	struct tsim *sim = open_regions();

	deck(sim, "region one sphere 0.4 0.5 0.5 0.35 units box\n"
		  "region two sphere 0.7 0.5 0.5 0.3 units box\n"
		  "region lens intersect 2 one two\n"
		  "region can cylinder z 0.5 0.5 0.3 0 1 units box\n"
		  "region slope plane 0.5 0.5 0.5 1 1 1 units box\n"
		  "region cut intersect 2 can slope\n"
		  "region face plane 0.5 0.5 0.6 -1 0.3 0.2 units box\n"
		  "region twice intersect 3 can slope face\n"
		  "region again intersect 2 cut face\n"
		  "region hole cylinder z 0.5 0.5 0.15 INF INF side out units box\n"
		  "region ring intersect 2 can hole");
	compare_depth(sim, "lens", 0.03);
	compare_depth(sim, "cut", 0.03);
	compare_depth(sim, "twice", 0.03);
	compare_depth(sim, "again", 0.03);
	compare_depth(sim, "ring", 0.03);
	tsim_close(sim);
}
END_TEST

/* A cube of 5 tetrahedra with a pyramid of two more, once with points of its own, and once more the first tetrahedron. */
static const char tetrahedra[] =
	"0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1  1.4 0.6 0.7  1 1 0  1 0 1  1 1 1\n"
	"CELLS 9 44\n3 0 1 2\n4 0 1 2 5\n4 0 2 3 7\n4 0 4 5 7\n4 2 5 6 7\n4 0 2 5 7\n"
	"4 1 2 5 8\n4 9 11 10 8\n4 0 1 2 5\nCELL_TYPES 9\n5\n10\n10\n10\n10\n10\n10\n10\n10\n";
/* A step of three, the third with points of its own and its corners in another order, so that diagonals of shared faces differ. */
static const char hexahedra[] =
	"0 0 0  1 0 0.2  1 1 0.2  0 1 0  0 0 0.5  1 0 0.7  1 1 0.7  0 1 0.5  0 0 1  1 0 1.2  1 1 1.2  0 1 1\n"
	"1 0 0.2  1.4 0 0.2  1.4 1 0.2  1 1 0.2  1 0 0.7  1.4 0 0.7  1.4 1 0.7  1 1 0.7\n"
	"CELLS 3 27\n8 0 1 2 3 4 5 6 7\n8 4 5 6 7 8 9 10 11\n8 13 14 15 12 17 18 19 16\nCELL_TYPES "
	"3\n12\n12\n12\n";

static void write_cells(const char *file, int points, const char *rest)
{
	FILE *f = fopen(file, "w");

	ck_assert_ptr_nonnull(f);
	fprintf(f,
		"# vtk DataFile Version 2.0\ncells\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS %d double\n%s",
		points, rest);
	ck_assert_int_eq(fclose(f), 0);
}

START_TEST(cells)
{
	struct tsim *sim = open_regions();

	write_cells("depth_tet.vtk", 12, tetrahedra);
	write_cells("depth_hex.vtk", 20, hexahedra);
	deck(sim,
	     "region tet mesh/tet file depth_tet.vtk scale 0.9 move 0.1 0.2 0.1 rotate 10 20 -20 units box\n"
	     "region hex mesh/hex file depth_hex.vtk scale 0.8 move 0.1 0.2 0 rotate 0 0 -10 units box");
	compare_depth(sim, "tet", 0.04);
	compare_depth(sim, "hex", 0.04);
	tsim_close(sim);
	remove("depth_tet.vtk");
	remove("depth_hex.vtk");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("depth");
	TCase *tcase = tcase_create("depth");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, shapes);
	tcase_add_test(tcase, intersections);
	tcase_add_test(tcase, cells);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
