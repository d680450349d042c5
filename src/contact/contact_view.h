/* Contacts and bonds as outputs look at them: each pair once, the partner with the smaller identity
 * first, with the force between them and the vector along which it acts. */
#ifndef TS_CONTACT_CONTACT_VIEW_H
#define TS_CONTACT_CONTACT_VIEW_H

#include "neigh/neigh.h"
#include "particle/particles.h"

/* Refuses to speak of contacts, or of the forces of bonds, where particles were added, deleted or moved in
 * memory since they were found. `what` for the message: "compute stress/atom". */
enum ts_status ts_contacts_require(struct tsim *sim, const struct ts_instance *self);

/* Refuses to speak of the forces of contacts where they were not kept. Whoever asks says so in its init, by
 * sim->neigh->shown. */
enum ts_status ts_contacts_kept(struct tsim *sim, const struct ts_instance *self);
/* Both. */
enum ts_status ts_contacts_forces(struct tsim *sim, const struct ts_instance *self);

/* One pair. a, b: rows of the particle columns, b perhaps a ghost's original. */
struct ts_contact_view {
	size_t row; /* of contact rows or bonds */
	size_t a, b;
	bool image;  /* a and b meet across a periodic face */
	double sign; /* +1: a is the row's first partner, -1: its second */
	double d[3]; /* from b to a, images taken into account */
	double distance;
	double force[3]; /* on a */
};

/* Row r is a pair of the group that is to be counted: of the two rows across a periodic face, one. */
bool ts_contact_counts(const struct tsim *sim, size_t r, int group);
void ts_contact_view(const struct tsim *sim, size_t r, struct ts_contact_view *view);
void ts_bond_view(const struct tsim *sim, size_t b, struct ts_contact_view *view);

/* Half the sum over the contacts and the bonds of particle i of d_a F_b, d the vector from the partner and
 * F its force on i, for ab = xx, yy, zz, xy, xz, yz: the particle's part of the virial. */
struct ts_virial_parts {
	bool kinetic, pair, bond;
};
void ts_virial_of(const struct tsim *sim, size_t i, const struct ts_virial_parts *parts, double w[6]);
/* The sum over all particles. */
void ts_virial_total(const struct tsim *sim, const struct ts_virial_parts *parts, double out[6]);
/* Pressures are by the volume of the box, in two dimensions its area; and the mean of their diagonal. */
double ts_pressure_volume(const struct tsim *sim);
double ts_pressure_mean(const struct tsim *sim, const double tensor[6]);
/* Words ke, pair, bond, fix, virial ... ; none: all. */
enum ts_status ts_virial_read(struct tsim *sim, const struct ts_instance *self, struct ts_words words,
			      struct ts_virial_parts *parts);

#endif
