#include "neigh/leaving.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/parallel.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "neigh/neigh.h"
#include "particle/columns.h"
#include "particle/exchange.h"
#include "particle/particles.h"

#include "base/banned.h"

bool ts_leaving_apart(const struct tsim *sim)
{
	return sim->particles->lost_policy == TS_LOST_IGNORE && sim->particles->xseen &&
	       ts_domain_all_fixed(sim);
}

enum ts_status ts_leaving_init(struct tsim *sim)
{
	if (sim->particles->lost_policy != TS_LOST_IGNORE || sim->legacy == TS_LEGACY_LIGGGHTS ||
	    sim->neigh->fixed_skin)
		return TS_OK;
	return ts_particles_need(sim, 1u << TS_COL_XSEEN);
}

static void hold_share(void *context, size_t from, size_t to)
{
	struct ts_particles *p = context;

	if (to > from)
		memcpy(p->xseen + from, p->x + from, (to - from) * sizeof *p->xseen);
}

void ts_leaving_hold(struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	if (ts_leaving_apart(sim))
		ts_parallel(ts_team(sim, p->n), p->n, hold_share, p);
}

struct watch_task {
	const struct ts_particles *p;
	double far2;
	long *moved;
};

TS_CLONES static void count_moved_share(void *context, size_t from, size_t to)
{
	const struct watch_task w = *(const struct watch_task *)context;
	const double *restrict x = w.p->x[0], *restrict seen = w.p->xseen[0];
	int64_t moved = 0;

#pragma omp simd reduction(+ : moved)
	for (size_t i = from; i < to; i++) {
		double a = x[3 * i] - seen[3 * i], b = x[3 * i + 1] - seen[3 * i + 1];
		double c = x[3 * i + 2] - seen[3 * i + 2];

		moved += a * a + b * b + c * c > w.far2;
	}
	if (!moved)
		return;
#pragma omp atomic
	*w.moved += (long)moved;
}

void ts_leaving_watch(struct tsim *sim, long *moved)
{
	double half = 0.5 * sim->neigh->given_skin;
	struct watch_task w = { sim->particles, half * half, moved };

	if (sim->neigh->leaving_watched)
		TS_DEFER_LOOP(sim, sim->particles->n, count_moved_share, &w);
}

/* Where walls move, rebuilds are due when they have moved half of the skin in use, too. */
static const double ROOM = 1.1;

double ts_leaving_skin(double given, double wanted)
{
	return ROOM * given * ceil(wanted / given);
}

bool ts_leaving_search(struct tsim *sim)
{
	bool left = ts_exchange_some_left(sim);

	ts_leaving_hold(sim);
	return ts_ranks_most(sim, left) > 0;
}
