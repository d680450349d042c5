/* What the ledger records in each stage of a step. */
#include "energy/ledger.h"

#include <stdio.h>
#include <string.h>

#include "bond/bonds.h"
#include "contact/pair.h"
#include "core/sim.h"
#include "math/quaternion.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/particles.h"
#include "rigid/rigid.h"
#include "wall/wall.h"

#include "base/banned.h"

enum { NOTHING_DUE = -1 };

static const char *actor_name(struct tsim *sim, const struct ts_instance *by)
{
	char name[160];

	snprintf(name, sizeof name, "%s %s", ts_kind_name(by->style->kind),
		 *by->id ? by->id : by->style->name);
	return ts_pool_get(sim->pool, name);
}

enum ts_status ts_ledger_actor(struct tsim *sim, struct ts_ledger *l, const struct ts_instance *by, size_t *k)
{
	const char *name = actor_name(sim, by);

	if (!name)
		return ts_nomem(&sim->error);
	for (*k = 0; *k < l->nactors; ++*k)
		if (ts_streq(l->actor[*k].name, name))
			break;
	if (*k < l->nactors)
		return TS_OK;
	if (TS_GROW(l->actor, l->actor_capacity, *k + 1) != TS_OK)
		return ts_nomem(&sim->error);
	memset(&l->actor[*k], 0, sizeof *l->actor);
	l->actor[l->nactors++].name = name;
	return TS_OK;
}

static enum ts_status add_named_column(struct tsim *sim, const struct ts_ledger *l, const char *of,
				       size_t width, size_t *index)
{
	char name[240];

	snprintf(name, sizeof name, "energy/ledger %s: %s", l->name, of);
	return ts_particles_add_column(sim, name, width, TS_COL_RESULT, index);
}

static bool is_wall(const struct ts_instance *inst)
{
	return inst->style->family && ts_streq(inst->style->family, TS_FAMILY_WALL);
}

/* Whether the forces of a style are found as the differences that its hooks add, or by wall contacts. */
static int force_kind(const struct ts_instance *inst)
{
	if (is_wall(inst))
		return TS_LEDGER_IS_WALL;
	return inst->style->hook[TS_STAGE_PRE_FORCE] || inst->style->hook[TS_STAGE_FORCE] ||
	       inst->style->hook[TS_STAGE_POST_FORCE];
}

static enum ts_status register_actors(struct tsim *sim, struct ts_ledger *l, enum ts_kind kind)
{
	const struct ts_instances *list = &sim->instances[kind];
	size_t a;

	for (size_t k = 0; k < list->n; k++) {
		TS_TRY(ts_ledger_actor(sim, l, list->item[k], &a));
		l->actor[a].by = list->item[k];
		if (list->item[k]->state == l) {
			l->rest = a;
			l->actor[a].pushes = TS_LEDGER_PUSHES;
		}
		if (force_kind(list->item[k]))
			l->actor[a].pushes = force_kind(list->item[k]);
	}
	return TS_OK;
}

/* Deleted actors keep their column as long as it carries their last forces. */
static enum ts_status add_columns(struct tsim *sim, struct ts_ledger *l)
{
	TS_TRY(add_named_column(sim, l, "contacts and bonds", TS_LEDGER_COLUMN, &l->column));
	for (size_t a = 0; a < l->nactors; a++)
		if (l->actor[a].pushes)
			TS_TRY(add_named_column(sim, l, l->actor[a].name, TS_CAUSE_NUMBERS,
						&l->actor[a].column));
	return TS_OK;
}

/* Allocates the arrays of per-particle data of a step. Old contents need not be kept: after particles
 * have been added, removed or reordered they are invalid. */
static enum ts_status allocate_particle_arrays(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_particles *p = sim->particles;
	size_t n = p->n + 1;
	size_t room[7] = { l->capacity, l->capacity, l->capacity, l->capacity,
			   l->capacity, l->capacity, l->capacity };

	if (l->capacity >= n)
		return TS_OK;
	if (TS_GROW(l->v, room[0], n) != TS_OK || TS_GROW(l->omega, room[1], n) != TS_OK ||
	    TS_GROW(l->seen_v, room[2], n) != TS_OK || TS_GROW(l->seen_omega, room[3], n) != TS_OK ||
	    TS_GROW(l->f, room[4], n) != TS_OK || TS_GROW(l->torque, room[5], n) != TS_OK ||
	    TS_GROW(l->kicker, room[6], n) != TS_OK)
		return ts_nomem(&sim->error);
	l->capacity = room[0];
	return TS_OK;
}

static void store_forces(const struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_particles *p = sim->particles;

	if (p->n)
		memcpy(l->f, p->f, p->n * sizeof *p->f);
	if (p->n && p->torque)
		memcpy(l->torque, p->torque, p->n * sizeof *p->torque);
}

static enum ts_status post_clear(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				 const double *value)
{
	(void)sim, (void)entry, (void)value;
	for (int k = 0; k < TS_NCONTACT_STORE; k++)
		l->store[ts_ledger_store(TS_LEDGER_WALL, k)] = 0;
	ts_ledger_heat_clear(l);
	return TS_OK;
}

/* Before the force computation: the forces of the last step have done their work. */
static enum ts_status clear_force_columns(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_ledger_entry clear = { .post = post_clear };
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		double *cause = ts_ledger_causes(l, p, i);

		if (cause[TS_LEDGER_NONZERO] > 0)
			memset(cause, 0, TS_NCAUSE * TS_CAUSE_NUMBERS * sizeof *cause);
		cause[TS_LEDGER_NONZERO] = 0;
	}
	for (size_t a = 0; a < l->nactors; a++)
		if (l->actor[a].pushes && p->n)
			memset(p->column[l->actor[a].column].data, 0,
			       p->n * TS_CAUSE_NUMBERS * sizeof(double));
	l->notes = 0;
	l->split = l->made = 1;
	store_forces(sim, l);
	return ts_ledger_enter(sim, l, &clear, NULL);
}

/* Forces on a rigid body as a whole are attributed to its first member: the force, and the torque that
 * moves it to the centre of mass. */
static void add_external_forces_of_bodies(struct tsim *sim, struct ts_ledger *l,
					  const struct ts_column *column)
{
	struct ts_rigid *rigid = sim->rigid;
	const struct ts_particles *p = sim->particles;

	for (size_t b = 0; b < rigid->n && b < l->bodies; b++) {
		size_t i = (size_t)rigid->member[rigid->start[b]];
		double *to = (double *)column->data + i * column->width;
		double push[3], m[3][3], arm[3], turn[3];

		ts_sub(rigid->body[b].external, l->body[b].external, push);
		ts_quaternion_matrix(rigid->body[b].q, m);
		ts_rotate(m, p->body_x[i], arm);
		ts_cross(arm, push, turn);
		if (i < p->n) {
			ts_axpy(1, push, to + TS_CAUSE_FORCE);
			ts_axpy(-1, turn, to + TS_CAUSE_TORQUE);
		}
		memcpy(l->body[b].external, rigid->body[b].external, sizeof push);
	}
}

/* The forces that the action has added. */
static enum ts_status add_force_differences(struct tsim *sim, struct ts_ledger *l, size_t actor)
{
	struct ts_particles *p = sim->particles;
	const struct ts_column *column = &p->column[l->actor[actor].column];

	for (size_t i = 0; i < p->n; i++) {
		double *to = (double *)column->data + i * column->width;

		for (int d = 0; d < 3; d++) {
			to[TS_CAUSE_FORCE + d] += p->f[i][d] - l->f[i][d];
			if (p->torque)
				to[TS_CAUSE_TORQUE + d] += p->torque[i][d] - l->torque[i][d];
		}
	}
	add_external_forces_of_bodies(sim, l, column);
	return TS_OK;
}

static enum ts_status account_forces(struct tsim *sim, struct ts_ledger *l, struct ts_instance *by)
{
	bool computed = sim->acted.stage == TS_STAGE_FORCE; /* bonds may also act before, to be created */
	size_t actor;

	if (computed && by->style->kind == TS_KIND_PAIR)
		TS_TRY(ts_ledger_account_pairs(sim, l));
	else if (computed && by->style->kind == TS_KIND_BOND)
		TS_TRY(ts_ledger_account_bonds(sim, l));
	TS_TRY(ts_ledger_actor(sim, l, by, &actor));
	if (is_wall(by))
		TS_TRY(ts_ledger_account_wall(sim, l, by, actor));
	else if (l->actor[actor].pushes && sim->acted.stage > TS_STAGE_PRE_FORCE)
		TS_TRY(add_force_differences(sim, l, actor));
	if (sim->acted.stage > TS_STAGE_PRE_FORCE)
		TS_TRY(ts_ledger_heat_flux(sim, l, actor));
	store_forces(sim, l);
	return TS_OK;
}

static double sum_values(const double *value, size_t n)
{
	double sum = 0;

	for (size_t k = 0; k < n; k++)
		sum += value[k];
	return sum;
}

/* Where a change of the kinetic energy is booked. */
enum book { NO_BOOK, BETWEEN_RUNS, OF_ACTOR };

static enum ts_status post_kinetic(struct tsim *sim, struct ts_ledger *l, const struct ts_ledger_entry *entry,
				   const double *value)
{
	double before = l->kinetic[0] + l->kinetic[1];
	struct ts_compensated_sum *book = entry->at == BETWEEN_RUNS ? &l->between : NULL;
	size_t actor;

	if (entry->at == OF_ACTOR) {
		TS_TRY(ts_ledger_actor(sim, l, entry->by, &actor));
		book = &l->actor[actor].own;
	}
	memcpy(l->kinetic, value, sizeof l->kinetic);
	if (book && l->open)
		ts_compensated_add(book, l->kinetic[0] + l->kinetic[1] - before);
	l->largest_energy =
		fmax(l->largest_energy, l->kinetic[0] + l->kinetic[1] + sum_values(l->store, TS_NSTORE));
	return TS_OK;
}

/* Updates the kinetic energy. */
static enum ts_status update_kinetic_energy(struct tsim *sim, struct ts_ledger *l, enum book book)
{
	const struct ts_ledger_entry entry = { .post = post_kinetic, .at = book, .n = 2 };

	TS_TRY(ts_ledger_kinetic(sim, l, l->own_kinetic));
	return ts_ledger_enter(sim, l, &entry, l->own_kinetic);
}

static bool velocities_changed(const struct tsim *sim, const struct ts_ledger *l)
{
	const struct ts_particles *p = sim->particles;

	return l->generation != sim->generation || l->n != p->n ||
	       (p->n && memcmp(l->seen_v, p->v, p->n * sizeof *p->v) != 0) ||
	       (p->n && p->omega && memcmp(l->seen_omega, p->omega, p->n * sizeof *p->omega) != 0);
}

static enum ts_status store_seen_velocities(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_particles *p = sim->particles;

	TS_TRY(allocate_particle_arrays(sim, l));
	l->n = p->n;
	l->generation = sim->generation;
	if (p->n)
		memcpy(l->seen_v, p->v, p->n * sizeof *p->v);
	if (p->n && p->omega)
		memcpy(l->seen_omega, p->omega, p->n * sizeof *p->omega);
	return TS_OK;
}

static enum ts_status archive_column(struct tsim *sim, struct ts_archive *a, size_t index)
{
	return ts_particles_archive_column(a, sim, sim->particles->column[index].name, index);
}

enum ts_status ts_ledger_archive_columns(struct tsim *sim, struct ts_ledger *l, struct ts_archive *a)
{
	TS_TRY(add_columns(sim, l));
	TS_TRY(archive_column(sim, a, l->column));
	for (size_t k = 0; k < l->nactors; k++)
		if (l->actor[k].pushes)
			TS_TRY(archive_column(sim, a, l->actor[k].column));
	return TS_OK;
}

/* Of walls the law is known once a run begins. */
static enum ts_status require_energy(struct ts_instance *self, struct tsim *sim,
				     const struct ts_granular_model *model)
{
	const char *what = ts_cohesion_bridges(model)		  ? "liquid bridges (cohesion)"
			   : model->normal == TS_NORMAL_EDINBURGH ? "contacts of model edinburgh"
								  : NULL;

	if (!what)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix %s: %s have no potential energy, so there is no energy balance",
		       self->style->name, what);
}

/* Energy that commands have changed since the last run is accounted now; elastic energy after the force
 * computation. */
static enum ts_status begin_run(struct tsim *sim, struct ts_ledger *l)
{
	l->due = NOTHING_DUE;
	l->stepping = l->made = l->already_accounted = false;
	memcpy(l->store_before, l->store, sizeof l->store);
	if (l->open)
		TS_TRY(update_kinetic_energy(sim, l, BETWEEN_RUNS));
	return store_seen_velocities(sim, l);
}

enum ts_status ts_ledger_init(struct ts_instance *self, struct tsim *sim)
{
	static const enum ts_kind kinds[] = { TS_KIND_SYSTEM, TS_KIND_FLOW, TS_KIND_FIX };
	const struct ts_instance *bond = ts_sim_only(sim, TS_KIND_BOND),
				 *pair = ts_sim_only(sim, TS_KIND_PAIR);
	struct ts_ledger *l = self->state;
	const struct ts_wall *wall;

	if (bond && !ts_bond_style_of(bond)->energy && !ts_bond_style_of(bond)->element)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: bond style %s has no potential energy", self->style->name,
			       bond->style->name);
	if (pair)
		TS_TRY(require_energy(self, sim, &((const struct ts_pair *)pair->state)->model));
	for (size_t k = 0; (wall = ts_walls_next(sim, &k, NULL));)
		TS_TRY(require_energy(self, sim, ts_wall_model(wall, sim)));
	l->name = self->id;
	sim->neigh->keep_forces = true;
	for (size_t a = 0; a < l->nactors; a++)
		l->actor[a].by = NULL;
	for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
		TS_TRY(register_actors(sim, l, kinds[k]));
	ts_walls_want_reports(sim);
	TS_TRY(add_columns(sim, l));
	return begin_run(sim, l);
}

/* Forces that were changed between their computation and the first kick of the next step: of particles
 * that are still being inserted by a stream, or that get the drag of a fluid after its step. Rigid
 * bodies are kicked by their own forces. */
static enum ts_status account_late_forces(struct tsim *sim, struct ts_ledger *l)
{
	struct ts_particles *p = sim->particles;
	size_t bytes = p->n * sizeof *p->f;

	if (!p->n ||
	    (memcmp(l->f, p->f, bytes) == 0 && (!p->torque || memcmp(l->torque, p->torque, bytes) == 0)))
		return TS_OK;
	for (size_t i = 0; i < p->n; i++) {
		const struct ts_column *c = &p->column[l->actor[l->rest].column];
		double *to = (double *)c->data + i * c->width;

		for (int d = 0; d < 3 && !ts_rigid_member(p, i); d++) {
			to[TS_CAUSE_FORCE + d] += p->f[i][d] - l->f[i][d];
			if (p->torque)
				to[TS_CAUSE_TORQUE + d] += p->torque[i][d] - l->torque[i][d];
		}
	}
	store_forces(sim, l);
	return TS_OK;
}

/* Whether the last action has deleted particles; with several ranks others may have them now. */
static enum ts_status find_deleted(struct tsim *sim, struct ts_ledger *l, bool *any)
{
	*any = l->stepping && !sim->division && sim->particles->n < l->n;
	return sim->division && sim->acted.stage == TS_STAGE_EXCHANGE ? ts_ledger_find_deleted(sim, l, any)
								      : TS_OK;
}

/* Fixes change masses in these stages: EXCHANGE is executed where lists are rebuilt. */
static bool may_change_masses(const struct tsim *sim, const struct ts_ledger *l, const struct ts_instance *by)
{
	int stage = sim->acted.stage;

	return by->style->kind == TS_KIND_FIX &&
	       (stage == TS_STAGE_POST_INTEGRATE || (stage == TS_STAGE_EXCHANGE && l->stepping));
}

/* Outside the kick stages any change of velocities or masses is a direct change by the acting style. With several ranks
 * those that see none wait, too, for what the others have seen. */
static enum ts_status account_direct_changes(struct tsim *sim, struct ts_ledger *l,
					     const struct ts_instance *by)
{
	bool changed = velocities_changed(sim, l) || may_change_masses(sim, l, by), deleted;
	struct ts_ledger_entry entry = { .post = post_kinetic,
					 .by = by,
					 .at = l->stepping ? OF_ACTOR : BETWEEN_RUNS,
					 .n = 2,
					 .maybe = true };

	if (!changed && !sim->division)
		return TS_OK;
	TS_TRY(find_deleted(sim, l, &deleted));
	changed |= deleted;
	entry.counts = changed;
	if (changed)
		TS_TRY(ts_ledger_kinetic(sim, l, l->own_kinetic));
	TS_TRY(ts_ledger_enter(sim, l, &entry, l->own_kinetic));
	if (deleted)
		TS_TRY(ts_ledger_account_removed(sim, l));
	return changed ? store_seen_velocities(sim, l) : TS_OK;
}

/* Accounts the kicks of the last stage. */
static enum ts_status account_pending_kicks(struct tsim *sim, struct ts_ledger *l)
{
	int due = l->due;

	l->due = NOTHING_DUE;
	if (due == NOTHING_DUE || !l->open)
		return TS_OK;
	TS_TRY(ts_ledger_account_kicks(sim, l, due == TS_STAGE_FINAL_INTEGRATE));
	TS_TRY(update_kinetic_energy(sim, l, NO_BOOK));
	return store_seen_velocities(sim, l);
}

static enum ts_status begin_stage_of_ranks(struct tsim *sim, struct ts_ledger *l)
{
	int stage = sim->acted.stage;

	/* all particles have come since the forces were computed, in a step in which they were divided */
	if (stage == TS_STAGE_END_OF_STEP && !sim->division)
		store_forces(sim, l);
	if (stage == TS_STAGE_EXCHANGE && sim->division)
		return ts_ledger_before_exchange(sim, l);
	if (stage != TS_STAGE_INITIAL_INTEGRATE || !l->relisted)
		return TS_OK;
	l->relisted = false;
	return ts_ledger_note_contacts(sim, l);
}

static enum ts_status begin_stage(struct tsim *sim, struct ts_ledger *l)
{
	int stage = sim->acted.stage;

	bool kicks = stage == TS_STAGE_INITIAL_INTEGRATE || stage == TS_STAGE_FINAL_INTEGRATE;

	TS_TRY(account_pending_kicks(sim, l));
	TS_TRY(allocate_particle_arrays(sim, l));
	l->stepping |= stage == TS_STAGE_INITIAL_INTEGRATE;
	if (sim->world)
		TS_TRY(begin_stage_of_ranks(sim, l));
	if (l->stepping && stage == TS_STAGE_PRE_FORCE)
		TS_TRY(ts_ledger_heat_update(sim, l));
	if (stage == TS_STAGE_FORCE)
		TS_TRY(ts_ledger_store_pair_history(sim, l));
	if (stage == TS_STAGE_POST_FORCE)
		TS_TRY(ts_ledger_store_wall_history(sim, l));
	if (kicks)
		l->due = stage;
	if (kicks || (stage >= TS_STAGE_PRE_FORCE && stage <= TS_STAGE_POST_FORCE))
		return ts_ledger_store_velocities(sim, l);
	return TS_OK;
}

enum ts_status ts_ledger_watch(struct ts_instance *self, struct tsim *sim)
{
	struct ts_ledger *l = self->state;
	struct ts_instance *by = sim->acted.self;
	int stage = sim->acted.stage;
	size_t actor;

	if (sim->world && sim->particles->division && sim->particles->division->rebuilding)
		return by || stage != TS_STAGE_BUILD ? TS_OK : ts_ledger_share_bonds(sim, l);
	if (!by)
		return begin_stage(sim, l);
	if (l->due != NOTHING_DUE) {
		TS_TRY(ts_ledger_actor(sim, l, by, &actor));
		ts_ledger_mark_kicked(sim, l, actor);
		return stage == TS_STAGE_FINAL_INTEGRATE ? ts_ledger_heat_advance(sim, l, by, actor) : TS_OK;
	}
	if (stage == TS_STAGE_PRE_FORCE && by->style == &ts_neigh_system.style)
		return clear_force_columns(sim, l);
	if (stage >= TS_STAGE_PRE_FORCE && stage <= TS_STAGE_POST_FORCE)
		TS_TRY(account_forces(sim, l, by));
	if (stage == TS_STAGE_END_OF_STEP && l->stepping)
		TS_TRY(account_late_forces(sim, l));
	return account_direct_changes(sim, l, by);
}

enum ts_status ts_ledger_finish_step(struct ts_instance *self, struct tsim *sim)
{
	struct ts_ledger *l = self->state;

	TS_TRY(account_pending_kicks(sim, l));
	l->newest = sim->particles->max_tag;
	return ts_ledger_post(sim, l);
}

/* While the particles are divided, before some or all ranks get all of them: what is done at the end of the step. */
enum ts_status ts_ledger_settle(struct ts_instance *self, struct tsim *sim)
{
	struct ts_ledger *l = self->state;

	TS_TRY(account_pending_kicks(sim, l));
	return account_late_forces(sim, l);
}

enum ts_status ts_ledger_join(struct ts_instance *self, struct tsim *sim)
{
	return ts_ledger_post(sim, self->state);
}

/* A run that continues with the forces of the last step: accounts the elastic energy of existing
 * contacts and bonds, and their forces if the ledger had not seen them. */
static enum ts_status account_existing_contacts(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_instance *wall;
	size_t k = 0, actor;

	TS_TRY(ts_ledger_account_pairs(sim, l));
	TS_TRY(ts_ledger_account_bonds(sim, l));
	while (ts_walls_next(sim, &k, &wall)) {
		TS_TRY(ts_ledger_actor(sim, l, wall, &actor));
		TS_TRY(ts_ledger_account_wall(sim, l, wall, actor));
	}
	return TS_OK;
}

static double sum_over_causes(const struct ts_ledger *l, const struct ts_particles *p, size_t i, int number)
{
	const double *cause = ts_ledger_causes(l, p, i) + number;
	double sum = 0;

	for (int c = 0; c < TS_NCAUSE; c++)
		sum += cause[c * TS_CAUSE_NUMBERS];
	return sum;
}

/* A new ledger: existing forces other than those of contacts and bonds are attributed to the actor of
 * unknown origin. */
static enum ts_status account_unknown_forces(struct tsim *sim, struct ts_ledger *l)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_column *c;

	TS_TRY(clear_force_columns(sim, l));
	TS_TRY(account_existing_contacts(sim, l));
	c = &p->column[l->actor[l->rest].column];
	for (size_t i = 0; i < p->n; i++) {
		double *to = (double *)c->data + i * c->width;

		for (int d = 0; d < 3; d++) {
			to[TS_CAUSE_FORCE + d] = p->f[i][d] - sum_over_causes(l, p, i, TS_CAUSE_FORCE + d);
			if (p->torque)
				to[TS_CAUSE_TORQUE + d] =
					p->torque[i][d] - sum_over_causes(l, p, i, TS_CAUSE_TORQUE + d);
		}
	}
	TS_TRY(ts_ledger_store_velocities(sim, l));
	for (size_t b = 0; b < l->bodies; b++)
		memset(l->body[b].external, 0, sizeof l->body[b].external);
	add_external_forces_of_bodies(sim, l, c);
	return TS_OK;
}

static void open_books(const struct tsim *sim, struct ts_ledger *l)
{
	memcpy(l->start_kinetic, l->kinetic, sizeof l->kinetic);
	memcpy(l->start_store, l->store, sizeof l->store);
	memset(l->moved, 0, sizeof l->moved);
	l->first = sim->clock.step;
	l->first_time = ts_sim_time(sim);
	l->largest_energy = l->kinetic[0] + l->kinetic[1] + sum_values(l->store, TS_NSTORE);
	l->open = 1;
}

enum ts_status ts_ledger_setup(struct ts_instance *self, struct tsim *sim)
{
	struct ts_ledger *l = self->state;

	TS_TRY(allocate_particle_arrays(sim, l));
	l->already_accounted = !l->made && l->split;
	if (l->already_accounted)
		l->notes = 0;
	if (!l->made)
		TS_TRY(l->split ? account_existing_contacts(sim, l) : account_unknown_forces(sim, l));
	l->already_accounted = false;
	l->newest = sim->particles->max_tag;
	TS_TRY(update_kinetic_energy(sim, l, BETWEEN_RUNS));
	TS_TRY(store_seen_velocities(sim, l));
	TS_TRY(ts_ledger_heat_update(sim, l));
	for (int k = 0; k < TS_NSTORE && l->open && l->made; k++)
		ts_compensated_add(&l->moved[k], l->store[k] - l->store_before[k]);
	if (!l->open)
		open_books(sim, l);
	return TS_OK;
}

void ts_ledger_fini(struct ts_instance *self)
{
	struct ts_ledger *l = self->state;

	ts_free(l->actor);
	ts_free(l->v);
	ts_free(l->omega);
	ts_free(l->seen_v);
	ts_free(l->seen_omega);
	ts_free(l->f);
	ts_free(l->torque);
	ts_free(l->kicker);
	ts_free(l->body);
	ts_free(l->row_energy);
	ts_free(l->memory);
	ts_free(l->wall_memory);
	ts_free(l->note);
	ts_free(l->bond);
	ts_free(l->journal.entry);
	ts_free(l->journal.sum);
	ts_free(l->journal.value);
	ts_free(l->counted);
	ts_free(l->seen);
	ts_free(l->gone);
	ts_parcel_release(&l->missing);
}
