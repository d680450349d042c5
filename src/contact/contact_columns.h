/* Columns of computes pair/gran/local and wall/gran/local, in the order of LIGGGHTS. */
#ifndef TS_CONTACT_CONTACT_COLUMNS_H
#define TS_CONTACT_CONTACT_COLUMNS_H

#include "core/name_list.h"
#include "law/granular_force.h"

/* Quantities of a contact, seen from the first particle. At a wall the particle is the second partner, and
 * the quantities are seen from it. */
struct ts_contact_facts {
	double pos[6], vel[6]; /* positions and velocities of both partners: length, velocity */
	/* identities, and 1 if across a periodic face; at a wall: mesh, triangle, particle */
	double id[3];
	double force[3];  /* force on the first particle; at a wall on the particle */
	double n[3];	  /* unit normal, along which `force` is split into normal and tangential part */
	double torque[3]; /* torque of the tangential force about the centre, without rolling friction */
	double history[TS_GRANULAR_MEMORY];
	double area, delta, point[3];
	double heat; /* heat conducted into the first particle, energy/time */
};

enum { TS_CONTACT_COLUMNS = 12, TS_CONTACT_HEAT = TS_CONTACT_COLUMNS - 1 };

/* First member of the states of both computes. */
struct ts_contact_columns {
	struct ts_words words; /* argument of the compute */
	struct ts_name_list list;
	bool wanted[TS_CONTACT_COLUMNS];
};
#define TS_FAMILY_CONTACTS "contacts"

extern const char ts_contact_columns_help[];
enum ts_status ts_contact_columns_init(struct ts_instance *self, struct tsim *sim);
/* Number of columns, where the contact law has `history` history numbers. */
size_t ts_contact_columns_width(const struct ts_contact_columns *columns, size_t history);
/* Slot `width` of styles whose state begins with the columns; 0 if it depends on the contact law. */
size_t ts_contact_columns_known_width(const struct ts_instance *self);
void ts_contact_columns_write(const struct ts_contact_columns *columns, size_t history,
			      const struct ts_contact_facts *facts, double *out);
/* Contact area, length^2: of the circle in which two spheres of radii a and b intersect; in which a sphere
 * and a plane intersect. */
double ts_contact_area(double a, double b, double distance);
double ts_contact_area_plane(double radius, double distance);

/* For files: the columns grouped into named arrays, one after the other. */
struct ts_contact_array {
	const char *name;
	size_t first, components; /* first column and number of columns */
};
enum { TS_CONTACT_ARRAYS = 15 };
/* *pos: first column of both positions, SIZE_MAX if they are not output. Returns the number of other arrays.
 */
size_t ts_contact_columns_arrays(const struct ts_contact_columns *columns, size_t width,
				 struct ts_contact_array array[TS_CONTACT_ARRAYS], size_t *pos);

#endif
