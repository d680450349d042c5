/* Pairs of the contact list by the indices of their particles. */
#include "library/library.h"

#include "contact/contact_view.h"
#include "core/ranks_pause.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status check_built(struct tsim *sim)
{
	TS_TRY(ts_ranks_require_all(sim, "pairs", NULL));
	if (!sim->neigh->wanted && !ts_sim_only(sim, TS_KIND_PAIR))
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "there is no contact list: no pair style and no other style needs one");
	if (ts_contacts_current(sim))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, NULL,
		       "pairs are known only after a run, and not if particles have been added or deleted "
		       "since; `run 0` finds them");
}

int tsim_pairs(struct tsim *sim, int32_t *pair, size_t room, size_t *n)
{
	TS_LIBRARY_NEEDS(sim, sim);
	TS_LIBRARY_NEEDS_ARRAY(sim, pair, room);
	TS_LIBRARY_NEEDS(sim, n);

	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	enum ts_status status = check_built(sim);

	*n = 0;
	for (size_t r = 0; status == TS_OK && r < list->n; r++) {
		size_t j = (size_t)list->j[r];

		if (!ts_contact_counts(sim, r, 0))
			continue;
		if (*n < room) {
			pair[2 * *n] = list->i[r];
			pair[2 * *n + 1] = j < p->n ? list->j[r] : p->ghost_owner[j - p->n];
		}
		++*n;
	}
	return ts_library_result(sim, status);
}
