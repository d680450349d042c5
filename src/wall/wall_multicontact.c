#include "wall/wall_multicontact.h"

#include <math.h>

#include "wall/wall.h"

#include "base/banned.h"

static enum ts_status contact_load(struct tsim *sim, const struct ts_wall *w, size_t k,
				   const struct ts_place *where, struct ts_multicontact_load *one)
{
	const struct ts_particles *p = sim->particles;
	const double *memory = ts_wall_memory(&w->contacts, k) + ts_granular_multi_at(ts_wall_model(w, sim));
	size_t i = (size_t)w->contacts.row[k];
	double distance = ts_norm(memory + TS_MULTI_ARM), radius = p->radius[i];

	*one = (struct ts_multicontact_load){ .load.force = memory[TS_MULTI_FORCE], .wall = w, .contact = k };
	for (int d = 0; d < 3; d++) {
		one->load.e[d] = memory[TS_MULTI_ARM + d] / distance;
		one->load.point[d] = -memory[TS_MULTI_ARM + d];
	}
	one->load.within = sqrt(radius * fmax(0, radius + memory[TS_MULTI_BULGE] - distance));
	if (memory[TS_MULTI_BULGE] <= TS_BULGE_MOST * radius)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "fix multicontact/halfspace: the surface of particle %d stands out by %.3g radii at a "
		       "wall, the limit is %g: the grains are pressed too far for the theory of small "
		       "strains",
		       p->tag[i], memory[TS_MULTI_BULGE] / radius, TS_BULGE_MOST);
}

/* Whether the contacts of a wall store the data of fix multicontact/halfspace in their history. */
static bool has_bulges(const struct ts_wall *w, const struct tsim *sim)
{
	return ts_wall_has_law(w, sim) && ts_wall_model(w, sim)->multi && w->contacts.n;
}

static bool is_touching(const struct ts_wall *w, const struct tsim *sim, size_t k)
{
	const double *memory = ts_wall_memory(&w->contacts, k) + ts_granular_multi_at(ts_wall_model(w, sim));

	return ts_norm(memory + TS_MULTI_ARM) > 0;
}

static void count_wall_contacts(struct ts_multicontact *m, const struct tsim *sim)
{
	const struct ts_wall *w;

	for (size_t walls = 0; (w = ts_walls_next(sim, &walls, NULL));)
		for (size_t k = 0; has_bulges(w, sim) && k < w->contacts.n; k++)
			m->next[w->contacts.row[k]] += is_touching(w, sim, k);
}

static enum ts_status collect_wall_loads(struct ts_multicontact *m, struct tsim *sim,
					 const struct ts_place *where)
{
	const struct ts_wall *w;

	for (size_t walls = 0; (w = ts_walls_next(sim, &walls, NULL));)
		for (size_t k = 0; has_bulges(w, sim) && k < w->contacts.n; k++)
			if (is_touching(w, sim, k))
				TS_TRY(contact_load(sim, w, k, where,
						    &m->load[m->next[w->contacts.row[k]]++]));
	return TS_OK;
}

static bool any_wall_bulges(const struct tsim *sim)
{
	const struct ts_wall *w;
	bool any = false;

	for (size_t k = 0; (w = ts_walls_next(sim, &k, NULL));)
		any |= ts_wall_has_law(w, sim) && ts_wall_model(w, sim)->multi;
	return any;
}

const struct ts_multicontact_walls ts_wall_multicontact = { .any = any_wall_bulges,
							    .count = count_wall_contacts,
							    .collect = collect_wall_loads };
