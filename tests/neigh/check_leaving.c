/* Particles that leave through fixed faces and are ignored are deleted in the same steps, whatever skin is
 * in use. */
#include "deck.h"

#include "core/sim.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

enum { STEPS = 400 };

/* Grains fly apart. */
static struct tsim *scatter(const char *neighbor)
{
	return deck_open("atom_style sphere\n"
			 "boundary f f f\n"
			 "region box block 0 1 0 1 0 1 units box\n"
			 "create_box 1 box\n"
			 "fix y all property/global youngsModulus peratomtype 5e6\n"
			 "fix n all property/global poissonsRatio peratomtype 0.3\n"
			 "fix e all property/global coefficientRestitution peratomtypepair 1 0.7\n"
			 "pair_style gran model hertz\n"
			 "pair_coeff * *\n"
			 "create_atoms 1 random 300 49979687 box\n"
			 "set type 1 diameter 0.04 density 2000\n"
			 "velocity all create 300 15485863\n"
			 "velocity all ramp vx -4 4 x 0 1\n"
			 "fix move all nve/limit radius_ratio 0.2\n"
			 "neighbor %s\n"
			 "thermo_modify lost ignore\n"
			 "timestep 2e-4\n"
			 "run 0\n",
			 neighbor);
}

START_TEST(same_steps)
{
	struct tsim *given = scatter("0.012 bin fixed yes"), *chosen = scatter("0.012 bin");
	size_t first = given->particles->n;

	for (int step = 0; step < STEPS; step++) {
		deck(given, "run 1 post no");
		deck(chosen, "run 1 post no");
		ck_assert_uint_eq(given->particles->n, chosen->particles->n);
	}
	ck_assert_uint_lt(given->particles->n, first * 3 / 4);
	ck_assert_double_gt(chosen->neigh->built_skin, 1.5 * 0.012);
	ck_assert_double_eq(given->neigh->built_skin, 0.012);
	tsim_close(given);
	tsim_close(chosen);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("leaving");
	TCase *tests = tcase_create("leaving");

	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, same_steps);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
