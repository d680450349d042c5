/* Lubrication: published resistance functions, rigid motion, conservation, and the bound of the rates. */
#include <stdlib.h>

#include "asserts.h"
#include "law/lubrication.h"

#define assert_near(a, b, relative) ck_assert_double_eq_tol(a, b, (relative)*fabs((double)(b)))

static const struct ts_lubrication law = { 1.7, 1e-4, 0.5 };

static struct ts_lubrication_pair exchanged(const struct ts_lubrication_pair *c)
{
	struct ts_lubrication_pair out = { .radius = { c->radius[1], c->radius[0] }, .gap = c->gap };

	ts_scale(-1, c->n, out.n);
	ts_scale(-1, c->v, out.v);
	ts_scale(1, c->omega[1], out.omega[0]);
	ts_scale(1, c->omega[0], out.omega[1]);
	return out;
}

static void act(const struct ts_lubrication_pair *c, double force[3], double torque[3])
{
	for (int d = 0; d < 3; d++)
		force[d] = torque[d] = 0;
	ts_lubrication_add(&law, c, force, torque);
}

/* Goldman, Cox, Brenner 1967: translation along x and rotation about y above the plane z = 0. The lever arm a + h/2
 * differs from theirs, a, by terms that vanish with h. */
START_TEST(sphere_at_a_plane)
{
	double a = 3, h = 1e-3, l = log(a / h), f[3], t[3];
	struct ts_lubrication_pair c = {
		.radius = { a, INFINITY }, .gap = h, .n = { 0, 0, 1 }, .v = { 0.7, 0, 0 }
	};

	act(&c, f, t);
	assert_near(f[0], -6 * TS_PI * 1.7 * a * 0.7 * 8 / 15 * l, 1e-14);
	assert_near(t[1], 8 * TS_PI * 1.7 * a * a * 0.7 / 10 * l, 4 * h / a);
	c.v[0] = 0;
	c.omega[0][1] = 0.7;
	act(&c, f, t);
	assert_near(f[0], 6 * TS_PI * 1.7 * a * a * 0.7 * 2 / 15 * l, 4 * h / a);
	assert_near(t[1], -8 * TS_PI * 1.7 * a * a * a * 0.7 * 2 / 5 * l, 4 * h / a);
	c.omega[0][1] = 0;
	c.v[2] = -0.7;
	act(&c, f, t);
	assert_near(f[2], 6 * TS_PI * 1.7 * a * a / h * 0.7, 1e-14);
	ck_assert_double_eq(f[0], 0);
	ck_assert_double_eq(t[1], 0);
}
END_TEST

/* Jeffrey and Onishi 1984, with k = b/a: g2 of Y11^A, Y11^B, Y11^C and g4 of Y12^C, which is not used to derive A, B, C */
START_TEST(two_spheres)
{
	double a = 2, k = 1.7, b = k * a, h = 1e-9, l = log(a / 1e-4), f[3], t[3];
	struct ts_lubrication_pair c = { .radius = { a, b }, .gap = h, .n = { 0, 0, 1 }, .v = { 1, 0, 0 } };

	act(&c, f, t);
	assert_near(f[0], -6 * TS_PI * 1.7 * a * l * 4 * k * (2 + k + 2 * k * k) / (15 * pow(1 + k, 3)),
		    1e-8);
	assert_near(t[1], 4 * TS_PI * 1.7 * a * a * l * k * (4 + k) / (5 * pow(1 + k, 2)), 1e-8);
	c.v[0] = 0;
	c.omega[0][1] = 1;
	act(&c, f, t);
	assert_near(t[1], -8 * TS_PI * 1.7 * a * a * a * l * 2 * k / (5 * (1 + k)), 1e-8);
	c.omega[0][1] = 0;
	c.omega[1][1] = 1;
	act(&c, f, t);
	assert_near(fabs(t[1]), TS_PI * 1.7 * pow(a + b, 3) * l * 0.8 * k * k / pow(1 + k, 4), 1e-8);
	c.omega[1][1] = 0;
	c.v[2] = 1;
	act(&c, f, t);
	assert_near(f[2], -6 * TS_PI * 1.7 * pow(a * b / (a + b), 2) / 1e-4, 1e-14); /* gap `inner` */
}
END_TEST

/* Two equal spheres that counter-rotate, so that both surfaces move with the speed U = a omega: Reynolds' equation
 * div(H^3 grad p) = 12 mu U dH/dx in the gap H = h + r^2/a has the solution p = -12/5 mu U x/H^2. The shear stress
 * H/2 dp/dx of one surface has the sum 6/5 pi mu a U ln(a/h), up to terms that remain finite, at the lever arm a. */
START_TEST(counter_rotation)
{
	double a = 2, l = log(a / 1e-4), f[3], t[3];
	struct ts_lubrication_pair c = { .radius = { a, a }, .gap = 1e-9, .n = { 0, 0, 1 } };

	c.omega[0][1] = 0.8;
	c.omega[1][1] = -0.8;
	act(&c, f, t);
	ck_assert_double_eq(f[0], 0);
	assert_near(t[1], -6.0 / 5 * TS_PI * 1.7 * a * a * a * 0.8 * l, 1e-12);
}
END_TEST

static const struct ts_lubrication_pair moving = { .radius = { 2.3, 0.9 },
						   .gap = 0.013,
						   .n = { 2.0 / 7, 3.0 / 7, 6.0 / 7 },
						   .v = { 0.3, -1.1, 0.45 },
						   .omega = { { 0.6, 0.21, -0.8 }, { -0.35, 1.3, 0.11 } } };

START_TEST(conserved)
{
	struct ts_lubrication_pair other = exchanged(&moving);
	double f[2][3], t[2][3], moment[3], distance = 2.3 + 0.9 + 0.013;

	act(&moving, f[0], t[0]);
	act(&other, f[1], t[1]);
	ts_cross(moving.n, f[0], moment);
	for (int d = 0; d < 3; d++) {
		ck_assert_double_eq(f[0][d], -f[1][d]);
		ck_assert_double_eq_tol(t[0][d] + t[1][d] + distance * moment[d], 0, 1e-12 * ts_norm(t[0]));
	}
	/* it dissipates */
	ck_assert_double_lt(ts_dot(f[0], moving.v) + ts_dot(t[0], moving.omega[0]) +
				    ts_dot(t[1], moving.omega[1]),
			    0);
}
END_TEST

START_TEST(rigid_motion)
{
	struct ts_lubrication_pair c = moving;
	double distance = 2.3 + 0.9 + 0.013, f[3], t[3], scale[3], unused[3];

	act(&c, scale, unused);
	ts_scale(1, c.omega[0], c.omega[1]);
	ts_cross(c.omega[0], c.n, c.v);
	ts_scale(distance, c.v, c.v);
	act(&c, f, t);
	ck_assert_double_lt(ts_norm(f), 1e-14 * ts_norm(scale));
	ck_assert_double_lt(ts_norm(t), 1e-13 * ts_norm(unused));
}
END_TEST

/* Nothing at `outer`, no slip resistance where min(a, b) is less than the gap. */
START_TEST(cut_off)
{
	struct ts_lubrication_resistance k;
	const double large[2] = { 5, 5 }, small[2] = { 0.1, 5 };

	ts_lubrication_resistance(&law, large, 0.5, &k);
	ck_assert(k.normal == 0 && k.slip == 0 && k.rolling == 0);
	ts_lubrication_resistance(&law, large, 0.499999, &k);
	ck_assert(k.normal > 0 && k.slip > 0);
	ts_lubrication_resistance(&law, small, 0.2, &k);
	ck_assert(k.normal > 0 && k.slip == 0 && k.mixed == 0 && k.rolling == 0);
	ts_lubrication_resistance(&law, large, -0.3, &k);
	assert_near(k.normal, 6 * TS_PI * 1.7 * 2.5 * 2.5 / 1e-4, 1e-14);
}
END_TEST

/* The power dissipated by any motion is at most the bound of the rates times twice the kinetic energy. */
START_TEST(bound)
{
	for (int k = 0; k < 4000; k++) {
		struct ts_lubrication_pair c = moving, other;
		double v[2][3], m[2] = { 0.3 + k % 7, 0.2 + k % 3 }, inertia[2], energy = 0, rate = 0, power,
				f[3], t[2][3];

		c.gap = k % 2 ? 0.4 : 0.002; /* slip, or squeeze, is the faster one */
		for (int d = 0; d < 3; d++)
			for (int e = 0; e < 2; e++) {
				v[e][d] = sin(1.7 * k + 2.1 * d + 4.9 * e);
				c.omega[e][d] = (k % 5) * cos(2.3 * k + 1.1 * d + 3.7 * e);
			}
		ts_sub(v[0], v[1], c.v);
		other = exchanged(&c);
		act(&other, f, t[1]);
		act(&c, f, t[0]);
		power = ts_dot(f, c.v) + ts_dot(t[0], c.omega[0]) + ts_dot(t[1], c.omega[1]);
		for (int e = 0; e < 2; e++) {
			const struct ts_lubrication_pair *side = e ? &other : &c;

			inertia[e] = 0.4 * m[e] * side->radius[0] * side->radius[0];
			energy += m[e] * ts_dot(v[e], v[e]) + inertia[e] * ts_dot(c.omega[e], c.omega[e]);
			rate = fmax(rate, ts_lubrication_rate(&law, side->radius, c.gap, 1 / m[e],
							      1 / inertia[e], 1 / m[!e]));
		}
		ck_assert_double_le(-power, rate * energy * (1 + 1e-12));
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("lubrication");
	TCase *tcase = tcase_create("law");
	SRunner *runner;
	int failed;

	tcase_add_test(tcase, sphere_at_a_plane);
	tcase_add_test(tcase, two_spheres);
	tcase_add_test(tcase, counter_rotation);
	tcase_add_test(tcase, conserved);
	tcase_add_test(tcase, rigid_motion);
	tcase_add_test(tcase, cut_off);
	tcase_add_test(tcase, bound);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
