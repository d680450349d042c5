/* Rigid bodies made of particles that keep their places in it.
 *
 * A system: bodies are integrated as soon as there are some, by velocity Verlet for the centre of mass
 * and for the angular momentum, the orientation as math/rigid_turn.h says. Members touch others
 * like all particles, but not each other, with the mass of the whole body; what acts on them acts on the
 * body. A body whose member is lost or deleted is deleted as a whole. */
#ifndef TS_RIGID_RIGID_H
#define TS_RIGID_RIGID_H

#include "core/sim.h"
#include "particle/particles.h"

struct ts_body {
	double mass;
	double inertia[3]; /* principal moments about the centre of mass */
	double q[4];	   /* orientation of the principal axes */
	double x[3], v[3]; /* of the centre of mass; not wrapped into the box */
	double spin[3];	   /* angular momentum */
	double omega[3];
	double force[3], torque[3]; /* of the last step */
	double external[3];	    /* force on the body itself in this step (gravity) */
	double free[6];		    /* 1: moves along, turns about x, y, z; 0: does not */
	double density;		    /* of its material, or 0 */
	double kind;		    /* a clump: number of its template; else 0 */
};

/* Rows of saved state for a body that is a field of a style's state. */
#define TS_SAVED_BODY(T, f)                                                                          \
	TS_SAVE_F64(T, f.mass), TS_SAVE_F64(T, f.inertia), TS_SAVE_F64(T, f.q), TS_SAVE_F64(T, f.x), \
		TS_SAVE_F64(T, f.v), TS_SAVE_F64(T, f.spin), TS_SAVE_F64(T, f.omega),                \
		TS_SAVE_F64(T, f.force), TS_SAVE_F64(T, f.torque), TS_SAVE_F64(T, f.external),       \
		TS_SAVE_F64(T, f.free), TS_SAVE_F64(T, f.density), TS_SAVE_F64(T, f.kind)

enum { TS_BODY_NUMBERS = sizeof(struct ts_body) / sizeof(double) }; /* nothing else is in it */

struct ts_rigid {
	size_t n;
	struct ts_body *body; /* in the order of their ids */
	int32_t *id;
	int32_t *size;	/* how many members it was made of */
	int64_t *owner; /* the fix that made it: ts_rigid_owner */
	size_t body_capacity, id_capacity, size_capacity, owner_capacity;
	int32_t last_id;

	/* rows of the members of body b: member[start[b]] .. member[start[b + 1] - 1], by identity */
	int32_t *member;
	size_t *start;
	size_t member_capacity, start_capacity;
	/* the bodies as their members follow each other in memory; those without members are not there */
	int32_t *order;
	size_t ordered, order_capacity;
	uint64_t generation; /* of the particles, as the members were listed; 0: not listed */
	/* Refuses members, in rows[0..n-1], that fixes would move, too; set by the integrators. */
	enum ts_status (*check_members)(struct tsim *sim, const int32_t *row, size_t n);
};

/* A number for the fix of this id; its bodies come apart when it is gone. */
int64_t ts_rigid_owner(const char *fix);

/* Makes the particles of these rows members of a new body. Its mass, moments, orientation, centre and
 * motion are given; the members' motion follows. */
enum ts_status ts_rigid_add(struct tsim *sim, const struct ts_body *body, int64_t owner, const int32_t *row,
			    size_t n);
/* Its bodies come apart; the particles stay. */
enum ts_status ts_rigid_dissolve(struct tsim *sim, int64_t owner);

/* The same for all bodies whose fix is gone. Done before steps, not as soon as it goes: after a restart
 * the bodies are there before the script has their fix. */
enum ts_status ts_rigid_dissolve_orphans(struct tsim *sim);

/* Whether the fix with this number is there. */
bool ts_rigid_owner_lives(const struct tsim *sim, int64_t owner);

/* Members left of bodies that are no longer whole are deleted, and their bodies. The members are listed. */
enum ts_status ts_rigid_drop_incomplete(struct tsim *sim);

/* Lists the members anew if particles have moved in memory. */
enum ts_status ts_rigid_list(struct tsim *sim);

/* Particle i belongs to a body; a and b, to the same one. */
static inline bool ts_rigid_member(const struct ts_particles *p, size_t i)
{
	return p->body && p->body[i];
}
static inline bool ts_rigid_same(const struct ts_particles *p, size_t a, size_t b)
{
	return p->body && p->body[a] && p->body[a] == p->body[b];
}

/* The body that particle i belongs to, or NULL. */
const struct ts_body *ts_rigid_body_of(const struct tsim *sim, size_t i);

/* The density of what particle i is made of: mass by volume, in a clump that of the clump's material, as
 * its overlapping spheres share the mass. */
double ts_rigid_material_density(const struct tsim *sim, size_t i);

/* An acceleration of the bodies of which a member is in the group. */
enum ts_status ts_rigid_accelerate(struct tsim *sim, int group, const double a[3]);

extern const struct ts_system_style ts_rigid_system;

#endif
