#include "contact/multicontact.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "material/property.h"
#include "neigh/contact_memory.h"

#include "base/banned.h"

enum ts_status ts_multicontact_prepare(struct ts_multicontact *m, struct tsim *sim,
				       const struct ts_place *where)
{
	static const char who[] = "fix multicontact/halfspace";
	int types = sim->particles->ntypes;

	if (TS_GROW(m->compliance, m->compliance_capacity, (size_t)types + 1) != TS_OK ||
	    TS_GROW(m->poisson, m->poisson_capacity, (size_t)types + 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (int t = 1; t <= types; t++) {
		double young;

		TS_TRY(ts_property_value(sim, "youngsModulus", t, 0, who, where, &young));
		TS_TRY(ts_property_value(sim, "poissonsRatio", t, 0, who, where, &m->poisson[t]));
		m->compliance[t] = ts_halfspace_compliance(young, m->poisson[t], m->prefactor);
	}
	return TS_OK;
}

/* ---- the loads on each particle: first of its pairs, in the order of its partners, then of walls */

/* Whether pair r is a load for other contacts of its particles. */
static bool carries_load(const struct ts_pair *pair, const struct ts_contact_list *list,
			 const struct ts_particles *p, size_t r)
{
	return ts_contact_touches(list, r) &&
	       ts_pair_model(pair, p->type[list->i[r]], p->type[list->j[r]])->multi;
}

/* Contact point of pair r relative to the centre of its particle `side`, normal e into this particle, gap of
 * the undeformed surfaces; lengths. */
static void contact_point(const struct ts_contact_list *list, const struct ts_particles *p, size_t r,
			  int side, double e[3], double point[3], double *gap)
{
	size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
	double d[3], distance;

	ts_sub(p->x[i], p->x[j], d);
	distance = ts_norm(d);
	/* the same bits whichever particle comes first */
	*gap = distance - fmax(p->radius[i], p->radius[j]) - fmin(p->radius[i], p->radius[j]);
	ts_scale(distance > 0 ? (side ? -1 : 1) / distance : 0, d, e);
	ts_scale(-(p->radius[side ? j : i] + 0.5 * *gap), e, point);
}

static struct ts_multicontact_load load_of_pair(const struct ts_pair *pair,
						const struct ts_contact_list *list,
						const struct ts_particles *p, size_t r, int side)
{
	const struct ts_granular_model *model = ts_pair_model(pair, p->type[list->i[r]], p->type[list->j[r]]);
	const double *memory = ts_contact_history(list, r) + ts_granular_multi_at(model);
	double a = p->radius[list->i[r]], b = p->radius[list->j[r]], gap;
	struct ts_multicontact_load one = { .load.force = memory[TS_MULTI_FORCE] };

	contact_point(list, p, r, side, one.load.e, one.load.point, &gap);
	one.load.within = sqrt(a * b / (a + b) * fmax(0, memory[TS_MULTI_BULGE] - gap));
	return one;
}

static enum ts_status count_loads(struct ts_multicontact *m, const struct tsim *sim,
				  const struct ts_pair *pair)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_gather *g = &list->gather;
	size_t n = sim->particles->n;

	if (TS_GROW(m->first, m->first_capacity, n + ts_copies(sim) + 1) != TS_OK ||
	    TS_GROW(m->next, m->next_capacity, n + 1) != TS_OK)
		return TS_NOMEM;
	for (size_t i = 0; i < n; i++) {
		m->next[i] = 0;
		for (size_t k = g->first ? g->first[i] : 0; pair && list->n && k < g->first[i + 1]; k++)
			m->next[i] += carries_load(pair, list, sim->particles, g->entry[k] >> 1);
	}
	sim->neigh->multicontact_walls->count(m, sim);
	m->first[0] = 0;
	for (size_t i = 0; i < n; i++) {
		m->first[i + 1] = m->first[i] + m->next[i];
		m->next[i] = m->first[i];
	}
	return TS_GROW(m->load, m->load_capacity, m->first[n] + 1);
}

static enum ts_status collect_loads(struct ts_multicontact *m, struct tsim *sim, const struct ts_pair *pair,
				    const struct ts_place *where)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_gather *g = &list->gather;

	if (count_loads(m, sim, pair) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < sim->particles->n && pair && list->n; i++)
		for (size_t k = g->first[i]; k < g->first[i + 1]; k++)
			if (carries_load(pair, list, sim->particles, g->entry[k] >> 1))
				m->load[m->next[i]++] =
					load_of_pair(pair, list, sim->particles, g->entry[k] >> 1,
						     (int)(g->entry[k] & 1));
	return sim->neigh->multicontact_walls->collect(m, sim, where);
}

/* Appends the loads on copies. */
static enum ts_status get_loads_of_copies(struct ts_multicontact *m, struct tsim *sim)
{
	const size_t n = sim->particles->n, copies = ts_copies(sim);
	size_t more;

	if (!sim->division)
		return TS_OK;
	if (ts_copies_forward_rows(sim, sizeof *m->load, m->first, m->load, &m->copied) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < copies; k++)
		m->first[n + k + 1] = m->first[n + k] + m->copied.count[k];
	more = m->first[n + copies] - m->first[n];
	if (TS_GROW(m->load, m->load_capacity, m->first[n + copies] + 1) != TS_OK)
		return ts_nomem(&sim->error);
	if (more)
		memcpy(m->load + m->first[n], m->copied.rows.data, more * sizeof *m->load);
	return TS_OK;
}

/* ---- displacements */

/* Contacts nearer than this fraction of the radius are the same one: the pair itself, or its other entry
 * across a periodic face. */
static const double SAME = 1e-6;

/* Whether a load on particle i is that of the contact at `point` itself: contact number `contact` of a wall, or one that
 * has moved to another triangle of its mesh; of a pair (no wall), the same point. */
static bool is_itself(const struct ts_multicontact_load *one, const double point[3], double radius,
		      const struct ts_wall *wall, size_t contact)
{
	const double distance = sqrt(ts_distance2(one->load.point, point)), same = SAME * radius;

	if (one->wall != wall)
		return false;
	return wall ? one->contact == contact || distance <= fmax(same, one->load.within) : distance <= same;
}

static double surface_displacement(const struct ts_multicontact *m, const struct ts_particles *p, size_t i,
				   const double e[3], const double point[3], const struct ts_wall *wall,
				   size_t contact)
{
	double sum = 0;

	if (!ts_in_group(p, i, m->group))
		return 0;
	for (size_t k = m->first[i]; k < m->first[i + 1]; k++) {
		const struct ts_multicontact_load *one = &m->load[k];

		if (is_itself(one, point, p->radius[i], wall, contact))
			continue;
		sum += ts_halfspace_bulge(&one->load, e, point, m->compliance[p->type[i]],
					  m->poisson[p->type[i]]);
	}
	return sum;
}

struct task {
	const struct ts_multicontact *m;
	const struct tsim *sim;
};

static void displace_pairs_share(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_contact_list *list = &t->sim->neigh->contacts;
	const struct ts_particles *p = t->sim->particles;

	for (size_t r = from; r < to; r++) {
		size_t i = (size_t)list->i[r], j = (size_t)list->j[r];
		size_t owner = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
		double e[3], point[3], gap, a = p->radius[i], b = p->radius[j], ours, theirs;

		contact_point(list, p, r, 0, e, point, &gap);
		t->m->bulge[r] = (struct ts_contact_bulge){ 0, a * b / (a + b) };
		if (gap > TS_BULGE_MOST * (a + b))
			continue;
		ours = surface_displacement(t->m, p, i, e, point, NULL, 0);
		contact_point(list, p, r, 1, e, point, &gap);
		theirs = surface_displacement(t->m, p, owner, e, point, NULL, 0);
		a += ours;
		b += theirs;
		t->m->bulge[r] = (struct ts_contact_bulge){ ours + theirs, a * b / (a + b) };
	}
}

enum ts_status ts_multicontact_update(struct ts_multicontact *m, struct tsim *sim,
				      const struct ts_place *where)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_PAIR);
	struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_pair *pair = inst ? inst->state : NULL;
	const struct ts_particles *p = sim->particles;
	struct task task = { m, sim };

	list->bulge = NULL;
	pair = pair && pair->model.multi ? pair : NULL;
	ts_contacts_store_history(sim, list);
	TS_TRY(collect_loads(m, sim, pair, where));
	TS_TRY(get_loads_of_copies(m, sim));
	if (!pair)
		return TS_OK;
	if (TS_GROW(m->bulge, m->bulge_capacity, list->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	ts_parallel(ts_team(sim, list->n), list->n, displace_pairs_share, &task);
	list->bulge = m->bulge;
	for (size_t r = 0; r < list->n; r++) {
		double sum = p->radius[list->i[r]] + p->radius[list->j[r]];

		if (m->bulge[r].bulge <= TS_BULGE_MOST * sum)
			continue;
		return ts_fail(&sim->error, TS_RANGE, where,
			       "fix multicontact/halfspace: the surfaces of particles %d and %d are "
			       "displaced by %.3g of the sum of their radii, the limit is %g: strains are "
			       "too large for linear elasticity",
			       ts_contact_tag(list, r, 0), ts_contact_tag(list, r, 1),
			       m->bulge[r].bulge / sum, TS_BULGE_MOST);
	}
	return TS_OK;
}

double ts_multicontact_at_wall(const struct tsim *sim, size_t i, const double e[3], double distance,
			       const struct ts_wall *wall, size_t contact)
{
	double point[3];

	if (!sim->neigh->multicontact)
		return 0;
	ts_scale(-distance, e, point);
	return surface_displacement(sim->neigh->multicontact, sim->particles, i, e, point, wall, contact);
}

double ts_multicontact_bytes(const struct tsim *sim)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	size_t touching = 0;

	for (size_t r = 0; r < list->n; r++)
		touching += ts_contact_touches(list, r);
	return (double)(2 * touching * sizeof(struct ts_multicontact_load)) /
	       fmax((double)sim->particles->n, 1);
}

void ts_multicontact_release(struct ts_multicontact *m)
{
	if (m->neigh && m->neigh->multicontact == m) { /* not that of a fix which replaces this one */
		m->neigh->multicontact = NULL;
		m->neigh->contacts.bulge = NULL;
	}
	ts_free(m->compliance);
	ts_free(m->poisson);
	ts_free(m->first);
	ts_free(m->next);
	ts_free(m->load);
	ts_free(m->bulge);
	ts_copied_rows_release(&m->copied);
}

enum ts_status ts_multicontact_check(struct tsim *sim, const struct ts_granular_model *model,
				     const struct ts_place *where)
{
	if (!model->multi || sim->neigh->multicontact)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, where,
		       "surface multicontact needs `fix ID all multicontact/halfspace`, which computes the "
		       "displacements of surfaces");
}
