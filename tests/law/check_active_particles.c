/* Active particles in polishing: the numbers that follow from the inputs of the published comparison (625 um^2, radius
 * 0.272 um, standard deviation of the diameters 0.086 um, 4 % by volume, hardness 5 MPa and 2 GPa), and limits. */
#include <stdlib.h>

#include "asserts.h"
#include "law/active_particles.h"

#define assert_near(a, b, relative) ck_assert_double_eq_tol(a, b, (relative)*fabs((double)(b)))

/* um, uN: pressures in MPa */
static const struct ts_slurry slurry = { 0.272, 0.086, 0.04 };
static const struct ts_polish_contact contact = { .nominal_area = 625,
						  .real_area = 5.171,
						  .gap_volume = 625 * 9.69,
						  .asperity_volume = 267.6,
						  .pressure = 5,
						  .pad_hardness = 5,
						  .wafer_hardness = 2000 };

START_TEST(mono_layer)
{
	struct ts_active_particles n = ts_active_monolayer(&slurry, &contact);

	assert_near(ts_slurry_density(&slurry), 0.474531, 2e-6);
	assert_near(n.eligible, 380.24, 2e-5);
	assert_near(n.active, 3.146, 2e-4);
	assert_near(n.all, 0.474531 * 625 * 9.69, 2e-6);
}
END_TEST

START_TEST(indentation)
{
	struct ts_slurry equal = { 0.272, 0, 0.04 };
	struct ts_active_particles n = ts_active_indentation(&slurry, &contact);
	double largest = 0.401, t = largest * (2 - 0.5 - 5.0 / 4000);

	assert_near(n.eligible, 127, 2e-4);
	assert_near(ts_active_distance(&slurry, &contact), t, 1e-14);
	assert_near(n.active, n.eligible * 0.5 * erfc((t - 0.544) / 0.086 / sqrt(2)), 1e-12);
	assert_near(ts_active_indentation(&equal, &contact).active, n.eligible, 1e-14); /* all are equal */
	ck_assert_double_eq(ts_active_part(&equal, 0.55), 0);
	assert_near(ts_active_part(&slurry, 0.544), 0.5, 1e-14);
}
END_TEST

/* A pad that does not yield, and no wafer that is softer: only the tail beyond 3 s of the largest is active. */
START_TEST(rigid_solids)
{
	struct ts_polish_contact rigid = contact;

	rigid.pad_hardness = rigid.wafer_hardness = INFINITY;
	assert_near(ts_active_part(&slurry, ts_active_distance(&slurry, &rigid)), 0.5 * erfc(3 / sqrt(2)),
		    1e-12);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("active particles");
	TCase *tcase = tcase_create("models");
	SRunner *runner;
	int failed;

	tcase_add_test(tcase, mono_layer);
	tcase_add_test(tcase, indentation);
	tcase_add_test(tcase, rigid_solids);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
