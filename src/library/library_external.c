/* Numbers of the outside program for a fix that takes them. */
#include "library/library.h"

#include "base/banned.h"

int tsim_external(struct tsim *sim, const char *fix, const char *what, double *value, size_t n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS(sim, fix);
	TS_LIBRARY_NEEDS(sim, what);
	TS_LIBRARY_NEEDS_ARRAY(sim, value, n);

	const struct ts_word id = { .text = fix };
	struct ts_instance *inst = NULL;
	enum ts_status status = ts_sim_require(sim, TS_KIND_FIX, &id, &inst);

	if (status == TS_OK && !inst->style->take)
		status = ts_fail(&sim->error, TS_STATE, NULL,
				 "fix %s takes no numbers from a program: fix external does",
				 inst->style->name);
	if (status == TS_OK && !sim->run.inside)
		status = ts_stepping_watch(&sim->library->stepping, sim);
	if (status == TS_OK)
		status = inst->style->take(inst, sim, what, value, n);
	return ts_library_result(sim, status);
}
