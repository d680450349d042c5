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
/* Adds n particles with consecutive new tags at the end of the locals (ghosts are dropped); they are
 * in group all, v = 0, radius 0.5, mass from density 1; the caller fills in the rest. */
enum ts_status ts_particles_add(struct tsim *sim, size_t n, size_t *first);
/* Deletes the local particles whose flag is set; order of the others is kept. Ghosts are dropped. */
enum ts_status ts_particles_delete(struct tsim *sim, const unsigned char *flag);
/* Reorders locals: new row k is old row order[k]. */
enum ts_status ts_particles_reorder(struct tsim *sim, const int32_t *order);

/* Makes the columns exist (zero-filled); bits of enum ts_column_id. */
enum ts_status ts_particles_need(struct tsim *sim, unsigned columns);
/* Adds or finds a column of doubles for a style, e.g. "f_heat"; *index into particles->column. */
enum ts_status ts_particles_add_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
				       size_t *index);
/* Initial values of the column for particles that are created from now on, `width` numbers. */
enum ts_status ts_particles_column_initial(struct tsim *sim, size_t index, const double *initial);
/* Writes the initial values to rows from .. to-1. */
void ts_particles_fill_initial(struct ts_column *column, size_t from, size_t to);

/* For a style's archive function: the column it has added, by identity, since the style may be defined
 * again only after particles have come and gone. Such columns are not TS_COL_SAVED. */
enum ts_status ts_particles_archive_column(struct ts_archive *archive, struct tsim *sim, const char *name,
					   size_t index);

/* Moves all mobile particles together as in a bed, to estimate its cost: crowd.c. */
enum ts_status ts_particles_crowd(struct ts_instance *self, struct tsim *sim);
/* Room for so many rows, ghosts included. */
enum ts_status ts_particles_reserve(struct tsim *sim, size_t rows);
/* imass = 1/mass; the fix that freezes particles sets theirs to 0 afterwards. */
void ts_particles_inverse_mass(struct ts_particles *p);

/* Per-particle quantity by its script name (x, vy, fz, radius, mass, id, type, diameter, density ...):
 * one value for each local particle. */
enum ts_status ts_particles_quantity(struct tsim *sim, const char *name, struct ts_table *out);
bool ts_particles_has_quantity(const struct tsim *sim, const char *name);
bool ts_particles_keeps_quantity(const struct tsim *sim, const char *name);
void ts_particles_suggest_quantity(struct ts_suggest *suggest);

/* A column that a style keeps under the name, NAME or NAME[k]; *k counted from 0. NULL: none. */
const struct ts_column *ts_particles_named_column(const struct ts_particles *p, const char *name, size_t *k);

/* The molecules of particles, as `fix property/atom mol` keeps them; NULL: there are none. */
const double *ts_particles_molecules(const struct ts_particles *p);
/* An error where they are needed; `what` for the message: "group". */
enum ts_status ts_particles_need_molecules(struct tsim *sim, const char *what, const struct ts_place *where);

/* The same, written: the k-th value goes to row[k], or to row k where row is NULL. All values are
 * checked before the first is written. A radius keeps the density, a density the radius, a mass
 * the radius. */
enum ts_assign { TS_ASSIGN_NOT, TS_ASSIGN_MOTION, TS_ASSIGN_FORCE, TS_ASSIGN_PROPERTY };
enum ts_assign ts_particles_assignable(const struct tsim *sim, const char *name);
enum ts_status ts_particles_assign(struct tsim *sim, const char *name, const int32_t *row,
				   const double *value, size_t n);
const struct ts_quantity *ts_particles_quantity_text(size_t k);
/* Name of the k-th quantity that can be read; NULL: there are no more. */
const char *ts_particles_quantity_name(size_t k);

static inline bool ts_in_group(const struct ts_particles *p, size_t i, int group)
{
	return (p->mask[i] >> group) & 1u;
}

extern const struct ts_system_style ts_particles_system;

#endif
