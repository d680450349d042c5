#include "neigh/leaving.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "neigh/neigh.h"
#include "particles/domain.h"
#include "particles/exchange.h"
#include "particles/particles.h"

#include "base/banned.h"

bool ts_leaving_apart(const struct tsim *sim)
{
	return sim->particles->lost_policy == TS_LOST_IGNORE && sim->particles->xseen &&
	       ts_neigh_all_fixed(sim);
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

struct watch {
	const struct ts_particles *p;
	double far2;
	long *moved;
};

TS_CLONES static void share(void *context, size_t from, size_t to)
{
	const struct watch w = *(const struct watch *)context;
	const double *restrict x = w.p->x[0], *restrict seen = w.p->xseen[0];
	int64_t moved = 0;

#pragma omp simd reduction(+ : moved)
	for (size_t i = from; i < to; i++) {
		double a = x[3 * i] - seen[3 * i], b = x[3 * i + 1] - seen[3 * i + 1];
		double c = x[3 * i + 2] - seen[3 * i + 2];

		moved += a * a + b * b + c * c > w.far2;
	}
#pragma omp atomic
	*w.moved += (long)moved;
}

void ts_leaving_watch(struct tsim *sim, long *moved)
{
	double half = 0.5 * sim->neigh->given_skin;
	struct watch w = { sim->particles, half * half, moved };

	if (ts_leaving_apart(sim) && sim->neigh->built_skin > sim->neigh->given_skin)
		TS_SWEEP_ADD(sim, sim->particles->n, share, &w);
}

bool ts_leaving_due(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double far2 = 0, skin = sim->neigh->given_skin, lo[3], hi[3];
	bool left = false;

	ts_exchange_fixed(sim, lo, hi);
	for (size_t i = 0; i < p->n; i++) {
		double moved2 = 0;

		for (int d = 0; d < 3; d++) {
			double step = p->x[i][d] - p->xhold[i][d];

			moved2 += step * step;
			left |= p->x[i][d] < lo[d] || p->x[i][d] > hi[d];
		}
		far2 = moved2 > far2 ? moved2 : far2;
	}
	ts_leaving_hold(sim);
	return left || 2 * sqrt(far2) + 1.08 * skin > sim->neigh->built_skin;
}
