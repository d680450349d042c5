/* What a mesh that presses on particles will feel: stiffness and damping of its contacts under a load, for
 * the gains of a controller. */
#ifndef TS_WALL_SERVO_RESPONSE_H
#define TS_WALL_SERVO_RESPONSE_H

#include "wall/mesh_wall.h"

/* A controlled mesh. Along an axis load, stiffness and damping are those of the force; about an axis those
 * of the torque by the speed and the way at `lever`, with contacts at `arm` from the axis. */
struct ts_servo_mesh {
	const struct ts_mesh_surface *surface;
	double axis[3];	   /* unit vector */
	double load;	   /* > 0: force or torque that is aimed at */
	double lever, arm; /* 0: force */
};

struct ts_servo_contacts {
	double n; /* so many, of equal load; 0: there is no law or no particle */
	double stiffness, damping;
};

/* Of n contacts with the smallest particles there are, or that will be inserted: of the type for which K h
 * + 2 C is `most`, or least. */
struct ts_servo_contacts ts_servo_contacts(const struct tsim *sim, const struct ts_servo_mesh *mesh, double n,
					   bool most);
/* How many particles touch the mesh now. */
size_t ts_servo_touching(const struct tsim *sim, const struct ts_mesh_surface *surface);
/* How many there may be at most: one for each square around the smallest on the mesh as seen along the
 * axis, and not more than there are. */
double ts_servo_room(const struct tsim *sim, const struct ts_servo_mesh *mesh);

#endif
