#include "contact/contact_view.h"

#include <inttypes.h>

#include "bond/bonds.h"
#include "box/domain.h"
#include "math/vec3.h"
#include "neigh/contact_memory.h"
#include "neigh/force_slots.h"
#include "particle/moments.h"

#include "base/banned.h"

static bool rows_current(const struct ts_contact_list *rows, const struct ts_particles *p)
{
	if (rows->particles != p->n)
		return false;
	for (size_t r = 0; r < rows->n; r++) {
		size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];

		if (i >= p->n || j >= p->n + p->nghost || p->tag[i] != rows->tag[0][r] ||
		    p->tag[j] != rows->tag[1][r])
			return false;
	}
	return true;
}

static bool bonds_current(const struct ts_bonds *bonds, const struct ts_particles *p)
{
	for (size_t b = 0; b < bonds->n; b++)
		for (int s = 0; s < 2; s++) {
			size_t i = (size_t)bonds->row[b][s];

			if (i >= p->n || p->tag[i] != bonds->tag[b][s])
				return false;
		}
	return true;
}

enum ts_status ts_contacts_require(struct tsim *sim, const struct ts_instance *self)
{
	bool rows_wanted = sim->neigh->wanted || ts_sim_only(sim, TS_KIND_PAIR);

	ts_contacts_store_history(sim, &sim->neigh->rows);
	if ((!rows_wanted || rows_current(&sim->neigh->rows, sim->particles)) &&
	    bonds_current(sim->bonds, sim->particles))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "%s %s %s: contacts are known only after a run, and not if particles have been "
		       "added or deleted since; `run 0` finds them",
		       ts_kind_name(self->style->kind), self->id, self->style->name);
}

enum ts_status ts_contacts_kept(struct tsim *sim, const struct ts_instance *self)
{
	struct ts_contact_list *rows = &sim->neigh->rows;

	if (rows->results == TS_RESULTS_NONE)
		return ts_contact_forces_keep(sim, rows);
	if (rows->results == TS_RESULTS_KEPT)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "%s %s %s: forces of contacts were not kept at step %" PRId64 "; `run 0` finds them",
		       ts_kind_name(self->style->kind), self->id, self->style->name, sim->clock.step);
}

enum ts_status ts_contacts_forces(struct tsim *sim, const struct ts_instance *self)
{
	TS_TRY(ts_contacts_require(sim, self));
	return ts_contacts_kept(sim, self);
}

bool ts_contact_counts(const struct tsim *sim, size_t r, int group)
{
	const struct ts_contact_list *rows = &sim->neigh->rows;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];

	if (!ts_in_group(p, i, group) || !ts_in_group(p, j, group))
		return false;
	if (j < p->n || p->tag[i] < p->tag[j])
		return true;
	return p->tag[i] == p->tag[j] && rows->image[r] > TS_IMAGE_SELF;
}

void ts_contact_view(const struct tsim *sim, size_t r, struct ts_contact_view *view)
{
	const struct ts_contact_list *rows = &sim->neigh->rows;
	const struct ts_particles *p = sim->particles;
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
	size_t owner = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
	bool swap = rows->tag[0][r] > rows->tag[1][r];

	view->row = r;
	view->a = swap ? owner : i;
	view->b = swap ? i : owner;
	view->image = j >= p->n;
	view->sign = swap ? -1 : 1;
	ts_sub(p->x[i], p->x[j], view->d);
	ts_scale(view->sign, view->d, view->d);
	ts_scale(view->sign, ts_contact_force(rows, r), view->force);
	view->distance = ts_norm(view->d);
}

void ts_bond_view(const struct tsim *sim, size_t b, struct ts_contact_view *view)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	double direct[3];

	view->row = b;
	view->a = (size_t)bonds->row[b][0];
	view->b = (size_t)bonds->row[b][1];
	view->sign = 1;
	ts_sub(p->x[view->a], p->x[view->b], direct);
	for (int k = 0; k < 3; k++)
		view->d[k] = direct[k];
	ts_box_nearest(&sim->domain->box, view->d);
	view->image = ts_distance2(view->d, direct) > 0;
	view->distance = ts_norm(view->d);
	/* as the bond loop does it; after a restart the tension is known, the force not yet */
	for (int k = 0; k < 3; k++)
		view->force[k] =
			view->distance > 0 ? -bonds->tension[b] * (view->d[k] * (1 / view->distance)) : 0;
}

/* The product is the same seen from either side: both factors change their sign. */
static void add_product(double w[6], const double d[3], const double f[3])
{
	for (int k = 0; k < 6; k++)
		w[k] += 0.5 * d[ts_tensor_row[k]] * f[ts_tensor_column[k]];
}

static void add_contacts(const struct tsim *sim, size_t i, double w[6])
{
	const struct ts_contact_list *rows = &sim->neigh->rows;
	const struct ts_gather *g = &rows->gather;
	const struct ts_particles *p = sim->particles;

	for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
		size_t r = g->entry[k] >> 1;
		double d[3];

		ts_sub(p->x[rows->i[r]], p->x[rows->j[r]], d);
		if (rows->touching[r])
			add_product(w, d, ts_contact_force(rows, r));
	}
}

static void add_bonds(const struct tsim *sim, size_t i, double w[6])
{
	const struct ts_gather *g = &sim->bonds->gather;
	struct ts_contact_view view;

	for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
		ts_bond_view(sim, g->entry[k] >> 1, &view);
		add_product(w, view.d, view.force);
	}
}

void ts_virial_of(const struct tsim *sim, size_t i, const struct ts_virial_parts *parts, double w[6])
{
	for (int k = 0; k < 6; k++)
		w[k] = 0;
	if (parts->pair && sim->neigh->rows.n)
		add_contacts(sim, i, w);
	if (parts->bond && sim->bonds->n)
		add_bonds(sim, i, w);
}

static void virial_term(const struct tsim *sim, size_t i, void *context, double *term)
{
	ts_virial_of(sim, i, context, term);
}

void ts_virial_total(const struct tsim *sim, const struct ts_virial_parts *parts, double out[6])
{
	struct ts_virial_parts wanted = *parts;

	ts_group_sum(sim, 0, 6, virial_term, &wanted, out);
}

double ts_pressure_volume(const struct tsim *sim)
{
	double volume = 1;

	for (int d = 0; d < sim->dimension; d++)
		volume *= ts_box_length(&sim->domain->box, d);
	return volume;
}

double ts_pressure_mean(const struct tsim *sim, const double tensor[6])
{
	return (tensor[0] + tensor[1] + (sim->dimension == 3 ? tensor[2] : 0)) / sim->dimension;
}

enum ts_status ts_virial_read(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
			      struct ts_virial_parts *parts)
{
	/* of the last six there is nothing to add here */
	static const char *const names[] = { "ke",    "pair",	  "bond",     "virial", "fix",
					     "angle", "dihedral", "improper", "kspace", NULL };

	*parts = (struct ts_virial_parts){ 0 };
	if (!words.n)
		*parts = (struct ts_virial_parts){ true, true, true };
	for (size_t k = 0; k < words.n; k++) {
		const char *word = words.word[k].text;
		struct ts_suggest suggest = ts_suggest_start(word);
		bool known = false;

		for (const char *const *name = names; *name; name++) {
			known |= ts_streq(word, *name);
			ts_suggest_try(&suggest, *name);
		}
		if (!known)
			return ts_fail(&sim->error, TS_UNKNOWN, &words.word[k].place,
				       "compute %s: unknown keyword '%s'%s", self->style->name, word,
				       ts_suggest_text(&suggest));
		parts->kinetic |= ts_streq(word, "ke");
		parts->pair |= ts_streq(word, "pair") || ts_streq(word, "virial");
		parts->bond |= ts_streq(word, "bond") || ts_streq(word, "virial");
	}
	return TS_OK;
}
