/* Bonds: a list of pairs of particles that stay connected until the bond breaks.
 *
 * The forces on a particle are summed over its bonds in the order of the identities of the partners, as
 * for contacts, so results depend neither on threads nor on the order of particles in memory. */
#ifndef TS_BOND_BONDS_H
#define TS_BOND_BONDS_H

#include "base/parallel.h"
#include "bond/bond_ranks.h"
#include "bond/bond_rows.h"
#include "bond/bond_slices.h"
#include "core/coeff.h"
#include "core/sim.h"
#include "law/bond_softening.h"
#include "math/exactsum.h"
#include "neigh/gather.h"

/* Record of a bond that broke. */
struct ts_bond_event {
	int64_t step;
	double time, x[3]; /* x: midpoint of the partners */
	double force;	   /* along the bond when it broke, > 0 in tension */
	int32_t tag[2], type;
	int32_t mode; /* what failed: enum ts_bond_failure */
};

/* Why a bond broke. Central springs break by their force, in tension or compression; TS_BOND_CUT: by fix bond/break. */
enum ts_bond_failure {
	TS_BOND_FORCE,
	TS_BOND_TENSION,
	TS_BOND_SHEARED,
	TS_BOND_CRUSHED,
	TS_BOND_CUT,
	TS_BOND_HEATED,
	TS_BOND_FAILURES
};
/* Values of ts_bonds.breaks: 0: holds; 1: breaks by its law, which tells the mode; else breaks by this mode. */
#define TS_BOND_BREAKS_BY(mode) ((unsigned char)((mode) + 2))
const char *ts_bond_failure_name(int mode);

/* What a bond that transmits moments remembers of the state in which it is free of shear, bending and
 * torque: bond/bond_reference.h. */
struct ts_bond_reference {
	double frame[2]
		    [4];  /* first axis along the bond, as quaternion, seen from either partner; 0: not set */
	double radius[2]; /* of the partners */
};

/* Forces and torques of a bond that transmits moments, on the first particle and on either. */
struct ts_bond_load {
	double force[3], torque[2][3];
};

struct ts_bonds {
	size_t n, capacity;
	int32_t (*tag)[2]; /* identities of the partners, the smaller first */
	int32_t *type;	   /* 1..ntypes */
	double *rest;	   /* rest length */
	double *own; /* that without coefficients that give it: distance at the creation, and yielding since */
	/* local indices of the partners, valid from one rebuild of the contact list to the next */
	int32_t (*row)[2];
	/* force along the bond, > 0 attractive, of the last step at which it was stored
	 * (sim->run.complete or shown) */
	double *tension;
	/* [n] if `transmits`: the bond style transmits moments. Loads are stored as tensions are. */
	struct ts_bond_reference *reference;
	struct ts_bond_load *load;
	bool transmits;
	/* [n] if `softens`: a bond type softens or has friction (law/bond_softening.h); lost: work in this step */
	struct ts_bond_damage *damage;
	double *lost;
	bool softens;
	bool shown;	       /* an output may read tensions at any step: they are stored in each step */
	unsigned char *breaks; /* per bond: breaks in this step */
	unsigned char
		*fresh; /* per bond: created after the contact list was built, which may have its pair */
	/* work lost in bonds that yield or soften, in this step; of those whose first particle is one of this rank */
	struct ts_exactsum flow;

	struct ts_gather gather; /* bonds of each local particle */
	/* the order in which bonds are computed: central springs by slices, bonds that transmit moments by rows */
	struct ts_bond_slices slices;
	struct ts_bond_rows rows;
	struct ts_bond_ranks ranks;

	int ntypes;
	int64_t created, broken; /* totals over all runs */
	int64_t gone;		 /* total of unbroken bonds removed because a partner left the simulation */
	struct ts_bond_event *event;
	double *event_energy; /* elastic energy of the bond when it broke; NaN: no potential, or an old restart file */
	unsigned char *event_fresh; /* whether it was fresh when it broke: the contact list has its pair */
	size_t past_events; /* of them, before the last reset_timestep: their steps are of another count */
	size_t nevents, event_capacity, energy_capacity, event_fresh_capacity, reference_capacity,
		load_capacity, damage_capacity, lost_capacity;
};

/* Arguments of a bond law. */
struct ts_bond_state {
	double extension; /* length minus rest length */
	double rate;	  /* time derivative of the extension; 0 if no bond is damped */
	double rest;	  /* rest length; 0 where there is no bond */
};

/* Evaluates the force along the bond (> 0 attractive) into *tension; returns false if the bond breaks.
 * A bond at its rest length does not break. */
typedef bool ts_bond_law(const void *coeff, const struct ts_bond_state *state, double *tension);

struct ts_bond_element;
struct ts_plastic_section;
struct ts_bond_ends;
struct ts_bond_answer;
/* Evaluates a bond that transmits moments, with the constants e, which it may change. `whole`: all forces; else
 * only the part that has the potential energy ts_bond_energies, without damping. Returns false if the bond breaks. */
typedef bool ts_bond_single_law(const void *coeff, struct ts_bond_element *e, const struct ts_bond_ends *s,
				bool whole, struct ts_bond_answer *out);
/* One bond and its partners; what the constants of its element may depend on. */
struct ts_bond_pair {
	double rest, radius[2], mass[2], inertia[2];
	int32_t tag[2];
};

struct ts_bond_style {
	struct ts_style style;
	/* Fails if the bonds that exist cannot act in this scene: before a run, and after bonds have been made in it.
	 * NULL: all can. */
	ts_hook_fn *allow;
	/* bytes of the coefficients of one bond type, the arguments of bond_coeff (style.coeff) */
	size_t coeff_size;
	enum ts_status (*complete)(struct tsim *sim, void *coeff, const struct ts_place *where);
	/* called when the style is chosen: makes what scripts may name from then on; or NULL */
	enum ts_status (*chosen)(struct ts_instance *self, struct tsim *sim);
	ts_range_count_fn *compute;	   /* ts_bond_compute_slices with this law (bond/bond_loop.h) */
	bool (*damped)(const void *coeff); /* whether the tension depends on the rate of extension */
	/* Bonds that transmit moments: the constants of law/bond_element.h; `compute` is then
	 * ts_bond_compute_moments, and the functions below are NULL. NULL: central springs. */
	void (*element)(const void *coeff, const struct ts_bond_pair *pair, struct ts_bond_element *out);
	bool (*softens)(const void *coeff); /* or has friction; NULL: no bond does */
	/* What a bond yields at; returns false if bonds of this type do not yield. NULL: none does. */
	bool (*section)(const void *coeff, const struct ts_bond_pair *pair, struct ts_plastic_section *out);
	/* Their law, if it is not that of law/bond_element.h with dashpots and largest stresses; `compute` may
	 * then be TS_BOND_SINGLE_LOOP with it (bond/bond_single_loop.h). NULL: it is. */
	ts_bond_single_law *law;
	/* Length without force, if the coefficients give it; NULL: that with which the bond was created. */
	double (*length)(const void *coeff);
	double (*stiffness)(const void *coeff, double rest); /* the largest */
	/* Force without damping, > 0 attractive, and elastic energy at this extension; NULL if the law has no
	 * potential. */
	double (*spring)(const void *coeff, double extension, double rest);
	double (*energy)(const void *coeff, double extension, double rest);
	/* Largest stable time step of one bond with the reduced mass `mass` = 1/(1/m_i + 1/m_j). */
	double (*limit)(const void *coeff, double rest, double mass, bool explicit_euler);
};

/* First member of the state of every bond style. */
struct ts_bond {
	struct ts_coeffs coeffs; /* entry t: bond type t */
};

static inline const struct ts_bond_style *ts_bond_style_of(const struct ts_instance *inst)
{
	return (const struct ts_bond_style *)inst->style;
}

/* Adds a bond with the rest length `rest`, unless the coefficients give another one, without a check whether the pair is
 * bonded already. Sort the list by ts_bonds_sort after a series. */
enum ts_status ts_bonds_add(struct tsim *sim, int32_t tag_a, int32_t tag_b, int type, double rest);
/* Rest lengths become those that the coefficients give, or the bonds' own. */
void ts_bonds_set_lengths(struct tsim *sim);
void ts_bonds_sort(struct ts_bonds *bonds);
bool ts_bonds_has(const struct ts_bonds *bonds, int32_t tag_a, int32_t tag_b);	   /* sorted list */
bool ts_bonds_has_old(const struct ts_bonds *bonds, int32_t tag_a, int32_t tag_b); /* which is not fresh */
/* Makes the arrays of bonds that transmit moments, or frees them. */
enum ts_status ts_bonds_transmit(struct tsim *sim, bool moments);
/* The same for bonds that soften. */
enum ts_status ts_bonds_soften(struct tsim *sim, bool softens);
/* Removes the bonds whose flag is set. */
void ts_bonds_delete(struct ts_bonds *bonds, const unsigned char *flag);
enum ts_status ts_bonds_reserve(struct tsim *sim, size_t n);
enum ts_status ts_bonds_reserve_events(struct tsim *sim, size_t n);

/* The columns of the list that are present, without rows of partners and flags, which are valid in a step only. */
enum { TS_BOND_COLUMNS = 9 };
struct ts_bond_column {
	void *data;
	size_t size; /* bytes of an element */
};
size_t ts_bond_columns(const struct ts_bonds *bonds, struct ts_bond_column column[TS_BOND_COLUMNS]);

/* Finds the local indices of the partners, deletes bonds of particles that have left, and rebuilds the lists of
 * bonds by particle. */
enum ts_status ts_bonds_connect(struct tsim *sim);
/* Whether the local indices are those of the partners. */
bool ts_bonds_connected(const struct ts_bonds *bonds, const struct ts_particles *particles);
/* Between runs: connects if particles have been deleted or created since; for outputs. */
enum ts_status ts_bonds_connect_if_changed(struct tsim *sim);
/* Rebuilds the lists of bonds by particle after the list or the local indices have changed. */
enum ts_status ts_bonds_build_index(struct tsim *sim);

/* Vector from particle j to particle i by the nearest image; returns its length. */
double ts_bond_separation(const struct tsim *sim, size_t i, size_t j, double d[3]);

extern const struct ts_system_style ts_bonds_system;

#endif
