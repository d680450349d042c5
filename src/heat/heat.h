/* Temperatures of particles and the heat that touching particles and walls conduct: the work of
 * fix heat/gran, and what walls need of it. The law is in law/conduction.h. */
#ifndef TS_HEAT_HEAT_H
#define TS_HEAT_HEAT_H

#include "contact/contact_pass.h"
#include "core/sim.h"
#include "law/conduction.h"
#include "neigh/contact_list.h"
#include "particle/particles.h"

/* Heat per time from the partner into the first of a row, and half of it times the vector from the
 * partner. */
struct ts_heat_flow {
	double number[4];
};

/* Conductances of a list of pairs. */
struct ts_heat_pairs {
	const struct ts_contact_list *rows;
	/* h of each row; 0 where it does not touch. Of a step only if somebody will look */
	double *conductance;
	size_t capacity;
	struct ts_heat_flow *flow; /* of each slot */
	size_t flow_capacity;
};

enum ts_heat_scheme { TS_HEAT_EULER, TS_HEAT_EXACT };

#define TS_FAMILY_HEAT "heat"

/* The state of a fix of that family. */
struct ts_heat {
	double initial;
	struct ts_words area_words;
	bool correction, store;
	int scheme; /* enum ts_heat_scheme */

	struct ts_heat_contact contact;
	bool ready; /* the columns exist */
	/* columns: temperature, heat per time into the particle by conduction, by its source, as a vector */
	size_t temperature, flux, source, directed;
	size_t contacts, area, wall_flux; /* with store_contact_data */
	size_t wall_conductance;	  /* sum of h over the walls that it touches */
	size_t rate;			  /* a stage of scheme exact */

	int ntypes;
	double *conductivity, *capacity; /* by type */
	double *pair;			 /* 4 k_i k_j / (k_i + k_j), by pair of types */
	double *softening;		 /* of the overlap, by pair of types; NULL: 1 */

	struct ts_contact_list held; /* pairs of which neither moves: they have no contact row */
	struct ts_heat_pairs pairs[2];
	struct ts_fused_pass fused_pass; /* of the forces of contacts */
	double *inner;			 /* heat per time from particle to particle */
	size_t inner_capacity;
	double *work; /* of scheme exact: two numbers a particle */
	size_t work_capacity;
	bool keeps;   /* the conductances of this step */
	bool examine; /* the contacts are new: is the step below the limit? */
	bool warned;
	double bound;	  /* temperatures beyond it are looked at twice */
	long beyond;	  /* how many there are, as far as passes have not waited */
	int64_t advanced; /* the step they have come to */
	struct tsim *sim; /* evaluation may fail */
};

/* `overlap`, `constant A` or `projection`; also a word of walls. */
enum ts_status ts_heat_read_area(struct tsim *sim, const char *who, struct ts_words words,
				 struct ts_heat_contact *out);

#define TS_HEAT_AREA_ARG(T, f)                                                                   \
	TS_SOME_KEYWORD("contact_area", T, f, 0,                                                 \
			.help = "overlap (where the surfaces cut, the default), constant A, or " \
				"projection (of the larger sphere)")

/* The live fix heat/gran; NULL: there is none. */
struct ts_heat *ts_heat_of(const struct tsim *sim);
enum ts_status ts_heat_conductivity(struct tsim *sim, int type, const char *who, const struct ts_place *where,
				    double *out);
/* Particle i touches a wall of this temperature: h from the law. In stage POST_FORCE. */
void ts_heat_from_wall(const struct ts_heat *heat, struct tsim *sim, size_t i, double conductance,
		       double temperature);

/* Slots of the style. */
extern const struct ts_value ts_heat_values[];
enum ts_status ts_heat_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
enum ts_status ts_heat_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_heat_fini(struct ts_instance *self);
/* Stages. */
enum ts_status ts_heat_built(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_clear(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_conduct(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_start(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_advance(struct ts_instance *self, struct tsim *sim);

/* Inside: a column; the conductances of all contacts as particles lie now; of particle i the sum of
 * h (value_j - value_i) over its contacts, and of h, walls included. */
static inline double *ts_heat_column(const struct tsim *sim, size_t column)
{
	return sim->particles->column[column].data;
}
/* The constants of all types up to the largest that particles have. */
enum ts_status ts_heat_materials(struct ts_instance *self, struct tsim *sim);
void ts_heat_find(const struct ts_instance *self, struct tsim *sim);
double ts_heat_sum(const struct ts_heat *heat, size_t i, const double *value);
double ts_heat_conductances(const struct ts_heat *heat, const struct tsim *sim, size_t i);
/* The columns of `store`. */
void ts_heat_store_contacts(const struct ts_instance *self, struct tsim *sim);
/* Fails if temperatures have grown without bound. */
enum ts_status ts_heat_look(struct ts_instance *self, struct tsim *sim);

#endif
