/* Contact laws by themselves: closed forms with uneven numbers, exchange of the partners, the wall as
 * limit of a large partner, restitution, and energy that never grows. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "law/granular_force.h"
#include "law/impact.h"

static const struct ts_granular_pair stuff = {
	.young = 2.385e6,
	.shear = 0.731e6,
	.log_restitution = -0.43,
	.damping = -0.1356,
	.velocity = 1.37,
	.kn = 2.3e5,
	.kt = 1.3e5,
	.gamman = 53,
	.gammat = 23,
	.friction = 0.31,
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
	.surface_energy = 0.53,
	.roll_stiffness = 1.1e4,
	.roll_damping = 0.31,
	.twist_stiffness = 0.23,
	.twist_damping = 1.7e-5,
	.twist_friction = 0.0011,
};

/* Two spheres that overlap along an oblique line, or the first of them and a wall. */
static struct ts_touch touch(double ri, double rj, double overlap, bool wall)
{
	static const double n[3] = { 2.0 / 7, -3.0 / 7, 6.0 / 7 };
	struct ts_touch t = { .overlap = overlap, .wall = wall };

	memcpy(t.n, n, sizeof n);
	t.radius[0] = ri;
	t.radius[1] = wall ? 0 : rj;
	t.distance = wall ? ri - overlap : ri + rj - overlap;
	t.r_eff = wall ? ri : ri * rj / (ri + rj);
	t.mass[0] = 9990 * ri * ri * ri;
	t.mass[1] = wall ? 0 : 7310 * rj * rj * rj;
	t.m_eff = wall ? t.mass[0] : t.mass[0] * t.mass[1] / (t.mass[0] + t.mass[1]);
	t.arm[0] = ri - overlap / 2;
	t.arm[1] = wall ? 0 : rj - overlap / 2;
	return t;
}

static struct ts_granular_force contact(const struct ts_granular_model *m, struct ts_touch t,
					const double v[3], const double wi[3], const double wj[3],
					double *memory)
{
	struct ts_granular_force f;
	double none[1] = { 0 }; /* of laws without a history */

	ts_granular_arms(m, &t);
	ts_touch_motion(&t, v, wi, wj);
	ts_granular_contact(m, &stuff, &t, 1e-5, true, memory ? memory : none, &f);
	return f;
}

static void close_to(double a, double b, double tolerance)
{
	ck_assert_msg(fabs(a - b) <= tolerance * fmax(fabs(a), fabs(b)), "%.17g is not %.17g", a, b);
}

START_TEST(hertz_and_hooke_at_rest)
{
	const double still[3] = { 0 };
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ };
	struct ts_touch t = touch(0.0123, 0.0231, 0.00037, false);
	double a = sqrt(t.r_eff) * stuff.young, v2 = stuff.velocity * stuff.velocity;

	close_to(contact(&m, t, still, still, still, NULL).normal, 4.0 / 3 * a * pow(t.overlap, 1.5), 1e-14);
	m.normal = TS_NORMAL_HOOKE;
	/* as deep as hertz at the characteristic velocity: k d^2 / 2 = 8/15 a d^2.5 = m* V^2 / 2 */
	close_to(contact(&m, t, still, still, still, NULL).normal,
		 t.m_eff * v2 / pow(pow(15.0 / 16 * t.m_eff * v2 / a, 0.4), 2) * t.overlap, 1e-13);
	m.normal = TS_NORMAL_HOOKE_STIFFNESS;
	close_to(contact(&m, t, still, still, still, NULL).normal, stuff.kn * t.overlap, 1e-15);
	m.normal = TS_NORMAL_HOOKE_MODULUS; /* 4 R E of both grains in series; here kn = 4 E */
	close_to(contact(&m, t, still, still, still, NULL).normal,
		 t.overlap / (1 / (stuff.kn * t.radius[0]) + 1 / (stuff.kn * t.radius[1])), 1e-14);
	m.normal = TS_NORMAL_HERTZ_STIFFNESS;
	close_to(contact(&m, t, still, still, still, NULL).normal,
		 stuff.kn * t.overlap * sqrt(t.r_eff * t.overlap), 1e-14);
}
END_TEST

static struct ts_granular_model area_model(int i)
{
	return (struct ts_granular_model){ .normal = TS_NORMAL_AREA_HOOKE + i % 4,
					   .tangential = TS_TANGENTIAL_LINEAR + i / 4 % 5,
					   .rolling = i / 20 % 2 ? TS_ROLLING_SDS : TS_ROLLING_OFF,
					   .twisting = i / 40 % 3,
					   .damping = i % 3 ? TS_DAMPING_VISCOELASTIC : TS_DAMPING_TSUJI,
					   .full_slip = true,
					   .wide = i % 7 == 0 };
}

/* What acts on j is what acts on i when the partners change places, reversed, to the last bit: which of them comes first
 * depends on the order in memory, and so on the number of ranks. */
static void change_places(struct ts_granular_model m)
{
	const double v[3] = { 0.31, -0.27, -0.83 }, back[3] = { -0.31, 0.27, 0.83 };
	const double wi[3] = { 3.1, -2.3, 7.7 }, wj[3] = { -1.3, 4.1, -5.9 };
	double memory[2][TS_GRANULAR_MEMORY] = { { 0 } };
	signed char sign[TS_GRANULAR_MEMORY + 1];
	struct ts_touch t = touch(0.0123, 0.0231, 0.00037, false);
	struct ts_touch s = touch(0.0231, 0.0123, 0.00037, false);

	for (int k = 0; k < 2; k++) {
		s.mass[k] = t.mass[!k];
		s.n[k] = -t.n[k];
	}
	s.n[2] = -t.n[2];
	s.m_eff = t.m_eff;
	ts_granular_memory_signs(&m, sign);
	for (int step = 0; step < 3; step++) {
		struct ts_granular_force a = contact(&m, t, v, wi, wj, memory[0]);
		struct ts_granular_force b = contact(&m, s, back, wj, wi, memory[1]);

		for (int k = 0; k < 3; k++) {
			ck_assert_double_eq(a.force[k], -b.force[k]);
			ck_assert_double_eq(a.turn[k], b.turn[k]);
			ck_assert_double_eq(a.roll[k], -b.roll[k]);
		}
		for (int k = 0; k < ts_granular_memory(&m); k++)
			ck_assert_double_eq(memory[0][k], sign[k] * memory[1][k]);
	}
}

START_TEST(partners_change_places)
{
	change_places((struct ts_granular_model){ .normal = 1 + _i % TS_NORMAL_HOOKE_HYSTERESIS,
						  .tangential = _i / 6 % (TS_TANGENTIAL_SLIDER + 1),
						  .rolling = _i / 24 % 5,
						  .cohesion = _i / 120 % 3 });
}
END_TEST

START_TEST(located_partners_change_places)
{
	change_places((struct ts_granular_model){ .normal = 1 + _i % TS_NORMAL_HERTZ_STIFFNESS,
						  .tangential = _i / 5 % (TS_TANGENTIAL_NO_HISTORY + 1),
						  .rolling = _i / 15 % 5,
						  .no_tension = _i % 2,
						  .located = true });
}
END_TEST

START_TEST(area_partners_change_places)
{
	change_places(area_model(_i));
}
END_TEST

/* delta(a) and its inverse; the force where surfaces part is 3 pi w R, and nowhere do they pull more. */
START_TEST(sticky_surfaces)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_AREA_JKR };
	double r = 0.0081, e = ts_jkr_modulus(&stuff), q = TS_PI * stuff.surface_energy / e;
	double reach = ts_jkr_reach(&stuff, r), most = 3 * TS_PI * stuff.surface_energy * r;

	for (int k = 0; k <= 40; k++) {
		double delta = -reach + k * k * 2.385e-7, a = ts_jkr_radius(&stuff, r, delta);
		struct ts_touch t = { .r_eff = r, .m_eff = 1, .overlap = delta };
		struct ts_normal n;

		ts_normal_force(&m, &stuff, &t, NULL, &n);
		ck_assert_double_eq_tol(a * a / r - 2 * sqrt(q * a), delta, 1e-9 * (reach + fabs(delta)));
		ck_assert_double_ge(n.force, -most * (1 + 1e-9));
		if (k == 0)
			close_to(n.force, -most, 1e-6);
	}
}
END_TEST

/* A very large, heavy partner at rest is a wall; of sjkr2 the wall has half. */
static void approach_wall(struct ts_granular_model m)
{
	const double v[3] = { 0.31, -0.27, -0.83 }, w[3] = { 3.1, -2.3, 7.7 }, still[3] = { 0 };
	double memory[2][TS_GRANULAR_MEMORY] = { { 0 } };
	struct ts_touch pair = touch(0.0123, 1e5, 0.00037, false);
	struct ts_touch wall = touch(0.0123, 0, 0.00037, true);
	struct ts_granular_force a, b;

	a = contact(&m, pair, v, w, still, memory[0]);
	b = contact(&m, wall, v, w, still, memory[1]);
	for (int k = 0; k < 3; k++) {
		ck_assert_double_eq_tol(a.force[k], b.force[k], 1e-5 * ts_norm(b.force));
		ck_assert_double_eq_tol(a.turn[k], b.turn[k], 1e-5 * ts_norm(b.force));
	}
}

START_TEST(wall_is_the_limit)
{
	approach_wall((struct ts_granular_model){ .normal = 1 + _i % TS_NORMAL_HOOKE_HYSTERESIS,
						  .tangential = _i / 6 % (TS_TANGENTIAL_SLIDER + 1),
						  .cohesion = _i / 24 % 2 });
}
END_TEST

START_TEST(wall_is_the_limit_of_areas)
{
	approach_wall(area_model(_i));
}
END_TEST

/* A head-on impact: the energy falls all the time, and the speed after it is e times that before. */
static double restitution(const struct ts_granular_model *m, const struct ts_granular_pair *c, double speed)
{
	struct ts_touch t = touch(0.0123, 0.0231, 0, false);
	double h = 1e-8, memory[TS_GRANULAR_MEMORY] = { 0 }, v = -speed, f = 0;

	for (;;) { /* velocity Verlet for overlap and approach speed */
		struct ts_granular_force out;

		v += 0.5 * h * f / t.m_eff;
		t.overlap -= h * v;
		if (t.overlap <= 0)
			return v / speed;
		t.distance = t.radius[0] + t.radius[1] - t.overlap;
		t.vn = v;
		ts_granular_contact(m, c, &t, h, true, memory, &out);
		f = out.normal;
		v += 0.5 * h * f / t.m_eff;
	}
}

START_TEST(restitution_is_kept)
{
	static const int laws[] = { TS_NORMAL_HERTZ, TS_NORMAL_HOOKE, TS_NORMAL_HOOKE_MODULUS };
	struct ts_granular_model m = { .normal = laws[_i % 3] };
	double e = 0.95 - 0.15 * (double)(_i / 3), log_e = log(e);
	struct ts_granular_pair c = stuff;

	c.log_restitution = log_e;
	c.damping = log_e / sqrt(log_e * log_e + TS_PI * TS_PI);
	close_to(restitution(&m, &c, 0.37), e, 2e-4);
	close_to(restitution(&m, &c, 1.91), e, 2e-4);
}
END_TEST

/* The motion of a single contact (law/impact.h), known at one overlap, has the force of the law at any other. */
START_TEST(impact_has_the_force_of_the_law)
{
	static const int laws[] = { TS_NORMAL_SPRING,	     TS_NORMAL_HERTZ,
				    TS_NORMAL_HOOKE,	     TS_NORMAL_HOOKE_STIFFNESS,
				    TS_NORMAL_HOOKE_MODULUS, TS_NORMAL_HERTZ_STIFFNESS };
	struct ts_granular_model m = { .normal = laws[_i % 6], .absolute_damping = _i >= 6 };
	const double at = 0.00037, overlaps[] = { 0.00023, 0.00037, 0.00111 };
	struct ts_touch t = touch(0.0123, 0.0231, at, false);
	struct ts_impact o;
	struct ts_normal n;
	double deepest[TS_NORMAL_MEMORY] = { 0 };

	ts_normal_force(&m, &stuff, &t, deepest, &n);
	ck_assert_double_gt(n.gamman, 0);
	o = ts_impact_of(&m, &t, &n);
	for (int k = 0; k < 3; k++) {
		t = touch(0.0123, 0.0231, overlaps[k], false);
		ts_normal_force(&m, &stuff, &t, deepest, &n);
		close_to(ts_impact_force(&o, overlaps[k], 0), n.kn * overlaps[k], 1e-13);
		close_to(ts_impact_force(&o, overlaps[k], 0.73) - ts_impact_force(&o, overlaps[k], 0),
			 0.73 * n.gamman, 1e-11);
	}
}
END_TEST

START_TEST(hysteresis_loses_energy)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HOOKE_HYSTERESIS };
	struct ts_granular_pair c = stuff;
	double soft, hard;

	c.log_restitution = -1e-9; /* no dashpot: the loss is that of the loop */
	c.plasticity = 0.31;
	soft = restitution(&m, &c, 0.37);
	c.unloading = 5.7;
	hard = restitution(&m, &c, 0.37);
	ck_assert_double_lt(soft, 0.95);
	ck_assert_double_lt(hard, soft); /* the steeper the unloading, the more is lost */
	ck_assert_double_gt(hard, 0);
}
END_TEST

/* Coulomb: a steady slip ends at mu F_n against it, and the spring remembers just that. */
START_TEST(friction_is_limited)
{
	const double v[3] = { 0.6, 0.4, 0 }, still[3] = { 0 }; /* v.n = 0 */
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY };
	struct ts_touch t = touch(0.0123, 0.0231, 0.00037, false);
	double xi[3] = { 0 }, tangential[3];
	struct ts_granular_force f;

	f = contact(&m, t, v, still, still, xi);
	for (int k = 0; k < 1000; k++)
		f = contact(&m, t, v, still, still, xi);
	for (int k = 0; k < 3; k++)
		tangential[k] = f.force[k] - f.normal * t.n[k];
	close_to(ts_norm(tangential), stuff.friction * f.normal, 1e-12);
	close_to(ts_dot(tangential, v), -ts_norm(tangential) * ts_norm(v), 1e-12);
	f = contact(&m, t, still, still, still, xi); /* held, the spring still pulls with it */
	for (int k = 0; k < 3; k++)
		ck_assert_double_eq_tol(f.force[k] - f.normal * t.n[k], tangential[k], 1e-14);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("law");
	TCase *c = tcase_create("contact");
	SRunner *runner;
	int failed;

	tcase_add_test(c, hertz_and_hooke_at_rest);
	tcase_add_loop_test(c, partners_change_places, 0, 360);
	tcase_add_loop_test(c, located_partners_change_places, 0, 75);
	tcase_add_loop_test(c, area_partners_change_places, 0, 120);
	tcase_add_loop_test(c, wall_is_the_limit, 0, 48);
	tcase_add_loop_test(c, wall_is_the_limit_of_areas, 0, 120);
	tcase_add_test(c, sticky_surfaces);
	tcase_add_loop_test(c, restitution_is_kept, 0, 12);
	tcase_add_loop_test(c, impact_has_the_force_of_the_law, 0, 12);
	tcase_add_test(c, hysteresis_loses_energy);
	tcase_add_test(c, friction_is_limited);
	suite_add_tcase(suite, c);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
