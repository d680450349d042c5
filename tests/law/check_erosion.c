/* Laws of erosion and wear: closed forms at exact points, limits, continuity, and input that makes no sense. */
#include <stdlib.h>

#include "asserts.h"
#include "law/archard.h"
#include "law/erosion_bitter.h"
#include "law/erosion_finnie.h"
#include "law/erosion_neilson.h"
#include "law/erosion_oka.h"
#include "law/erosion_zhao_chang.h"
#include "math/constants.h"

#define assert_near(a, b, relative) ck_assert_double_eq_tol(a, b, (relative)*fabs((double)(b)))

static const struct ts_erosion_finnie finnie = { 2.2e9, 2, 2, 1 };
static const struct ts_erosion_neilson neilson = { 1.3e10, 3.1e10, 4.7, 0.42 };
static const struct ts_erosion_bitter bitter = { 3.1e10, 1.3e10, 0.65, 2.3e-11, 0.013 };
static const struct ts_erosion_zhao_chang zhao = { 5.3e10, 2.7e9, 0.04, 0, false, false };

static double radians(double degrees)
{
	return degrees * TS_PI / 180;
}

/* A grain of 25 um with the density 2900 kg/m^3. */
static struct ts_erosion_impact grain(double normal, double tangential)
{
	double d = 24.89e-6;

	return (struct ts_erosion_impact){ 2900 * TS_PI / 6 * d * d * d, d, normal, tangential };
}

static struct ts_erosion_impact grain_at(double speed, double angle)
{
	struct ts_erosion_impact i = grain(0, 0);

	return ts_erosion_impact_at(i.mass, i.diameter, speed, angle);
}

START_TEST(components_of_the_velocity)
{
	struct ts_erosion_impact i = ts_erosion_impact_at(3, 2, 5, asin(0.6));

	assert_near(i.normal, 3, 1e-15);
	assert_near(i.tangential, 4, 1e-15);
	ck_assert_double_lt(ts_erosion_impact_at(3, 2, 5, -0.1).normal, 0);
}
END_TEST

START_TEST(finnie_values)
{
	double peak = 0.5 * atan(2.0 / 3), v = 105, limit = atan(finnie.force_ratio / 6);
	struct ts_erosion_impact i = grain_at(v, peak);
	double scale = i.mass * v * v / (2.2e9 * 2 * 2);

	ck_assert_double_eq_tol(peak * 180 / TS_PI, 16.845, 5e-4);
	assert_near(ts_erosion_finnie_volume(&finnie, &i), scale * (sqrt(3.25) - 1.5), 1e-14);
	ck_assert_double_eq_tol(sqrt(3.25) - 1.5, 0.30278, 5e-6);
	for (int sign = -1; sign <= 1; sign += 2) {
		struct ts_erosion_impact aside = grain_at(v, peak + sign * 1e-3), at = grain_at(v, limit);

		at.normal *= 1 + sign * 1e-13;
		ck_assert_double_lt(ts_erosion_finnie_volume(&finnie, &aside),
				    ts_erosion_finnie_volume(&finnie, &i));
		assert_near(ts_erosion_finnie_volume(&finnie, &at), scale * 0.3, 1e-12);
	}
	i = grain_at(v, radians(60));
	assert_near(ts_erosion_finnie_volume(&finnie, &i), scale / 12, 1e-14);
	i = grain(v, 0);
	ck_assert_double_eq(ts_erosion_finnie_volume(&finnie, &i), 0);
}
END_TEST

START_TEST(neilson_values)
{
	struct ts_erosion_impact at = grain_at(105, neilson.transition), i = grain(105, 0), below = at;
	double excess = at.normal - 4.7;

	/* both branches at alpha0 */
	assert_near(ts_erosion_neilson_volume(&neilson, &at),
		    0.5 * at.mass * (at.tangential * at.tangential / 1.3e10 + excess * excess / 3.1e10),
		    1e-14);
	below.normal *= 1 - 1e-12;
	assert_near(ts_erosion_neilson_volume(&neilson, &below), ts_erosion_neilson_volume(&neilson, &at),
		    1e-11);
	assert_near(ts_erosion_neilson_volume(&neilson, &i), 0.5 * i.mass * 100.3 * 100.3 / 3.1e10, 1e-14);
	/* a third of alpha0: sin 30 degrees; no deformation below K */
	i = grain_at(4.7, neilson.transition / 3);
	assert_near(ts_erosion_neilson_volume(&neilson, &i),
		    0.25 * i.mass * i.tangential * i.tangential / 1.3e10, 1e-14);
}
END_TEST

/* The speed K is that at which the largest pressure of Hertz' contact, 3 F/(2 pi a^2), reaches y. */
START_TEST(yield_speed_is_that_of_hertz)
{
	double y = 1.9e9, modulus = 5.3e10, speed = ts_erosion_yield_speed(y, 2900, modulus);
	struct ts_erosion_impact i = grain(speed, 0);
	double r = 0.5 * i.diameter, peak = ts_zhao_hertz_peak(modulus, &i);
	double force = 4.0 / 3 * modulus * sqrt(r * peak) * peak;

	assert_near(1.5 * force / (TS_PI * r * peak), y, 1e-13);
	/* all energy is elastic */
	assert_near(0.4 * force * peak, 0.5 * i.mass * speed * speed, 1e-13);
	assert_near(ts_erosion_bitter_cutting(1.9e9, 2900), 0.288 / 1.9e9 * pow(2900 / 1.9e9, 0.25), 1e-14);
	assert_near(ts_erosion_bitter_elastic(1.9e9, 2900, modulus),
		    0.82 * pow(1.9e9 / modulus, 2) * pow(1.9e9 / 2900, 0.25), 1e-14);
}
END_TEST

START_TEST(bitter_values)
{
	double n = 40, excess = n - 0.65, x = 2.3e-11 * excess * excess / sqrt(n);
	double elastic = 0.013 * pow(excess, 1.5), meet = 2 * x * 1.3e10 + sqrt(elastic);
	struct ts_erosion_impact at = grain(n, meet), above = grain(n, meet * (1 + 1e-12)), i = grain(n, 400);
	double crater = 0.5 * i.mass * excess * excess / 3.1e10;

	assert_near(ts_erosion_bitter_volume(&bitter, &at),
		    crater + 0.5 * at.mass * (meet * meet - elastic) / 1.3e10, 1e-13);
	assert_near(ts_erosion_bitter_volume(&bitter, &above), ts_erosion_bitter_volume(&bitter, &at), 1e-11);
	assert_near(ts_erosion_bitter_volume(&bitter, &i), crater + 2 * i.mass * x * (400 - x * 1.3e10),
		    1e-13);
	i = grain(n, 0); /* the motion along the surface has less energy than elastic deformation takes */
	assert_near(ts_erosion_bitter_volume(&bitter, &i), crater, 1e-15);
	i = grain(0.65, 100); /* elastic */
	ck_assert_double_eq(ts_erosion_bitter_volume(&bitter, &i), 0);
}
END_TEST

static struct ts_erosion_oka oka_of(enum ts_erosion_oka_particle particle, double gpa)
{
	struct ts_erosion_oka_set set = ts_erosion_oka_set_of(particle);

	return ts_erosion_oka_of(&set, 1e9 * gpa, 0);
}

START_TEST(oka_angles)
{
	struct ts_erosion_oka law = oka_of(TS_OKA_SIO2, 1.12);
	double peak = ts_erosion_oka_peak(&law), most = ts_erosion_oka_angle(&law, peak);

	ck_assert_double_eq(ts_erosion_oka_angle(&law, 1), 1);
	ck_assert_double_eq(ts_erosion_oka_angle(&law, 0), 0);
	ck_assert_double_eq_tol(asin(peak) * 180 / TS_PI, 28.313, 1e-2);
	ck_assert_double_gt(most, ts_erosion_oka_angle(&law, peak + 1e-3));
	ck_assert_double_gt(most, ts_erosion_oka_angle(&law, peak - 1e-3));
	/* a hard surface wears most at 90 degrees */
	law = oka_of(TS_OKA_GLASS, 9);
	ck_assert_double_eq(ts_erosion_oka_peak(&law), 1);
	ck_assert_double_lt(ts_erosion_oka_angle(&law, 0.99), 1);
	/* s1 Hv^q1 and s2 Hv^q2: 0.8 and 1.3 in the example of Fluent for sand and steel */
	law = oka_of(TS_OKA_SIO2, 1.8);
	assert_near(law.n1, 0.71 * pow(1.8, 0.14), 1e-15);
	assert_near(law.n2, 2.4 * pow(1.8, -0.94), 1e-15);
	ck_assert_double_eq_tol(law.k2, 2.35, 5e-3);
}
END_TEST

START_TEST(oka_volumes)
{
	static const double rate[] = { 65, 45, 27 }, exponent[] = { 2.3, 3, 2.1 };
	struct ts_erosion_impact i = grain(0, 0);

	for (int k = 0; k < TS_OKA_PARTICLES; k++) {
		struct ts_erosion_oka law = oka_of(k, 1);
		double once, twice, large;

		/* at 1 GPa, V' and D': K mm^3/kg */
		i.normal = k == TS_OKA_SIO2 ? 104 : k == TS_OKA_SIC ? 99 : 100;
		i.diameter = k == TS_OKA_GLASS ? 200e-6 : 326e-6;
		once = ts_erosion_oka_volume(&law, &i);
		assert_near(once, i.mass * rate[k] * 1e-9, 1e-14);
		i.normal *= 2;
		twice = ts_erosion_oka_volume(&law, &i);
		assert_near(twice, once * pow(2, exponent[k]), 1e-14);
		i.diameter *= 2;
		large = ts_erosion_oka_volume(&law, &i);
		assert_near(large, twice * pow(2, 0.19), 1e-14);
	}
}
END_TEST

START_TEST(oka_hardness)
{
	struct ts_erosion_oka_set set = ts_erosion_oka_set_of(TS_OKA_SIO2);
	struct ts_erosion_oka soft = oka_of(TS_OKA_SIO2, 1.12), hard = oka_of(TS_OKA_SIO2, 2.77);
	struct ts_erosion_oka relaxed = ts_erosion_oka_of(&set, 1.12e9, 1000);
	struct ts_erosion_impact i = grain_at(105, radians(30)), flat = i;

	assert_near(soft.normal_rate, 65e-9 * pow(1.12, -0.12), 1e-14);
	assert_near(relaxed.normal_rate, 65e-9 * pow(1000, 0.12), 1e-14);
	ck_assert_double_gt(ts_erosion_oka_volume(&soft, &i), ts_erosion_oka_volume(&hard, &i));
	/* the same angle: the exponent of the speed, 2.3 Hv^0.038 */
	flat.normal *= 3;
	flat.tangential *= 3;
	assert_near(ts_erosion_oka_volume(&soft, &flat),
		    ts_erosion_oka_volume(&soft, &i) * pow(3, 2.3 * pow(1.12, 0.038)), 1e-13);
}
END_TEST

/* The numbers of doc/erosion.md. */
START_TEST(oka_of_three_surfaces)
{
	static const struct {
		double hv, angle, normal, exponent;
	} of[] = { { 22.4, 17.6, 0.48, 2.17 }, { 112, 28.1, 0.63, 2.31 }, { 277.3, 39.6, 0.76, 2.39 } };

	for (int k = 0; k < 3; k++) {
		struct ts_erosion_oka law = oka_of(TS_OKA_SIO2, 9.80665e-3 * of[k].hv);
		double peak = ts_erosion_oka_peak(&law);

		ck_assert_double_eq_tol(asin(peak) * 180 / TS_PI, of[k].angle, 0.06);
		ck_assert_double_eq_tol(1 / ts_erosion_oka_angle(&law, peak), of[k].normal, 5e-3);
		ck_assert_double_eq_tol(law.k2, of[k].exponent, 5e-3);
	}
}
END_TEST

START_TEST(normal_impacts_on_steel)
{
	struct ts_erosion_oka oka = oka_of(TS_OKA_SIO2, 9.80665e-3 * 277.3);
	struct ts_erosion_zhao_chang law = { 5.63e10, 9.80665e6 * 277.3, 0.02, 0, false, false };
	struct ts_erosion_impact i = grain(105, 0);

	ck_assert_double_eq_tol(1e9 * ts_erosion_oka_volume(&oka, &i) / i.mass, 36.2, 0.05);
	ck_assert_double_eq_tol(1e9 * ts_erosion_zhao_chang_volume(&law, &i) / i.mass, 40.5, 0.05);
}
END_TEST

START_TEST(archard_values)
{
	assert_near(ts_archard_volume(0.003, 1.7e9, 23, 0.4), 0.003 * 23 * 0.4 / 1.7e9, 1e-15);
	assert_near(ts_archard_volume(0.003, 1.7e9, 23, -0.4), 0.003 * 23 * 0.4 / 1.7e9, 1e-15);
	ck_assert_double_eq(ts_archard_volume(0.003, 1.7e9, -23, 0.4), 0);
	ck_assert_double_eq(ts_archard_volume(0.003, 1.7e9, 23, 0), 0);
	ck_assert_double_nan(ts_archard_volume(0.003, 1.7e9, NAN, 0.4));
}
END_TEST

START_TEST(sections_of_a_groove)
{
	double d = 3, r = 1.5, x = 0.9;

	assert_near(ts_zhao_section(true, d, x), r * r * acos(1 - x / r) - (r - x) * sqrt(2 * r * x - x * x),
		    1e-14);
	assert_near(ts_zhao_section(true, d, r), 0.5 * TS_PI * r * r, 1e-15);
	assert_near(ts_zhao_section(true, d, 2), 0.5 * TS_PI * r * r + 0.5 * d, 1e-15);
	assert_near(ts_zhao_section(false, d, x), 4.0 / 3 * sqrt(d) * pow(x, 1.5), 1e-15);
	/* the series meets the closed form */
	assert_near(ts_zhao_segment(0.01 * (1 - 1e-14)), ts_zhao_segment(0.01), 2e-13);
	assert_near(ts_zhao_section(true, d, 1e-9), ts_zhao_section(false, d, 1e-9), 1e-9);
	ck_assert_double_eq(ts_zhao_section(true, d, -1), 0);
}
END_TEST

START_TEST(indentation)
{
	double d = 25e-6, star = ts_zhao_transition(&zhao, d);
	double force = 4.0 / 3 * zhao.modulus * sqrt(0.5 * d) * pow(star, 1.5);

	/* both laws meet at delta*, where the mean pressure of Hertz' contact is 2 H */
	assert_near(ts_zhao_hertz_overlap(zhao.modulus, d, force), star, 1e-14);
	assert_near(ts_zhao_plastic_overlap(zhao.hardness, d, force), star, 1e-14);
	assert_near(force / (TS_PI * 0.5 * d * star), 2 * zhao.hardness, 1e-14);
	assert_near(ts_zhao_indentation(&zhao, d, 3 * force), 3 * star, 1e-14);
	assert_near(ts_zhao_indentation(&zhao, d, force / 8), star / 4, 1e-14);
	assert_near(ts_zhao_slide_volume(&zhao, d, 3 * force, -2e-6),
		    ts_zhao_section(false, d, 3 * star) * 2e-6, 1e-14);
	ck_assert_double_eq(ts_zhao_slide_volume(&zhao, d, -force, 1), 0);
	ck_assert_double_eq(ts_zhao_slide_volume(&zhao, d, 0, 1), 0);
	ck_assert_double_nan(ts_zhao_slide_volume(&zhao, d, NAN, 1));
}
END_TEST

START_TEST(elastic_groove)
{
	struct ts_erosion_zhao_chang hard = zhao;
	struct ts_erosion_impact i = grain(60, 85);

	hard.hardness = 1e13;
	assert_near(ts_zhao_groove_volume(&hard, &i), 2 * sqrt(2) * i.mass * 60 * 85 / zhao.modulus, 1e-14);
	i = grain(105, 0);
	ck_assert_double_eq(ts_zhao_groove_volume(&hard, &i), 0);
}
END_TEST

struct motion {
	double stiffness, mass; /* m x'' = -k x^(3/2), or -k x */
	bool hertz;
};

static double acceleration(const struct motion *o, double x)
{
	return x > 0 ? -o->stiffness * (o->hertz ? x * sqrt(x) : x) / o->mass : 0;
}

static void step(const struct motion *o, double h, double *x, double *v)
{
	double a = acceleration(o, *x), b, c, d;

	b = acceleration(o, *x + 0.5 * h * *v);
	c = acceleration(o, *x + 0.5 * h * *v + 0.25 * h * h * a);
	d = acceleration(o, *x + h * *v + 0.5 * h * h * b);
	*x += h * *v + h * h / 6 * (a + b + c);
	*v += h / 6 * (a + 2 * b + 2 * c + d);
}

/* The groove of a contact resolved in time until it is deepest: Runge-Kutta for the motion, Simpson for the
 * volume. */
static double resolved(const struct ts_erosion_zhao_chang *law, const struct ts_erosion_impact *i,
		       double time)
{
	struct motion o = { .mass = i->mass, .hertz = !law->plastic };
	int parts = 4000;
	double h = time / (2 * parts), x = 0, v = i->normal, sum = 0;

	o.stiffness = law->plastic ? TS_PI * i->diameter * law->hardness
				   : 4.0 / 3 * law->modulus * sqrt(0.5 * i->diameter);
	for (int k = 0; k <= 2 * parts; k++) {
		double weight = k == 0 || k == 2 * parts ? 1 : k % 2 ? 4 : 2, force = 0;

		if (x > 0)
			force = -o.mass * acceleration(&o, x);
		if (law->plastic)
			sum += weight * h / 3 * ts_zhao_section(law->segment, i->diameter, x) * i->tangential;
		else
			sum += weight * ts_zhao_slide_volume(law, i->diameter, force, h / 3 * i->tangential);
		step(&o, h, &x, &v);
	}
	return sum;
}

/* Elastic impacts, part plastic, nearly all plastic; both sections. */
START_TEST(groove_of_resolved_contacts)
{
	static const double hardness[] = { 1e12, 4e9, 2.7e9, 1.12e9, 0.5e9, 0.22e9 };
	struct ts_erosion_impact i = grain(91, 52.5);
	double half =
		0.4 * sqrt(TS_PI) * tgamma(0.4) / tgamma(0.9) * ts_zhao_hertz_peak(zhao.modulus, &i) / 91;

	for (size_t k = 0; k < sizeof(hardness) / sizeof(hardness[0]); k++)
		for (int segment = 0; segment <= 1; segment++) {
			struct ts_erosion_zhao_chang law = zhao;
			double tolerance =
				segment ? 1e-6 : 1e-9; /* some are deeper than R, where the segment ends */

			law.hardness = hardness[k];
			law.segment = segment;
			assert_near(2 * resolved(&law, &i, half), ts_zhao_groove_volume(&law, &i), tolerance);
			law.plastic = true;
			assert_near(resolved(&law, &i,
					     0.5 * TS_PI / ts_zhao_plastic_frequency(law.hardness, &i)),
				    ts_zhao_groove_volume(&law, &i), tolerance);
		}
}
END_TEST

/* The quadrature for circular segments against the closed form, where the difference is small. */
START_TEST(quadrature_of_sections)
{
	for (int plastic = 0; plastic <= 1; plastic++) {
		struct ts_erosion_zhao_chang law = zhao, exact;
		struct ts_erosion_impact i = grain(1e-9, 1);

		law.plastic = plastic;
		law.hardness = plastic ? 2.7e9 : 1e3; /* an elastic impact is plastic over most of its time */
		exact = law;
		exact.segment = true;
		assert_near(ts_zhao_groove_volume(&exact, &i), ts_zhao_groove_volume(&law, &i), 1e-8);
		ck_assert_double_lt(ts_zhao_groove_volume(&exact, &i),
				    ts_zhao_groove_volume(&law, &i) * (1 + 1e-9));
	}
}
END_TEST

/* Its groove over m n^(3/2) t/H (rho/H)^(1/4): 0.237. */
static double plastic_groove(void)
{
	double quarter = 0.5 * sqrt(TS_PI) * tgamma(1.25) / tgamma(1.75);

	return 4.0 / 3 * sqrt(2) * quarter * pow(4 * TS_PI / 3, 0.25) * pow(2 * TS_PI, -1.25);
}

START_TEST(plastic_impact)
{
	struct ts_erosion_zhao_chang law = zhao;
	struct ts_erosion_impact i = grain(105, 30), faster = grain(210, 30), large = i;
	double frequency = ts_zhao_plastic_frequency(law.hardness, &i), deepest = i.normal / frequency;
	double groove;

	law.crater = 1;
	law.plastic = true;
	/* K. L. Johnson: largest depth, volume of the crater (a cap of the area pi d delta), time */
	assert_near(deepest, 105 * sqrt(i.mass / (2 * TS_PI * 0.5 * i.diameter * 2.7e9)), 1e-14);
	assert_near(0.5 * TS_PI * i.diameter * deepest * deepest, i.mass * 105 * 105 / (2 * 2.7e9), 1e-14);
	assert_near(ts_zhao_crater_volume(&law, &i), i.mass * 105 * 105 / (2 * 2.7e9), 1e-14);
	law.yield_speed = 5;
	assert_near(ts_zhao_crater_volume(&law, &i), i.mass * (105 * 105 - 25) / (2 * 2.7e9), 1e-14);
	law.yield_speed = 105;
	ck_assert_double_eq(ts_zhao_crater_volume(&law, &i), 0);
	/* the groove: exponent 1.5 of the normal speed; by mass independent of the size */
	groove = ts_zhao_groove_volume(&law, &i);
	assert_near(ts_zhao_groove_volume(&law, &faster), groove * pow(2, 1.5), 1e-14);
	large.diameter *= 3;
	large.mass *= 27;
	assert_near(ts_zhao_groove_volume(&law, &large), 27 * groove, 1e-14);
	assert_near(groove / (i.mass * pow(105, 1.5) * 30 / 2.7e9 * pow(2900 / 2.7e9, 0.25)),
		    plastic_groove(), 1e-13);
	/* far beyond the transition of the elastic force: exponent 1.6 */
	law.plastic = false;
	law.hardness = 1;
	assert_near(ts_zhao_groove_volume(&law, &faster) / ts_zhao_groove_volume(&law, &i), pow(2, 1.6),
		    1e-12);
}
END_TEST

/* Where the groove is largest: n t at 45 degrees, n^(3/2) t at tan^2 = 3/2. */
START_TEST(angle_of_the_largest_groove)
{
	struct ts_erosion_zhao_chang law = zhao;

	law.hardness = 1e13;
	for (int plastic = 0; plastic <= 1; plastic++) {
		double angle = atan(plastic ? sqrt(1.5) : 1);
		struct ts_erosion_impact at = grain_at(105, angle);

		law.plastic = plastic;
		for (int sign = -1; sign <= 1; sign += 2) {
			struct ts_erosion_impact aside = grain_at(105, angle + sign * 1e-3);

			ck_assert_double_lt(ts_zhao_groove_volume(&law, &aside),
					    ts_zhao_groove_volume(&law, &at));
		}
	}
	ck_assert_double_eq_tol(atan(sqrt(1.5)) * 180 / TS_PI, 50.8, 0.05);
}
END_TEST

/* At the speed at which the elastic impact just reaches delta*, the closed form is continuous. */
START_TEST(transition_of_the_groove)
{
	struct ts_erosion_impact i = grain(1, 1);
	double peak = ts_zhao_hertz_peak(zhao.modulus, &i), star = ts_zhao_transition(&zhao, i.diameter),
	       under;

	i.normal = pow(star / peak, 1.25) * (1 - 1e-9);
	under = ts_zhao_groove_volume(&zhao, &i);
	assert_near(under, 2 * sqrt(2) * i.mass * i.normal / zhao.modulus, 1e-14);
	i.normal *= 1 + 2e-9;
	assert_near(ts_zhao_groove_volume(&zhao, &i), under, 1e-8);
	/* both series of the incomplete integral */
	assert_near(ts_zhao_plastic_part(sqrt(0.5) * (1 - 1e-15)),
		    ts_zhao_plastic_part(sqrt(0.5) * (1 + 1e-15)), 1e-14);
	assert_near(ts_zhao_plastic_part(1), 0.5 * tgamma(1.3) * sqrt(TS_PI) / tgamma(1.8), 1e-14);
	assert_near(ts_zhao_plastic_part(1e-4), 1e-4 * (1 - 1e-9), 1e-14);
}
END_TEST

enum { LAWS = 8 };

static double volume(int law, const struct ts_erosion_impact *i)
{
	struct ts_erosion_oka oka = oka_of(TS_OKA_SIC, 2.7);
	struct ts_erosion_zhao_chang z = zhao;

	z.segment = law & 1;
	z.plastic = law >= 6;
	switch (law) {
	case 0:
		return ts_erosion_finnie_volume(&finnie, i);
	case 1:
		return ts_erosion_neilson_volume(&neilson, i);
	case 2:
		return ts_erosion_bitter_volume(&bitter, i);
	case 3:
		return ts_erosion_oka_volume(&oka, i);
	default:
		return ts_erosion_zhao_chang_volume(&z, i);
	}
}

START_TEST(nothing_is_removed_without_an_approach)
{
	const struct ts_erosion_impact none[] = { grain(0, 0), grain(0, 105), grain(-105, 0), grain(-1, 105),
						  grain(-0.0, 105) };

	for (int law = 0; law < LAWS; law++)
		for (size_t k = 0; k < sizeof(none) / sizeof(none[0]); k++)
			ck_assert_double_eq(volume(law, &none[k]), 0);
}
END_TEST

START_TEST(grazing_and_normal_impacts_are_finite)
{
	const struct ts_erosion_impact odd[] = { grain(1e-12, 105), grain(105, 1e-12), grain(105, 0),
						 grain(1e-12, 1e-12), grain(1e4, 1e4) };

	for (int law = 0; law < LAWS; law++)
		for (size_t k = 0; k < sizeof(odd) / sizeof(odd[0]); k++) {
			ck_assert_double_finite(volume(law, &odd[k]));
			ck_assert_double_ge(volume(law, &odd[k]), 0);
		}
}
END_TEST

START_TEST(not_a_number_stays_one)
{
	const struct ts_erosion_impact bad[] = { grain(NAN, 105), grain(105, NAN), grain(NAN, NAN) };
	struct ts_erosion_impact i = grain(50, 50);

	i.mass = NAN;
	for (int law = 0; law < LAWS; law++) {
		for (size_t k = 0; k < sizeof(bad) / sizeof(bad[0]); k++)
			ck_assert_double_nan(volume(law, &bad[k]));
		ck_assert_double_nan(volume(law, &i));
	}
}
END_TEST

/* Ductile laws remove more from a softer surface: the ranking of steel, aluminium and acrylic. */
START_TEST(softer_surfaces_lose_more)
{
	static const double hardness[] = { 2.719e9, 1.098e9, 0.2197e9 };

	for (int angle = 30; angle <= 90; angle += 60) {
		struct ts_erosion_impact i = grain_at(105, radians(angle));
		double last = 0;

		for (int k = 0; k < 3; k++) {
			struct ts_erosion_zhao_chang law = zhao;
			double removed;

			law.hardness = hardness[k];
			removed = ts_erosion_zhao_chang_volume(&law, &i);
			ck_assert_double_gt(removed, last);
			last = removed;
		}
	}
}
END_TEST

static Suite *erosion_suite(void)
{
	Suite *suite = suite_create("erosion");
	TCase *tests = tcase_create("erosion");

	tcase_add_test(tests, components_of_the_velocity);
	tcase_add_test(tests, finnie_values);
	tcase_add_test(tests, neilson_values);
	tcase_add_test(tests, yield_speed_is_that_of_hertz);
	tcase_add_test(tests, bitter_values);
	tcase_add_test(tests, oka_angles);
	tcase_add_test(tests, oka_volumes);
	tcase_add_test(tests, oka_hardness);
	tcase_add_test(tests, oka_of_three_surfaces);
	tcase_add_test(tests, normal_impacts_on_steel);
	tcase_add_test(tests, archard_values);
	tcase_add_test(tests, sections_of_a_groove);
	tcase_add_test(tests, indentation);
	tcase_add_test(tests, elastic_groove);
	tcase_add_test(tests, groove_of_resolved_contacts);
	tcase_add_test(tests, quadrature_of_sections);
	tcase_add_test(tests, plastic_impact);
	tcase_add_test(tests, angle_of_the_largest_groove);
	tcase_add_test(tests, transition_of_the_groove);
	tcase_add_test(tests, nothing_is_removed_without_an_approach);
	tcase_add_test(tests, grazing_and_normal_impacts_are_finite);
	tcase_add_test(tests, not_a_number_stays_one);
	tcase_add_test(tests, softer_surfaces_lose_more);
	suite_add_tcase(suite, tests);
	return suite;
}

int main(void)
{
	SRunner *runner = srunner_create(erosion_suite());
	int failed;

	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
