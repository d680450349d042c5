/* Fix: integrates the clumps that templates of several spheres insert. The work is done in
 * rigid/rigid.c; bodies come apart when this fix is gone. */
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
		if (fixes->item[k]->style == self->style && fixes->item[k] != self)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix multisphere: there is one already, fix %s (line %d)",
				       fixes->item[k]->id, fixes->item[k]->where.line);
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
	.summary = "Moves clumps of spheres as rigid bodies",
	.doc = "Clumps inserted from fix particletemplate/multisphere move as rigid bodies:\n"
	       "M dV/dt = F, dL/dt = T with the sums of what acts on their spheres, by velocity Verlet;\n"
	       "the orientation follows from L by a step extrapolated from one whole and two half steps.\n"
	       "Spheres of a clump do not touch each other, and touch others with the mass of the\n"
	       "clump. Gravity acts on the clump as a whole, whose mass is not that of its overlapping\n"
	       "spheres. A clump that loses a sphere through a fixed face is deleted. The group is\n"
	       "without effect.\n\n"
	       "The spheres must not be moved by another fix (nve/sphere) as well.",
	.example = "fix clumps all multisphere",
	.args = args,
	.state_size = sizeof(struct multisphere),
	.columns = TS_NEED(OMEGA) | TS_NEED(TORQUE) | TS_NEED(BODY) | TS_NEED(BODY_X),
	.init = init,
};
