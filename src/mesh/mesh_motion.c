#include "base/clones.h"
TS_UNROLLED

#include "mesh/mesh_motion.h"

#include <math.h>
#include <string.h>

#include "base/inline.h"
#include "base/parallel.h"

#include "base/banned.h"

void ts_mesh_motions_release(struct ts_mesh_surface *s)
{
	ts_free(s->home);
	ts_free(s->motion);
	ts_free(s->serial);
	s->home = NULL;
	s->motion = NULL;
	s->serial = NULL;
	s->nmotions = s->motion_capacity = s->serial_capacity = 0;
}

static const struct ts_motion *total_motion(const struct ts_mesh_surface *s)
{
	return s->nmotions == 1 ? &s->motion[0].now : &s->carried;
}

/* Moves a corner to its present position; returns the square of its displacement. */
TS_INLINE double place_corner(const struct ts_motion *m, const double *home, double *x)
{
	double now[3], far;

	ts_motion_apply(m, home, now);
	far = ts_distance2(now, x);
	for (int d = 0; d < 3; d++)
		x[d] = now[d];
	return far;
}

/* Moves corners from .. to-1; returns the square of the largest displacement. */
TS_CLONES static double place_corners(const struct ts_motion *motion, const double *restrict home,
				      double *restrict x, size_t from, size_t to)
{
	const struct ts_motion m = *motion;
	double most = 0;

#pragma omp simd reduction(max : most)
	for (size_t c = from; c < to; c++) {
		double far = place_corner(&m, home + 3 * c, x + 3 * c);

		most = far > most ? far : most;
	}
	return most;
}

struct placement {
	struct ts_mesh_surface *s;
	double most;
};

static void place_range(void *context, size_t from, size_t to)
{
	struct placement *g = context;
	struct ts_mesh_surface *s = g->s;
	double most = place_corners(total_motion(s), s->home[0][0], s->mesh.x[0][0], 3 * from, 3 * to);

	ts_mesh_update_triangles(&s->mesh, from, to);
#pragma omp critical
	g->most = fmax(g->most, most);
}

/* Moves all corners; returns the largest displacement, length. */
static double place_mesh(const struct tsim *sim, struct ts_mesh_surface *s)
{
	struct placement g = { s, 0 };

	ts_parallel(ts_team(sim, 8 * s->mesh.n), s->mesh.n, place_range, &g);
	ts_motion_apply(total_motion(s), s->anchor_home, s->anchor);
	s->moves++;
	return sqrt(g.most);
}

void ts_mesh_surface_place(const struct tsim *sim, struct ts_mesh_surface *s)
{
	place_mesh(sim, s);
}

/* Sets the reference so that the present positions result from it: by the total motion of a single mover,
 * else by no motion. */
static void reset_home(struct ts_mesh_surface *s)
{
	static const struct ts_motion none = { .turn = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
	const struct ts_motion *m = s->nmotions == 1 ? &s->motion[0].now : &none;

	s->carried = none;
	for (size_t c = 0; c < 3 * s->mesh.n; c++)
		ts_motion_undo(m, s->mesh.x[c / 3][c % 3], s->home[c / 3][c % 3]);
	ts_motion_undo(m, s->anchor, s->anchor_home);
}

/* Advances the mesh by motion k in a step, and the centres of the motions after it. */
static void advance_motion(struct ts_mesh_surface *s, size_t k, double dt)
{
	const struct ts_mesh_motion *m = &s->motion[k];
	struct ts_motion step = ts_motion_none();
	double speed = ts_norm(m->spin), axis[3];

	ts_scale(speed > 0 ? 1 / speed : 0, m->spin, axis);
	ts_motion_set_turn(&step, axis, speed * dt);
	ts_scale(1, m->centre, step.origin);
	ts_scale(dt, m->drift, step.shift);
	s->carried = ts_motion_compose(&s->carried, &step);
	while (++k < s->nmotions)
		ts_motion_apply(&step, s->motion[k].centre, s->motion[k].centre);
}

/* Adds the velocity of a motion at x, drift + spin x (x - centre), or sets it if this is the first motion. */
TS_INLINE void add_corner_velocity(const struct ts_mesh_motion *m, bool first, const double *x, double *v)
{
	double arm[3], turning[3];

	ts_sub(x, m->centre, arm);
	ts_cross(m->spin, arm, turning);
	for (int d = 0; d < 3; d++)
		v[d] = (first ? 0 : v[d]) + m->drift[d] + turning[d];
}

TS_CLONES static void add_corner_velocities(const struct ts_mesh_motion *motion, bool first,
					    const double *restrict x, double *restrict v, size_t n)
{
	const struct ts_mesh_motion m = *motion;

#pragma omp simd
	for (size_t c = 0; c < n; c++)
		add_corner_velocity(&m, first, x + 3 * c, v + 3 * c);
}

/* Adds the velocity of motion k at the present positions: later motions have not been applied in this
 * step. */
static void add_velocity(struct ts_mesh_surface *s, size_t k)
{
	add_corner_velocities(&s->motion[k], k == 0, s->mesh.x[0][0], s->v[0][0], 3 * s->mesh.n);
}

static enum ts_status store_home(struct ts_mesh_surface *s)
{
	if (!s->home) {
		s->home = ts_alloc(s->mesh.n, sizeof *s->home);
		for (size_t t = 0; s->home && t < s->mesh.n; t++)
			for (int k = 0; k < 3; k++)
				ts_scale(1, s->mesh.x[t][k], s->home[t][k]);
		ts_scale(1, s->anchor, s->anchor_home);
	}
	if (!s->v)
		s->v = ts_alloc(s->mesh.n, sizeof *s->v);
	return s->home && s->v ? TS_OK : TS_NOMEM;
}

static size_t find_motion(const struct ts_mesh_surface *s, int64_t serial)
{
	size_t k = 0;

	while (k < s->nmotions && s->serial[k] != serial)
		k++;
	return k;
}

static enum ts_status add_motion(struct ts_mesh_surface *s, struct ts_mesh_mover *mover)
{
	size_t n = s->nmotions + 1;
	struct ts_mesh_motion *m;

	TS_TRY(store_home(s));
	TS_TRY(TS_GROW(s->motion, s->motion_capacity, n));
	TS_TRY(TS_GROW(s->serial, s->serial_capacity, n));
	mover->serial = s->serial[s->nmotions] = ++s->serials;
	m = &s->motion[s->nmotions];
	*m = (struct ts_mesh_motion){ .now = ts_motion_none() };
	ts_scale(1, mover->origin, m->centre);
	s->nmotions = n;
	if (n == 2) /* the first mover was the only one until now */
		reset_home(s);
	return TS_OK;
}

/* Adds the motions of all new movers of the mesh, in script order. */
static enum ts_status add_new_motions(struct tsim *sim, struct ts_mesh_surface *s, const char *mesh)
{
	const struct ts_instance *inst;

	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &k));) {
		struct ts_mesh_mover *mover = inst->state;

		if (ts_streq(mover->mesh, mesh) && find_motion(s, mover->serial) == s->nmotions)
			TS_TRY(add_motion(s, mover));
	}
	return TS_OK;
}

static enum ts_status moved_mesh(struct ts_instance *self, struct tsim *sim, struct ts_mesh_surface **out)
{
	const struct ts_mesh_mover *mover = self->state;
	struct ts_word id = { .text = mover->mesh, .place = *ts_instance_word(self, mover->mesh) };

	return ts_mesh_surface_require(sim, &id, out);
}

enum ts_status ts_mesh_mover_check(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_mesh_mover *mover = self->state;
	struct ts_mesh_surface *s;

	TS_TRY(moved_mesh(self, sim, &s));
	s->has_mover = true;
	if (mover->serial && find_motion(s, mover->serial) == s->nmotions)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: mesh %s has been defined anew since this fix moved it: define fix %s "
			       "anew, too, behind it",
			       self->style->name, mover->mesh, self->id);
	if (s->v && !s->nmotions)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix %s: a mesh with surface_vel or surface_ang_vel cannot move, and one that "
			       "is a servo moves by itself",
			       self->style->name);
	/* a run that is only planned would have moved it */
	if (sim->reading.explain && sim->clock.last_step > sim->clock.step && !mover->serial)
		return add_new_motions(sim, s, mover->mesh) == TS_OK ? TS_OK : ts_nomem(&sim->error);
	return TS_OK;
}

enum ts_status ts_mesh_mover_move(struct ts_instance *self, struct tsim *sim, const struct ts_mesh_motion *m)
{
	struct ts_mesh_mover *mover = self->state;
	struct ts_mesh_surface *s;
	double centre[3];
	size_t k;

	TS_TRY(moved_mesh(self, sim, &s));
	if (find_motion(s, mover->serial) == s->nmotions && add_new_motions(sim, s, mover->mesh) != TS_OK)
		return ts_nomem(&sim->error);
	k = find_motion(s, mover->serial);
	ts_scale(1, s->motion[k].centre, centre);
	s->motion[k] = *m;
	ts_scale(1, centre, s->motion[k].centre);
	if (s->nmotions > 1)
		advance_motion(s, k, sim->clock.dt);
	s->travelled += place_mesh(sim, s);
	add_velocity(s, k);
	return TS_OK;
}

enum ts_status ts_mesh_mover_set_velocity(struct ts_instance *self, struct tsim *sim, const double drift[3],
					  const double spin[3])
{
	const struct ts_mesh_mover *mover = self->state;
	struct ts_mesh_surface *s;
	size_t k;

	TS_TRY(moved_mesh(self, sim, &s));
	k = find_motion(s, mover->serial);
	if (k == s->nmotions)
		return TS_OK;
	ts_scale(1, drift, s->motion[k].drift);
	ts_scale(1, spin, s->motion[k].spin);
	for (k = 0; k < s->nmotions; k++)
		add_velocity(s, k);
	return TS_OK;
}

enum ts_status ts_mesh_surface_set_motion(struct tsim *sim, struct ts_mesh_surface *s,
					  const struct ts_motion *motion)
{
	if (store_home(s) != TS_OK)
		return ts_nomem(&sim->error);
	s->carried = *motion;
	s->travelled += place_mesh(sim, s);
	return TS_OK;
}

const struct ts_instance *ts_mesh_mover_of(const struct tsim *sim, const char *mesh)
{
	const struct ts_instance *inst;

	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &k));)
		if (ts_streq(((const struct ts_mesh_mover *)inst->state)->mesh, mesh))
			return inst;
	return NULL;
}

bool ts_mesh_mover_turns(const struct tsim *sim, const char *mesh)
{
	const struct ts_instance *inst;

	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &k));) {
		const struct ts_mesh_mover *mover = inst->state;

		if (mover->turns && ts_streq(mover->mesh, mesh))
			return true;
	}
	return false;
}

static bool has_mover(const struct ts_instance *by, const struct tsim *sim, int64_t serial)
{
	const struct ts_instance *inst;

	for (size_t k = 0; (inst = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &k));) {
		const struct ts_mesh_mover *mover = inst->state;

		if (mover->serial == serial && ts_streq(mover->mesh, by->id))
			return true;
	}
	return false;
}

static void end_motion(struct ts_mesh_surface *s, size_t k)
{
	for (s->nmotions--; k < s->nmotions; k++) {
		s->motion[k] = s->motion[k + 1];
		s->serial[k] = s->serial[k + 1];
	}
}

void ts_mesh_motions_remove_ended(const struct ts_instance *by, struct tsim *sim)
{
	struct ts_mesh_surface *s = by->state;
	size_t before = s->nmotions;

	for (size_t k = s->nmotions; k-- > 0;)
		if (!has_mover(by, sim, s->serial[k]))
			end_motion(s, k);
	if (s->nmotions == before)
		return;
	reset_home(s);
	for (size_t k = 0; k < s->nmotions; k++)
		add_velocity(s, k);
	if (s->nmotions)
		return;
	ts_free(s->v); /* at rest */
	s->v = NULL;
}

static enum ts_status fail_damaged(struct tsim *sim)
{
	return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible motions of a mesh");
}

static enum ts_status archive_list(struct ts_mesh_surface *s, struct tsim *sim, struct ts_archive *a)
{
	size_t numbers = s->nmotions * TS_MESH_MOTION, count = s->nmotions;
	size_t capacity = s->motion_capacity * TS_MESH_MOTION;
	void *motion = s->motion, *serial = s->serial;
	enum ts_status status;

	status = ts_archive_array(a, "motions", TS_SAVED_F64, &motion, &capacity, &numbers);
	s->motion = motion;
	s->motion_capacity = capacity / TS_MESH_MOTION;
	TS_TRY(status);
	status = ts_archive_array(a, "serials", TS_SAVED_I64, &serial, &s->serial_capacity, &count);
	s->serial = serial;
	TS_TRY(status);
	s->nmotions = count;
	return numbers == count * TS_MESH_MOTION ? TS_OK : fail_damaged(sim);
}

static enum ts_status refuse_given(struct ts_instance *self, struct tsim *sim, const char *word,
				   const char *what)
{
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, word),
		       "fix %s: mesh %s had moved when the restart file was written, and %s; or give it "
		       "another id to start without that state",
		       self->style->name, self->id, what);
}

/* What the script gives is what the script that wrote the file gave: the mesh has moved from there. Older files do not tell. */
static enum ts_status archive_given(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_mesh_surface *s = self->state;
	double anchor[3] = { s->anchor_given[0], s->anchor_given[1], s->anchor_given[2] };
	int64_t given = (int64_t)s->given;

	if (!ts_archive_writing(a) && s->belt)
		return refuse_given(self, sim, "surface_vel",
				    "a mesh that moves has no surface_vel or surface_ang_vel: leave it out");
	if (!ts_archive_writing(a) && !ts_archive_has(a, "given_corners"))
		return TS_OK;
	TS_TRY(ts_archive_fixed(a, "given_corners", TS_SAVED_I64, &given, 1));
	TS_TRY(ts_archive_fixed(a, "given_anchor", TS_SAVED_F64, anchor, 3));
	if (given != (int64_t)s->given)
		return refuse_given(self, sim, "file",
				    "its triangles were others, at its first place: use the same ones");
	if (memcmp(anchor, s->anchor_given, sizeof anchor) != 0)
		return refuse_given(self, sim, "reference_point", "reference_point was another one: use it");
	return TS_OK;
}

enum ts_status ts_mesh_motions_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct ts_mesh_surface *s = self->state;
	bool writing = ts_archive_writing(a), moving;

	if (writing ? !s->home : !ts_archive_has(a, "home"))
		return TS_OK;
	TS_TRY(archive_given(self, sim, a));
	if (!writing && store_home(s) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(ts_archive_fixed(a, "home", TS_SAVED_F64, s->home, 9 * s->mesh.n));
	TS_TRY(ts_archive_fixed(a, "given", TS_SAVED_I64, &s->serials, 1));
	TS_TRY(ts_archive_fixed(a, "travelled", TS_SAVED_F64, &s->travelled, 1));
	TS_TRY(ts_archive_fixed(a, "anchor", TS_SAVED_F64, s->anchor_home, 3));
	TS_TRY(ts_archive_fixed(a, "carried", TS_SAVED_F64, &s->carried, sizeof s->carried / sizeof(double)));
	TS_TRY(archive_list(s, sim, a));
	moving = writing ? s->v != NULL : ts_archive_has(a, "velocity");
	if (moving)
		TS_TRY(ts_archive_fixed(a, "velocity", TS_SAVED_F64, s->v, 9 * s->mesh.n));
	if (writing)
		return TS_OK;
	if (!moving) {
		ts_free(s->v);
		s->v = NULL;
	}
	place_mesh(sim, s);
	return TS_OK;
}
