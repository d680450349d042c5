/* Energy ledger: the energy balance of the particles, by sources and sinks.
 *
 * A kick is v' = v + s F/m, with s half a time step (in explicit and symplectic Euler a whole one). Then
 *
 *   m v'^2/2 - m v^2/2 = s F.(v + v')/2
 *
 * exactly, and the same holds for T and omega. So the works s F_c.(v + v')/2 of all causes c, sum F_c =
 * F, add up to the change of kinetic energy to rounding: the residual is the closure. The elastic
 * energy is known from the positions. It differs from minus the work of the springs by the error of the
 * integrator: the drift, O(h^2) for velocity Verlet and forces without jumps.
 *
 * The ledger uses the slot `watch` (style.h): forces of fixes are what each hook adds to f and torque;
 * those of contacts and bonds are split into parts by law/contact_parts.h; kicks are taken from the
 * velocities before and after each stage. The ledger changes nothing but columns of its own, which
 * carry F_c from one step to the first kick of the next. */
#ifndef TS_ENERGY_LEDGER_H
#define TS_ENERGY_LEDGER_H

#include "law/bond_element.h"
#include "law/contact_parts.h"
#include "math/compensated.h"
#include "math/exactsum.h"
#include "neigh/neigh.h"
#include "rank/world.h"
#include "rigid/rigid.h"

/* Causes that all ledgers have: each part of the contact force, between particles and with walls, and
 * bonds. */
enum { TS_LEDGER_PAIR, TS_LEDGER_WALL, TS_LEDGER_SIDES };
enum {
	TS_CAUSE_BOND = TS_LEDGER_SIDES * TS_NPART,
	TS_CAUSE_BOND_DASHPOT,
	TS_NCAUSE,
	TS_LEDGER_BOND = TS_LEDGER_SIDES * TS_NCONTACT_STORE, /* by mode of law/bond_element.h */
	TS_NSTORE = TS_LEDGER_BOND + TS_BOND_MODES
};
/* Layout of the numbers of one cause on one particle: force, torque, and the power that is transferred
 * to the drive of the surface. */
enum { TS_CAUSE_FORCE = 0, TS_CAUSE_TORQUE = 3, TS_CAUSE_DRIVE = 6, TS_CAUSE_NUMBERS };

/* After the causes: 1 if an integrator makes whole kicks; 1 if any cause is not 0. */
enum { TS_LEDGER_WHOLE_KICK = TS_NCAUSE * TS_CAUSE_NUMBERS, TS_LEDGER_NONZERO, TS_LEDGER_COLUMN };

static inline int ts_ledger_cause(int side, int part)
{
	return side * TS_NPART + part;
}
static inline int ts_ledger_store(int side, int store)
{
	return side * TS_NCONTACT_STORE + store;
}

/* An actor: a style that acts on particles. */
struct ts_ledger_actor {
	const char *name;	/* "fix ID", "pair" ...; in the string pool */
	struct ts_instance *by; /* NULL: it has been deleted */
	/* TS_LEDGER_PUSHES: acts in the force stages and has a column; TS_LEDGER_IS_WALL: a wall */
	int pushes;
	size_t column;
	/* work of its forces; energy it changed directly, e.g. by setting velocities */
	struct ts_compensated_sum work, own;
	struct ts_compensated_sum heat; /* heat it has supplied */
	double heat_rate;		/* in this step, energy/time */
};

enum { TS_LEDGER_PUSHES = 1, TS_LEDGER_IS_WALL = 2 };

/* Balance of the heat content: ledger_heat.c. */
struct ts_ledger_heat {
	double known; /* 1: there is a fix of family heat, and start and now are set */
	double start, now;
	/* source: heat of heatSource; moved: heat added, removed or set with particles */
	struct ts_compensated_sum source, moved;
	double seen; /* total flux into all particles after the last action */
};

/* Elastic energies of a note: at most those of a bond, which has more modes than a contact has stores. */
enum { TS_LEDGER_NOTE_ENERGIES = TS_BOND_MODES };
_Static_assert((int)TS_LEDGER_NOTE_ENERGIES >= (int)TS_NCONTACT_STORE, "room for the energies of a contact");

/* Elastic energy of a bond, or of one contact of a particle with a wall, in the last force computation. */
struct ts_ledger_note {
	int32_t tag[2];
	double energy[TS_LEDGER_NOTE_ENERGIES];
};

/* A journal entry: what sums over particles or contacts are added to. While the particles are divided among ranks the sums
 * of this rank wait for those of the others: ledger_journal.c. */
struct ts_ledger;
struct ts_ledger_entry;
typedef enum ts_status ts_ledger_post_fn(struct tsim *sim, struct ts_ledger *l,
					 const struct ts_ledger_entry *entry, const double *value);
struct ts_ledger_entry {
	ts_ledger_post_fn *post;
	const struct ts_instance *by; /* these are for `post` */
	size_t at;
	int32_t side, flags;
	double factor;
	size_t n;   /* sums */
	bool maybe; /* only made if one of the ranks has `counts` */
	bool counts;
};

struct ts_ledger_journal {
	struct ts_ledger_entry *entry;
	struct ts_exactsum *sum; /* of all entries */
	double *value;		 /* of the entry that is posted */
	size_t n, capacity, sums, sum_capacity, value_capacity;
};

/* Kinetic energy of a body that this rank counts, and its members. */
struct ts_ledger_body {
	int32_t id, members;
	double energy[2];
};

struct ts_ledger {
	/* saved */
	int64_t open;  /* 1: the balance has started, the start values are set */
	int64_t split; /* 1: the columns contain the forces of the last step */
	/* 1: some contacts are plastic or sticky: energy that springs do not store counts as lost */
	int64_t plastic[TS_LEDGER_SIDES];
	int64_t first; /* step at the start of the balance */
	double first_time;
	double start_kinetic[2], start_store[TS_NSTORE];
	double kinetic[2], store[TS_NSTORE]; /* now */
	/* Energies: work of each cause; work of moving walls; work of a deforming box on contacts across its
	 * faces; elastic energy of broken bonds; work lost in bonds that yield; error of the rotation of rigid bodies; constraints: particles
	 * that are not integrated, and fixed directions of bodies; changes by commands between runs. */
	struct ts_compensated_sum work[TS_NCAUSE], drive, box, broken, yielded, turning, held, between;
	/* energy of tangential springs dissipated by slip */
	struct ts_compensated_sum slip[TS_LEDGER_SIDES];
	/* elastic energy that came or went with particles, or changed between runs */
	struct ts_compensated_sum moved[TS_NSTORE];
	double largest_energy; /* largest total energy so far */
	struct ts_ledger_heat heat;
	int32_t newest; /* largest particle identity at the last force computation */
	struct ts_ledger_actor *actor;
	size_t nactors, actor_capacity;
	/* index of the actor that stands for forces of unknown origin: the ledger fix itself */
	size_t rest;

	/* transient data of one step */
	bool stepping;			/* true in a step; false in the set-up of a run */
	bool made;			/* forces were computed in the set-up */
	double store_before[TS_NSTORE]; /* store before the set-up */
	/* the forces of this step were accounted in the last run: only energies of contacts are stored */
	bool already_accounted;
	const char *name; /* ID of the fix, in the names of its columns */
	size_t column;	  /* causes of each particle, TS_LEDGER_WHOLE_KICK, TS_LEDGER_NONZERO */
	size_t n, capacity;
	uint64_t generation;
	double (*v)[3], (*omega)[3];	       /* at the beginning of the stage */
	double (*seen_v)[3], (*seen_omega)[3]; /* after the last action */
	double (*f)[3], (*torque)[3];	       /* after the last action */
	int32_t *kicker;      /* by particle: actor that has changed its velocity in this stage, or -1 */
	struct ts_body *body; /* at the beginning of the stage */
	size_t body_capacity, bodies;
	int due; /* stage whose kicks are not accounted yet; -1: none */
	/* contact histories before the force computation; walls in their order */
	double *memory, *wall_memory;
	size_t memory_n, memory_capacity, wall_memory_n, wall_memory_capacity;
	double (*row_energy)[TS_NCONTACT_STORE];
	size_t rows, row_capacity;
	struct ts_ledger_note *note, *bond;
	size_t notes, note_capacity, bonds, bond_capacity;

	/* with several ranks */
	struct ts_ledger_journal journal;
	struct ts_exactsum own_kinetic[2]; /* of this rank, at the last look */
	struct ts_ledger_body *counted;
	size_t ncounted, counted_capacity;
	bool relisted; /* the lists have been made again for other particles */
	/* identities and bodies: of the own particles before they moved to other ranks; of those that were deleted then */
	int32_t (*seen)[2], (*gone)[2];
	size_t nseen, seen_capacity, ngone, gone_capacity;
	int64_t all;		  /* particles of all ranks then */
	struct ts_parcel missing; /* bonds that may be broken */
};

enum {
	TS_LEDGER_STEPPING = 1, /* flags of entries: in a step */
	TS_LEDGER_FIRST = 2,	/* the store of energy is set, not added to */
	TS_LEDGER_EXACT = 4	/* scheme of the heat fix */
};
/* Makes the entry, now or, while the particles are divided, in ts_ledger_post. */
enum ts_status ts_ledger_enter(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
			       const struct ts_exactsum *sum);
/* Makes the entries with the sums of all ranks. */
enum ts_status ts_ledger_post(struct tsim *sim, struct ts_ledger *l);
/* Entry: adds the value to the account at this offset of struct ts_ledger. */
enum ts_status ts_ledger_post_account(struct tsim *sim, struct ts_ledger *l,
				      const struct ts_ledger_entry *entry, const double *value);

/* ledger_ranks.c. Before particles move to other ranks. */
enum ts_status ts_ledger_before_exchange(struct tsim *sim, struct ts_ledger *l);
/* After a step of that: whether particles were deleted, which are found then. All ranks call it. */
enum ts_status ts_ledger_find_deleted(struct tsim *sim, struct ts_ledger *l, bool *any);
bool ts_ledger_is_deleted(const struct ts_ledger *l, int32_t tag);
/* Lists are about to be made again, as all ranks got all particles, or have divided them. */
enum ts_status ts_ledger_share_bonds(struct tsim *sim, struct ts_ledger *l);
/* The energy of bonds that are noted and are not there any more, of all ranks. */
enum ts_status ts_ledger_account_missing(struct tsim *sim, struct ts_ledger *l);

/* Slots of a style whose state begins with a struct ts_ledger. */
enum ts_status ts_ledger_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_watch(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_setup(struct ts_instance *self, struct tsim *sim);
/* Accounts the kicks of the step; to be called first in END_OF_STEP. */
enum ts_status ts_ledger_finish_step(struct ts_instance *self, struct tsim *sim);
/* Slots for several ranks. */
enum ts_status ts_ledger_settle(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_join(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_ledger_fini(struct ts_instance *self);
enum ts_status ts_ledger_archive_columns(struct tsim *sim, struct ts_ledger *l, struct ts_archive *a);

/* Finds or adds the actor `by`; its index into *k. */
enum ts_status ts_ledger_actor(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by,
			       size_t *k);

/* ledger_parts.c: adds the forces of contacts and bonds to the columns by cause, and sums their elastic
 * energies. */
enum ts_status ts_ledger_account_pairs(struct tsim *sim, struct ts_ledger *l);
enum ts_status ts_ledger_account_wall(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *wall,
				      size_t actor);
enum ts_status ts_ledger_account_bonds(struct tsim *sim, struct ts_ledger *l);
/* Notes energies of contacts again, without accounting anything. */
enum ts_status ts_ledger_note_contacts(struct tsim *sim, struct ts_ledger *l);
/* Copy the contact histories before the force computation. */
enum ts_status ts_ledger_store_pair_history(struct tsim *sim, struct ts_ledger *l);
enum ts_status ts_ledger_store_wall_history(struct tsim *sim, struct ts_ledger *l);
/* Accounts the elastic energy of contacts and bonds of particles that were removed. */
enum ts_status ts_ledger_account_removed(struct tsim *sim, struct ts_ledger *l);

/* ledger_work.c: kinetic energies of translation and rotation; those of this rank. */
enum ts_status ts_ledger_kinetic(struct tsim *sim, struct ts_ledger *l, struct ts_exactsum out[2]);
/* Accounts the work of the kicks of a stage; `final`: of the second half of the step. */
enum ts_status ts_ledger_account_kicks(struct tsim *sim, struct ts_ledger *l, bool final);
/* Stores the velocities of particles and bodies at the beginning of a stage. */
enum ts_status ts_ledger_store_velocities(struct tsim *sim, struct ts_ledger *l);
/* Marks the particles whose velocity the actor has changed. */
void ts_ledger_mark_kicked(struct tsim *sim, struct ts_ledger *l, size_t actor);

/* ledger_heat.c: updates the heat content and accounts changes other than conduction; clears the fluxes
 * before the force computation; accounts the flux added by the last action; accounts the advance of the
 * temperatures. */
enum ts_status ts_ledger_heat_update(struct tsim *sim, struct ts_ledger *l);
void ts_ledger_heat_clear(struct ts_ledger *l);
enum ts_status ts_ledger_heat_flux(struct tsim *sim, struct ts_ledger *l, size_t actor);
enum ts_status ts_ledger_heat_advance(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by,
				      size_t actor);
double ts_ledger_heat_closure(const struct ts_ledger *l);

static inline double *ts_ledger_causes(const struct ts_ledger *l, const struct ts_particles *p, size_t i)
{
	const struct ts_column *c = &p->column[l->column];

	return (double *)c->data + i * c->width;
}

/* Values for output, in the order of f_ID[k]: E - E(0) = forces + walls + moved - lost + closure +
 * drift. */
/* clang-format off */
#define TS_LEDGER_LIST(X)                                                                          \
	X(TRANSLATION, "kinetic energy of translation")                                            \
	X(ROTATION, "kinetic energy of rotation")                                                  \
	X(CONTACTS, "elastic energy of particle contacts")                                             \
	X(WALLS, "elastic energy of wall contacts")                                                  \
	X(BONDS, "elastic energy of bonds")                                                                \
	X(TOTAL, "total energy")                                                                     \
	X(FORCES, "work of fixes")                                                         \
	X(DRIVE, "work of moving walls")                                                           \
	X(MOVED, "energy set, added or removed other than by forces")                       \
	X(NORMAL_DASHPOTS, "dissipated by normal dashpots")                                              \
	X(TANGENTIAL_DASHPOTS, "dissipated by tangential dashpots")                                      \
	X(FRICTION, "dissipated by sliding friction")                                                                \
	X(SPRINGS, "lost by rotated or released tangential springs")                            \
	X(ROLLING, "dissipated by rolling and twisting friction")                                                 \
	X(PLASTIC, "dissipated in plastic or adhesive contacts, and bonds that yield")                                 \
	X(BOND_DASHPOTS, "dissipated by bond dashpots")                                              \
	X(BROKEN, "elastic energy of broken bonds")                                                        \
	X(LOST, "total dissipation")                                                                \
	X(CLOSURE, "closure")                                                                      \
	X(DRIFT, "drift")                                                                          \
	X(TURNOVER, "largest turnover")                                                            \
	X(HEAT, "heat content of particles")                                                           \
	X(HEAT_IN, "heat from walls, fluid and sources")                                           \
	X(HEAT_MOVED, "heat set, added or removed with particles")                         \
	X(HEAT_CLOSURE, "heat closure")                                                                \
	X(BOND_NORMAL, "elastic energy of bonds, normal")                                              \
	X(BOND_SHEAR, "elastic energy of bonds, shear")                                                \
	X(BOND_BENDING, "elastic energy of bonds, bending")                                            \
	X(BOND_TWIST, "elastic energy of bonds, twist")
/* clang-format on */
#define TS_LEDGER_ENUM(name, text) TS_LEDGER_##name##_VALUE,
enum { TS_LEDGER_LIST(TS_LEDGER_ENUM) TS_LEDGER_VALUES };
#undef TS_LEDGER_ENUM
void ts_ledger_values(const struct ts_ledger *l, double out[TS_LEDGER_VALUES]);
/* Drift by store of elastic energy, and of the rotation of rigid bodies as the last. */
void ts_ledger_drifts(const struct ts_ledger *l, double out[TS_NSTORE + 1]);

#endif
