/* Carries the history columns of touching rows over a rebuild, by the identities of the partners.
 */
#ifndef TS_NEIGH_CONTACT_HISTORY_H
#define TS_NEIGH_CONTACT_HISTORY_H

#include "neigh/contact_list.h"

struct ts_contact_history {
	size_t n, width;
	struct ts_contact_key {
		int32_t tag[2];	 /* smaller first */
		int32_t winding; /* of the larger, seen from the smaller, and which row */
	} * key;
	double *value;	    /* width numbers each, as seen from the smaller tag */
	double (*force)[3]; /* on the smaller tag; NULL: not kept */
	bool overlapping;   /* only rows whose partners overlap now get it */
};

/* Copies out the history of the touching rows, and if asked their forces: a run that goes on with
 * the forces of the last step shows the contacts of that step. */
enum ts_status ts_contact_history_take(struct tsim *sim, struct ts_contact_list *list, bool forces,
				       struct ts_contact_history *h);
/* As LIGGGHTS: of all rows that remember something, also those that have parted, for such as overlap when
 * it is given. */
enum ts_status ts_contact_history_take_memories(struct tsim *sim, struct ts_contact_list *list, bool forces,
						struct ts_contact_history *h);
/* Gives it to the rows of the same partners. */
enum ts_status ts_contact_history_give(struct tsim *sim, const struct ts_contact_history *h,
				       struct ts_contact_list *list);
void ts_contact_history_release(struct ts_contact_history *h);
/* Restart files. */
enum ts_status ts_contact_history_archive(struct ts_archive *archive, struct tsim *sim,
					  struct ts_contact_history *h);

#endif
