#include "limits/limits_system.h"

#include "limits/network.h"
#include "limits/pace.h"
#include "neigh/neigh.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	sim->neigh->ask.hits = ts_pace_hits;
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	(void)self;
	return ts_network_report(report, sim);
}

const struct ts_system_style ts_limits_system = {
	.style = { .name = "limits",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "limits of the time step that contacts, walls and bonds have together",
		   .init = init,
		   .plan = plan },
};
