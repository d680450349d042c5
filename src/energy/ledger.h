/* The books of an energy ledger: where the energy of particles comes from and where it goes.
 *
 * A kick is v' = v + s F/m, s half a step (in explicit Euler and symplectic Euler a whole one). Then
 *
 *   m v'^2/2 - m v^2/2 = s F.(v + v')/2
 *
 * exactly, and the same with T and omega. So the work of each cause, s F_c.(v + v')/2 with sum F_c = F,
 * adds up to the change of kinetic energy to rounding: the closure. What springs store is known from where
 * particles are. It differs from minus the work of the springs by the error of the integrator: the drift,
 * O(h^2) for velocity Verlet and forces without jumps.
 *
 * The ledger watches (style.h): forces by what each action adds to f and torque; those of contacts and
 * bonds by taking them apart, law/contact_parts.h; kicks from the velocities before and after each stage.
 * It changes nothing but columns of its own, which carry F_c from one step into the first kick of the
 * next. */
#ifndef TS_ENERGY_LEDGER_H
#define TS_ENERGY_LEDGER_H

#include "law/contact_parts.h"
#include "math/compensated.h"
#include "math/exactsum.h"
#include "neigh/neigh.h"
#include "rigid/rigid.h"

/* Causes that all ledgers have: each part of contacts, of particles among themselves and with walls, and
 * bonds. */
enum { TS_LEDGER_PAIR, TS_LEDGER_WALL, TS_LEDGER_SIDES };
enum {
	TS_CAUSE_BOND = TS_LEDGER_SIDES * TS_NPART,
	TS_CAUSE_BOND_DASHPOT,
	TS_NCAUSE,
	TS_LEDGER_BOND = TS_LEDGER_SIDES * TS_NCONTACT_STORE,
	TS_NSTORE
};
/* Of one cause on one particle: force, torque, and the power that goes to who moves the surface. */
enum { TS_CAUSE_FORCE = 0, TS_CAUSE_TORQUE = 3, TS_CAUSE_DRIVE = 6, TS_CAUSE_NUMBERS };

/* After the causes: 1 where an integrator makes whole kicks; where some cause is not 0. */
enum { TS_LEDGER_WHOLE = TS_NCAUSE * TS_CAUSE_NUMBERS, TS_LEDGER_BUSY, TS_LEDGER_COLUMN };

static inline int ts_ledger_cause(int side, int part)
{
	return side * TS_NPART + part;
}
static inline int ts_ledger_store(int side, int store)
{
	return side * TS_NCONTACT_STORE + store;
}

/* Somebody who acts on particles. */
struct ts_ledger_actor {
	const char *name;	/* "fix ID", "pair" ...: of the string pool */
	struct ts_instance *by; /* NULL: it is gone */
	/* acts in the stages of forces, has a column: 1; or as a wall that moves: 2 */
	int pushes;
	size_t column;
	struct ts_compensated_sum work, own; /* of its forces; what it changed directly */
	struct ts_compensated_sum heat;	     /* it has brought */
	double heat_rate;		     /* in this step, heat by time */
};

enum { TS_LEDGER_PUSHES = 1, TS_LEDGER_IS_WALL = 2 };

/* Books of heat: ledger_heat.c. */
struct ts_ledger_heat {
	double known; /* 1: there is such a fix, and start and now are of it */
	double start, now;
	struct ts_compensated_sum source, moved; /* of heatSource; come, gone or set with particles */
	double seen;				 /* flux into all particles as of the last action */
};

struct ts_ledger_note { /* of a bond or of the contacts of a particle with walls, in the last forces */
	int32_t tag[2];
	double energy[TS_NCONTACT_STORE];
};

struct ts_ledger {
	/* saved */
	int64_t open;  /* the books are: the start is known */
	int64_t split; /* forces in the columns are those of the last step */
	/* some contacts yield or stick: what springs do not store is lost */
	int64_t plastic[TS_LEDGER_SIDES];
	int64_t first; /* step at the start */
	double first_time;
	double start_kinetic[2], start_store[TS_NSTORE];
	double kinetic[2], store[TS_NSTORE]; /* now */
	struct ts_compensated_sum work[TS_NCAUSE], drive, box, broken, turning, held, between;
	struct ts_compensated_sum slip[TS_LEDGER_SIDES]; /* what it takes of springs */
	/* energy of springs that came or went with particles, or between runs */
	struct ts_compensated_sum moved[TS_NSTORE];
	double most; /* energy at any time */
	struct ts_ledger_heat heat;
	int32_t newest; /* the largest identity when forces were last made */
	struct ts_ledger_actor *actor;
	size_t nactors, actor_capacity;
	size_t rest; /* the actor that stands for forces of nobody known: the ledger's own fix */

	/* of this step only */
	bool stepping;			/* in a step; else in the set-up of a run */
	bool made;			/* forces were made in the set-up */
	double store_before[TS_NSTORE]; /* the set-up */
	/* at a step that is booked already: energies of contacts are noted, nothing is booked */
	bool looking;
	const char *name; /* of its columns */
	size_t column;	  /* causes of each particle, and TS_LEDGER_WHOLE, TS_LEDGER_BUSY */
	size_t n, capacity;
	uint64_t generation;
	double (*v)[3], (*omega)[3];	       /* as the stage began */
	double (*seen_v)[3], (*seen_omega)[3]; /* after the last action */
	double (*f)[3], (*torque)[3];	       /* the same */
	int32_t *kicker;		       /* actor that has changed the velocity, or -1 */
	struct ts_body *body;		       /* as the stage began */
	size_t body_capacity, bodies;
	int due; /* stage of kicks that has not been booked; -1: none */
	/* of the contacts before their forces are made; walls' in their order */
	double *memory, *wall_memory;
	size_t memory_n, memory_capacity, wall_memory_n, wall_memory_capacity;
	double (*row_energy)[TS_NCONTACT_STORE];
	size_t rows, row_capacity;
	struct ts_ledger_note *note, *bond;
	size_t notes, note_capacity, bonds, bond_capacity;
};

/* For the slots of a style whose state begins with a ledger. */
enum ts_status ts_ledger_init(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_watch(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_setup(struct ts_instance *self, struct tsim *sim);
/* To be called first in END_OF_STEP. */
enum ts_status ts_ledger_settle(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_ledger_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a);
void ts_ledger_fini(struct ts_instance *self);
enum ts_status ts_ledger_archive_columns(struct tsim *sim, struct ts_ledger *l, struct ts_archive *a);

/* Of one actor; NULL name: things that nobody is known to have done. */
enum ts_status ts_ledger_actor(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by,
			       size_t *k);

/* ledger_parts.c: the forces of contacts and bonds by cause into the columns, the energies of springs. */
enum ts_status ts_ledger_take_pairs(struct tsim *sim, struct ts_ledger *l);
enum ts_status ts_ledger_take_wall(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *wall,
				   size_t actor);
enum ts_status ts_ledger_take_bonds(struct tsim *sim, struct ts_ledger *l);
/* Memories as they are before the forces. */
enum ts_status ts_ledger_hold_rows(struct tsim *sim, struct ts_ledger *l);
enum ts_status ts_ledger_hold_walls(struct tsim *sim, struct ts_ledger *l);
/* Particles are gone: the springs that held them went with them. */
enum ts_status ts_ledger_take_away(struct tsim *sim, struct ts_ledger *l);

/* ledger_work.c */
void ts_ledger_kinetic(struct tsim *sim, double out[2]);
/* The works of the kicks of this stage; `final`: of the second half of the step. */
enum ts_status ts_ledger_work(struct tsim *sim, struct ts_ledger *l, bool final);
/* A stage begins: the velocities of particles and bodies as they are; nobody has kicked yet. */
enum ts_status ts_ledger_work_start(struct tsim *sim, struct ts_ledger *l);
/* Who has changed which velocities. */
void ts_ledger_work_mark(struct tsim *sim, struct ts_ledger *l, size_t actor);

/* ledger_heat.c: what particles have now, that others than conduction have changed; before forces are
 * made; what the last action has added to the fluxes; the temperatures have been advanced. */
void ts_ledger_heat_look(struct tsim *sim, struct ts_ledger *l);
void ts_ledger_heat_clear(struct ts_ledger *l);
void ts_ledger_heat_flux(struct tsim *sim, struct ts_ledger *l, size_t actor);
void ts_ledger_heat_advance(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by,
			    size_t actor);
double ts_ledger_heat_closure(const struct ts_ledger *l);

static inline double *ts_ledger_causes(const struct ts_ledger *l, const struct ts_particles *p, size_t i)
{
	const struct ts_column *c = &p->column[l->column];

	return (double *)c->data + i * c->width;
}

/* What a user reads, in the order of f_ID[k]. E - E(0) = forces + walls + moved - lost + closure + drift. */
/* clang-format off */
#define TS_LEDGER_LIST(X)                                                                          \
	X(TRANSLATION, "kinetic energy of translation")                                            \
	X(ROTATION, "kinetic energy of rotation")                                                  \
	X(CONTACTS, "stored in contacts of particles")                                             \
	X(WALLS, "stored in contacts with walls")                                                  \
	X(BONDS, "stored in bonds")                                                                \
	X(TOTAL, "all energy")                                                                     \
	X(FORCES, "work of fixes' forces")                                                         \
	X(DRIVE, "work of moving walls")                                                           \
	X(MOVED, "set, brought in or taken away by other means than forces")                       \
	X(NORMAL_DASHPOTS, "lost in normal dashpots")                                              \
	X(TANGENTIAL_DASHPOTS, "lost in tangential dashpots")                                      \
	X(FRICTION, "lost in slip")                                                                \
	X(SPRINGS, "lost by springs of slip that turn, soften or part")                            \
	X(ROLLING, "lost in rolling and twisting")                                                 \
	X(PLASTIC, "lost in contacts that yield or stick")                                         \
	X(BOND_DASHPOTS, "lost in dashpots of bonds")                                              \
	X(BROKEN, "lost with broken bonds")                                                        \
	X(LOST, "all that is lost")                                                                \
	X(CLOSURE, "closure")                                                                      \
	X(DRIFT, "drift")                                                                          \
	X(TURNOVER, "largest turnover")                                                            \
	X(HEAT, "heat of the particles")                                                           \
	X(HEAT_IN, "heat from walls, fluid and sources")                                           \
	X(HEAT_MOVED, "heat set, brought in or taken away with particles")                         \
	X(HEAT_CLOSURE, "heat that is not explained")
/* clang-format on */
#define TS_LEDGER_ENUM(name, text) TS_LEDGER_##name##_VALUE,
enum { TS_LEDGER_LIST(TS_LEDGER_ENUM) TS_LEDGER_VALUES };
#undef TS_LEDGER_ENUM
void ts_ledger_values(const struct ts_ledger *l, double out[TS_LEDGER_VALUES]);
/* Drift of the springs by store, and of turning bodies as the last. */
void ts_ledger_drifts(const struct ts_ledger *l, double out[TS_NSTORE + 1]);

#endif
