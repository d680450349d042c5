/* What must not matter: order of the particles, direction in space, a common velocity, which loop
 * evaluates the contacts, and whether an infinitely heavy, flat partner is a particle or a wall. */
#include "../cloud.h"
#include "../deck.h"
#include "particle/columns.h"

#include <string.h>

#include "core/sim.h"
#include "particle/particles.h"

enum { STEPS = 1200 };

static struct cloud after(const char *boundary, const char *options, struct cloud start)
{
	struct tsim *sim = cloud_open(boundary, options, "nve", start);
	double energy = deck_value(sim, "ke");
	struct cloud c;

	deck(sim, "run %d", STEPS);
	ck_assert_double_lt(deck_value(sim, "ke"), 0.9 * energy); /* there have been collisions */
	c = cloud_read(sim, 0);
	tsim_close(sim);
	return c;
}

/* Largest difference of positions by the size of the box, and of velocities by 1 m/s. */
static double difference(const struct cloud *a, const struct cloud *b)
{
	double most = 0;

	for (int k = 0; k < 3; k++)
		for (int i = 0; i < CLOUD; i++)
			most = fmax(most, fmax(fabs(a->x[k][i] - b->x[k][i]) / CLOUD_BOX,
					       fabs(a->v[k][i] - b->v[k][i])));
	return most;
}

/* The loop with the law inlined gives the bits of the one that calls it through a pointer. */
START_TEST(generic_loop)
{
	struct cloud a = after("p p p", "", cloud_start());
	struct cloud b = after("p p p", "generic", cloud_start());

	ck_assert(difference(&a, &b) == 0);
}
END_TEST

/* The order in memory, with the same identities: the same bits. */
START_TEST(order_in_memory)
{
	struct tsim *sim = cloud_open("p p p", "", "nve", cloud_start());
	struct cloud a = after("p p p", "", cloud_start()), b;
	int32_t order[CLOUD];
	double id[CLOUD];

	for (int i = 0; i < CLOUD; i++)
		order[i] = (29 * i + 11) % CLOUD;
	ck_assert(ts_particles_reorder(sim, order) == TS_OK);
	ck_assert(!tsim_column_read(sim, "id", id, CLOUD));
	ck_assert_double_eq(id[0], 12);
	deck(sim, "run %d", STEPS);
	b = cloud_read(sim, 0);
	ck_assert(difference(&a, &b) == 0);
	tsim_close(sim);
}
END_TEST

/* Other identities: sums of forces are in another order, so rounding differs, no more. */
START_TEST(order_of_creation)
{
	struct cloud start = cloud_start(), permuted, a = after("p p p", "", start), b, back;

	for (int i = 0; i < CLOUD; i++) {
		int from = (29 * i + 11) % CLOUD;

		for (int k = 0; k < 3; k++) {
			permuted.x[k][i] = start.x[k][from];
			permuted.v[k][i] = start.v[k][from];
		}
		permuted.m[i] = start.m[from];
		permuted.r[i] = start.r[from];
	}
	b = after("p p p", "", permuted);
	for (int i = 0; i < CLOUD; i++) {
		int from = (29 * i + 11) % CLOUD;

		for (int k = 0; k < 3; k++) {
			back.x[k][from] = b.x[k][i];
			back.v[k][from] = b.v[k][i];
		}
	}
	ck_assert_double_lt(difference(&a, &back), 1e-13);
}
END_TEST

/* By 90 degrees around `axis`. */
static struct cloud turned(const struct cloud *c, int axis)
{
	struct cloud t = *c;
	int x = (axis + 1) % 3, y = (axis + 2) % 3;

	for (int i = 0; i < CLOUD; i++) {
		t.x[x][i] = -c->x[y][i];
		t.x[y][i] = c->x[x][i];
		t.v[x][i] = -c->v[y][i];
		t.v[y][i] = c->v[x][i];
	}
	return t;
}

/* Around x and y squares are summed in another order; around z in the same, so bits stay. */
START_TEST(right_angle)
{
	struct cloud start = cloud_start(), other = turned(&start, _i);
	struct cloud a = after("f f f", "", start), b = after("f f f", "", other);

	a = turned(&a, _i);
	ck_assert_double_le(difference(&a, &b), _i == 2 ? 0 : 1e-13);
}
END_TEST

/* All move with a common velocity on top, through the faces of the periodic box. */
START_TEST(galilean)
{
	static const double velocity[3] = { 3.1, -2.3, 0.77 };
	struct cloud start = cloud_start(), moving = start;
	struct cloud a = after("p p p", "", start), b;
	struct tsim *sim;
	double time = STEPS * 1.1e-5;

	for (int k = 0; k < 3; k++)
		for (int i = 0; i < CLOUD; i++)
			moving.v[k][i] += velocity[k];
	sim = cloud_open("p p p", "", "nve", moving);
	deck(sim, "run %d", STEPS);
	b = cloud_read(sim, 0);
	for (int k = 0; k < 3; k++) {
		for (int i = 0; i < CLOUD; i++) {
			double d = b.x[k][i] - a.x[k][i] - velocity[k] * time;

			b.v[k][i] -= velocity[k];
			b.x[k][i] = a.x[k][i] + d - CLOUD_BOX * rint(d / CLOUD_BOX);
		}
	}
	ck_assert_double_lt(difference(&a, &b), 1e-10);
	tsim_close(sim);
}
END_TEST

/* Velocity after a sphere of radius 0.013 and mass 0.0231 has hit what `partner` says: sphere 2 of
 * radius R below, or a wall at z = 0. */
static void bounce(const char *partner, double radius, double partner_mass, double v[3])
{
	static const char *const names[] = { "vx", "vy", "vz" };
	struct tsim *sim = deck_open("units si\n"
				     "boundary f f f\n"
				     "region box block -0.5 0.5 -0.5 0.5 %.17g 0.5 units box\n"
				     "create_box 2 box\n"
				     "neighbor 0.003 bin\n"
				     "pair_style spring/dashpot\n"
				     "pair_coeff * * stiffness 2.385e4 restitution 0.63\n"
				     "create_atoms 1 single 0.031 -0.012 0.0131\n"
				     "set type 1 diameter 0.026 mass 0.0231 vx 0.3 vy 0.1 vz -0.7\n"
				     "timestep 1e-6\n"
				     "fix move all nve",
				     -2 * radius - 0.5);
	size_t n = 1;

	if (strcmp(partner, "wall") == 0) {
		deck(sim, "fix floor all wall/gran primitive type 2 zplane 0.0");
	} else {
		deck(sim,
		     "create_atoms 2 single 0.031 -0.012 %.17g\n"
		     "set type 2 diameter %.17g mass %.17g\n"
		     "group below type 2",
		     -radius, 2 * radius, partner_mass);
		n = 2;
		if (strcmp(partner, "frozen") == 0)
			deck(sim, "fix hold below freeze");
	}
	deck(sim, "run 6000");
	for (int k = 0; k < 3; k++) {
		double column[2];

		deck_column(sim, names[k], column, n, 0);
		v[k] = column[0];
	}
	ck_assert_double_gt(v[2], 0.3);
	tsim_close(sim);
}

static double distance(const double a[3], const double b[3])
{
	return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
		    (a[2] - b[2]) * (a[2] - b[2]));
}

/* An oblique blow: the frozen sphere's surface turns away from the plane as 1/R. */
START_TEST(wall_is_large_sphere)
{
	double wall[3], v[3], radius[3], off[3];

	bounce("wall", 0.1, 0, wall);
	for (int k = 0; k < 3; k++) {
		radius[k] = 1 / (k == 0 ? 1e1 : k == 1 ? 1e2 : 1e3);
		bounce("frozen", 1 / radius[k], 1, v);
		off[k] = distance(v, wall);
	}
	DECK_NEAR(deck_order(radius, off, 3), 1, 0.02);
	bounce("frozen", 1e6, 1, v);
	ck_assert_double_lt(distance(v, wall), 1e-6);
}
END_TEST

/* A free partner of mass M: m* = m - m^2/M ... */
START_TEST(frozen_is_heavy)
{
	double frozen[3], v[3], mass[3], off[3];

	bounce("frozen", 0.4, 1, frozen);
	for (int k = 0; k < 3; k++) {
		mass[k] = 1 / (k == 0 ? 1e1 : k == 1 ? 1e3 : 1e5);
		bounce("free", 0.4, 1 / mass[k], v);
		off[k] = distance(v, frozen);
	}
	DECK_NEAR(deck_order(mass, off, 3), 1, 0.02);
	/* the mass a frozen particle has by itself does not matter at all */
	bounce("frozen", 0.4, 1e-3, v);
	ck_assert(distance(v, frozen) == 0);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("invariance");
	TCase *tests = tcase_create("what must not matter");

	tcase_set_timeout(tests, 30);
	tcase_add_test(tests, generic_loop);
	tcase_add_test(tests, order_in_memory);
	tcase_add_test(tests, order_of_creation);
	tcase_add_loop_test(tests, right_angle, 0, 3);
	tcase_add_test(tests, galilean);
	tcase_add_test(tests, wall_is_large_sphere);
	tcase_add_test(tests, frozen_is_heavy);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
