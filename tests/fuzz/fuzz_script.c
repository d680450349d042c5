/* Any bytes as a script. "#explain" at the start: planned only. */
#include <string.h>

#include "sandbox.h"

#include "core/sim.h"
#include "tsim.h"

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	static const char explain[] = "#explain";
	struct tsim *sim = tsim_open();
	FILE *script;

	if (!sim)
		return 0;
	sandbox_enter(sim, data, size);
	sim->explain = size > strlen(explain) && memcmp(data, explain, strlen(explain)) == 0;
	script = size ? fopen("input", "r") : NULL;
	if (script) {
		tsim_stream(sim, script, "input");
		fclose(script);
	}
	sandbox_report(sim);
	tsim_close(sim);
	sandbox_leave();
	return 0;
}
