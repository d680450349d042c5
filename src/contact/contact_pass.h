/* A pass over the active pairs: something is computed for each pair, stored in its slot, and summed over the
 * particles. The forces are such a pass. Another one, such as conduction of heat, can be fused with it block
 * by block, while the data are in the cache. */
#ifndef TS_CONTACT_CONTACT_PASS_H
#define TS_CONTACT_CONTACT_PASS_H

#include "base/parallel.h"
#include "neigh/contact_list.h"

struct ts_contacts_pass {
	ts_range_fn *compute; /* computes the active pairs of the blocks from .. to-1 */
	ts_range_fn *sum;     /* sums over the particles from .. to-1, all of whose pairs are computed */
	void *context;	      /* argument of both functions; shared by the threads */
	bool sum_all;	      /* `sum` is called also for particles without active pairs */
};

/* A pass that is fused with that of the forces, if there are candidate pairs. Touching pairs come first in
 * each block. */
struct ts_fused_pass {
	struct ts_contacts_pass pass;
	/* called after slots have been assigned, before the first block */
	enum ts_status (*start)(struct tsim *sim, void *context);
	bool begun; /* the pass has been started in this step */
};

/* Fuses a pass with the forces of this step; to be called in PRE_FORCE, by one style at most. */
void ts_contacts_fuse(struct tsim *sim, struct ts_fused_pass *pass);

/* Executes the pass of the forces over the contact list of the simulation, and the fused one. */
enum ts_status ts_contacts_compute(struct tsim *sim, const struct ts_contacts_pass *forces);

#endif
