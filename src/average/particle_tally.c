#include "average/particle_tally.h"

#include <string.h>

#include "math/exactsum.h"
#include "particle/particles.h"
#include "particle/rank_sums.h"

#include "base/banned.h"

enum ts_status ts_particle_tally_start_unset(struct tsim *sim, struct ts_particle_tally *tally)
{
	TS_TRY(ts_particle_tally_start_empty(sim, tally));
	tally->n = sim->particles->n;
	return TS_OK;
}

enum ts_status ts_particle_tally_start(struct tsim *sim, struct ts_particle_tally *tally)
{
	TS_TRY(ts_particle_tally_start_unset(sim, tally));
	if (tally->n)
		memset(tally->note, 0, tally->n * sizeof *tally->note);
	return TS_OK;
}

enum ts_status ts_particle_tally_start_empty(struct tsim *sim, struct ts_particle_tally *tally)
{
	if (TS_GROW(tally->note, tally->capacity, sim->particles->n) != TS_OK)
		return ts_nomem(&sim->error);
	tally->n = 0;
	tally->fresh = true;
	return TS_OK;
}

double (*ts_particle_tally_append(struct ts_particle_tally *tally, size_t members))[TS_PARTICLE_TALLY_MOST]
{
	size_t first;

#pragma omp atomic capture
	{
		first = tally->n;
		tally->n += members;
	}
	return tally->note + first;
}

const double *ts_particle_tally_sums(struct ts_particle_tally *tally)
{
	for (size_t k = 0; tally->fresh && k < TS_PARTICLE_TALLY_MOST; k++)
		tally->sum[k] =
			tally->n ? ts_exactsum_of(&tally->note[0][k], tally->n, TS_PARTICLE_TALLY_MOST) : 0;
	tally->fresh = false;
	return tally->sum;
}

enum ts_status ts_particle_tally_join(struct ts_instance *self, struct tsim *sim)
{
	return ts_particle_tally_merge(self->state, sim);
}

enum ts_status ts_particle_tally_merge(struct ts_particle_tally *tally, struct tsim *sim)
{
	if (!tally->fresh)
		return TS_OK;
	TS_TRY(ts_rank_sums(sim, (const double *)tally->note, tally->n, TS_PARTICLE_TALLY_MOST,
			    TS_PARTICLE_TALLY_MOST, tally->sum));
	tally->fresh = false;
	return TS_OK;
}

void ts_particle_tally_release(struct ts_particle_tally *tally)
{
	ts_free(tally->note);
	*tally = (struct ts_particle_tally){ 0 };
}

enum ts_status ts_particle_tally_archive(struct ts_archive *archive, struct ts_particle_tally *tally)
{
	if (ts_archive_writing(archive))
		ts_particle_tally_sums(tally);
	else if (!ts_archive_has(archive, "tally"))
		return TS_OK; /* restart files of version 1 have no tally */
	return ts_archive_fixed(archive, "tally", TS_SAVED_F64, tally->sum, TS_PARTICLE_TALLY_MOST);
}
