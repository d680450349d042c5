/* Contact history by the identities of the partners: carries it over a rebuild of the contact list and to
 * restart files. */
#ifndef TS_NEIGH_CONTACT_HISTORY_H
#define TS_NEIGH_CONTACT_HISTORY_H

#include "core/carried.h"
#include "neigh/contact_list.h"

enum { TS_HISTORY_OTHER_SIDE = 1 << 30 }; /* see the winding of a key */
enum { TS_HISTORY_TORQUE = 7 };		  /* numbers that the torques of a contact depend on */

struct ts_contact_history {
	size_t n, width;
	struct ts_contact_key {
		int32_t tag[2]; /* identities, the smaller first */
		/* image of the larger seen from the smaller (ts_winding), and which of two entries across a
		 * periodic face */
		int32_t winding;
	} * key;
	/* history, `width` numbers each, with the signs as seen from the smaller identity */
	double *value;
	double (*force)[3]; /* force on the smaller identity; NULL: forces are not saved */
	/* with the forces, if the laws have torques: half the overlap, the tangential torque for a lever arm of 1, the rolling
	 * torque on the smaller identity */
	double (*torque)[TS_HISTORY_TORQUE];
	bool lent;	  /* `key` and `value` are in memory of the list, and not to be freed */
	bool overlapping; /* only pairs that overlap now get their history back */
	bool parted;	  /* all get it back, and those that overlap now touch */
};

/* Copies the history of the touching pairs, and on request their forces: a run that continues with the forces
 * of the last step outputs the contacts of that step. `of`: only pairs of these particles; NULL: all. */
enum ts_status ts_contact_history_save(struct tsim *sim, struct ts_contact_list *list, bool forces,
				       const struct ts_leaving *of, struct ts_contact_history *h);
/* The same as LIGGGHTS does it: copies the history of all pairs that have any, also of those that have
 * parted; it is given back only to pairs that overlap then, or, where lists are made again between rebuilds, to all. */
enum ts_status ts_contact_history_save_all(struct tsim *sim, struct ts_contact_list *list, bool forces,
					   const struct ts_leaving *of, struct ts_contact_history *h);
/* The one or the other, for the next list: the copy is in memory of the list that serves again when active pairs are chosen, so
 * that it takes no more; until then it must have been restored. */
enum ts_status ts_contact_history_carry(struct tsim *sim, struct ts_contact_list *list, bool forces,
					struct ts_contact_history *h);
/* Copies the history, and the forces if saved, to the pairs of the same particles in the list. */
enum ts_status ts_contact_history_restore(struct tsim *sim, const struct ts_contact_history *h,
					  struct ts_contact_list *list);
/* Moves the contacts of `more`, saved without forces, into h. */
enum ts_status ts_contact_history_append(struct tsim *sim, struct ts_contact_history *h,
					 struct ts_contact_history *more);
void ts_contact_history_release(struct ts_contact_history *h);
/* Writes to or reads from a restart file. */
enum ts_status ts_contact_history_archive(struct ts_archive *archive, struct tsim *sim,
					  struct ts_contact_history *h);

#endif
