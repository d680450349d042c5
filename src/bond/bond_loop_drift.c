/* Relative velocities of bonded particles across periodic faces that move. */
#include <math.h>

#include "bond/bond_loop.h"
#include "box/domain.h"

#include "base/banned.h"

void ts_bond_add_drift(const struct ts_bond_task *t, size_t i, size_t j, const double d[3], double v[3])
{
	if (!ts_in_group(t->p, i, t->drift->drift_group) || !ts_in_group(t->p, j, t->drift->drift_group))
		return;
	for (int c = 0; c < 3; c++)
		if (ts_box_periodic(t->box, c))
			v[c] -= rint(d[c] / ts_box_length(t->box, c)) * t->drift->drift[c];
}
