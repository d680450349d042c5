/* Rigid bodies whose members are particles at fixed positions in the body.
 *
 * A system: it integrates all bodies by velocity Verlet for the centre of mass and the angular momentum;
 * the orientation is integrated by math/rigid_turn.h. Members have contacts with other particles, with
 * the mass of the body, but not with each other; forces on them act on the body. If a member is lost or
 * deleted, the whole body is deleted. */
#ifndef TS_RIGID_RIGID_H
#define TS_RIGID_RIGID_H

#include "core/sim.h"
#include "particle/particles.h"

struct ts_body {
	double mass;
	double inertia[3];	    /* principal moments about the centre of mass */
	double q[4];		    /* quaternion: orientation of the principal axes */
	double x[3], v[3];	    /* centre of mass, unwrapped, and its velocity */
	double spin[3];		    /* angular momentum about the centre of mass */
	double omega[3];	    /* angular velocity */
	double force[3], torque[3]; /* of the last step, in directions in which it is held, too */
	double external[3];	    /* force on the body as a whole in this step (gravity) */
	double free[6];		    /* 1 or 0: translation along x, y, z; rotation about x, y, z */
	double density;		    /* of its material, or 0 */
	double kind;		    /* of a clump: number of its template; else 0 */
};

/* Rows of saved state for a body that is a field of a style's state. */
#define TS_SAVED_BODY(T, f)                                                                          \
	TS_SAVE_F64(T, f.mass), TS_SAVE_F64(T, f.inertia), TS_SAVE_F64(T, f.q), TS_SAVE_F64(T, f.x), \
		TS_SAVE_F64(T, f.v), TS_SAVE_F64(T, f.spin), TS_SAVE_F64(T, f.omega),                \
		TS_SAVE_F64(T, f.force), TS_SAVE_F64(T, f.torque), TS_SAVE_F64(T, f.external),       \
		TS_SAVE_F64(T, f.free), TS_SAVE_F64(T, f.density), TS_SAVE_F64(T, f.kind)

enum { TS_BODY_NUMBERS = sizeof(struct ts_body) / sizeof(double) }; /* all members are doubles */

struct ts_rigid {
	size_t n;
	struct ts_body *body; /* [n], in the order of their ids */
	int32_t *id;	      /* [n], ascending */
	int32_t *size;	      /* [n], number of members when it was created */
	int64_t *owner;	      /* [n], the fix that created it: ts_rigid_owner */
	size_t body_capacity, id_capacity, size_capacity, owner_capacity;
	int32_t last_id;

	/* local indices of the members of body b: member[start[b]] .. member[start[b + 1] - 1], by tag */
	int32_t *member;
	size_t *start;
	size_t member_capacity, start_capacity;
	/* [ordered], bodies with members, in the order of their first members in memory */
	int32_t *order;
	size_t ordered, order_capacity;
	/* the members of these, one body after the other: those of order[k] are row[row_start[k]] .. row[row_start[k + 1] - 1] */
	int32_t *row;
	size_t *row_start;
	size_t row_capacity, row_start_capacity;
	uint64_t generation; /* of the particles when members were listed; 0: not listed */
	bool read;	     /* from a restart file; no run has begun since then */
	bool fresh;	     /* a run begins: members may have got other velocities */
	int64_t lost;	     /* particles that had been lost when bodies were checked */
	/* Fails if a fix also integrates one of the members row[0..n-1]; set by the integrators. */
	enum ts_status (*check_members)(struct tsim *sim, const int32_t *row, size_t n);
};

/* Identifies the fix with this ID as owner of bodies, which are dissolved when it is deleted. */
int64_t ts_rigid_owner(const char *fix);

/* Adds a body with the n particles row[] as members. Mass, moments, orientation, centre and velocities
 * are those of `body`; positions and velocities of the members are computed from them. */
enum ts_status ts_rigid_add(struct tsim *sim, const struct ts_body *body, int64_t owner, const int32_t *row,
			    size_t n);
/* Dissolves the bodies of this owner; their particles become independent. */
enum ts_status ts_rigid_dissolve(struct tsim *sim, int64_t owner);

/* Dissolves all bodies whose fix does not exist. This is done before a step, not when a fix is deleted:
 * after a restart bodies exist before the script defines their fix. */
enum ts_status ts_rigid_dissolve_orphans(struct tsim *sim);

/* Whether the fix with this number exists. */
bool ts_rigid_owner_lives(const struct tsim *sim, int64_t owner);

/* Deletes bodies that have lost members, and their other members. The members must be listed. */
enum ts_status ts_rigid_drop_incomplete(struct tsim *sim);

/* Lists the members again if the order of particles in memory has changed. */
enum ts_status ts_rigid_list(struct tsim *sim);

/* With several ranks each has the bodies with a member among its particles, and copies of the other members; it integrates
 * them with the forces on all members, from the same bits as the other ranks that have them. */

/* Hook of EXCHANGE while the particles are divided. */
enum ts_status ts_rigid_exchange_own(struct tsim *sim);
/* Slot `join`: all ranks get all bodies. */
enum ts_status ts_rigid_join(struct ts_instance *self, struct tsim *sim);
/* Slot `claim`. */
enum ts_status ts_rigid_claim(struct ts_instance *self, struct tsim *sim, const struct ts_copy_map *copies,
			      struct ts_claims *claims);
extern const struct ts_carrier ts_rigid_carrier;
enum ts_status ts_rigid_reserve(struct tsim *sim, size_t n);
/* Removes the flagged bodies; their members become independent particles. The members must be listed. */
void ts_rigid_drop(struct tsim *sim, const unsigned char *gone);
/* Deletes the flagged bodies with those of their members that are particles of this rank. The members must be listed. */
enum ts_status ts_rigid_delete(struct tsim *sim, const unsigned char *torn);
/* Index of the body with this id, or r->n. */
size_t ts_rigid_find(const struct ts_rigid *r, int32_t id);
/* Index of the body of particle i, or r->n; there are bodies. */
static inline size_t ts_rigid_index(const struct ts_rigid *r, const struct ts_particles *p, size_t i)
{
	return p->body[i] ? ts_rigid_find(r, p->body[i]) : r->n;
}

/* Whether particle i is in a body; and whether a and b are in the same one. */
static inline bool ts_rigid_member(const struct ts_particles *p, size_t i)
{
	return p->body && p->body[i];
}
static inline bool ts_rigid_same(const struct ts_particles *p, size_t a, size_t b)
{
	return p->body && p->body[a] && p->body[a] == p->body[b];
}

/* Mass of particle i in contacts: that of its body, if it is a member of one. */
static inline double ts_rigid_inertial_mass(const struct ts_particles *p, size_t i)
{
	return ts_rigid_member(p, i) && p->imass[i] > 0 ? 1 / p->imass[i] : p->mass[i];
}

/* The body of particle i, or NULL. */
const struct ts_body *ts_rigid_body_of(const struct tsim *sim, size_t i);

/* Material density of particle i: mass / volume; in a clump the density of the clump, since its overlapping
 * spheres share its mass. */
double ts_rigid_material_density(const struct tsim *sim, size_t i);

/* Whether body b has a member in the group. The members must be listed. */
bool ts_rigid_in_group(const struct ts_rigid *r, const struct ts_particles *p, size_t b, int group);
/* Number of its members in the group. */
size_t ts_rigid_members_in_group(const struct ts_rigid *r, const struct ts_particles *p, size_t b, int group);
/* Whether it has members, and all are in the group. */
bool ts_rigid_all_in_group(const struct ts_rigid *r, const struct ts_particles *p, size_t b, int group);
/* Adds the force of an acceleration to all bodies with a member in the group; all deferred loops are done then, unless all
 * bodies are clumps. */
enum ts_status ts_rigid_accelerate(struct tsim *sim, int group, const double a[3]);

extern const struct ts_system_style ts_rigid_system;

#endif
