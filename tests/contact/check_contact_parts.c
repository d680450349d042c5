/* Contact forces taken apart: the parts are the whole, the part of the normal spring is the slope of the
 * energy that it stores, and slip takes mu |F_n| times the way. For all laws, of pairs and at walls. */
#include <math.h>
#include <string.h>

#include "asserts.h"
#include "law/contact_parts.h"

static const struct ts_granular_pair stuff = {
	.young = 2.385e6,
	.shear = 0.731e6,
	.log_restitution = -0.31,
	.damping = -0.098,
	.velocity = 1.37,
	.kn = 2.3e5,
	.kt = 1.3e5,
	.gamman = 53,
	.gammat = 0.7,
	.friction = 0.43,
	.rolling_friction = 0.053,
	.rolling_viscosity = 0.12,
	.rolling_stiffness = 1.7,
	.cohesion = 3100,
	.viscosity = 0.0031,
	.critical_stokes = 3.1,
	.largest_restitution = 0.91,
	.unloading = 3.1,
	.adhesion = 0.31,
	.plasticity = 0.0031,
	.surface_energy = 0.3,
	.overlap_exponent = 1.5,
	.adhesion_exponent = 3.1,
	.pull_off = 0.031,
	.metre = 1,
	.roll_stiffness = 1.1e4,
	.roll_damping = 3.1,
	.twist_stiffness = 13,
	.twist_damping = 0.023,
	.twist_friction = 0.0031,
};

static struct ts_touch touch_of(const struct ts_granular_model *m, bool wall, double overlap)
{
	const double v[3] = { 0.37, -0.23, 0.41 }, wi[3] = { 3.1, -2.3, 5.3 }, wj[3] = { -1.7, 0.7, 2.3 };
	struct ts_touch t = { .wall = wall,
			      .n = { 0.6, 0.0, 0.8 },
			      .radius = { 0.053, wall ? 0 : 0.031 },
			      .mass = { 1.7, wall ? 0 : 0.31 },
			      .overlap = overlap,
			      .r_eff = wall ? 0.053 : 0.053 * 0.031 / 0.084,
			      .m_eff = wall ? 1.7 : 1.7 * 0.31 / 2.01 };

	t.distance = t.radius[0] + t.radius[1] - overlap;
	ts_granular_arms(m, &t);
	ts_touch_motion(&t, v, wi, wj);
	return t;
}

static void near(double a, double b, double size, const struct ts_granular_model *m, const char *what)
{
	ck_assert_msg(fabs(a - b) <= size, "%s of normal %d tangential %d rolling %d cohesion %d: %g, not %g",
		      what, m->normal, m->tangential, m->rolling, m->cohesion, a, b);
}

static void check_sums(const struct ts_granular_model *m, const struct ts_touch *t)
{
	double memory[TS_GRANULAR_MEMORY + 1] = { 0.0011, 0.0007, -0.0003, 0.013, 0.002 };
	struct ts_granular_force f;
	struct ts_contact_parts parts;

	ts_granular_contact(m, &stuff, t, 1e-5, true, memory, &f);
	ts_contact_split(m, &stuff, t, memory, f.force, f.roll, &parts);
	for (int d = 0; d < 3; d++) {
		double force = 0, turn = 0;

		for (int part = 0; part < TS_NPART; part++) {
			force += parts.force[part][d];
			turn += parts.turn[part][d];
		}
		near(force, f.force[d], 1e-12 * ts_norm(f.force), m, "sum of forces");
		near(turn, f.turn[d], 1e-12 * ts_norm(f.force), m, "sum of torques");
		near(parts.roll[d], f.roll[d], 0, m, "torque of rolling");
	}
	ck_assert(isfinite(parts.energy[0] + parts.energy[1] + parts.energy[2]));
	ck_assert(parts.energy[TS_STORE_SHEAR] >= 0 && parts.energy[TS_STORE_ROLLING] >= 0);
}

/* The energy of the normal spring, and its force. */
static double stored(const struct ts_granular_model *m, bool wall, double overlap, double *force)
{
	static const double none[3] = { 0 };
	const double memory[TS_GRANULAR_MEMORY + 1] = { 0 };
	struct ts_touch t = touch_of(m, wall, overlap);
	struct ts_contact_parts parts;

	ts_contact_split(m, &stuff, &t, memory, none, none, &parts);
	*force = ts_dot(parts.force[TS_PART_NORMAL], t.n);
	return parts.energy[TS_STORE_NORMAL];
}

static void check_slope(const struct ts_granular_model *m, bool wall, double overlap)
{
	double step = 1e-4 * overlap, force, other;
	double slope = (stored(m, wall, overlap + step, &other) - stored(m, wall, overlap - step, &other)) /
		       (2 * step);

	stored(m, wall, overlap, &force);
	if (m->normal != TS_NORMAL_HOOKE_HYSTERESIS && m->normal != TS_NORMAL_EDINBURGH)
		near(slope, force, 1e-7 * fabs(force), m, "slope of the energy");
}

START_TEST(test_all)
{
	for (int normal = TS_NORMAL_SPRING; normal < TS_NNORMAL; normal++)
		for (int tangential = 0; tangential < TS_NTANGENTIAL; tangential++)
			for (int rolling = 0; rolling <= TS_ROLLING_SDS; rolling++)
				for (int rest = 0; rest < 12; rest++) {
					const struct ts_granular_model m = {
						.normal = normal,
						.tangential = tangential,
						.rolling = rolling,
						.cohesion = rest % 3,
						.twisting = rest / 3 % 2 ? TS_TWISTING_SDS : 0,
						.damping = TS_DAMPING_TSUJI,
					};
					bool wall = rest / 6;
					struct ts_touch t = touch_of(&m, wall, 0.0023);

					check_sums(&m, &t);
					check_slope(&m, wall, 0.0023);
				}
}
END_TEST

/* A spring that slips all the time. */
START_TEST(test_slip)
{
	static const int laws[] = { TS_TANGENTIAL_HISTORY, TS_TANGENTIAL_INCREMENTAL, TS_TANGENTIAL_LINEAR,
				    TS_TANGENTIAL_MINDLIN_FORCE };

	for (size_t k = 0; k < sizeof laws / sizeof *laws; k++) {
		const struct ts_granular_model m = { .normal = k > 1 ? TS_NORMAL_AREA_HERTZ : TS_NORMAL_HERTZ,
						     .tangential = laws[k],
						     .no_tangential_damping = true };
		double memory[TS_GRANULAR_MEMORY + 1] = { 0 }, before[TS_GRANULAR_MEMORY + 1], dt = 1e-5;
		struct ts_touch t = touch_of(&m, false, 0.0023);
		struct ts_granular_pair c = stuff;
		struct ts_granular_force f;
		double lost;

		c.gammat = 0;
		for (int step = 0; step < 20000; step++) {
			memcpy(before, memory, sizeof before);
			ts_granular_contact(&m, &c, &t, dt, true, memory, &f);
		}
		lost = c.friction * fabs(f.normal) * ts_norm(t.slip) * dt;
		near(ts_slip_loss(&m, &c, &t, dt, before, memory), lost, 1e-9 * lost, &m, "slip");
		/* from half the spring nothing slips in one step */
		ts_scale(0.5, memory, memory);
		memcpy(before, memory, sizeof before);
		ts_granular_contact(&m, &c, &t, dt, true, memory, &f);
		near(ts_slip_loss(&m, &c, &t, dt, before, memory), 0, 1e-12, &m, "no slip");
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("contact_parts");
	TCase *all = tcase_create("contact parts");
	SRunner *runner;
	int failed;

	tcase_add_test(all, test_all);
	tcase_add_test(all, test_slip);
	suite_add_tcase(suite, all);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? 1 : 0;
}
