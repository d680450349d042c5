#include "limits/limits_system.h"

#include "limits/ground.h"
#include "limits/network.h"
#include "limits/tunnelling.h"
#include "neigh/neigh.h"

#include "base/banned.h"

static enum ts_status report_limits(struct ts_plan_report *report, struct tsim *sim)
{
	TS_TRY(ts_ground_report(report, sim));
	return ts_network_report(report, sim);
}

static void connect_limits(struct tsim *sim)
{
	sim->neigh->callback.find_hit = ts_tunnelling_find;
}

const struct ts_system_style ts_limits_system = {
	.style = { .name = "limits",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "limits of the time step of coupled contacts, walls and bonds, and of what "
			      "holds particles" },
	.no_instance = true,
	.connect = connect_limits,
	.limits = report_limits,
};
