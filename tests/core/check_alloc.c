/* The k-th allocation fails, for k = 1, 2, 3 ...: every time the script ends in the error "out of
 * memory", or does without; nothing crashes, and nothing stays allocated. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "deck.h"

#include "base/alloc.h"
#include "core/sim.h"

/* In memory where that is possible: restart files wait for the disk. */
static char folder[64] = "/dev/shm/tsim.alloc.XXXXXX";

/* Something of everything, small. */
static const char script[] = "variable n loop 2\n"
			     "variable r equal 0.05+0.1/5\n"
			     "variable w atom x*2\n"
			     "variable s string 'a b'\n"
			     "units si\n"
			     "boundary p f m\n"
			     "lattice sc 0.11\n"
			     "region box block 0 1 0 1 0 1 units box\n"
			     "region low block 0 0.6 0 0.3 0 0.3 units box\n"
			     "region ball sphere 0.5 0.5 0.5 0.3 units box\n"
			     "region both union 2 low ball\n"
			     "create_box 2 box\n"
			     "create_atoms 1 region low\n"
			     "create_atoms 2 random 5 86028157 box overlap 0.1\n"
			     "set type 1 diameter 0.12 density 1000\n"
			     "set type 2 diameter v_r density 900 vx v_w\n"
			     "group rock type 1\n"
			     "group part region both\n"
			     "group rest subtract all part\n"
			     "velocity rock create 1.0 86028121\n"
			     "delete_atoms group rest\n"
			     "pair_style spring/dashpot\n"
			     "pair_coeff * * stiffness 100 restitution 0.5\n"
			     "bond_style contact\n"
			     "bond_coeff 1 stiffness 100 ultimate 0.01\n"
			     "create_bonds many rock rock 1 0 0.13\n"
			     "flow_style uniform velocity 0 0 1 viscosity 0.01\n"
			     "fix move all nve\n"
			     "fix g all gravity 9.81 vector 0 0 -1\n"
			     "fix drag all drag/stokes\n"
			     "fix floor all wall/gran primitive type 1 zplane -0.03\n"
			     "fix crack all bond/breakage file cracks\n"
			     "fix books all energy/ledger every 5 file books\n"
			     "compute nc all contacts\n"
			     "compute nb all bonds\n"
			     "compute k all ke\n"
			     "compute x part reduce max x\n"
			     "compute out all leave ball\n"
			     "fix mean all ave/time 2 2 4 c_k c_nc file means\n"
			     "fix trace all vector 3 c_k\n"
			     "fix say all print 5 'ke $(c_k)' file said screen no\n"
			     "thermo 4\n"
			     "thermo_style custom step ke c_nc f_mean[1] c_x f_trace[1]\n"
			     "timestep 1e-3\n"
			     "dump a all custom 5 atoms id x y z c_nc v_w\n"
			     "dump z all custom 5 atoms.*.gz id x\n"
			     "dump v all custom/vtk 5 atoms*.vtp id vx vy vz\n"
			     "dump b all local 5 bonds c_nb[1] c_nb[2]\n"
			     "dump l all local/vtk 5 bonds*.vtp c_nb[1] c_nb[2]\n"
			     "restart 7 turn1 turn2\n"
			     "if '${r} > 0' then 'print yes' else 'print no'\n"
			     "run 11\n"
			     "write_restart whole\n"
			     "write_data grains\n"
			     "undump a\n"
			     "unfix g\n"
			     "run 2 every 1 NULL\n";

static const char again[] = "read_restart whole\n"
			    "pair_style spring/dashpot\n"
			    "bond_style contact\n"
			    "fix move all nve\n"
			    "compute k all ke\n"
			    "fix trace all vector 3 c_k\n"
			    "fix books all energy/ledger every 5 file books\n"
			    "run 3\n"
			    "clear\n";

/* Data files, formulas, and styles that remember. */
static const char more[] =
	"units si\n"
	"boundary p f m\n"
	"bond_style contact\n"
	"read_data grains nocoeff\n"
	"read_data grains add append shift 0 0 0.3 nocoeff\n"
	"pair_style spring/dashpot\n"
	"pair_coeff * * stiffness 100 restitution 0.5\n"
	"bond_coeff 1 stiffness 100 ultimate 0.01\n"
	"variable v vector [1,2,3]\n"
	"variable f equal 1+sum(v_v)*normal(0,1,7)+v_v[2]\n"
	"variable h equal 1+0.1*step\n"
	"variable a atom x*2+gmask(all)+random(0,1,5)\n"
	"variable p format f %.3g\n"
	"group few dynamic all var a every 2\n"
	"fix move all nve\n"
	"fix mark all property/atom mark scalar yes no no 0.5\n"
	"fix was all store/state 0 xu yu zu\n"
	"fix push all addforce v_f 0 0\n"
	"fix soft all adapt 2 pair spring/dashpot stiffness 1 1* v_h scale yes\n"
	"compute far all msd\n"
	"compute all few reduce sum x y\n"
	"compute pairs all pair/local dist\n"
	"compute stress all stress/atom\n"
	"thermo_style custom step ke c_far[4] f_push[1] c_all[1]\n"
	"timestep 1e-5\n"
	"write_dump all custom dumped id x f_mark f_was[1] v_a\n"
	"write_dump all image drawn.png x diameter size 70 20 fsaa yes ssao yes 1 0.5 legend yes &\n"
	"	modify acolor * red/blue color mud 1 0.5 0 backcolor mud amap min max cf 0 2 min red max "
	"blue\n"
	"run 4\n"
	"print \"${p} $(v_f*2:%.3g)\"\n"
	"write_restart more\n";

/* A fluid and what acts between it and particles. */
static const char fluid[] =
	"units si\n"
	"boundary f p f\n"
	"newton off\n"
	"communicate single vel yes\n"
	"region box block 0 1 0 1 0 1 units box\n"
	"create_box 1 box\n"
	"create_atoms 1 single 0.3 0.4 0.5\n"
	"create_atoms 1 single 0.6 0.4 0.5\n"
	"set group all diameter 0.1 density 1000\n"
	"fix k all property/global thermalConductivity peratomtype 1\n"
	"fix c all property/global thermalCapacity peratomtype 31\n"
	"fix heat all heat/gran initial_temperature 300\n"
	"flow_style projection cells 4 4 4 viscosity 0.01 density 10\n"
	"flow_boundary zhi wall velocity 0 1 0\n"
	"fix e all void_fraction method kernel\n"
	"fix d all drag/gidaspow scheme exact\n"
	"fix l all lift/saffman\n"
	"fix s all lift/magnus\n"
	"fix p all flow/pressure_gradient\n"
	"fix a all added_mass\n"
	"fix T all flow/scalar conductivity 1 initial 400 exchange ranz_marshall zhi value 500\n"
	"fix m all nve/sphere\n"
	"timestep 1e-3\n"
	"thermo_style custom step ke f_d[1] f_l[1] f_e[1] f_T[1]\n"
	"run 2\n"
	"write_restart fluid\n";

/* A body in a fluid, and what comes out of it. */
static const char wet[] =
	"units si\n"
	"boundary f f f\n"
	"region box block 0 1 0 1 0 1 units box\n"
	"region rod cylinder z 0.5 0.5 0.2 INF INF units box\n"
	"create_box 1 box\n"
	"variable yy internal 0\n"
	"variable u equal v_yy*(1-v_yy)+step\n"
	"flow_style projection cells 4 4 4 viscosity 0.1 density 2 time ab2 body_force v_u 0 0\n"
	"flow_grid y tanh 1.2\n"
	"flow_boundary xlo inlet velocity v_u 0 0 set y yy\n"
	"flow_boundary xhi outlet pressure v_u set y yy hydrostatic yes\n"
	"flow_set velocity v_u 0 0 set y yy\n"
	"pressure_style multigrid\n"
	"fix T all flow/scalar conductivity 0.1 initial v_u set y yy xlo value v_u\n"
	"fix rod all immersed/boundary region rod min_cells 0\n"
	"compute probe all flow/probe 0.1 0.2 0.3 0.5 0.5 0.5 values vx f_T\n"
	"compute line all flow/line cells y 0.5 0.5\n"
	"compute plane all flow/plane x 0.5 values p wz\n"
	"compute flux all flow/flux x 0.5 region rod\n"
	"compute force all flow/force ylo\n"
	"fix mean all ave/time 1 1 2 c_plane[*] mode vector\n"
	"dump d all flow/vtk 1 wet*.vtr\n"
	"thermo_style custom step flow_ke c_probe[1] c_line[2][1] c_flux c_force[7]\n"
	"timestep 1e-4\n"
	"run 1\n"
	"write_restart wet\n";

/* True when the failure has not happened yet: the next allocations fails then. */
static bool survived(void)
{
	void *p = ts_alloc(1, 1);
	bool failed = !p;

	ts_free(p);
	return failed;
}

static int try(const char *text, long k)
{
	struct tsim *sim;
	int status;

	ts_alloc_fail_at(k);
	sim = tsim_open();
	if (!sim)
		return TS_NOMEM;
	status = tsim_string(sim, text);
	if (status && (status != TS_NOMEM || !strstr(tsim_error(sim), "out of memory")))
		ck_abort_msg("allocation %ld: status %d, %s", k, status, tsim_error(sim));
	tsim_close(sim);
	return status;
}

static void each_allocation(const char *text)
{
	int endured = 0;
	long k = 1;

	ts_alloc_fail_at(0);
	ck_assert_int_eq(ts_alloc_balance(), 0);
	for (;; k++) {
		int status = try(text, k);

		if (ts_alloc_balance() != 0)
			ck_abort_msg("allocation %ld fails: %ld blocks are lost", k, ts_alloc_balance());
		if (status == TS_OK && survived())
			break;
		endured += status == TS_OK;
	}
	ts_alloc_fail_at(0);
	ck_assert_int_gt(k, 50);
	ck_assert_int_lt(endured, k / 3); /* most of them matter */
}

START_TEST(fails)
{
	static const char *const texts[] = { script, again, more, fluid, wet };

	ck_assert_int_eq(try(script, 0), TS_OK); /* leaves the restart file */
	each_allocation(texts[_i]);
}
END_TEST

/* After an error the simulation can be used on. */
START_TEST(goes_on)
{
	struct tsim *sim = tsim_open();

	ck_assert_ptr_nonnull(sim);
	ts_alloc_fail_at(700);
	ck_assert(tsim_string(sim, script));
	ts_alloc_fail_at(0);
	tsim_error_clear(sim);
	ck_assert_msg(!tsim_string(sim, "clear"), "%s", tsim_error(sim));
	ck_assert_msg(!tsim_string(sim, script), "%s", tsim_error(sim));
	tsim_close(sim);
	ck_assert_int_eq(ts_alloc_balance(), 0);
}
END_TEST

static void enter(void)
{
	if (!mkdtemp(folder)) {
		strcpy(folder, "/tmp/tsim.alloc.XXXXXX");
		ck_assert_ptr_nonnull(mkdtemp(folder));
	}
	ck_assert_int_eq(chdir(folder), 0);
}

static void leave(void)
{
	char command[100];

	snprintf(command, sizeof command, "rm -rf %s", folder);
	ck_assert_int_eq(chdir("/") + system(command), 0);
}

int main(void)
{
	Suite *suite = suite_create("allocation");
	TCase *all = tcase_create("all");

	tcase_set_timeout(all, 120);
	tcase_add_checked_fixture(all, enter, leave);
	tcase_add_loop_test(all, fails, 0, 5);
	tcase_add_test(all, goes_on);
	suite_add_tcase(suite, all);
	return deck_main(suite);
}
