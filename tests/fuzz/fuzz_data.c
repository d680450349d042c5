/* Any bytes as a data file: as the start of a simulation, and again added to it. */
#include <stdlib.h>
#include <string.h>

#include "sandbox.h"

#include "core/sim.h"
#include "tsim.h"

static const char script[] = "units si\n"
			     "atom_style granular\n"
			     "boundary p f m\n"
			     "bond_style contact\n"
			     "read_data input\n"
			     "pair_style spring/dashpot\n"
			     "pair_coeff * * stiffness 2385.0 restitution 0.6\n"
			     "bond_coeff * stiffness 1931.0 ultimate 0.35\n"
			     "fix move all nve\n"
			     "compute nb all bonds\n"
			     "dump d all custom 1 d id type x y z vx vy vz ix\n"
			     "thermo_modify lost ignore\n"
			     "run 2\n"
			     "write_data again\n"
			     "read_data input add append shift 0.1 0 0\n"
			     "run 1\n";

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct tsim *sim = tsim_open();

	if (!sim)
		return 0;
	sandbox_enter(sim, data, size);
	tsim_string(sim, script);
	sandbox_report(sim);
	tsim_close(sim);
	sandbox_leave();
	return 0;
}
