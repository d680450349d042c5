#include "particle/division.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "box/domain.h"
#include "core/plan.h"
#include "core/ranks.h"
#include "particle/carrier_rows.h"
#include "particle/columns.h"
#include "particle/division_blocks.h"
#include "particle/identity.h"
#include "particle/shared_rows.h"
#include "particle/turning.h"
#include "rank/loads.h"

#include "base/banned.h"

const char *ts_division_undivided(const struct tsim *sim)
{
	enum { OFTEN = 20 }; /* a step with all particles takes as long as so many */
	const struct ts_particles *p = sim->particles;

	for (int bit = 1; bit < TS_MAX_GROUPS; bit++)
		if (p->dynamic[bit].every && p->dynamic[bit].every < OFTEN &&
		    ts_ranks_variable_shared(sim, p->dynamic[bit].variable))
			return "the variable of a dynamic group";
	return NULL;
}

bool ts_division_whole_step(const struct tsim *sim, bool set_up)
{
	const struct ts_particles *p = sim->particles;

	for (int bit = 1; bit < TS_MAX_GROUPS; bit++)
		if (p->dynamic[bit].every && (set_up || sim->clock.step % p->dynamic[bit].every == 0) &&
		    ts_ranks_variable_shared(sim, p->dynamic[bit].variable))
			return true;
	return false;
}

static void release_reread(struct ts_division *d)
{
	if (d->reread.release)
		d->reread.release(d->reread.data);
	d->reread = (struct ts_reread){ 0 };
}

void ts_division_read_out(struct tsim *sim)
{
	release_reread(sim->particles->division);
	sim->run.made = false;
}

void ts_division_free(struct ts_division *d)
{
	if (!d)
		return;
	ts_carrier_rows_release(d);
	ts_free(d->carried);
	ts_turning_forget(d);
	ts_free(d->turned);
	ts_str_release(&d->said);
	ts_parcel_release(&d->look.ghosts);
	release_reread(d);
	ts_rank_blocks_release(&d->blocks);
	ts_copies_release(&d->copies, d->ranks);
	ts_free(d);
}

/* Once in a rebuild. */
static enum ts_status exchange_turning(struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;
	struct ts_division *d = sim->division;

	if (d->turned_before ||
	    !(ts_box_periodic(box, 0) || ts_box_periodic(box, 1) || ts_box_periodic(box, 2)))
		return TS_OK;
	d->turned_before = true;
	return ts_turning_exchange(sim);
}

/* While there are copies, in whose place the new particles come. */
enum ts_status ts_division_begin_new(struct tsim *sim)
{
	return sim->division ? exchange_turning(sim) : TS_OK;
}

void ts_division_end_new(struct tsim *sim, size_t n)
{
	enum { MANY = 20 }; /* of a part of the particles of a rank */
	struct ts_division *d = sim->division;

	if (d && n > d->cut_most / MANY)
		sim->run.uneven |= ts_division_is_uneven(sim, d);
}

enum ts_status ts_division_let_go(struct tsim *sim)
{
	struct ts_division *d = sim->division;

	if (!d || d->reread.all)
		return TS_OK;
	if (sim->run.uneven)
		TS_TRY(ts_division_cut_again(sim, d));
	TS_TRY(exchange_turning(sim));
	d->turned_before = false;
	return TS_OK;
}

/* ---- migration */

static enum ts_status append_particles(struct tsim *sim, const struct ts_parcel *in)
{
	struct ts_particles *p = sim->particles;
	size_t bytes = ts_copies_row_bytes(p), n = in->n / bytes;

	p->nghost = 0;
	TS_TRY(ts_particles_reserve(sim, p->n + n));
	for (size_t k = 0; k < n; k++)
		ts_copies_unpack(p, p->n++, in->data + k * bytes);
	sim->generation++;
	return TS_OK;
}

/* Particles with to[i] of other ranks are sent there. */
static enum ts_status send_particles(struct tsim *sim, const int32_t *to, unsigned char *gone)
{
	const struct ts_particles *p = sim->particles;
	struct ts_division *d = sim->division;
	struct ts_parcel *out = ts_carrier_rows_parcels(sim);
	size_t before;

	for (size_t i = 0; i < p->n; i++) {
		gone[i] = to[i] != sim->world->rank;
		if (gone[i] && ts_copies_pack(p, i, &out[to[i]]) != TS_OK)
			return ts_nomem(&sim->error);
	}
	if (ts_world_deliver(sim->world, out, d->copies.in) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_particles_delete(sim, gone));
	before = p->n;
	for (int r = 0; r < sim->world->n; r++)
		if (r != sim->world->rank)
			TS_TRY(append_particles(sim, &d->copies.in[r]));
	d->moved += (int64_t)(p->n - before);
	return TS_OK;
}

static enum ts_status send_all(struct tsim *sim, const int32_t *to, unsigned char *gone)
{
	struct ts_division *d = sim->division;

	for (size_t k = 0; k < d->ncarried; k++) {
		struct ts_parcel *out = ts_carrier_rows_parcels(sim);

		TS_TRY(ts_carrier_rows_sort(sim, &d->carried[k], to, out, NULL));
		TS_TRY(ts_carrier_rows_deliver(sim, &d->carried[k], out));
	}
	TS_TRY(send_particles(sim, to, gone));
	return d->reread.all ? TS_OK : ts_carrier_rows_take(sim, d);
}

/* to[i]: the rank of the particle's position. */
static enum ts_status find_leaving(struct tsim *sim, int32_t *to, struct ts_leaving *leaving)
{
	const struct ts_rank_blocks *blocks = &sim->division->blocks;
	const struct ts_rank_block own = ts_rank_blocks_block(blocks, sim->world->rank);
	const struct ts_particles *p = sim->particles;
	size_t capacity = 0;

	for (size_t i = 0; i < p->n; i++) {
		bool inside = ts_rank_block_inside(&own, p->x[i], 0);

		to[i] = (int32_t)(inside ? sim->world->rank : ts_rank_blocks_owner(blocks, p->x[i]));
		if (to[i] == sim->world->rank)
			continue;
		if (TS_GROW(leaving->tag, capacity, leaving->n + 1) != TS_OK)
			return ts_nomem(&sim->error);
		leaving->tag[leaving->n++] = p->tag[i];
	}
	ts_carried_sort(leaving);
	return TS_OK;
}

static enum ts_status send_leaving(struct tsim *sim, int32_t *to, unsigned char *gone,
				   struct ts_leaving *leaving)
{
	struct ts_division *d = sim->division;
	double most[2];

	TS_TRY(find_leaving(sim, to, leaving));
	most[0] = leaving->n || ts_turning_found(d);
	most[1] = (double)sim->particles->n;
	ts_world_most(sim->world, most, 2);
	sim->run.uneven |= ts_division_is_very_uneven(d, most[1]);
	if (!(most[0] > 0))
		return TS_OK;
	if (!d->reread.all) { /* else each rank has read what belongs to them */
		TS_TRY(ts_carrier_rows_give(sim, d, false, leaving));
		TS_TRY(ts_turning_add(sim));
	}
	return send_all(sim, to, gone);
}

enum ts_status ts_division_migrate(struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	struct ts_leaving leaving = { 0 };
	int32_t *to;
	unsigned char *gone;
	enum ts_status status;

	if (!sim->division)
		return TS_OK;
	ts_rank_blocks_fit(&sim->division->blocks, sim->domain->box.lo, sim->domain->box.hi);
	to = ts_alloc(p->n, sizeof *to);
	gone = ts_alloc(p->n, sizeof *gone);
	status = to && gone ? send_leaving(sim, to, gone, &leaving) : ts_nomem(&sim->error);
	ts_free(leaving.tag);
	ts_free(to);
	ts_free(gone);
	return status;
}

int64_t ts_division_sum(const struct tsim *sim, int64_t number)
{
	if (sim->division)
		ts_world_sum(sim->world, &number);
	return number;
}

/* ---- all particles on each rank, and back */

/* Makes ghosts and lists of contacts again, from the positions of the last rebuild, as a continued run does. */
static enum ts_status remake_lists(struct ts_plan *plan, struct tsim *sim, struct ts_division *d)
{
	enum ts_status status;

	sim->run.resuming = d->rebuilding = true;
	status = ts_plan_stages(plan, sim, TS_STAGE_BUILD, TS_STAGE_POST_BUILD);
	sim->run.resuming = d->rebuilding = false;
	return status;
}

static enum ts_status keep_own_particles(struct tsim *sim, struct ts_division *d, struct ts_placed placed)
{
	const struct ts_particles *p = sim->particles;
	unsigned char *gone = ts_alloc(p->n, sizeof *gone);
	int32_t *owner = ts_alloc(p->n, sizeof *owner);
	enum ts_status status =
		gone && owner ? ts_division_choose_blocks(sim, d, &placed, owner) : ts_nomem(&sim->error);

	for (size_t i = 0; status == TS_OK && i < p->n; i++)
		gone[i] = owner[i] != sim->world->rank;
	if (status == TS_OK)
		status = ts_particles_delete(sim, gone);
	ts_free(owner);
	ts_free(gone);
	return status;
}

bool ts_division_rereads(const struct tsim *sim)
{
	const struct ts_division *d = sim->particles->division;

	return d && d->reread.all && !sim->division;
}

void ts_division_start(struct tsim *sim, const struct ts_reread *reread)
{
	sim->division = sim->particles->division;
	sim->division->reread = *reread;
}

/* While the particles are divided the ranks do not all warn of the same; the first one prints for all. */
static void listen(struct tsim *sim, struct ts_division *d)
{
	sim->log.warned = d ? &d->said : NULL;
}

/* ---- a look at all particles */

static enum ts_status save_ghosts(const struct ts_particles *p, struct ts_look *look)
{
	unsigned char *to;

	look->n = p->n;
	look->nghost = p->nghost;
	look->columns = p->ncolumns;
	look->ghosts.n = 0;
	to = ts_parcel_extend(&look->ghosts, p->nghost * ts_copies_row_bytes(p));
	if (!to)
		return TS_NOMEM;
	ts_shared_rows_move(p, look->columns, p->n, p->nghost, true, to);
	return TS_OK;
}

enum ts_status ts_division_show(struct tsim *sim, const unsigned char *chosen)
{
	if (!sim->division)
		return TS_OK;
	if (save_ghosts(sim->particles, &sim->division->look) != TS_OK)
		return ts_nomem(&sim->error);
	return ts_shared_rows(sim, TS_SHARED_OWN_FIRST, chosen);
}

static enum ts_status restore_ghosts(struct tsim *sim, const struct ts_look *look)
{
	struct ts_particles *p = sim->particles;

	p->n = look->n;
	p->nghost = look->nghost;
	if (ts_shared_rows_move(p, look->columns, p->n, p->nghost, false, NULL) != look->ghosts.n)
		return ts_fail(&sim->error, TS_STATE, NULL,
			       "columns of particles have changed while all ranks had all particles");
	ts_shared_rows_move(p, look->columns, p->n, p->nghost, false, look->ghosts.data);
	sim->generation++;
	return TS_OK;
}

enum ts_status ts_division_hide(struct tsim *sim)
{
	return sim->division ? restore_ghosts(sim, &sim->division->look) : TS_OK;
}

enum ts_status ts_division_keep_own(struct tsim *sim)
{
	TS_TRY(sim->particles->check_movers(sim)); /* the same message from all ranks */
	TS_TRY(ts_division_new(sim));
	TS_TRY(keep_own_particles(sim, sim->particles->division,
				  sim->run.resuming ? ts_placed_before(sim) : ts_placed_now(sim)));
	listen(sim, sim->particles->division);
	sim->division = sim->particles->division;
	return TS_OK;
}

enum ts_status ts_division_divide(struct ts_plan *plan, struct tsim *sim)
{
	struct ts_division *d;

	TS_TRY(ts_division_new(sim));
	d = sim->particles->division;
	ts_deferred_loops_run(sim);
	if (sim->run.looks) {
		TS_TRY(restore_ghosts(sim, &d->look));
		sim->run.looks = false;
		listen(sim, d);
		sim->division = d;
		return TS_OK;
	}
	TS_TRY(keep_own_particles(sim, d, ts_placed_before(sim)));
	listen(sim, d);
	sim->division = d;
	return remake_lists(plan, sim, d); /* these continue the contacts of the old lists */
}

static enum ts_status share_rows(struct tsim *sim, struct ts_carried *rows)
{
	struct ts_parcel all = { 0 };
	enum ts_status status = ts_world_share(sim->world, &rows->rows, &all);

	ts_parcel_release(&rows->rows);
	rows->rows = all;
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* Whether a line of n characters, with its end, is one of those from `text` to `end`. */
static bool has_line(const char *text, const char *end, const char *line, size_t n)
{
	for (const char *next; text < end; text = next) {
		next = text + strcspn(text, "\n") + 1;
		if ((size_t)(next - text) == n && memcmp(text, line, n) == 0)
			return true;
	}
	return false;
}

/* Prints the lines of a rank that none of the ranks before it has said. */
static void print_new_lines(struct ts_log *log, const char *before, const char *text)
{
	for (const char *line = text, *next; *line; line = next) {
		next = line + strcspn(line, "\n") + 1;
		if (!has_line(before, text, line, (size_t)(next - line)))
			ts_log(log, "%.*s", (int)(next - line), line);
	}
}

/* The first rank has printed its own ones. */
static enum ts_status print_warnings(struct tsim *sim, struct ts_division *d)
{
	struct ts_parcel mine = { 0 }, all = { 0 };
	enum ts_status status = ts_parcel_add(&mine, ts_str_text(&d->said), d->said.length + 1);
	const char *text;

	if (status == TS_OK)
		status = ts_world_share(sim->world, &mine, &all);
	text = (const char *)all.data;
	for (int rank = 0; status == TS_OK && rank < sim->world->n; rank++, text += strlen(text) + 1)
		if (rank > 0)
			print_new_lines(&sim->log, (const char *)all.data, text);
	ts_parcel_release(&mine);
	ts_parcel_release(&all);
	ts_str_clear(&d->said);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

/* The ranks have the same particles from here on. */
static enum ts_status leave_division(struct tsim *sim, struct ts_division *d)
{
	TS_TRY(print_warnings(sim, d));
	listen(sim, NULL);
	sim->division = NULL;
	return TS_OK;
}

static enum ts_status join_sums(struct tsim *sim)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			struct ts_instance *inst = sim->instances[kind].item[k];

			if (inst->style->join)
				TS_TRY(inst->style->join(inst, sim));
		}
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if ((*s)->no_instance && (*s)->style.join)
			TS_TRY((*s)->style.join(NULL, sim));
	return TS_OK;
}

/* All ranks get all particles and the rows of all carriers, and make the lists again. */
static enum ts_status gather_all(struct ts_plan *plan, struct tsim *sim, struct ts_division *d)
{
	TS_TRY(ts_carrier_rows_give(sim, d, true, NULL));
	for (size_t k = 0; k < d->ncarried; k++)
		TS_TRY(ts_carrier_rows_keep_local(sim, &d->carried[k]));
	TS_TRY(ts_shared_rows(sim, TS_SHARED_BY_RANK, NULL));
	d->copies.n = 0;
	for (size_t k = 0; k < d->ncarried; k++)
		TS_TRY(share_rows(sim, &d->carried[k]));
	TS_TRY(leave_division(sim, d));
	d->listed++;
	TS_TRY(ts_carrier_rows_take(sim, d));
	return remake_lists(plan, sim, d);
}

/* Each rank has its own particles of a file, or of those that commands have made. */
static enum ts_status read_again(struct tsim *sim, struct ts_division *d)
{
	TS_TRY(leave_division(sim, d));
	TS_TRY(d->reread.all(sim, d->reread.data));
	ts_division_read_out(sim);
	return TS_OK;
}

enum ts_status ts_division_gather(struct ts_plan *plan, struct tsim *sim, bool lists)
{
	struct ts_division *d = sim->division;

	if (d->reread.all)
		return read_again(sim, d);
	ts_deferred_loops_run(sim);
	if (!sim->run.resuming ||
	    d->unjoined) /* when a continued run begins, all may have the sums of the last step */
		TS_TRY(join_sums(sim));
	d->unjoined = false;
	d->gathered++;
	sim->run.uneven |= ts_division_is_uneven(sim, d);
	if (lists)
		return gather_all(plan, sim, d);
	TS_TRY(ts_division_show(sim, NULL));
	sim->run.looks = true;
	return leave_division(sim, d);
}

enum ts_status ts_division_rest(struct tsim *sim, bool begins)
{
	struct ts_division *d = sim->division;

	ts_deferred_loops_run(sim);
	if (!begins) {
		listen(sim, d);
		return TS_OK;
	}
	d->unjoined = true;
	sim->run.uneven |= ts_division_is_uneven(sim, d);
	TS_TRY(print_warnings(sim, d));
	listen(sim, NULL);
	return TS_OK;
}
