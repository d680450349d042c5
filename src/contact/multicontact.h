/* Surfaces that stand out, or are pressed in, where other contacts of the same grain load it:
 * `surface multicontact` of pair_style gran and fix wall/gran, with fix multicontact/halfspace.
 * Loads are those of the last step, as the contacts remember them; law/halfspace.h says what they
 * do. */
#ifndef TS_CONTACT_MULTICONTACT_H
#define TS_CONTACT_MULTICONTACT_H

#include "contact/pair.h"
#include "law/halfspace.h"

struct ts_wall;

struct ts_multicontact_load {
	struct ts_halfspace_load load;
	const struct ts_wall *wall; /* of a contact with a wall; NULL: of two grains */
};

struct ts_multicontact;

/* The loads that walls put on particles: sim->neigh->multicontact_walls. */
struct ts_multicontact_walls {
	/* Whether some wall has contacts that know of the others of their grain. */
	bool (*any)(const struct tsim *sim);
	/* Adds to m->next[i] how many there are on particle i. */
	void (*count)(struct ts_multicontact *m, const struct tsim *sim);
	/* Notes each on particle i in m->load[m->next[i]++]. */
	enum ts_status (*collect)(struct ts_multicontact *m, struct tsim *sim, const struct ts_place *where);
};

struct ts_multicontact {
	double prefactor;	      /* gamma */
	int group;		      /* grains that give way */
	struct ts_neigh *neigh;	      /* that knows of it */
	double *compliance, *poisson; /* of each type, from 1 */
	size_t *first, *next;	      /* the loads on particle i: first[i] .. first[i+1]-1 */
	struct ts_multicontact_load *load;
	struct ts_contact_bulge *bulge; /* of each row */
	size_t compliance_capacity, poisson_capacity, first_capacity, next_capacity, load_capacity,
		bulge_capacity;
};

/* The materials of all types; in init, and before runs. */
enum ts_status ts_multicontact_prepare(struct ts_multicontact *m, struct tsim *sim,
				       const struct ts_place *where);
/* Collects the loads, and what they do at the rows: before forces. */
enum ts_status ts_multicontact_update(struct ts_multicontact *m, struct tsim *sim,
				      const struct ts_place *where);
/* How far the surface of particle i stands out at a place where it meets a wall. */
double ts_multicontact_at_wall(const struct tsim *sim, size_t i, const double e[3], double distance,
			       const struct ts_wall *wall);
void ts_multicontact_release(struct ts_multicontact *m);

/* In plans: a model whose surfaces need the fix is refused without. */
enum ts_status ts_multicontact_check(struct tsim *sim, const struct ts_granular_model *model,
				     const struct ts_place *where);

#endif
