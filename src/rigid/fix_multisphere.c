/* Fix multisphere: rigid clumps that are inserted from templates of several spheres. The system of rigid
 * bodies (rigid/rigid_system.c) integrates them, and dissolves them when this fix is deleted. */
#include "rigid/rigid.h"

#include "base/banned.h"

struct multisphere {
	bool group_and_set, heat_source;
	double added[2];
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	if (sim->dimension != 3)
		return ts_fail(&sim->error, TS_STATE, &self->where, "fix multisphere needs dimension 3");
	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style == self->style && !ts_streq(fixes->item[k]->id, self->id))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix multisphere: there is one already, fix %s (%s:%d)",
				       fixes->item[k]->id, TS_FILE_AND_LINE(fixes->item[k]->where));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_BOOL("allow_group_and_set", struct multisphere, group_and_set, .fallback = "no",
		.help = "no effect: commands group and set are always allowed"),
	TS_BOOL("allow_heatsource", struct multisphere, heat_source, .fallback = "no",
		.help = "no effect: heat sources are always allowed"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_multisphere)
const struct ts_style ts_fix_multisphere = {
	.name = "multisphere",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "Integrates clumps of spheres as rigid bodies",
	.doc = "Integrates clumps inserted from fix particletemplate/multisphere as rigid bodies, by "
	       "velocity Verlet:\n\n"
	       "    M dV/dt = F,   dL/dt = T\n\n"
	       "where F and T are sums over the forces and torques on their spheres. The orientation follows "
	       "from L by a step that is extrapolated from one full and two half steps.\n\n"
	       "Spheres of a clump do not interact with each other; in contacts with others they have the "
	       "mass of the clump. Gravity acts on the clump as a whole, whose mass is not the sum of its "
	       "overlapping spheres. A clump of which a sphere is lost through a fixed face is deleted. The "
	       "group has no effect.\n\n"
	       "In sums over a group (xcm(), vcm(), angmom(), inertia(), compute com, gyration, fix "
	       "momentum, fix spring, `velocity zero`) a clump is a body with its centre of mass and its "
	       "moments of inertia, and each of its spheres counts for the share of the mass of the clump "
	       "that it has.\n\n"
	       "Clumps follow `velocity`, `set` and displace_atoms as described for fix rigid; "
	       "displace_atoms can move the spheres of a clump together only. A clump takes the velocity "
	       "that its centre of mass has in the motion of the centres of its spheres, from `velocity` at "
	       "once if all its spheres are in the group.\n\n"
	       "The spheres must not be integrated by another fix such as nve/sphere.",
	.example = "fix clumps all multisphere",
	.args = args,
	.state_size = sizeof(struct multisphere),
	.columns = TS_NEED(OMEGA) | TS_NEED(TORQUE) | TS_NEED(BODY) | TS_NEED(BODY_X),
	.init = init,
};
