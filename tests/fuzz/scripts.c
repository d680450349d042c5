#include "scripts.h"

#include <stdlib.h>
#include <string.h>

#include "sandbox.h"

#include "core/sim.h"
#include "script/script.h"
#include "tsim.h"

/* A check that ends by itself has a report; one that was stopped need not. */
static void report(struct tsim *sim)
{
	struct ts_str errors = { 0 }, text = { 0 };
	int n = 0;

	ts_script_check_report(sim->script_api_data, &errors, &text, &n);
	ts_str_release(&errors);
	ts_str_release(&text);
}

void fuzz_as_script(const uint8_t *data, size_t size, enum fuzz_mode mode)
{
	struct tsim *sim = tsim_open();
	FILE *script;
	int status = 0;

	if (!sim)
		return;
	sandbox_enter(sim, data, size);
	sim->reading.explain = mode == FUZZ_EXPLAIN;
	if (mode == FUZZ_CHECK)
		status = ts_script_check(sim->script_api_data);
	script = size && !status ? fopen("input", "r") : NULL;
	if (script) {
		status = tsim_stream(sim, script, "input");
		fclose(script);
		if (mode == FUZZ_CHECK && !status)
			report(sim);
		ts_script_warn_unused(sim->script_api_data);
	}
	sandbox_report(sim);
	tsim_close(sim);
	sandbox_leave();
}
