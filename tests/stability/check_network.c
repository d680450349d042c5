/* Many contacts and bonds at once: the largest stable step, found by bisection, beside theory where it is
 * known in closed form, and beside what the plan of a run reports (limits/network.c), both sides: measured
 * must not be below what is reported by more than a few per cent, nor above it.
 *
 * All but the grain on a wall have unit springs and masses: h is in units of sqrt(m/k).
 *
 * TS_TABLE=FILE appends what is measured. */
#include <stdlib.h>
#include <string.h>

#include "../deck.h"

#include "core/report.h"
#include "core/sim.h"

struct scene {
	const char *name;
	const char *script; /* at rest in equilibrium; kn and so on as variables */
	const char *kick;   /* what disturbs it; v: a random velocity */
	double theory;	    /* h, or 0 */
	bool slip;	    /* the limit with slip and rolling is the one that is meant */
	double least, most; /* of measured over reported */
};

/* Springs of kn = 1, masses 1 unless the scene says otherwise; radius 0.5 */
#define HEAD "units si\natom_style granular\nnewton off\ncommunicate single vel yes\nneighbor 0.01 bin\n"
#define GRAIN(friction)                                                                     \
	"fix n all property/global kn peratomtypepair 2 1 1 1 1\n"                          \
	"fix t all property/global kt peratomtypepair 2 " friction                          \
	"fix g all property/global gamman_abs peratomtypepair 2 0 0 0 0\n"                  \
	"fix s all property/global gammat_abs peratomtypepair 2 0 0 0 0\n"                  \
	"fix f all property/global coefficientFriction peratomtypepair 2 1e6 1e6 1e6 1e6\n" \
	"fix Y all property/global youngsModulus peratomtype 1e7 1e7\n"                     \
	"fix P all property/global poissonsRatio peratomtype 0.25 0.25\n"                   \
	"fix E all property/global coefficientRestitution peratomtypepair 2 1 1 1 1\n"
#define SMOOTH "0 0 0 0\n"
#define ROUGH "0.7 0.7 0.7 0.7\n"
#define PAIR(tangential)                                               \
	"pair_style gran model hooke/stiffness tangential " tangential \
	" absolute_damping on\npair_coeff * *\n"
#define HELD "group still type 2\nfix hold still freeze\ngroup free type 1\nfix move free nve/sphere\n"
#define UNIT "set group all diameter 1 mass 1\n"
#define BOX(faces, size) "boundary " faces "\nregion box block " size " units box\ncreate_box 2 box\n"
#define NEAR_X \
	"create_atoms 1 single 0 0 0\ncreate_atoms 2 single 0.99 0 0\ncreate_atoms 2 single -0.99 0 0\n"
#define NEAR_YZ                                                             \
	"create_atoms 2 single 0 0.99 0\ncreate_atoms 2 single 0 -0.99 0\n" \
	"create_atoms 2 single 0 0 0.99\ncreate_atoms 2 single 0 0 -0.99\n"

#define BONDED(reach)                                                                  \
	"pair_style none\nbond_style contact\nbond_coeff 1 stiffness 1 ultimate 1e9\n" \
	"create_bonds many all all 1 0.0 " reach "\nfix move all nve\n"
#define CHAIN                                                                                       \
	BOX("p f f", "0 8 -1 1 -1 1")                                                               \
	"lattice sc 1.0\nregion line block 0 8 -0.1 0.1 -0.1 0.1 units box\ncreate_atoms 1 region " \
	"line\n" UNIT
#define PARALLEL(kn, ratio, lambda, damping)                                                          \
	"pair_style none\nbond_style parallel\nbond_coeff 1 kn " kn " ratio " ratio " lambda " lambda \
	" " damping "\ncreate_bonds many all all 1 0.0 1.01\nfix move all nve/sphere\n"
#define BONDED_PAIR(mass)                                                                              \
	OPEN "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 1 0 0\n" UNIT "set atom 2 mass " mass \
	     "\n" BONDED("1.01")
#define AT(x, y, z) "create_atoms 2 single " x " " y " " z "\n"
/* at (+-0.7 +-0.7 0) and so on */
/* clang-format off */
#define TWELVE                                                                                     \
	AT("0.7", "0.7", "0") AT("0.7", "-0.7", "0") AT("-0.7", "0.7", "0") AT("-0.7", "-0.7", "0") \
	AT("0.7", "0", "0.7") AT("0.7", "0", "-0.7") AT("-0.7", "0", "0.7") AT("-0.7", "0", "-0.7") \
	AT("0", "0.7", "0.7") AT("0", "0.7", "-0.7") AT("0", "-0.7", "0.7") AT("0", "-0.7", "-0.7")
/* clang-format on */
#define MOVES "fix move all nve/sphere\n"
#define ALL "velocity all set v_v v_v v_v"
#define OPEN BOX("f f f", "-3 3 -3 3 -3 3")
#define FCC BOX("p p p", "0 4.2 0 4.2 0 4.2") "lattice fcc 1.4\ncreate_atoms 1 box\n" UNIT
/* Four by four spheres in a plane, one body pressed onto the plane below. */
#define PLATE                          \
	BOX("f f f", "-5 5 -5 5 -2 2") \
	"lattice sc 1.1\n"             \
	"region field block -2.25 2.15 -2.25 2.15 -0.1 0.1 units box\ncreate_atoms 1 region field\n" UNIT
#define ON_PLANE "fix floor all wall/gran primitive type 1 zplane -0.49\nfix load all addforce 0 0 -0.01\n"
#define PUSH "fix kick all addforce 0 0 1e-9\nrun 10 unsafe yes post no\nunfix kick"
#define ROLLING                                                                                     \
	"fix mr all property/global coefficientRollingFriction peratomtypepair 2 0.9 0.9 0.9 0.9\n" \
	"fix er all property/global coefficientRollingViscousDamping peratomtypepair 2 0 0 0 0\n"
/* 120 spheres of two sizes, pressed together: relaxed under friction of the air. */
#define PACKING                                                                    \
	BOX("p p p", "0 3.5 0 3.5 0 3.5")                                          \
	"create_atoms 1 random 60 2385 NULL\ncreate_atoms 2 random 60 2389 NULL\n" \
	"set type 1 diameter 1 mass 1\nset type 2 diameter 0.5 mass 0.125\n"
#define RELAX                                                                                                \
	"fix slow all nve/limit radius_ratio 0.2\nfix air all viscous 0.1\ntimestep 0.3\nrun 1000 post no\n" \
	"unfix slow\nunfix air\nvelocity all set 0 0 0\n"

static const struct scene scenes[] = {
	{ "grain between 2 held ones", HEAD OPEN NEAR_X UNIT GRAIN(SMOOTH) PAIR("off") HELD,
	  "velocity all set v_v NULL NULL", 1.41421356, false, 0.99, 1.002 },
	/* the load on the contacts makes them 1 % softer across: the reported limit is on the safe side */
	{ "grain between 6 held ones", HEAD OPEN NEAR_X NEAR_YZ UNIT GRAIN(SMOOTH) PAIR("off") HELD, ALL,
	  1.41421356, false, 0.99, 1.012 },
	{ "the same, rough, kt/kn = 0.7", HEAD OPEN NEAR_X NEAR_YZ UNIT GRAIN(ROUGH) PAIR("history") HELD,
	  ALL, 0.76397, true, 0.99, 1.002 },
	/* sum n n = 4 */
	{ "grain between 12 held ones",
	  HEAD OPEN "create_atoms 1 single 0 0 0\n" TWELVE UNIT GRAIN(SMOOTH) PAIR("off") HELD, ALL, 1, false,
	  0.99, 1.012 },
	/* 2 sqrt(m* / k) */
	{ "two bonded grains, masses 1 and 1", HEAD BONDED_PAIR("1"), ALL, 1.41421356, false, 0.99, 1.002 },
	{ "two bonded grains, masses 1 and 10", HEAD BONDED_PAIR("10"), ALL, 1.90692518, false, 0.99, 1.002 },
	{ "two bonded grains, masses 1 and 100", HEAD BONDED_PAIR("100"), ALL, 1.99007438, false, 0.99,
	  1.002 },
	{ "two bonded grains, masses 1 and 1000", HEAD BONDED_PAIR("1000"), ALL, 1.99900075, false, 0.99,
	  1.002 },
	{ "chain of bonds",
	  HEAD BOX("p f f", "0 8 -1 1 -1 1") "lattice sc 1.0\nregion line block 0 8 -0.1 0.1 -0.1 0.1 units "
					     "box\ncreate_atoms 1 region line\n" UNIT BONDED("1.01"),
	  ALL, 1, false, 0.99, 1.002 },
	{ "chain of bonds, masses 1 and 100",
	  HEAD BOX("p f f",
		   "0 8 -1 1 -1 1") "lattice sc 1.0\nregion line block 0 8 -0.1 0.1 -0.1 0.1 units "
				    "box\ncreate_atoms 1 region line\n" UNIT
				    "group heavy id 1 3 5 7\nset group heavy mass 100\n" BONDED("1.01"),
	  ALL, 1.40719509, false, 0.99, 1.002 },
	{ "simple cubic network of bonds",
	  HEAD BOX("p p p", "0 4 0 4 0 4") "lattice sc 1.0\ncreate_atoms 1 box\n" UNIT BONDED("1.01"), ALL, 1,
	  false, 0.99, 1.002 },
	{ "face-centred cubic network of bonds",
	  HEAD BOX("p p p", "0 4.5 0 4.5 0 4.5") "lattice fcc 1.5\ncreate_atoms 1 box\n" UNIT BONDED("1.07"),
	  ALL, 0.70710678, false, 0.99, 1.002 },
	/* radius of the section R_b, k_n = 1, bending k_b = R_b^2/4, m = 1, I = 0.1, modes of one grain against the
	 * next: stretched, 4 k_n; bent, 4 k_b/I; grains that turn together: k_s l^2/I */
	{ "chain of parallel bonds, stretched", HEAD CHAIN PARALLEL("1.2732395447", "4", "1", ""), ALL, 1,
	  false, 0.99, 1.002 },
	{ "chain of parallel bonds, bent", HEAD CHAIN PARALLEL("0.31830988618", "4", "2", ""), ALL,
	  0.63245553, false, 0.99, 1.002 },
	{ "chain of parallel bonds, sheared", HEAD CHAIN PARALLEL("1.2732395447", "1.25", "1", ""), ALL,
	  0.70710678, false, 0.99, 1.002 },
	{ "chain of parallel bonds, damped", HEAD CHAIN PARALLEL("1.2732395447", "4", "1.5", "damping 0.2"),
	  ALL, 0.425229, false, 0.99, 1.012 },
	{ "two parallel bonds of three grains",
	  HEAD OPEN "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 1 0 0\ncreate_atoms 1 single 1 1 "
		    "0\n" UNIT PARALLEL("1.2732395447", "2", "1.2", ""),
	  ALL, 0, false, 0.99, 1.002 },
	{ "simple cubic network of parallel bonds",
	  HEAD BOX("p p p",
		   "0 4 0 4 0 4") "lattice sc 1.0\ncreate_atoms 1 box\n" UNIT PARALLEL("1.2732395447", "2",
										       "1", ""),
	  ALL, 0, false, 0.99, 1.002 },
	{ "face-centred cubic crystal of grains", HEAD FCC GRAIN(SMOOTH) PAIR("off") MOVES, ALL, 0.70710678,
	  false, 0.99, 1.012 },
	{ "the same, gamma/omega of a contact 0.3",
	  HEAD FCC GRAIN(SMOOTH) "fix g all property/global gamman_abs peratomtypepair 2 0.4242640687 0 0 "
				 "0\n" PAIR("off") MOVES,
	  ALL, 0.400356, false, 0.99, 1.012 },
	{ "the same, rough, kt/kn = 0.7", HEAD FCC GRAIN(ROUGH) PAIR("history") MOVES, ALL, 0, true, 0.99,
	  1.012 },
	{ "the same of Hertz, overlap 1 %",
	  HEAD FCC GRAIN(SMOOTH) "fix Y all property/global youngsModulus peratomtype 1e3 1e3\n"
				 "hard_particles no\nsoft_particles yes\npair_style gran model "
				 "hertz\npair_coeff * *\n" MOVES,
	  ALL, 0.0967, false, 0.99, 1.012 },
	{ "packing of two sizes 2 : 1", HEAD PACKING GRAIN(SMOOTH) PAIR("off") RELAX "fix move all nve\n",
	  ALL, 0, false, 0.97, 1.02 },
	{ "plate of 16 spheres on springs, rigid",
	  HEAD PLATE GRAIN(SMOOTH) PAIR("off") ON_PLANE "fix plate all rigid single\n", PUSH, 2, false, 0.99,
	  1.002 },
	/* k twice at half the length: 1/M + L^2/4/I, M = 2, I = 0.7 */
	{ "rigid dumbbell held at one end",
	  HEAD OPEN "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 1 0 0\n"
		    "create_atoms 2 single 0 0 1\ncreate_atoms 2 single 0 0 -1\n" UNIT
		    "group still type 2\nfix hold still freeze\n"
		    "group free type 1\nfix body free rigid single\npair_style none\nbond_style contact\n"
		    "bond_coeff 1 stiffness 1 ultimate 1e9\ncreate_bonds many free still 1 0.0 1.01\n",
	  PUSH, 1.52753, false, 0.99, 1.002 },
	/* 2.25 kn mu^2 R^2/I */
	{ "sphere that rolls on a plane, epsd",
	  HEAD OPEN "create_atoms 1 single 0 0 0\n" UNIT GRAIN(SMOOTH) ROLLING
	  "pair_style gran model hooke/stiffness tangential off rolling_friction epsd absolute_damping "
	  "on\npair_coeff * *\n" ON_PLANE MOVES,
	  "set atom 1 omegax 1e-9", 0.9322, true, 0.99, 1.002 },
};

static struct tsim *open_scene(const struct scene *s, double h)
{
	struct tsim *sim = deck_open("%s", s->script);

	deck(sim, "variable v atom 1e-9*random(-1,1,2385)\ntimestep %.17g", h);
	return sim;
}

static double energy(struct tsim *sim)
{
	return deck_value(sim, "ke") + deck_value(sim, "erotate");
}

static bool stable(const struct scene *s, double h)
{
	struct tsim *sim = open_scene(s, h);
	bool good = deck_accepts(sim, "%s", s->kick);
	double first = good ? energy(sim) : 0;

	for (int chunk = 0; chunk < 20 && good; chunk++)
		good = deck_accepts(sim, "run 30 unsafe yes post no") && energy(sim) < 1e6 * first;
	tsim_close(sim);
	return good;
}

static double least(const struct ts_plan_report *report, const char *text)
{
	double found = INFINITY;

	for (size_t k = 0; k < report->nlimits; k++)
		if (strncmp(report->limit[k].text, text, strlen(text)) == 0)
			found = fmin(found, report->limit[k].dt);
	return found;
}

/* What the plan would say after a step: of all contacts, or of one where there is one only; *one: of one
 * contact. */
static double reported(const struct scene *s, double *one)
{
	struct ts_plan_report report = { .limits_only = true, .advice = true, .enough = INFINITY };
	struct tsim *sim = open_scene(s, 1e-3);
	double all;

	deck(sim, "run 1 post no");
	ck_assert(ts_report_collect(&report, sim) == TS_OK);
	all = least(&report, s->slip ? "all contacts with" : "all contacts together");
	*one = s->slip ? least(&report, "the slip")
		       : fmin(least(&report, "a contact"), least(&report, "a single"));
	ts_report_release(&report);
	tsim_close(sim);
	return isfinite(all) ? all : *one;
}

static double measure(const struct scene *s, double about)
{
	double lo = 0.6 * about, hi = 1.7 * about;

	ck_assert_msg(stable(s, lo), "%s: unstable at 0.6 of the limit", s->name);
	ck_assert_msg(!stable(s, hi), "%s: stable at 1.7 times the limit", s->name);
	while (hi / lo > 1.001) {
		double h = sqrt(lo * hi);

		*(stable(s, h) ? &lo : &hi) = h;
	}
	return sqrt(lo * hi);
}

START_TEST(limits)
{
	const struct scene *s = &scenes[_i];
	double one, said = reported(s, &one), measured = measure(s, said);
	FILE *table = _i ? NULL
			 : deck_table("Many contacts and bonds at once: measured, theory (0: none), "
				      "reported, ratio, limit of one contact alone");

	if (_i && getenv("TS_TABLE"))
		table = fopen(getenv("TS_TABLE"), "a");
	if (table)
		fprintf(table, "%-44s %9.5f %9.5f %9.5f %9.4f %9.5f\n", s->name, measured, s->theory, said,
			measured / said, one);
	if (table)
		fclose(table);
	ck_assert_msg(measured >= s->least * said && measured <= s->most * said,
		      "%s: stable up to %g, reported %g", s->name, measured, said);
	if (s->theory > 0)
		DECK_NEAR(measured / s->theory, 1, s->most - 1 + 0.002);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stability of networks");
	TCase *tests = tcase_create("bisection");

	tcase_set_timeout(tests, 120);
	tcase_add_loop_test(tests, limits, 0, (int)DECK_LENGTH(scenes));
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
