/* The elastic element of bonds (law/bond_element.h): forces are derivatives of the energy, conserve momentum and
 * angular momentum and ignore rigid motions, whatever the rotations; chains of elements have the exact deflections
 * of the discrete model, up to a full circle. */
#include "deck.h"

#include <math.h>
#include <string.h>

#include "law/beam.h"
#include "law/bond_element.h"
#include "law/bond_section.h"
#include "math/constants.h"
#include "math/rng.h"

/* Uneven numbers. */
static const struct ts_bond_element sample = { .length = 1.3,
					       .fraction = 0.37,
					       .k = { 23.85, 9.1, 3.7, 1.9 },
					       .c = { 0.7, 0.4, 0.31, 0.17 },
					       .tension = INFINITY,
					       .shear = INFINITY,
					       .compression = INFINITY };

static struct ts_xyz random_vector(struct ts_rng *rng, double size)
{
	struct ts_xyz a;

	a.x = size * (2 * ts_rng_uniform(rng) - 1);
	a.y = size * (2 * ts_rng_uniform(rng) - 1);
	a.z = size * (2 * ts_rng_uniform(rng) - 1);
	return a;
}

/* Deformed by about a third, relative rotation up to 60 degrees; both ends turned at random. */
static struct ts_bond_ends random_ends(struct ts_rng *rng)
{
	const struct ts_wxyz all = ts_wxyz_of_vector(random_vector(rng, 2));
	struct ts_bond_ends s;

	s.d = ts_wxyz_rotate(all,
			     ts_xyz_add((struct ts_xyz){ sample.length, 0, 0 }, 1, random_vector(rng, 0.3)));
	for (int k = 0; k < 2; k++) {
		s.q[k] = ts_wxyz_product(all, ts_wxyz_of_vector(random_vector(rng, 0.3)));
		s.omega[k] = random_vector(rng, 1);
	}
	s.v = random_vector(rng, 1);
	return s;
}

static double energy_of(const struct ts_bond_ends *s, struct ts_bond_answer *a)
{
	double energy[TS_BOND_MODES], sum = 0;

	ts_bond_elastic(&sample, s, a);
	ts_bond_energies(&sample, a, energy);
	for (int k = 0; k < TS_BOND_MODES; k++)
		sum += energy[k];
	return sum;
}

/* Change of the energy when coordinate k changes by h: 0..2 of d, 3..5 turns of a, 6..8 turns of b. */
static double energy_at(const struct ts_bond_ends *s, int k, double h)
{
	struct ts_bond_ends t = *s;
	struct ts_bond_answer a;
	struct ts_xyz step = { k % 3 == 0 ? h : 0, k % 3 == 1 ? h : 0, k % 3 == 2 ? h : 0 };

	if (k < 3)
		t.d = ts_xyz_add(t.d, 1, step);
	else
		t.q[k / 3 - 1] = ts_wxyz_product(ts_wxyz_of_vector(step), t.q[k / 3 - 1]);
	return energy_of(&t, &a);
}

START_TEST(derivatives_of_the_energy)
{
	struct ts_rng rng = ts_rng_start(2385, (uint64_t)_i);
	struct ts_bond_ends s = random_ends(&rng);
	struct ts_bond_answer a;
	const double h = 1e-3;

	energy_of(&s, &a);
	for (int k = 0; k < 9; k++) {
		const struct ts_xyz *of = k < 3 ? &a.force : &a.torque[k / 3 - 1];
		double force = k % 3 == 0 ? of->x : k % 3 == 1 ? of->y : of->z;
		/* fourth order */
		double slope = (8 * (energy_at(&s, k, h) - energy_at(&s, k, -h)) - energy_at(&s, k, 2 * h) +
				energy_at(&s, k, -2 * h)) /
			       (12 * h);

		DECK_NEAR(force, -slope, 2e-10);
	}
}
END_TEST

static void add_viscous(const struct ts_bond_ends *s, struct ts_bond_answer *a)
{
	ts_bond_elastic(&sample, s, a);
	ts_bond_viscous(&sample, s, a);
}

START_TEST(angular_momentum)
{
	struct ts_rng rng = ts_rng_start(2389, (uint64_t)_i);
	struct ts_bond_ends s = random_ends(&rng);
	struct ts_bond_answer a, elastic;
	struct ts_xyz sum;
	double power;

	add_viscous(&s, &a);
	sum = ts_xyz_add(ts_xyz_add(ts_xyz_cross(s.d, a.force), 1, a.torque[0]), 1, a.torque[1]);
	DECK_NEAR(sqrt(ts_xyz_dot(sum, sum)), 0, 3e-14);
	/* dashpots take energy */
	ts_bond_elastic(&sample, &s, &elastic);
	power = ts_xyz_dot(ts_xyz_add(a.force, -1, elastic.force), s.v);
	for (int k = 0; k < 2; k++)
		power += ts_xyz_dot(ts_xyz_add(a.torque[k], -1, elastic.torque[k]), s.omega[k]);
	ck_assert_double_lt(power, 0);
}
END_TEST

/* Turned as a whole, in a frame that turns as a whole: the same force and torques, and dashpots do not notice
 * a rotation at omega. */
START_TEST(rigid_motion)
{
	struct ts_rng rng = ts_rng_start(2393, (uint64_t)_i);
	const struct ts_wxyz by = ts_wxyz_of_vector(random_vector(&rng, 3));
	const struct ts_xyz omega = random_vector(&rng, 2);
	struct ts_bond_ends s = random_ends(&rng), t = s, rest = s;
	struct ts_bond_answer a, b;
	struct ts_xyz turned;

	t.d = ts_wxyz_rotate(by, s.d);
	for (int k = 0; k < 2; k++) {
		t.q[k] = ts_wxyz_product(by, s.q[k]);
		t.omega[k] = s.omega[k] = omega;
	}
	s.v = ts_xyz_cross(omega, s.d);
	t.v = ts_xyz_cross(omega, t.d);
	add_viscous(&s, &a);
	add_viscous(&t, &b);
	turned = ts_xyz_add(ts_wxyz_rotate(by, a.force), -1, b.force);
	DECK_NEAR(sqrt(ts_xyz_dot(turned, turned)), 0, 1e-13);
	for (int k = 0; k < 2; k++) {
		turned = ts_xyz_add(ts_wxyz_rotate(by, a.torque[k]), -1, b.torque[k]);
		DECK_NEAR(sqrt(ts_xyz_dot(turned, turned)), 0, 1e-13);
	}
	/* no force at all in the state of reference, however turned */
	rest.d = ts_wxyz_rotate(by, (struct ts_xyz){ sample.length, 0, 0 });
	rest.q[0] = rest.q[1] = by;
	ts_bond_elastic(&sample, &rest, &a);
	DECK_NEAR(sqrt(ts_xyz_dot(a.force, a.force)), 0, 1e-14 * sample.k[0]);
	DECK_NEAR(sqrt(ts_xyz_dot(a.torque[0], a.torque[0])), 0, 1e-14 * sample.k[0]);
}
END_TEST

START_TEST(rotation_vector)
{
	/* |phi| up to 90 degrees: load is stiffness times angle, for pure bending and pure twist */
	for (int step = 0; step <= 90; step++) {
		const double angle = step * TS_PI / 180;
		struct ts_bond_ends s = { .d = { 1, 0, 0 }, .q = { { 1, 0, 0, 0 } } };
		struct ts_bond_answer a;

		s.q[1] = ts_wxyz_of_vector((struct ts_xyz){ -angle, 0, 0 });
		ts_bond_elastic(&sample, &s, &a);
		DECK_NEAR(a.load[TS_BOND_TWIST], -sample.k[TS_BOND_TWIST] * angle, 1e-15);
		s.q[1] = ts_wxyz_of_vector((struct ts_xyz){ 0, 0.6 * angle, 0.8 * angle });
		ts_bond_elastic(&sample, &s, &a);
		DECK_NEAR(a.load[TS_BOND_BENDING], sample.k[TS_BOND_BENDING] * angle, 2e-15);
		DECK_NEAR(a.cosine, cos(angle / 2), 2e-16);
	}
}
END_TEST

/* ---- chains in equilibrium */

enum { N = 10, FREE = 6 * N };

struct chain {
	int n; /* elements, at most N */
	struct ts_bond_element e;
	struct ts_xyz x[N + 1];
	struct ts_wxyz q[N + 1];
	struct ts_xyz force, torque; /* on the last particle */
};

static void residual(const struct chain *c, double r[FREE])
{
	struct ts_xyz f[N + 1][2] = { { { 0 } } };

	f[c->n][0] = c->force;
	f[c->n][1] = c->torque;
	for (int k = 0; k < c->n; k++) {
		struct ts_bond_ends s = { .d = ts_xyz_add(c->x[k + 1], -1, c->x[k]),
					  .q = { c->q[k], c->q[k + 1] } };
		struct ts_bond_answer a;

		ts_bond_elastic(&c->e, &s, &a);
		f[k][0] = ts_xyz_add(f[k][0], -1, a.force);
		f[k + 1][0] = ts_xyz_add(f[k + 1][0], 1, a.force);
		f[k][1] = ts_xyz_add(f[k][1], 1, a.torque[0]);
		f[k + 1][1] = ts_xyz_add(f[k + 1][1], 1, a.torque[1]);
	}
	memcpy(r, f[1], FREE * sizeof *r);
}

static void displace(struct chain *c, int at, double h)
{
	const int node = at / 6 + 1, k = at % 3;
	const struct ts_xyz step = { k == 0 ? h : 0, k == 1 ? h : 0, k == 2 ? h : 0 };

	if (at % 6 < 3)
		c->x[node] = ts_xyz_add(c->x[node], 1, step);
	else
		c->q[node] = ts_wxyz_product(ts_wxyz_of_vector(step), c->q[node]);
}

/* Gauss-Jordan elimination with pivots. */
static void solve(int n, double a[FREE][FREE], double b[FREE])
{
	for (int k = 0; k < n; k++) {
		int best = k;

		for (int i = k; i < n; i++)
			best = fabs(a[i][k]) > fabs(a[best][k]) ? i : best;
		for (int j = 0; j < n; j++) {
			double t = a[k][j];

			a[k][j] = a[best][j];
			a[best][j] = t;
		}
		{
			double t = b[k];

			b[k] = b[best];
			b[best] = t;
		}
		for (int i = 0; i < n; i++) {
			double factor = i == k ? 0 : a[i][k] / a[k][k];

			for (int j = 0; j < n && factor != 0; j++)
				a[i][j] -= factor * a[k][j];
			b[i] -= factor * b[k];
		}
	}
	for (int k = 0; k < n; k++)
		b[k] /= a[k][k];
}

/* K = -dr/du by central differences. */
static void stiffness(const struct chain *c, double a[FREE][FREE])
{
	const double h = 1e-5;
	const int n = 6 * c->n;

	for (int j = 0; j < n; j++) {
		struct chain plus = *c, minus = *c;
		double up[FREE], down[FREE];

		displace(&plus, j, h);
		displace(&minus, j, -h);
		residual(&plus, up);
		residual(&minus, down);
		for (int i = 0; i < n; i++)
			a[i][j] = (down[i] - up[i]) / (2 * h);
	}
}

static void equilibrate(struct chain *c)
{
	static double a[FREE][FREE];
	double r[FREE];

	for (int round = 0; round < 12; round++) {
		residual(c, r);
		stiffness(c, a);
		solve(6 * c->n, a, r);
		for (int j = 0; j < 6 * c->n; j++)
			displace(c, j, r[j]);
	}
}

static const double E = 2.385e3, G = 0.93e3, RADIUS = 0.23, LENGTH = 7.1;
#define AREA (TS_PI * RADIUS * RADIUS)
#define INERTIA (TS_PI * RADIUS * RADIUS * RADIUS * RADIUS / 4)

static struct chain straight(void)
{
	struct chain c = { .n = N, .e = { .length = LENGTH / N, .fraction = 0.5 } };

	ts_bond_section_parallel(RADIUS, E * N / LENGTH, G * N / LENGTH, &c.e);
	for (int k = 0; k <= N; k++) {
		c.x[k] = (struct ts_xyz){ k * LENGTH / N, 0, 0 };
		c.q[k] = (struct ts_wxyz){ 1, 0, 0, 0 };
	}
	return c;
}

/* Angle about the axis with number `axis` of the last particle; small angles. */
static double slope(const struct chain *c, int axis)
{
	const struct ts_wxyz *q = &c->q[N];

	return 2 * atan2(axis == 0 ? q->x : axis == 1 ? q->y : q->z, q->w);
}

/* The exact answers of the discrete chain: the moments act half way between the particles. */
START_TEST(cantilever)
{
	struct chain c = straight();
	const double p = 1e-6, bending = p * pow(LENGTH, 3) / (3 * E * INERTIA) * (1 - 0.25 / (N * N));

	c.force.x = 1;
	equilibrate(&c);
	DECK_NEAR((c.x[N].x - LENGTH) / (LENGTH / (E * AREA)), 1, 1e-9);
	c = straight();
	c.force.y = p;
	equilibrate(&c);
	DECK_NEAR(c.x[N].y / (bending + p * LENGTH / (G * AREA)), 1, 1e-9);
	c = straight();
	c.torque.z = p;
	equilibrate(&c);
	DECK_NEAR(slope(&c, 2) / (p * LENGTH / (E * INERTIA)), 1, 1e-9);
	DECK_NEAR(c.x[N].y / (p * LENGTH * LENGTH / (2 * E * INERTIA)), 1, 1e-9);
	c = straight();
	c.torque.x = p;
	equilibrate(&c);
	DECK_NEAR(slope(&c, 0) / (p * LENGTH / (G * 2 * INERTIA)), 1, 1e-9);
}
END_TEST

/* An end moment 2 pi E I/L bends the chain to a closed regular polygon, in steps of a tenth. */
START_TEST(circle)
{
	struct chain c = straight();

	for (int k = 1; k <= 10; k++) {
		c.torque.y = -k * 0.1 * 2 * TS_PI * E * INERTIA / LENGTH;
		equilibrate(&c);
		DECK_NEAR(sin(slope(&c, 1) / 2), sin(-k * 0.1 * TS_PI), 1e-9);
	}
	DECK_NEAR(c.x[N].x, 0, 1e-9 * LENGTH);
	DECK_NEAR(c.x[N].z, 0, 1e-9 * LENGTH);
	/* all bonds as long as before: no force acts on the section */
	for (int k = 0; k < N; k++) {
		struct ts_xyz d = ts_xyz_add(c.x[k + 1], -1, c.x[k]);

		DECK_NEAR(sqrt(ts_xyz_dot(d, d)), LENGTH / N, 1e-9 * LENGTH);
	}
}
END_TEST

/* Beam elements: the deflections of the continuum, whatever their number. */
START_TEST(beams)
{
	const int n = _i + 1;
	const double p = 1e-6, kappa = ts_beam_shear_coefficient(0.3);
	struct chain c = straight(), start;

	c.n = n;
	c.e = (struct ts_bond_element){ .length = LENGTH / n };
	ts_beam_element(RADIUS, E, G, kappa, &c.e);
	for (int k = 0; k <= n; k++)
		c.x[k].x = k * LENGTH / n;
	start = c;
	c.force.z = p;
	equilibrate(&c);
	DECK_NEAR(c.x[n].z / (p * pow(LENGTH, 3) / (3 * E * INERTIA) + p * LENGTH / (kappa * G * AREA)), 1,
		  1e-9);
	c = start;
	c.torque.z = p;
	equilibrate(&c);
	DECK_NEAR(c.x[n].y / (p * LENGTH * LENGTH / (2 * E * INERTIA)), 1, 1e-9);
	c = start;
	c.torque.x = p;
	equilibrate(&c);
	DECK_NEAR(2 * c.q[n].x / (p * LENGTH / (G * 2 * INERTIA)), 1, 1e-9);
	c = start;
	c.force.x = 1;
	equilibrate(&c);
	DECK_NEAR((c.x[n].x - LENGTH) / (LENGTH / (E * AREA)), 1, 1e-9);
}
END_TEST

/* ---- strengths */

START_TEST(scatter)
{
	const int n = 20000;
	struct ts_bond_strength s = {
		.tension = 3, .shear = 5, .compression = NAN, .deviation = 0.2, .shape = 4
	};
	double sum[2] = { 0 }, square[2] = { 0 }, product = 0, mean, deviation;

	s.scatter = _i ? TS_BOND_WEIBULL : TS_BOND_GAUSS;
	s.seed = 7;
	for (int k = 0; k < n; k++) {
		const int32_t tag[2] = { k + 1, 3 * k + 2 };
		struct ts_bond_element e;
		double x[2];

		ts_bond_section_strength(&s, tag, &e);
		x[0] = e.tension / 3;
		x[1] = e.shear / 5;
		ck_assert(isinf(e.compression));
		for (int m = 0; m < 2; m++) {
			ck_assert_double_gt(x[m], 0);
			sum[m] += x[m];
			square[m] += x[m] * x[m];
		}
		product += (x[0] - 1) * (x[1] - 1);
	}
	/* Gamma(1.25), Gamma(1.5) */
	deviation = _i ? sqrt(tgamma(1.5) / pow(tgamma(1.25), 2) - 1) : 0.2;
	for (int m = 0; m < 2; m++) {
		mean = sum[m] / n;
		DECK_NEAR(mean, 1, 4 * deviation / sqrt(n));
		DECK_NEAR(sqrt(square[m] / n - mean * mean), deviation, 0.02 * deviation);
	}
	DECK_NEAR(product / n, 0, 4 * deviation * deviation / sqrt(n));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("bond element");
	TCase *tests = tcase_create("element");

	tcase_set_timeout(tests, 60);
	tcase_add_loop_test(tests, derivatives_of_the_energy, 0, 20);
	tcase_add_loop_test(tests, angular_momentum, 0, 20);
	tcase_add_loop_test(tests, rigid_motion, 0, 20);
	tcase_add_test(tests, rotation_vector);
	tcase_add_test(tests, cantilever);
	tcase_add_test(tests, circle);
	tcase_add_loop_test(tests, beams, 0, N);
	tcase_add_loop_test(tests, scatter, 0, 2);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
