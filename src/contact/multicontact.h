/* Displacement of the surface of a particle at a contact by its other contacts: `surface multicontact` of
 * pair_style gran and fix wall/gran, with fix multicontact/halfspace. The loads are the forces of the last
 * step from the contact history; equations: law/halfspace.h. */
#ifndef TS_CONTACT_MULTICONTACT_H
#define TS_CONTACT_MULTICONTACT_H

#include "contact/pair.h"
#include "law/halfspace.h"
#include "particle/copies.h"

struct ts_wall;

struct ts_multicontact_load {
	struct ts_halfspace_load load;
	/* the wall in contact; NULL: a contact of two particles. Of a load from another rank: whether it is NULL counts */
	const struct ts_wall *wall;
	size_t contact; /* number of the contact of this wall */
};

struct ts_multicontact;

/* Loads of walls on particles: sim->neigh->multicontact_walls. */
struct ts_multicontact_walls {
	/* Whether the contacts of some wall have `surface multicontact`. */
	bool (*any)(const struct tsim *sim);
	/* Adds the number of loads on particle i to m->next[i]. */
	void (*count)(struct ts_multicontact *m, const struct tsim *sim);
	/* Writes each load on particle i to m->load[m->next[i]++]. */
	enum ts_status (*collect)(struct ts_multicontact *m, struct tsim *sim, const struct ts_place *where);
};

struct ts_multicontact {
	double prefactor;	      /* geometric prefactor gamma */
	int group;		      /* group of the particles whose surfaces are displaced */
	struct ts_neigh *neigh;	      /* the neighbour list that refers to this */
	double *compliance, *poisson; /* by type, from 1: compliance (law/halfspace.h), Poisson's ratio */
	/* loads on particle i, own or copy: load[first[i]] .. load[first[i+1]-1] */
	size_t *first, *next;
	struct ts_copied_rows copied; /* loads on copies, from other ranks */
	struct ts_multicontact_load *load;
	struct ts_contact_bulge *bulge; /* by candidate pair */
	size_t compliance_capacity, poisson_capacity, first_capacity, next_capacity, load_capacity,
		bulge_capacity;
};

/* Reads the material constants of all types; in init and before runs. */
enum ts_status ts_multicontact_prepare(struct ts_multicontact *m, struct tsim *sim,
				       const struct ts_place *where);
/* Collects the loads and computes the displacements at all candidate pairs; before forces. */
enum ts_status ts_multicontact_update(struct ts_multicontact *m, struct tsim *sim,
				      const struct ts_place *where);
/* Displacement of the surface of particle i, length, at a contact with a wall in direction e. */
double ts_multicontact_at_wall(const struct tsim *sim, size_t i, const double e[3], double distance,
			       const struct ts_wall *wall, size_t contact);
/* Bytes of the loads of an average particle, of its contacts with other particles. */
double ts_multicontact_bytes(const struct tsim *sim);
void ts_multicontact_release(struct ts_multicontact *m);

/* Fails if the model has `surface multicontact` but the fix is missing; called in plans. */
enum ts_status ts_multicontact_check(struct tsim *sim, const struct ts_granular_model *model,
				     const struct ts_place *where);

#endif
