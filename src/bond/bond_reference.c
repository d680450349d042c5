#include "bond/bond_reference.h"

#include <math.h>
#include <string.h>

#include "math/quaternion.h"
#include "math/vec3.h"
#include "particle/copies.h"
#include "particle/identity.h"
#include "particle/orientation.h"

#include "base/banned.h"

/* A rotation of the first axis to the direction n: the smallest, for n[0] < 0 after half a turn, so that there
 * is no cancellation. */
static void rotation_to(const double n[3], double q[4])
{
	static const double half[4] = { 0, 0, 1, 0 };
	double sign = n[0] < 0 ? -1 : 1, turn[4] = { 1 + sign * n[0], 0, -sign * n[2], sign * n[1] };

	ts_quaternion_normalise(turn);
	if (n[0] < 0)
		ts_quaternion_multiply(turn, half, q);
	else
		memcpy(q, turn, sizeof turn);
}

static void take_reference(const struct tsim *sim, size_t b, const size_t row[2])
{
	struct ts_bond_reference *r = &sim->bonds->reference[b];
	double d[3], along[4], q[4], length = ts_bond_separation(sim, row[1], row[0], d);

	ts_scale(1 / length, d, d);
	rotation_to(d, along);
	for (int s = 0; s < 2; s++) {
		ts_orientation_of(sim, row[s], q);
		for (int k = 1; k < 4; k++)
			q[k] = -q[k];
		ts_quaternion_multiply(q, along, r->frame[s]);
		r->radius[s] = sim->particles->radius[row[s]];
	}
}

static bool is_set(const struct ts_bond_reference *r)
{
	return r->radius[0] > 0;
}

enum ts_status ts_bond_reference_complete(struct tsim *sim)
{
	struct ts_bonds *b = sim->bonds;
	struct ts_identities own;
	struct ts_copy_map copies;

	if (!b->transmits || !b->n)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &own));
	if (ts_copy_map_make(sim, &copies) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < b->n; k++) {
		int32_t row[2];

		if (is_set(&b->reference[k]))
			continue;
		for (int s = 0; s < 2; s++)
			row[s] = ts_bonds_row_of(sim, &own, &copies, b->tag[k][s]);

		if (row[0] < 0 || row[1] < 0)
			continue;
		take_reference(sim, k, (size_t[2]){ (size_t)row[0], (size_t)row[1] });
	}
	ts_copy_map_release(&copies);
	return TS_OK;
}

enum ts_status ts_bond_reference_require(struct tsim *sim)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_BOND);

	TS_TRY(ts_bonds_transmit(sim, inst && ts_bond_style_of(inst)->element));
	return ts_bond_reference_complete(sim);
}

void ts_bond_reference_copy(struct ts_bonds *b, size_t from, size_t to, bool swapped)
{
	static const double back[4] = { 0, 0, 1, 0 }; /* half a turn: the first axis points back */
	const struct ts_bond_reference *r;

	if (b->softens)
		b->damage[to] = b->damage[from];
	if (!b->transmits)
		return;
	r = &b->reference[from];
	b->reference[to] = *r;
	for (int s = 0; swapped && s < 2; s++) {
		ts_quaternion_multiply(r->frame[1 - s], back, b->reference[to].frame[s]);
		b->reference[to].radius[s] = r->radius[1 - s];
	}
}

void ts_bond_reference_doubt(struct tsim *sim, const char *command, const struct ts_place *where)
{
	if (!sim->bonds->n || !sim->bonds->transmits)
		return;
	ts_warn(&sim->log, where,
		"%s: dumps have no orientations, so that particles keep those of now: shear, bending and "
		"torsion of bonds, and which of them break, are not those of the run that wrote the dump",
		command);
}
