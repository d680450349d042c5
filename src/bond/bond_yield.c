#include "bond/bond_yield.h"

#include "base/parallel.h"
#include "bond/bond_moment.h"
#include "law/plastic_hinge.h"
#include "math/exactsum.h"
#include "math/quaternion.h"
#include "particle/copies.h"
#include "particle/orientation.h"

#include "base/banned.h"

struct yielding {
	const struct tsim *sim;
	const struct ts_bond_style *style;
	const struct ts_coeffs *coeffs;
	double *work; /* per bond, lost in this step */
};

/* Elastic energy but that of the normal force. */
static double energy_across(const struct ts_bond_element *e, const struct ts_bond_ends *s)
{
	struct ts_bond_answer a;
	double energy[TS_BOND_MODES];

	ts_bond_elastic(e, s, &a);
	ts_bond_energies(e, &a, energy);
	return energy[TS_BOND_SHEAR] + energy[TS_BOND_BENDING] + energy[TS_BOND_TWIST];
}

/* Changes the rest length, and with it the constants *e; returns the work. */
static double stretch(const struct tsim *sim, size_t b, const struct ts_plastic_section *y,
		      const struct ts_bond_ends *s, struct ts_bond_element *e)
{
	double length = ts_plastic_length(e, y, sqrt(ts_xyz_dot(s->d, s->d))), work;

	if (length == e->length)
		return 0;
	work = ts_plastic_stretch_work(e, y, length) + energy_across(e, s);
	sim->bonds->rest[b] = sim->bonds->own[b] = length;
	ts_bond_constants(sim, b, e);
	return work - energy_across(e, s);
}

/* The frame of the end in space becomes the reference of the particle. */
static void store_frame(const struct tsim *sim, size_t b, int side, struct ts_wxyz frame)
{
	const double space[4] = { frame.w, frame.x, frame.y, frame.z };
	double *to = sim->bonds->reference[b].frame[side], body[4];

	ts_orientation_of(sim, (size_t)sim->bonds->row[b][side], body);
	for (int k = 1; k < 4; k++)
		body[k] = -body[k];
	ts_quaternion_multiply(body, space, to);
	ts_quaternion_normalise(to);
}

static double yield_bond(const struct yielding *t, size_t b)
{
	const struct tsim *sim = t->sim;
	const struct ts_bond_pair pair = ts_bond_pair_of(sim, b);
	struct ts_plastic_section section;
	struct ts_plastic_flow flow;
	struct ts_bond_element e;
	struct ts_bond_ends s;
	double work;

	if (!t->style->section(ts_coeff(t->coeffs, (size_t)sim->bonds->type[b]), &pair, &section))
		return 0;
	ts_bond_constants(sim, b, &e);
	ts_bond_ends_of(sim, b, &s);
	work = stretch(sim, b, &section, &s, &e);
	if (ts_plastic_relax(&e, &section, &s, &flow))
		for (int side = 0; side < 2; side++)
			store_frame(sim, b, side, s.q[side]);
	return work + flow.work;
}

static void yield_bonds(void *context, size_t from, size_t to)
{
	const struct yielding *t = context;

	for (size_t b = from; b < to; b++)
		t->work[b] = yield_bond(t, b);
}

static bool any_yields(const struct yielding *t)
{
	const struct ts_bond_pair pair = { 0 };
	struct ts_plastic_section section;
	bool any = false;

	for (int type = 1; type <= t->sim->bonds->ntypes; type++)
		any |= t->coeffs->given[type] &&
		       t->style->section(ts_coeff(t->coeffs, (size_t)type), &pair, &section);
	return any;
}

enum ts_status ts_bond_turn_and_yield(struct ts_instance *self, struct tsim *sim)
{
	struct ts_bonds *bonds = sim->bonds;
	struct yielding t = { sim, ts_bond_style_of(self), &((const struct ts_bond *)self->state)->coeffs,
			      NULL };

	bonds->flow = ts_exactsum_start();
	TS_TRY(ts_bond_turn(self, sim));
	if (!any_yields(&t))
		return TS_OK;
	ts_copies_forward(sim); /* partners on other ranks have moved, too */
	if (!bonds->n)
		return TS_OK;
	t.work = ts_alloc(bonds->n, sizeof *t.work);
	if (!t.work)
		return ts_nomem(&sim->error);
	ts_parallel(ts_team(sim, bonds->n), bonds->n, yield_bonds, &t);
	for (size_t b = 0; b < bonds->n; b++) {
		if (t.work[b] != 0)
			bonds->rows.filled = false;
		if ((size_t)bonds->row[b][0] < sim->particles->n)
			ts_exactsum_add(&bonds->flow, t.work[b]);
	}
	ts_free(t.work);
	return TS_OK;
}
