#include "particle/exchange.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "particle/columns.h"
#include "particle/copies.h"
#include "particle/division.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status fail_position(struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	const double *x = p->x[i], *v = p->v[i];

	return ts_fail(&sim->error, TS_PHYSICS, NULL,
		       "particle %d (type %d) has the invalid position (%g %g %g), velocity (%g %g %g): a "
		       "coordinate is not a number, or too far from the box for its image flags",
		       p->tag[i], p->type[i], x[0], x[1], x[2], v[0], v[1], v[2]);
}

/* Beyond this coordinate a squared distance overflows and no cell index can be computed. */
static const double FARTHEST = 1e150;

/* After particle i was wrapped by this number of turns across the sheared faces. */
static bool wrap_sheared(struct tsim *sim, size_t i, int32_t turns)
{
	struct ts_particles *p = sim->particles;
	const struct ts_domain *domain = sim->domain;

	if (ts_in_group(p, i, domain->drift_group))
		p->v[i][domain->box.shear.flow] -= turns * domain->shear_drift;
	return ts_box_wrap_shear(&domain->box, p->x[i], p->image[i], turns);
}

struct wrapping {
	struct tsim *sim;
	int dim;
	size_t failed; /* the first particle with an invalid position, SIZE_MAX: none */
};

static bool wrap_particle(const struct wrapping *w, size_t i)
{
	struct tsim *sim = w->sim;
	struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;
	const int dim = w->dim;
	int32_t before = p->image[i][dim];

	if (!(fabs(p->x[i][dim]) < FARTHEST) ||
	    (ts_box_periodic(box, dim) && !ts_box_wrap(box, dim, &p->x[i][dim], &p->image[i][dim])))
		return false;
	if (ts_in_group(p, i, sim->domain->drift_group))
		p->v[i][dim] -= (p->image[i][dim] - before) * sim->domain->drift[dim];
	return !(box->shear.on && dim == box->shear.gradient) ||
	       wrap_sheared(sim, i, p->image[i][dim] - before);
}

static void wrap_share(void *context, size_t from, size_t to)
{
	struct wrapping *w = context;

	for (size_t i = from; i < to; i++) {
		if (wrap_particle(w, i))
			continue;
#pragma omp critical(ts_wrap)
		w->failed = i < w->failed ? i : w->failed;
		return;
	}
}

static enum ts_status wrap_periodic(struct tsim *sim, int dim)
{
	struct wrapping w = { sim, dim, SIZE_MAX };
	size_t n = sim->particles->n;

	ts_parallel(ts_team(sim, n), n, wrap_share, &w);
	return w.failed == SIZE_MAX ? TS_OK : fail_position(sim, w.failed);
}

int ts_exchange_left(const struct ts_box *box, const double x[3])
{
	for (int dim = 0; dim < 3; dim++) {
		if (box->face[dim][0] == TS_FACE_FIXED && x[dim] < box->lo[dim])
			return 2 * dim;
		if (box->face[dim][1] == TS_FACE_FIXED && x[dim] > box->hi[dim])
			return 2 * dim + 1;
	}
	return -1;
}

void ts_exchange_limits(const struct tsim *sim, double lo[3], double hi[3])
{
	const struct ts_box *box = &sim->domain->box;
	bool waits = sim->particles->lost_policy == TS_LOST_IGNORE;

	for (int d = 0; d < 3; d++) {
		lo[d] = !waits && box->face[d][0] == TS_FACE_FIXED ? box->lo[d] : -INFINITY;
		hi[d] = !waits && box->face[d][1] == TS_FACE_FIXED ? box->hi[d] : INFINITY;
	}
}

static enum ts_status report_lost(struct tsim *sim, size_t i, int face)
{
	static const char *const faces[] = { "xlo", "xhi", "ylo", "yhi", "zlo", "zhi" };
	struct ts_particles *p = sim->particles;
	const double *v = p->v[i];
	double travel = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * sim->clock.dt / p->radius[i];
	struct ts_str contacts = { 0 }, cause = { 0 };
	char text[1100];
	enum ts_status status = TS_OK;

	if (p->lost_policy == TS_LOST_IGNORE || (p->lost_policy == TS_LOST_WARN && p->lost_warned))
		return TS_OK;
	if (p->describe_contacts)
		p->describe_contacts(sim, i, &contacts);
	if (travel > 0.1)
		ts_str_add(&cause, "it moves a large part of its radius in a step: the time step is too "
				   "large or something is too stiff");
	else if (p->explain_loss)
		p->explain_loss(sim, i, face, &cause);
	snprintf(text, sizeof text,
		 "particle %d (type %d) left the box through its fixed face %s at step %" PRId64
		 ": position (%g %g %g), velocity (%g %g %g); last contacts: %.300s; probable cause: %.400s",
		 p->tag[i], p->type[i], faces[face], sim->clock.step, p->x[i][0], p->x[i][1], p->x[i][2],
		 v[0], v[1], v[2], contacts.length ? contacts.text : "none",
		 cause.length ? cause.text : "no wall stands at that face");
	ts_str_release(&contacts);
	ts_str_release(&cause);
	if (p->lost_policy == TS_LOST_ERROR)
		status = ts_fail(&sim->error, TS_PHYSICS, NULL, "%s", text);
	else
		ts_warn(&sim->log, NULL,
			"%s (said once; `thermo_modify lost ignore` is silent, `lost error` stops)", text);
	return status;
}

static long count_left(void *context, size_t from, size_t to)
{
	const struct tsim *sim = context;
	long left = 0;

	for (size_t i = from; i < to; i++)
		left += ts_exchange_left(&sim->domain->box, sim->particles->x[i]) >= 0;
	return left;
}

bool ts_exchange_some_left(struct tsim *sim)
{
	size_t n = sim->particles->n;

	return ts_parallel_count(ts_team(sim, n), n, count_left, sim) > 0;
}

/* Particles that have left the box, and that with the least identity. */
struct lost {
	unsigned char *gone; /* by particle; NULL: none has */
	size_t n, first;
};

static enum ts_status find_lost(struct tsim *sim, struct lost *lost)
{
	const struct ts_particles *p = sim->particles;

	lost->gone = ts_alloc(p->n, 1);
	if (!lost->gone)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++) {
		lost->gone[i] = ts_exchange_left(&sim->domain->box, p->x[i]) >= 0;
		if (lost->gone[i] && (!lost->n || p->tag[i] < p->tag[lost->first]))
			lost->first = i;
		lost->n += lost->gone[i];
	}
	return TS_OK;
}

/* Of all ranks the one that has lost the particle with the least identity reports it, and all have warned then. */
static enum ts_status drop_lost(struct tsim *sim, const struct lost *lost)
{
	struct ts_particles *p = sim->particles;
	double least = lost->n ? -(double)p->tag[lost->first] : -INFINITY;
	double most = ts_ranks_most(sim, least);

	if (isinf(most)) /* no rank has lost any */
		return TS_OK;
	if (least == most)
		TS_TRY(report_lost(sim, lost->first, ts_exchange_left(&sim->domain->box, p->x[lost->first])));
	p->lost_warned |= p->lost_policy != TS_LOST_IGNORE;
	p->lost += ts_division_sum(sim, (int64_t)lost->n);
	return lost->n ? ts_particles_delete(sim, lost->gone) : TS_OK;
}

/* Extends lo..hi by the extents of fixes such as meshes. */
static void include_fix_extents(const struct tsim *sim, int dim, double *lo, double *hi)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style->extent)
			fixes->item[k]->style->extent(fixes->item[k], dim, lo, hi);
}

void ts_exchange_fitted_faces(const struct tsim *sim, int dim, double *face_lo, double *face_hi)
{
	const struct ts_domain *d = sim->domain;
	const struct ts_particles *p = sim->particles;
	double margin = ts_domain_margin(d, dim);
	double lo = INFINITY, hi = -INFINITY;

	*face_lo = d->box.lo[dim];
	*face_hi = d->box.hi[dim];
	if (d->box.face[dim][0] < TS_FACE_SHRINK && d->box.face[dim][1] < TS_FACE_SHRINK)
		return; /* neither face is shrink-wrapped */

	for (size_t i = 0; i < p->n; i++) {
		lo = fmin(lo, p->x[i][dim]);
		hi = fmax(hi, p->x[i][dim]);
	}
	include_fix_extents(sim, dim, &lo, &hi);
	lo = -ts_ranks_most(sim, -lo);
	hi = ts_ranks_most(sim, hi);
	if (!(lo <= hi))
		return;
	if (d->box.face[dim][0] == TS_FACE_SHRINK)
		*face_lo = lo - margin;
	else if (d->box.face[dim][0] == TS_FACE_MINIMUM)
		*face_lo = fmin(lo - margin, d->first_lo[dim]);
	if (d->box.face[dim][1] == TS_FACE_SHRINK)
		*face_hi = hi + margin;
	else if (d->box.face[dim][1] == TS_FACE_MINIMUM)
		*face_hi = fmax(hi + margin, d->first_hi[dim]);
}

/* Moves shrink-wrapped faces (boundary s and m) to the particles. */
static void fit_all_faces(struct tsim *sim)
{
	for (int dim = 0; dim < 3; dim++) {
		const enum ts_face *face = sim->domain->box.face[dim];

		sim->run.box_moves |= face[0] >= TS_FACE_SHRINK || face[1] >= TS_FACE_SHRINK;
		ts_exchange_fitted_faces(sim, dim, &sim->domain->box.lo[dim], &sim->domain->box.hi[dim]);
	}
}

enum ts_status ts_exchange_migrate(struct tsim *sim)
{
	struct lost lost = { 0 };
	enum ts_status status = TS_OK;

	sim->particles->nghost = 0;
	ts_domain_reduce_shear(sim->domain);
	for (int dim = 2; dim >= 0; dim--) /* of a sheared box `gradient` before `flow` */
		TS_TRY(wrap_periodic(sim, dim));
	if (!sim->run.relist && ts_exchange_some_left(sim))
		status = find_lost(sim, &lost);
	if (status == TS_OK)
		status = drop_lost(sim, &lost);
	ts_free(lost.gone);
	TS_TRY(status);
	fit_all_faces(sim);
	return TS_OK;
}

static void hold_share(void *context, size_t from, size_t to)
{
	struct ts_particles *p = context;

	if (to > from)
		memcpy(p->xhold + from, p->x + from, (to - from) * sizeof *p->xhold);
}

void ts_exchange_hold(struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	ts_parallel(ts_team(sim, p->n), p->n, hold_share, p);
	ts_domain_hold(sim->domain);
}

/* Computes positions and velocities of ghosts from their originals, never from other ghosts: those in edges
 * and corners would differ in the last bit. */
static void place_ghosts(const struct ts_particles *p, const struct ts_domain *domain, size_t from, size_t to)
{
	const double length[3] = { ts_box_length(&domain->box, 0), ts_box_length(&domain->box, 1),
				   ts_box_length(&domain->box, 2) };
	const struct ts_shear *s = &domain->box.shear;

	for (size_t k = from; k < to; k++) {
		size_t owner = (size_t)p->ghost_owner[k];
		bool drifts = ts_in_group(p, owner, domain->drift_group);

		for (int d = 0; d < 3; d++) {
			double shift = p->ghost_shift[k][d];

			p->x[p->n + k][d] = p->x[owner][d] + shift * length[d];
			p->v[p->n + k][d] = p->v[owner][d] + (drifts ? shift * domain->drift[d] : 0);
		}
		if (!s->on)
			continue;
		p->x[p->n + k][s->flow] += p->ghost_shift[k][s->gradient] * s->offset;
		p->v[p->n + k][s->flow] += drifts ? p->ghost_shift[k][s->gradient] * domain->shear_drift : 0;
	}
}

/* xhold of a ghost: position of the original, and the box, at the last build of the contact list. */
static void set_ghost_xhold(const struct ts_particles *p, const struct ts_domain *domain, size_t k)
{
	size_t owner = (size_t)p->ghost_owner[k];
	const struct ts_shear *s = &domain->box.shear;

	for (int d = 0; d < 3; d++)
		p->xhold[p->n + k][d] =
			p->xhold[owner][d] + p->ghost_shift[k][d] * (domain->held_hi[d] - domain->held_lo[d]);
	if (s->on)
		p->xhold[p->n + k][s->flow] += p->ghost_shift[k][s->gradient] * domain->held_offset;
}

/* Adds a ghost; of its columns only xhold is set. */
static enum ts_status add_ghost(struct tsim *sim, size_t from, int dim, int shift)
{
	struct ts_particles *p = sim->particles;
	size_t k = p->nghost;

	TS_TRY(ts_particles_reserve_ghosts(sim, k + 1));
	p->ghost_owner[k] = from < p->n ? (int32_t)from : p->ghost_owner[from - p->n];
	memset(p->ghost_shift[k], 0, sizeof p->ghost_shift[k]);
	if (from >= p->n)
		memcpy(p->ghost_shift[k], p->ghost_shift[from - p->n], sizeof p->ghost_shift[k]);
	p->ghost_shift[k][dim] = (int8_t)shift;
	set_ghost_xhold(p, sim->domain, k);
	p->nghost++;
	return TS_OK;
}

static enum ts_status add_ghosts_of_faces(struct tsim *sim, int dim, double cutoff, double most)
{
	struct ts_particles *p = sim->particles;
	double lo = sim->domain->held_lo[dim], hi = sim->domain->held_hi[dim];
	size_t present = p->n + p->nghost; /* ghosts of ghosts fill edges and corners */
	const struct ts_shear *s = &sim->domain->box.shear;
	bool sheared = s->on && dim == s->flow, some = false;

	if ((sheared ? 2 : 1) * most > hi - lo) /* all ranks fail, or none */
		some = ts_ranks_most(sim, present > 0) > 0;
	if (most > hi - lo && some)
		return ts_fail(&sim->error, TS_RANGE, NULL,
			       "the periodic box is %g long in dimension %c, less than the reach %g of a "
			       "contact: make it longer or the skin smaller",
			       hi - lo, 'x' + dim, most);
	if (sheared && some)
		return ts_fail(&sim->error, TS_RANGE, NULL,
			       "the sheared periodic box is %g long in dimension %c, less than twice the "
			       "reach %g of a contact: make it longer or the skin smaller",
			       hi - lo, 'x' + dim, most);
	for (size_t i = 0; i < present; i++) {
		double x = p->xhold[i][dim];

		if (x < lo + cutoff && ts_division_near(sim, dim, x + (hi - lo), cutoff))
			TS_TRY(add_ghost(sim, i, dim, 1));
		if (x >= hi - cutoff && ts_division_near(sim, dim, x - (hi - lo), cutoff))
			TS_TRY(add_ghost(sim, i, dim, -1));
	}
	return TS_OK;
}

/* Copies a column from the originals to ghosts from..to-1. A constant size in the loops of scalars and
 * vectors lets the compiler inline memcpy. */
static void copy_column(const struct ts_particles *p, const struct ts_column *c, size_t from, size_t to)
{
	size_t bytes = c->element * c->width;
	char *data = c->data;

#define COPY(bytes)                        \
	for (size_t k = from; k < to; k++) \
	memcpy(data + (p->n + k) * (bytes), data + (size_t)p->ghost_owner[k] * (bytes), bytes)
	if (bytes == sizeof(int32_t))
		COPY(sizeof(int32_t));
	else if (bytes == sizeof(double))
		COPY(sizeof(double));
	else if (bytes == 3 * sizeof(double))
		COPY(3 * sizeof(double));
	else
		COPY(bytes);
#undef COPY
}

/* Copies the columns with the flag to ghosts from..to-1, of those that follow the copies (copies.h), and places them. */
static void copy_columns(const struct tsim *sim, unsigned flag, size_t from, size_t to)
{
	const struct ts_particles *p = sim->particles;
	size_t copies = ts_copies(sim);

	for (size_t k = 0; k < p->ncolumns; k++) {
		const struct ts_column *c = &p->column[k];

		if (c->active && (c->flags & flag) && c->data != p->x && c->data != p->v &&
		    c->data != p->xhold)
			copy_column(p, c, copies + from, copies + to);
	}
	place_ghosts(p, sim->domain, copies + from, copies + to);
}

static void border_range(void *context, size_t from, size_t to)
{
	copy_columns(context, TS_COL_BORDER, from, to);
}

static void forward_range(void *context, size_t from, size_t to)
{
	copy_columns(context, TS_COL_FORWARD, from, to);
}

/* Cost of copying a ghost, in iterations of a simple loop; ts_team derives the number of threads from it. */
enum { FORWARD_COST = 9 };

enum ts_status ts_exchange_borders(struct tsim *sim, double cutoff, double copies, double most)
{
	size_t n;

	sim->particles->nghost = 0;
	if (sim->division)
		TS_TRY(ts_copies_make(sim, copies));
	else if (!sim->particles->n) /* a box for a fluid alone may be smaller than the skin */
		return TS_OK;
	for (int k = 0; k < sim->dimension; k++) { /* in two dimensions there are no images in z */
		int dim =
			sim->domain->box.shear.on ? sim->dimension - 1 - k : k; /* `gradient` before `flow` */

		if (ts_box_periodic(&sim->domain->box, dim))
			TS_TRY(add_ghosts_of_faces(sim, dim, cutoff, most));
	}
	n = sim->particles->nghost - ts_copies(sim);
	ts_parallel(ts_team(sim, FORWARD_COST * n), n, border_range, sim);
	return TS_OK;
}

void ts_exchange_forward(struct tsim *sim)
{
	size_t n = sim->particles->nghost - ts_copies(sim);

	ts_copies_forward(sim);
	ts_parallel(ts_team(sim, FORWARD_COST * n), n, forward_range, sim);
}
