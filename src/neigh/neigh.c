#include "neigh/neigh.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/parallel.h"
#include "box/domain.h"
#include "core/deferred_loops.h"
#include "core/ranks.h"
#include "core/report.h"
#include "core/settings.h"
#include "math/vec3.h"
#include "neigh/active_pairs.h"
#include "neigh/carried_history.h"
#include "neigh/contact_memory.h"
#include "neigh/leaving.h"
#include "neigh/order.h"
#include "neigh/runaways.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/exchange.h"
#include "particle/molecule.h"
#include "particle/particles.h"
#include "rigid/rigid.h"

#include "base/banned.h"

static void describe_contacts(struct tsim *sim, size_t i, struct ts_str *out)
{
	const struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;

	for (size_t r = 0; r < list->n; r++) {
		bool is_i = ts_contact_tag(list, r, 0) == p->tag[i],
		     /* across a periodic face it is listed with either particle as i */
			is_j = ts_contact_tag(list, r, 1) == p->tag[i] &&
			       ts_contact_image(list, r) == TS_IMAGE_SELF;

		if (!ts_contact_touches(list, r) || !(is_i || is_j))
			continue;
		ts_str_addf(out, "%sparticle %d", out->length ? ", " : "",
			    ts_contact_tag(list, r, is_i ? 1 : 0));
		if (list->results == TS_RESULTS_KEPT)
			ts_str_addf(out, " (force %g)",
				    ts_norm(ts_contact_force(list, ts_contact_kept(list, r))));
	}
}

/* Whether nothing adds to or reads forces before the contact loop: then this overwrites them, and they need
 * not be zeroed. */
static bool contacts_add_first(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	bool first = ts_sim_only(sim, TS_KIND_PAIR) && !sim->outside;

	for (size_t k = 0; k < fixes->n; k++)
		first &= !fixes->item[k]->style->watch;
	return first;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_neigh *nb = self->state;

	sim->particles->describe_contacts = describe_contacts;
	nb->wanted = ts_sim_only(sim, TS_KIND_PAIR) || sim->full & TS_FULL_CONTACTS;
	nb->builds = 0;
	nb->fix_reach = nb->centre_reach = 0;
	nb->skin_observed = nb->keep_forces = false; /* outputs that do set them in their init, after this */
	nb->keep_forces_every = 0;
	nb->contacts.active_chosen = false; /* types of particles may have been changed */
	nb->contacts_first = contacts_add_first(sim);
	return ts_leaving_init(sim);
}

/* Limits beyond which a rebuild, or an error, is due. */
struct check_limits {
	const struct ts_particles *p;
	double moved2;	 /* displacement since the last build, length^2 */
	double shift[3]; /* of the frame: drift_frame.h */
	double dt2;
	double lo[3], hi[3]; /* see ts_exchange_limits */
	long *beyond;	     /* number of particles beyond a limit */
};

/* Counts the particles beyond a limit; without branches, as it runs in every step. */
TS_CLONES
static void check_share(void *context, size_t from, size_t to)
{
	const struct check_limits l = *(const struct check_limits *)context;
	const struct ts_particles *p = l.p;
	const double *restrict x = p->x[0], *restrict hold = p->xhold[0], *restrict v = p->v[0];
	const double *restrict radius = p->radius;
	int64_t beyond = 0;

#pragma omp simd reduction(+ : beyond)
	for (size_t i = from; i < to; i++) {
		double a = x[3 * i], b = x[3 * i + 1], c = x[3 * i + 2];
		double da = a - hold[3 * i] - l.shift[0], db = b - hold[3 * i + 1] - l.shift[1],
		       dc = c - hold[3 * i + 2] - l.shift[2];
		double va = v[3 * i], vb = v[3 * i + 1], vc = v[3 * i + 2];
		double d2 = da * da + db * db + dc * dc, v2 = va * va + vb * vb + vc * vc;
		/* written so that NaN is not within */
		int64_t within = (d2 <= l.moved2) & (v2 * l.dt2 <= radius[i] * radius[i]) & (a >= l.lo[0]) &
				 (a <= l.hi[0]) & (b >= l.lo[1]) & (b <= l.hi[1]) & (c >= l.lo[2]) &
				 (c <= l.hi[2]);

		beyond += 1 - within;
	}
	if (!beyond) /* as a rule: threads that wrote to one counter for every block would wait for each other */
		return;
#pragma omp atomic
	*l.beyond += (long)beyond;
}

static enum ts_status check(struct ts_instance *self, struct tsim *sim)
{
	struct ts_neigh *nb = self->state;
	const struct ts_particles *p = sim->particles;
	double reach = nb->built_skin - ts_domain_moved(sim->domain); /* < 0: rebuild at once */
	long beyond = 0, moved = 0;
	struct check_limits limits = { .p = p,
				       .beyond = &beyond,
				       .moved2 = reach < 0 ? -1 : reach * reach / 4,
				       .dt2 = sim->clock.dt * sim->clock.dt };

	ts_drift_frame_advance(&nb->frame, sim->clock.dt, nb->built_skin);
	ts_scale(1, nb->frame.shift, limits.shift);
	ts_scale(sim->clock.dt, nb->mean_velocity, nb->contacts.drift);
	ts_exchange_limits(sim, limits.lo, limits.hi);
	sim->run.rebuild |= nb->stale;
	TS_DEFER_LOOP(sim, p->n, check_share, &limits);
	ts_contact_list_locate_locals(sim, &sim->neigh->contacts);
	ts_leaving_watch(sim, &moved);
	ts_deferred_loops_run(sim);
	sim->run.seeks = moved && sim->division; /* in the same step on all ranks: ts_ranks_agree */
	sim->run.rebuild |= moved && !sim->division && ts_leaving_search(sim);
	if (!beyond)
		return TS_OK;
	sim->run.relist = nb->leaving_watched;
	sim->run.rebuild |= !sim->run.relist;
	for (size_t i = 0; i < p->n && !sim->run.runaways; i++)
		sim->run.runaways = ts_runaways_has(p, i, limits.dt2);
	return TS_OK;
}

/* All ranks have agreed on whether there are any. */
static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	return sim->run.runaways ? ts_runaways_stop(sim) : TS_OK;
}

/* A rank that breaks a bond knows alone that its list is to be rebuilt; the first one writes restart files. */
static enum ts_status join(struct ts_instance *self, struct tsim *sim)
{
	struct ts_neigh *nb = self->state;

	nb->stale = ts_ranks_most(sim, nb->stale) > 0;
	return TS_OK;
}

static enum ts_status exchange(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	TS_TRY(ts_division_let_go(sim));
	TS_TRY(ts_exchange_migrate(sim));
	TS_TRY(ts_division_migrate(sim));
	ts_particles_inverse_mass(sim->particles);
	return TS_OK;
}

bool ts_neigh_uses_group(const struct ts_neigh *neigh, int bit)
{
	bool uses = neigh->include && neigh->include == bit;

	for (int k = 0; k < neigh->nexclude; k++) {
		const struct ts_exclude *e = &neigh->exclude[k];

		uses |= e->by != TS_EXCLUDE_TYPES && (e->a == bit || e->b == bit);
	}
	return uses;
}

static bool same_molecule(const struct ts_particles *p, size_t i, size_t j)
{
	const double *molecule = ts_particles_molecules(p);

	j = j < p->n ? j : (size_t)p->ghost_owner[j - p->n];
	return molecule && molecule[i] == molecule[j];
}

static bool excludes(const struct ts_exclude *e, const struct ts_particles *p, size_t i, size_t j)
{
	bool members;

	if (e->by == TS_EXCLUDE_TYPES)
		return (p->type[i] == e->a && p->type[j] == e->b) ||
		       (p->type[i] == e->b && p->type[j] == e->a);
	if (e->by == TS_EXCLUDE_GROUPS)
		return (ts_in_group(p, i, e->a) && ts_in_group(p, j, e->b)) ||
		       (ts_in_group(p, i, e->b) && ts_in_group(p, j, e->a));
	members = ts_in_group(p, i, e->a) && ts_in_group(p, j, e->a);
	return members && same_molecule(p, i, j) == (e->by == TS_EXCLUDE_WITHIN);
}

/* Of the images of a bonded particle the nearest holds the bond. */
static bool is_nearest_image(const struct tsim *sim, const double d[3])
{
	double nearest[3] = { d[0], d[1], d[2] };

	ts_box_nearest(&sim->domain->box, nearest);
	ts_axpy(-1, d, nearest);
	return ts_norm(nearest) <= 1e-9 * ts_norm(d);
}

static bool excluded(const struct tsim *sim, size_t i, size_t j, const double d[3])
{
	const struct ts_particles *p = sim->particles;
	const struct ts_neigh *nb = sim->neigh;

	if (ts_rigid_same(p, i, j) || !ts_in_group(p, i, nb->include) || !ts_in_group(p, j, nb->include))
		return true;
	for (int k = 0; k < nb->nexclude; k++)
		if (excludes(&nb->exclude[k], p, i, j))
			return true;
	return nb->skip_bonded && nb->callback.bonded(sim, p->tag[i], p->tag[j]) && is_nearest_image(sim, d);
}

ts_excluded_fn *ts_neigh_excluded(const struct tsim *sim)
{
	const struct ts_neigh *nb = sim->neigh;

	return nb->include || nb->nexclude || nb->skip_bonded || sim->rigid->n ? excluded : NULL;
}

static enum ts_status build(struct ts_instance *self, struct tsim *sim)
{
	struct ts_neigh *nb = self->state;
	double least, largest, reach, image_reach, ghost_reach;

	ts_neigh_radii(sim, &least, &largest);
	nb->least_radius = least;
	reach = nb->wanted ? nb->callback.reach(sim, largest) : 0;
	image_reach = fmax(reach, nb->fix_reach);
	if (!sim->run.resuming)
		TS_TRY(ts_order_by_place(sim));
	nb->given_skin = ts_neigh_skin(sim);
	/* a continued run keeps the positions and the skin of its last build, and so builds the same list */
	if (!sim->run.resuming || !(nb->built_skin > 0))
		ts_neigh_choose_skin(sim, largest);
	if (!sim->run.resuming) {
		ts_exchange_hold(sim);
		if (!sim->run.relist)
			ts_leaving_hold(sim);
	}
	if (sim->division)
		ts_division_read_out(sim);
	ghost_reach = 2 * largest + nb->built_skin + image_reach;
	nb->copy_reach = fmax(ghost_reach, nb->centre_reach + nb->built_skin);
	TS_TRY(ts_exchange_borders(sim, ghost_reach, nb->copy_reach,
				   2 * largest + fmax(nb->given_skin, nb->built_skin) + image_reach));
	nb->builds += !(sim->particles->division && sim->particles->division->rebuilding);
	/* a continued run rebuilds at the steps at which an uninterrupted one would */
	nb->stale &= sim->run.resuming;
	if (!nb->wanted)
		return TS_OK;
	TS_TRY(ts_contact_list_build(sim, &nb->contacts, nb->built_skin + reach, ts_neigh_excluded(sim)));
	/* only lists of ranks are made again during a run of LIGGGHTS */
	nb->saved.parted = sim->legacy == TS_LEGACY_LIGGGHTS && sim->run.resuming;
	if (nb->saved.n && nb->saved.width == nb->contacts.history_width)
		TS_TRY(ts_contact_history_restore(sim, &nb->saved, &nb->contacts));
	ts_contact_history_release(&nb->saved);
	return TS_OK;
}

void ts_neigh_keep_forces_every(struct ts_neigh *nb, int64_t every)
{
	int64_t a = nb->keep_forces_every, b = every;

	while (b) { /* the greatest common divisor of both: its multiples include all their steps */
		int64_t rest = a % b;

		a = b;
		b = rest;
	}
	nb->keep_forces_every = a;
}

/* Whether an output may read the forces of contacts computed in this step; always so at the end of a run. */
static bool forces_must_be_kept(const struct tsim *sim)
{
	const struct ts_neigh *nb = sim->neigh;
	int64_t step = sim->clock.step;

	return nb->keep_forces || sim->run.shows_contacts || sim->run.in_setup || sim->requests.saving ||
	       step == sim->clock.last_step || sim->run.timeout > 0 ||
	       (nb->keep_forces_every && step % nb->keep_forces_every == 0);
}

static enum ts_status forward(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	ts_exchange_forward(sim);
	return TS_OK;
}

static enum ts_status clear_forces(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	struct ts_contact_list *list = &sim->neigh->contacts;

	(void)self;
	sim->run.complete = forces_must_be_kept(sim);
	sim->neigh->fused_pass = NULL; /* styles with a fused pass set it in each step */
	if (sim->outside) {	       /* the calling program may have changed anything */
		ts_contacts_store_history(sim, list);
		list->active_chosen = list->locals_packed = false;
	}
	list->overwrite_sums = sim->neigh->contacts_first && list->n;
	if (p->n && !list->overwrite_sums)
		memset(p->f, 0, p->n * sizeof *p->f);
	if (p->n && p->torque && !(list->overwrite_sums && list->parts > 1))
		memset(p->torque, 0, p->n * sizeof *p->torque);
	return TS_OK;
}

/* Missing in restart files of version 1. */
static enum ts_status archive_bonded(struct ts_neigh *nb, struct ts_archive *a)
{
	uint8_t flags[2] = { nb->skip_bonded, nb->stale };

	if (ts_archive_has(a, "bonded"))
		TS_TRY(ts_archive_fixed(a, "bonded", TS_SAVED_U8, flags, 2));
	nb->skip_bonded = flags[0] != 0;
	nb->stale = flags[1] != 0;
	return TS_OK;
}

static enum ts_status archive_include(struct ts_neigh *nb, struct ts_archive *a)
{
	return ts_archive_has(a, "include") /* missing in older files */
		       ? ts_archive_fixed(a, "include", TS_SAVED_I32, &nb->include, 1)
		       : TS_OK;
}

static enum ts_status archive_skin(struct ts_neigh *nb, struct ts_archive *a)
{
	uint8_t fixed = nb->fixed_skin;

	if (ts_archive_has(a, "fixed_skin"))
		TS_TRY(ts_archive_fixed(a, "fixed_skin", TS_SAVED_U8, &fixed, 1));
	nb->fixed_skin = fixed != 0;
	return TS_OK;
}

/* Missing in older files, whose frame is at rest. */
static enum ts_status archive_frame(struct ts_neigh *nb, struct ts_archive *a)
{
	double frame[6];
	uint8_t watched = nb->leaving_watched;

	memcpy(frame, &nb->frame, sizeof frame);
	if (!ts_archive_writing(a) && !ts_archive_has(a, "frame")) {
		nb->leaving_watched = true;
		return TS_OK;
	}
	TS_TRY(ts_archive_fixed(a, "frame", TS_SAVED_F64, frame, 6));
	TS_TRY(ts_archive_fixed(a, "leaving_watched", TS_SAVED_U8, &watched, 1));
	memcpy(&nb->frame, frame, sizeof frame);
	nb->leaving_watched = watched != 0;
	return TS_OK;
}

static bool is_group(int32_t bit)
{
	return bit >= 0 && bit < TS_MAX_GROUPS;
}

static bool exclusions_possible(const struct ts_neigh *nb)
{
	bool possible = nb->nexclude >= 0 && nb->nexclude <= TS_MAX_EXCLUDE && is_group(nb->include);

	for (int k = 0; possible && k < nb->nexclude; k++) {
		const struct ts_exclude *e = &nb->exclude[k];

		possible = e->by >= TS_EXCLUDE_TYPES && e->by <= TS_EXCLUDE_BETWEEN &&
			   (e->by == TS_EXCLUDE_TYPES || (is_group(e->a) && is_group(e->b)));
	}
	return possible;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_neigh *nb = self->state;
	struct ts_contact_history h = { 0 };
	enum ts_status status;

	if (ts_division_rereads(sim)) /* the script may have changed what else there is */
		return ts_contact_history_archive(a, sim, &nb->saved);
	TS_TRY(archive_bonded(nb, a));
	TS_TRY(archive_include(nb, a));
	TS_TRY(archive_skin(nb, a));
	TS_TRY(archive_frame(nb, a));
	TS_TRY(ts_archive_fixed(a, "exclude", TS_SAVED_I32, nb->exclude, 3 * TS_MAX_EXCLUDE));
	if (!exclusions_possible(nb))
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible exclusions of neighbors");
	if (!ts_archive_writing(a) || nb->saved.n)
		return ts_contact_history_archive(a, sim, &nb->saved);
	TS_TRY(ts_contact_history_save(sim, &nb->contacts, true, NULL, &h));
	status = ts_contact_history_archive(a, sim, &h);
	ts_contact_history_release(&h);
	return status;
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_neigh *nb = self->state;

	(void)sim;
	ts_hash_add(hash, &nb->skin, sizeof nb->skin);
	ts_hash_add(hash, &nb->include, sizeof nb->include);
	ts_hash_add(hash, &nb->nexclude, sizeof nb->nexclude);
	ts_hash_add(hash, nb->exclude, sizeof nb->exclude);
	ts_hash_add(hash, &nb->skip_bonded, sizeof nb->skip_bonded);
}

static bool is_periodic(const struct ts_box *box)
{
	return ts_box_periodic(box, 0) || ts_box_periodic(box, 1) || ts_box_periodic(box, 2);
}

/* Bytes that ghosts, images of particles near the faces, would take if all faces were periodic. */
static double image_bytes(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	double least, largest, reach, images = 0, bytes = 0;

	ts_neigh_radii(sim, &least, &largest);
	reach = 2 * largest + sim->neigh->built_skin;
	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			bytes += (double)(p->column[k].width * p->column[k].element);
	for (size_t i = 0; i < p->n; i++) {
		double images_of_particle = 1;

		for (int d = 0; d < sim->dimension; d++)
			images_of_particle *=
				1 + (p->x[i][d] < box->lo[d] + reach) + (p->x[i][d] > box->hi[d] - reach);
		images += images_of_particle - 1;
	}
	return images * bytes;
}

static void report_pairs(const struct ts_neigh *nb, const struct tsim *sim, struct ts_plan_report *report)
{
	const size_t list = nb->contacts.n, n = sim->particles->n;

	if (!n && !(nb->skin > 0))
		ts_report_line(report, "contact list",
			       "no pairs yet; the skin follows from the first particles");
	else
		ts_report_line(report, "contact list",
			       "%zu pairs within the skin %g (%.1f per particle), %zu bytes each", list,
			       nb->built_skin, n ? (double)list / (double)n : 0.0,
			       list ? ts_contact_list_bytes(&nb->contacts) / list : 0);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ts_neigh *nb = self->state;
	size_t list = nb->contacts.n;

	if (!nb->wanted) {
		ts_report_left_out(report, "contact list", TS_FULL_CONTACTS, 0, "no pair_style");
		return TS_OK;
	}
	report->bytes += (double)ts_contact_list_bytes(&nb->contacts);
	report_pairs(nb, sim, report);
	if (!nb->contacts.history_width)
		ts_report_left_out(report, "contact history", TS_FULL_HISTORY,
				   3.0 * sizeof(double) * (double)list, "the contact law has no history");
	if (nb->skip_bonded)
		ts_report_line(report, "contacts", "none between bonded particles (special_bonds)");
	ts_report_left_out(report, "rebuilds", TS_FULL_REBUILDS, 0,
			   "the list is kept until a particle has moved half the skin%s",
			   is_periodic(&sim->domain->box)
				   ? " (steps of rebuilds change the last digits where "
				     "particles cross periodic faces)"
				   : "");
	ts_report_left_out(report, "looks", TS_FULL_ACTIVE_PAIRS, 0,
			   "only pairs that may have come near enough to touch are computed");
	if (!is_periodic(&sim->domain->box))
		ts_report_left_out(report, "ghosts", 0, image_bytes(sim), "no periodic faces");
	if (sim->threads > 1 && ts_team(sim, sim->particles->n) < sim->threads)
		ts_report_left_out(report, "threads", TS_FULL_THREADS, 0,
				   "%zu particles are too few to share among %d", sim->particles->n,
				   sim->threads);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct ts_neigh *nb = self->state;

	ts_contact_list_release(&nb->contacts);
	ts_contact_history_release(&nb->saved);
}

static enum ts_status count_builds(struct tsim *sim, double *out)
{
	*out = (double)sim->neigh->builds;
	return TS_OK;
}

/* The list is rebuilt exactly when a particle has moved half the skin: no contact is missed. */
static enum ts_status count_dangerous_builds(struct tsim *sim, double *out)
{
	(void)sim;
	*out = 0;
	return TS_OK;
}

static const struct ts_keyword keywords[] = {
	{ "nbuild", "Nbuild", "", "number of builds of the neighbour list in this run", 1, count_builds },
	{ "ndanger", "Ndanger", "", "number of builds that came too late: always 0", 1,
	  count_dangerous_builds },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct ts_neigh, skin),
	TS_SAVE_F64(struct ts_neigh, built_skin),
	TS_SAVE_I32(struct ts_neigh, nexclude),
	TS_SAVED_ROWS_END,
};

static void settings(const struct ts_instance *self, const struct tsim *sim, struct ts_str *out)
{
	const struct ts_neigh *nb = self->state;

	if (ts_ranks_most(sim, (double)sim->particles->n) > 0)
		ts_setting(out, !(nb->skin > 0), "neighbor %.6g%s", ts_neigh_skin(sim),
			   nb->fixed_skin ? " fixed" : "");
	ts_setting(out, nb->nexclude == 0, "excluded %d", (int)nb->nexclude);
	if (nb->include)
		ts_setting(out, false, "include %s", ts_group_name(sim, nb->include));
}

const struct ts_system_style ts_neigh_system = {
	.style = { .name = "neigh",
		   .kind = TS_KIND_SYSTEM,
		   .summary = "contact list: pairs of particles that may touch",
		   .state_size = sizeof(struct ts_neigh),
		   .saved = saved,
		   .archive = archive,
		   .fingerprint = fingerprint,
		   .init = init,
		   .ranks = TS_RANKS_ROWLESS,
		   .hook = { [TS_STAGE_CHECK] = check,
			     [TS_STAGE_PRE_EXCHANGE] = pre_exchange,
			     [TS_STAGE_EXCHANGE] = exchange,
			     [TS_STAGE_BUILD] = build,
			     [TS_STAGE_FORWARD] = forward,
			     [TS_STAGE_PRE_FORCE] = clear_forces },
		   .defers = TS_DEFERS(CHECK),
		   .plan = plan,
		   .join = join,
		   .carrier = &ts_carried_history,
		   .fini = fini },
	.slot = offsetof(struct tsim, neigh),
	.settings = settings,
	.keywords = keywords,
};
