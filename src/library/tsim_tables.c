#include "library/tsim_tables.h"

#include "bond/bonds.h"
#include "box/domain.h"
#include "contact/contact_system.h"
#include "core/plan.h"
#include "explain/guard.h"
#include "explain/plan_report.h"
#include "flow/flow.h"
#include "group/group_function.h"
#include "insert/stream.h"
#include "integrate/integrators.h"
#include "limits/limits_system.h"
#include "neigh/leaving.h"
#include "neigh/neigh.h"
#include "particle/division.h"
#include "particle/particles.h"
#include "region/region.h"
#include "review/table.h"
#include "rigid/rigid.h"
#include "thermo/thermo.h"
#include "wall/wall_system.h"

#include "base/banned.h"

/* In the order in which they act within a stage. */
static const struct ts_system_style *const systems[] = {
	&ts_domain_system,
	&ts_particles_system,
	&ts_neigh_system,
	&ts_bonds_system,
	&ts_rigid_system,
	&ts_flow_system,
	&ts_thermo_system,
	&ts_guard_system,
	/* without an instance; their order is that in the manual */
	&ts_regions_system,
	&ts_groups_system,
	&ts_integrators_system,
	&ts_stream_system,
	&ts_contact_system,
	&ts_walls_system,
	&ts_limits_system,
	NULL,
};

const struct ts_tables ts_tables = {
	.styles = ts_style_table,
	.systems = systems,
	.checks = ts_review_table,
	.judge = ts_plan_judge,
	.judge_own = ts_plan_judge_own,
	.keep_own = ts_division_keep_own,
	.search_left = ts_leaving_search,
	.divide = ts_division_divide,
	.gather = ts_division_gather,
	.rest = ts_division_rest,
};
