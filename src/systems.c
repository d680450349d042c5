/* The systems of a simulation, in the order in which they act within a stage. */
#include "core/guard.h"
#include "core/style.h"
#include "flow/flow.h"
#include "io/thermo.h"
#include "neigh/bonds.h"
#include "neigh/neigh.h"
#include "particles/domain.h"
#include "particles/particles.h"
#include "particles/rigid.h"

#include "base/banned.h"

const struct ts_system_style *const ts_system_table[] = {
	&ts_domain_system, &ts_particles_system, &ts_neigh_system,
	&ts_bonds_system,  &ts_rigid_system,	 &ts_flow_system,  &ts_thermo_system, &ts_guard_system, NULL,
};
