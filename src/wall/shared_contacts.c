#include "wall/shared_contacts.h"

#include "base/sort.h"
#include "core/ranks.h"
#include "core/report.h"

#include "base/banned.h"

static enum ts_status pack(const struct tsim *sim, const struct ts_wall *w, struct ts_parcel *mine)
{
	struct ts_shared_contact *row =
		(struct ts_shared_contact *)(void *)ts_parcel_extend(mine, w->nlisted * sizeof *row);

	for (size_t at = 0; row && at < w->nlisted; at++) {
		row[at] = (struct ts_shared_contact){ .surface = w->touching[at].surface,
						      .rank = sim->world->rank,
						      .conducts = at >= w->ntouching };
		ts_surface_contact_of(sim, w, w->touching[at].k, &row[at].contact);
	}
	return row ? TS_OK : TS_NOMEM;
}

/* Appends the shared rows of one sort to the first n of the list; returns their number. A particle has all its contacts on one
 * rank, in the order of its list, which equal keys keep. */
static size_t append_sorted(struct ts_wall *w, size_t n, bool conducts)
{
	const struct ts_shared_contact *row = (const struct ts_shared_contact *)(const void *)w->shared.data;
	size_t from = n;

	for (size_t k = 0; k < w->shared.n / sizeof *row; k++)
		if (row[k].conducts == conducts)
			w->touching[n++] =
				(struct ts_wall_touching){ row[k].surface, (int32_t)row[k].contact.element,
							   row[k].contact.tag, k };
	ts_sort(w->touching + from, n - from, sizeof *w->touching, ts_wall_touching_order);
	return n;
}

enum ts_status ts_shared_contacts_make(struct tsim *sim, struct ts_wall *w)
{
	struct ts_parcel mine = { 0 };
	enum ts_status status = pack(sim, w, &mine);
	struct ts_shared_contact *row;
	size_t n;

	w->shared.n = w->ntouching = w->nlisted = 0;
	w->shares = true;
	if (status == TS_OK)
		status = ts_world_share(sim->world, &mine, &w->shared);
	ts_parcel_release(&mine);
	n = w->shared.n / sizeof *row;
	if (status != TS_OK || TS_GROW(w->touching, w->touching_capacity, n) != TS_OK)
		return ts_nomem(&sim->error);
	row = (struct ts_shared_contact *)(void *)w->shared.data;
	for (size_t k = 0; k < n; k++)
		if (row[k].rank != sim->world->rank)
			row[k].contact.particle = SIZE_MAX;
	w->ntouching = append_sorted(w, 0, false);
	w->nlisted = append_sorted(w, w->ntouching, true);
	return TS_OK;
}

enum ts_status ts_shared_contacts_find(struct tsim *sim, const struct ts_instance *surface)
{
	struct ts_wall *w;

	for (size_t at = 0; sim->division && (w = ts_walls_next(sim, &at, NULL));)
		if (!w->shares && ts_wall_find_surface(w, surface) != SIZE_MAX)
			TS_TRY(ts_shared_contacts_make(sim, w));
	return TS_OK;
}

/* ---- plan ---- */

static size_t count_touching(const struct tsim *sim, const struct ts_wall *w)
{
	size_t n = 0;

	for (size_t k = 0; k < w->contacts.n; k++) {
		struct ts_wall_place place;
		int type;

		ts_wall_place(w, k, &place);
		n += w->observers[place.surface] &&
		     w->shape->distance(w, sim, k, &type) < sim->particles->radius[w->contacts.row[k]];
	}
	return n;
}

void ts_shared_contacts_plan(const struct tsim *sim, const struct ts_wall *w, struct ts_plan_report *report)
{
	if (w->observed && ts_ranks(sim) > 1)
		ts_report_line(report, "shared contacts",
			       "all ranks get those with wall %s where its load is printed, in each step "
			       "where the load moves or wears it: now %zu, %zu bytes each",
			       w->by->id, count_touching(sim, w), sizeof(struct ts_shared_contact));
}
