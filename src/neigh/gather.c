#include "neigh/gather.h"

#include "base/clones.h"
#include "base/four.h"
#include "base/parallel.h"
#include "particles/particles.h"

#include "base/banned.h"

struct task {
	const struct ts_gather *gather;
	const double (*force)[3];
	double (*f)[3];
};

TS_CLONES static void share(void *context, size_t from, size_t to)
{
	static const double signs[] = { 1, -1 }; /* a table: which side cannot be guessed */
	const struct task t = *(const struct task *)context;

	for (size_t i = from; i < to; i++) {
		ts_four f = { 0 };

		for (size_t k = t.gather->first[i]; k < t.gather->first[i + 1]; k++) {
			uint32_t entry = t.gather->entry[k];

			f += signs[entry & 1] * TS_FOUR_AT(t.force[entry >> 1]);
		}
		for (int d = 0; d < 3; d++)
			t.f[i][d] += f[d];
	}
}

void ts_gather_forces(struct tsim *sim, const struct ts_gather *gather, const double (*force)[3])
{
	struct task task = { gather, force, sim->particles->f };

	ts_parallel(ts_team(sim, sim->particles->n), sim->particles->n, share, &task);
}

void ts_gather_release(struct ts_gather *gather)
{
	ts_free(gather->first);
	ts_free(gather->entry);
	*gather = (struct ts_gather){ 0 };
}
