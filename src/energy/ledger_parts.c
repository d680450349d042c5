/* Forces and elastic energies of contacts and bonds by cause, right after the force computation. */
#include <stddef.h>
#include <string.h>

#include "bond/bond_moment.h"
#include "contact/contact_loop.h"
#include "contact/contact_view.h"
#include "energy/ledger.h"
#include "neigh/contact_memory.h"
#include "neigh/touching_sums.h"
#include "particle/identity.h"
#include "wall/wall.h"

#include "base/banned.h"

/* Sums over contacts: energies by store, of these what contacts have brought, and SLIP. */
enum { BROUGHT = TS_NCONTACT_STORE, SLIP = 2 * TS_NCONTACT_STORE, NSUMS };
struct sums {
	struct ts_exactsum of[NSUMS];
};

static void sums_start(struct sums *s)
{
	for (int k = 0; k < NSUMS; k++)
		s->of[k] = ts_exactsum_start();
}

/* `fresh`: one of the partners was added after the last force computation, and the contact with it. */
static void add_energy(struct sums *s, const double energy[], double fraction, bool fresh)
{
	for (int k = 0; k < TS_NCONTACT_STORE; k++) {
		if (energy[k] == 0)
			continue;
		ts_exactsum_add(&s->of[k], fraction * energy[k]);
		if (fresh)
			ts_exactsum_add(&s->of[BROUGHT + k], fraction * energy[k]);
	}
}

static enum ts_status post_contacts(struct tsim *sim, struct ts_ledger *l,
				    const struct ts_ledger_entry *entry, const double *value)
{
	bool stepping = entry->flags & TS_LEDGER_STEPPING;

	(void)sim;
	if (stepping)
		ts_compensated_add(&l->slip[entry->side], value[SLIP]);
	for (int k = 0; k < TS_NCONTACT_STORE; k++) {
		int store = ts_ledger_store(entry->side, k);

		l->store[store] = (entry->flags & TS_LEDGER_FIRST ? 0 : l->store[store]) + value[k];
		if (stepping)
			ts_compensated_add(&l->moved[store], value[BROUGHT + k]);
	}
	return TS_OK;
}

static enum ts_status sums_finish(struct tsim *sim, const struct sums *s, struct ts_ledger *l, int side,
				  bool first)
{
	struct ts_ledger_entry entry = { .post = post_contacts, .side = side, .n = NSUMS };

	entry.flags = (l->stepping ? TS_LEDGER_STEPPING : 0) | (first ? TS_LEDGER_FIRST : 0);
	return l->already_accounted ? TS_OK : ts_ledger_enter(sim, l, &entry, s->of);
}

/* Adds the force parts to the columns of one partner, with its sign and lever arm. `drive`: velocity of
 * the surface of the other partner that is not in the particle columns. */
static void add_parts_to_columns(double *own, int side, const struct ts_contact_parts *parts, double sign,
				 double arm, const double drive[3])
{
	double *cause = own + ts_ledger_cause(side, 0) * TS_CAUSE_NUMBERS;

	own[TS_LEDGER_NONZERO] = 1;
	for (int part = 0; part < TS_NPART; part++) {
		double *to = cause + part * TS_CAUSE_NUMBERS;

		ts_axpy(sign, parts->force[part], to + TS_CAUSE_FORCE);
		ts_axpy(arm, parts->turn[part], to + TS_CAUSE_TORQUE);
		to[TS_CAUSE_DRIVE] += sign * ts_dot(parts->force[part], drive);
	}
	ts_axpy(sign, parts->roll, cause + TS_PART_ROLLING * TS_CAUSE_NUMBERS + TS_CAUSE_TORQUE);
}

/* Whether normal springs do not return the energy put in: plastic laws, laws whose energy jumps when
 * surfaces touch or part, and multi-contact laws whose surface is moved by other contacts. */
static bool is_inelastic(const struct ts_granular_model *m)
{
	return m->normal == TS_NORMAL_HOOKE_HYSTERESIS || ts_normal_sticks(m) || m->multi;
}

struct pair_accounting {
	struct tsim *sim;
	struct ts_ledger *l;
	const struct ts_pair *pair;
	struct sums sums;
};

/* Accounts contact r of the list for its partner `own` on the given side. */
static void account_pair(struct pair_accounting *w, size_t r, int side, size_t own)
{
	static const double zero[3] = { 0 };
	const struct ts_contact_list *rows = &w->sim->neigh->contacts;
	const struct ts_particles *p = w->sim->particles;
	size_t i = (size_t)rows->i[r], j = (size_t)rows->j[r];
	const struct ts_granular_model *m = ts_pair_model(w->pair, p->type[i], p->type[j]);
	const double *memory = rows->history_width ? ts_contact_history(rows, r) : NULL;
	double sign = side ? -1 : 1, drive[3] = { 0 };
	struct ts_contact_parts parts;
	struct ts_touch t;

	ts_contact_touch(p, i, j, m, &t);
	ts_granular_add_bulge(m, memory, &t);
	ts_contact_split(m, ts_pair_law(w->pair, p->type[i], p->type[j]), &t, memory,
			 ts_contact_force(rows, ts_contact_kept(rows, r)),
			 rows->parts > 2 ? ts_contact_rolling_torque(rows, ts_contact_kept(rows, r)) : zero,
			 &parts);
	/* a periodic image may move relative to its original; the other half is accounted by the
	 * mirrored pair */
	if (j >= p->n) {
		ts_sub(p->v[j], p->v[p->ghost_owner[j - p->n]], drive);
		ts_scale(0.5, drive, drive);
	}
	if (!w->l->already_accounted)
		add_parts_to_columns(ts_ledger_causes(w->l, p, own), TS_LEDGER_PAIR, &parts, sign,
				     t.arm[side], drive);
	add_energy(&w->sums, parts.energy, 0.5, p->tag[i] > w->l->newest || p->tag[j] > w->l->newest);
	if (w->l->stepping && (r + 1) * rows->history_width <= w->l->memory_n)
		ts_exactsum_add(&w->sums.of[SLIP],
				0.5 * ts_slip_loss(m, ts_pair_law(w->pair, p->type[i], p->type[j]), &t,
						   w->sim->clock.dt, w->l->memory + r * rows->history_width,
						   memory));
	memcpy(w->l->row_energy[r], parts.energy, sizeof parts.energy);
	w->l->plastic[TS_LEDGER_PAIR] |= is_inelastic(m);
}

/* Appends a copy of n numbers. */
static enum ts_status append_history(struct tsim *sim, const double *from, size_t n, double **to, size_t *at,
				     size_t *capacity)
{
	if (TS_GROW(*to, *capacity, *at + n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	if (n)
		memcpy(*to + *at, from, n * sizeof **to);
	*at += n;
	return TS_OK;
}

enum ts_status ts_ledger_store_pair_history(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_contact_list *rows = &sim->neigh->contacts;

	ts_contacts_store_history(sim, rows);
	l->memory_n = 0;
	for (size_t r = 0; r < rows->n && rows->history_width; r++)
		TS_TRY(append_history(sim, ts_contact_history(rows, r), rows->history_width, &l->memory,
				      &l->memory_n, &l->memory_capacity));
	return TS_OK;
}

enum ts_status ts_ledger_store_wall_history(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_wall *wall;
	size_t k = 0;

	l->wall_memory_n = 0;
	while ((wall = ts_walls_next(sim, &k, NULL)))
		TS_TRY(append_history(sim, wall->contacts.memory, wall->contacts.n * wall->contacts.width,
				      &l->wall_memory, &l->wall_memory_n, &l->wall_memory_capacity));
	return TS_OK;
}

/* Stored history of contact `contact` of this wall; NULL: none was stored. */
static const double *stored_wall_history(const struct tsim *sim, const struct ts_ledger *l,
					 const struct ts_wall *wall, size_t contact)
{
	const struct ts_wall *other;
	size_t k = 0, at = contact * wall->contacts.width;

	while ((other = ts_walls_next(sim, &k, NULL)) && other != wall)
		at += other->contacts.n * other->contacts.width;
	return at + wall->contacts.width <= l->wall_memory_n && wall->contacts.width ? l->wall_memory + at
										     : NULL;
}

enum ts_status ts_ledger_account_pairs(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_contact_list *rows = &sim->neigh->contacts;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	struct pair_accounting w = { .sim = sim, .l = l, .pair = pair ? pair->state : NULL };
	uint32_t entry;

	sums_start(&w.sums);
	ts_contacts_store_history(sim, rows);
	l->rows = rows->n;
	if (TS_GROW(l->row_energy, l->row_capacity, rows->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	memset(l->row_energy, 0, rows->n * sizeof *l->row_energy);
	for (size_t i = 0; pair && rows->n && i < sim->particles->n; i++)
		for (struct ts_touching t = ts_touching_of(rows, i); ts_touching_next(rows, &t, &entry);)
			account_pair(&w, entry >> 1, (int)(entry & 1), i);
	return sums_finish(sim, &w.sums, l, TS_LEDGER_PAIR, true);
}

static enum ts_status append_note(struct tsim *sim, struct ts_ledger_note **list, size_t *n, size_t *capacity,
				  struct ts_ledger_note entry)
{
	if (TS_GROW(*list, *capacity, *n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	(*list)[(*n)++] = entry;
	return TS_OK;
}

/* The power that contacts get from a moving wall is also subtracted in the column of the wall, so that
 * the work of each wall is known. */
static void add_wall_power(const struct ts_ledger *l, const struct ts_particles *p, size_t i, size_t actor,
			   const struct ts_contact_parts *parts, const double velocity[3])
{
	const struct ts_column *c = &p->column[l->actor[actor].column];
	double *to = (double *)c->data + i * c->width;

	for (int part = 0; part < TS_NPART; part++)
		to[TS_CAUSE_DRIVE] -= ts_dot(parts->force[part], velocity);
}

static enum ts_status account_wall_contact(struct tsim *sim, struct ts_ledger *l, const struct ts_wall *wall,
					   size_t k, size_t actor, struct sums *sums)
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
	if (!l->already_accounted)
		add_parts_to_columns(ts_ledger_causes(l, p, i), TS_LEDGER_WALL, &parts, 1, view.touch.arm[0],
				     r->velocity);
	if (!l->already_accounted)
		add_wall_power(l, p, i, actor, &parts, r->velocity);
	add_energy(sums, parts.energy, 1, p->tag[i] > l->newest);
	before = stored_wall_history(sim, l, wall, k);
	if (l->stepping && before)
		ts_exactsum_add(&sums->of[SLIP],
				ts_slip_loss(view.model, view.law, &view.touch, sim->clock.dt, before,
					     ts_wall_memory(&wall->contacts, k)));
	memcpy(entry.energy, parts.energy, sizeof parts.energy);
	l->plastic[TS_LEDGER_WALL] |= is_inelastic(view.model);
	return append_note(sim, &l->note, &l->notes, &l->note_capacity, entry);
}

enum ts_status ts_ledger_account_wall(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *inst,
				      size_t actor)
{
	const struct ts_wall *wall = inst->state;
	struct sums sums;

	sums_start(&sums);
	for (size_t k = 0; k < wall->contacts.n; k++)
		if (ts_wall_report(&wall->contacts, k))
			TS_TRY(account_wall_contact(sim, l, wall, k, actor, &sums));
	return sums_finish(sim, &sums, l, TS_LEDGER_WALL, false);
}

/* In the way of a run that is continued. */
enum ts_status ts_ledger_note_contacts(struct tsim *sim, struct ts_ledger *l)
{
	const bool stepping = l->stepping;
	const struct ts_instance *wall;
	enum ts_status status;
	size_t k = 0;

	l->stepping = false;
	l->already_accounted = true;
	l->notes = 0;
	status = ts_ledger_account_pairs(sim, l);
	while (status == TS_OK && ts_walls_next(sim, &k, &wall))
		status = ts_ledger_account_wall(sim, l, wall, 0);
	l->already_accounted = false;
	l->stepping = stepping;
	return status;
}

/* Elastic energy lost with a broken bond: the mean of the energies before and after the last move, as
 * its force ended in between. */
static double broken_energy(const struct tsim *sim, const struct ts_ledger_note *was)
{
	const struct ts_bonds *bonds = sim->bonds;
	double before = was->energy[0];

	for (int mode = 1; mode < TS_BOND_MODES; mode++)
		before += was->energy[mode];

	for (size_t e = bonds->nevents;
	     e-- > bonds->past_events && bonds->event[e].step == sim->clock.step;) {
		const struct ts_bond_event *event = &bonds->event[e];

		if (event->tag[0] == was->tag[0] && event->tag[1] == was->tag[1])
			return 0.5 * (before + bonds->event_energy[e]);
	}
	return before;
}

/* Accounts bonds that were listed in the last step and are not any more. Both lists are sorted by
 * identities. */
static enum ts_status account_broken_bonds(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_ledger_entry entry = { .post = ts_ledger_post_account,
					       .at = offsetof(struct ts_ledger, broken),
					       .n = 1 };
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_exactsum broken = ts_exactsum_start();
	size_t b = 0;

	if (sim->division)
		return ts_ledger_account_missing(sim, l);
	for (size_t k = 0; k < l->bonds; k++) {
		const int32_t *tag = l->bond[k].tag;

		while (b < bonds->n && (bonds->tag[b][0] < tag[0] ||
					(bonds->tag[b][0] == tag[0] && bonds->tag[b][1] < tag[1])))
			b++;
		if (b == bonds->n || bonds->tag[b][0] != tag[0] || bonds->tag[b][1] != tag[1])
			ts_exactsum_add(&broken, broken_energy(sim, &l->bond[k]));
	}
	return ts_ledger_enter(sim, l, &entry, &broken);
}

static enum ts_status account_bond(struct tsim *sim, struct ts_ledger *l, size_t b, struct ts_exactsum sum[])
{
	const struct ts_bonds *bonds = sim->bonds;
	struct ts_ledger_note entry = { .tag = { bonds->tag[b][0], bonds->tag[b][1] } };
	const struct ts_particles *p = sim->particles;
	struct ts_contact_view view;
	struct ts_bond_load spring;

	ts_contact_view_of_bond(sim, b, &view);
	ts_bond_spring_load(sim, b, &spring);
	for (int s = 0; s < 2; s++) {
		double sign = s ? -1 : 1;
		double *own = ts_ledger_causes(l, p, s ? view.b : view.a);
		double *to = own + TS_CAUSE_BOND * TS_CAUSE_NUMBERS;

		if ((s ? view.b : view.a) >= p->n) /* a particle of another rank */
			continue;
		own[TS_LEDGER_NONZERO] = 1;
		for (int d = 0; d < 3 && !l->already_accounted; d++) {
			to[d] += sign * spring.force[d];
			to[TS_CAUSE_NUMBERS + d] += sign * (view.force[d] - spring.force[d]);
			if (!bonds->transmits)
				continue;
			to[TS_CAUSE_TORQUE + d] += spring.torque[s][d];
			to[TS_CAUSE_NUMBERS + TS_CAUSE_TORQUE + d] +=
				bonds->load[b].torque[s][d] - spring.torque[s][d];
		}
	}
	if (view.a >= p->n)
		return TS_OK;
	ts_bond_energy(sim, b, entry.energy);
	for (int mode = 0; mode < TS_BOND_MODES; mode++)
		ts_exactsum_add(&sum[mode], entry.energy[mode]);
	return append_note(sim, &l->bond, &l->bonds, &l->bond_capacity, entry);
}

static enum ts_status post_bonds(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				 const double *value)
{
	(void)sim, (void)entry;
	for (int mode = 0; mode < TS_BOND_MODES; mode++)
		l->store[TS_LEDGER_BOND + mode] = value[mode];
	return TS_OK;
}

enum ts_status ts_ledger_account_bonds(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_ledger_entry yielded = { .post = ts_ledger_post_account,
						 .at = offsetof(struct ts_ledger, yielded),
						 .n = 1 },
				     entry = { .post = post_bonds, .n = TS_BOND_MODES };
	struct ts_exactsum sum[TS_BOND_MODES];

	if (!ts_sim_only(sim, TS_KIND_BOND)) /* bond_style none: bonds exert no force */
		return TS_OK;
	for (int mode = 0; mode < TS_BOND_MODES; mode++)
		sum[mode] = ts_exactsum_start();
	if (l->stepping) {
		TS_TRY(account_broken_bonds(sim, l));
		TS_TRY(ts_ledger_enter(sim, l, &yielded, &sim->bonds->flow));
	}
	l->bonds = 0;
	for (size_t b = 0; b < sim->bonds->n; b++)
		TS_TRY(account_bond(sim, l, b, sum));
	return l->already_accounted ? TS_OK : ts_ledger_enter(sim, l, &entry, sum);
}

/* Particles that are not there any more: those without a row, with several ranks those that are listed. */
struct absence {
	const struct ts_ledger *l;
	struct ts_identities map;
	bool divided;
};

static bool is_absent(const struct absence *a, int32_t tag)
{
	return a->divided ? ts_ledger_is_deleted(a->l, tag) : ts_identity_row(&a->map, tag) < 0;
}

static enum ts_status post_removed(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				   const double *value)
{
	(void)sim;
	for (size_t k = 0; k < entry->n; k++)
		ts_compensated_add(&l->moved[entry->at + k], value[k]);
	return TS_OK;
}

static enum ts_status remove_pairs_of_deleted(struct tsim *sim, struct ts_ledger *l, const struct absence *a)
{
	const struct ts_ledger_entry entry = { .post = post_removed,
					       .at = (size_t)ts_ledger_store(TS_LEDGER_PAIR, 0),
					       .n = TS_NCONTACT_STORE };
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	struct ts_exactsum gone[TS_NCONTACT_STORE];

	for (int k = 0; k < TS_NCONTACT_STORE; k++)
		gone[k] = ts_exactsum_start();
	for (size_t r = 0; r < l->rows && r < rows->n; r++) {
		/* a contact across a periodic face, or of particles of two ranks, has two rows */
		double fraction = (size_t)rows->j[r] < rows->particles ? -1 : -0.5;

		if (!is_absent(a, ts_contact_tag(rows, r, 0)) && !is_absent(a, ts_contact_tag(rows, r, 1)))
			continue;
		for (int k = 0; k < TS_NCONTACT_STORE; k++)
			ts_exactsum_add(&gone[k], fraction * l->row_energy[r][k]);
		memset(l->row_energy[r], 0, sizeof l->row_energy[r]);
	}
	return ts_ledger_enter(sim, l, &entry, gone);
}

/* Removes the entries of deleted particles; accounts their energy by store. */
static enum ts_status remove_notes_of_deleted(struct tsim *sim, struct ts_ledger *l,
					      struct ts_ledger_note *list, size_t *n,
					      const struct ts_ledger_entry *entry, const struct absence *a)
{
	struct ts_exactsum gone[TS_LEDGER_NOTE_ENERGIES];
	size_t kept = 0;

	for (size_t k = 0; k < entry->n; k++)
		gone[k] = ts_exactsum_start();
	for (size_t e = 0; e < *n; e++) {
		const int32_t *tag = list[e].tag;
		bool here = !is_absent(a, tag[0]) && (!tag[1] || !is_absent(a, tag[1]));

		for (size_t k = 0; k < entry->n && !here; k++)
			ts_exactsum_add(&gone[k], -list[e].energy[k]);
		if (here)
			list[kept++] = list[e];
	}
	*n = kept;
	return ts_ledger_enter(sim, l, entry, gone);
}

enum ts_status ts_ledger_account_removed(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_ledger_entry walls = { .post = post_removed,
					       .at = (size_t)ts_ledger_store(TS_LEDGER_WALL, 0),
					       .n = TS_NCONTACT_STORE },
				     bonds = { .post = post_removed,
					       .at = TS_LEDGER_BOND,
					       .n = TS_BOND_MODES };
	struct absence a = { .l = l, .divided = sim->division != NULL };

	if (!a.divided)
		TS_TRY(ts_identities(sim, false, &a.map));
	TS_TRY(remove_pairs_of_deleted(sim, l, &a));
	TS_TRY(remove_notes_of_deleted(sim, l, l->note, &l->notes, &walls, &a));
	return remove_notes_of_deleted(sim, l, l->bond, &l->bonds, &bonds, &a);
}
