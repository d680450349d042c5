#include "neigh/leaving.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "box/domain.h"
#include "math/vec3.h"
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
	if (sim->particles->lost_policy != TS_LOST_IGNORE || sim->legacy || sim->neigh->fixed_skin)
		return TS_OK;
	return ts_particles_need(sim, 1u << TS_COL_XSEEN);
}

void ts_leaving_hold(struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	if (ts_leaving_apart(sim) && p->n)
		memcpy(p->xseen, p->x, p->n * sizeof *p->xseen);
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

	if (ts_leaving_apart(sim) && sim->neigh->built_skin > sim->neigh->given_skin)
		TS_DEFER_LOOP(sim, sim->particles->n, count_moved_share, &w);
}

/* Room that each check takes of the skin, in units of the given skin: more than 1, as a check comes in the
 * step after half of it has been passed; NEXT_CHECK_ROOM, for the decision whether another check fits, is a
 * little less than what was provided. */
static const double CHECK_ROOM = 1.1, NEXT_CHECK_ROOM = 1.08;

double ts_leaving_skin(double given, double wanted)
{
	return CHECK_ROOM * given * ceil(wanted / given);
}

bool ts_leaving_due(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double far2 = 0, skin = sim->neigh->given_skin;
	bool left = false;

	for (size_t i = 0; i < p->n; i++) {
		left |= ts_exchange_left(&sim->domain->box, p->x[i]) >= 0;
		far2 = fmax(far2, ts_distance2(p->x[i], p->xhold[i]));
	}
	ts_leaving_hold(sim);
	return left || 2 * sqrt(far2) + NEXT_CHECK_ROOM * skin > sim->neigh->built_skin;
}
