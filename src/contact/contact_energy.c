#include "contact/contact_energy.h"

#include "bond/bond_moment.h"
#include "contact/contact_loop.h"
#include "law/elastic_energy.h"
#include "neigh/contact_memory.h"
#include "neigh/touching_sums.h"
#include "particle/group_moments.h"

#include "base/banned.h"

static double energy_of_pair(const struct tsim *sim, const struct ts_pair *pair, size_t r)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r], width = list->history_width;
	const struct ts_granular_model *model = ts_pair_model(pair, p->type[i], p->type[j]);
	struct ts_touch t;

	ts_contact_touch(p, i, j, model, &t);
	ts_granular_add_bulge(model, width ? ts_contact_history(list, r) : NULL, &t);
	if (!(t.overlap > 0) && !ts_granular_reaches(model))
		return 0;
	return ts_granular_energy(model, ts_pair_law(pair, p->type[i], p->type[j]), &t,
				  width ? ts_contact_history(list, r) : NULL);
}

double ts_contact_energy_of_row(const struct tsim *sim, size_t r)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);

	return pair ? energy_of_pair(sim, pair->state, r) : 0;
}

static double energy_of_contacts(const struct tsim *sim, size_t i)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_PAIR);
	struct ts_touching touching = ts_touching_of(list, i);
	double sum = 0;
	uint32_t entry;

	while (inst && ts_touching_next(list, &touching, &entry))
		sum += energy_of_pair(sim, inst->state, entry >> 1);
	return sum;
}

static double energy_of_bonds(const struct tsim *sim, size_t i)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_gather *g = &bonds->gather;
	double sum = 0;

	for (size_t k = g->first[i]; inst && k < g->first[i + 1]; k++)
		sum += ts_bond_elastic_energy(sim, g->entry[k] >> 1);
	return sum;
}

double ts_contact_energy_of_particle(const struct tsim *sim, size_t i,
				     const struct ts_contact_energy_parts *parts)
{
	double sum = 0;

	if (parts->pair && sim->neigh->contacts.n)
		sum += 0.5 * energy_of_contacts(sim, i);
	if (parts->bond && sim->bonds->n)
		sum += 0.5 * energy_of_bonds(sim, i);
	return sum;
}

enum ts_status ts_contact_energy_require(struct tsim *sim, const struct ts_instance *self,
					 const struct ts_contact_energy_parts *parts)
{
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	const struct ts_instance *bond = ts_sim_only(sim, TS_KIND_BOND);

	if (parts->pair && pair && !ts_granular_has_energy(&((const struct ts_pair *)pair->state)->model))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       ts_cohesion_bridges(&((const struct ts_pair *)pair->state)->model)
				       ? "liquid bridges have no potential energy: the energy that they "
					 "release depends on the amount of liquid when they break"
				       : "models hooke/hysteresis and edinburgh have no potential energy: "
					 "what a contact releases after yielding depends on the path of "
					 "unloading");
	if (parts->bond && bond && sim->bonds->n && !ts_bond_style_of(bond)->energy &&
	    !ts_bond_style_of(bond)->element)
		return ts_fail(&sim->error, TS_STATE, &self->where, "bond style %s has no potential energy",
			       bond->style->name);
	return ts_contacts_require(sim, self);
}

static void energy_term(const struct tsim *sim, size_t i, const void *context, double *out)
{
	*out = ts_contact_energy_of_particle(sim, i, context);
}

static enum ts_status total_energy(struct ts_instance *self, struct tsim *sim,
				   struct ts_contact_energy_parts parts, double *out)
{
	TS_TRY(ts_contact_energy_require(sim, self, &parts));
	ts_group_sum(sim, 0, 1, energy_term, &parts, out);
	return TS_OK;
}

enum ts_status ts_contact_energy_of_pairs(struct ts_instance *self, struct tsim *sim, double *out)
{
	return total_energy(self, sim, (struct ts_contact_energy_parts){ .pair = true }, out);
}

enum ts_status ts_contact_energy_of_bonds(struct ts_instance *self, struct tsim *sim, double *out)
{
	return total_energy(self, sim, (struct ts_contact_energy_parts){ .bond = true }, out);
}
