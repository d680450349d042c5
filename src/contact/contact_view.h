/* Contacts and bonds as outputs show them: each pair once, the particle with the smaller identity first, with
 * the force between them and the vector along which it acts. */
#ifndef TS_CONTACT_CONTACT_VIEW_H
#define TS_CONTACT_CONTACT_VIEW_H

#include "neigh/neigh.h"
#include "particle/particles.h"

/* Whether the pairs of the contact list are of the particles that have their indices now. */
bool ts_contacts_current(const struct tsim *sim);

/* Fails if particles were added, deleted or reordered since contacts and bonds were computed last, so that
 * their indices are not valid. `self` is named in the message. */
enum ts_status ts_contacts_require(struct tsim *sim, const struct ts_instance *self);

/* Fails if the forces of contacts were not kept in the last step. A style that calls this requests them in
 * its init, by sim->neigh->keep_forces. */
enum ts_status ts_contacts_kept(struct tsim *sim, const struct ts_instance *self);
/* Both checks. */
enum ts_status ts_contacts_forces(struct tsim *sim, const struct ts_instance *self);

/* One pair of particles. */
struct ts_contact_view {
	size_t row; /* index of the contact or bond */
	size_t a, b;
	bool image;  /* a and b are in contact across a periodic face */
	double sign; /* +1: a is i of the candidate pair, -1: a is j */
	double d[3]; /* vector from b to a, across periodic faces, length */
	double distance;
	double force[3]; /* force on a */
};

/* Whether pair r of the contact list is to be output: both particles are in the group; of the two entries of
 * a pair across a periodic face, only one. */
bool ts_contact_counts(const struct tsim *sim, size_t r, int group);

/* A pair of the contact list. */
struct ts_contact_row {
	uint64_t pair; /* both identities, the smaller one first */
	int32_t image; /* ts_contact_image */
	size_t r;      /* its index */
};
/* Pairs of the contact list that are to be output, in the order of the identities of their particles, which does not depend
 * on how particles lie in memory. */
struct ts_contact_rows {
	struct ts_contact_row *row; /* [n]. Owned */
	size_t n;
};
/* touching: contacts only. */
enum ts_status ts_contact_rows(struct tsim *sim, int group, bool touching, struct ts_contact_rows *rows);
void ts_contact_rows_release(struct ts_contact_rows *rows);

void ts_contact_view(const struct tsim *sim, size_t r, struct ts_contact_view *view);
void ts_contact_view_of_bond(const struct tsim *sim, size_t b, struct ts_contact_view *view);

#endif
