/* Fix multicontact/halfspace: elastic interaction between the contacts of one particle. */
#include "contact/multicontact.h"
#include "core/report.h"
#include "core/sim.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	struct ts_multicontact *m = self->state;

	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style == self->style && !ts_streq(fixes->item[k]->id, self->id))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix multicontact/halfspace: there is one already, fix %s (%s:%d), "
				       "and it acts on all contacts",
				       fixes->item[k]->id, TS_FILE_AND_LINE(fixes->item[k]->where));
	sim->neigh->multicontact = m;
	m->neigh = sim->neigh;
	m->group = self->group;
	return ts_multicontact_prepare(m, sim, &self->where);
}

static enum ts_status pre_force(struct ts_instance *self, struct tsim *sim)
{
	return ts_multicontact_update(self->state, sim, &self->where);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);

	report->copied.messages += 2;
	report->copied.bytes += sizeof(uint32_t) + ts_multicontact_bytes(sim);
	if ((pair && ((const struct ts_pair *)pair->state)->model.multi) ||
	    sim->neigh->multicontact_walls->any(sim))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix multicontact/halfspace: no contacts have `surface multicontact` of pair_style "
		       "gran or fix wall/gran");
}

static void fini(struct ts_instance *self)
{
	ts_multicontact_release(self->state);
}

static const struct ts_arg args[] = {
	TS_REAL("geometric_prefactor", struct ts_multicontact, prefactor, .fallback = "1",
		.range = TS_NOT_NEGATIVE,
		.help = "gamma: factor for the shape of a particle instead of a half space; Brodu et al. "
			"found 1 to 1.5"),
	TS_ARGS_END,
};

static const char doc[] =
	"The contacts of a particle interact: a force that presses on one place of its surface displaces the "
	"surface at the other contacts, outwards or inwards. Contacts of `pair_style gran ... surface "
	"multicontact` and of walls with these words have the overlap\n\n"
	"    delta = R_i + s_i + R_j + s_j - r,   s_i = sum of s_ik over the other contacts k of particle "
	"i,\n"
	"    s_ik = -gamma (1 + nu) F_k/(2 pi Y d) [(e_k.u) (e.u) + (3 - 4 nu) e_k.e - (1 - 2 nu) (e_k + "
	"u).e/(1 + e_k.u)]\n\n"
	"with Y and nu of particle i, F_k the normal force of contact k in the last step, e and e_k the unit "
	"normals into the particle, d u the vector from contact k to this one, |u| = 1. This is the normal "
	"displacement of the surface of an elastic half space (Boussinesq; N. Brodu, J. A. Dijksman, R. P. "
	"Behringer, Phys. Rev. E 91 (2015) 032201). The contact point is midway between the two surfaces of "
	"particles, or on the wall; walls are rigid. Within the contact area of k, of radius sqrt(R* delta), "
	"d is this radius. An isolated pair of particles has the forces that it has without the fix. With "
	"neighbouring contacts, particles may be in contact before their undeformed surfaces touch. If the "
	"surfaces of two particles are displaced outwards by more than 0.1 of the sum of their radii, the "
	"run stops, as strains are not small any more. Surfaces of particles outside the group are not "
	"displaced.\n\n"
	"Restrictions: needs youngsModulus and poissonsRatio (fix property/global), model hertz, hooke or "
	"hooke/hysteresis, and no cohesion.\n\n"
	"Displacements depend on the forces of the step before; they converge within about ten steps, as "
	"long as s is smaller than the overlap. R* is that of the radii R + s; LIGGGHTS uses R instead of R "
	"+ s for one of two particles (not at walls), so its forces may differ by the fraction s/(4 R). "
	"Elastic energy is that of the overlaps delta; the work of moving surfaces is booked as dissipated "
	"by fix energy/ledger.\n\n"
	"Equations typeset, assumptions, order and limits: doc/theory-multicontact.md.";

TS_STYLE(fix, ts_style, ts_fix_multicontact_halfspace)
const struct ts_style ts_fix_multicontact_halfspace = {
	.name = "multicontact/halfspace",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "lets the contacts of a particle displace its surface at its other contacts, as on an "
		   "elastic half space",
	.doc = doc,
	.example = "fix mc all multicontact/halfspace geometric_prefactor 1.125",
	.args = args,
	.state_size = sizeof(struct ts_multicontact),
	.init = init,
	.hook = { [TS_STAGE_PRE_FORCE] = pre_force },
	.plan = plan,
	.fini = fini,
};
