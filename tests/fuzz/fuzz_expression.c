/* Any bytes as expressions, one per line, in a simulation that has something of everything a name can
 * stand for. */
#include <stdlib.h>
#include <string.h>

#include "sandbox.h"

#include "core/sim.h"
#include "tsim.h"

static const char setting[] = "units si\n"
			      "boundary p f m\n"
			      "region box block 0 1 0 1 0 1 units box\n"
			      "region low block 0 0.5 0 1 0 1 units box\n"
			      "create_box 2 box\n"
			      "create_atoms 1 single 0.3 0.4 0.5 units box\n"
			      "create_atoms 2 single 0.385 0.4 0.5 units box\n"
			      "create_atoms 2 single 0.7 0.4 0.5 units box\n"
			      "set type 1 diameter 0.12 density 1000\n"
			      "set type 2 diameter 0.1 density 900 vx 0.2\n"
			      "group rock type 1\n"
			      "group none region box\n"
			      "variable a equal 2.5\n"
			      "variable b atom x*2\n"
			      "variable c equal v_c+1\n"
			      "variable s string word\n"
			      "variable i index 1 2 3\n"
			      "variable l loop 5\n"
			      "pair_style spring/dashpot\n"
			      "pair_coeff * * stiffness 100 restitution 0.5\n"
			      "compute nc all contacts\n"
			      "compute k all ke\n"
			      "compute m all reduce max x vx\n"
			      "fix move all nve\n"
			      "fix mean all ave/time 1 1 1 c_k\n"
			      "fix trace all vector 1 c_k\n"
			      "thermo_style custom step ke c_k\n"
			      "timestep 1e-4\n"
			      "run 3\n";
static struct tsim *sim;

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	sim = tsim_open();
	if (!sim)
		abort();
	sim->log.screen = NULL;
	if (tsim_string(sim, setting)) {
		fputs(tsim_error(sim), stderr);
		abort();
	}
	return 0;
}

static void evaluate(const char *line)
{
	static const char form[] = "print \"${a} %s $(%s)\"\n";
	size_t n = strlen(form) + 2 * strlen(line) + 1;
	char *command = malloc(n);
	double value;

	tsim_value(sim, line, &value);
	tsim_error_clear(sim);
	if (command) {
		snprintf(command, n, form, line, line);
		tsim_string(sim, command);
		snprintf(command, n, "if \"%s\" then \"print yes\"", line);
		tsim_string(sim, command);
		tsim_error_clear(sim);
		snprintf(command, n, "variable t atom \"%s\"\n", line);
		if (!tsim_string(sim, command))
			tsim_string(sim, "dump d all custom 1 d id v_t\nrun 0 post no\nundump d\n");
		tsim_error_clear(sim);
		tsim_string(sim, "undump d\n");
		tsim_error_clear(sim);
	}
	free(command);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	char *text = size < 4096 ? malloc(size + 1) : NULL;

	if (!text)
		return 0;
	sandbox_enter(sim, data, size);
	memcpy(text, data, size);
	text[size] = 0;
	for (char *line = text, *end; line; line = end ? end + 1 : NULL) {
		end = strchr(line, '\n');
		if (end)
			*end = 0;
		evaluate(line);
	}
	sandbox_leave();
	free(text);
	return 0;
}
