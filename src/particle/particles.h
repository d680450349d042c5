/* The particles: a structure of arrays whose columns are allocated only if a live style needs them.
 *
 * Indices 0..n-1 are local particles, n..n+nghost-1 ghosts: their images across periodic faces. A ghost has
 * the tag (atom ID) of its original. With several ranks the particles of others that are near this one are ghosts,
 * too. */
#ifndef TS_PARTICLE_PARTICLES_H
#define TS_PARTICLE_PARTICLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/group.h"
#include "core/sim.h"
#include "material/material.h"

/* Built-in columns. C(id, name, C type, width, flags) */
/* clang-format off */
#define TS_COLUMN_LIST(C)                                                                          \
	C(TAG, tag, int32_t, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                      \
	C(TYPE, type, int32_t, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                    \
	C(MASK, mask, uint32_t, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                   \
	C(IMAGE, image, int32_t, 3, TS_COL_ALWAYS | TS_COL_SAVED)                                  \
	C(X, x, double, 3, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER | TS_COL_FORWARD)          \
	C(V, v, double, 3, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER | TS_COL_FORWARD)          \
	C(F, f, double, 3, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_RESULT)                           \
	C(RADIUS, radius, double, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                 \
	C(MASS, mass, double, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                     \
	C(IMASS, imass, double, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                   \
	C(XHOLD, xhold, double, 3, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER | TS_COL_RESULT)   \
	C(XSEEN, xseen, double, 3, TS_COL_SAVED | TS_COL_RESULT)                                   \
	C(OMEGA, omega, double, 3, TS_COL_SAVED | TS_COL_BORDER | TS_COL_FORWARD)                  \
	C(TORQUE, torque, double, 3, TS_COL_SAVED | TS_COL_RESULT)                                 \
	C(BODY, body, int32_t, 1, TS_COL_SAVED | TS_COL_BORDER)                                    \
	C(BODY_X, body_x, double, 3, TS_COL_SAVED)
/* clang-format on */

enum ts_column_flags {
	TS_COL_ALWAYS = 1,
	TS_COL_SAVED = 2,   /* written to restart files */
	TS_COL_BORDER = 4,  /* copied to ghosts when they are created */
	TS_COL_FORWARD = 8, /* copied to ghosts in every step */
	TS_COL_RESULT = 16, /* forces do not depend on it: not part of the fingerprint */
	TS_COL_NAMED = 32,  /* added by a style; scripts read it as NAME or NAME[k] */
	TS_COL_COPIED = 64  /* copied in every step to copies on other ranks, not to images */
};

#define TS_COLUMN_ENUM(id, name, type, width, flags) TS_COL_##id,
enum ts_column_id { TS_COLUMN_LIST(TS_COLUMN_ENUM) TS_NCOLUMN_BUILTIN };
#undef TS_COLUMN_ENUM
#define TS_NEED(id) (1u << TS_COL_##id) /* for ts_style.columns */

struct ts_column {
	const char *name;
	enum ts_saved_type type;
	size_t element, width; /* bytes per number, numbers per particle */
	unsigned flags;
	bool active;
	void *data;	 /* [capacity][width], cache-line aligned; NULL if not active */
	void **bound;	 /* the member of struct ts_particles that is kept equal to data, or NULL */
	double *initial; /* [width], values of new particles; NULL: 0 */
	uint64_t owner;	 /* serial number of the instance that has added it; 0: not known, or several */
};

/* A dynamic group, whose members are reassigned during a run: group/group_dynamic.h. The names belong to
 * the string pool. Region and variable are looked up at each use, since the script may redefine them. */
struct ts_dynamic_group {
	int64_t every;		       /* steps between assignments; 0: the group is static */
	int parent;		       /* bit of the parent group */
	const char *region, *variable; /* or NULL */
};

/* Moment of inertia of a particle: particle/sphere_shape.h. */
enum ts_inertia { TS_INERTIA_BY_DIMENSION, TS_INERTIA_SPHERE, TS_INERTIA_DISC };

/* A wall that an inserted particle has met on its way. */
struct ts_missed_wall {
	const char *id;	   /* of its fix; NULL: none */
	size_t i;	   /* the particle */
	double flown, met; /* time of the whole way; until it touched the wall */
};

struct ts_particles {
	size_t n, nghost, capacity; /* capacity: allocated rows, for local particles and ghosts together */

	/* the built-in columns, in the units of the script; NULL if not active */
	int32_t *tag;	     /* atom ID, 1..max_tag, never reused */
	int32_t *type;	     /* 1..ntypes */
	uint32_t *mask;	     /* bit g: member of group g */
	int32_t (*image)[3]; /* periodic image flags */
	double (*x)[3];	     /* position, wrapped into the box at the last exchange */
	double (*v)[3], (*f)[3];
	double *radius, *mass;
	/* effective 1/mass in contacts: 0 if frozen or prescribed, 1/(mass of the body) for members of
	 * rigid bodies */
	double *imass;
	double (*xhold)[3]; /* positions at the last build of the contact list */
	double (*xseen)[3]; /* positions at the last search for lost particles: neigh/leaving.h */
	double (*omega)[3], (*torque)[3];
	int32_t *body;	     /* id of its rigid body, or 0: rigid/rigid.h */
	double (*body_x)[3]; /* position in the principal-axes frame of its body */
	/* volume of liquid on its surface divided by its own volume: contact/liquid.h; NULL: no liquid */
	double *liquid;

	struct ts_column *column; /* [ncolumns]: the built-in columns, then those added by styles */
	size_t ncolumns, column_capacity;

	const char *atom_style; /* arguments of atom_style: the columns of data files; NULL: sphere */
	int ntypes;
	int32_t max_tag; /* largest tag ever assigned */
	/* particles with tags up to this have been in a run: their overlaps result from contact forces */
	int32_t max_run_tag;
	enum ts_inertia inertia;			/* set by the integrator */
	struct ts_materials materials;			/* by type, from material files; sim->materials */
	double *type_mass;				/* [ntypes + 1], by `mass`; 0: not given */
	struct ts_dynamic_group dynamic[TS_MAX_GROUPS]; /* by bit of the group */

	/* [nghost], ghosts: first copies of particles of other ranks (particle/copies.h), then images */
	int32_t *ghost_owner;	  /* index of the original, which may be a copy; a copy is its own original */
	int8_t (*ghost_shift)[3]; /* image offset in box lengths: x = x of the original + shift * length */
	size_t ghost_capacity;

	int64_t lost;	  /* number of particles lost through fixed faces since the beginning */
	int lost_policy;  /* enum ts_lost */
	bool lost_warned; /* the warning is printed once */

	struct ts_division
		*division; /* with several ranks; sim->division points to it while they are divided */

	struct ts_shared_buffers *holds; /* of the simulation: columns that callers of the library read */
	/* lookup of indices by tag: particle/identity.h */
	int32_t *row_of_tag;  /* [max_tag + 1]: local index of a tag, or -1 */
	int32_t *sorted_tags; /* [2][n]: the tags in ascending order, then their local indices */
	size_t row_of_tag_capacity, sorted_tags_capacity;

	/* Functions of folders above this one, set when their systems are initialised. */

	/* Describes the contacts of particle i in a message; set by the neighbour search. */
	void (*describe_contacts)(struct tsim *sim, size_t i, struct ts_str *out);
	/* Explains in a message the probable cause that particle i left through face 2 * dim + side; set by
	 * the walls. */
	void (*explain_loss)(struct tsim *sim, size_t i, int face, struct ts_str *out);
	/* Finds a wall that one of the particles from .. from + n - 1 has met before it was inserted where it is,
	 * having flown freely for the time flown[k]; set by the walls. */
	enum ts_status (*find_missed_wall)(struct tsim *sim, size_t from, size_t n, const double *flown,
					   struct ts_missed_wall *out);
	/* Assigns the members of all dynamic groups, or of those that are due in this step; set by the
	 * groups. */
	enum ts_status (*choose_members)(struct tsim *sim, bool all);
	/* Fails if a particle is integrated by more than one fix; set by the integrators. */
	enum ts_status (*check_movers)(struct tsim *sim);
	/* Material density of particle i: mass / volume, or the density of its clump; set by the rigid
	 * bodies. */
	double (*material_density)(const struct tsim *sim, size_t i);
	/* To be called after the command `who` has moved particles or changed the box: rigid bodies follow their members; whether
	 * the command may move members of a body apart; set by the rigid bodies. */
	enum ts_status (*bodies_follow)(struct tsim *sim, bool reshapes, const char *who,
					const struct ts_place *where);
	/* To be called before the box gets the faces lo, hi in a step: see rigid/rigid_box.h; set by the rigid bodies. */
	enum ts_status (*bodies_change_box)(struct tsim *sim, const double lo[3], const double hi[3],
					    bool map, int group);
};

enum ts_lost { TS_LOST_IGNORE, TS_LOST_WARN, TS_LOST_ERROR };

/* Fails if a range of types goes beyond the last one. `who`: whose argument it is, for the message. */
enum ts_status ts_particles_require_types(struct tsim *sim, const char *who, const struct ts_types *types,
					  const struct ts_place *where);

/* Creates the box from lo to hi for particles of types 1..ntypes. `where`: place in the script for messages,
 * or NULL. */
enum ts_status ts_particles_make_box(struct tsim *sim, int ntypes, const double lo[3], const double hi[3],
				     const struct ts_place *where);

/* Whether particle i is in the group with this bit. */
static inline bool ts_in_group(const struct ts_particles *p, size_t i, int group)
{
	return (p->mask[i] >> group) & 1u;
}

extern const struct ts_system_style ts_particles_system;

#endif
