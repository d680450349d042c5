#include "insert/insertion_region.h"

#include <inttypes.h>

#include "box/domain.h"
#include "insert/insertion_meshes.h"
#include "math/exactsum.h"
#include "math/quaternion.h"
#include "math/vec3.h"
#include "particle/particles.h"
#include "particle/rank_sums.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid.h"

#include "base/banned.h"

/* As in LIGGGHTS, the seed of the stream of the region is that of the fix plus this. */
static const int64_t SEED_OFFSET = 12;
/* The search fails after this number of consecutive points where the particle does not fit in the region. */
static const int64_t MOST_POINTS = 20000000;
/* Trial positions after a request to stop before the step is aborted. */
static const int64_t TRIES_AFTER_STOP = 500000;

static struct ts_minstd *position_stream(const struct ts_insertion_region *s)
{
	return &((struct ts_region *)s->region->state)->random;
}

static void draw_point(struct ts_minstd *random, const double lo[3], const double hi[3], double x[3])
{
	for (int d = 0; d < 3; d++)
		x[d] = lo[d] + ts_minstd_uniform(random) * (hi[d] - lo[d]);
}

static bool fits_region(const struct ts_insertion_region *s, const double x[3], double radius)
{
	return ts_region_contains(s->region, x) &&
	       (!s->base.all_in || ts_region_depth(s->region, x) >= radius);
}

static enum ts_status fail_no_volume(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion_region *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;

	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix %s: none of %lld random points in the box around region %s lies in it and in the "
		       "simulation box%s; %s a larger region or smaller particles (radius up to %g), or a "
		       "larger ntry_mc",
		       self->style->name, (long long)s->ntry_mc, s->region->id,
		       s->base.all_in ? " and so deep that the largest particle fits" : "",
		       s->base.all_in ? "take" : "it is too small:", d->largest);
}

/* Bounding box of the part of the region that is in the simulation box. */
static void find_bounds(const struct ts_insertion_region *s, const struct ts_box *box, double lo[3],
			double hi[3])
{
	ts_region_bounds(s->region, lo, hi);
	for (int d = 0; d < 3; d++) {
		lo[d] = fmax(lo[d], box->lo[d]);
		hi[d] = fmin(hi[d], box->hi[d]);
	}
}

void ts_insertion_region_faces(const struct ts_insertion_region *s, const struct ts_box *box,
			       double face[3][2])
{
	double lo[3], hi[3];

	ts_region_bounds(s->region, lo, hi);
	for (int d = 0; d < 3; d++) {
		face[d][0] = lo[d] < box->lo[d] ? box->lo[d] : -INFINITY;
		face[d][1] = hi[d] > box->hi[d] ? box->hi[d] : INFINITY;
	}
}

static bool is_within(const double x[3], const double lo[3], const double hi[3])
{
	bool within = true;

	for (int d = 0; d < 3; d++)
		within &= lo[d] <= x[d] && x[d] <= hi[d];
	return within;
}

/* Volume of the part that is in the simulation box, where all particles are placed. Monte Carlo integration even where the volume
 * is known: as in LIGGGHTS, it advances the stream of positions. */
static enum ts_status estimate_volume(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion_region *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;
	struct ts_minstd *random = position_stream(s);
	int64_t hits = 0, deep = 0;
	double lo[3], hi[3], x[3];

	ts_region_bounds(s->region, lo, hi);
	find_bounds(s, &sim->domain->box, s->bounds[0], s->bounds[1]);
	for (int64_t k = 0; k < s->ntry_mc; k++) {
		draw_point(random, lo, hi, x);
		if (!is_within(x, s->bounds[0], s->bounds[1]) || !ts_region_contains(s->region, x))
			continue;
		hits++;
		deep += !deep && fits_region(s, x, d->largest);
	}
	if (!deep)
		return fail_no_volume(self, sim);
	s->volume = (double)hits / (double)s->ntry_mc * (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
	if (s->volume >= ((const struct ts_region *)s->region->state)->volume_limit)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &s->region->where,
		       "region %s has a volume of about %g, below its volume_limit", s->region->id,
		       s->volume);
}

static bool is_shrink_wrapped(const struct ts_box *box)
{
	bool moves = false;

	for (int k = 0; k < 6; k++)
		moves |= box->face[k / 2][k % 2] >= TS_FACE_SHRINK;
	return moves;
}

static enum ts_status check_region(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion_region *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	double lo[3], hi[3];

	if (((const struct ts_region *)s->region->state)->moves)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->region->id),
			       "fix %s: region %s moves, expected one that stands still", self->style->name,
			       s->region->id);
	ts_region_bounds(s->region, lo, hi);
	for (int d = 0; d < 3; d++) {
		if (!isfinite(lo[d]) || !isfinite(hi[d]))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, s->region->id),
				       "fix %s: region %s is unbounded in %c; use numbers or EDGE for its "
				       "faces",
				       self->style->name, s->region->id, 'x' + d);
		if ((box->face[d][0] == TS_FACE_FIXED && lo[d] < box->lo[d]) ||
		    (box->face[d][1] == TS_FACE_FIXED && hi[d] > box->hi[d]))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, s->region->id),
				       "fix %s: region %s reaches from %c = %g to %g, beyond the fixed faces "
				       "of the box at %g and %g; make it smaller, or the boundary m",
				       self->style->name, s->region->id, 'x' + d, lo[d], hi[d], box->lo[d],
				       box->hi[d]);
	}
	if (s->base.all_in && isnan(ts_region_depth(s->region, box->lo)))
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "all_in"),
			       "fix %s: all_in yes is not possible with a region of style %s",
			       self->style->name, s->region->style->name);
	return TS_OK;
}

enum ts_status ts_insertion_region_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_insertion_region *s = self->state;
	bool first;

	TS_TRY(ts_insertion_init(self, sim, &first));
	if (s->avoid.n && !s->base.overlapcheck)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "avoid_meshes"),
			       "fix %s: avoid_meshes needs overlapcheck yes", self->style->name);
	TS_TRY(ts_insertion_meshes_check(sim, &s->avoid));
	if (!first) /* the box may have changed; regions with variables are checked in each insertion */
		return s->base.wait > 0 && !ts_region_varies(s->region) ? check_region(self, sim) : TS_OK;
	TS_TRY(ts_region_update(s->region, sim));
	TS_TRY(check_region(self, sim));
	*position_stream(s) = ts_minstd_start((s->base.seed + SEED_OFFSET - 1) % 2147483646 + 1);
	return estimate_volume(self, sim);
}

/* Integrates the volume again if the shape of the region, or the part of it that is in the box, has changed. In a shrink-wrapped
 * box each insertion does so, but as in LIGGGHTS for the next one. */
static enum ts_status renew_volume(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_insertion_region *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	bool changed = ts_region_reshapes(s->region);
	double lo[3], hi[3];

	find_bounds(s, box, lo, hi);
	for (int d = 0; d < 3 && !is_shrink_wrapped(box); d++)
		changed |= lo[d] != s->bounds[0][d] || hi[d] != s->bounds[1][d];
	if (!changed)
		return TS_OK;
	TS_TRY(check_region(self, sim));
	return estimate_volume(self, sim);
}

enum { MASS, VOLUME };

struct content {
	int64_t number;
	struct ts_exactsum sum[2];
};

/* Spheres, except those of clumps. */
static void count_spheres(const struct ts_insertion_region *s, const struct tsim *sim, struct content *c)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		const struct ts_body *body = ts_rigid_body_of(sim, i);

		if ((body && body->kind > 0) || !ts_region_contains(s->region, p->x[i]))
			continue;
		c->number++;
		ts_exactsum_add(&c->sum[MASS], p->mass[i]);
		ts_exactsum_add(&c->sum[VOLUME], ts_particle_volume(sim, p->radius[i]));
	}
}

static const struct ts_template *find_template(const struct tsim *sim, const struct ts_body *body)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++) {
		const struct ts_template *t = fixes->item[k]->state;

		if (ts_streq(fixes->item[k]->style->name, "particletemplate/multisphere") && t->defined &&
		    t->body.kind == body->kind)
			return t;
	}
	return NULL;
}

/* The centre of the bounding sphere, as in LIGGGHTS; the centre of mass if the template does not exist any more. */
static void find_middle(const struct tsim *sim, const struct ts_body *body, double x[3])
{
	const struct ts_template *t = find_template(sim, body);
	double d[3], own[3], arm[3], m[3][3];

	ts_scale(1, body->x, x);
	if (!t)
		return;
	ts_sub(t->clump->middle, t->clump->centre, d);
	ts_quaternion_matrix(t->body.q, m);
	ts_rotate_back(m, d, own);
	ts_quaternion_matrix(body->q, m);
	ts_rotate(m, own, arm);
	ts_add(x, arm, x);
}

/* While there are any, all particles and bodies are on all ranks when particles are inserted:
 * ts_insertion_divides. */
static void count_clumps(const struct ts_insertion_region *s, const struct tsim *sim, struct content *c)
{
	const struct ts_rigid *r = sim->rigid;

	for (size_t b = 0; b < r->n; b++) {
		const struct ts_body *body = &r->body[b];
		double x[3];

		if (!(body->kind > 0))
			continue;
		find_middle(sim, body, x);
		ts_insertion_wrap(&sim->domain->box, x);
		if (!ts_region_contains(s->region, x))
			continue;
		c->number++;
		ts_exactsum_add(&c->sum[MASS], body->mass);
		ts_exactsum_add(&c->sum[VOLUME], body->mass / body->density);
	}
}

static void find_content(const struct ts_insertion_region *s, const struct tsim *sim,
			 struct ts_region_content *out)
{
	struct content c = { 0, { ts_exactsum_start(), ts_exactsum_start() } };

	count_spheres(s, sim, &c);
	count_clumps(s, sim, &c);
	ts_rank_sums_count(sim, &c.number);
	ts_rank_sums_merge(sim, c.sum, 2);
	*out = (struct ts_region_content){ .room = s->volume,
					   .number = c.number,
					   .mass = ts_exactsum_value(&c.sum[MASS]),
					   .volume = ts_exactsum_value(&c.sum[VOLUME]) };
}

enum ts_status ts_insertion_region_content(struct ts_instance *self, struct tsim *sim,
					   struct ts_region_content *out)
{
	const struct ts_insertion_region *s = self->state;

	TS_TRY(ts_region_update(s->region, sim));
	if (out) {
		TS_TRY(renew_volume(self, sim));
		find_content(s, sim, out);
	}
	/* as in LIGGGHTS, the new volume is used from the next insertion on */
	return is_shrink_wrapped(&sim->domain->box) ? estimate_volume(self, sim) : TS_OK;
}

/* ---- positions */

struct search {
	struct ts_insertion_region *s;
	const struct ts_box *box;
	double lo[3], hi[3]; /* box in which points are drawn */
	struct ts_spherehash occupied;
	struct ts_insertion_meshes meshes;
	int64_t tries, most_tries;
	int64_t patience; /* limit of `tries` after a request to stop; 0: no request */
};

static bool near_border(const struct ts_box *box, const double x[3], double radius)
{
	for (int d = 0; d < 3; d++)
		if (x[d] - box->lo[d] < radius || box->hi[d] - x[d] < radius)
			return true;
	return false;
}

static enum ts_status draw_in_region(struct ts_instance *self, struct tsim *sim, const struct search *search,
				     struct ts_new_particle *one)
{
	const struct ts_insertion_region *s = self->state;

	for (int64_t k = 0; k < MOST_POINTS; k++) {
		draw_point(position_stream(s), search->lo, search->hi, one->x);
		if (fits_region(s, one->x, one->radius))
			return TS_OK;
	}
	return ts_fail(&sim->error, TS_RANGE, &self->where,
		       "fix %s: no place in region %s is %g deep, the radius of a particle; take a larger "
		       "region, or all_in no",
		       self->style->name, s->region->id, one->radius);
}

static void draw_motion(struct ts_insertion *s, struct ts_new_particle *one)
{
	ts_insertion_draw_velocity(s, one);
	for (int d = 0; d < 3; d++)
		one->omega[d] = s->omega[d];
	ts_insertion_draw_orientation(s, one);
}

/* Fails some time after a request to stop: a search that ends earlier completes the step, whose state can
 * then be saved. */
static enum ts_status check_stop_request(struct ts_instance *self, struct tsim *sim, struct search *search)
{
	if (!sim->requests.stop)
		return TS_OK;
	if (!search->patience)
		search->patience = search->tries + TRIES_AFTER_STOP;
	if (search->tries < search->patience)
		return TS_OK;
	return ts_fail(&sim->error, TS_STOPPED, &self->where,
		       "fix %s: stopped on request during the search for positions, after %" PRId64
		       " tries; the step is not finished, and no particle is made in it",
		       self->style->name, search->tries);
}

/* Searches a position; the limit of trial positions is common to all particles. */
static enum ts_status place_particle(struct ts_instance *self, struct tsim *sim, struct search *search,
				     struct ts_new_particle *one)
{
	struct ts_insertion_region *s = self->state;
	bool touches = false;

	while (!one->placed && search->tries < search->most_tries) {
		TS_TRY(check_stop_request(self, sim, search));
		do {
			TS_TRY(draw_in_region(self, sim, search, one));
			search->tries++;
		} while (search->tries < search->most_tries && s->check_border &&
			 near_border(search->box, one->x, one->radius));
		if (search->tries == search->most_tries)
			return TS_OK;
		draw_motion(&s->base, one);
		one->placed = !ts_insertion_overlaps(sim, &search->occupied, one);
		if (one->placed && search->meshes.n)
			TS_TRY(ts_insertion_meshes_touch(&search->meshes, sim, one->x, one->radius,
							 &touches));
		one->placed = one->placed && !touches;
	}
	return one->placed ? ts_insertion_hash_add(sim, &search->occupied, one) : TS_OK;
}

static enum ts_status place_unchecked(struct ts_instance *self, struct tsim *sim, struct search *search,
				      struct ts_new_particle *one)
{
	struct ts_insertion_region *s = self->state;

	TS_TRY(draw_in_region(self, sim, search, one));
	draw_motion(&s->base, one);
	one->placed = true;
	return TS_OK;
}

static enum ts_status place_particles(struct ts_instance *self, struct tsim *sim, int64_t most_tries)
{
	struct ts_insertion_region *s = self->state;
	struct search search = { .s = s, .box = &sim->domain->box, .most_tries = most_tries };
	enum ts_status status = TS_OK;

	find_bounds(s, search.box, search.lo, search.hi);
	if (s->base.overlapcheck)
		status = ts_insertion_hash_near(sim, &search.occupied, search.lo, search.hi,
						ts_insertion_reach(&s->base.list));
	if (status == TS_OK && s->avoid.n)
		status = ts_insertion_meshes_start(&search.meshes, sim, &s->avoid);
	for (size_t k = 0; status == TS_OK && k < s->base.list.n; k++)
		status = (s->base.overlapcheck ? place_particle : place_unchecked)(self, sim, &search,
										   &s->base.list.item[k]);
	ts_spherehash_release(&search.occupied);
	ts_insertion_meshes_release(&search.meshes);
	return status;
}

enum ts_status ts_insertion_region_event(struct ts_instance *self, struct tsim *sim, int64_t n,
					 int64_t most_tries)
{
	struct ts_insertion *s = self->state;
	size_t from;

	TS_TRY(ts_distribution_draw(s->distribution, sim, self, n, s->random_distribute == 0, &s->list));
	TS_TRY(place_particles(self, sim, most_tries));
	return ts_insertion_make(self, sim, &from);
}

enum ts_status ts_insertion_region_scatter(struct ts_instance *self, struct tsim *sim, int64_t n)
{
	struct ts_insertion *s = self->state;

	s->overlapcheck = false;
	TS_TRY(ts_distribution_draw(s->distribution, sim, self, n, s->random_distribute == 0, &s->list));
	return place_particles(self, sim, n);
}

enum ts_status ts_insertion_region_archive(struct ts_instance *self, struct tsim *sim,
					   struct ts_archive *archive)
{
	struct ts_insertion_region *s = self->state;

	TS_TRY(ts_insertion_archive(self, sim, archive));
	if (ts_archive_has(archive, "bounds"))
		TS_TRY(ts_archive_fixed(archive, "bounds", TS_SAVED_F64, s->bounds, 6));
	return ts_template_archive_stream(archive, sim, "places", position_stream(s));
}
