#include "base/clones.h"
TS_UNROLLED

#include "contact/contact_sums.h"

#include <string.h>

#include "base/eight.h"
#include "neigh/touching_sums.h"

#include "base/banned.h"

/* Force and torque of a particle as one vector of eight numbers, so that both are summed at once. */
#define EIGHT(x) ((ts_eight){ x, x, x, x, x, x, x, x })

/* Adds a result to the force and torque of a particle; entry: 2 slot + side; `parts` as in struct ts_contact_list. */
TS_INLINE void add_result(ts_eight *sum, const ts_eight *radius, const ts_four *results, size_t parts,
			  uint32_t entry)
{
	/* a table instead of a branch: the branch would be mispredicted half of the time */
	static const ts_eight signs[] = { { 1, 1, 1, 1, 1, 1, 1, 1 }, { -1, -1, -1, -1, -1, -1, -1, -1 } };
	const ts_four *result = results + parts * (entry >> 1);
	const ts_eight sign = signs[entry & 1], arm = *radius - EIGHT(result[0][3]);

	if (parts == 1)
		*sum += sign * TS_FOUR_JOIN(result[0], result[0]);
	else if (parts == 2)
		*sum += TS_EIGHT_HALVES(sign, arm) * *(const ts_eight *)result;
	else
		*sum += TS_EIGHT_HALVES(sign, arm) * TS_FOUR_JOIN(result[0], result[1]) +
			TS_EIGHT_HALVES(EIGHT(0), sign) * TS_FOUR_JOIN(result[2], result[2]);
}

/* Adds the entries from .. to-1 of a row; entries without a result are zero and change nothing. */
TS_INLINE void add_row(ts_eight *sum, const ts_eight *radius, const ts_four *results, size_t parts,
		       const uint32_t *row, int from, int to)
{
#pragma GCC unroll 8
	for (int k = from; k < to; k++)
		add_result(sum, radius, results, parts, row[k]);
}

TS_INLINE void add_or_set(double to[3], const ts_eight *sum, int from, bool overwrite)
{
	for (int d = 0; d < 3; d++)
		to[d] = overwrite ? (*sum)[from + d] : to[d] + (*sum)[from + d];
}

/* Neighbours in memory are neighbours in space: where grains fly, none of several touches. */
enum { TOGETHER = 8 };

TS_INLINE bool none_touches(const uint32_t sums[TOGETHER])
{
	uint64_t two[TOGETHER / 2];

	memcpy(two, sums, sizeof two);
	return !(two[0] | two[1] | two[2] | two[3]);
}

static void clear_sums(const struct ts_particles *p, size_t from, size_t n, size_t parts)
{
	memset(p->f[from], 0, n * sizeof *p->f);
	if (parts > 1)
		memset(p->torque[from], 0, n * sizeof *p->torque);
}

/* Sums the results of the touching pairs of particle i; `parts` as in struct ts_contact_list; always: number of entries that
 * are added for all particles. */
TS_INLINE void sum_particle(const struct ts_contact_list *list, const struct ts_particles *p, size_t i,
			    size_t parts, int always)
{
	const ts_four *results = (const ts_four *)list->result;
	const ts_eight radius = EIGHT(list->sphere[i].position[3]);
	const uint32_t *row = list->sum + TS_SUM_ROW * i;
	const bool overwrite = list->overwrite_sums;
	ts_eight sum = EIGHT(0);
	size_t n = list->sums[i];

	add_row(&sum, &radius, results, parts, row, 0, always);
	if (n > (size_t)always) {
		add_row(&sum, &radius, results, parts, row, always, TS_SUM_ROW);
		for (size_t k = TS_SUM_ROW; k < n; k++)
			add_result(&sum, &radius, results, parts, ts_touching_sums_entry(list, i, k));
	}
	add_or_set(p->f[i], &sum, 0, overwrite);
	if (parts > 1)
		add_or_set(p->torque[i], &sum, 4, overwrite);
}

TS_INLINE void sum_forces(const struct ts_contact_list *list, const struct ts_particles *p, size_t from,
			  size_t to, size_t parts, int always)
{
	const bool overwrite = list->overwrite_sums;

	for (; to - from >= TOGETHER; from += TOGETHER) {
		if (overwrite && none_touches(list->sums + from)) {
			clear_sums(p, from, TOGETHER, parts);
			continue;
		}
		for (size_t i = from; i < from + TOGETHER; i++)
			sum_particle(list, p, i, parts, always);
	}
	for (; from < to; from++)
		sum_particle(list, p, from, parts, always);
}

#define SUM(name, parts, always)                                                                     \
	TS_CLONES static void name(const struct ts_contact_list *list, const struct ts_particles *p, \
				   size_t from, size_t to)                                           \
	{                                                                                            \
		sum_forces(list, p, from, to, parts, always);                                        \
	}
SUM(half_rows_forces_only, 1, TS_SUM_ROW / 2)
SUM(half_rows_with_tangential_torque, 2, TS_SUM_ROW / 2)
SUM(half_rows_with_all_torques, 3, TS_SUM_ROW / 2)
SUM(rows_forces_only, 1, TS_SUM_ROW)
SUM(rows_with_tangential_torque, 2, TS_SUM_ROW)
SUM(rows_with_all_torques, 3, TS_SUM_ROW)

ts_contact_sums_fn *ts_contact_sums_of(const struct ts_contact_list *list)
{
	static ts_contact_sums_fn *const of[2][3] = {
		{ half_rows_forces_only, half_rows_with_tangential_torque, half_rows_with_all_torques },
		{ rows_forces_only, rows_with_tangential_torque, rows_with_all_torques },
	};

	return of[list->sum_whole_rows][list->parts - 1];
}
