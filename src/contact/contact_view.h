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
void ts_contact_view_of_bond(const struct tsim *sim, size_t b, struct ts_contact_view *view);

#endif
