/* Pictures: which samples a surface covers, which surface is seen, colours, threads. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "math/rng.h"
#include "render/colour_map.h"
#include "render/picture.h"

static const double PI = 3.14159265358979323846;
static const struct ts_colour red = { { 1, 0, 0 } }, blue = { { 0, 0, 1 } };

/* Looks along -z: x to the right, y upwards, a unit is a pixel. */
static struct ts_camera camera_of(uint32_t width, uint32_t height)
{
	struct ts_camera c = { .right = { 1, 0, 0 },
			       .up = { 0, 1, 0 },
			       .towards = { 0, 0, 1 },
			       .scale = 1,
			       .width = width,
			       .height = height };

	return c;
}

/* Ambient light only: colours are those of the surfaces. */
static const struct ts_picture_style flat = { .lights = { .ambient = 1 } };

static struct ts_picture draw(const struct ts_scene *scene, const struct ts_camera *camera,
			      const struct ts_picture_style *style, int threads)
{
	struct ts_picture p = { 0 };

	ck_assert(ts_picture_draw(&p, scene, camera, style, threads) == TS_OK);
	return p;
}

static const unsigned char *at(const struct ts_picture *p, uint32_t x, uint32_t y)
{
	return p->rgb + 3 * ((size_t)y * p->width + x);
}

static int lit(const struct ts_picture *p, int channel)
{
	int n = 0;

	for (uint32_t y = 0; y < p->height; y++)
		for (uint32_t x = 0; x < p->width; x++)
			n += at(p, x, y)[channel] > 0;
	return n;
}

/* A sphere covers just the pixels whose middle is in its disc, across tiles and beyond the edge of the picture. */
START_TEST(sphere_covers_its_disc)
{
	const struct ts_camera c = camera_of(203, 151);
	const double x[3] = { 23.85, -31.4, 7 }, r = 57.3;
	struct ts_scene scene = { 0 };
	struct ts_picture p;

	ck_assert(ts_scene_add_sphere(&scene, x, r, red, 1) == TS_OK);
	p = draw(&scene, &c, &flat, 1);
	for (uint32_t j = 0; j < p.height; j++)
		for (uint32_t i = 0; i < p.width; i++) {
			const double dx = i + 0.5 - 101.5 - x[0], dy = 75.5 - j - 0.5 - x[1];

			if ((dx * dx + dy * dy <= r * r) != (at(&p, i, j)[0] == 255))
				ck_abort_msg("pixel %u %u", i, j);
		}
	ts_picture_release(&p);
	ts_scene_release(&scene);
}
END_TEST

/* Of two spheres that intersect each pixel shows the one that is nearer there, whichever comes first. */
START_TEST(nearer_surface_is_seen)
{
	const struct ts_camera c = camera_of(160, 120);
	const double x[2][3] = { { -11.3, 4.1, 0 }, { 14.2, -3.3, 9.7 } }, r[2] = { 37.2, 29.4 };
	int both = 0;

	for (int order = 0; order < 2; order++) {
		struct ts_scene scene = { 0 };
		struct ts_picture p;

		for (int k = 0; k < 2; k++)
			ck_assert(ts_scene_add_sphere(&scene, x[k ^ order], r[k ^ order],
						      k ^ order ? blue : red, 1) == TS_OK);
		p = draw(&scene, &c, &flat, 1);
		for (uint32_t j = 0; j < p.height; j++)
			for (uint32_t i = 0; i < p.width; i++) {
				double z[2];

				for (int k = 0; k < 2; k++) {
					const double dx = i + 0.5 - 80 - x[k][0], dy = 60 - j - 0.5 - x[k][1];

					z[k] = x[k][2] + sqrt(r[k] * r[k] - dx * dx - dy * dy);
				}
				if (isnan(z[0]) || isnan(z[1]) || fabs(z[0] - z[1]) < 1e-3)
					continue;
				both++;
				ck_assert_int_eq(at(&p, i, j)[0], z[0] > z[1] ? 255 : 0);
				ck_assert_int_eq(at(&p, i, j)[2], z[0] > z[1] ? 0 : 255);
			}
		ts_picture_release(&p);
		ts_scene_release(&scene);
	}
	ck_assert_int_gt(both, 1000);
}
END_TEST

/* The silhouette of a rod with round ends is a rectangle and two half discs; a tilted one is shorter. */
START_TEST(rod_covers_its_silhouette)
{
	const struct ts_camera c = camera_of(400, 300);
	const double r = 23.7;

	for (int tilt = 0; tilt <= 80; tilt += 20) {
		const double length = 170 * cos(tilt * PI / 180), depth = 170 * sin(tilt * PI / 180);
		const double a[3] = { -0.5 * length * 0.8, -0.5 * length * 0.6, 0 };
		const double b[3] = { 0.5 * length * 0.8, 0.5 * length * 0.6, depth };
		const double area = 2 * r * length + PI * r * r;
		struct ts_scene scene = { 0 };
		struct ts_picture p;

		ck_assert(ts_scene_add_rod(&scene, a, b, r, red) == TS_OK);
		p = draw(&scene, &c, &flat, 1);
		ck_assert_double_eq_tol(lit(&p, 0), area, 0.004 * area);
		ts_picture_release(&p);
		ts_scene_release(&scene);
	}
}
END_TEST

/* Triangles that share edges cover each pixel once: with opacity 1/2 no pixel is darker or brighter. */
START_TEST(shared_edges_are_drawn_once)
{
	const struct ts_camera c = camera_of(150, 150);
	struct ts_scene scene = { 0 };
	struct ts_picture p;
	int inside = 0;

	for (int k = 0; k < 12; k++) { /* a fan around a point that is the middle of a pixel */
		double corner[3][3] = { { 0.5, 0.5, 0 } };

		for (int e = 0; e < 2; e++) {
			corner[1 + e][0] = 0.5 + 60 * cos((k + e) % 12 * PI / 6);
			corner[1 + e][1] = 0.5 + 60 * sin((k + e) % 12 * PI / 6);
			corner[1 + e][2] = 0;
		}
		ck_assert(ts_scene_add_triangle(&scene, (const double(*)[3])corner, red, 0.5) == TS_OK);
	}
	p = draw(&scene, &c, &flat, 1);
	for (uint32_t j = 0; j < p.height; j++)
		for (uint32_t i = 0; i < p.width; i++) {
			const double x = i - 75.0, y = 74.0 - j, d = sqrt(x * x + y * y);

			if (d < 57) {
				if (at(&p, i, j)[0] != 128)
					ck_abort_msg("pixel %u %u is %d", i, j, at(&p, i, j)[0]);
				inside++;
			} else if (d > 61)
				ck_assert_int_eq(at(&p, i, j)[0], 0);
		}
	ck_assert_int_gt(inside, 10000);
	ts_picture_release(&p);
	ts_scene_release(&scene);
}
END_TEST

/* A cone seen from the side is a triangle; along its axis, from either end, a disc; obliquely its base is an ellipse, and the
 * tangents from the tip touch it: the area between them and the ellipse follows from the eccentric angle of contact. */
START_TEST(cone_covers_its_silhouette)
{
	const struct ts_camera c = camera_of(400, 300);
	const double r = 61.3, length = 117.7;

	for (int tilt = -90; tilt <= 90; tilt += 15) {
		const double along = length * cos(tilt * PI / 180), depth = length * sin(tilt * PI / 180);
		const double half = r * fabs(sin(tilt * PI / 180)); /* of the ellipse, along the axis */
		const double base[3] = { -0.5 * along * 0.8, -0.5 * along * 0.6, 0 };
		const double tip[3] = { 0.5 * along * 0.8, 0.5 * along * 0.6, depth };
		const double touch = along > half ? acos(half / along) : 0;
		const double area = r * (along * sin(touch) + half * (PI - touch));
		struct ts_scene scene = { 0 };
		struct ts_picture p;

		ck_assert(ts_scene_add_cone(&scene, base, tip, r, red) == TS_OK);
		p = draw(&scene, &c, &flat, 1);
		ck_assert_double_eq_tol(lit(&p, 0), area, 0.006 * area);
		ts_picture_release(&p);
		ts_scene_release(&scene);
	}
}
END_TEST

/* Light from the camera only: the brightness of a surface is the cosine of its angle. */
static const struct ts_picture_style headlight = { .lights = { .ambient = 0.25, .fill = 0.75 } };

/* A plane that faces the camera cuts off the front of a sphere: the same disc, with a flat face in its middle. */
START_TEST(cut_faces_are_closed)
{
	const struct ts_camera c = camera_of(200, 200);
	const double x[3] = { 3.3, -5.2, 10 }, r = 71.9, height = 31.3, face = sqrt(r * r - height * height);
	const double square[3][3] = { { -90, -90, 0 }, { 90, -90, 0 }, { -90, 90, 0 } };
	struct ts_scene scene = { .cut = { { { 0, 0, 1 }, x[2] + height } }, .ncuts = 1 }, plane = { 0 };
	struct ts_picture p, q;
	int on_face = 0, disc = 0;

	ck_assert(ts_scene_add_sphere(&scene, x, r, red, 1) == TS_OK);
	ck_assert(ts_scene_add_triangle(&plane, square, red, 1) == TS_OK);
	p = draw(&scene, &c, &headlight, 1);
	q = draw(&plane, &c, &headlight, 1);
	for (uint32_t j = 0; j < 200; j++)
		for (uint32_t i = 0; i < 200; i++) {
			const double dx = i + 0.5 - 100 - x[0], dy = 99.5 - j - x[1],
				     d = sqrt(dx * dx + dy * dy);

			disc += at(&p, i, j)[0] > 0;
			if (d < face - 0.05) {
				on_face++;
				ck_assert_int_eq(at(&p, i, j)[0], at(&q, 30, 150)[0]);
			}
		}
	ck_assert_double_eq_tol(disc, PI * r * r, 0.004 * PI * r * r);
	ck_assert_double_eq_tol(on_face, PI * face * face, 0.006 * PI * face * face);
	ts_picture_release(&p);
	ts_picture_release(&q);
	ts_scene_release(&scene);
	ts_scene_release(&plane);
}
END_TEST

/* A plane seen from its edge halves spheres, rods, cones and triangles; one that faces away opens them; what is whole is
 * not cut; two planes leave a quarter. */
START_TEST(cuts_remove_what_is_beyond)
{
	const struct ts_camera c = camera_of(200, 200);
	const struct ts_scene_cut right = { { 1, 0, 0 }, 0 }, upper = { { 0, 1, 0 }, 0 };
	const struct ts_scene_cut back = { { 0, 0, -1 }, -20 }, all = { { 0, 0, 1 }, -80 };
	const double o[3] = { 0 }, a[3] = { -60, 0, 0 }, b[3] = { 60, 0, 0 };
	const double flag[3][3] = { { -60, 0, 0 }, { 60, 0, 0 }, { 0, 60, 0 } };
	const struct {
		struct ts_scene_cut cut[2];
		int ncuts, sphere, rod, triangle; /* part that is left, in quarters; -1: that of the cap */
	} cases[] = {
		{ { right }, 1, 2, 2, 2 },
		{ { right, upper }, 2, 1, 1, 0 },
		{ { all }, 1, 0, 0, 0 },
		{ { back }, 1, -1, 0, 0 },
	};
	const double r = 60, ball = PI * r * r, rod = 120 * 20 + PI * 100, cap = PI * (r * r - 400);

	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
		for (int what = 0; what < 4; what++) {
			struct ts_scene scene = { .ncuts = cases[k].ncuts };
			struct ts_picture p;
			const double whole = what == 0 ? ball : what == 1 ? rod : 3600;
			const int part = what == 0   ? cases[k].sphere
					 : what == 1 ? cases[k].rod
					 : what == 2 ? cases[k].triangle
						     : 4;
			const double area = part < 0 ? cap : whole * part / 4;

			memcpy(scene.cut, cases[k].cut, sizeof cases[k].cut);
			scene.whole = what == 3;
			if (what == 0)
				ck_assert(ts_scene_add_sphere(&scene, o, r, red, 1) == TS_OK);
			else if (what == 1)
				ck_assert(ts_scene_add_rod(&scene, a, b, 10, red) == TS_OK);
			else
				ck_assert(ts_scene_add_triangle(&scene, flag, red, 1) == TS_OK);
			p = draw(&scene, &c, &flat, 1);
			ck_assert_double_eq_tol(lit(&p, 0), area, 0.01 * whole);
			ts_picture_release(&p);
			ts_scene_release(&scene);
		}
}
END_TEST

/* Numbers between the corners of a triangle are linear; its colours do not depend on the lights. */
START_TEST(painted_triangles_show_numbers)
{
	const struct ts_camera c = camera_of(100, 100);
	const struct ts_scene_scale scale = { ts_colour_map_named("gray"), -50, 50 };
	struct ts_scene_triangle t = { .corner = { { -50, -50, 0 }, { 50, -50, 30 }, { -50, 50, -20 } },
				       .opacity = 1,
				       .unlit = true,
				       .scale = &scale,
				       .value = { -50, 50, -50 } }; /* x */
	struct ts_scene scene = { 0 };
	struct ts_picture p;

	ck_assert(ts_scene_add_painted(&scene, &t) == TS_OK);
	t.value[1] = NAN;
	t.corner[0][0] = t.corner[0][1] = 50; /* the other half of the square */
	ck_assert(ts_scene_add_painted(&scene, &t) == TS_OK);
	p = draw(&scene, &c, &headlight, 1);
	for (uint32_t i = 0; i < 90; i++)
		ck_assert_int_le(abs(at(&p, i, 98)[0] - (int)(255 * (i + 0.5) / 100 + 0.5)), 1);
	ck_assert(at(&p, 95, 10)[0] == 255 && at(&p, 95, 10)[1] == 0 && at(&p, 95, 10)[2] == 255);
	ts_picture_release(&p);
	ts_scene_release(&scene);
}
END_TEST

/* A quarter of red over blue. */
START_TEST(transparent_spheres_are_blended)
{
	const struct ts_camera c = camera_of(100, 100);
	const double near[3] = { 0, 0, 50 }, far[3] = { 0, 0, -50 };
	struct ts_scene scene = { 0 };
	struct ts_picture p;

	ck_assert(ts_scene_add_sphere(&scene, near, 20, red, 0.25) == TS_OK);
	ck_assert(ts_scene_add_sphere(&scene, far, 40, blue, 1) == TS_OK);
	ck_assert(ts_scene_add_sphere(&scene, far, 45, red, 0) == TS_OK);
	p = draw(&scene, &c, &flat, 1);
	ck_assert(at(&p, 50, 50)[0] == 64 && at(&p, 50, 50)[2] == 191);
	ck_assert(at(&p, 50, 20)[0] == 0 && at(&p, 50, 20)[2] == 255);
	ck_assert(at(&p, 50, 8)[2] == 0);
	ts_picture_release(&p);
	ts_scene_release(&scene);
}
END_TEST

/* The farthest surface has half of the colour of the ground, one in the middle a quarter. */
START_TEST(haze_grows_with_depth)
{
	const struct ts_picture_style style = { .lights = { .ambient = 1 },
						.ground = { blue, blue },
						.haze = 0.5 };
	const struct ts_camera c = camera_of(90, 30);
	struct ts_scene scene = { 0 };
	struct ts_picture p;

	for (int k = 0; k < 3; k++) {
		const double x = 30 * k - 45, z = 40 * k;
		const double corner[3][3] = { { x, -15, z }, { x + 30, -15, z }, { x, 15, z } };

		ck_assert(ts_scene_add_triangle(&scene, corner, red, 1) == TS_OK);
	}
	p = draw(&scene, &c, &style, 1);
	for (uint32_t k = 0; k < 3; k++)
		ck_assert_int_le(abs(at(&p, 30 * k + 5, 25)[2] - (int)(64 * (2 - k))), 1);
	ts_picture_release(&p);
	ts_scene_release(&scene);
}
END_TEST

static void add_random(struct ts_scene *scene)
{
	const struct ts_scene_cut oblique = { { 0.6, 0, 0.8 }, 20 };
	struct ts_rng rng = ts_rng_start(49979687, 0);
	double x[4][3];

	scene->cut[scene->ncuts++] = oblique;
	for (int k = 0; k < 600; k++) {
		for (int c = 0; c < 4; c++)
			for (int d = 0; d < 3; d++)
				x[c][d] = (c ? 0.2 : 1) * 200 * (ts_rng_uniform(&rng) - 0.5) +
					  (c ? x[0][d] : 0);
		ck_assert(ts_scene_add_sphere(scene, x[0], 2 + 10 * ts_rng_uniform(&rng),
					      ts_colour_of_type((size_t)k), k % 3 ? 1 : 0.5) == TS_OK);
		ck_assert(ts_scene_add_rod(scene, x[0], x[1], 2, red) == TS_OK);
		ck_assert(ts_scene_add_cone(scene, x[1], x[2], 4, blue) == TS_OK);
		ck_assert(ts_scene_add_triangle(scene, (const double(*)[3])x + 1, blue, k % 2 ? 1 : 0.4) ==
			  TS_OK);
	}
}

/* Threads, and the order in which spheres are given, change no byte; the memory of a picture serves the next. */
START_TEST(threads_change_nothing)
{
	const struct ts_picture_style style = { .lights = TS_LIGHTS_DEFAULT,
						.shiny = 1,
						.smooth = true,
						.occlusion = 0.6,
						.crevice = 10,
						.seed = 2385 };
	const struct ts_camera c = camera_of(219, 181);
	struct ts_scene scene = { 0 };
	struct ts_picture one, three;

	add_random(&scene);
	one = draw(&scene, &c, &style, 1);
	three = draw(&scene, &c, &style, 3);
	ck_assert(memcmp(one.rgb, three.rgb, (size_t)3 * 219 * 181) == 0);
	ck_assert(ts_picture_draw(&three, &scene, &c, &style, 2) == TS_OK);
	ck_assert(memcmp(one.rgb, three.rgb, (size_t)3 * 219 * 181) == 0);
	ck_assert_int_gt(lit(&one, 0), 219 * 181 / 4);
	ts_picture_release(&one);
	ts_picture_release(&three);
	ts_scene_release(&scene);
}
END_TEST

/* A picture does not depend on where tiles begin: that of a part is the part of the picture. */
START_TEST(tiles_do_not_show)
{
	const struct ts_picture_style style = { .lights = TS_LIGHTS_DEFAULT, .shiny = 1 };
	const struct ts_camera c = camera_of(220, 180);
	struct ts_camera part = camera_of(102, 82);
	struct ts_scene scene = { 0 };
	struct ts_picture whole, piece;
	int differ = 0;

	add_random(&scene);
	whole = draw(&scene, &c, &style, 1);
	part.centre[0] = -110 + 31 + 51; /* columns 31 .. 132, rows 17 .. 98 */
	part.centre[1] = 90 - 17 - 41;
	piece = draw(&scene, &part, &style, 1);
	for (uint32_t j = 0; j < 82; j++)
		for (uint32_t i = 0; i < 102; i++)
			for (int k = 0; k < 3; k++)
				differ += abs(at(&piece, i, j)[k] - at(&whole, i + 31, j + 17)[k]) > 1;
	ck_assert_int_le(differ, 12); /* samples on an edge, by rounding */
	ts_picture_release(&whole);
	ts_picture_release(&piece);
	ts_scene_release(&scene);
}
END_TEST

/* Nothing in the scene, one pixel, coordinates far beyond the picture or no numbers. */
START_TEST(odd_scenes)
{
	const struct ts_camera c = camera_of(1, 1);
	const double far[3] = { 1e30, -1e30, 1e300 }, nan3[3] = { NAN, 0, 0 }, zero[3] = { 0 };
	struct ts_scene scene = { 0 };
	struct ts_picture p = draw(&scene, &c, &flat, 2);

	ck_assert_int_eq(at(&p, 0, 0)[0], 0);
	ck_assert(ts_scene_add_sphere(&scene, nan3, 1, red, 1) == TS_OK);
	ck_assert(ts_scene_add_sphere(&scene, zero, 0, red, 1) == TS_OK);
	ck_assert(ts_scene_add_sphere(&scene, zero, NAN, red, 1) == TS_OK);
	ck_assert_uint_eq(scene.nspheres, 0);
	ck_assert(ts_scene_add_sphere(&scene, far, 1, red, 1) == TS_OK);
	ck_assert(ts_scene_add_rod(&scene, far, zero, 1e-3, red) == TS_OK);
	ck_assert(ts_scene_add_rod(&scene, zero, zero, 3, blue) == TS_OK); /* a ball */
	ck_assert(ts_picture_draw(&p, &scene, &c, &flat, 1) == TS_OK);
	ck_assert_int_eq(at(&p, 0, 0)[2], 255);
	ts_picture_release(&p);
	ts_scene_release(&scene);
}
END_TEST

/* The background: a gradient from the lower to the upper edge. */
START_TEST(background_is_a_gradient)
{
	const struct ts_picture_style style = { .ground = { red, blue } };
	const struct ts_camera c = camera_of(3, 101);
	const struct ts_scene scene = { 0 };
	struct ts_picture p = draw(&scene, &c, &style, 1);

	ck_assert_int_eq(at(&p, 1, 0)[2], 255);
	ck_assert_int_eq(at(&p, 1, 100)[0], 255);
	ck_assert_int_eq(at(&p, 1, 75)[0], 191);
	ts_picture_release(&p);
}
END_TEST

START_TEST(camera_has_orthonormal_axes)
{
	struct ts_camera c = camera_of(640, 480);
	const double length[3] = { 2, 3, 1 }, up[3] = { 0, 0, 1 }, x[3] = { 0.2, 0.3, 0.7 };
	double out[3];

	ck_assert(ts_camera_look(&c, PI / 3, PI / 6, up));
	ts_camera_zoom(&c, length, 1.5);
	ck_assert_double_eq_tol(c.scale, 480 * 1.5 / 6, 1e-12);
	/* towards = (sin 60 cos 30, sin 60 sin 30, cos 60), right = (-sin 30, cos 30, 0) */
	ts_camera_project(&c, x, out);
	ck_assert_double_eq_tol(out[0], 320 + c.scale * (-0.1 + 0.3 * sqrt(0.75)), 1e-10);
	ck_assert_double_eq_tol(out[2], c.scale * (0.2 * 0.75 + 0.3 * sqrt(0.75) / 2 + 0.35), 1e-10);
	ck_assert(!ts_camera_look(&c, 0, 0, up));
	ck_assert(!ts_camera_look(&c, 1, 0, (const double[3]){ 0 }));
}
END_TEST

/* The example of LAMMPS' manual: half-way from red to blue is purple; bins repeat; the first match counts. */
START_TEST(colour_maps)
{
	const struct ts_colour green = { { 0, 1, 0 } };
	const struct ts_colour_map_entry two[] = { { -INFINITY, 0, red }, { INFINITY, 0, blue } };
	const struct ts_colour_map_entry three[] = { { -INFINITY, 0, red },
						     { 0.25, 0, green },
						     { INFINITY, 0, blue } };
	const struct ts_colour_map_entry parts[] = { { 1, 2, green }, { -INFINITY, INFINITY, red } };
	struct ts_colour_map map = { .lo = NAN, .hi = NAN, .fractional = true, .entry = two, .n = 2 };
	double lo = INFINITY, hi = -INFINITY, values[] = { 3, NAN, -10, INFINITY, 0 };
	struct ts_colour c;

	ts_colour_map_extend(values, 5, 1, &lo, &hi);
	ts_colour_map_range(&map, &lo, &hi);
	ck_assert(lo == -10 && hi == 3);
	c = ts_colour_map_at(&map, -10, 0, -5);
	ck_assert(c.c[0] == 0.5F && c.c[1] == 0 && c.c[2] == 0.5F);
	ck_assert(ts_colour_map_at(&map, -10, 0, 77).c[2] == 1);
	ck_assert(ts_colour_map_at(&map, 4, 4, 4).c[0] == 1); /* all values the same */
	map.entry = three;
	map.n = 3;
	ck_assert(ts_colour_map_at(&map, 0, 8, 2).c[1] == 1);
	map.fractional = false;
	ck_assert(ts_colour_map_at(&map, 0, 8, 0.125).c[1] == 0.5F);
	map = (struct ts_colour_map){ .style = TS_MAP_DISCRETE, .entry = parts, .n = 2 };
	ck_assert(ts_colour_map_at(&map, 0, 5, 2).c[1] == 1 && ts_colour_map_at(&map, 0, 5, 2.1).c[0] == 1);
	map = (struct ts_colour_map){ .style = TS_MAP_SEQUENTIAL, .bin = 1, .entry = three, .n = 3 };
	ck_assert(ts_colour_map_at(&map, -1, 9, 0).c[1] == 1 && ts_colour_map_at(&map, -1, 9, 4.5).c[2] == 1);
}
END_TEST

/* All names are found, and own definitions go first. */
START_TEST(colour_names)
{
	const struct ts_colour_name mine[] = { { "red", { { 0, 0, 1 } } },
					       { "mud", { { 0.5F, 0.25F, 0 } } } };
	const struct ts_palette own = { mine, 2 }, none = { NULL, 0 };
	struct ts_colour c;

	ck_assert(ts_colour_find(&none, "forestgreen", &c) && c.c[0] == 34 / 255.0F &&
		  c.c[1] == 139 / 255.0F);
	ck_assert(ts_colour_find(&none, "0x6e7f80", &c) && c.c[0] == 110 / 255.0F && c.c[2] == 128 / 255.0F);
	ck_assert(!ts_colour_find(&none, "mud", &c) && !ts_colour_find(&none, "0x6e7f8", &c));
	ck_assert(ts_colour_find(&own, "red", &c) && c.c[2] == 1);
	ck_assert(ts_colour_find(&own, "mud", &c) && c.c[1] == 0.25F);
	c = ts_colour_of_type(16);
	ck_assert(memcmp(&c, &red, sizeof c) == 0);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("render");
	TCase *tests = tcase_create("render");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, sphere_covers_its_disc);
	tcase_add_test(tests, nearer_surface_is_seen);
	tcase_add_test(tests, rod_covers_its_silhouette);
	tcase_add_test(tests, cone_covers_its_silhouette);
	tcase_add_test(tests, cut_faces_are_closed);
	tcase_add_test(tests, cuts_remove_what_is_beyond);
	tcase_add_test(tests, painted_triangles_show_numbers);
	tcase_add_test(tests, transparent_spheres_are_blended);
	tcase_add_test(tests, haze_grows_with_depth);
	tcase_add_test(tests, shared_edges_are_drawn_once);
	tcase_add_test(tests, threads_change_nothing);
	tcase_add_test(tests, tiles_do_not_show);
	tcase_add_test(tests, odd_scenes);
	tcase_add_test(tests, background_is_a_gradient);
	tcase_add_test(tests, camera_has_orthonormal_axes);
	tcase_add_test(tests, colour_maps);
	tcase_add_test(tests, colour_names);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_ENV);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed != 0;
}
