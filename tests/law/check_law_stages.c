/* Laws in stages give what they give for one contact after the other, bit for bit: all combinations of
 * laws, between particles and at walls. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "contact/contact_loop.h"
#include "contact/law_stages.h"
#include "wall/wall_stages.h"

enum { N = 24 };
static const double DT = 1e-3;

static const struct ts_granular_pair law = {
	.young = 5e4,
	.shear = 1.9e4,
	.log_restitution = -0.51,
	.damping = -0.16,
	.velocity = 1.3,
	.kn = 3e4,
	.kt = 2e4,
	.gamman = 21,
	.gammat = 0.7,
	.gamman_root = 3,
	.friction = 0.4,
	.rolling_friction = 0.1,
	.rolling_viscosity = 0.3,
	.rolling_stiffness = 1.7,
	.cohesion = 30,
	.unloading = 2.5,
	.adhesion = 0.6,
	.plasticity = 0.05,
	.surface_energy = 0.2,
	.roll_stiffness = 900,
	.roll_damping = 7,
	.twist_stiffness = 500,
	.twist_damping = 3,
	.twist_friction = 0.2,
};

/* Numbers between a and b. */
static double draw(double a, double b)
{
	static uint64_t state = 88172645463325252u;

	state ^= state << 13;
	state ^= state >> 7;
	state ^= state << 17;
	return a + (b - a) * (double)(state >> 11) / 9007199254740992.0;
}

static void draw_vector(double size, double v[3])
{
	for (int k = 0; k < 3; k++)
		v[k] = draw(-size, size);
}

/* What contacts remember: some slide, some have long been pressed. */
static void draw_memory(const struct ts_granular_model *m, double memory[])
{
	for (int c = 0; c < TS_GRANULAR_MEMORY; c++)
		memory[c] = draw(-0.02, 0.02);
	memory[ts_granular_depth_at(m)] =
		m->rolling == TS_ROLLING_SDS ? memory[ts_granular_depth_at(m)] : draw(0, 0.1);
	if (ts_tangential_rescales(m))
		memory[ts_granular_area_at(m)] = draw(0, 0.2);
	if (m->located) {
		double *own = memory + ts_granular_located_at(m);

		own[TS_LOCATED_STAGE] = floor(draw(TS_LOCATED_NEW, TS_LOCATED_LEFT + 1));
		own[TS_LOCATED_AIM] = draw(-1, 1);
		own[TS_LOCATED_AHEAD] = own[TS_LOCATED_STAGE] == TS_LOCATED_TOUCHES ? draw(-1e-4, 1e-4) : 0;
	}
}

static void same(const char *what, int k, const double *one, const double *column[], int n,
		 const struct ts_granular_model *m)
{
	for (int c = 0; c < n; c++)
		if (memcmp(&one[c], &column[c][k], sizeof *one) != 0)
			ck_abort_msg("%s[%d] of contact %d: %.17g, in stages %.17g; normal %d, cohesion %d, "
				     "tangential %d, rolling %d, twisting %d",
				     what, c, k, one[c], column[c][k], m->normal, m->cohesion, m->tangential,
				     m->rolling, m->twisting);
}

/* ---- particles */

/* Distance by the sum of the radii, or by the radius at a wall; with sub-step detection many contacts begin or end. */
static double draw_distance(const struct ts_granular_model *m)
{
	return m->located ? draw(0.997, 0.99999) : draw(0.9, 0.999);
}

static void draw_ends(const struct ts_granular_model *m, struct ts_contact_inputs *e, bool touches)
{
	double length;

	*e = (struct ts_contact_inputs){ 0 };
	for (int j = 0; j < 2; j++) {
		e->radius[j] = draw(0.3, 0.7);
		e->mass[j] = draw(0.5, 2);
		draw_vector(3, e->omega[j]);
	}
	e->imass = 1 / e->mass[0] + 1 / e->mass[1];
	draw_vector(1, e->v);
	draw_vector(1, e->d);
	length = (e->radius[0] + e->radius[1]) * (touches ? draw_distance(m) : draw(1.001, 1.1)) /
		 ts_norm(e->d);
	ts_scale(length, e->d, e->d);
	ts_contact_inputs_complete(e);
}

struct pairs {
	struct ts_stages s;
	struct ts_touch touch[N];
	double radius[2][TS_BATCH], mass[2][TS_BATCH];
	double column[TS_GRANULAR_MEMORY][TS_BATCH], memory[N][TS_GRANULAR_MEMORY], *at[TS_GRANULAR_MEMORY];
	long long marks[TS_BATCH];
};

static void draw_pairs(struct pairs *p, const struct ts_granular_model *m)
{
	for (int k = 0; k < N; k++) {
		bool touches = k % 5 != 3;
		struct ts_contact_inputs e;

		draw_ends(m, &e, touches);
		ts_contact_inputs_touch(&e, m, &p->touch[k]);
		ts_stages_store_touch(&p->s, (size_t)k, m, &p->touch[k]);
		p->marks[k] = -(long long)touches;
		for (int j = 0; j < 2; j++) {
			p->radius[j][k] = e.radius[j];
			p->mass[j][k] = e.mass[j];
		}
		draw_memory(m, p->memory[k]);
		for (int c = 0; c < TS_GRANULAR_MEMORY; c++)
			p->column[c][k] = p->memory[k][c];
	}
	for (int j = 0; j < 2; j++) {
		p->s.radius[j] = p->radius[j];
		p->s.mass[j] = p->mass[j];
	}
	for (int c = 0; c < TS_GRANULAR_MEMORY; c++)
		p->at[c] = p->column[c];
	p->s.memory = p->at;
	p->s.touch = p->marks;
	p->s.wall = p->s.postpones = false;
}

static void check_pairs(const struct ts_granular_model *m)
{
	static struct pairs p;
	const double *memory[TS_GRANULAR_MEMORY];

	draw_pairs(&p, m);
	ts_stages_compute(&p.s, N, m, &law, DT);
	for (int c = 0; c < TS_GRANULAR_MEMORY; c++)
		memory[c] = p.column[c];
	for (int k = 0; k < N; k++) {
		struct ts_granular_force one, f;

		if (p.marks[k]) {
			ts_granular_contact(m, &law, &p.touch[k], DT, true, p.memory[k], &one);
			ts_stages_force(&p.s, (size_t)k, m->twisting != TS_TWISTING_OFF, &f);
			for (int c = 0; c < 3; c++) {
				const double *part[3] = { &f.force[c], &f.turn[c], &f.roll[c] };
				double whole[3] = { one.force[c], one.turn[c], one.roll[c] };

				for (int q = 0; q < 3; q++)
					same(q == 0   ? "force"
					     : q == 1 ? "turn"
						      : "roll",
					     0, &whole[q], &part[q], 1, m);
			}
		}
		same("memory", k, p.memory[k], memory, ts_granular_memory(m), m);
	}
}

/* ---- walls */

static void draw_wall(const struct ts_granular_model *m, struct ts_wall_ends *e, struct ts_wall_batch *b,
		      int k)
{
	*e = (struct ts_wall_ends){ .radius = draw(0.3, 0.7),
				    .mass = draw(0.5, 2),
				    .curvature = k % 3 ? 0 : draw(-1, 1) };
	e->distance = e->radius * draw_distance(m);
	draw_vector(1, e->n);
	ts_scale(1 / ts_norm(e->n), e->n, e->n);
	draw_vector(1, e->v);
	draw_vector(3, e->omega);
	for (int c = 0; c < 3; c++) {
		b->n[c][k] = e->n[c];
		b->v[c][k] = e->v[c];
		b->omega[c][k] = e->omega[c];
	}
	b->n[3][k] = e->distance;
	b->v[3][k] = e->mass;
	b->omega[3][k] = e->radius;
	b->curvature[k] = e->curvature;
}

static void check_walls(const struct ts_granular_model *m)
{
	static double memory[N][TS_GRANULAR_MEMORY];
	const double *columns[3][TS_GRANULAR_MEMORY];
	static struct ts_wall_batch b;
	struct ts_wall_ends e[N];

	for (int k = 0; k < N; k++) {
		draw_wall(m, &e[k], &b, k);
		draw_memory(m, memory[k]);
		for (int c = 0; c < TS_GRANULAR_MEMORY; c++)
			b.memory[c][k] = memory[k][c];
	}
	ts_wall_staged(&b, N, m, &law, DT);
	for (int c = 0; c < TS_GRANULAR_MEMORY; c++) {
		columns[0][c] = b.memory[c];
		columns[1][c] = b.force[c % 4];
		columns[2][c] = b.torque[c % 4];
	}
	for (int k = 0; k < N; k++) {
		struct ts_granular_force f;
		double torque[4];
		struct ts_touch t;

		ts_wall_ends_touch(&e[k], m, &t);
		ts_granular_contact(m, &law, &t, DT, true, memory[k], &f);
		for (int c = 0; c < 3; c++)
			torque[c] = t.arm[0] * f.turn[c] + f.roll[c];
		torque[3] = t.r_eff;
		same("memory at a wall", k, memory[k], columns[0], ts_granular_memory(m), m);
		same("force of a wall", k, f.force, columns[1], 3, m);
		same("torque of a wall", k, torque, columns[2], 4, m);
	}
}

/* ---- */

static void check(const struct ts_granular_model *m)
{
	if (!ts_stages_for(m))
		return;
	check_pairs(m);
	check_walls(m);
}

/* The flags of a model, by the bits of a number. */
static void flags(struct ts_granular_model *m, int bits)
{
	m->no_tension = bits & 1;
	m->no_tangential_damping = bits & 2;
	m->absolute_damping = bits & 4;
	m->tangential_stiffness_2_7 = bits & 8;
	m->reduce = bits & 16;
	m->torsion = bits & 32;
	m->plane = bits & 64;
	m->full_arms = bits & 128;
	m->full_slip = bits & 256;
	m->wide = bits & 512;
}

START_TEST(all_combinations)
{
	struct ts_granular_model m = { .normal = _i };
	int run = 0;

	for (m.cohesion = 0; m.cohesion <= TS_COHESION_SJKR2; m.cohesion++)
		for (m.tangential = 0; m.tangential < TS_NTANGENTIAL; m.tangential++)
			for (m.rolling = 0; m.rolling <= TS_ROLLING_SDS; m.rolling++)
				for (m.twisting = 0; m.twisting <= TS_TWISTING_MARSHALL; m.twisting++) {
					/* odd multiples meet all flags, and pairs of them */
					flags(&m, run++ * 331 & 1023);
					m.damping = run % (TS_DAMPING_RESTITUTION + 1);
					check(&m);
				}
}
END_TEST

START_TEST(all_flags)
{
	struct ts_granular_model m = { .normal = _i,
				       .tangential = TS_TANGENTIAL_HISTORY,
				       .rolling = TS_ROLLING_EPSD,
				       .cohesion = TS_COHESION_SJKR };

	for (int bits = 0; bits < 1024; bits++) {
		flags(&m, bits);
		check(&m);
	}
}
END_TEST

/* Sub-step detection: contacts of each stage, with overlaps of which some end or have just begun. */
START_TEST(located)
{
	struct ts_granular_model m = { .normal = _i, .located = true };

	for (int bits = 0; bits < 1024; bits++) {
		flags(&m, bits);
		m.tangential = bits % 5 ? TS_TANGENTIAL_HISTORY : bits % TS_NTANGENTIAL;
		m.rolling = bits % 3 ? TS_ROLLING_OFF : TS_ROLLING_CDT;
		m.cohesion = bits % 7 ? TS_COHESION_OFF : TS_COHESION_SJKR;
		check(&m);
	}
}
END_TEST

START_TEST(which_have_none)
{
	struct ts_granular_model m = { .normal = TS_NORMAL_HERTZ };

	ck_assert(ts_stages_for(&m));
	m = (struct ts_granular_model){ .normal = TS_NORMAL_HOOKE, .viscous = true };
	ck_assert(!ts_stages_for(&m));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("laws in stages");
	TCase *tests = tcase_create("laws in stages");
	SRunner *runner;
	int failed;

	tcase_set_timeout(tests, 60);
	tcase_add_loop_test(tests, all_combinations, TS_NORMAL_SPRING, TS_NNORMAL);
	tcase_add_loop_test(tests, all_flags, TS_NORMAL_SPRING, TS_NNORMAL);
	tcase_add_loop_test(tests, located, TS_NORMAL_SPRING, TS_NORMAL_HOOKE_HYSTERESIS);
	tcase_add_test(tests, which_have_none);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_ENV);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
