/* Bonds that soften (law/bond_softening.h): the curve and the work of a bond that is pulled, unloaded and compressed, by
 * hand; bending; shear; a shear strength that grows with the pressure; forces as derivatives of the energy; objectivity. */
#include "deck.h"

#include <math.h>

#include "law/bond_section.h"
#include "law/bond_softening.h"
#include "math/rng.h"

static const double RADIUS = 0.01, LENGTH = 0.03, KN = 2.385e11, KS = 0.9e11, STRENGTH = 1.1e6;

struct bond {
	struct ts_bond_element e, now; /* now: with the shear strength of the present pressure */
	struct ts_bond_ends s;
	struct ts_bond_damage damage;
	struct ts_bond_answer a;
	double lost;
};

static struct bond straight(double beta)
{
	struct bond b = { .e = { .length = LENGTH,
				 .fraction = 0.5,
				 .tension = STRENGTH,
				 .shear = INFINITY,
				 .compression = INFINITY } };

	ts_bond_section_parallel(RADIUS, KN, KS, &b.e);
	ts_bond_section_stress(RADIUS, 1, &b.e);
	ts_bond_softens_by(beta, false, &b.e);
	b.s.d = (struct ts_xyz){ LENGTH, 0, 0 };
	for (int k = 0; k < 2; k++)
		b.s.q[k] = (struct ts_wxyz){ 1, 0, 0, 0 };
	return b;
}

static void move(struct bond *b)
{
	double lost;

	b->now = b->e;
	ts_bond_elastic(&b->now, &b->s, &b->a);
	ts_bond_stress(&b->now, &b->a);
	ts_bond_rub(ts_bond_intact(b->e.rupture, b->damage.reached), &b->a, &b->now);
	b->damage = ts_bond_crack(&b->now, b->damage, &b->a, &lost);
	b->lost += lost;
	ts_bond_soften(ts_bond_intact(b->e.rupture, b->damage.reached), &b->s, &b->a);
}

/* Pulled to x times the opening of the strength; the force by the strength. */
static double pull(struct bond *b, double x)
{
	b->s.d.x = LENGTH + x * STRENGTH / KN;
	move(b);
	DECK_NEAR(-b->a.force.x, b->a.load[TS_BOND_NORMAL], 1e-9 * fabs(b->a.force.x) + 1e-9);
	return -b->a.force.x / (TS_PI * RADIUS * RADIUS * STRENGTH);
}

START_TEST(curve)
{
	const double beta = 0.25, all = 0.5 * STRENGTH * STRENGTH / KN * TS_PI * RADIUS * RADIUS;
	struct bond b = straight(beta);

	for (int n = 1; n <= 50; n++)
		DECK_NEAR(pull(&b, 0.02 * n), 0.02 * n, 1e-8);
	ck_assert_double_lt(b.lost, 1e-8 * all);
	for (int n = 1; n <= 20; n++)
		DECK_NEAR(pull(&b, 1 + 0.1 * n), 1 - beta * 0.1 * n, 1e-8);
	/* twice the triangle of (0, 0), (1, 1), (3, 1/2) */
	DECK_NEAR(b.lost / all, 2.5, 1e-8);
	DECK_NEAR(pull(&b, 1.5), 0.25, 1e-8);
	DECK_NEAR(pull(&b, -2), -2, 1e-8); /* a closed crack */
	DECK_NEAR(pull(&b, 2.7), 0.45, 1e-8);
	DECK_NEAR(b.lost / all, 2.5, 1e-8);
	for (int n = 1; n < 20; n++) /* steps of any size */
		DECK_NEAR(pull(&b, 3 + 0.1 * n), 0.5 - beta * 0.1 * n, 1e-8);
	ck_assert(ts_bond_holds(&b.e, &b.a));
	(void)pull(&b, 5 - 1e-9);
	DECK_NEAR(b.lost / all, b.e.rupture, 1e-7);
	(void)pull(&b, 5 + 1e-6);
	ck_assert(!ts_bond_holds(&b.e, &b.a));
}
END_TEST

/* Bent to twice the angle of the strength: the moment M_c (1 - beta). */
START_TEST(bent)
{
	const double beta = 0.25, moment = STRENGTH * TS_PI * pow(RADIUS, 3) / 4;
	struct bond b = straight(beta);
	double angle;

	angle = moment / b.e.k[TS_BOND_BENDING];
	for (int n = 1; n <= 40; n++) {
		b.s.q[0] = ts_wxyz_of_vector((struct ts_xyz){ 0, 0, -0.025 * n * angle });
		b.s.q[1] = ts_wxyz_of_vector((struct ts_xyz){ 0, 0, 0.025 * n * angle });
		move(&b);
	}
	DECK_NEAR(b.a.load[TS_BOND_BENDING] / moment, 1 - beta, 1e-6);
	DECK_NEAR(b.lost / (0.5 * moment * angle), 2 - (1 - beta), 1e-6);
}
END_TEST

/* Stress n along the bond, by the strength, and displacement x across it, by that of the shear strength: the shear force by
 * the shear strength without pressure. The direction does not turn with the displacement, so that all of it is shear. */
static double shear(struct bond *b, double n, double x)
{
	const double across = x * STRENGTH / KS, turn = asin(across / LENGTH);

	b->s.d = (struct ts_xyz){ LENGTH + n * STRENGTH / KN, 0, 0 };
	for (int k = 0; k < 2; k++)
		b->s.q[k] = ts_wxyz_of_vector((struct ts_xyz){ 0, 0, turn });
	move(b);
	return b->a.load[TS_BOND_SHEAR] / (TS_PI * RADIUS * RADIUS * STRENGTH);
}

static struct bond sheared(double friction)
{
	struct bond b = straight(INFINITY);

	b.e.tension = b.e.shear = STRENGTH;
	b.e.friction = friction;
	ts_bond_softens_by(0.25, true, &b.e);
	return b;
}

/* Softening by shear, under pressure: strength 1 + 0.6 * 0.5. */
START_TEST(shear_curve)
{
	const double friction = _i ? 0.6 : 0, most = 1 + 0.5 * friction;
	const double all = 0.5 * most * most * STRENGTH * STRENGTH / KS * TS_PI * RADIUS * RADIUS;
	struct bond b = sheared(friction);

	for (int n = 1; n <= 50; n++)
		DECK_NEAR(shear(&b, -0.5, 0.02 * n * most), 0.02 * n * most, 1e-6);
	ck_assert_double_lt(b.lost, 1e-6 * all);
	for (int n = 1; n < 40; n++)
		DECK_NEAR(shear(&b, -0.5, (1 + 0.1 * n) * most), (1 - 0.025 * n) * most, 1e-6);
	DECK_NEAR(b.a.load[TS_BOND_NORMAL], -0.5 * STRENGTH * TS_PI * RADIUS * RADIUS, 1e-6 * STRENGTH);
	DECK_NEAR(shear(&b, -0.5, 2 * most), 2 * (5 - 4.9) / (4 * 4.9) * most, 1e-6);
	DECK_NEAR(shear(&b, -0.5, 4.9999 * most), 0.25e-4 * most, 1e-6);
	ck_assert(ts_bond_holds(&b.now, &b.a));
	DECK_NEAR(b.lost / all, 5 - 4.9999 * 0.25e-4, 1e-6);
	(void)shear(&b, -0.5, 5.0001 * most);
	ck_assert(!ts_bond_holds(&b.now, &b.a));
}
END_TEST

/* Brittle bonds: Mohr and Coulomb, also in tension, up to where no shear strength is left. */
START_TEST(friction)
{
	for (int n = -30; n <= 9; n++) {
		struct bond b = straight(INFINITY);
		double most = 1 - 0.6 * 0.1 * n;

		b.e.tension = b.e.shear = STRENGTH;
		b.e.friction = 0.6;
		ts_bond_never_softens(&b.now);
		DECK_NEAR(shear(&b, 0.1 * n, most * (1 - 1e-6)) / most, 1, 2e-6);
		ck_assert(ts_bond_holds(&b.now, &b.a));
		(void)shear(&b, 0.1 * n, most * (1 + 1e-6));
		ck_assert(!ts_bond_holds(&b.now, &b.a));
	}
}
END_TEST

/* What a cracked section carries counts where it is pulled: it does not break by shear as long as g sigma tan(phi) is below
 * the strength. */
START_TEST(pulled_with_friction)
{
	struct bond b = sheared(0.9);

	for (int n = 1; n < 50; n++) {
		DECK_NEAR(shear(&b, 0.1 * n, 0), 0, 1e-12);
		ck_assert(ts_bond_holds(&b.now, &b.a));
		DECK_NEAR(b.a.load[TS_BOND_NORMAL] / (TS_PI * RADIUS * RADIUS * STRENGTH),
			  n < 10 ? 0.1 * n : 1 - 0.25 * (0.1 * n - 1), 1e-6);
	}
}
END_TEST

static struct ts_xyz random_vector(struct ts_rng *rng, double size)
{
	const double x = ts_rng_uniform(rng), y = ts_rng_uniform(rng), z = ts_rng_uniform(rng);

	return (struct ts_xyz){ size * (2 * x - 1), size * (2 * y - 1), size * (2 * z - 1) };
}

/* E at the present damage. */
static double energy(const struct bond *b)
{
	struct ts_bond_element e = b->e;
	struct ts_bond_answer a;
	double of[TS_BOND_MODES];

	ts_bond_elastic(&e, &b->s, &a);
	ts_bond_stress(&e, &a);
	ts_bond_soften_state(b->damage.reached, &b->s, &e, &a);
	ts_bond_energies(&e, &a, of);
	return of[0] + of[1] + of[2] + of[3];
}

/* A random state, pulled or pressed: the force is the derivative of the energy, and turns with the bond. */
START_TEST(any_state)
{
	struct ts_rng rng = ts_rng_start(2385, (uint64_t)_i);
	const struct ts_wxyz all = ts_wxyz_of_vector(random_vector(&rng, 3));
	const double h = 1e-7 * LENGTH;
	struct bond b = straight(0.1), c;
	struct ts_xyz turned;
	double part[2];

	for (int k = 0; k < 2; k++)
		b.s.q[k] = ts_wxyz_of_vector(random_vector(&rng, 2e-4));
	b.s.d = ts_xyz_add(b.s.d, 1, random_vector(&rng, 1e-5));
	b.damage.reached = 4;
	c = b;
	c.s.d = ts_wxyz_rotate(all, c.s.d);
	for (int k = 0; k < 2; k++)
		c.s.q[k] = ts_wxyz_product(all, c.s.q[k]);
	move(&b);
	move(&c);
	turned = ts_xyz_add(ts_wxyz_rotate(all, b.a.force), -1, c.a.force);
	ck_assert_double_lt(sqrt(ts_xyz_dot(turned, turned) / ts_xyz_dot(b.a.force, b.a.force)), 1e-8);
	ck_assert_double_eq_tol(b.damage.reached, c.damage.reached, 1e-8);
	DECK_NEAR(b.lost, c.lost, 1e-8 * (b.lost + 1e-9));
	for (int side = 0; side < 2; side++) {
		c = b;
		c.s.d.x += side ? h : -h;
		part[side] = energy(&c);
	}
	DECK_NEAR((part[0] - part[1]) / (2 * h), b.a.force.x, 1e-5 * sqrt(ts_xyz_dot(b.a.force, b.a.force)));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("soften");
	TCase *tests = tcase_create("bonds that soften");

	tcase_add_test(tests, curve);
	tcase_add_test(tests, bent);
	tcase_add_loop_test(tests, shear_curve, 0, 2);
	tcase_add_test(tests, friction);
	tcase_add_test(tests, pulled_with_friction);
	tcase_add_loop_test(tests, any_state, 0, 20);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
