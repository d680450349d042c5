/* The collision of one sphere with a flat wall as a whole, against closed forms and against the same law in small steps.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "../deck.h"
#include "base/alloc.h"
#include "law/granular_force.h"
#include "math/constants.h"
#include "impact/exact_collision.h"

/* A grain of lunar dust on a metal, 105 m/s. */
static const double RADIUS = 12.4e-6, DENSITY = 2900, SPEED = 105;

static struct ts_granular_pair law_of(double e, double mu)
{
	double l = log(e);

	return (struct ts_granular_pair){ .young = 5.7e10,
					  .shear = 1.9e10,
					  .log_restitution = l,
					  .damping = l / sqrt(l * l + TS_PI * TS_PI),
					  .velocity = 71,
					  .friction = mu,
					  .kn = 1.3e6,
					  .kt = 0.9e6,
					  .gamman = 4.1e7,
					  .gammat = 2.3e7 };
}

static struct ts_collision sphere(const struct ts_granular_model *m, const struct ts_granular_pair *law,
				  double degrees)
{
	double angle = degrees * TS_PI / 180;
	struct ts_collision c = { .model = m,
				  .law = law,
				  .radius = RADIUS,
				  .r_eff = RADIUS,
				  .mass = 4.0 / 3 * TS_PI * DENSITY * pow(RADIUS, 3),
				  .inertia = 0.4,
				  .n = { 2.0 / 7, -3.0 / 7, 6.0 / 7 },
				  .longest = INFINITY };
	static const double along[3] = { 3.0 / 7, 6.0 / 7, 2.0 / 7 };

	ts_scale(-SPEED * sin(angle), c.n, c.velocity);
	ts_axpy(SPEED * cos(angle), along, c.velocity);
	return c;
}

static struct ts_collision_result collide(const struct ts_collision *c)
{
	struct ts_collision_result r;

	ck_assert_int_eq(ts_collision_compute(c, &r), TS_COLLISION_PARTS);
	return r;
}

/* The same collision in time steps as a run makes them: forces of the present positions and of the velocities of the
 * half step. It begins the part `phase` of a step after the last one without touch. */
static struct ts_collision_result in_steps(const struct ts_collision *c, double h, double phase)
{
	double memory[TS_GRANULAR_MEMORY] = { 0 }, x = c->radius - phase * h * ts_dot(c->velocity, c->n);
	double v[3], omega[3], inertia = c->inertia * c->mass * c->radius * c->radius;
	struct ts_collision_result r = { 0 };
	bool met = false;

	memcpy(v, c->velocity, sizeof v);
	memcpy(omega, c->omega, sizeof omega);
	for (;;) {
		struct ts_touch t = { .wall = true, .distance = x += h * ts_dot(v, c->n) };
		struct ts_granular_force f;

		t.overlap = c->radius - x;
		if (!(t.overlap > 0) && met)
			break;
		if (!(t.overlap > 0))
			continue;
		met = true;
		memcpy(t.n, c->n, sizeof t.n);
		t.radius[0] = c->radius;
		t.r_eff = c->r_eff;
		t.mass[0] = t.m_eff = c->mass;
		ts_granular_arms(c->model, &t);
		ts_touch_motion(&t, v, omega, (double[3]){ 0 });
		ts_granular_contact(c->model, c->law, &t, h, true, memory, &f);
		ts_axpy(h / c->mass, f.force, v);
		ts_axpy(h * t.arm[0] / inertia, f.turn, omega);
		r.peak_force = fmax(r.peak_force, f.normal);
		r.peak_overlap = fmax(r.peak_overlap, t.overlap);
		r.impulse += h * f.normal;
		r.slip += h * ts_norm(t.slip);
		r.work -= h * (ts_dot(f.force, t.slip));
		r.duration += h;
		ts_axpy(h, v, r.shift);
	}
	ts_project(c->n, r.shift);
	memcpy(r.velocity, v, sizeof v);
	memcpy(r.omega, omega, sizeof omega);
	return r;
}

static double energy(const struct ts_collision *c, const double v[3], const double omega[3])
{
	return 0.5 * c->mass * (ts_dot(v, v) + c->inertia * c->radius * c->radius * ts_dot(omega, omega));
}

START_TEST(hertz_keeps_energy)
{
	struct ts_granular_model m = { .normal = _i % 2 ? TS_NORMAL_HERTZ_STIFFNESS : TS_NORMAL_HERTZ,
				       .no_tension = _i / 2 };
	struct ts_granular_pair law = law_of(1, 0);
	struct ts_collision c;
	struct ts_collision_result r;
	double k, u, most;

	law.gamman = 0;
	for (int degrees = 90; degrees > 0; degrees -= 29) {
		c = sphere(&m, &law, degrees);
		r = collide(&c);
		u = -ts_dot(c.velocity, c.n);
		DECK_NEAR(energy(&c, r.velocity, r.omega) / energy(&c, c.velocity, c.omega), 1, 5e-11);
		DECK_NEAR(ts_dot(r.velocity, c.n) / u, 1, 5e-11);
		/* F = K q^1.5: m u^2/2 = 2/5 K q^2.5; the time from the beta function, 2.94327... */
		k = sqrt(RADIUS) * (_i % 2 ? law.kn : 4.0 / 3 * law.young);
		most = pow(1.25 * c.mass * u * u / k, 0.4);
		DECK_NEAR(r.peak_overlap / most, 1, 5e-11);
		DECK_NEAR(r.peak_force / (k * pow(most, 1.5)), 1, 5e-11);
		DECK_NEAR(r.duration * u / most, 2 * sqrt(TS_PI) * tgamma(1.4) / tgamma(0.9), 1e-10);
		DECK_NEAR(r.impulse / (2 * c.mass * u), 1, 1e-11);
		DECK_NEAR(ts_norm(r.shift), SPEED * cos(degrees * TS_PI / 180) * r.duration, 1e-10 * RADIUS);
	}
}
END_TEST

/* The damped oscillator ends at zero overlap after half a period, with e; its largest overlap is where u = 0. */
START_TEST(hooke_has_its_restitution)
{
	static const double es[] = { 0.97, 0.61, 0.2, 1e-3 };
	struct ts_granular_model m = { .normal = TS_NORMAL_HOOKE };
	struct ts_granular_pair law = law_of(es[_i], 0);
	struct ts_collision c = sphere(&m, &law, 90);
	struct ts_collision_result r = collide(&c);
	struct ts_touch t = { .r_eff = RADIUS, .m_eff = c.mass };
	double k = ts_hooke_stiffness(&law, &t), w0 = sqrt(k / c.mass);
	double g = w0 * -law.log_restitution / sqrt(TS_PI * TS_PI + pow(law.log_restitution, 2));
	double w = sqrt(w0 * w0 - g * g), turn = atan2(w, g) / w;

	DECK_NEAR(ts_dot(r.velocity, c.n) / SPEED, es[_i], 1e-10);
	DECK_NEAR(r.duration * w, TS_PI, 1e-9);
	DECK_NEAR(r.peak_overlap / (SPEED / w * exp(-g * turn) * sin(w * turn)), 1, 1e-10);
}
END_TEST

/* A limited normal force ends it where k q + gamma q' = 0: tan(w t) = -2 g w/(w0^2 - 2 g^2); here w0 = 1. */
START_TEST(limited_force_ends_early)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HOOKE, .no_tension = true };
	struct ts_granular_pair law = law_of(0.3, 0);
	struct ts_collision c = sphere(&m, &law, 90);
	struct ts_collision_result r = collide(&c);
	double beta = -law.damping, w = sqrt(1 - beta * beta);
	double angle = atan2(-2 * beta * w, 1 - 2 * beta * beta), t = (angle < 0 ? angle + TS_PI : angle) / w;

	DECK_NEAR(-ts_dot(r.velocity, c.n) / SPEED, exp(-beta * t) * (cos(w * t) - beta / w * sin(w * t)),
		  1e-10);
}
END_TEST

/* Johnson, Contact Mechanics, 11.4: with much slip the tangential impulse is mu times the normal one. A lever arm of
 * R gives the spin without any integration. */
START_TEST(gross_sliding_has_impulses_in_the_ratio_of_friction)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ,
				       .tangential = _i ? TS_TANGENTIAL_NO_HISTORY : TS_TANGENTIAL_HISTORY,
				       .full_arms = true,
				       .no_tension = true };
	struct ts_granular_pair law = law_of(_i ? 0.8 : 1, 0.21);
	struct ts_collision c = sphere(&m, &law, 15);
	struct ts_collision_result r = collide(&c);
	double change[3], impulse, spin[3];

	ts_sub(r.velocity, c.velocity, change);
	impulse = ts_dot(change, c.n);
	ts_project(c.n, change);
	DECK_NEAR(ts_norm(change) / impulse, 0.21, 1e-11);
	DECK_NEAR(r.impulse / (c.mass * impulse), 1, 1e-11);
	ts_cross(c.n, change, spin);
	DECK_NEAR(ts_norm(r.omega) * RADIUS / (2.5 * ts_norm(spin)), 1, 1e-11);
	/* the energy that is lost is the work of friction and of the dashpot */
	if (!_i)
		DECK_NEAR(r.work / (energy(&c, c.velocity, c.omega) - energy(&c, r.velocity, r.omega)), 1,
			  1e-9);
}
END_TEST

/* Without slip nothing acts along the surface. */
START_TEST(rolling_goes_on)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ,
				       .tangential = TS_TANGENTIAL_HISTORY,
				       .full_arms = true };
	struct ts_granular_pair law = law_of(0.7, 0.4);
	struct ts_collision c = sphere(&m, &law, 35);
	struct ts_collision_result r;
	double along[3];

	ts_scale(1, c.velocity, along);
	ts_project(c.n, along);
	ts_cross(c.n, along, c.omega);
	ts_scale(1 / RADIUS, c.omega, c.omega);
	r = collide(&c);
	for (int k = 0; k < 3; k++)
		DECK_NEAR(r.omega[k], c.omega[k], 1e-9 * SPEED / RADIUS);
	ts_project(c.n, r.velocity);
	DECK_NEAR(ts_norm(r.velocity) / ts_norm(along), 1, 1e-11);
}
END_TEST

static const struct ts_granular_model models[] = {
	{ .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY },
	{ .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY, .no_tension = true },
	{ .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_NO_HISTORY },
	{ .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_HISTORY },
	{ .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_HISTORY, .no_tension = true },
	{ .normal = TS_NORMAL_HOOKE, .tangential = TS_TANGENTIAL_NO_HISTORY, .no_tension = true },
	{ .normal = TS_NORMAL_HOOKE_STIFFNESS, .tangential = TS_TANGENTIAL_HISTORY, .full_arms = true },
	{ .normal = TS_NORMAL_HERTZ_STIFFNESS, .tangential = TS_TANGENTIAL_HISTORY },
	{ .normal = TS_NORMAL_HERTZ_STIFFNESS,
	  .tangential = TS_TANGENTIAL_NO_HISTORY,
	  .absolute_damping = true,
	  .no_tangential_damping = true },
};
static const double angles[] = { 90, 61, 30, 9 };
enum { NSTEPS = 4, NPHASES = 4 };

/* Differences of velocity and spin between the collision and that in steps, the largest of several phases of entry;
 * *least: the smallest, if not NULL. */
static double difference(const struct ts_collision *c, const struct ts_collision_result *r, double h,
			 double *least)
{
	double worst = 0, best = INFINITY;

	for (int phase = 0; phase < NPHASES; phase++) {
		struct ts_collision_result s = in_steps(c, h, (phase + 0.37) / NPHASES);
		double d[3], w[3];

		ts_sub(s.velocity, r->velocity, d);
		ts_sub(s.omega, r->omega, w);
		worst = fmax(worst, (ts_norm(d) + RADIUS * ts_norm(w)) / SPEED);
		best = fmin(best, (ts_norm(d) + RADIUS * ts_norm(w)) / SPEED);
	}
	if (least)
		*least = best;
	return worst;
}

/* The limit of small steps of the same law, spin along and across the slip included. */
START_TEST(agrees_with_small_steps)
{
	const struct ts_granular_model *m = &models[_i / 12];
	double e = _i / 12 % 3 == 2 ? 0.55 : 0.85, mu = _i % 3 ? 0.37 : 0.08, h[NSTEPS], error[NSTEPS];
	struct ts_granular_pair law = law_of(e, mu);
	struct ts_collision c = sphere(m, &law, angles[_i % 4]);
	struct ts_collision_result r, s;
	double order;

	if (m->normal == TS_NORMAL_HERTZ_STIFFNESS) { /* times sqrt(R q) */
		law.kn *= 3e4;
		law.kt *= 3e4;
		law.gamman *= 3e4 * (m->absolute_damping ? 0.1 * c.mass * RADIUS : 1);
		law.gammat *= 3e4;
	}
	if (_i % 3 == 1) {
		c.omega[0] = 1.7e6;
		c.omega[1] = -0.9e6;
		c.omega[2] = 0.6e6;
	}
	r = collide(&c);
	for (int k = 0; k < NSTEPS; k++) {
		h[k] = r.duration / (200.37 * pow(6, k));
		error[k] = difference(&c, &r, h[k], NULL);
	}
	order = deck_order(h, error, NSTEPS);
	/* the dashpot of Hertz' law, ~ q^(1/4), and the begin of sliding let the order vary */
	ck_assert_msg(order > 0.5, "the order is %g", order);
	ck_assert_msg(error[NSTEPS - 1] < 3e-5, "the error is %g", error[NSTEPS - 1]);
	s = in_steps(&c, h[NSTEPS - 1], 0.5);
	DECK_NEAR(s.peak_overlap / r.peak_overlap, 1, 3e-4);
	DECK_NEAR(s.peak_force / r.peak_force, 1, 3e-4);
	DECK_NEAR(s.duration / r.duration, 1, 3e-4);
	DECK_NEAR(s.impulse / r.impulse, 1, 3e-4);
	DECK_NEAR(s.slip, r.slip, 3e-4 * SPEED * r.duration);
	DECK_NEAR(s.work, r.work, 3e-4 * energy(&c, c.velocity, c.omega));
	for (int k = 0; k < 3; k++)
		DECK_NEAR(s.shift[k], r.shift[k], 3e-4 * SPEED * r.duration);
}
END_TEST

/* Where stick and slide end in each other small steps alternate between them; a short slide may lie within one step of
 * the integration. Velocities (towards the wall, along it) of collisions in which that happens. In the last one the
 * contact may stick or slide when the normal force begins to pull; small steps do either, by the phase of entry. */
static const struct {
	double e, u, v;
} alternating[] = { { 0.8, 50.15, 82.305 }, { 0.8, 96.75, 35.334 }, { 0.1, 40.525, 80.8135 } };

START_TEST(stick_and_slide_alternate)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ, .tangential = TS_TANGENTIAL_HISTORY };
	struct ts_granular_pair law = law_of(alternating[_i].e, 0.3);
	struct ts_collision c = sphere(&m, &law, 90);
	struct ts_collision_result r;
	double h[3], error[3], order, closest;

	law.young = 7e10 / 1.82;
	law.shear = 7e10 / 8.84;
	ts_scale(-alternating[_i].u, c.n, c.velocity);
	ts_axpy(alternating[_i].v, (double[]){ 3.0 / 7, 6.0 / 7, 2.0 / 7 }, c.velocity);
	r = collide(&c);
	for (int k = 0; k < 3; k++) {
		h[k] = r.duration / (2000.37 * pow(6, k));
		error[k] = difference(&c, &r, h[k], &closest);
		if (_i == 2)
			error[k] = closest;
	}
	order = deck_order(h, error, 3);
	ck_assert_msg(order > 0.6, "the order is %g", order);
	ck_assert_msg(error[2] < 2e-5, "errors %g %g %g", error[0], error[1], error[2]);
}
END_TEST

/* Sums over the nodes are the integrals of the result; energy and momentum follow along the collision. */
START_TEST(nodes_add_up_to_the_collision)
{
	const struct ts_granular_model *m = &models[_i / 4 % 6];
	struct ts_granular_pair law = law_of(0.85, 0.37);
	struct ts_collision c = sphere(m, &law, angles[_i % 4]);
	struct ts_contact_nodes nodes = { 0 };
	struct ts_collision_result r;
	double time = 0, push[3] = { 0 }, work = 0, moved[3] = { 0 }, turn[3] = { 0 };

	if (_i / 24) {
		c.omega[0] = 1.7e6;
		c.omega[1] = -0.9e6;
		c.omega[2] = 0.6e6;
	}
	c.nodes = &nodes;
	r = collide(&c);
	ck_assert_uint_gt(nodes.n, 20);
	for (size_t k = 0; k < nodes.n; k++) {
		const struct ts_contact_node *at = &nodes.item[k];
		double arm = RADIUS - 0.5 * at->overlap, slip[3], torque[3];

		ck_assert_double_gt(at->duration, 0);
		ck_assert_double_gt(at->time, k ? at[-1].time : 0);
		time += at->duration;
		ts_axpy(at->duration, at->force, push);
		ts_axpy(at->duration, at->velocity, moved);
		ts_cross(c.n, at->force, torque);
		ts_axpy(-at->duration * arm, torque, turn);
		ts_cross(at->omega, c.n, slip);
		ts_scale(-arm, slip, slip);
		ts_add(slip, at->velocity, slip);
		ts_project(c.n, slip);
		work -= at->duration * ts_dot(at->force, slip);
	}
	ts_project(c.n, moved);
	/* a force that is limited ends before the surfaces part */
	if (!m->no_tension)
		DECK_NEAR(time / r.duration, 1, 1e-8);
	DECK_NEAR(work, r.work, 1e-6 * energy(&c, c.velocity, c.omega));
	for (int k = 0; k < 3; k++) {
		DECK_NEAR(c.velocity[k] + push[k] / c.mass, r.velocity[k], 1e-6 * SPEED);
		DECK_NEAR(c.omega[k] + turn[k] / (0.4 * c.mass * RADIUS * RADIUS), r.omega[k],
			  1e-6 * SPEED / RADIUS);
		if (!m->no_tension)
			DECK_NEAR(moved[k], r.shift[k], 1e-6 * SPEED * r.duration);
	}
	ts_free(nodes.item);
}
END_TEST

/* k F_n s along a frictionless Hertz impact: 2 m u times the speed along the surface. */
START_TEST(nodes_integrate_sliding)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ };
	struct ts_granular_pair law = law_of(1, 0);
	struct ts_contact_nodes nodes = { 0 };
	struct ts_collision c = sphere(&m, &law, 33);
	double u = SPEED * sin(33 * TS_PI / 180), t = SPEED * cos(33 * TS_PI / 180), sum = 0;

	c.nodes = &nodes;
	collide(&c);
	for (size_t k = 0; k < nodes.n; k++) {
		double along[3];

		ts_scale(1, nodes.item[k].velocity, along);
		ts_project(c.n, along);
		sum += ts_dot(nodes.item[k].force, c.n) * ts_norm(along) * nodes.item[k].duration;
	}
	DECK_NEAR(sum / (2 * c.mass * u * t), 1, 1e-8);
	ts_free(nodes.item);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("exact collision");
	TCase *exact = tcase_create("closed forms"), *steps = tcase_create("small steps");

	tcase_add_loop_test(exact, hertz_keeps_energy, 0, 4);
	tcase_add_loop_test(exact, hooke_has_its_restitution, 0, 4);
	tcase_add_test(exact, limited_force_ends_early);
	tcase_add_loop_test(exact, gross_sliding_has_impulses_in_the_ratio_of_friction, 0, 2);
	tcase_add_test(exact, rolling_goes_on);
	tcase_add_loop_test(steps, agrees_with_small_steps, 0, 12 * (int)DECK_LENGTH(models));
	tcase_add_loop_test(exact, stick_and_slide_alternate, 0, sizeof alternating / sizeof *alternating);
	tcase_add_loop_test(exact, nodes_add_up_to_the_collision, 0, 48);
	tcase_add_test(exact, nodes_integrate_sliding);
	suite_add_tcase(suite, exact);
	suite_add_tcase(suite, steps);
	return deck_main(suite);
}
