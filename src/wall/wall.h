/* Walls: rigid bodies, infinitely heavy, that particles touch with a contact law. The shape belongs to
 * the style; from "the particle touches here" on, all walls are the same:
 *
 *   POST_BUILD  ts_wall_rebuild_start, ts_wall_contacts_add for each particle and element (a plane,
 *               a triangle) that may touch before the next rebuild, ts_wall_rebuild_finish
 *   POST_FORCE  ts_wall_start, then for each contact k where it touches ts_wall_enqueue_contact (wall/wall_queue.h), where
 *               not ts_wall_contact_part; ts_wall_finish
 *
 * Contacts of different particles may be pushed side by side, in queues of their own: ts_wall_contacts_parallel.
 *
 * Who wants to know each contact - its force, place, overlap - asks for reports:
 * ts_walls_want_reports in its init, then reads them by ts_walls_next and ts_wall_report
 * (wall/wall_contacts.h) from POST_FORCE on. */
#ifndef TS_WALL_WALL_H
#define TS_WALL_WALL_H

#include "contact/materials.h"
#include "contact/pair.h"
#include "heat/heat.h"
#include "wall/wall_batch.h"
#include "wall/wall_contacts.h"

struct ts_primitive_wall;
struct ts_mesh_wall;

/* First member of the state of every wall with contact laws; its style is of TS_FAMILY_WALL. */
struct ts_wall {
	struct ts_granular_words words; /* `model ...`; off: the model of the pair style */
	struct ts_wall_contacts contacts;
	double force[3]; /* on the wall, in the last step */
	size_t inside; /* the first contact in the last step whose particle has its centre in the surface; TS_WALL_NONE */
	const struct ts_primitive_wall *primitive; /* what it is made of, or NULL; set in init */
	int meshes;	 /* how many it is made of; 0: it is a plane or the like. Set in init */
	const struct ts_mesh_wall *mesh; /* these, or NULL; set in init */
	const struct ts_instance *region; /* whose surface it is, or NULL; set in init */
	/* How far the particle of contact k is from the surface now, and the surface's type; set in init. NULL: not told */
	double (*distance)(const struct ts_instance *self, const struct tsim *sim, size_t k, int *type);
	struct ts_words area_words;
	bool store_force, store_contacts[2];
	bool list_contacts; /* of each particle, as an output */
	size_t stored; /* column of the force on each particle, with store_force */

	bool own_model;
	bool given;	 /* its constants are the same for all types */
	struct ts_granular_pair numbers; /* these */
	struct ts_granular_model model; /* the own one */
	ts_wall_batch_fn *batch; /* the loop compiled for the model, or NULL */
	struct ts_granular_pair *law;	/* of the own model: type of the wall * (ntypes + 1) + type
					 * of the particle */
	bool warm;  /* some of it has a temperature; set in init */
	bool moves; /* towards the particles or away, and is no mesh; set in init */
	struct ts_heat_contact area;
	double *conductivity; /* 4 k k'/(k + k'), in the same order */
	int ntypes;
	double bridges; /* how far bridges of liquid reach at most, by the radius */
};

#define TS_FAMILY_WALL "wall"
#define TS_WALL_NONE SIZE_MAX

/* Words that all walls take. */
#define TS_WALL_ARGS(T, f)                                                                         \
	TS_HEAT_AREA_ARG(T, f.area_words),                                                         \
		TS_BOOL("store_force", T, f.store_force, .fallback = "no",                         \
			.help = "the force on each particle, f_force_ID[1] ... [3]"),              \
		TS_FLAG("contacts", T, f.list_contacts,                                            \
			.help = "the contact of each particle with the wall, f_ID[1] ... [8]: "    \
				"touches, force, point, radius"),                                  \
		TS_BOOL("store_force_contact", T, f.store_contacts[0], .fallback = "no",           \
			.help = "no effect: LIGGGHTS keeps with it what its scripts cannot read; " \
				"compute wall/gran/local gives the force at each contact"),        \
		TS_BOOL("store_force_contact_stress", T, f.store_contacts[1], .fallback = "no",    \
			.help = "no effect, as store_force_contact")

/* Where the surface is nearest to a particle. */
struct ts_wall_contact_point {
	double n[3];	    /* unit vector from the surface to the particle's centre; 0 where there is none */
	double distance;    /* of the centre, >= 0 */
	double velocity[3]; /* of the surface there */
	double curvature;   /* 1/radius of the surface, > 0: bulging towards the particle */
	bool sums;	    /* the wall sums what it feels: held particles push it as well */
	int type;	    /* particle type whose material the surface has */
	int mesh, triangle; /* from 1 and from 0, for reports; 0, 0: no mesh */
	bool warm;	    /* it has a temperature and conducts heat */
	double temperature;
};

/* In the style's init. */
enum ts_status ts_wall_init(struct ts_instance *self, struct tsim *sim);

/* Whether particle i may have contacts: one of the group that can move or, at a wall that is warm, take up
 * heat. */
static inline bool ts_wall_meets(const struct ts_instance *self, const struct tsim *sim, size_t i,
				 bool warm)
{
	return ts_in_group(sim->particles, i, self->group) &&
	       (sim->particles->imass[i] > 0 || (warm && ts_heat_of(sim)));
}

/* Forces and what is stored of them are 0. */
void ts_wall_start(struct ts_wall *w, struct tsim *sim);
/* Adds up the force on the wall, in the order of contacts; notes whether a centre lies in its surface, which
 * ts_coincide_wall (wall/wall_coincide.h) refuses. */
void ts_wall_finish(struct ts_wall *w);

/* Checks that the law exists for particles of the group and a wall of this type, and reports the
 * largest step that contacts allow. */
enum ts_status ts_wall_plan(struct ts_instance *self, struct tsim *sim, int type,
			    struct ts_plan_report *report);

/* The law and the partners of contact k as they were in the last force computation; false: they did not
 * touch, or the particle cannot move. */
struct ts_contact_case;
bool ts_wall_case(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_contact_case *out);

/* Whether there is a contact law at all; if not, nothing is near and the plan refuses the run. */
bool ts_wall_has_law(const struct ts_wall *w, const struct tsim *sim);
/* The law for particles that meet a surface of this type; before pushes, after each rebuild. */
enum ts_status ts_wall_make_law(struct ts_instance *self, struct tsim *sim, int type);
/* Starts a rebuild of w->contacts, see ts_wall_contacts_start. `own`: how many numbers a contact
 * remembers, after those of its law, for the style. */
void ts_wall_rebuild_start(struct ts_wall *w, const struct tsim *sim, size_t own,
			   struct ts_wall_rebuild *rebuild);
/* `status` of listing: if it is an error the old contacts are dropped and it is returned. */
enum ts_status ts_wall_rebuild_finish(struct ts_wall *w, struct tsim *sim,
				      struct ts_wall_rebuild *rebuild, enum ts_status status);

/* Whether surfaces act beyond the touch, or others may stand out; how far beyond that of a particle of this radius at most. */
bool ts_wall_pulls(const struct ts_wall *w, const struct tsim *sim);
double ts_wall_reach(const struct ts_wall *w, const struct tsim *sim, double radius);
/* Its laws; those of a particle of a type that meets a surface of the type `wall`. */
const struct ts_granular_model *ts_wall_model(const struct ts_wall *w, const struct tsim *sim);
const struct ts_granular_pair *ts_wall_law(const struct ts_wall *w, const struct tsim *sim, int wall,
					   int particle);
/* How many numbers its laws remember of a contact: the first ones of ts_wall_memory. */
size_t ts_wall_history(const struct ts_wall *w, const struct tsim *sim);
/* The contact of a report as its laws see it, at the velocities as they are now. */
struct ts_wall_view {
	const struct ts_granular_model *model;
	const struct ts_granular_pair *law;
	struct ts_touch touch;
};
void ts_wall_view(const struct ts_wall *w, const struct tsim *sim, size_t k, struct ts_wall_view *view);
/* Force and torque (without that of rolling) that the contact of a report would have with the velocities as they
 * are now. */
void ts_wall_force_now(const struct ts_wall *w, const struct tsim *sim, size_t k, double force[3],
		       double torque[3]);

/* The k-th wall in script order, start with *k = 0; NULL: no more. `by` may be NULL. */
struct ts_wall *ts_walls_next(const struct tsim *sim, size_t *k, const struct ts_instance **by);
/* Walls keep reports of their contacts from the next rebuild on: to be called in init. */
void ts_walls_want_reports(const struct tsim *sim);

/* For the slots of the styles. */
enum ts_status ts_wall_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_wall_fini(struct ts_instance *self);

enum ts_status ts_wall_eval_force(struct ts_instance *self, const struct tsim *sim,
				  struct ts_table *out);
enum ts_status ts_wall_eval_contacts(struct ts_instance *self, const struct tsim *sim,
				     struct ts_table *out);
/* For the slot of the styles: no contacts without the word. */
bool ts_wall_gives(const struct ts_instance *self, const struct ts_value *value);
extern const char *const ts_wall_force_names[], *const ts_wall_contact_names[];
enum { TS_WALL_CONTACT_COLUMNS = 8 };
#define TS_WALL_CONTACTS_VALUE                                                                     \
	{                                                                                          \
		"contacts", "",                                                                    \
			"1 where a particle touches the wall, the force on it, the point of the "  \
			"wall, its radius (0 where it does not; of several contacts the last)",    \
			TS_PERATOM, TS_WALL_CONTACT_COLUMNS, ts_wall_contact_names,                \
			ts_wall_eval_contacts                                                      \
	}
#define TS_WALL_FORCE_VALUE                                                                        \
	{                                                                                          \
		"force", "force", "total force on the wall", TS_VECTOR, 3, ts_wall_force_names,    \
			ts_wall_eval_force                                                         \
	}

#endif
