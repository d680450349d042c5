/* Walls: rigid bodies of infinite mass that interact with particles by a contact law. The shape of the wall
 * (wall/wall_shape.h) gives the contact points; everything after that is common to all walls:
 *
 *   POST_BUILD  ts_wall_rebuild_start; ts_wall_contacts_add for each pair of a particle and an element of the
 *               wall (a plane, a face, a triangle) that may touch before the next rebuild;
 *               ts_wall_rebuild_finish
 *   POST_FORCE  ts_wall_start; for each listed contact k ts_wall_enqueue_contact (wall/wall_queue.h) if it
 *               touches, else ts_wall_contact_end; ts_wall_finish
 *
 * Contacts of different particles may be enqueued by several threads, each with its own queue:
 * ts_wall_contacts_parallel.
 *
 * Outputs that need the force, the point or the overlap of each contact call ts_walls_want_reports in
 * their init and read the reports by ts_walls_next and ts_wall_report (wall/wall_contacts.h) from
 * POST_FORCE on. */
#ifndef TS_WALL_WALL_H
#define TS_WALL_WALL_H

#include "contact/materials.h"
#include "contact/pair.h"
#include "heat/heat.h"
#include "wall/contact_node.h"
#include "wall/wall_batch.h"
#include "wall/wall_contacts.h"
#include "wall/wall_shape.h"

struct ts_exact_impacts;
struct ts_impacts;

/* An observed contact, with the keys that define the order of summation. */
struct ts_wall_touching {
	int32_t surface, element, tag;
	size_t k; /* in the contacts of the wall, or in `shared` */
};

/* A contact that began and ended within this step, with the nodes of a quadrature over its time. */
struct ts_wall_brief {
	size_t surface, element;
	int type;	 /* of the particle, as all that follow */
	uint32_t groups; /* bits */
	double mass, radius;
	double normal[3]; /* of the surface, unit vector, towards the particle */
	double point[3];  /* contact point at the touch, in the frame of the surface at the end of the step */
	const struct ts_contact_node *node; /* [nnodes] */
	size_t nnodes;
};

/* First member of the state of every wall with contact laws; its style is of TS_FAMILY_WALL. */
struct ts_wall {
	const struct ts_instance *by;	/* its fix; set in init */
	struct tsim *sim;		/* for outputs; set in init */
	struct ts_granular_words words; /* `model ...`; normal off: the model of the pair style */
	struct ts_wall_contacts contacts;
	/* sum of the forces of particles on the wall in the last step: ts_wall_force; while `unsummed` without those of
	 * the contacts, which are summed if something needs it */
	double force[3];
	bool unsummed;
	/* first contact of the last step whose particle has its centre in the surface, or TS_WALL_NONE */
	size_t inside;
	const struct ts_wall_shape *shape; /* set by ts_wall_find, with */
	void *geometry;			   /* its state: struct ts_primitive_wall, ts_mesh_wall ... */
	/* particle type whose material the wall has; INT64_MIN: not given, its surfaces have types of their own */
	int64_t type;
	unsigned *observers; /* [surfaces] bits of enum ts_observes; set in POST_BUILD */
	unsigned observed;   /* all of them */
	/* observed contacts, wall/surface_contacts.h: first ntouching that touch, then up to nlisted those that
	 * only conduct heat; both parts sorted */
	struct ts_wall_touching *touching;
	size_t ntouching, nlisted, touching_capacity, observers_capacity;
	/* While particles are divided among ranks: the observed contacts of all ranks, wall/shared_contacts.h */
	bool shares;
	struct ts_parcel shared;
	/* By particle and time, of observed surfaces; made in POST_INTEGRATE by `impact exact`. */
	struct ts_wall_brief *brief;
	size_t nbriefs, brief_capacity;
	struct ts_impacts *impacts; /* NULL: nobody observes impacts; impact/impacts.h */
	struct ts_words area_words;
	bool store_force, store_contacts[2];
	bool list_contacts; /* output f_ID[1..8]: the contact of each particle */
	size_t stored;	    /* with store_force: index of the particle column force_ID */

	/* `impact exact`: impact/exact_impacts.h; NULL: all contacts are resolved by time steps. Set in init */
	struct ts_exact_impacts *exact;

	bool own_model; /* the contact law is given on the line of the fix, else by the pair style */
	bool given;	/* the constants of the law are given on the line, the same for all types */
	struct ts_granular_pair numbers; /* these constants */
	struct ts_granular_model model;	 /* the law, with own_model */
	ts_wall_batch_fn *batch;	 /* the vectorised loop for the model; NULL: contact by contact */
	struct ts_granular_pair *law;	 /* constants of the own model, [type of the wall * (ntypes + 1) +
					  * type of the particle] */
	bool warm;			 /* a part of the wall has a temperature; set in init */
	bool moves;			 /* a primitive wall that moves along its normal; set in init */
	bool yields;			 /* its surface is a spring under particles; set in init */
	struct ts_heat_contact area;	 /* area for heat conduction */
	double *conductivity;		 /* 4 k k'/(k + k'), same shape as `law` */
	double *softening;		 /* factor of the overlap for conduction, same shape as `law` */
	int ntypes;
	/* distance from their surface up to which particles are listed, as others ask for near points, length; 0:
	 * those that may touch. Set, and only enlarged, in the init of these others */
	double look;
	double bridges; /* maximum rupture length of a liquid bridge, in radii of the particle */
	int32_t newest; /* largest identity of a particle when contacts were listed, or the run began */
};

#define TS_FAMILY_WALL "wall"
#define TS_WALL_NONE SIZE_MAX

/* Keywords of all walls. */
#define TS_WALL_ARGS(T, f)                                                                              \
	TS_HEAT_AREA_ARG(T, f.area_words),                                                              \
		TS_BOOL("store_force", T, f.store_force, .fallback = "no",                              \
			.help = "whether the force on each particle is stored: f_force_ID[1] ... [3]"), \
		TS_FLAG("contacts", T, f.list_contacts,                                                 \
			.help = "outputs the contact of each particle with the wall, f_ID[1] ... [8]: " \
				"touches, force, contact point, radius"),                               \
		TS_BOOL("store_force_contact", T, f.store_contacts[0], .fallback = "no",                \
			.help = "no effect: in LIGGGHTS it stores data that scripts cannot read; "      \
				"compute wall/gran/local gives the force of each contact"),             \
		TS_BOOL("store_force_contact_stress", T, f.store_contacts[1], .fallback = "no",         \
			.help = "no effect, as store_force_contact")

/* The contact point: the point of the surface that is nearest to a particle. */
struct ts_wall_contact_point {
	double n[3];	    /* unit normal, from the surface to the centre of the particle; 0: undefined */
	double distance;    /* of the centre from the surface, length, >= 0 */
	double velocity[3]; /* of the surface */
	double curvature;   /* mean curvature of the surface, 1/length, > 0: convex towards the particle */
	bool observed;	    /* contacts of the surface are observed: those of immobile particles, too */
	int type;	    /* particle type whose material the surface has */
	/* for reports: mesh from 1, triangle from 0; 0, 0: no mesh. Of a height field 1 and the column */
	int mesh, triangle;
	bool warm; /* the surface has a temperature and conducts heat */
	double temperature;
};

/* To be called in the init of the style: the wall is of this shape; resolves the words of the shape. */
enum ts_status ts_wall_find(struct ts_instance *self, struct tsim *sim, const struct ts_wall_shape *shape,
			    void *geometry);
/* In the init of the style, after ts_wall_find. */
enum ts_status ts_wall_init(struct ts_instance *self, struct tsim *sim);
/* Fails at this word of the line if the type of a surface does not exist. It is a frequent error: reported here rather
 * than by a material property with too few values. */
enum ts_status ts_wall_check_type(struct ts_instance *self, struct tsim *sim, int64_t type, const char *word);

/* Whether walls with a temperature exchange heat with particles: a fix heat/gran exists. */
bool ts_wall_heats(const struct tsim *sim);

/* Whether the contacts of particle i act on it: it belongs to the group, and it is mobile or, at a wall with a
 * temperature, exchanges heat. */
static inline bool ts_wall_interacts(const struct ts_instance *self, const struct tsim *sim, size_t i,
				     bool warm)
{
	return ts_in_group(sim->particles, i, self->group) &&
	       (sim->particles->imass[i] > 0 || (warm && ts_wall_heats(sim)));
}
/* Whether contacts of particle i with a surface are listed: they act on it, or the contacts of that surface are observed. */
static inline bool ts_wall_lists(const struct ts_instance *self, const struct tsim *sim, size_t i,
				 size_t surface, bool warm)
{
	return ts_wall_interacts(self, sim, i, warm) ||
	       (((const struct ts_wall *)self->state)->observers[surface] &&
		ts_in_group(sim->particles, i, self->group));
}

/* Number of its surfaces; the fix of one of them; where contact k is on them. */
static inline size_t ts_wall_surfaces(const struct ts_wall *w)
{
	return w->shape->surfaces(w);
}
static inline const struct ts_instance *ts_wall_surface(const struct ts_wall *w, size_t surface)
{
	return w->shape->fix(w, surface);
}
static inline void ts_wall_place(const struct ts_wall *w, size_t k, struct ts_wall_place *out)
{
	w->shape->place(w, k, out);
}
/* Particle type whose material a surface has. */
int ts_wall_surface_type(const struct ts_wall *w, size_t surface);
/* The number of the surface of this fix; SIZE_MAX: it is none of them. */
size_t ts_wall_find_surface(const struct ts_wall *w, const struct ts_instance *by);
/* Slots of shapes with one surface: 1; and of those that are the surface themselves: the fix of the wall, the number of the
 * element as in the key of the contact. */
size_t ts_wall_one_surface(const struct ts_wall *w);
const struct ts_instance *ts_wall_own_fix(const struct ts_wall *w, size_t surface);
void ts_wall_own_place(const struct ts_wall *w, size_t k, struct ts_wall_place *out);
/* Number of its meshes, 1 of a height field; 0: the wall itself is the surface. */
size_t ts_wall_meshes(const struct ts_wall *w);

/* Sets the force on the wall and stored forces to 0. */
void ts_wall_start(struct ts_wall *w, struct tsim *sim);
/* After all forces of the step; finds a centre of a particle in the surface (`inside`), which ts_coincide_wall
 * (wall/wall_coincide.h) refuses. */
void ts_wall_finish(struct ts_wall *w);
/* The force on the wall: the exact sum of those of its contacts, rounded once, and of others. Called before the
 * contacts change, too. */
const double *ts_wall_force(struct ts_wall *w);
/* Slot `join` of walls. */
enum ts_status ts_wall_join(struct ts_instance *self, struct tsim *sim);

/* Checks that the law is defined between particles of the group and all surfaces, and reports the largest stable time
 * step of the contacts. */
enum ts_status ts_wall_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);

/* Smallest distance between wall and particle over the contacts of one particle, of which contact k is the first; *type: of the
 * surface there; *next: first contact of the next particle. Returns the index of the particle. */
size_t ts_wall_deepest_contact(const struct ts_wall *w, const struct tsim *sim, size_t k, size_t *next,
			       double *distance, int *type);

/* The law, masses and radii of contact k in the last force evaluation; false: it did not touch, or the
 * particle is immobile. */
struct ts_contact_case;
bool ts_wall_case(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_contact_case *out);

/* Whether a contact law is defined; if not, no contacts are listed and ts_wall_plan fails. */
bool ts_wall_has_law(const struct ts_wall *w, const struct tsim *sim);
/* Computes the constants of the law for all surfaces; after each rebuild, before contacts are listed. */
enum ts_status ts_wall_make_laws(struct ts_instance *self, struct tsim *sim);
/* Starts a rebuild of w->contacts, see ts_wall_contacts_start. `own`: number of history values of the shape
 * for each contact, stored after those of the law. */
void ts_wall_rebuild_start(struct ts_wall *w, const struct tsim *sim, size_t own,
			   struct ts_wall_rebuild *rebuild);
/* `status`: of the listing; if it is an error, the old contacts are discarded and it is returned. */
enum ts_status ts_wall_rebuild_finish(struct ts_wall *w, struct tsim *sim, struct ts_wall_rebuild *rebuild,
				      enum ts_status status);
/* Both: `add` adds the pairs. */
enum ts_status ts_wall_relist(struct ts_instance *self, struct tsim *sim, size_t own, ts_hook_fn *add);

/* Whether the law acts beyond the touch (liquid bridges, adhesion, surfaces displaced by fix
 * multicontact/halfspace), and up to which distance of the surfaces for a particle of this radius. */
bool ts_wall_long_ranged(const struct ts_wall *w, const struct tsim *sim);
double ts_wall_reach(const struct ts_wall *w, const struct tsim *sim, double radius);
/* The contact law, and its constants between a particle type and a surface of type `wall`. */
const struct ts_granular_model *ts_wall_model(const struct ts_wall *w, const struct tsim *sim);
const struct ts_granular_pair *ts_wall_law(const struct ts_wall *w, const struct tsim *sim, int wall,
					   int particle);
/* Number of history values of the law for each contact: the first ones of ts_wall_memory. */
size_t ts_wall_history(const struct ts_wall *w, const struct tsim *sim);
/* The input of the law for the contact of a report, with the present velocities. */
struct ts_wall_view {
	const struct ts_granular_model *model;
	const struct ts_granular_pair *law;
	struct ts_touch touch;
};
void ts_wall_view(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_wall_view *view);
/* Force and torque (with that of rolling friction) that the law gives for the contact of a report with the
 * present velocities. */
void ts_wall_force_now(const struct ts_wall *w, const struct tsim *sim, size_t k, double force[3],
		       double torque[3]);

/* Iterates over the walls in script order: start with *k = 0; returns NULL at the end. *by is its fix; `by`
 * may be NULL. */
struct ts_wall *ts_walls_next(const struct tsim *sim, size_t *k, const struct ts_instance **by);
/* Connects the contacts of all walls to their particles between runs (ts_wall_contacts_connect), for outputs. */
enum ts_status ts_walls_connect(struct tsim *sim);
/* Makes walls store reports of their contacts from the next rebuild on: to be called in init. */
void ts_walls_want_reports(const struct tsim *sim);

/* For the slots archive and fini of the styles. */
enum ts_status ts_wall_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_wall_fini(struct ts_instance *self);
extern const struct ts_carrier ts_wall_carrier;

enum ts_status ts_wall_eval_force(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);
enum ts_status ts_wall_eval_contacts(struct ts_instance *self, const struct tsim *sim, struct ts_table *out);
/* For the slot gives: f_ID[1..8] is available only with the keyword `contacts`. */
bool ts_wall_gives(const struct ts_instance *self, const struct ts_value *value);
extern const char *const ts_wall_force_names[], *const ts_wall_contact_names[];
enum { TS_WALL_CONTACT_COLUMNS = 8 };
#define TS_WALL_CONTACTS_VALUE                                                                            \
	{                                                                                                 \
		"contacts", "",                                                                           \
			"1 if the particle touches the wall, the force on it, the contact point, "        \
			"its radius; 0 if it does not touch; of several contacts the last",               \
			TS_PERATOM, TS_WALL_CONTACT_COLUMNS, ts_wall_contact_names, ts_wall_eval_contacts \
	}
#define TS_WALL_FORCE_VALUE                                                                     \
	{                                                                                       \
		"force", "force", "total force on the wall", TS_VECTOR, 3, ts_wall_force_names, \
			ts_wall_eval_force                                                      \
	}

/* Of the arguments above in the manual pages. */
#define TS_WALL_GROUP                                                                                      \
	{ "Contact area (heat)", "contact_area" },                                                         \
	{                                                                                                  \
		"Forces for output", "store_force contacts store_force_contact store_force_contact_stress" \
	}

#endif
