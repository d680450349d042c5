/* The system of rigid bodies: integration, lost members, restart files. */
#include "rigid/rigid.h"

#include <string.h>

#include "base/parallel.h"
#include "core/report.h"
#include "particle/copies.h"
#include "rigid/rigid_batch.h"
#include "rigid/rigid_box.h"
#include "rigid/rigid_follow.h"

#include "base/banned.h"

/* ---- the stages: all work on a body and its members in one pass */

static void begin_step(void *context, size_t from, size_t to)
{
	ts_rigid_begin_bodies(context, from, to);
}

struct end_task {
	struct tsim *sim;
};

static void end_step(void *context, size_t from, size_t to)
{
	const struct end_task *task = context;

	ts_rigid_end_bodies(task->sim, from, to);
}

static void end_and_begin_step(void *context, size_t from, size_t to)
{
	ts_rigid_end_and_begin_bodies(context, from, to);
}

static void sum_forces(void *context, size_t from, size_t to)
{
	ts_rigid_sum_forces(context, from, to);
}

static enum ts_status for_each_body(struct tsim *sim, ts_range_fn *work)
{
	const struct ts_rigid *r = sim->rigid;

	TS_TRY(ts_rigid_list(sim));
	ts_parallel(ts_team(sim, r->start ? r->start[r->n] : 0), r->ordered, work, sim); /* by members */
	return TS_OK;
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_rigid *r = self->state;

	if (!r->n)
		return TS_OK;
	if (ts_deferred_loop_take(sim, end_step))
		return for_each_body(sim, end_and_begin_step);
	ts_deferred_loops_run(sim);
	return for_each_body(sim, begin_step);
}

static enum ts_status pre_force(struct ts_instance *self, struct tsim *sim)
{
	struct ts_rigid *r = self->state;

	(void)sim;
	for (size_t b = 0; b < r->n; b++)
		memset(r->body[b].external, 0, sizeof r->body[b].external);
	return TS_OK;
}

/* Mostly the next step begins before anybody looks at the bodies: then both are one pass. */
static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_rigid *r = self->state;
	struct end_task task = { sim };

	if (!r->n && !sim->division)
		return TS_OK;
	ts_deferred_loops_run(sim);
	ts_copies_forward_forces(sim);
	TS_TRY(ts_rigid_list(sim));
	ts_defer_loop_alone(sim, r->ordered, end_step, &task, sizeof task);
	if (sim->division)
		ts_deferred_loops_run(sim);
	return TS_OK;
}

/* Ghosts have changed, which are members of bodies if they are copies of particles of other ranks. */
static enum ts_status build(struct ts_instance *self, struct tsim *sim)
{
	if (sim->division)
		((struct ts_rigid *)self->state)->generation = 0;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	(void)sim;
	((struct ts_rigid *)self->state)->fresh = true;
	return TS_OK;
}

/* Forces at the start of a run; a run that resumes has them from the last step. */
static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	struct ts_rigid *r = self->state;

	r->fresh = false;
	if (!r->n || sim->run.resuming)
		return TS_OK;
	return for_each_body(sim, sum_forces);
}

/* Bodies whose fix is gone. After `unfix` they dissolve as the script has said, not if it does not define the fix of a restart
 * file again. */
static enum ts_status dissolve_orphans(struct tsim *sim, struct ts_rigid *r)
{
	const size_t before = r->n;

	TS_TRY(ts_rigid_dissolve_orphans(sim));
	if (r->read && r->n < before)
		ts_warn(&sim->log, NULL,
			"rigid bodies of the restart file are dissolved (%zu), since the script does not "
			"define the fix again that moves them (fix rigid, fix multisphere): their particles "
			"go on as single ones",
			before - r->n);
	r->read = false;
	return TS_OK;
}

/* `commanded`: members are missing that no step has lost. */
static enum ts_status drop_incomplete(struct tsim *sim, const struct ts_rigid *r, bool commanded)
{
	const size_t before = r->n;

	TS_TRY(ts_rigid_drop_incomplete(sim));
	if (commanded && r->n < before)
		ts_warn(&sim->log, NULL,
			"%zu rigid bodies lack members, which delete_atoms has deleted: they are deleted "
			"with all their particles",
			before - r->n);
	return TS_OK;
}

/* After particles were lost and inverse masses were set: deletes incomplete bodies, sets imass of members. */
static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	struct ts_rigid *r = self->state;
	const bool some_lost = r->lost != sim->particles->lost;

	if (sim->division)
		return ts_rigid_exchange_own(sim);
	r->lost = sim->particles->lost;
	if (!r->n)
		return TS_OK;
	TS_TRY(dissolve_orphans(sim, r));
	TS_TRY(ts_rigid_list(sim));
	TS_TRY(drop_incomplete(sim, r, r->fresh && !some_lost));
	if (r->fresh && sim->clock.step == sim->clock.first_step) /* not in a step after `run N pre no` */
		TS_TRY(ts_rigid_take_velocities(sim));
	r->fresh = false;
	if (sim->run.rebuild && r->n)
		TS_TRY(r->check_members(sim, r->member, r->start[r->n]));
	for (size_t b = 0; b < r->n; b++)
		for (size_t k = r->start[b]; k < r->start[b + 1]; k++)
			sim->particles->imass[r->member[k]] = 1 / r->body[b].mass;
	return TS_OK;
}

/* A damaged file may have members of bodies that do not exist. */
static enum ts_status check_members(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_rigid *r = sim->rigid;

	for (size_t b = 0; b < r->n; b++)
		if (r->id[b] <= (b ? r->id[b - 1] : 0) || r->id[b] > r->last_id || !(r->body[b].mass > 0))
			return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible rigid bodies");
	for (size_t i = 0; i < p->n; i++)
		if (ts_rigid_member(p, i) && !ts_rigid_body_of(sim, i))
			return ts_fail(&sim->error, TS_DAMAGED, NULL,
				       "particle %d belongs to a body that does not exist", p->tag[i]);
	return r->n && !p->body ? ts_fail(&sim->error, TS_DAMAGED, NULL, "rigid bodies without members")
				: TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_rigid *r = self->state;
	size_t numbers = r->n * TS_BODY_NUMBERS, room = r->body_capacity * TS_BODY_NUMBERS;
	size_t ids = r->n, sizes = r->n, owners = r->n;

	if (!ts_archive_writing(a) && !ts_archive_has(a, "body"))
		return TS_OK; /* files of older versions */
	TS_TRY(ts_archive_array(a, "body", TS_SAVED_F64, (void **)&r->body, &room, &numbers));
	r->body_capacity = room / TS_BODY_NUMBERS;
	TS_TRY(ts_archive_array(a, "id", TS_SAVED_I32, (void **)&r->id, &r->id_capacity, &ids));
	TS_TRY(ts_archive_array(a, "size", TS_SAVED_I32, (void **)&r->size, &r->size_capacity, &sizes));
	TS_TRY(ts_archive_array(a, "owner", TS_SAVED_I64, (void **)&r->owner, &r->owner_capacity, &owners));
	TS_TRY(ts_archive_fixed(a, "last_id", TS_SAVED_I32, &r->last_id, 1));
	if (numbers != ids * TS_BODY_NUMBERS || sizes != ids || owners != ids)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible rigid bodies");
	r->n = ids;
	r->generation = 0;
	r->read |= !ts_archive_writing(a);
	return check_members(sim);
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_rigid *r = self->state;

	ts_hash_add(hash, r->id, r->n * sizeof *r->id);
	for (size_t b = 0; b < r->n; b++)
		if ((b == 0 || r->owner[b] != r->owner[b - 1]) && !ts_rigid_owner_lives(sim, r->owner[b]))
			ts_hash_text(hash, "comes apart");
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_rigid *r = self->state;

	(void)sim;
	if (r->n)
		ts_report_line(report, "rigid bodies", "%zu, of %zu particles", r->n,
			       r->start ? r->start[r->n] : 0);
	return TS_OK;
}

/* The same on all ranks, of which some may have no bodies. */
static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_rigid *r = self->state;

	return sim->division ? sim->particles->body != NULL : r->n > 0;
}

static void fini(struct ts_instance *self)
{
	struct ts_rigid *r = self->state;

	ts_free(r->body);
	ts_free(r->id);
	ts_free(r->size);
	ts_free(r->owner);
	ts_free(r->member);
	ts_free(r->order);
	ts_free(r->row);
	ts_free(r->row_start);
	ts_free(r->start);
}

static void connect_rigid_bodies(struct tsim *sim)
{
	sim->particles->material_density = ts_rigid_material_density;
	sim->particles->bodies_follow = ts_rigid_follow;
	sim->particles->bodies_change_box = ts_rigid_change_box;
}

const struct ts_system_style ts_rigid_system = {
	.style = { .name = "rigid",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "rigid bodies of particles",
		   .state_size = sizeof(struct ts_rigid),
		   .archive = archive,
		   .fingerprint = fingerprint,
		   .init = init,
		   .ranks = TS_RANKS_ROWLESS,
		   .hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
			     [TS_STAGE_EXCHANGE] = exchange,
			     [TS_STAGE_BUILD] = build,
			     [TS_STAGE_PRE_FORCE] = pre_force,
			     [TS_STAGE_FINAL_INTEGRATE] = final_integrate,
			     [TS_STAGE_SETUP] = setup },
		   .defers = TS_DEFERS(INITIAL_INTEGRATE) | TS_DEFERS(FINAL_INTEGRATE),
		   .plan = plan,
		   .due = due,
		   .join = ts_rigid_join,
		   .carrier = &ts_rigid_carrier,
		   .claim = ts_rigid_claim,
		   .fini = fini },
	.slot = offsetof(struct tsim, rigid),
	.connect = connect_rigid_bodies,
};
