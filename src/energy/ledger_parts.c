/* Contacts and bonds by cause, as they are right after their forces were made. */
#include <string.h>

#include "bond/bonds.h"
#include "contact/contact_loop.h"
#include "contact/contact_view.h"
#include "energy/ledger.h"
#include "neigh/contact_memory.h"
#include "particle/identity.h"
#include "wall/wall.h"

#include "base/banned.h"

struct sums {
	struct ts_exactsum store[TS_NCONTACT_STORE], brought[TS_NCONTACT_STORE], slip;
};

static void start_sums(struct sums *s)
{
	for (int k = 0; k < TS_NCONTACT_STORE; k++)
		s->store[k] = s->brought[k] = ts_exactsum_start();
	s->slip = ts_exactsum_start();
}

/* `fresh`: one of the partners has come since the last forces, and the contact with it. */
static void add_energy(struct sums *s, const double energy[], double share, bool fresh)
{
	for (int k = 0; k < TS_NCONTACT_STORE; k++) {
		if (energy[k] == 0)
			continue;
		ts_exactsum_add(&s->store[k], share * energy[k]);
		if (fresh)
			ts_exactsum_add(&s->brought[k], share * energy[k]);
	}
}

static void end_sums(const struct sums *s, struct ts_ledger *l, int side, bool first)
{
	if (l->stepping)
		ts_compensated_add(&l->slip[side], ts_exactsum_value(&s->slip));
	for (int k = 0; k < TS_NCONTACT_STORE; k++) {
		int store = ts_ledger_store(side, k);

		if (l->looking)
			continue;
		l->store[store] = (first ? 0 : l->store[store]) + ts_exactsum_value(&s->store[k]);
		if (l->stepping)
			ts_compensated_add(&l->moved[store], ts_exactsum_value(&s->brought[k]));
	}
}

/* The parts on one partner: sign and arm are his. `drive`: velocity of the other's surface that is not in
 * the columns of particles. */
static void book(double *own, int side, const struct ts_contact_parts *parts, double sign, double arm,
		 const double drive[3])
{
	double *cause = own + ts_ledger_cause(side, 0) * TS_CAUSE_NUMBERS;

	own[TS_LEDGER_BUSY] = 1;
	for (int part = 0; part < TS_NPART; part++) {
		double *to = cause + part * TS_CAUSE_NUMBERS;

		ts_axpy(sign, parts->force[part], to + TS_CAUSE_FORCE);
		ts_axpy(arm, parts->turn[part], to + TS_CAUSE_TORQUE);
		to[TS_CAUSE_DRIVE] += sign * ts_dot(parts->force[part], drive);
	}
	ts_axpy(sign, parts->roll, cause + TS_PART_ROLLING * TS_CAUSE_NUMBERS + TS_CAUSE_TORQUE);
}

/* Normal springs that do not give back what they got: they yield, the energy jumps as surfaces meet
 * and part, or other contacts move the surface. */
static bool loses(const struct ts_granular_model *m)
{
	return m->normal == TS_NORMAL_HOOKE_HYSTERESIS || ts_normal_sticks(m) || m->multi;
}

struct row_work {
	struct tsim *sim;
	struct ts_ledger *l;
	const struct ts_pair *pair;
	struct sums sums;
};

/* Row r as its partner of that side sees it. */
static void book_row(struct row_work *w, size_t r, int side, size_t own)
{
	static const double still[3] = { 0 };
	const struct ts_contact_list *rows = &w->sim->neigh->contacts;
	const struct ts_particles *p = w->sim->particles;
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
	const struct ts_granular_model *m = ts_pair_model(w->pair, p->type[i], p->type[j]);
	const double *memory = rows->history_width ? rows->history + r * rows->history_width : NULL;
	double sign = side ? -1 : 1, drive[3] = { 0 };
	struct ts_contact_parts parts;
	struct ts_touch t;

	ts_contact_touch(p, i, j, m, &t);
	ts_granular_stand_out(m, memory, &t);
	ts_contact_split(m, ts_pair_law(w->pair, p->type[i], p->type[j]), &t, memory,
			 ts_contact_force(rows, r),
			 rows->parts > 2 ? ts_contact_rolling_torque(rows, r) : still, &parts);
	if (j >= p->n) { /* an image may move as its original does not; the other half is the mirror row's */
		ts_sub(p->v[j], p->v[p->ghost_owner[j - p->n]], drive);
		ts_scale(0.5, drive, drive);
	}
	if (!w->l->looking)
		book(ts_ledger_causes(w->l, p, own), TS_LEDGER_PAIR, &parts, sign, t.arm[side], drive);
	add_energy(&w->sums, parts.energy, 0.5, p->tag[i] > w->l->newest || p->tag[j] > w->l->newest);
	if (w->l->stepping && (r + 1) * rows->history_width <= w->l->memory_n)
		ts_exactsum_add(&w->sums.slip,
				0.5 * ts_slip_loss(m, ts_pair_law(w->pair, p->type[i], p->type[j]), &t,
						   w->sim->clock.dt, w->l->memory + r * rows->history_width,
						   memory));
	memcpy(w->l->row_energy[r], parts.energy, sizeof parts.energy);
	w->l->plastic[TS_LEDGER_PAIR] |= loses(m);
}

/* Appends a copy. */
static enum ts_status hold(struct tsim *sim, const double *from, size_t n, double **to, size_t *at,
			   size_t *capacity)
{
	if (TS_GROW(*to, *capacity, *at + n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	if (n)
		memcpy(*to + *at, from, n * sizeof **to);
	*at += n;
	return TS_OK;
}

enum ts_status ts_ledger_hold_rows(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_contact_list *rows = &sim->neigh->contacts;

	ts_contacts_store_history(sim, rows);
	l->memory_n = 0;
	return hold(sim, rows->history, rows->n * rows->history_width, &l->memory, &l->memory_n,
		    &l->memory_capacity);
}

enum ts_status ts_ledger_hold_walls(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_wall *wall;
	size_t k = 0;

	l->wall_memory_n = 0;
	while ((wall = ts_walls_next(sim, &k, NULL)))
		TS_TRY(hold(sim, wall->contacts.memory, wall->contacts.n * wall->contacts.width,
			    &l->wall_memory, &l->wall_memory_n, &l->wall_memory_capacity));
	return TS_OK;
}

/* Where the memory of contact k of this wall was; NULL: not held. */
static const double *held_memory(const struct tsim *sim, const struct ts_ledger *l,
				 const struct ts_wall *wall, size_t contact)
{
	const struct ts_wall *other;
	size_t k = 0, at = contact * wall->contacts.width;

	while ((other = ts_walls_next(sim, &k, NULL)) && other != wall)
		at += other->contacts.n * other->contacts.width;
	return at + wall->contacts.width <= l->wall_memory_n && wall->contacts.width ? l->wall_memory + at
										     : NULL;
}

enum ts_status ts_ledger_take_pairs(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_contact_list *rows = &sim->neigh->contacts;
	const struct ts_gather *g = &rows->gather;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	struct row_work w = { .sim = sim, .l = l, .pair = pair ? pair->state : NULL };

	start_sums(&w.sums);
	ts_contacts_store_history(sim, rows);
	l->rows = rows->n;
	if (TS_GROW(l->row_energy, l->row_capacity, rows->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	memset(l->row_energy, 0, rows->n * sizeof *l->row_energy);
	for (size_t i = 0; pair && rows->n && i < sim->particles->n; i++)
		for (size_t k = g->first[i]; k < g->first[i + 1]; k++)
			if (rows->touching[g->entry[k] >> 1])
				book_row(&w, g->entry[k] >> 1, (int)(g->entry[k] & 1), i);
	end_sums(&w.sums, l, TS_LEDGER_PAIR, true);
	return TS_OK;
}

static enum ts_status note(struct tsim *sim, struct ts_ledger_note **list, size_t *n, size_t *capacity,
			   struct ts_ledger_note entry)
{
	if (TS_GROW(*list, *capacity, *n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	(*list)[(*n)++] = entry;
	return TS_OK;
}

/* What the contacts get goes through the wall's own column, too, so that each wall is known by its work. */
static void book_drive(const struct ts_ledger *l, const struct ts_particles *p, size_t i, size_t actor,
		       const struct ts_contact_parts *parts, const double velocity[3])
{
	const struct ts_column *c = &p->column[l->actor[actor].column];
	double *to = (double *)c->data + i * c->width;

	for (int part = 0; part < TS_NPART; part++)
		to[TS_CAUSE_DRIVE] -= ts_dot(parts->force[part], velocity);
}

static enum ts_status book_wall(struct tsim *sim, struct ts_ledger *l, const struct ts_wall *wall, size_t k,
				size_t actor, struct sums *sums)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_wall_report *r = &wall->contacts.report[k];
	size_t i = (size_t)wall->contacts.row[k];
	struct ts_ledger_note entry = { .tag = { p->tag[i] } };
	struct ts_contact_parts parts;
	struct ts_wall_view view;
	const double *before;

	ts_wall_view(wall, sim, k, &view);
	ts_contact_split(view.model, view.law, &view.touch, ts_wall_memory(&wall->contacts, k), r->force,
			 r->rolling, &parts);
	if (!l->looking)
		book(ts_ledger_causes(l, p, i), TS_LEDGER_WALL, &parts, 1, view.touch.arm[0], r->velocity);
	if (!l->looking)
		book_drive(l, p, i, actor, &parts, r->velocity);
	add_energy(sums, parts.energy, 1, p->tag[i] > l->newest);
	before = held_memory(sim, l, wall, k);
	if (l->stepping && before)
		ts_exactsum_add(&sums->slip, ts_slip_loss(view.model, view.law, &view.touch, sim->clock.dt,
							  before, ts_wall_memory(&wall->contacts, k)));
	memcpy(entry.energy, parts.energy, sizeof parts.energy);
	l->plastic[TS_LEDGER_WALL] |= loses(view.model);
	return note(sim, &l->note, &l->notes, &l->note_capacity, entry);
}

enum ts_status ts_ledger_take_wall(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *inst,
				   size_t actor)
{
	const struct ts_wall *wall = inst->state;
	struct sums sums;

	start_sums(&sums);
	for (size_t k = 0; k < wall->contacts.n; k++)
		if (ts_wall_report(&wall->contacts, k))
			TS_TRY(book_wall(sim, l, wall, k, actor, &sums));
	end_sums(&sums, l, TS_LEDGER_WALL, false);
	return TS_OK;
}

/* What a bond stores that is no more: half before and half after the last move, since its force ended
 * between. */
static double broken_energy(const struct tsim *sim, const struct ts_ledger_note *was)
{
	const struct ts_bonds *bonds = sim->bonds;
	const struct ts_bond *state = ts_sim_only(sim, TS_KIND_BOND)->state;
	const struct ts_bond_style *style = ts_bond_style_of(ts_sim_only(sim, TS_KIND_BOND));

	for (size_t e = bonds->nevents; e-- > 0 && bonds->event[e].step == sim->clock.step;) {
		const struct ts_bond_event *event = &bonds->event[e];
		const void *coeff = ts_coeff(&state->coeffs, (size_t)event->type);

		if (event->tag[0] == was->tag[0] && event->tag[1] == was->tag[1])
			return 0.5 * (was->energy[0] +
				      style->energy(coeff, event->force / style->stiffness(coeff)));
	}
	return was->energy[0];
}

/* Both lists are sorted by identities. */
static void find_broken(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_exactsum broken = ts_exactsum_start();
	size_t b = 0;

	for (size_t k = 0; k < l->bonds; k++) {
		const int32_t *tag = l->bond[k].tag;

		while (b < bonds->n && (bonds->tag[b][0] < tag[0] ||
					(bonds->tag[b][0] == tag[0] && bonds->tag[b][1] < tag[1])))
			b++;
		if (b == bonds->n || bonds->tag[b][0] != tag[0] || bonds->tag[b][1] != tag[1])
			ts_exactsum_add(&broken, broken_energy(sim, &l->bond[k]));
	}
	ts_compensated_add(&l->broken, ts_exactsum_value(&broken));
}

static enum ts_status book_bond(struct tsim *sim, struct ts_ledger *l, size_t b, struct ts_exactsum *sum)
{
	const struct ts_instance *inst = ts_sim_only(sim, TS_KIND_BOND);
	const struct ts_bond *state = inst->state;
	const struct ts_bond_style *style = ts_bond_style_of(inst);
	const struct ts_bonds *bonds = sim->bonds;
	const void *coeff = ts_coeff(&state->coeffs, (size_t)bonds->type[b]);
	struct ts_ledger_note entry = { .tag = { bonds->tag[b][0], bonds->tag[b][1] } };
	struct ts_contact_view view;
	double spring[3], extension;

	ts_contact_view_of_bond(sim, b, &view);
	extension = view.distance - bonds->rest[b];
	ts_scale(view.distance > 0 ? -style->stiffness(coeff) * extension / view.distance : 0, view.d,
		 spring);
	for (int s = 0; s < 2; s++) {
		double sign = s ? -1 : 1;
		double *own = ts_ledger_causes(l, sim->particles, s ? view.b : view.a);
		double *to = own + TS_CAUSE_BOND * TS_CAUSE_NUMBERS;

		own[TS_LEDGER_BUSY] = 1;
		for (int d = 0; d < 3 && !l->looking; d++) {
			to[d] += sign * spring[d];
			to[TS_CAUSE_NUMBERS + d] += sign * (view.force[d] - spring[d]);
		}
	}
	entry.energy[0] = style->energy(coeff, extension);
	ts_exactsum_add(sum, entry.energy[0]);
	return note(sim, &l->bond, &l->bonds, &l->bond_capacity, entry);
}

enum ts_status ts_ledger_take_bonds(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_exactsum sum = ts_exactsum_start();

	if (l->stepping)
		find_broken(sim, l);
	l->bonds = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		TS_TRY(book_bond(sim, l, b, &sum));
	if (!l->looking)
		l->store[TS_LEDGER_BOND] = ts_exactsum_value(&sum);
	return TS_OK;
}

static void take_rows(struct tsim *sim, struct ts_ledger *l, const struct ts_identities *map)
{
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	struct ts_exactsum gone[TS_NCONTACT_STORE];

	for (int k = 0; k < TS_NCONTACT_STORE; k++)
		gone[k] = ts_exactsum_start();
	for (size_t r = 0; r < l->rows && r < rows->n; r++) {
		/* the contact across a periodic face has two rows */
		double share = (size_t)rows->j[r] < rows->particles ? -1 : -0.5;

		if (ts_contact_of(map, rows->tag[0][r]) >= 0 && ts_contact_of(map, rows->tag[1][r]) >= 0)
			continue;
		for (int k = 0; k < TS_NCONTACT_STORE; k++)
			ts_exactsum_add(&gone[k], share * l->row_energy[r][k]);
		memset(l->row_energy[r], 0, sizeof l->row_energy[r]);
	}
	for (int k = 0; k < TS_NCONTACT_STORE; k++)
		ts_compensated_add(&l->moved[ts_ledger_store(TS_LEDGER_PAIR, k)],
				   ts_exactsum_value(&gone[k]));
}

/* Drops the notes of those that are gone; their energy by store. */
static void take_notes(struct ts_ledger *l, struct ts_ledger_note *list, size_t *n, int store, int count,
		       const struct ts_identities *map)
{
	struct ts_exactsum gone[TS_NCONTACT_STORE];
	size_t kept = 0;

	for (int k = 0; k < count; k++)
		gone[k] = ts_exactsum_start();
	for (size_t e = 0; e < *n; e++) {
		const int32_t *tag = list[e].tag;
		bool here = ts_contact_of(map, tag[0]) >= 0 && (!tag[1] || ts_contact_of(map, tag[1]) >= 0);

		for (int k = 0; k < count && !here; k++)
			ts_exactsum_add(&gone[k], -list[e].energy[k]);
		if (here)
			list[kept++] = list[e];
	}
	*n = kept;
	for (int k = 0; k < count; k++)
		ts_compensated_add(&l->moved[store + k], ts_exactsum_value(&gone[k]));
}

enum ts_status ts_ledger_take_away(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	take_rows(sim, l, &map);
	take_notes(l, l->note, &l->notes, ts_ledger_store(TS_LEDGER_WALL, 0), TS_NCONTACT_STORE, &map);
	take_notes(l, l->bond, &l->bonds, TS_LEDGER_BOND, 1, &map);
	return TS_OK;
}
