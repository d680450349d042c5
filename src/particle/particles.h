/* The particles: a structure of arrays whose columns exist only if a live style needs them.
 *
 * Rows 0..n-1 are local particles, n..n+nghost-1 ghosts: images across periodic faces (and, later,
 * neighbours' particles). Ghosts carry the identity (tag) of their original. */
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
	C(IMASS, imass, double, 1, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER)                               \
	C(XHOLD, xhold, double, 3, TS_COL_ALWAYS | TS_COL_SAVED | TS_COL_BORDER | TS_COL_RESULT)   \
	C(XSEEN, xseen, double, 3, TS_COL_SAVED | TS_COL_RESULT)                                   \
	C(OMEGA, omega, double, 3, TS_COL_SAVED | TS_COL_BORDER | TS_COL_FORWARD)                  \
	C(TORQUE, torque, double, 3, TS_COL_SAVED | TS_COL_RESULT)                                 \
	C(BODY, body, int32_t, 1, TS_COL_SAVED | TS_COL_BORDER)                                    \
	C(BODY_X, body_x, double, 3, TS_COL_SAVED)
/* clang-format on */

enum ts_column_flags {
	TS_COL_ALWAYS = 1,
	TS_COL_SAVED = 2,   /* goes to restart files */
	TS_COL_BORDER = 4,  /* copied to ghosts when they are made */
	TS_COL_FORWARD = 8, /* refreshed in ghosts every step */
	TS_COL_RESULT = 16, /* forces do not depend on it: not in the fingerprint */
	TS_COL_NAMED = 32   /* of a style: scripts may read it by its name, NAME or NAME[k] */
};

#define TS_COLUMN_ENUM(id, name, type, width, flags) TS_COL_##id,
enum ts_column_id { TS_COLUMN_LIST(TS_COLUMN_ENUM) TS_NCOLUMN_BUILTIN };
#undef TS_COLUMN_ENUM
#define TS_NEED(id) (1u << TS_COL_##id) /* for ts_style.columns */

struct ts_column {
	const char *name;
	enum ts_saved_type type;
	size_t element, width; /* bytes of one number, numbers per particle */
	unsigned flags;
	bool active;
	void *data;	 /* capacity * width elements, cache-line aligned; NULL if not active */
	void **bound;	 /* the named pointer below that mirrors data, or NULL */
	double *initial; /* of new particles, `width` numbers; NULL: 0 */
};

/* A group whose members are chosen anew while a run goes on: group/group_dynamic.h. The names belong to
 * the string pool; region and variable are looked up when they are needed, so they may be defined again. */
struct ts_dynamic_group {
	int64_t every; /* 0: not dynamic */
	int parent;
	const char *region, *variable; /* or NULL */
};

/* Of rotation; see particle/sphere_shape.h. */
enum ts_inertia { TS_INERTIA_BY_DIMENSION, TS_INERTIA_SPHERE, TS_INERTIA_DISC };

struct ts_particles {
	size_t n, nghost, capacity;

	/* the built-in columns; NULL when not active. Vectors are interleaved: x[i][0..2]. */
	int32_t *tag;	     /* identity, 1..max_tag, never reused */
	int32_t *type;	     /* 1..ntypes */
	uint32_t *mask;	     /* bit g: member of group g */
	int32_t (*image)[3]; /* how often it crossed periodic faces */
	double (*x)[3], (*v)[3], (*f)[3];
	double *radius, *mass;
	double *imass;	    /* 1/mass; 0 for frozen and prescribed particles: infinite mass */
	double (*xhold)[3]; /* positions at the last build of the contact list */
	double (*xseen)[3]; /* positions at the last search for particles that have left: neigh/leaving.h */
	double (*omega)[3], (*torque)[3];
	int32_t *body;	     /* id of the rigid body it belongs to, or 0; see rigid/rigid.h */
	double (*body_x)[3]; /* its position in the body, along the principal axes */
	/* volume of liquid on its surface by its own volume: contact/liquid.h; NULL: no liquid */
	double *liquid;

	struct ts_column *column; /* built-in ones first, then those styles add */
	size_t ncolumns, column_capacity;

	const char *atom_style; /* words of the command: columns of data files; NULL: sphere */
	int ntypes;
	int32_t max_tag;
	/* particles up to this identity have been in a run: their overlaps are those of forces */
	int32_t settled;
	enum ts_inertia inertia;			/* as its integrator says */
	struct ts_materials materials;			/* of the types, from files; sim->materials */
	double *type_mass;				/* `mass` command, by type; 0: not given */
	struct ts_dynamic_group dynamic[TS_MAX_GROUPS]; /* by bit */

	/* ghosts: where they come from */
	int32_t *ghost_owner;	  /* local index of the original */
	int8_t (*ghost_shift)[3]; /* in box lengths */
	size_t ghost_capacity;

	int64_t lost;	 /* particles that left through fixed faces, ever */
	int lost_policy; /* enum ts_lost */
	bool lost_warned;

	struct ts_shared_buffers *holds; /* of the simulation: columns that callers of the library read */
	int32_t *map; /* row of tag, and the tags there are with their rows: particle/identity.h */
	size_t map_capacity;
	int32_t *by_tag;
	size_t by_tag_capacity;
	/* Lists the contacts of particle i for a message; set by the search for neighbours. */
	void (*describe_contacts)(struct tsim *sim, size_t i, struct ts_str *out);
	/* Explains in a message why particle i may have left through face 2 * dim + side; set by the
	 * walls. */
	void (*explain_loss)(struct tsim *sim, size_t i, int face, struct ts_str *out);
	/* Chooses the members of all dynamic groups, or of those whose turn it is in this step; set by the
	 * groups. */
	enum ts_status (*choose_members)(struct tsim *sim, bool all);
	/* Refuses particles that two fixes would move; set by the integrators. */
	enum ts_status (*check_movers)(struct tsim *sim);
	/* Density of what particle i is made of, in a clump that of its material; set by the rigid bodies. */
	double (*material_density)(const struct tsim *sim, size_t i);
};

enum ts_lost { TS_LOST_IGNORE, TS_LOST_WARN, TS_LOST_ERROR };

/* Makes the box, from lo to hi, with room for so many types of particles; `where` may be NULL. */
enum ts_status ts_particles_make_box(struct tsim *sim, int ntypes, const double lo[3], const double hi[3],
				     const struct ts_place *where);
static inline bool ts_in_group(const struct ts_particles *p, size_t i, int group)
{
	return (p->mask[i] >> group) & 1u;
}

extern const struct ts_system_style ts_particles_system;

#endif
