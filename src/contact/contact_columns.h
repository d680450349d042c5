/* The columns of computes pair/gran/local and wall/gran/local, in the order of LIGGGHTS. */
#ifndef TS_CONTACT_CONTACT_COLUMNS_H
#define TS_CONTACT_CONTACT_COLUMNS_H

#include "core/name_list.h"
#include "law/granular_force.h"

/* What can be said of a contact, seen from the first partner; of a wall and a particle, from the particle,
 * which then is the second. */
struct ts_contact_facts {
	double pos[6], vel[6]; /* of both */
	double id[3];	       /* identities and whether across a periodic face; mesh, triangle, particle */
	double force[3];       /* on the first; on the particle */
	double n[3];	       /* unit vector along which `force` has its normal part */
	double torque[3];      /* by the tangential force about the centre, without rolling friction */
	double history[TS_GRANULAR_MEMORY];
	double area, delta, point[3];
	double heat; /* per time into the first, by conduction */
};

enum { TS_CONTACT_COLUMNS = 12, TS_CONTACT_HEAT = TS_CONTACT_COLUMNS - 1 };

/* First member of the states of the computes. */
struct ts_contact_columns {
	struct ts_words words; /* argument */
	struct ts_name_list list;
	bool wanted[TS_CONTACT_COLUMNS];
};
#define TS_FAMILY_CONTACTS "contacts"

extern const char ts_contact_columns_help[];
enum ts_status ts_contact_columns_init(struct ts_instance *self, struct tsim *sim);
/* How many numbers a row has, where contacts remember `history` numbers. */
size_t ts_contact_columns_width(const struct ts_contact_columns *columns, size_t history);
void ts_contact_columns_write(const struct ts_contact_columns *columns, size_t history,
			      const struct ts_contact_facts *facts, double *out);
/* Area of the circle in which two spheres meet; in which a sphere meets a plane. */
double ts_contact_area(double a, double b, double distance);
double ts_contact_area_plane(double radius, double distance);

/* For files: the columns as arrays with names of their own, one after the other. */
struct ts_contact_array {
	const char *name;
	size_t first, components; /* columns of the row */
};
enum { TS_CONTACT_ARRAYS = 15 };
/* *pos: first column of the places of both, SIZE_MAX: they are not among them. Returns the number of
 * others. */
size_t ts_contact_columns_arrays(const struct ts_contact_columns *columns, size_t width,
				 struct ts_contact_array array[TS_CONTACT_ARRAYS], size_t *pos);

#endif
