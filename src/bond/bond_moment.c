#include "bond/bond_moment.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "bond/bond_reference.h"
#include "box/domain.h"
#include "law/bond_softening.h"
#include "math/vec3.h"
#include "particle/identity.h"
#include "particle/orientation.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"

#include "base/banned.h"

/* ---- constants */

static const void *coeff_of(const struct tsim *sim, size_t b)
{
	const struct ts_bond *bond = ts_sim_only(sim, TS_KIND_BOND)->state;

	return ts_coeff(&bond->coeffs, (size_t)sim->bonds->type[b]);
}

struct ts_bond_pair ts_bond_pair_of(const struct tsim *sim, size_t b)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_particles *p = sim->particles;
	struct ts_bond_pair pair = { .rest = bonds->rest[b] };

	for (int s = 0; s < 2; s++) {
		size_t i = (size_t)bonds->row[b][s];

		pair.radius[s] = bonds->reference[b].radius[s];
		pair.mass[s] = p->mass[i];
		pair.inertia[s] = ts_inertia(sim, i);
		pair.tag[s] = bonds->tag[b][s];
	}
	return pair;
}

void ts_bond_constants(const struct tsim *sim, size_t b, struct ts_bond_element *out)
{
	const struct ts_bond_pair pair = ts_bond_pair_of(sim, b);

	*out = (struct ts_bond_element){
		.length = pair.rest, .tension = INFINITY, .shear = INFINITY, .compression = INFINITY
	};
	ts_bond_never_softens(out);
	ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND))->element(coeff_of(sim, b), &pair, out);
}

static void fill_softening(const struct ts_bonds *b, const struct ts_bond_element *e, uint32_t bond,
			   struct ts_bond_softening *s, size_t lane)
{
	const struct ts_bond_damage damage =
		bond == TS_BOND_NONE ? (struct ts_bond_damage){ 0, 0 } : b->damage[bond];

	s->onset[lane] = e->onset;
	s->rupture[lane] = e->rupture;
	s->shear_rupture[lane] = e->shear_rupture;
	s->friction[lane] = e->friction;
	s->reached[lane] = damage.reached;
	s->release[lane] = damage.release;
}

/* The constants of a lane that rows of equal bonds share. */
static void fill_sections(struct ts_bond_sections *c, const struct ts_bond_element *e, size_t lane)
{
	for (int k = 0; k < TS_BOND_MODES; k++)
		c->k[k][lane] = e->k[k];
	c->per_area[lane] = e->per_area;
	c->per_moment[lane] = e->per_moment;
	c->per_torque[lane] = e->per_torque;
	c->lever[lane] = e->lever;
	c->tension[lane] = e->tension;
	c->shear[lane] = e->shear;
	c->compression[lane] = e->compression;
}

/* A lane of row r, except its sections; e: its bond, or that of another lane. */
static void fill_lane(const struct tsim *sim, size_t r, size_t lane, const struct ts_bond_element *e)
{
	const struct ts_bond_rows *rows = &sim->bonds->rows;
	struct ts_bond_row *l = &rows->row[r];
	const uint32_t b = l->bond[lane];
	struct ts_bond_element none = *e;

	ts_bond_never_softens(&none);
	if (rows->softens)
		fill_softening(sim->bonds, b == TS_BOND_NONE ? &none : e, b, &rows->soft[r], lane);
	l->length[lane] = b == TS_BOND_NONE ? 0 : e->length;
	l->fraction[lane] = e->fraction;
	for (int k = 0; k < TS_BOND_MODES; k++) {
		if (rows->damped)
			rows->dashpots[r].c[k][lane] = b == TS_BOND_NONE ? 0 : e->c[k];
		for (int s = 0; s < 2; s++)
			l->frame[s][k][lane] =
				b == TS_BOND_NONE ? k == 0 : sim->bonds->reference[b].frame[s][k];
	}
}

/* Where there is no bond the sections are those of the lane before, so that rows differ rarely. */
static void fill_row(const struct tsim *sim, size_t r)
{
	const struct ts_bond_rows *rows = &sim->bonds->rows;
	struct ts_bond_element e = { .tension = INFINITY, .shear = INFINITY, .compression = INFINITY };

	ts_bond_never_softens(&e);
	for (size_t lane = 0; lane < TS_BOND_ROW_LANES; lane++) {
		if (rows->row[r].bond[lane] != TS_BOND_NONE)
			ts_bond_constants(sim, rows->row[r].bond[lane], &e);
		fill_lane(sim, r, lane, &e);
		fill_sections(&rows->sections[r], &e, lane);
	}
}

static void fill_rows(void *context, size_t from, size_t to)
{
	const struct tsim *sim = context;
	const struct ts_bond_rows *rows = &sim->bonds->rows;
	size_t kept = from;

	for (size_t r = from; r < to; r++) {
		fill_row(sim, r);
		if (memcmp(&rows->sections[kept], &rows->sections[r], sizeof *rows->sections) != 0)
			kept = r;
		rows->sections_of[r] = (uint32_t)kept;
	}
}

/* ---- broken bonds */

static void empty_lane(const struct tsim *sim, size_t r, size_t lane)
{
	const struct ts_bond_rows *rows = &sim->bonds->rows;
	const struct ts_bond_element none = { .length = 0 };
	struct ts_bond_row *row = &rows->row[r];

	row->bond[lane] = TS_BOND_NONE;
	row->particle[1][lane] = row->particle[0][lane];
	fill_lane(sim, r, lane, &none);
}

/* Removes the entries of bonds that have no new number from the sums of all particles. */
static void shorten_sums(struct ts_bonds *b, const uint32_t *number)
{
	struct ts_gather *g = &b->gather;
	size_t kept = 0, k = 0;

	for (size_t i = 0; i < b->rows.particles; i++) {
		size_t end = g->first[i + 1];

		g->first[i] = kept;
		for (; k < end; k++) {
			uint32_t entry = g->entry[k];

			if (number[entry >> 1] == TS_BOND_NONE)
				continue;
			g->entry[kept] = 2 * number[entry >> 1] | (entry & 1);
			b->rows.sum[kept++] = b->rows.sum[k];
		}
	}
	g->first[b->rows.particles] = kept;
}

enum ts_status ts_bond_moments_remove(struct tsim *sim, const unsigned char *broken)
{
	struct ts_bonds *b = sim->bonds;
	uint32_t *number = ts_alloc(b->n, sizeof *number), kept = 0;

	if (!number)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < b->n; k++)
		number[k] = broken[k] ? TS_BOND_NONE : kept++;
	for (size_t r = 0; r < b->rows.n; r++)
		for (size_t lane = 0; lane < TS_BOND_ROW_LANES; lane++) {
			uint32_t *bond = &b->rows.row[r].bond[lane];

			if (*bond == TS_BOND_NONE)
				continue;
			*bond = number[*bond];
			if (*bond == TS_BOND_NONE)
				empty_lane(sim, r, lane);
		}
	shorten_sums(b, number);
	ts_free(number);
	ts_bonds_delete(b, broken);
	memset(b->breaks, 0, b->n);
	return TS_OK;
}

/* ---- checks */

static enum ts_status refuse_member(struct ts_instance *self, struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	if (!p->body || !p->body[i])
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "bond_style %s: particle %d belongs to a rigid body, whose rotation this bond style "
		       "does not follow; use bond_style contact, or bond single particles",
		       self->style->name, p->tag[i]);
}

enum ts_status ts_bond_moments_require(struct tsim *sim)
{
	TS_TRY(ts_orientation_need(sim));
	return ts_bond_reference_require(sim);
}

enum ts_status ts_bond_moments_allow(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_bonds *b = sim->bonds;
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < b->n; k++)
		for (int s = 0; s < 2; s++) {
			int32_t row = ts_identity_row(&map, b->tag[k][s]);

			if (row >= 0)
				TS_TRY(refuse_member(self, sim, (size_t)row));
		}
	return TS_OK;
}

enum ts_status ts_bond_moments_fill(struct tsim *sim, bool damped, bool softens)
{
	struct ts_bond_rows *rows = &sim->bonds->rows;

	if (rows->filled)
		return TS_OK;
	if (damped && TS_RENEW(rows->dashpots, rows->dashpots_capacity, rows->n) != TS_OK)
		return ts_nomem(&sim->error);
	if (softens && TS_RENEW(rows->soft, rows->soft_capacity, rows->n) != TS_OK)
		return ts_nomem(&sim->error);
	rows->damped = damped;
	rows->softens = softens;
	ts_parallel(ts_team(sim, rows->n * TS_BOND_ROW_LANES), rows->n, fill_rows, sim);
	rows->filled = true;
	return TS_OK;
}

/* ---- the state of a bond */

static struct ts_wxyz frame_of(const struct tsim *sim, size_t b, int side)
{
	const double *f = sim->bonds->reference[b].frame[side];
	double q[4];

	ts_orientation_of(sim, (size_t)sim->bonds->row[b][side], q);
	return ts_wxyz_product((struct ts_wxyz){ q[0], q[1], q[2], q[3] },
			       (struct ts_wxyz){ f[0], f[1], f[2], f[3] });
}

void ts_bond_ends_of(const struct tsim *sim, size_t b, struct ts_bond_ends *out)
{
	double d[3];

	ts_bond_separation(sim, (size_t)sim->bonds->row[b][1], (size_t)sim->bonds->row[b][0], d);
	out->d = (struct ts_xyz){ d[0], d[1], d[2] };
	for (int k = 0; k < 2; k++)
		out->q[k] = frame_of(sim, b, k);
}

void ts_bond_state_of(const struct tsim *sim, size_t b, struct ts_bond_element *e, struct ts_bond_answer *out)
{
	ts_bond_single_law *law = ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND))->law;
	struct ts_bond_ends s = { .v = { 0, 0, 0 } };

	ts_bond_constants(sim, b, e);
	ts_bond_ends_of(sim, b, &s);
	if (law) {
		(void)law(coeff_of(sim, b), e, &s, false, out);
		return;
	}
	ts_bond_elastic(e, &s, out);
	ts_bond_stress(e, out);
	if (sim->bonds->softens) {
		ts_bond_rub(ts_bond_intact(e->rupture, sim->bonds->damage[b].reached), out, e);
		ts_bond_soften_state(sim->bonds->damage[b].reached, &s, e, out);
	}
}

double ts_bond_shear_ratio(const struct ts_bond_element *e, const struct ts_bond_answer *s)
{
	return e->shear > 0 ? s->shear / e->shear : INFINITY;
}

enum ts_bond_failure ts_bond_failure_of(const struct ts_bond_element *e, const struct ts_bond_answer *s)
{
	double most = s->tension / e->tension;
	enum ts_bond_failure failure = TS_BOND_TENSION;

	if (ts_bond_shear_ratio(e, s) > most) {
		most = ts_bond_shear_ratio(e, s);
		failure = TS_BOND_SHEARED;
	}
	return s->compression / e->compression > most ? TS_BOND_CRUSHED : failure;
}

void ts_bond_energy(const struct tsim *sim, size_t b, double energy[TS_BOND_MODES])
{
	const struct ts_bond_style *style = ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND));
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_bond_element e;
	struct ts_bond_answer a;
	double d[3];

	if (style->element) {
		ts_bond_state_of(sim, b, &e, &a);
		ts_bond_energies(&e, &a, energy);
		return;
	}
	memset(energy, 0, TS_BOND_MODES * sizeof *energy);
	energy[TS_BOND_NORMAL] =
		style->energy(coeff_of(sim, b),
			      ts_bond_separation(sim, (size_t)bonds->row[b][0], (size_t)bonds->row[b][1], d) -
				      bonds->rest[b],
			      bonds->rest[b]);
}

double ts_bond_elastic_energy(const struct tsim *sim, size_t b)
{
	double energy[TS_BOND_MODES], sum = 0;

	ts_bond_energy(sim, b, energy);
	for (int mode = 0; mode < TS_BOND_MODES; mode++)
		sum += energy[mode];
	return sum;
}

static void store_xyz(struct ts_xyz from, double sign, double to[3])
{
	to[0] = sign * from.x;
	to[1] = sign * from.y;
	to[2] = sign * from.z;
}

void ts_bond_spring_load(const struct tsim *sim, size_t b, struct ts_bond_load *out)
{
	const struct ts_bond_style *style = ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND));
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_bond_element e;
	struct ts_bond_answer a;
	double d[3], distance;

	memset(out, 0, sizeof *out);
	if (style->element) {
		ts_bond_state_of(sim, b, &e, &a);
		store_xyz(a.force, -1, out->force);
		store_xyz(a.torque[0], 1, out->torque[0]);
		store_xyz(a.torque[1], 1, out->torque[1]);
		return;
	}
	distance = ts_bond_separation(sim, (size_t)bonds->row[b][0], (size_t)bonds->row[b][1], d);
	ts_scale(distance > 0 ? -style->spring(coeff_of(sim, b), distance - bonds->rest[b], bonds->rest[b]) /
					distance
			      : 0,
		 d, out->force);
}

double ts_bond_moment_limit(const struct tsim *sim, size_t b)
{
	const struct ts_particles *p = sim->particles;
	struct ts_bond_element e;
	double mass[2], inertia[2];

	for (int s = 0; s < 2; s++) {
		size_t i = (size_t)sim->bonds->row[b][s];

		mass[s] = p->imass[i];
		inertia[s] = p->imass[i] > 0 ? 1 / ts_inertia(sim, i) : 0;
	}
	if (!(mass[0] + mass[1] > 0))
		return INFINITY;
	ts_bond_constants(sim, b, &e);
	return ts_bond_element_limit(&e, mass, inertia);
}

enum ts_status ts_bond_turn(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	ts_orientation_advance(sim);
	return TS_OK;
}
