/* Stiffness and damping of the contacts of a mesh with particles under a load, for the gains of a
 * controller. */
#ifndef TS_LOAD_SERVO_RESPONSE_H
#define TS_LOAD_SERVO_RESPONSE_H

#include "mesh/mesh_surface.h"
#include "wall/wall.h"

/* A controlled mesh. Force control: load, stiffness and damping refer to the force along the axis. Torque
 * control: they refer to the torque about the axis as a function of displacement and speed at the distance
 * `lever` from the axis, with contacts at the distance `arm`. */
struct ts_servo_mesh {
	const struct ts_mesh_surface *surface;
	double axis[3];	   /* unit vector */
	double load;	   /* target force or torque, > 0 */
	double lever, arm; /* length; 0: force control */
};

struct ts_servo_contacts {
	double n;		   /* number of contacts, of equal load; 0: there is no law or no particle */
	double stiffness, damping; /* of all contacts together: load/length, load/velocity */
};

/* Response of n contacts with the smallest particles that exist or will be inserted, of the particle type for
 * which K h + 2 C (K stiffness, C damping, h time step) is largest (`most`) or smallest. */
struct ts_servo_contacts ts_servo_contacts(const struct tsim *sim, const struct ts_servo_mesh *mesh, double n,
					   bool most);
/* Number of particles that touch the mesh now. */
size_t ts_servo_touching(const struct tsim *sim, const struct ts_mesh_surface *surface);
/* Estimate of the largest number of contacts: A/(4 R^2), with A the area of the mesh projected along the
 * axis (for torque control its area) and R the smallest radius; without insertion not more than there are
 * particles. */
double ts_servo_most_contacts(const struct tsim *sim, const struct ts_servo_mesh *mesh);

#endif
