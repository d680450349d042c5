/* The neighbour system: contact rows with a skin, rebuilt exactly when some particle has moved half
 * the skin since the last build. The check runs after every move and before every force, so no
 * contact is ever missed, whatever the skin; the skin only decides the cost. */
#ifndef TS_NEIGH_NEIGH_H
#define TS_NEIGH_NEIGH_H

#include "neigh/contact_history.h"
#include "neigh/contact_list.h"

enum { TS_MAX_EXCLUDE = 16 };

/* Pairs that do not touch each other (neigh_modify exclude): of two types, of two groups, or of a group
 * whose molecules are the same or different. */
enum ts_exclude_by { TS_EXCLUDE_TYPES, TS_EXCLUDE_GROUPS, TS_EXCLUDE_WITHIN, TS_EXCLUDE_BETWEEN };
struct ts_exclude {
	int32_t by;   /* enum ts_exclude_by */
	int32_t a, b; /* types or group bits */
};

struct ts_fused_pass;
struct ts_multicontact;
struct ts_multicontact_walls;

/* What the search has to know of contacts, bonds and walls, whose folders stand above this one: each is
 * set by the slot `connect` of their systems, and so always there. */
struct ts_neigh_callbacks {
	/* How far beyond their touch the surfaces of particles of this radius, or smaller ones, may still
	 * pull. */
	double (*reach)(const struct tsim *sim, double radius);
	/* Whether the types of particles i and j have a contact law. */
	bool (*interact)(const struct tsim *sim, size_t i, size_t j);
	/* Whether there is a bond between the particles of these identities. */
	bool (*bonded)(const struct tsim *sim, int32_t tag_a, int32_t tag_b);
	/* Whether a wall, other than of meshes, moves. */
	bool (*walls_move)(const struct tsim *sim);
	/* Whether particle i, which has just moved by more than its radius, may have met something on its
	 * way; `what` says it: " past ...". */
	bool (*hits)(struct tsim *sim, size_t i, char *what, size_t room);
	/* Reports the limits of the time step that contacts, walls and bonds have together. */
	enum ts_status (*network)(struct ts_plan_report *report, struct tsim *sim);
};

struct ts_neigh {
	double skin;	     /* at most; <= 0: chosen from the particles, see ts_neigh_skin */
	bool fixed_skin;     /* not less either */
	double built_skin;   /* of the rows now in use */
	double given_skin;   /* at that time, see ts_neigh_skin */
	double least_radius; /* at that time, of all particles */
	int32_t include;     /* bit of the group whose members touch each other; 0: all */
	int32_t nexclude;
	struct ts_exclude exclude[TS_MAX_EXCLUDE];
	bool skip_bonded;   /* bonded particles do not touch each other (special_bonds) */
	bool stale;	    /* a bond broke under skip_bonded: its pair needs a row */
	int64_t builds;	    /* in this run */
	bool wanted;	    /* some live style acts on contacts */
	bool rows_first;    /* of all that act on forces */
	bool skin_observed; /* an output depends on the skin: it is the one given */
	bool shown;	    /* an output may look at the forces of contacts at any step: they are kept */
	int64_t show_every; /* at these steps too; 0: none */
	struct ts_contact_list contacts;
	/* how contacts of one grain act on each other; NULL: not at all */
	struct ts_multicontact *multicontact;
	/* the part of walls in it; set by their system */
	const struct ts_multicontact_walls *multicontact_walls;
	struct ts_fused_pass *fused_pass; /* of the forces of this step, see contact_pass.h; NULL: none */
	struct ts_contact_history saved;  /* from a restart file, for the next build */
	struct ts_neigh_callbacks callback;
};

/* Of the smallest and the largest particle; infinite and 0 where there are none. */
void ts_neigh_radii(const struct ts_particles *p, double *least, double *most);
/* The largest skin: as given by `neighbor`, else 0.4 of the smallest radius (at least 0.05 of the
 * largest). */
double ts_neigh_skin(const struct tsim *sim);
/* The one that suits the speeds and the step as they are now; more than that only if all faces are fixed. */
double ts_neigh_choose_skin(const struct tsim *sim);
/* For the init of outputs and of what may end a run: they look at forces of contacts at multiples of
 * `every`. */
void ts_neigh_show_every(struct ts_neigh *neigh, int64_t every);
/* Whether neigh_modify names the group of this bit. */
bool ts_neigh_uses_group(const struct ts_neigh *neigh, int bit);

/* The pairs that neigh_modify exclude and special_bonds leave out; NULL: none. */
ts_excluded_fn *ts_neigh_excluded(const struct tsim *sim);

extern const struct ts_system_style ts_neigh_system;

#endif
