/* Command replicate: replicates the box with all particles and bonds. */
#include "core/sim.h"

#include <math.h>
#include <string.h>

#include "bond/bond_reference.h"
#include "bond/bonds.h"
#include "box/domain.h"
#include "particle/columns.h"
#include "particle/exchange.h"
#include "particle/identity.h"
#include "particle/molecule.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	int64_t n[3];
	bool bbox;
};

/* State before the replication. */
struct before {
	const struct state *state;
	struct ts_box box;
	size_t n;	  /* number of particles */
	int32_t max_tag;  /* copy k of the particle t has the identity t + k max_tag */
	double molecules; /* largest number of a molecule; those above 0 are numbered on in the same way */
	double (*x)[3];	  /* unwrapped positions */
};

static int64_t copies(const struct state *s)
{
	return s->n[0] * s->n[1] * s->n[2];
}

/* Index of the copy at the given multiples of the box, x fastest; periodic in the new box. */
static int64_t copy_at_cell(const struct state *s, const int64_t at[3])
{
	int64_t k = 0;

	for (int d = 2; d >= 0; d--)
		k = k * s->n[d] + (at[d] % s->n[d] + s->n[d]) % s->n[d];
	return k;
}

static void cell_of_copy(const struct state *s, int64_t copy, int64_t at[3])
{
	for (int d = 0; d < 3; d++) {
		at[d] = copy % s->n[d];
		copy /= s->n[d];
	}
}

static enum ts_status check_replication(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	const struct ts_particles *p = sim->particles;
	double largest_tag = (double)copies(s) * fmax((double)p->max_tag, (double)p->n);

	if (sim->dimension == 2 && s->n[2] != 1)
		return ts_fail(&sim->error, TS_RANGE, where, "replicate: in two dimensions nz must be 1");
	if (largest_tag > INT32_MAX)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "replicate: %g identities would be needed, there are %d", largest_tag,
			       INT32_MAX);
	for (size_t i = 0; p->body && i < p->n; i++)
		if (p->body[i])
			return ts_fail(&sim->error, TS_STATE, where,
				       "replicate: particle %d belongs to a rigid body, which is not copied: "
				       "replicate first, then define the bodies",
				       p->tag[i]);
	for (int d = 0; d < 3; d++)
		if (s->n[d] > 1 && !ts_box_periodic(&sim->domain->box, d))
			ts_warn(&sim->log, where,
				"the box is not periodic in %c: particles at its faces may overlap", 'x' + d);
	return TS_OK;
}

static enum ts_status store_positions(struct tsim *sim, struct before *b)
{
	const struct ts_particles *p = sim->particles;

	b->x = ts_alloc(p->n, sizeof *b->x);
	if (!b->x)
		return ts_nomem(&sim->error);
	b->box = sim->domain->box;
	b->n = p->n;
	b->max_tag = p->max_tag;
	b->molecules = ts_particles_most_molecule(sim);
	for (size_t i = 0; i < p->n; i++)
		for (int d = 0; d < 3; d++)
			b->x[i][d] = p->x[i][d] + p->image[i][d] * ts_box_length(&b->box, d);
	return TS_OK;
}

static void copy_columns(struct ts_particles *p, size_t from, size_t n, size_t to)
{
	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];
		size_t bytes = c->element * c->width;

		if (c->active && n)
			memcpy((char *)c->data + to * bytes, (char *)c->data + from * bytes, n * bytes);
	}
}

/* Positions are unwrapped, also those of copy 0; they are wrapped into the new box at the end. */
static enum ts_status copy_particles(struct tsim *sim, const struct before *b)
{
	struct ts_particles *p = sim->particles;
	int64_t total = copies(b->state);
	double *molecule;
	size_t first;

	TS_TRY(ts_particles_add(sim, (size_t)(total - 1) * b->n, &first));
	molecule = ts_particles_molecules_to_set(p);
	for (int64_t k = 0; k < total && b->n; k++) {
		size_t row = (size_t)k * b->n;
		int64_t at[3];

		cell_of_copy(b->state, k, at);
		if (k)
			copy_columns(p, 0, b->n, row);
		for (size_t i = 0; i < b->n; i++) {
			p->tag[row + i] = (int32_t)(p->tag[i] + k * b->max_tag);
			if (molecule && molecule[i] > 0)
				molecule[row + i] = molecule[i] + (double)k * b->molecules;
			for (int d = 0; d < 3; d++) {
				p->x[row + i][d] = b->x[i][d] + (double)at[d] * ts_box_length(&b->box, d);
				p->image[row + i][d] = 0;
			}
		}
	}
	p->max_tag = (int32_t)(total * b->max_tag);
	return TS_OK;
}

/* Number of old box lengths between particle i and its bonded partner j: the nearest unwrapped image of
 * j is at x_j + shift L. */
static void bond_shift(const struct before *b, size_t i, size_t j, int64_t shift[3])
{
	for (int d = 0; d < 3; d++) {
		double length = ts_box_length(&b->box, d);

		shift[d] =
			ts_box_periodic(&b->box, d) ? (int64_t)rint((b->x[i][d] - b->x[j][d]) / length) : 0;
	}
}

static enum ts_status copy_bond(struct tsim *sim, const struct before *b, const int32_t tag[2],
				const int64_t shift[3], size_t bond)
{
	struct ts_bonds *bonds = sim->bonds;

	for (int64_t k = 0; k < copies(b->state); k++) {
		int64_t at[3], other;

		cell_of_copy(b->state, k, at);
		for (int d = 0; d < 3; d++)
			at[d] += shift[d];
		other = copy_at_cell(b->state, at);
		TS_TRY(ts_bonds_add(sim, (int32_t)(tag[0] + k * b->max_tag),
				    (int32_t)(tag[1] + other * b->max_tag), bonds->type[bond],
				    bonds->own[bond]));
		ts_bond_reference_copy(bonds, bond, bonds->n - 1,
				       tag[0] + k * b->max_tag > tag[1] + other * b->max_tag);
	}
	return TS_OK;
}

/* Bonds across periodic faces connect adjacent copies. The new list is appended to the old one, which
 * is deleted. */
static enum ts_status copy_bonds(struct tsim *sim, const struct before *b)
{
	struct ts_bonds *bonds = sim->bonds;
	size_t n = bonds->n;
	unsigned char *old;
	struct ts_identities map;

	if (!n)
		return TS_OK;
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < n; k++) {
		const int32_t tag[2] = { bonds->tag[k][0], bonds->tag[k][1] };
		const int32_t row[2] = { ts_identity_row(&map, tag[0]), ts_identity_row(&map, tag[1]) };
		int64_t shift[3];

		if (row[0] < 0 || row[1] < 0)
			continue;
		bond_shift(b, (size_t)row[0], (size_t)row[1], shift);
		TS_TRY(copy_bond(sim, b, tag, shift, k));
	}
	old = ts_alloc(bonds->n, 1);
	if (!old)
		return ts_nomem(&sim->error);
	memset(old, 1, n);
	ts_bonds_delete(bonds, old);
	ts_free(old);
	bonds->created -= (int64_t)n;
	ts_bonds_sort(bonds);
	return TS_OK;
}

static enum ts_status replicate(struct tsim *sim, struct before *b, const struct ts_place *where)
{
	double hi[3];

	TS_TRY(store_positions(sim, b));
	TS_TRY(copy_particles(sim, b));
	TS_TRY(copy_bonds(sim, b));
	for (int d = 0; d < 3; d++)
		hi[d] = b->box.lo[d] + (double)b->state->n[d] * ts_box_length(&b->box, d);
	TS_TRY(ts_domain_set_box(sim, b->box.lo, hi, where));
	return ts_exchange_migrate(sim);
}

static enum ts_status replicate_command(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct before b = { .state = state };
	const struct ts_box *box = &sim->domain->box;
	enum ts_status status;

	TS_TRY(ts_domain_refuse_shear(sim, "replicate", where));
	TS_TRY(check_replication(sim, state, where));
	status = replicate(sim, &b, where);
	ts_free(b.x);
	TS_TRY(status);
	ts_log(&sim->log, "Replicated box = (%g %g %g) to (%g %g %g)\n  %zu atoms\n", box->lo[0], box->lo[1],
	       box->lo[2], box->hi[0], box->hi[1], box->hi[2], sim->particles->n);
	if (sim->bonds->n)
		ts_log(&sim->log, "  %zu bonds\n", sim->bonds->n);
	return TS_OK;
}

#define NUMBER(name, d, help_)                                                                               \
	TS_INT(name, struct state, n[d], .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1000000, \
	       .help = help_)
static const struct ts_arg args[] = {
	NUMBER("nx", 0, "number of copies along x"),
	NUMBER("ny", 1, "number of copies along y"),
	NUMBER("nz", 2, "number of copies along z"),
	TS_FLAG("bbox", struct state, bbox, .help = "no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_replicate)
const struct ts_command_style ts_command_replicate = {
	.style = {
		.name = "replicate",
		.kind = TS_KIND_COMMAND,
		.summary = "replicates the box with all particles and bonds",
		.doc = "All properties of the particles are copied, group membership included. Copy k of the "
		       "particle with ID t gets the ID t + k N, where N is the largest ID before and k "
		       "numbers the copies with x varying fastest; molecules above 0 are numbered on in the "
		       "same way. Bonds connect corresponding neighbours, also across periodic faces: a "
		       "periodic block of bonded particles becomes a larger periodic block without unbonded "
		       "interfaces.\n\n"
		       "Copies start without contact history. Fixes that store initial positions of particles "
		       "and are defined before this command store those of the originals for their copies; "
		       "define them afterwards.",
		.example = "replicate 4 4 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = replicate_command,
};
