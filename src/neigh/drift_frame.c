#include "neigh/drift_frame.h"

#include <math.h>

#include "base/clones.h"
#include "base/parallel.h"
#include "core/ranks.h"
#include "math/bounds.h"
#include "math/vec3.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct speeds_task {
	const struct ts_particles *p;
	const double *centre;
	double most2, most_relative2;
};

TS_CLONES static void largest_speeds(const struct ts_particles *p, const double centre[3], size_t from,
				     size_t to, double most[2])
{
	double most2 = 0, relative2 = 0;

	for (size_t i = from; i < to; i++) {
		const double *v = p->v[i];
		double a = v[0] - centre[0], b = v[1] - centre[1], c = v[2] - centre[2];
		double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2], r2 = a * a + b * b + c * c;

		most2 = v2 > most2 ? v2 : most2;
		relative2 = r2 > relative2 ? r2 : relative2;
	}
	most[0] = most2;
	most[1] = relative2;
}

static void speeds_share(void *context, size_t from, size_t to)
{
	struct speeds_task *t = context;
	double most[2];

	largest_speeds(t->p, t->centre, from, to, most);
#pragma omp critical(ts_drift_frame)
	{
		t->most2 = fmax(t->most2, most[0]);
		t->most_relative2 = fmax(t->most_relative2, most[1]);
	}
}

void ts_drift_frame_speeds(const struct tsim *sim, struct ts_drift_frame_speeds *out)
{
	const struct ts_particles *p = sim->particles;
	struct speeds_task t = { .p = p, .centre = out->centre };
	double lo[3], hi[3], range[6], most[2]; /* of the velocities; -lo and hi; squares of the speeds */
	int team = ts_team(sim, p->n);

	*out = (struct ts_drift_frame_speeds){ .most = 0 };
	ts_bounds(team, p->n, (const double(*)[3])p->v, lo, hi);
	for (int d = 0; d < 3; d++) {
		range[d] = -lo[d];
		range[3 + d] = hi[d];
	}
	ts_ranks_most_of(sim, range, 6);
	for (int d = 0; d < 3; d++) {
		lo[d] = -range[d];
		hi[d] = range[3 + d];
		/* not so if there are no particles, or speeds overflow */
		out->centre[d] = isfinite(lo[d] + hi[d]) ? 0.5 * (lo[d] + hi[d]) : 0;
	}
	ts_parallel(team, p->n, speeds_share, &t);
	most[0] = t.most2;
	most[1] = t.most_relative2;
	ts_ranks_most_of(sim, most, 2);
	out->most = sqrt(most[0]);
	out->most_relative = sqrt(most[1]);
}

/* At most this part of the speed remains. */
static const double PAYS_BELOW = 0.75;

bool ts_drift_frame_pays(const struct ts_drift_frame_speeds *speeds)
{
	return speeds->most_relative < PAYS_BELOW * speeds->most;
}

void ts_drift_frame_advance(struct ts_drift_frame *frame, double dt, double skin)
{
	double next[3];

	for (int d = 0; d < 3; d++)
		next[d] = frame->shift[d] + dt * frame->velocity[d];
	if (ts_dot(next, next) <= 0.25 * skin * skin)
		ts_scale(1, next, frame->shift);
}

double ts_drift_frame_room_of_walls(const struct tsim *sim)
{
	return 0.5 * sim->neigh->built_skin - ts_norm(sim->neigh->frame.shift);
}
