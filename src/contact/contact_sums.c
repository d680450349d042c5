#include "contact/contact_sums.h"

#include "base/clones.h"
#include "base/four.h"

#include "base/banned.h"

/* a table instead of a branch: the branch would be mispredicted half of the time */
static const double signs[] = { 1, -1 };

TS_INLINE void add_or_set(double to[3], const ts_four *sum, bool overwrite)
{
	for (int d = 0; d < 3; d++)
		to[d] = overwrite ? (*sum)[d] : to[d] + (*sum)[d];
}

/* Sums the results of the touching pairs of each particle; `parts` as in struct ts_contact_list. */
TS_INLINE void sum_forces(const struct ts_contact_list *list, const struct ts_particles *p, size_t from,
			  size_t to, size_t parts)
{
	const size_t *first = list->gather.first;
	const ts_four *results = (const ts_four *)list->result;
	bool overwrite = list->overwrite_sums;

	for (size_t i = from; i < to; i++) {
		ts_four f = { 0 }, torque = { 0 };
		double radius = list->sphere[i].position[3];
		const uint32_t *sum = list->sum + first[i];

		for (size_t k = 0; k < list->sums[i]; k++) {
			const ts_four *result = results + parts * (sum[k] >> 1);
			double sign = signs[sum[k] & 1];

			f += sign * result[0];
			if (parts > 2)
				torque += (radius - result[0][3]) * result[1] + sign * result[2];
			else if (parts > 1)
				torque += (radius - result[0][3]) * result[1];
		}
		add_or_set(p->f[i], &f, overwrite);
		if (parts > 1)
			add_or_set(p->torque[i], &torque, overwrite);
	}
}

#define SUM(name, parts)                                                                             \
	TS_CLONES static void name(const struct ts_contact_list *list, const struct ts_particles *p, \
				   size_t from, size_t to)                                           \
	{                                                                                            \
		sum_forces(list, p, from, to, parts);                                                \
	}
SUM(sum_forces_only, 1)
SUM(sum_with_tangential_torque, 2)
SUM(sum_with_all_torques, 3)

ts_contact_sums_fn *ts_contact_sums_of(const struct ts_contact_list *list)
{
	return list->parts > 2	 ? sum_with_all_torques
	       : list->parts > 1 ? sum_with_tangential_torque
				 : sum_forces_only;
}
