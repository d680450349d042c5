/* Contact forces come in pairs of opposite central forces: the momentum of a cloud of colliding
 * particles stays, and in free space its angular momentum too, to rounding. */
#include "../deck.h"
#include "../cloud.h"

struct totals {
	double p[3], l[3], scale_p, scale_l;
};

static struct totals total(struct tsim *sim)
{
	struct cloud c = cloud_read(sim, 0);
	struct totals t = { 0 };

	for (size_t i = 0; i < CLOUD; i++) {
		for (int k = 0; k < 3; k++) {
			int a = (k + 1) % 3, b = (k + 2) % 3;
			double l = c.m[i] * (c.x[a][i] * c.v[b][i] - c.x[b][i] * c.v[a][i]);

			t.p[k] += c.m[i] * c.v[k][i];
			t.l[k] += l;
			t.scale_p += fabs(c.m[i] * c.v[k][i]);
			t.scale_l += fabs(l);
		}
	}
	return t;
}

static void conserved(const char *boundary, const char *integrator, bool angular)
{
	struct tsim *sim = cloud_open(boundary, "", integrator, cloud_start());
	struct totals before = total(sim), after;
	double energy = deck_value(sim, "ke");

	deck(sim, "run 3000");
	after = total(sim);
	/* there have been collisions: the dashpots have taken energy */
	ck_assert_double_lt(deck_value(sim, "ke"), 0.8 * energy);
	for (int k = 0; k < 3; k++) {
		DECK_NEAR(after.p[k], before.p[k], 1e-14 * before.scale_p);
		if (angular)
			DECK_NEAR(after.l[k], before.l[k], 3e-14 * before.scale_l);
	}
	tsim_close(sim);
}

static const char *const integrators[] = { "nve", "nve/symplectic", "nve/euler" };

START_TEST(periodic)
{
	conserved("p p p", integrators[_i], false);
}
END_TEST

/* Explicit Euler is left out: it changes x x m v by h^2 v x F per step. */
START_TEST(free_space)
{
	conserved("f f f", integrators[_i], true);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("momentum");
	TCase *tests = tcase_create("a cloud of colliding particles");

	tcase_set_timeout(tests, 30);
	tcase_add_loop_test(tests, periodic, 0, 3);
	tcase_add_loop_test(tests, free_space, 0, 2);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
