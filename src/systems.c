/* The systems of a simulation, in the order in which they act within a stage. */
#include "bond/bonds.h"
#include "box/domain.h"
#include "core/style.h"
#include "explain/guard.h"
#include "flow/flow.h"
#include "group/group_function.h"
#include "insert/stream.h"
#include "integrate/integrators.h"
#include "neigh/neigh.h"
#include "particle/particles.h"
#include "region/region.h"
#include "rigid/rigid.h"
#include "thermo/thermo.h"

#include "base/banned.h"

const struct ts_system_style *const ts_system_table[] = {
	&ts_domain_system, &ts_particles_system, &ts_neigh_system,
	&ts_bonds_system,  &ts_rigid_system,	 &ts_flow_system,  &ts_thermo_system, &ts_guard_system,
	/* of names only; their order is that of the manual's lists */
	&ts_regions_system, &ts_groups_system, &ts_integrators_system, &ts_stream_system, NULL,
};
