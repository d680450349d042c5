/* Beams that yield (law/plastic_hinge.h): collapse loads and work of one element by hand, limits of moments and
 * objectivity at finite rotations. */
#include "deck.h"

#include <math.h>

#include "law/beam.h"
#include "law/plastic_hinge.h"
#include "math/rng.h"

static const double E = 2.385e9, RADIUS = 0.01, LENGTH = 0.2, STRESS = 1e5;

struct beam {
	struct ts_bond_element e;
	struct ts_plastic_section limit;
	struct ts_bond_ends s;
	double work;
	struct ts_bond_answer a;
};

static struct beam straight(void)
{
	struct beam b = { .e = { .length = LENGTH }, .limit = ts_plastic_circle(RADIUS, STRESS) };

	ts_beam_element(RADIUS, E, E / 2.6, INFINITY, &b.e);
	b.s.d = (struct ts_xyz){ LENGTH, 0, 0 };
	for (int k = 0; k < 2; k++)
		b.s.q[k] = (struct ts_wxyz){ 1, 0, 0, 0 };
	return b;
}

static void settle(struct beam *b)
{
	struct ts_plastic_flow flow;

	ts_plastic_relax(&b->e, &b->limit, &b->s, &flow);
	b->work += flow.work;
	ts_bond_elastic(&b->e, &b->s, &b->a);
}

static void turn(struct beam *b, int end, double x, double y, double z)
{
	b->s.q[end] = ts_wxyz_product(ts_wxyz_of_vector((struct ts_xyz){ x, y, z }), b->s.q[end]);
}

/* Both ends are clamped and displaced across the beam by w: P = 12 E I w/l^3 up to 2 M_p/l, then constant; the
 * work is that of the force on the plastic displacement, and unloading is elastic. The number of steps does not
 * matter. */
START_TEST(two_hinges)
{
	const double inertia = 0.25 * TS_PI * pow(RADIUS, 4), k = 12 * E * inertia / pow(LENGTH, 3);
	const double moment = 4.0 / 3 * pow(RADIUS, 3) * STRESS, limit = 2 * moment / LENGTH,
		     begin = limit / k;
	const int n = _i ? 400 : 5;
	struct beam b = straight();

	for (int i = 1; i <= n; i++) {
		double w = 3 * begin * i / n;

		b.s.d.y = w;
		settle(&b);
		/* the ends do not approach each other: the beam is stretched, (w/R)^2/6 */
		DECK_NEAR(-b.a.force.y / fmin(k * w, limit), 1, 1e-3);
	}
	DECK_NEAR(b.work / (limit * 2 * begin), 1, 1e-3);
	b.s.d.y = 2 * begin; /* the plastic displacement stays */
	settle(&b);
	DECK_NEAR(b.a.force.y / limit, 0, 1e-3);
}
END_TEST

/* End b is turned: M_b = 4 E I/l up to M_p, and M_a half of it. */
START_TEST(one_hinge)
{
	struct beam b = straight();
	const double k = 4 * b.e.k[TS_BOND_BENDING], moment = b.limit.moment, begin = moment / k;

	for (int i = 1; i <= 8; i++) {
		turn(&b, 1, 0, 0, 0.5 * begin);
		settle(&b);
		DECK_NEAR(-b.a.torque[1].z / moment, fmin(0.5 * i, 1), 1e-7);
		DECK_NEAR(-b.a.torque[0].z / moment, 0.5 * fmin(0.5 * i, 1), 1e-7);
	}
	DECK_NEAR(b.work / (moment * 3 * begin), 1, 1e-7);
}
END_TEST

START_TEST(torque)
{
	struct beam b = straight();
	const double limit = 2.0 / 3 * TS_PI * pow(RADIUS, 3) * STRESS / sqrt(3),
		     begin = limit / b.e.k[TS_BOND_TWIST];

	for (int i = 1; i <= 8; i++) {
		turn(&b, 1, -0.5 * begin, 0, 0);
		settle(&b);
		DECK_NEAR(b.a.torque[1].x / limit, fmin(0.5 * i, 1), 1e-9);
	}
	DECK_NEAR(b.work / (limit * 3 * begin), 1, 1e-9);
}
END_TEST

/* The force stays at N_p; the work of the force is what is lost and what is stored in the longer beam. */
START_TEST(elongation)
{
	const double sign = _i ? -1 : 1, area = TS_PI * RADIUS * RADIUS, limit = area * STRESS;
	struct beam b = straight();
	double r = LENGTH * (1 + sign * STRESS / E), put_in = 0.5 * limit * fabs(r - LENGTH);

	for (int i = 0; i < 50; i++) {
		const double next = r * (1 + 0.01 * sign), length = ts_plastic_length(&b.e, &b.limit, next);

		b.work += ts_plastic_stretch_work(&b.e, &b.limit, length);
		b.e.length = length;
		ts_beam_element(RADIUS, E, E / 2.6, INFINITY, &b.e);
		put_in += limit * fabs(next - r);
		r = next;
		DECK_NEAR(sign * b.e.k[TS_BOND_NORMAL] * (r - length), limit, 1e-9 * limit);
	}
	DECK_NEAR(b.work + 0.5 * limit * limit / b.e.k[TS_BOND_NORMAL], put_in, 1e-9 * put_in);
}
END_TEST

static struct ts_xyz random_vector(struct ts_rng *rng, double size)
{
	const double x = ts_rng_uniform(rng), y = ts_rng_uniform(rng), z = ts_rng_uniform(rng);

	return (struct ts_xyz){ size * (2 * x - 1), size * (2 * y - 1), size * (2 * z - 1) };
}

static struct beam turned_at_random(struct ts_rng *rng)
{
	struct beam b = straight();

	for (int k = 0; k < 2; k++) {
		struct ts_xyz by = random_vector(rng, 0.05);

		turn(&b, k, by.x, by.y, by.z);
	}
	b.s.d = ts_xyz_add(b.s.d, LENGTH, random_vector(rng, 0.02));
	return b;
}

static void near(struct ts_xyz a, struct ts_xyz b, double within)
{
	DECK_NEAR(a.x, b.x, within);
	DECK_NEAR(a.y, b.y, within);
	DECK_NEAR(a.z, b.z, within);
}

/* Both ends turned at random: no moment is above its limit, the same turned in space, and the flow costs work. */
START_TEST(any_rotation)
{
	struct ts_rng rng = ts_rng_start(2385, (uint64_t)_i);
	const struct ts_wxyz all = ts_wxyz_of_vector(random_vector(&rng, 3));
	struct beam b = turned_at_random(&rng), c = b;
	struct ts_xyz m[TS_PLASTIC_PLACES];

	c.s.d = ts_wxyz_rotate(all, c.s.d);
	for (int k = 0; k < 2; k++)
		c.s.q[k] = ts_wxyz_product(all, c.s.q[k]);
	settle(&b);
	settle(&c);
	ts_plastic_moments(&b.e, &b.s, m);
	for (int k = 0; k < TS_PLASTIC_PLACES; k++)
		ck_assert_double_le(sqrt(ts_xyz_dot(m[k], m[k])),
				    ts_plastic_limit(&b.limit, k) * (1 + 1e-11));
	ck_assert_double_gt(b.work, 0);
	DECK_NEAR(c.work / b.work, 1, 1e-10);
	near(ts_wxyz_rotate(all, b.a.torque[0]), c.a.torque[0], 1e-9 * b.limit.moment);
}
END_TEST

/* The same element seen from its other end: all moments change places. */
START_TEST(exchanged_ends)
{
	static const struct ts_wxyz back = { 0, 0, 0, 1 };
	struct ts_rng rng = ts_rng_start(77, (uint64_t)_i);
	struct beam b = turned_at_random(&rng), c = b;

	c.s.d = ts_xyz_scale(-1, b.s.d);
	for (int k = 0; k < 2; k++)
		c.s.q[k] = ts_wxyz_product(b.s.q[1 - k], back);
	settle(&b);
	settle(&c);
	ck_assert_double_gt(b.work, 0);
	DECK_NEAR(c.work / b.work, 1, 1e-10);
	for (int k = 0; k < 2; k++)
		near(b.a.torque[k], c.a.torque[1 - k], 1e-10 * b.limit.moment);
	near(b.a.force, ts_xyz_scale(-1, c.a.force), 1e-10 * b.limit.force);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("yield");
	TCase *tests = tcase_create("hinges");

	tcase_add_loop_test(tests, two_hinges, 0, 2);
	tcase_add_test(tests, one_hinge);
	tcase_add_test(tests, torque);
	tcase_add_loop_test(tests, elongation, 0, 2);
	tcase_add_loop_test(tests, any_rotation, 0, 40);
	tcase_add_loop_test(tests, exchanged_ends, 0, 40);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
