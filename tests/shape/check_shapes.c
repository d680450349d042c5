/* Shapes given by their sizes: areas and volumes against exact ones and the order at which they converge, closed and
 * consistently oriented surfaces, places and directions, and what is refused. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/alloc.h"
#include "deck.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "mesh/mesh_doctor.h"
#include "mesh/mesh_surface.h"

#define BOX                                                                                         \
	"units si\natom_style granular\nboundary %s\nregion b block %s units box\ncreate_box 1 b\n" \
	"neighbor 0.001 bin\n"

static struct tsim *open_box(void)
{
	return deck_open(BOX, "f f f", "-10 10 -10 10 -10 10");
}

/* The mesh `shape` of a simulation, found without faults other than a rim. */
static const struct ts_mesh *make(struct tsim *sim, const char *words, size_t *rim)
{
	struct ts_mesh_findings found = { 0 };
	const struct ts_mesh *m;

	deck(sim, "fix shape all mesh/surface primitive %s type 1\n", words);
	m = &ts_mesh_surface_find(sim, "shape")->mesh;
	ck_assert_int_eq(ts_mesh_examine(m, 0.256235, &found), TS_OK);
	*rim = found.count[TS_MESH_OPEN];
	ck_assert_msg(found.n == *rim, "%s: %zu faults", words, found.n - *rim);
	ts_mesh_findings_release(&found);
	return m;
}

struct measures {
	double area, volume, angle;
	size_t rim, n;
};

static double smallest_angle(const struct ts_mesh *m)
{
	double least = INFINITY, c[3];

	for (size_t t = 0; t < m->n; t++)
		for (int k = 0; k < 3; k++) {
			const double *on = m->along[t][k], *back = m->along[t][(k + 2) % 3];

			ts_cross(back, on, c);
			least = fmin(least, atan2(ts_norm(c), -ts_dot(on, back)));
		}
	return least * 180 / TS_PI;
}

static struct measures measure(const char *words)
{
	struct tsim *sim = open_box();
	struct measures out;
	const struct ts_mesh *m = make(sim, words, &out.rim);

	out.area = ts_mesh_area(m);
	out.volume = ts_mesh_volume(m);
	out.angle = smallest_angle(m);
	out.n = m->n;
	tsim_close(sim);
	return out;
}

START_TEST(flat)
{
	struct measures m = measure("box -0.385 2 0.1 1.5 -1 2");

	ck_assert_uint_eq(m.n, 12);
	ck_assert_uint_eq(m.rim, 0);
	DECK_NEAR(m.volume, 2.385 * 1.4 * 3, 1e-14);
	DECK_NEAR(m.area, 2 * (2.385 * 1.4 + 2.385 * 3 + 1.4 * 3), 1e-14);
	m = measure("box -0.385 2 0.1 1.5 -1 2 open zhi xlo");
	ck_assert_uint_eq(m.n, 8);
	DECK_NEAR(m.area, 2.385 * 1.4 + 2 * 2.385 * 3 + 1.4 * 3, 1e-14);
	m = measure("plate length 2.385 width 0.7");
	DECK_NEAR(m.area, 2.385 * 0.7, 1e-15);
	m = measure("wedge width 1 outlet 0.2 depth 0.5 half_angle 30 height 0.3");
	DECK_NEAR(m.area, 2 * 0.5 * (0.4 / sin(TS_PI / 6) + 0.3) + 2 * (0.6 * 0.4 / tan(TS_PI / 6) + 0.3),
		  1e-14);
	m = measure("wedge width 1 outlet 0.2 depth 0.5 half_angle 90 ends no");
	DECK_NEAR(m.area, 2 * 0.5 * 0.4, 1e-15);
}
END_TEST

/* Prisms over a polygon of n sides: exact to rounding. */
START_TEST(polygons)
{
	double n = 24, R = 1.3, L = 2.385, base = n / 2 * R * R * sin(2 * TS_PI / n),
	       side = 2 * R * sin(TS_PI / n);
	struct measures m = measure("cylinder radius 1.3 length 2.385 segments 24");

	DECK_NEAR(m.volume, base * L, 1e-13);
	DECK_NEAR(m.area, n * side * L + 2 * base, 1e-13);
	m = measure("tube radius 1.3 length 2.385 thickness 0.3 segments 24");
	DECK_NEAR(m.volume, base * L * (1 - 1 / 1.69), 1e-13);
	m = measure("screw radius 1.3 shaft 0.6 pitch 1.1 turns 2.5 thickness 0.2 length 4 segments 24");
	DECK_NEAR(m.volume, base * (0.36 / 1.69 * 4 + (1 - 0.36 / 1.69) * 0.2 * 2.5), 1e-13);
	m = measure(
		"mixer radius 1.3 shaft 0.3 length 1 blades 3 width 0.4 thickness 0.1 tilt 35 segments 24");
	DECK_NEAR(m.volume, base * 0.09 / 1.69 + 3 * 1.15 * 0.4 * 0.1, 1e-13);
}
END_TEST

/* Area between the circle and the bar's tip. */
static double bar(double R, double h, double w)
{
	return R * R * asin(w / 2 / R) + w / 2 * sqrt(R * R - w * w / 4) - w * (R - h);
}

/* Both sides of a helicoid for one turn: 2 pi times the integral of 2 sqrt(r^2 + k^2) from a to b. */
static double helicoid(double a, double b, double pitch)
{
	double k = pitch / (2 * TS_PI), at[2] = { a, b }, f[2];

	for (int i = 0; i < 2; i++)
		f[i] = at[i] * hypot(at[i], k) + k * k * asinh(at[i] / k);
	return 2 * TS_PI * (f[1] - f[0]);
}

static const struct curved {
	const char *words;
	bool closed;
} curved[] = {
	{ "disk radius 1.1 hole 0.2", false },
	{ "cylinder radius 1.1 length 1.3 open both", false },
	{ "cylinder radius 1.1 length 1.3", true },
	{ "tube radius 1.1 thickness 0.2 length 1.3", true },
	{ "cone radlo 0.3 radhi 1.1 length 1.3", true },
	{ "cone radlo 0.7 radhi 0 length 1.3", true },
	{ "revolve 0 0 1 0.5 0 1", true },
	{ "hopper radius 1.1 outlet 0.2 half_angle 35 height 0.4 stem 0.1", false },
	{ "drum radius 1.1 length 1.3 lifters 7 height 0.25 width 0.15", true },
	{ "sphere radius 1.1", true },
	{ "screw radius 1.1 shaft 0.4 pitch 0.9 turns 2.5 thickness 0.1 length 3", true },
};

static void exact_measures(double area[], double volume[])
{
	double cone = tan(35 * TS_PI / 180), b = bar(1.1, 0.25, 0.15), w = 2 * asin(0.075 / 1.1) * 1.1;
	double sides = 2 * (sqrt(1.21 - 0.075 * 0.075) - 0.85) + 0.15;

	area[0] = TS_PI * (1.21 - 0.04);
	area[1] = 2 * TS_PI * 1.1 * 1.3;
	area[2] = area[1] + 2 * TS_PI * 1.21;
	volume[2] = TS_PI * 1.21 * 1.3;
	area[3] = 2 * TS_PI * (1.1 + 0.9) * 1.3 + 2 * TS_PI * (1.21 - 0.81);
	volume[3] = TS_PI * (1.21 - 0.81) * 1.3;
	area[4] = TS_PI * (0.09 + 1.21 + 1.4 * hypot(0.8, 1.3));
	volume[4] = TS_PI / 3 * 1.3 * (0.09 + 0.33 + 1.21);
	area[5] = TS_PI * (0.49 + 0.7 * hypot(0.7, 1.3));
	volume[5] = TS_PI / 3 * 0.49 * 1.3;
	area[6] = 2 * TS_PI * hypot(1, 0.5);
	volume[6] = TS_PI / 3;
	area[7] = 2 * TS_PI * (1.1 * 0.4 + 0.2 * 0.1) + TS_PI * 1.3 * hypot(0.9, 0.9 / cone);
	volume[8] = (TS_PI * 1.21 - 7 * b) * 1.3;
	area[8] = 2 * (TS_PI * 1.21 - 7 * b) + 1.3 * (2 * TS_PI * 1.1 + 7 * (sides - w));
	area[9] = 4 * TS_PI * 1.21;
	volume[9] = 4 * TS_PI / 3 * 1.331;
	area[10] = 2.5 * (helicoid(0.4, 1.1, 0.9) + 2 * TS_PI * 0.1 * (1.1 - 0.4)) + 2 * 0.7 * 0.1 +
		   2 * TS_PI * 0.4 * (3 + 0.4);
	volume[10] = TS_PI * (0.16 * 3 + (1.21 - 0.16) * 0.1 * 2.5);
}

/* Errors of area and volume fall as 1/n^2, and both are too small: corners are on the surface. */
START_TEST(converge)
{
	enum { SHAPES = DECK_LENGTH(curved) };
	double area[SHAPES], volume[SHAPES], step[3], lost[2][3];
	const struct curved *c = &curved[_i];
	char words[200];

	exact_measures(area, volume);
	for (int k = 0; k < 3; k++) {
		int n = 40 << k;
		struct measures m;

		snprintf(words, sizeof words, "%s segments %d", c->words, n);
		m = measure(words);
		step[k] = 1.0 / n;
		lost[0][k] = 1 - m.area / area[_i];
		lost[1][k] = c->closed ? 1 - m.volume / volume[_i] : 0;
		ck_assert_uint_eq(m.rim > 0, !c->closed);
		ck_assert_msg(m.angle > 1, "%s: angle %g", words, m.angle);
		ck_assert_msg(lost[0][k] > 0 && lost[0][k] < 11.0 / n / n, "%s: area %g", words, lost[0][k]);
	}
	DECK_NEAR(deck_order(step + 1, lost[0] + 1, 2), 2, 0.06);
	if (c->closed) {
		ck_assert(lost[1][2] > 0);
		DECK_NEAR(deck_order(step + 1, lost[1] + 1, 2), 2, 0.06);
	}
}
END_TEST

/* Closed shapes of many proportions, with normals to either side. */
START_TEST(closed)
{
	static const char *const words[] = {
		"sphere radius 1 segments 3",
		"cylinder radius 0.1 length 9 segments 3",
		"cylinder radius 5 length 0.3",
		"cylinder radius 1 length 1 segments 1000",
		"tube radius 1 thickness 0.97 length 1",
		"tube radius 1 thickness 0.02 length 2",
		"cone radlo 1 radhi 0.01 length 2",
		"drum radius 1 length 2 lifters 1",
		"drum radius 1 length 2 lifters 2 height 0.8 width 0.5",
		"drum radius 1 length 0.1 lifters 24 height 0.1 width 0.02",
		"drum radius 1 length 2 lifters 6 height 0.2 width 0.9",
		"drum radius 1 length 2 lifters 4 segments 300 size 0.1",
		"drum radius 1 length 2",
		"screw radius 1 shaft 0.1 pitch 1 turns 1 thickness 0.1",
		"screw radius 1 shaft 0.9 pitch 0.2 turns 7.5 thickness 0.1 hand left length 3",
		"screw radius 1 shaft 0.3 pitch 2 turns 2.125 thickness 0.1 size 0.2",
		"box 0 1 0 0.01 0 0.02 size 0.1",
		"cylinder radius 1 length 1 size 0.05",
		"sphere radius 1 error 0.001",
		"cylinder radius 1 length 1 error 0.5",
		"revolve 0.5 0 0.5 1 1 1 0.7 0 0.5 0",
		"revolve 0 1 0.5 0.5 0.2 0 0 0 axis 1 2 3 angle 70",
	};
	struct measures m = measure(words[_i]), inward;
	char text[200];

	ck_assert_uint_eq(m.rim, 0);
	ck_assert(m.volume > 0);
	ck_assert_msg(m.angle > 0.5, "%s: angle %g", words[_i], m.angle);
	snprintf(text, sizeof text, "%s normals inward", words[_i]);
	inward = measure(text);
	DECK_NEAR(inward.volume, -m.volume, 1e-13 * m.volume);
	ck_assert_uint_eq(inward.rim, 0);
}
END_TEST

/* Along the axes of coordinates the corners are those of the upright shape, bit for bit. */
START_TEST(places)
{
	static const char *const words[] = { "drum radius 0.7 length 1.1 lifters 3 axis 0 0 1",
					     "drum radius 0.7 length 1.1 lifters 3 axis 2.385 0 0",
					     "drum radius 0.7 length 1.1 lifters 3 axis 0 3 0" };
	struct tsim *sim[2] = { open_box(), open_box() };
	size_t rim;
	const struct ts_mesh *up = make(sim[0], words[0], &rim), *other;

	for (size_t turn = 1; turn < 3; turn++) {
		other = make(sim[1], words[turn], &rim);
		ck_assert_uint_eq(other->n, up->n);
		for (size_t k = 0; k < 9 * up->n; k++)
			ck_assert(other->x[k / 9][k / 3 % 3][k % 3] ==
				  up->x[k / 9][k / 3 % 3][(k + 3 - turn) % 3]);
	}
	tsim_close(sim[0]);
	tsim_close(sim[1]);
}
END_TEST

/* Distances from the axis: every corner is on the surface, and the middle of every side within the error. */
START_TEST(chords)
{
	struct tsim *sim = open_box();
	double farthest = 0;
	size_t rim;
	const struct ts_mesh *m =
		make(sim, "cylinder radius 0.7 length 1 open both error 1e-3 base 1 2 3 axis 1 -1 0.5", &rim);
	const double base[3] = { 1, 2, 3 }, axis[3] = { 1 / 1.5, -1 / 1.5, 0.5 / 1.5 };

	for (size_t k = 0; k < 3 * m->n; k++) {
		const double *a = m->x[k / 3][k % 3], *b = m->x[k / 3][(k + 1) % 3];
		double arm[3], middle[3];

		ts_sub(a, base, arm);
		ts_axpy(-ts_dot(arm, axis), axis, arm);
		ck_assert(fabs(ts_norm(arm) - 0.7) < 1e-14);
		ts_add(a, b, middle);
		ts_scale(0.5, middle, middle);
		ts_sub(middle, base, arm);
		ts_axpy(-ts_dot(arm, axis), axis, arm);
		farthest = fmax(farthest, 0.7 - ts_norm(arm));
	}
	ck_assert(farthest < 1e-3 && farthest > 0.8e-3);
	m = make(sim, "sphere radius 0.7 error 1e-3", &rim);
	farthest = 0;
	for (size_t t = 0; t < m->n; t++)
		farthest = fmax(farthest, 0.7 - fabs(ts_dot(m->normal[t], m->x[t][0])));
	ck_assert(farthest < 1.02e-3 && farthest > 0.8e-3);
	m = make(sim, "screw radius 0.7 shaft 0.2 pitch 1 turns 2 thickness 0.1 size 0.08", &rim);
	for (size_t k = 0; k < 3 * m->n; k++)
		ck_assert(m->length[k / 3][k % 3] < 0.08 * 1.7);
	tsim_close(sim);
}
END_TEST

/* Edges that are not shared by exactly two triangles. */
static int lonely_edges(struct tsim *sim, const char *words)
{
	const struct ts_mesh *m;
	int n = 0;

	deck(sim, "fix shape all mesh/surface primitive %s type 1\n", words);
	m = &ts_mesh_surface_find(sim, "shape")->mesh;
	for (size_t k = 0; k < 3 * m->n; k++)
		n += m->neighbour[k / 3][k % 3] < 0;
	return n;
}

/* Open ends meet across the faces of a periodic box. */
START_TEST(periodic)
{
	struct tsim *sim = deck_open(BOX, "f f p", "-2 2 -2 2 -0.4 0.9");

	ck_assert_int_eq(lonely_edges(sim, "drum radius 1.1 length 1.3 lifters 5 open both base 0 0 -0.4"),
			 0);
	ck_assert_int_eq(lonely_edges(sim, "screw radius 1.1 shaft 0.4 pitch 0.65 turns 2 thickness 0.1 "
					   "periodic yes base 0 0 -0.4"),
			 0);
	ck_assert_int_eq(lonely_edges(sim,
				      "tube radius 1.1 length 1.3 thickness 0.1 open both base 0 0 -0.4"),
			 0);
	ck_assert_int_eq(lonely_edges(sim, "cylinder radius 1.1 length 1.2 open both base 0 0 -0.4"), 128);
	tsim_close(sim);
	sim = deck_open(BOX, "f p f", "-2 2 -1 1 -2 2");
	ck_assert_int_eq(lonely_edges(sim, "wedge width 1.1 outlet 0.2 depth 2 half_angle 30 ends no"),
			 4 * 3);
	tsim_close(sim);
}
END_TEST

/* Micrometres and kilometres in metres: the same triangles. */
START_TEST(scales)
{
	static const double factors[] = { 1e-6, 1e3 };
	struct measures one = measure("drum radius 1.5 length 2 lifters 4 height 0.25 width 0.125");

	for (int k = 0; k < 2; k++) {
		double s = factors[k];
		struct tsim *sim =
			deck_open("units si\nboundary m m m\nregion b block %g %g %g %g %g %g units box\n"
				  "create_box 1 b\nneighbor %g bin\n",
				  -2 * s, 2 * s, -2 * s, 2 * s, -1 * s, 3 * s, 1e-3 * s);
		const struct ts_mesh *m;
		char words[200];
		size_t rim;

		snprintf(words, sizeof words,
			 "drum radius %.17g length %.17g lifters 4 height %.17g width %.17g", 1.5 * s, 2 * s,
			 0.25 * s, 0.125 * s);
		m = make(sim, words, &rim);
		ck_assert_uint_eq(m->n, one.n);
		ck_assert_uint_eq(rim, 0);
		DECK_NEAR(ts_mesh_volume(m) / s / s / s, one.volume, 1e-12);
		tsim_close(sim);
	}
}
END_TEST

static const struct refusal {
	const char *words, *text;
} refusals[] = {
	{ "sfere radius 1", "did you mean 'sphere'" },
	{ "sphere radus 1", "did you mean 'radius'" },
	{ "sphere", "'radius' is missing" },
	{ "sphere radius 0", "radius" },
	{ "cylinder radius -1 length 1", "radius" },
	{ "cylinder radius 1 length 1 open left", "none, lower, upper, both" },
	{ "cylinder radius 1 length 1 axis 0 0 0", "axis has no length" },
	{ "cylinder radius 1 length 1 segments 2", "segments" },
	{ "cylinder radius 1 length 1 segments 8 error 0.1", "one of `segments` and `error`" },
	{ "cylinder radius 1 length 1 size 1e-5", "more than 2000000 triangles" },
	{ "cylinder radius 1 length 1 error 1e-12", "more than 2000000 triangles" },
	{ "sphere radius 1 error 1e-12", "more than 2000000 triangles" },
	{ "cylinder radius 1 length 1e-4", "sizes differ too much" },
	{ "box 0 1 0 1 1 0", "no volume" },
	{ "box 0 1 0 1", "zlo" },
	{ "box 0 1 0 1 0 1 open zhy", "did you mean 'zhi'" },
	{ "box 0 1 0 1 0 1 open xlo xhi ylo yhi zlo zhi", "all faces are open" },
	{ "disk radius 1 hole 1", "not smaller than the radius" },
	{ "tube radius 1 thickness 1 length 1", "not smaller than the radius" },
	{ "tube radius 1 thickness 1e-4 length 1", "sizes differ too much" },
	{ "cone radlo 0 radhi 0 length 1", "both 0" },
	{ "revolve 1 0 1", "pairs of numbers" },
	{ "revolve -1 0 1 1", "pairs of numbers" },
	{ "revolve 1 0 1 0", "are the same" },
	{ "revolve 1 0 x 1", "pairs of numbers" },
	{ "revolve 0 0 1 1 1 0 0 1", "crosses itself between points 1 and 2, and 3 and 4" },
	{ "hopper radius 1 outlet 1.5 half_angle 30", "not narrower" },
	{ "hopper radius 1 outlet 0.5 half_angle 0", "straight bin" },
	{ "wedge width 1 outlet 1 depth 1 half_angle 30", "not narrower" },
	{ "drum radius 1 length 1 lifters 4 height 1", "beyond the axis" },
	{ "drum radius 1 length 1 lifters 40 height 0.5", "touch each other" },
	{ "drum radius 1 length 1 lifters -1", "lifters" },
	{ "drum radius 1 length 1 height 0.1", "no `lifters`" },
	{ "drum radius 1 length 1 lifters 100000", "more than 64 segments" },
	{ "screw radius 1 shaft 0.2 pitch 0 turns 2 thickness 0.1", "pitch" },
	{ "screw radius 1 shaft 1.2 pitch 1 turns 2 thickness 0.1", "not thinner" },
	{ "screw radius 1 shaft 0.2 pitch 1 turns 2 thickness 1", "fills its pitch" },
	{ "screw radius 1 shaft 0.2 pitch 1 turns 2 thickness 0.1 length 2", "shorter than its flight" },
	{ "screw radius 1 shaft 0.2 pitch 1 turns 2.01 thickness 0.1", "whole number of segments" },
	{ "screw radius 1 shaft 0.2 pitch 1 turns 2.5 thickness 0.1 periodic yes", "whole number of turns" },
	{ "mixer radius 1 shaft 1 length 1 blades 2 width 0.1 thickness 0.1", "inside of the shaft" },
	{ "mixer radius 1 shaft 0.1 length 1 blades 2 width 0.1 thickness 0.1 at 1", "not on the shaft" },
	{ "sphere radius 1 base 20 0 0", "outside the box" },
	{ "sphere radius 1 primitive", "primitive" },
	{ "sphere radius 1 primitive primitive sphere radius 1", "shape" },
	{ "sphere radius 1 primitive sphere radius 1", "same corners" },
	{ "sphere radius 1 file x.stl", "found both" },
	{ "sphere radius 1 element_exclusion_list write x", "a primitive has none" },
};

START_TEST(refused)
{
	struct tsim *sim = open_box();

	ck_assert_msg(!deck_accepts(sim, "fix shape all mesh/surface primitive %s type 1\n",
				    refusals[_i].words),
		      "%s", refusals[_i].words);
	ck_assert_msg(strstr(tsim_error(sim), refusals[_i].text), "%s: %s", refusals[_i].words,
		      tsim_error(sim));
	tsim_close(sim);
}
END_TEST

/* Each allocation fails once: one clear error, and all memory is returned. */
START_TEST(memory)
{
	long before = ts_alloc_balance();
	bool done = false;

	for (long k = 1; !done; k += 1 + k / 8) {
		struct tsim *sim = open_box();

		ts_alloc_fail_at(k);
		done = deck_accepts(sim,
				    "fix shape all mesh/surface primitive drum radius 1 length 1 lifters 2 "
				    "segments 8 primitive revolve 1 0 1 1 segments 8 type 1\n");
		ts_alloc_fail_at(0);
		ck_assert(done || strstr(tsim_error(sim), "memory"));
		tsim_close(sim);
		ck_assert_int_eq(ts_alloc_balance(), before);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("shapes");
	TCase *shapes = tcase_create("shapes");

	tcase_set_timeout(shapes, 60);
	tcase_add_test(shapes, flat);
	tcase_add_test(shapes, polygons);
	tcase_add_loop_test(shapes, converge, 0, (int)DECK_LENGTH(curved));
	tcase_add_loop_test(shapes, closed, 0, 22);
	tcase_add_test(shapes, places);
	tcase_add_test(shapes, chords);
	tcase_add_test(shapes, periodic);
	tcase_add_test(shapes, scales);
	tcase_add_loop_test(shapes, refused, 0, (int)DECK_LENGTH(refusals));
	tcase_add_test(shapes, memory);
	suite_add_tcase(suite, shapes);
	return deck_main(suite);
}
