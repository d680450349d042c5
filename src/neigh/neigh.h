/* The neighbour list: contacts (candidate pairs) with a skin, rebuilt exactly when some particle has moved
 * half the skin since the last build. This is checked after every move and before every force, so no contact
 * is missed whatever the skin; the skin affects only the cost. */
#ifndef TS_NEIGH_NEIGH_H
#define TS_NEIGH_NEIGH_H

#include "neigh/contact_history.h"
#include "neigh/contact_list.h"
#include "neigh/drift_frame.h"

enum { TS_MAX_EXCLUDE = 16 };

/* Pairs without contact forces (neigh_modify exclude): of two types, of two groups, or of members of one
 * group with the same or with different molecules. */
enum ts_exclude_by { TS_EXCLUDE_TYPES, TS_EXCLUDE_GROUPS, TS_EXCLUDE_WITHIN, TS_EXCLUDE_BETWEEN };
struct ts_exclude {
	int32_t by;   /* enum ts_exclude_by */
	int32_t a, b; /* particle types or group bits */
};

struct ts_fused_pass;
struct ts_multicontact;
struct ts_multicontact_walls;

/* What the search needs from contacts, bonds and walls, whose folders are above this one. The slot `connect`
 * of their systems sets each function, so none is NULL. */
struct ts_neigh_callbacks {
	/* Largest gap, length, at which the surfaces of particles of this radius or smaller still attract
	 * each other. */
	double (*reach)(const struct tsim *sim, double radius);
	/* Whether there is a contact law for the types of particles i and j. */
	bool (*interact)(const struct tsim *sim, size_t i, size_t j);
	/* Whether a bond joins the particles of these identities. */
	bool (*bonded)(const struct tsim *sim, int32_t tag_a, int32_t tag_b);
	/* Whether a wall other than a mesh moves. */
	bool (*walls_move)(const struct tsim *sim);
	/* Of the particles that have just moved by more than their radius (neigh/runaways.h) that of the least identity that
	 * may have met something on its path: *hit is its index, on the rank that has it; else SIZE_MAX. `what`, of `room`
	 * bytes, describes it for a message: " past ...". All ranks call it. */
	enum ts_status (*find_hit)(struct tsim *sim, size_t *hit, char *what, size_t room);
};

struct ts_neigh {
	double skin;	   /* largest skin, length; <= 0: chosen from the radii, see ts_neigh_skin */
	bool fixed_skin;   /* `neighbor ... fixed yes`: the skin is never less either */
	double built_skin; /* skin of the present list, length */
	double copy_reach; /* distance from a block up to which its rank has copies of particles, length */
	double given_skin; /* ts_neigh_skin when the list was built, length */
	struct ts_drift_frame frame; /* displacements are measured relative to it */
	double mean_velocity[3];     /* ts_drift_frame_speeds.centre when the list was built */
	double least_radius;	     /* smallest radius then, length */
	bool leaving_watched;	     /* see leaving.h */
	int32_t include;	     /* bit of the only group with contacts (neigh_modify include); 0: all */
	int32_t nexclude;
	struct ts_exclude exclude[TS_MAX_EXCLUDE];
	bool skip_bonded; /* no contacts between bonded particles (special_bonds) */
	bool stale;	  /* a bond broke under skip_bonded: a rebuild must list its pair */
	/* largest gap, length, up to which fixes act between particles: ghosts reach as far. Set in their init,
	 * to the largest of all */
	double fix_reach;
	/* largest distance of centres, length, up to which styles look for particles in steps in which these are divided among
	 * ranks: copies reach as far. Set in their init, to the largest of all */
	double centre_reach;
	int64_t builds;		   /* number of builds in this run */
	bool wanted;		   /* some live style needs contacts */
	bool contacts_first;	   /* contact forces are the first to be added in a step */
	bool skin_observed;	   /* the skin is visible to an output: exactly the given one is used */
	bool keep_forces;	   /* an output may read forces of contacts at any step: they are kept */
	int64_t keep_forces_every; /* they are kept at multiples of this step, too; 0: not */
	struct ts_contact_list contacts;
	/* displacement of surfaces by other contacts (fix multicontact/halfspace); NULL: none */
	struct ts_multicontact *multicontact;
	/* what walls contribute to it; set by the system of walls */
	const struct ts_multicontact_walls *multicontact_walls;
	/* fused with the forces of this step, see contact_pass.h; NULL: none */
	struct ts_fused_pass *fused_pass;
	struct ts_contact_history saved; /* history read from a restart file, for the next build */
	struct ts_neigh_callbacks callback;
};

/* Smallest and largest radius, length; infinite and 0 without particles. */
void ts_neigh_radii(const struct tsim *sim, double *least, double *most);
/* The largest skin, length: as given by `neighbor`, else 0.4 of the smallest radius (at least 0.05 of the
 * largest). */
double ts_neigh_skin(const struct tsim *sim);
/* Sets the skin, and the frame at its start, for the present speeds and time step; given_skin and least_radius are known.
 * The skin is larger than ts_neigh_skin, and the frame moves, only if all faces of the box are fixed. */
void ts_neigh_choose_skin(struct tsim *sim, double largest_radius);
/* For the init of outputs and of fixes that may end a run: they read forces of contacts at multiples of
 * `every`. */
void ts_neigh_keep_forces_every(struct ts_neigh *neigh, int64_t every);
/* Whether neigh_modify uses the group of this bit. */
bool ts_neigh_uses_group(const struct ts_neigh *neigh, int bit);

/* Tells the pairs excluded by neigh_modify, special_bonds and rigid bodies; NULL: none. */
ts_excluded_fn *ts_neigh_excluded(const struct tsim *sim);

extern const struct ts_system_style ts_neigh_system;

#endif
