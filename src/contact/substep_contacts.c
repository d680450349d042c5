#include "contact/substep_contacts.h"

#include "base/banned.h"

enum ts_status ts_substep_check(struct tsim *sim, const struct ts_granular_model *model,
				const struct ts_place *where)
{
	const char *why = NULL;

	if (!model->located)
		return TS_OK;
	if (!ts_substep_supports(model))
		why = "the normal law must be spring, hooke, hertz, hooke/stiffness, hooke/modulus or "
		      "hertz/stiffness, and not viscous";
	else if (sim->run.explicit_euler)
		why = "fix nve/euler moves particles by the velocities before the step; use fix nve";
	else if (sim->legacy == TS_LEGACY_LIGGGHTS)
		why = "`legacy yes` reproduces LIGGGHTS, which has no such detection";
	return why ? ts_fail(&sim->error, TS_STATE, where, "located yes: %s", why) : TS_OK;
}
