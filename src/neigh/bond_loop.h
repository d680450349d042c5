/* The loop over bonds, written once. A bond style makes a share function that calls ts_bond_share with
 * its law, which as a constant function is inlined. */
#ifndef TS_NEIGH_BOND_LOOP_H
#define TS_NEIGH_BOND_LOOP_H

#include <math.h>

#include "base/inline.h"
#include "base/parallel.h"
#include "geom/box.h"
#include "neigh/bonds.h"
#include "particles/particles.h"

struct ts_bond_task {
	const struct ts_particles *p;
	struct ts_bonds *bonds;
	const struct ts_coeffs *coeffs;
	const struct ts_box *box;
};

/* Vector from the second to the first partner, by the nearest image. */
static inline void ts_bond_separation(const struct ts_bond_task *t, size_t i, size_t j, double d[3])
{
	for (int k = 0; k < 3; k++)
		d[k] = t->p->x[i][k] - t->p->x[j][k];
	ts_box_nearest(t->box, d);
}

/* Force of bond b on its first partner; false if it breaks. */
TS_INLINE bool ts_bond_evaluate(const struct ts_bond_task *t, size_t b, ts_bond_law *law)
{
	struct ts_bonds *bonds = t->bonds;
	const struct ts_particles *p = t->p;
	size_t i = (size_t)bonds->row[b][0], j = (size_t)bonds->row[b][1];
	const double *vi = p->v[i], *vj = p->v[j];
	struct ts_bond_state state;
	double d[3], length, inverse, tension;
	bool holds;

	ts_bond_separation(t, i, j, d);
	length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
	inverse = length > 0 ? 1 / length : 0;
	for (int k = 0; k < 3; k++)
		d[k] *= inverse;
	state.extension = length - bonds->rest[b];
	state.mass = 1 / (p->imass[i] + p->imass[j]);
	state.rate = (vi[0] - vj[0]) * d[0] + (vi[1] - vj[1]) * d[1] + (vi[2] - vj[2]) * d[2];
	holds = law(ts_coeff(t->coeffs, (size_t)bonds->type[b]), &state, &tension);
	bonds->tension[b] = tension;
	for (int k = 0; k < 3; k++)
		bonds->force[b][k] = holds ? -tension * d[k] : 0;
	return holds;
}

/* Returns the number of bonds that break. */
TS_INLINE long ts_bond_share(const struct ts_bond_task *t, size_t from, size_t to, ts_bond_law *law)
{
	long broken = 0;

	for (size_t b = from; b < to; b++) {
		t->bonds->breaks[b] = !ts_bond_evaluate(t, b, law);
		broken += t->bonds->breaks[b];
	}
	return broken;
}

#endif
