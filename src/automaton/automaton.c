#include "automaton/automaton.h"

#include "base/banned.h"

struct ts_automaton *ts_automaton_of(const struct tsim *sim)
{
	const struct ts_instance *live = ts_sim_only(sim, TS_KIND_AUTOMATON);

	return live ? ((const struct ts_automaton_style *)live->style)->of(live) : NULL;
}

enum ts_status ts_automaton_require(struct tsim *sim, const char *who, const struct ts_place *where,
				    struct ts_automaton **out)
{
	*out = ts_automaton_of(sim);
	return *out ? TS_OK
		    : ts_fail(&sim->error, TS_STATE, where,
			      "%s needs an automaton: use automaton_style before it", who);
}
