/* The sums of the rows' forces and torques over the particles. */
#include "base/clones.h"
#include "base/four.h"
#include "neigh/contact_list.h"

#include "base/banned.h"

static const double signs[] = { 1, -1 }; /* a table: which side cannot be guessed */

TS_INLINE void add(double to[3], const ts_four *sum, bool sets)
{
	for (int d = 0; d < 3; d++)
		to[d] = sets ? (*sum)[d] : to[d] + (*sum)[d];
}

/* `parts` as in struct ts_contact_list. */
TS_INLINE void gather(const struct ts_contact_list *rows, const struct ts_particles *p, size_t from,
		      size_t to, size_t parts)
{
	const uint32_t *first = rows->sum_first, *sum = rows->sum;
	const ts_four *results = (const ts_four *)rows->result;
	bool sets = rows->sets;

	for (size_t i = from; i < to; i++) {
		ts_four f = { 0 }, torque = { 0 };
		double radius = rows->sphere[i].place[3];

		for (size_t k = first[i]; k < first[i + 1]; k++) {
			const ts_four *result = results + parts * (sum[k] >> 1);
			double sign = signs[sum[k] & 1];

			f += sign * result[0];
			if (parts > 2)
				torque += (radius - result[0][3]) * result[1] + sign * result[2];
			else if (parts > 1)
				torque += (radius - result[0][3]) * result[1];
		}
		add(p->f[i], &f, sets);
		if (parts > 1)
			add(p->torque[i], &torque, sets);
	}
}

#define GATHER(name, parts)                                                                          \
	TS_CLONES static void name(const struct ts_contact_list *rows, const struct ts_particles *p, \
				   size_t from, size_t to)                                           \
	{                                                                                            \
		gather(rows, p, from, to, parts);                                                    \
	}
GATHER(gather_forces, 1)
GATHER(gather_turns, 2)
GATHER(gather_rolls, 3)

ts_contacts_sum_fn *ts_contacts_sum_of(const struct ts_contact_list *rows)
{
	return rows->parts > 2 ? gather_rolls : rows->parts > 1 ? gather_turns : gather_forces;
}
