/* Fix insert/stream: inserts a stream of particles through a plane face. */
#include "core/deferred_loops.h"
#include "core/ranks.h"
#include "core/report.h"

#include <string.h>

#include "base/sort.h"
#include "box/domain.h"
#include "insert/insertion_rate.h"
#include "insert/stream.h"
#include "math/rigid_turn.h"
#include "math/vec3.h"
#include "mesh/mesh_motion.h"
#include "particle/columns.h"
#include "particle/particles.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

struct state {
	union {
		struct ts_insertion base;
		struct ts_stream stream;
	};
	struct ts_insertion_rate rate;
	const char *face_id;
	double given_length;
	int64_t duration;
	bool parallel;

	struct ts_mesh_surface *face;
	double length;	  /* of the space behind the face that is filled */
	double normal[3]; /* unit normal of the face, against the stream */
	double speed;	  /* normal to the face */
	int32_t *moving;  /* [nmoving], local indices of particles moving to the face, or just released */
	size_t nmoving, moving_capacity;
	uint64_t generation; /* of the particles when `moving` was listed */
	/* saved */
	int64_t release;  /* largest age of the stream at which a particle is released */
	int32_t measured; /* the space behind the face has been checked */
	double dt;	  /* time step of the ages at which particles began their way and pass the face */
};

/* As in LIGGGHTS, seed of the random stream of points on a mesh, which fixes with the same face share. */
static const int64_t MESH_SEED = 179424799;
/* Relative tolerance when length / (speed dt) is rounded down, so that a stream of 1 m/s takes 1500 steps of
 * 2e-5 s for 0.03 m. LIGGGHTS adds 1e-14 units of length to the length. */
static const double ROUNDING = 1e-13;
/* Smallest angle, in radian, between the velocity and the face. */
static const double ALONG = 1e-6;
/* Random points to estimate which fraction of the space behind the face lies in the box. */
enum { NMEASURE = 100000 };

/* ---- set-up */

static enum ts_status find_face(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->face_id, .place = *ts_instance_word(self, s->face_id) };
	const struct ts_instance *mover;
	const struct ts_mesh *mesh;
	double through;

	TS_TRY(ts_mesh_surface_require(sim, &id, &s->face));
	mover = ts_mesh_mover_of(sim, s->face_id);
	if (mover)
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "fix insert/stream: mesh %s is moved by fix %s (%s:%d), but the face of a "
			       "stream must stay where it is",
			       s->face_id, mover->id, TS_FILE_AND_LINE(mover->where));
	mesh = &s->face->mesh;
	for (size_t t = 1; t < mesh->n; t++)
		if (fabs(ts_dot(mesh->normal[t], mesh->normal[0])) < 1 - 1e-6)
			return ts_fail(&sim->error, TS_STATE, &id.place,
				       "fix insert/stream: mesh %s is not plane: triangle %zu is inclined "
				       "against the first one",
				       s->face_id, t + 1);
	if (!mesh->n)
		return ts_fail(&sim->error, TS_STATE, &id.place,
			       "fix insert/stream: mesh %s has no triangles", s->face_id);
	through = ts_dot(s->base.velocity.mean, mesh->normal[0]);
	s->speed = fabs(through);
	if (!(s->speed > ALONG * ts_norm(s->base.velocity.mean)))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "vel"),
			       "fix insert/stream: the velocity through the face is %g, expected a stream "
			       "through it: say `vel constant vx vy vz`, not along the face",
			       s->speed);
	ts_scale(through > 0 ? -1 : 1, mesh->normal[0], s->normal);
	ts_scale(-s->speed, s->normal, s->stream.drift);
	return TS_OK;
}

/* With another time step than before: particles on their way to the face began it other numbers of steps ago, and pass the
 * face in other numbers of steps. */
static void count_in_new_steps(struct state *s, const struct tsim *sim, double before)
{
	const double age = (double)s->stream.age, dt = sim->clock.dt;
	double last = 0;

	for (size_t i = 0; i < sim->particles->n; i++) {
		double *memory = ts_stream_record(&s->stream, sim, i);
		double elapsed = (age - memory[TS_STREAM_START]) * before;
		double left = memory[TS_STREAM_DISTANCE] / s->speed - elapsed;

		if (!(memory[TS_STREAM_RELEASE] > 0))
			continue;
		memory[TS_STREAM_START] = age - elapsed / dt;
		memory[TS_STREAM_RELEASE] = age + floor(fmax(left, 0) / dt * (1 + ROUNDING));
		last = fmax(last, memory[TS_STREAM_RELEASE]);
	}
	s->release = (int64_t)ts_ranks_most(sim, last);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double before = s->dt;
	char name[80];
	bool first;

	TS_TRY(ts_insertion_init(self, sim, &first));
	TS_TRY(ts_insertion_rate_init(self, sim, &s->rate));
	TS_TRY(find_face(self, sim));
	if ((s->base.every_word != NULL) == !isnan(s->given_length))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix insert/stream: expected one of insert_every and extrude_length, found %s",
			       s->base.every_word ? "both" : "none");
	if (s->base.every_word && s->base.every < 1)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "insert_every"),
			       "fix insert/stream: insert_every is '%s', expected a number of steps > 0",
			       s->base.every_word);
	if (s->duration != INT64_MIN && (!s->base.every_word || s->duration > s->base.every))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "duration"),
			       "fix insert/stream: duration is a part of insert_every");
	if (!s->face->random.state)
		s->face->random = ts_minstd_start(MESH_SEED);
	snprintf(name, sizeof name, "stream %s", self->id);
	TS_TRY(ts_particles_add_column(sim, name, TS_STREAM_WIDTH, 0, &s->stream.column));
	s->dt = sim->clock.dt;
	if (before > 0 && (before < s->dt || before > s->dt))
		count_in_new_steps(s, sim, before);
	return TS_OK;
}

/* interval * speed = length; computed for each run, since the time step may change. */
static enum ts_status find_length(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;
	double travel = s->speed * sim->clock.dt;
	int64_t steps = s->duration == INT64_MIN ? s->base.every : s->duration;
	double least = (s->base.every_word ? 2 : 3) * d->largest;

	if (s->base.every_word) {
		s->length = (double)steps * sim->clock.dt * s->speed;
	} else {
		s->length = s->given_length;
		s->base.every = (int64_t)fmin(s->length / travel * (1 + ROUNDING), 1e15);
	}
	if (s->length < least)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix insert/stream: the space behind the face is %g long, expected at least "
			       "%g, %s radii of the largest particle; raise %s",
			       s->length, least, s->base.every_word ? "two" : "three",
			       s->base.every_word ? "insert_every" : "extrude_length");
	if (s->base.every < 1)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix insert/stream: particles move %g in a step, the space behind the face is "
			       "%g long; raise extrude_length or take a smaller step",
			       travel, s->length);
	return TS_OK;
}

static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(find_length(self, sim));
	ts_insertion_rate_print(self, sim, &s->rate);
	return TS_OK;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return report->limits_only ? TS_OK : find_length(self, sim);
}

/* ---- positions */

/* Whether the distance to all outer edges of the face is at least the radius. */
static bool inside_face(const struct ts_mesh *mesh, const double x[3], double radius)
{
	for (size_t t = 0; t < mesh->n; t++) {
		for (int k = 0; k < 3; k++) {
			double d[3], along;

			if (mesh->neighbour[t][k] != -1)
				continue;
			ts_sub(x, mesh->x[t][k], d);
			along = fmax(0, fmin(mesh->length[t][k], ts_dot(d, mesh->along[t][k])));
			ts_axpy(-along, mesh->along[t][k], d);
			if (ts_dot(d, d) < radius * radius)
				return false;
		}
	}
	return true;
}

/* Draws a triangle with a probability proportional to its area, then a uniform point on it by rejection. */
static void draw_on_face(struct ts_mesh_surface *face, double x[3])
{
	const struct ts_mesh *mesh = &face->mesh;
	double total = 0, sum = mesh->area[0], r, u, v;
	size_t t = 0;

	for (size_t k = 0; k < mesh->n; k++)
		total += mesh->area[k];
	r = ts_minstd_uniform(&face->random) * total;
	while (sum < r && t + 1 < mesh->n)
		sum += mesh->area[++t];
	do {
		u = ts_minstd_uniform(&face->random);
		v = ts_minstd_uniform(&face->random);
	} while (u + v > 1);
	for (int d = 0; d < 3; d++)
		x[d] = (1 - u - v) * mesh->x[t][0][d] + v * mesh->x[t][1][d] + u * mesh->x[t][2][d];
}

/* The search fails after this number of points on the face that are too close to its edge. */
static const int64_t MOST_POINTS = 10000000;

/* Draws a position at the depth R .. L + R behind the face; without a check of overlaps R .. L - R. */
static enum ts_status draw_position(struct ts_instance *self, struct tsim *sim, double radius, double x[3])
{
	struct state *s = self->state;
	double depth, length = s->base.overlapcheck ? s->length : s->length - 2 * radius;
	int64_t k = 0;

	do {
		draw_on_face(s->face, x);
		if (k++ == MOST_POINTS)
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "fix insert/stream: no point of the face is %g from its edge, the "
				       "radius of a particle; take a larger face, or all_in no",
				       radius);
	} while (s->base.all_in && !inside_face(&s->face->mesh, x, radius));
	depth = ts_minstd_uniform(&s->base.random) * length + radius;
	ts_axpy(depth, s->normal, x);
	return TS_OK;
}

static bool in_box(const struct ts_box *box, const double x[3], double radius)
{
	for (int d = 0; d < 3; d++)
		if (x[d] - box->lo[d] < radius || box->hi[d] - x[d] < radius)
			return false;
	return true;
}

/* Checks, in the first insertion and in all with shrink-wrapped faces, how much of the space behind the
 * face lies in the box; as in LIGGGHTS the points drawn here advance the random streams. */
static enum ts_status check_space_in_box(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	bool moves = false;
	int outside = 0;

	for (int k = 0; k < 6; k++)
		moves |= box->face[k / 2][k % 2] >= TS_FACE_SHRINK;
	if (s->measured && !moves)
		return TS_OK;
	s->measured = 1;
	for (int k = 0; k < NMEASURE; k++) {
		double x[3];

		draw_on_face(s->face, x);
		ts_axpy(ts_minstd_uniform(&s->base.random) * s->length, s->normal, x);
		outside += !in_box(box, x, 0);
	}
	if (outside > NMEASURE / 10)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix insert/stream: %.0f%% of the space behind the face, %g long, are outside "
			       "the box; make the box larger, or extrude_length smaller",
			       100.0 * outside / NMEASURE, s->length);
	if (outside && !s->base.warned && ts_ranks_first(sim))
		ts_warn(&sim->log, &self->where,
			"fix insert/stream: %.2f%% of the space behind the face, %g long, are outside the "
			"box: no particle will come from there",
			100.0 * outside / NMEASURE, s->length);
	return TS_OK;
}

struct search {
	const struct ts_box *box;
	struct ts_spherehash occupied;
	int64_t tries, most_tries;
};

static enum ts_status place_particle(struct ts_instance *self, struct tsim *sim, struct search *search,
				     struct ts_new_particle *one)
{
	struct state *s = self->state;

	while (!one->placed && search->tries < search->most_tries) {
		do {
			TS_TRY(draw_position(self, sim, one->radius, one->x));
			search->tries++;
		} while (search->tries < search->most_tries && !in_box(search->box, one->x, one->radius));
		if (search->tries == search->most_tries)
			return TS_OK;
		ts_insertion_draw_orientation(&s->base, one);
		one->placed = !ts_insertion_overlaps(sim, &search->occupied, one);
	}
	return one->placed ? ts_insertion_hash_add(sim, &search->occupied, one) : TS_OK;
}

/* Those that particles in the space behind the face may overlap. */
static enum ts_status hash_present(const struct state *s, struct tsim *sim, struct ts_spherehash *occupied)
{
	const struct ts_mesh *mesh = &s->face->mesh;
	const double reach = ts_insertion_reach(&s->base.list), depth = s->length + reach;
	double lo[3] = { INFINITY, INFINITY, INFINITY }, hi[3] = { -INFINITY, -INFINITY, -INFINITY };

	for (size_t t = 0; t < mesh->n; t++)
		for (int k = 0; k < 3; k++)
			for (int d = 0; d < 3; d++) {
				double x = mesh->x[t][k][d], end = x + depth * s->normal[d];

				lo[d] = fmin(lo[d], fmin(x, end));
				hi[d] = fmax(hi[d], fmax(x, end));
			}
	return ts_insertion_hash_near(sim, occupied, lo, hi, reach);
}

static enum ts_status place_particles(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_new_particles *list = &s->base.list;
	struct search search = { .box = &sim->domain->box,
				 .most_tries = (int64_t)list->n * s->base.maxattempt };
	enum ts_status status = TS_OK;

	if (s->base.overlapcheck)
		status = hash_present(s, sim, &search.occupied);
	for (size_t k = 0; status == TS_OK && k < list->n; k++) {
		if (s->base.overlapcheck) {
			status = place_particle(self, sim, &search, &list->item[k]);
			continue;
		}
		status = draw_position(self, sim, list->item[k].radius, list->item[k].x);
		ts_insertion_draw_orientation(&s->base, &list->item[k]);
		list->item[k].placed = true;
	}
	ts_spherehash_release(&search.occupied);
	return status;
}

/* ---- the stream */

/* The numbers of a rigid body are found for its first sphere; the others have copies, since they may be of other ranks. */
static bool is_first_of_body(const struct ts_particles *p, size_t from, size_t i)
{
	return i == from || !ts_rigid_same(p, i - 1, i);
}

static struct ts_body *body_of(struct tsim *sim, size_t i)
{
	const struct ts_body *body = ts_rigid_body_of(sim, i);

	return body ? &sim->rigid->body[body - sim->rigid->body] : NULL;
}

/* Prescribes the motion of a rigid body: it does not rotate until it is released, and in LIGGGHTS not
 * then either. */
static void prescribe_body(const struct state *s, const struct tsim *sim, struct ts_body *body,
			   const double *memory, bool free)
{
	double time = ((double)s->stream.age - memory[TS_STREAM_START]) * sim->clock.dt;

	for (int k = 0; k < 3; k++) {
		double v = -s->speed * s->normal[k];

		if (!free)
			body->x[k] = memory[TS_STREAM_PLACE + k] + time * v;
		body->v[k] = free ? memory[TS_STREAM_VELOCITY + k] : v;
		body->omega[k] = free && sim->legacy != TS_LEGACY_LIGGGHTS ? s->base.omega[k] : 0;
	}
	ts_rigid_angular_momentum(body->q, body->inertia, body->omega, body->spin);
}

/* The numbers of a particle, or a body, that begins its way to the face here. */
static void record_start(struct state *s, const struct tsim *sim, const double x[3], double *memory)
{
	struct ts_new_particle free = { 0 };
	double d[3];

	ts_insertion_draw_velocity(&s->base, &free);
	ts_scale(1, x, memory + TS_STREAM_PLACE);
	ts_scale(1, free.v, memory + TS_STREAM_VELOCITY);
	ts_sub(memory + TS_STREAM_PLACE, s->face->mesh.x[0][0], d);
	memory[TS_STREAM_START] = (double)s->stream.age;
	memory[TS_STREAM_DISTANCE] = ts_dot(d, s->normal);
	memory[TS_STREAM_RELEASE] =
		(double)s->stream.age + floor(memory[TS_STREAM_DISTANCE] / (s->speed * sim->clock.dt));
	s->release = (int64_t)fmax((double)s->release, memory[TS_STREAM_RELEASE]);
}

/* New particles move along the normal to the face, where they get the velocity of the keyword vel. */
static void start_particle(struct state *s, struct tsim *sim, size_t from, size_t i)
{
	struct ts_particles *p = sim->particles;
	double *memory = ts_stream_record(&s->stream, sim, i);
	struct ts_body *body = body_of(sim, i);

	for (int k = 0; k < 3; k++)
		p->v[i][k] = -s->speed * s->normal[k];
	if (!is_first_of_body(p, from, i)) {
		memcpy(memory, ts_stream_record(&s->stream, sim, i - 1), TS_STREAM_WIDTH * sizeof *memory);
		memory[TS_STREAM_DISTANCE] = -1;
		return;
	}
	record_start(s, sim, body ? body->x : p->x[i], memory);
	if (body)
		prescribe_body(s, sim, body, memory, false);
}

/* Velocities of those of other ranks are drawn, too. */
static void start_particles(struct ts_instance *self, struct tsim *sim, size_t from)
{
	struct state *s = self->state;
	double memory[TS_STREAM_WIDTH];

	for (size_t k = 0; k < s->base.spheres; k++) {
		const struct ts_new_sphere *sphere = &s->base.sphere[k];

		if (sphere->row >= 0)
			start_particle(s, sim, from, (size_t)sphere->row);
		else
			record_start(s, sim, sphere->x, memory);
	}
	s->generation = 0;
}

static enum ts_status advance_stream(struct ts_instance *self, struct tsim *sim)
{
	((struct ts_stream *)self->state)->age++;
	return ts_insertion_check(self, sim);
}

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	size_t from;
	int64_t n;

	if (!s->base.due)
		return TS_OK;
	n = ts_insertion_rate_count(self, sim, &s->rate);
	if (n > 0) {
		TS_TRY(check_space_in_box(self, sim));
		TS_TRY(ts_distribution_draw(s->base.distribution, sim, self, n,
					    s->base.random_distribute == 0, &s->base.list));
		TS_TRY(place_particles(self, sim));
		TS_TRY(ts_insertion_make(self, sim, &from));
		start_particles(self, sim, from);
	}
	ts_insertion_rate_next(self, &s->rate);
	return TS_OK;
}

/* The velocity at which particles move to the face, and their displacement in a time step, length. */
struct feed {
	double v[3], step;
};

static struct feed feed_of(const struct state *s, const struct tsim *sim)
{
	struct feed feed;

	ts_scale(-s->speed, s->normal, feed.v);
	feed.step = sim->clock.dt * ts_norm(feed.v);
	return feed;
}

/* Sets the position to start + time * v, so that neither rounding nor the forces of a set-up change the
 * path, as in LIGGGHTS. Particles that were wrapped into a periodic box are not corrected. */
static void correct_position(struct ts_particles *p, size_t i, const double start[3], const struct feed *feed,
			     double time)
{
	for (int k = 0; k < 3; k++) {
		double to = start[k] + time * feed->v[k];

		if (fabs(to - p->x[i][k]) <= feed->step)
			p->x[i][k] = to;
	}
}

static void prescribe_sphere(const struct state *s, struct tsim *sim, size_t i, const double *memory,
			     const struct feed *feed, bool free)
{
	struct ts_particles *p = sim->particles;

	correct_position(p, i, memory + TS_STREAM_PLACE, feed,
			 ((double)s->stream.age - memory[TS_STREAM_START]) * sim->clock.dt);
	for (int k = 0; k < 3; k++) {
		p->v[i][k] = free ? memory[TS_STREAM_VELOCITY + k] : feed->v[k];
		p->f[i][k] = 0;
		if (p->torque)
			p->torque[i][k] = 0;
		if (p->omega)
			p->omega[i][k] = free ? s->base.omega[k] : 0;
	}
}

static void prescribe_motion(const struct state *s, struct tsim *sim, size_t i, const struct feed *feed)
{
	double *memory = ts_stream_record(&s->stream, sim, i);
	bool free = (double)s->stream.age >= memory[TS_STREAM_RELEASE];
	struct ts_body *body = sim->rigid->n ? body_of(sim, i) : NULL;

	if (!(memory[TS_STREAM_RELEASE] > 0))
		return;
	if (body) {
		size_t first = sim->rigid->start[body - sim->rigid->body];
		size_t end = sim->rigid->start[body - sim->rigid->body + 1];

		prescribe_body(s, sim, body, memory, free);
		if (!free ||
		    sim->legacy != TS_LEGACY_LIGGGHTS) /* in LIGGGHTS its spheres follow in the next step */
			ts_rigid_place(sim, body, sim->rigid->member + first, end - first);
	} else {
		prescribe_sphere(s, sim, i, memory, feed, free);
	}
	if (free)
		memory[TS_STREAM_RELEASE] *= -1;
}

struct prescribe_task {
	const struct state *s;
	struct tsim *sim;
	struct feed feed;
};

static void prescribe_range(void *context, size_t from, size_t to)
{
	const struct prescribe_task *t = context;

	for (size_t k = ts_find_int32(t->s->moving, t->s->nmoving, sizeof *t->s->moving, (int32_t)from);
	     k < t->s->nmoving && (size_t)t->s->moving[k] < to; k++)
		prescribe_motion(t->s, t->sim, (size_t)t->s->moving[k], &t->feed);
}

/* Lists the particles moving to the face, which are few of many, whenever the order of particles has
 * changed. */
static enum ts_status list_moving(struct state *s, struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;

	if (s->generation == sim->generation)
		return TS_OK;
	if (TS_GROW(s->moving, s->moving_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	s->nmoving = 0;
	for (size_t i = 0; i < p->n; i++)
		if (ts_stream_record(&s->stream, sim, i)[TS_STREAM_RELEASE] > 0)
			s->moving[s->nmoving++] = (int32_t)i;
	s->generation = sim->generation;
	return TS_OK;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct prescribe_task task = { s, sim, feed_of(s, sim) };

	if (s->stream.age > s->release)
		return TS_OK;
	TS_TRY(list_moving(s, sim));
	if (!sim->rigid->n) {
		TS_DEFER_LOOP(sim, sim->particles->n, prescribe_range, &task);
		return TS_OK;
	}
	ts_deferred_loops_run(sim); /* the spheres of a body may have any index */
	TS_TRY(ts_rigid_list(sim));
	prescribe_range(&task, 0, sim->particles->n);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->moving);
	ts_insertion_fini(self);
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	TS_TRY(ts_insertion_archive(self, sim, a));
	if (!ts_sim_find(sim, TS_KIND_FIX, s->face_id) ||
	    ts_sim_find(sim, TS_KIND_FIX, s->face_id)->state != (const void *)s->face)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix insert/stream: fix %s has been deleted or defined anew since the last "
			       "run: run first",
			       s->face_id);
	if (ts_archive_writing(a) || ts_archive_has(a, "dt")) /* older files do not have it */
		TS_TRY(ts_archive_fixed(a, "dt", TS_SAVED_F64, &s->dt, 1));
	TS_TRY(ts_template_archive_stream(a, sim, "face", &s->face->random));
	return ts_particles_archive_column(a, sim, sim->particles->column[s->stream.column].name,
					   s->stream.column);
}

static const struct ts_arg args[] = {
	TS_INSERTION_ARGS(struct state),
	TS_INSERTION_RATE_ARGS(struct state),
	TS_WORD("insertion_face", struct state, face_id,
		.help = "ID of a plane fix mesh/surface through which particles are inserted"),
	TS_REAL("extrude_length", struct state, given_length, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "length",
		.help = "length of the space behind the face that is filled; the next insertion is due when "
			"the stream has left it"),
	TS_WORD("insert_every", struct state, base.every_word, .flags = TS_OPTIONAL,
		.help = "instead of extrude_length: steps between insertions"),
	TS_INT("duration", struct state, duration, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "with insert_every: number of steps in which the particles of an insertion pass the "
		       "face, followed by a pause"),
	TS_BOOL("parallel", struct state, parallel, .fallback = "no", .help = "no effect"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_INSERTION_SAVED(struct state),
	TS_SAVE_I64(struct state, stream.age),
	TS_SAVE_I64(struct state, release),
	TS_SAVE_I32(struct state, measured),
	TS_SAVED_ROWS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "nparticles mass particlerate massrate insertion_face extrude_length insert_every" },
	TS_INSERTION_GROUPS,
	{ "The stream", "duration parallel" },
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_insert_stream)
const struct ts_style ts_fix_insert_stream = {
	.name = "insert/stream",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_STEPS | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_insertion_whole_due,
	.summary = "Inserts a stream of particles through a plane face",
	.purpose =
		"A feeder: grains fall through a face into the simulation at a given rate. It needs a plane "
		"fix mesh/surface, and a fix particledistribution/discrete with templates of particles.",
	.doc = "In each insertion, rate times interval particles are placed at random in the space behind a "
	       "plane mesh: the face extruded by the length L against the velocity. They move towards the "
	       "face with the normal component of the velocity, irrespective of forces. When their centers "
	       "reach the face, they get the given velocity and angular velocity and are released. The "
	       "interval is L divided by the normal speed; extrude_length sets L, or insert_every sets the "
	       "interval, of which only duration is filled.\n\n"
	       "Positions, numbers and velocities are drawn from the random streams of LIGGGHTS 3.8, in the "
	       "same order. With overlapcheck yes centers lie between R and L + R behind the face, and "
	       "positions are drawn again if particles overlap or extend beyond the box; else they lie "
	       "between R and L - R. all_in yes keeps particles within the outer edges of the face. The "
	       "number of particles is rounded up or down at random so that the mean is exact. A total mass "
	       "M gives the total number M divided by the mean mass of a particle of the mixture, as in "
	       "LIGGGHTS: the mass inserted differs from M if particles of the mixture have different "
	       "masses. The face must not move.\n\n"
	       "A rigid clump is released when its centre of mass reaches the face; it does not rotate "
	       "before. LIGGGHTS does not give it the angular velocity at the face; neither does tsim with "
	       "`legacy yes`.\n\n"
	       "As in LIGGGHTS, f_release_fix_insert_stream[1] to [14] are per-particle quantities: position "
	       "(1 to 3) and step (4) of the insertion, step of the release (5), velocity until then (6 to "
	       "8), velocity (9 to 11) and angular velocity (12 to 14) at the release. They are 0 for other "
	       "particles.",
	.example = "fix pour all insert/stream seed 32452867 distributiontemplate mix nparticles 5000 vel "
		   "constant 0 -0.5 -2 particlerate 1000 overlapcheck yes insertion_face hole extrude_length "
		   "0.6",
	.family = TS_FAMILY_STREAM,
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = ts_insertion_values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = advance_stream,
		  [TS_STAGE_PRE_EXCHANGE] = pre_exchange,
		  [TS_STAGE_SETUP] = setup,
		  [TS_STAGE_END_OF_STEP] = end_of_step },
	.plan = plan,
	.defers = TS_DEFERS(END_OF_STEP),
	.fini = fini,
};
