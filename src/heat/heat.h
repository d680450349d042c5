/* Temperatures of particles and conduction of heat between touching particles and walls: the
 * implementation of fix heat/gran, and its interface for walls. The law is in law/conduction.h. */
#ifndef TS_HEAT_HEAT_H
#define TS_HEAT_HEAT_H

#include "contact/contact_pass.h"
#include "core/sim.h"
#include "law/conduction.h"
#include "neigh/contact_list.h"
#include "particle/particles.h"

struct ts_granular_model;

/* Heat flow through one contact: [0] heat rate into the first particle of the pair, energy/time; [1..3]
 * half of it times the vector from the second particle to the first, energy length/time. */
struct ts_heat_flow {
	double number[4];
};

/* Conductances and heat flows of a list of pairs. */
struct ts_heat_pairs {
	const struct ts_contact_list *rows;
	/* conductance h of each pair, energy/(time temperature), 0 if not in contact; stored only in
	 * steps in which it is needed (ts_heat.keeps) */
	double *conductance;
	size_t capacity;
	struct ts_heat_flow *flow; /* by slot */
	size_t flow_capacity;
};

enum ts_heat_scheme { TS_HEAT_EULER, TS_HEAT_EXACT };

#define TS_FAMILY_HEAT "heat"

/* State of a fix of that family. */
struct ts_heat {
	double initial;
	struct ts_words area_words;
	bool correction, store;
	int scheme; /* enum ts_heat_scheme */

	struct ts_heat_contact contact;
	bool ready; /* the columns exist */
	/* indices of particle columns: temperature; heat rate into the particle by conduction; by its
	 * source; directional heat flux */
	size_t temperature, flux, source, directed;
	size_t contacts, area, wall_flux; /* only with store_contact_data */
	size_t wall_conductance;	  /* sum of the conductances of its wall contacts, and of fluids */
	size_t rate;			  /* dT/dt and Taylor terms of scheme exact */

	int ntypes;
	double *conductivity, *capacity; /* by atom type */
	double *pair;			 /* 4 k_i k_j / (k_i + k_j), by pair of types */
	double *softening; /* factor of the overlap (area_correction), by pair of types; NULL: 1 */

	/* pairs of two frozen particles, which the contact list does not contain */
	struct ts_contact_list held;
	struct ts_heat_pairs pairs[2];
	struct ts_fused_pass fused_pass; /* fused with the pass of the contact forces */
	double *inner;			 /* by particle: heat rate from other particles */
	size_t inner_capacity;
	double *work; /* scratch memory of scheme exact: three numbers per particle */
	size_t work_capacity;
	double *mean_rise; /* by particle, for ts_heat_mean_rise */
	size_t mean_rise_capacity;
	bool keeps;   /* store the conductances in this step */
	bool examine; /* the contact list was rebuilt: check the time step against the stability limit */
	bool warned;
	double bound;	  /* magnitude of temperature beyond which stability is checked */
	long beyond;	  /* number of particles beyond it, as far as deferred loops have been executed */
	int64_t advanced; /* step to which temperatures have been advanced */
	struct tsim *sim; /* for the evaluation of outputs, which needs a mutable simulation */
};

/* Parses `overlap`, `constant A` or `projection`; also a keyword of walls. */
enum ts_status ts_heat_read_area(struct tsim *sim, const char *who, struct ts_words words,
				 struct ts_heat_contact *out);

#define TS_HEAT_AREA_ARG(T, f)                                                                   \
	TS_SOME_KEYWORD("contact_area", T, f, 0,                                                 \
			.help = "overlap (circle of intersection, the default), constant A, or " \
				"projection (cross section of the larger sphere)")

/* The fix heat/gran; NULL if there is none. */
struct ts_heat *ts_heat_of(const struct tsim *sim);
enum ts_status ts_heat_conductivity(struct tsim *sim, int type, const char *who, const struct ts_place *where,
				    double *out);
/* The factor by which area_correction changes the overlap of two types, whose contacts have this model; 1 without it. */
enum ts_status ts_heat_softening(struct tsim *sim, const struct ts_heat *heat,
				 const struct ts_granular_model *model, int a, int b,
				 const struct ts_place *where, double *out);
/* Adds the heat flow from what has this temperature, e.g. a fluid, to particle i and returns it, energy/time;
 * `conductance`: heat flow by difference of temperatures. To be called in stage POST_FORCE; in the set-up of a run
 * nothing is added. */
double ts_heat_from_outside(const struct ts_heat *heat, struct tsim *sim, size_t i, double conductance,
			    double temperature);
/* The same from a wall, whose flow is that of wallHeatFlux, too; `conductance`: h of the contact. */
double ts_heat_from_wall(const struct ts_heat *heat, struct tsim *sim, size_t i, double conductance,
			 double temperature);
/* Mean temperature of particle i over this step, minus that of stage POST_FORCE, with which heat flows are
 * computed: scheme euler advances all temperatures by these flows, so it is 0. Known from the stage
 * FINAL_INTEGRATE of the fix heat/gran until the end of the step. */
static inline double ts_heat_mean_rise(const struct ts_heat *heat, size_t i)
{
	return heat->scheme == TS_HEAT_EXACT ? heat->mean_rise[i] : 0;
}

/* Slots of the style. */
extern const struct ts_value ts_heat_values[];
enum ts_status ts_heat_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
enum ts_status ts_heat_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_heat_fini(struct ts_instance *self);
/* Hooks of the stages. */
enum ts_status ts_heat_update_contacts(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_clear(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_conduct(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_set_bound(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_heat_advance(struct ts_instance *self, struct tsim *sim);

/* Data of a column. */
static inline double *ts_heat_column(const struct tsim *sim, size_t column)
{
	return sim->particles->column[column].data;
}
/* Evaluates the material constants of all types in use. */
enum ts_status ts_heat_materials(struct ts_instance *self, struct tsim *sim);
/* Computes the conductances of all pairs at the current positions. */
void ts_heat_find_conductances(const struct ts_instance *self, struct tsim *sim);
/* Sums over the contacts of particle i, in the order of the identities of the partners: of
 * h (value_j - value_i); of h, walls included. */
double ts_heat_sum_differences(const struct ts_heat *heat, size_t i, const double *value);
double ts_heat_sum_conductances(const struct ts_heat *heat, const struct tsim *sim, size_t i);
/* Fills the columns of store_contact_data. */
void ts_heat_store_contacts(const struct ts_instance *self, struct tsim *sim);
/* Returns an error if temperatures diverge because the time step exceeds the limit of explicit Euler. */
enum ts_status ts_heat_check_divergence(struct ts_instance *self, struct tsim *sim);

#endif
