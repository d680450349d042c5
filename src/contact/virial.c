#include "contact/virial.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "bond/bonds.h"
#include "box/domain.h"
#include "contact/contact_view.h"
#include "core/name_list.h"
#include "math/vec3.h"
#include "neigh/touching_sums.h"
#include "particle/group_moments.h"

#include "base/banned.h"

/* d f / 2. The product does not depend on which particle is the first: both factors change their sign. */
static inline void add_virial_of_pair(double w[restrict 6], const double d[3], const double f[restrict 3])
{
	const double x = 0.5 * d[0], y = 0.5 * d[1], z = 0.5 * d[2];

	w[0] += x * f[0];
	w[1] += y * f[1];
	w[2] += z * f[2];
	w[3] += x * f[1];
	w[4] += x * f[2];
	w[5] += y * f[2];
}

static void add_virial_of_contacts(const struct tsim *sim, size_t i, double w[6])
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	uint32_t entry;

	for (struct ts_touching t = ts_touching_of(list, i); ts_touching_next(list, &t, &entry);) {
		size_t r = entry >> 1;
		double d[3];

		ts_sub(p->x[list->i[r]], p->x[list->j[r]], d);
		add_virial_of_pair(w, d, ts_contact_force(list, ts_contact_slot(list, r)));
	}
}

static void add_virial_of_bonds(const struct tsim *sim, size_t i, double w[6])
{
	const struct ts_gather *g = &sim->bonds->gather;
	struct ts_contact_view view;

	for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
		ts_contact_view_of_bond(sim, g->entry[k] >> 1, &view);
		add_virial_of_pair(w, view.d, view.force);
	}
}

void ts_virial_of_particle(const struct tsim *sim, size_t i, const struct ts_virial_parts *parts, double w[6])
{
	for (int k = 0; k < 6; k++)
		w[k] = 0;
	if (parts->pair && sim->neigh->contacts.n)
		add_virial_of_contacts(sim, i, w);
	if (parts->bond && sim->bonds->n)
		add_virial_of_bonds(sim, i, w);
}

static void virial_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	ts_virial_of_particle(sim, i, context, term);
}

void ts_virial_total(const struct tsim *sim, const struct ts_virial_parts *parts, double out[6])
{
	struct ts_virial_parts wanted = *parts;

	ts_group_sum(sim, 0, 6, virial_term, &wanted, out);
}

enum ts_status ts_virial_join(struct tsim *sim, const struct ts_instance *self,
			      const struct ts_virial_parts *parts, double kept[6], int64_t *step)
{
	if (!sim->run.complete)
		return TS_OK;
	if (self && parts->pair)
		TS_TRY(ts_contacts_kept(sim, self));
	ts_virial_total(sim, parts, kept);
	*step = sim->clock.step;
	return TS_OK;
}

enum ts_status ts_virial_now(struct tsim *sim, const struct ts_instance *self,
			     const struct ts_virial_parts *parts, const double kept[6], int64_t step,
			     double out[6])
{
	if (!sim->run.looks) {
		if (self)
			TS_TRY(ts_contacts_forces(sim, self));
		else if (ts_sim_only(sim, TS_KIND_BOND))
			TS_TRY(ts_contacts_require(sim, ts_sim_only(sim, TS_KIND_BOND)));
		if (sim->bonds->n && !sim->bonds->gather.first)
			return ts_fail(&sim->error, TS_STATE, NULL,
				       "the pressure is not known before the first run: forces of bonds are "
				       "missing");
		ts_virial_total(sim, parts, out);
		return TS_OK;
	}
	if (step != sim->clock.step)
		return ts_fail(&sim->error, TS_STATE, self ? &self->where : NULL,
			       "the pressure is not known at step %" PRId64
			       ": forces of contacts were not kept",
			       sim->clock.step);
	memcpy(out, kept, 6 * sizeof *out);
	return TS_OK;
}

double ts_virial_box_volume(const struct tsim *sim)
{
	double volume = 1;

	for (int d = 0; d < sim->dimension; d++)
		volume *= ts_box_length(&sim->domain->box, d);
	return volume;
}

double ts_virial_mean_pressure(const struct tsim *sim, const double tensor[6])
{
	return (tensor[0] + tensor[1] + (sim->dimension == 3 ? tensor[2] : 0)) / sim->dimension;
}

enum ts_status ts_virial_read_parts(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
				    struct ts_virial_parts *parts)
{
	/* the last six are accepted; contacts and bonds have nothing to add to them */
	static const char *const names[] = { "ke",    "pair",	  "bond",     "virial", "fix",
					     "angle", "dihedral", "improper", "kspace", NULL };
	char what[80];

	snprintf(what, sizeof what, "compute %s", self->style->name);
	TS_TRY(ts_name_list_check_keywords(sim, what, words, names));
	*parts = (struct ts_virial_parts){ 0 };
	if (!words.n)
		*parts = (struct ts_virial_parts){ true, true, true };
	for (size_t k = 0; k < words.n; k++) {
		const char *word = words.word[k].text;

		parts->kinetic |= ts_streq(word, "ke");
		parts->pair |= ts_streq(word, "pair") || ts_streq(word, "virial");
		parts->bond |= ts_streq(word, "bond") || ts_streq(word, "virial");
	}
	return TS_OK;
}
