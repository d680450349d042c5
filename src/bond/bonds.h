/* Bonds: an explicit list of pairs that hold together until they break.
 *
 * Each particle adds up the forces of its bonds in the order of partners' identities, as for contact rows,
 * so results do not depend on threads or order in memory. */
#ifndef TS_BOND_BONDS_H
#define TS_BOND_BONDS_H

#include "base/parallel.h"
#include "bond/bond_slices.h"
#include "core/coeff.h"
#include "core/sim.h"
#include "neigh/gather.h"

/* What a broken bond leaves behind. */
struct ts_bond_event {
	int64_t step;
	double time, x[3], force; /* place: middle between the partners */
	int32_t tag[2], type;
};

struct ts_bonds {
	size_t n, capacity;
	int32_t (*tag)[2]; /* identities, smaller first */
	int32_t *type;	   /* 1..ntypes */
	double *rest;	   /* length without force */
	int32_t (*row)[2]; /* rows of the particle columns; made at each rebuild */
	/* along the bond, > 0 pulling: of the last step of which all is left (sim->complete) */
	double *tension;
	bool shown;	       /* an output may look at tensions at any step: they are left always */
	unsigned char *breaks; /* in this step */

	struct ts_gather gather; /* of the local particles */
	struct ts_bond_slices slices;

	int ntypes;
	int64_t created, broken; /* ever */
	int64_t gone;		 /* lost because a partner left the simulation */
	struct ts_bond_event *event;
	size_t nevents, event_capacity;
};

/* One bond, as bond laws see it. */
struct ts_bond_state {
	double extension; /* length - rest */
	double rate;	  /* of extension; 0 unless a bond is damped */
};

/* Tension (> 0 pulls the partners together) into *tension; false if the bond breaks, which one at rest
 * does not. */
typedef bool ts_bond_law(const void *coeff, const struct ts_bond_state *state, double *tension);

struct ts_bond_style {
	struct ts_style style;
	size_t coeff_size; /* bytes that the rows style.coeff fill, the arguments of bond_coeff */
	enum ts_status (*complete)(struct tsim *sim, void *coeff, const struct ts_place *where);
	ts_count_fn *share;		   /* ts_bond_share with its law: bond/bond_loop.h */
	bool (*damped)(const void *coeff); /* tension depends on the rate */
	double (*stiffness)(const void *coeff);
	/* Elastic energy at this extension; NULL: the law has no potential. */
	double (*energy)(const void *coeff, double extension);
	/* Largest stable time step of one bond with reduced mass m*. */
	double (*limit)(const void *coeff, double mass, bool explicit_euler);
};

/* First member of every bond style's state. */
struct ts_bond {
	struct ts_coeffs coeffs; /* entry of bond type t: t */
};

static inline const struct ts_bond_style *ts_bond_style_of(const struct ts_instance *inst)
{
	return (const struct ts_bond_style *)inst->style;
}

/* Adds a bond of the present length between two particles; nothing if they are bonded already. Keep
 * the list sorted with ts_bonds_sort after a series. */
enum ts_status ts_bonds_add(struct tsim *sim, int32_t tag_a, int32_t tag_b, int type, double rest);
void ts_bonds_sort(struct ts_bonds *bonds);
bool ts_bonds_has(const struct ts_bonds *bonds, int32_t tag_a, int32_t tag_b); /* sorted list */
/* Removes the bonds whose flag is set. */
void ts_bonds_delete(struct ts_bonds *bonds, const unsigned char *flag);

/* Makes the lists by particle anew after the list or the particles' rows have changed. */
enum ts_status ts_bonds_index(struct tsim *sim);

/* Vector from particle j to particle i, by the nearest image; its length. */
double ts_bond_separation(const struct tsim *sim, size_t i, size_t j, double d[3]);

enum ts_status ts_bond_set(struct tsim *sim, struct ts_types types, struct ts_words words,
			   const struct ts_place *where);
/* Shared by all bond styles: slots of struct ts_style. */
enum ts_status ts_bond_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_bond_force(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_bond_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_bond_fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash);
enum ts_status ts_bond_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
void ts_bond_fini(struct ts_instance *self);

extern const struct ts_system_style ts_bonds_system;

#endif
