/* Fix insert/jet: particles leave a round nozzle at a given rate and speed. */
#include "core/ranks.h"
#include "core/report.h"
#include "core/sim.h"

#include "box/domain.h"
#include "insert/insertion_rate.h"
#include "insert/nozzle.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

struct jet {
	struct ts_insertion base;
	struct ts_insertion_rate rate;
	double direction[3], diameter, inner_diameter;
	double duration; /* NaN: unlimited */
	struct ts_words speed_words, cone_words;

	/* set by init */
	struct ts_nozzle nozzle;
	struct ts_spread speed;
	double quantum;		       /* mean mass of a particle; 1 with particlerate */
	double per_time;	       /* massrate, or particlerate */
	struct ts_new_particles drawn; /* room for one particle */
	struct ts_spherehash occupied; /* spheres near the nozzle, in an insertion */
	double *flown;		       /* [spheres] of an insertion: time since it left the nozzle */
	size_t spheres, flown_capacity;
	/* saved */
	double owed;	    /* mass, or number, that the rate has delivered and that is not inserted yet */
	double age;	    /* time since the beginning of the jet */
	double span;	    /* time since the last insertion was due */
	double energy;	    /* kinetic energy inserted so far */
	int64_t steps_left; /* until the next insertion */
	bool kept;	    /* a particle for which there was no room is inserted first ... */
	struct ts_new_particle keep; /* ... namely this one */
};

/* ---- arguments */

struct cone {
	int mode;
	double angle; /* degrees */
};

static const struct ts_arg uniform_rows[] = {
	TS_REAL("angle", struct cone, angle, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0, .hi = 90,
		.unit = "degrees", .help = "half-angle of the cone"),
	TS_ARGS_END,
};

static const struct ts_arg gaussian_rows[] = {
	TS_REAL("deviation", struct cone, angle, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
		.hi = 30, .unit = "degrees", .help = "standard deviation"),
	TS_ARGS_END,
};

static const struct ts_arg linear_rows[] = {
	TS_REAL("angle", struct cone, angle, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0, .hi = 89,
		.unit = "degrees", .help = "angle at the rim"),
	TS_ARGS_END,
};

static const struct ts_mode cones[] = {
	[TS_CONE_UNIFORM] = { "uniform", "uniform over the solid angle of the cone", uniform_rows },
	[TS_CONE_GAUSSIAN] = { "gaussian", "normal about the axis", gaussian_rows },
	[TS_CONE_LINEAR] = { "linear", "straight lines from one apex", linear_rows },
	{ .name = NULL },
};

static const struct ts_arg cone_rows[] = {
	TS_MODE("mode", struct cone, mode, cones, .help = "distribution of the directions"),
	TS_ARGS_END,
};

static enum ts_status read_nozzle(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;
	struct cone cone = { 0 };
	double margin = s->base.all_in ? d->largest : 0;

	if (!(ts_norm(s->direction) > 0))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "direction"),
			       "fix insert/jet: direction is 0 0 0, expected a vector along the jet");
	ts_nozzle_orient(&s->nozzle, s->direction);
	s->nozzle.outer = 0.5 * s->diameter;
	s->nozzle.inner = 0.5 * s->inner_diameter;
	if (s->inner_diameter > s->diameter ||
	    (margin > 0 && s->nozzle.outer - margin < (s->nozzle.inner > 0 ? s->nozzle.inner + margin : 0)))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "diameter"),
			       "fix insert/jet: a nozzle of diameter %g and inner diameter %g has no room "
			       "for particles%s of radius %g",
			       s->diameter, s->inner_diameter, margin > 0 ? ", wholly within it," : "",
			       d->largest);
	if (s->cone_words.n)
		TS_TRY(ts_args_parse(sim, "fix insert/jet: cone", cone_rows, s->cone_words,
				     &s->cone_words.word[0].place, &self->arena, &cone));
	s->nozzle.cone = cone.mode;
	s->nozzle.angle = cone.angle * TS_PI / 180;
	if (cone.mode == TS_CONE_LINEAR && cone.angle > 0 && !(s->diameter > 0))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "cone"),
			       "fix insert/jet: a linear cone needs a diameter > 0");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;
	const struct ts_distribution *d;
	bool first;

	if (!s->rate.number_word && !s->rate.mass_word && isfinite(s->duration))
		s->rate.number_word = "INF";
	TS_TRY(ts_insertion_init(self, sim, &first));
	TS_TRY(ts_insertion_rate_init(self, sim, &s->rate));
	if (s->base.every < 1)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "insert_every"),
			       "fix insert/jet: insert_every is '%s', expected a number of steps > 0",
			       s->base.every_word);
	d = s->base.distribution->state;
	s->per_time = isnan(s->rate.massrate) ? s->rate.particlerate : s->rate.massrate;
	s->quantum = isnan(s->rate.massrate) ? 1 : d->mass;
	if (first)
		s->steps_left = s->base.every;
	TS_TRY(ts_template_spread(self, sim, "fix insert/jet: speed", s->speed_words, &s->speed));
	return read_nozzle(self, sim);
}

/* A nozzle outside of faces that particles must not cross is an error of the script. */
static enum ts_status check_place(struct ts_instance *self, struct tsim *sim)
{
	const struct jet *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	const double *x = s->nozzle.centre;

	for (int d = 0; d < 3; d++)
		if ((x[d] < box->lo[d] && box->face[d][0] < TS_FACE_SHRINK) ||
		    (x[d] > box->hi[d] && box->face[d][1] < TS_FACE_SHRINK))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "position"),
				       "fix insert/jet: the nozzle is at %c = %g, outside the box, which "
				       "reaches from %g to %g",
				       'x' + d, x[d], box->lo[d], box->hi[d]);
	return TS_OK;
}

static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;

	TS_TRY(check_place(self, sim));
	ts_insertion_rate_print(self, sim, &s->rate);
	return TS_OK;
}

/* ---- particles of an insertion */

/* Time for which the jet has been closed. */
static double closed_for(const struct jet *s)
{
	return isfinite(s->duration) ? fmax(0, s->age - s->duration) : 0;
}

/* Whether a particle is to be inserted now, after this number and mass. */
static bool is_due(const struct jet *s, int64_t number, double mass, double owed)
{
	const struct ts_distribution *d = s->base.distribution->state;

	if (s->rate.mass_word ? mass + 0.5 * d->mass > s->rate.total_mass
			      : s->rate.total >= 0 && number >= s->rate.total)
		return false;
	return owed >= 0.5 * s->quantum;
}

static bool within_faces(const struct ts_box *box, const double x[3])
{
	for (int d = 0; d < 3; d++)
		if ((box->face[d][0] == TS_FACE_FIXED && x[d] < box->lo[d]) ||
		    (box->face[d][1] == TS_FACE_FIXED && x[d] > box->hi[d]))
			return false;
	return true;
}

/* Searches a place for a particle that left the nozzle `late` before the end of this step; it has kept
 * its velocity since. */
static void place_particle(struct jet *s, struct tsim *sim, double late, struct ts_new_particle *one)
{
	double margin = s->base.all_in ? one->radius : 0;
	double speed = ts_spread_draw(&s->speed, &s->base.random), direction[3];
	int64_t most = s->base.overlapcheck ? s->base.maxattempt : 1;

	ts_nozzle_draw_direction(&s->nozzle, &s->base.random, direction);
	one->placed = false;
	for (int64_t k = 0; k < most && !one->placed; k++) {
		ts_nozzle_draw_point(&s->nozzle, margin, &s->base.random, one->x);
		if (s->nozzle.cone == TS_CONE_LINEAR)
			ts_nozzle_linear_direction(&s->nozzle, one->x, direction);
		ts_scale(speed, direction, one->v);
		ts_axpy(late, one->v, one->x);
		ts_insertion_draw_orientation(&s->base, one);
		one->placed = within_faces(&sim->domain->box, one->x) &&
			      !(s->base.overlapcheck && ts_insertion_overlaps(sim, &s->occupied, one));
	}
	ts_scale(1, s->base.omega, one->omega);
}

static enum ts_status draw_particle(struct ts_instance *self, struct tsim *sim, struct ts_new_particle *one)
{
	struct jet *s = self->state;
	const bool kept = s->kept && ts_distribution_holds(s->base.distribution, &s->keep);

	s->kept = false;
	if (kept) {
		*one = s->keep;
		return TS_OK;
	}
	TS_TRY(ts_distribution_draw(s->base.distribution, sim, self, 1, true, &s->drawn));
	*one = s->drawn.item[0];
	return TS_OK;
}

/* `late`: see place_particle. */
static enum ts_status append_particle(struct jet *s, struct tsim *sim, double late,
				      const struct ts_new_particle *one)
{
	struct ts_new_particles *list = &s->base.list;
	size_t spheres = ts_insertion_spheres(one);

	if (TS_GROW(list->item, list->capacity, list->n + 1) != TS_OK ||
	    TS_GROW(s->flown, s->flown_capacity, s->spheres + spheres) != TS_OK)
		return ts_nomem(&sim->error);
	list->item[list->n++] = *one;
	for (size_t k = 0; k < spheres; k++)
		s->flown[s->spheres++] = late;
	return s->base.overlapcheck ? ts_insertion_hash_add(sim, &s->occupied, one) : TS_OK;
}

static void warn_blocked(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;
	double area = TS_PI * (s->nozzle.outer * s->nozzle.outer - s->nozzle.inner * s->nozzle.inner);

	if (!s->base.warned && ts_ranks_first(sim))
		ts_warn(&sim->log, &self->where,
			"fix insert/jet %s: no place for a particle in step %lld after %lld tries; it is "
			"inserted later. Particles fill %.2g of the volume of the jet at the nozzle: take a "
			"lower rate, a wider nozzle, or overlapcheck no if particles do not interact (said "
			"once)",
			self->id, (long long)sim->clock.step, (long long)s->base.maxattempt,
			s->rate.rate * d->volume / (area * ts_spread_mean(&s->speed, 1)));
	s->base.warned = true;
}

/* Draws and places all particles that are due. The n-th of them left the nozzle when the rate had delivered
 * half a particle more than those before it. */
static enum ts_status place_particles(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;
	double mass = s->base.mass, one_mass;
	struct ts_new_particle one;

	s->base.list.n = s->spheres = 0;
	while (is_due(s, s->base.inserted + (int64_t)s->base.list.n, mass, s->owed)) {
		double late = fmin((s->owed - 0.5 * s->quantum) / s->per_time + closed_for(s), s->span);

		TS_TRY(draw_particle(self, sim, &one));
		place_particle(s, sim, late, &one);
		if (!one.placed) {
			s->keep = one;
			s->kept = true;
			warn_blocked(self, sim);
			return TS_OK;
		}
		TS_TRY(append_particle(s, sim, late, &one));
		one_mass = ts_insertion_mass(sim, &one);
		mass += one_mass;
		s->owed -= isnan(s->rate.massrate) ? 1 : one_mass;
		s->energy += 0.5 * one_mass * ts_dot(one.v, one.v);
	}
	return TS_OK;
}

/* Keeps the times of the particles of this rank, and returns their number. */
static size_t keep_own_times(struct jet *s)
{
	size_t own = 0;

	for (size_t k = 0; k < s->base.spheres; k++)
		if (s->base.sphere[k].row >= 0)
			s->flown[own++] = s->flown[k];
	return own;
}

/* Of several ranks the one tells that has found the wall that comes first and the particle with the least identity there. */
static bool is_first(const struct tsim *sim, const struct ts_missed_wall *wall)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	double order = INFINITY;

	for (size_t k = 0; wall->id && k < fixes->n; k++)
		if (ts_streq(fixes->item[k]->id, wall->id))
			order = (double)k * ((double)INT32_MAX + 1) + sim->particles->tag[wall->i];
	return ts_ranks_most(sim, -order) == -order && wall->id;
}

/* Fails if a particle has met a wall on its way from the nozzle. `from`: index of the first new one. */
static enum ts_status check_way(struct ts_instance *self, struct tsim *sim, size_t from)
{
	struct jet *s = self->state;
	const struct ts_particles *p = sim->particles;
	struct ts_missed_wall wall = { 0 };
	char advice[80] = "take a smaller time step, or move the nozzle away from the wall";
	double steps;

	if (p->find_missed_wall)
		TS_TRY(p->find_missed_wall(sim, from, keep_own_times(s), s->flown, &wall));
	if (!is_first(sim, &wall))
		return TS_OK;
	steps = floor(wall.met / sim->clock.dt);
	if (steps >= 1)
		snprintf(advice, sizeof advice, "take insert_every %.0f or less, or move the nozzle", steps);
	return ts_fail(&sim->error, TS_PHYSICS, &self->where,
		       "fix insert/jet %s: particle %d has left the nozzle %.3g ago and met wall %s on its "
		       "way, at the distance %.3g from the nozzle, before it was inserted beyond it in step "
		       "%lld; %s",
		       self->id, p->tag[wall.i], wall.flown, wall.id, wall.met * ts_norm(p->v[wall.i]),
		       (long long)sim->clock.step, advice);
}

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;
	enum ts_status status = TS_OK;
	size_t from;

	if (!s->base.due)
		return TS_OK;
	if (s->base.overlapcheck)
		status = ts_insertion_hash_near(sim, &s->occupied, s->nozzle.centre, s->nozzle.centre,
						s->nozzle.outer + ts_spread_largest(&s->speed) * s->span +
							3 * d->largest);
	if (status == TS_OK)
		status = place_particles(self, sim);
	ts_spherehash_release(&s->occupied);
	s->base.due = false;
	s->span = 0;
	TS_TRY(status);
	TS_TRY(ts_insertion_make(self, sim, &from));
	return check_way(self, sim, from);
}

/* What the rate delivers in this step. */
static double delivered(const struct jet *s, const struct tsim *sim)
{
	double dt = sim->clock.dt;

	return s->per_time * (isfinite(s->duration) ? fmin(dt, fmax(0, s->duration - s->age)) : dt);
}

/* Whether the step that begins inserts particles, and all ranks do it with all particles. */
static bool inserts_whole(const struct ts_instance *self, const struct tsim *sim)
{
	const struct jet *s = self->state;

	return !ts_insertion_divides(&s->base, sim) && s->base.wait <= 1 && s->steps_left <= 1 &&
	       is_due(s, s->base.inserted, s->base.mass, s->owed + delivered(s, sim));
}

/* Counts what the rate delivers in this step. Only a step that inserts particles rebuilds the contact list.
 */
static enum ts_status check(struct ts_instance *self, struct tsim *sim)
{
	struct jet *s = self->state;
	double dt = sim->clock.dt;

	if (s->base.wait > 0 && --s->base.wait > 0) /* `start` */
		return TS_OK;
	s->owed += delivered(s, sim);
	s->age += dt;
	s->span += dt;
	if (--s->steps_left > 0)
		return TS_OK;
	s->steps_left = s->base.every;
	s->base.due = is_due(s, s->base.inserted, s->base.mass, s->owed);
	sim->run.rebuild |= s->base.due;
	if (!s->base.due)
		s->span = 0;
	return TS_OK;
}

/* ---- outputs */

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct jet *s = self->state;
	const struct ts_distribution *d = s->base.distribution->state;
	double area = TS_PI * (s->nozzle.outer * s->nozzle.outer - s->nozzle.inner * s->nozzle.inner);
	double speed = ts_spread_mean(&s->speed, 1), density = s->rate.rate / (area * speed);
	double radius = cbrt(3 * d->volume / (4 * TS_PI));

	if (report->limits_only)
		return TS_OK;
	TS_TRY(check_place(self, sim));
	ts_report_line(report, "jet", "%s: %.3g particles a step, volume fraction %.2g at the nozzle",
		       self->id, s->rate.rate * sim->clock.dt, density * d->volume);
	ts_report_line(report, "", "mean free path of a particle at rest in it 1/(n pi d^2) = %.3g",
		       1 / (density * TS_PI * 4 * radius * radius));
	if (!ts_sim_only(sim, TS_KIND_FLOW))
		ts_report_left_out(report, "air", 0, 0, "no flow_style: the particles fly without drag");
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct jet *s = self->state;

	(void)sim;
	out->data[0] = (double)s->base.inserted;
	out->data[1] = s->base.mass;
	out->data[2] = s->energy;
	out->data[3] = fmin(s->age, s->duration); /* without a duration it is NaN, and fmin the age */
	return TS_OK;
}

static const char *const names[] = { "number", "mass", "energy", "time", NULL };
static const struct ts_value values[] = {
	{ "inserted", "", "number, mass and kinetic energy of the particles inserted so far, time of the jet",
	  TS_VECTOR, 4, names, eval },
	{ .name = NULL },
};

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct jet *s = self->state;

	TS_TRY(ts_insertion_archive(self, sim, a));
	if (ts_sim_find(sim, TS_KIND_FIX, s->base.distribution_id) != s->base.distribution)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix insert/jet: fix %s has been deleted or defined anew since the last run: "
			       "run first",
			       s->base.distribution_id);
	return ts_distribution_archive_particle(s->base.distribution, sim, a, "kept", &s->keep, &s->kept);
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct jet *)self->state)->drawn.item);
	ts_free(((struct jet *)self->state)->flown);
	ts_insertion_fini(self);
}

static const struct ts_arg args[] = {
	TS_INSERTION_SOURCE_ARGS(struct jet),
	TS_BOOL("all_in", struct jet, base.all_in, .fallback = "no",
		.help = "particles leave completely within the opening, not only their centers"),
	TS_VEC3("position", struct jet, nozzle.centre, .unit = "length",
		.help = "centre of the opening of the nozzle"),
	TS_VEC3("direction", struct jet, direction, .unit = "",
		.help = "direction of the jet, of any length"),
	TS_REAL("diameter", struct jet, diameter, .range = TS_NOT_NEGATIVE, .unit = "length",
		.help = "diameter of the opening; 0: all particles leave from one point"),
	TS_REAL("inner_diameter", struct jet, inner_diameter, .range = TS_NOT_NEGATIVE, .unit = "length",
		.fallback = "0", .help = "inner diameter of an opening that is a ring"),
	TS_LIST_KEYWORD("speed", struct jet, speed_words, .flags = TS_TO_KEYWORD, .unit = "velocity",
			.help = "constant V | uniform LO HI | gaussian MEAN DEVIATION | lognormal MEDIAN "
				"DEVIATION: speed, distributed over particles; normal deviates are truncated "
				"at three deviations"),
	TS_LIST_KEYWORD("cone", struct jet, cone_words, .flags = TS_TO_KEYWORD | TS_OPTIONAL,
			.help = "uniform ANGLE | gaussian DEVIATION | linear ANGLE: directions about the "
				"axis in degrees; default: parallel"),
	TS_INSERTION_MOTION_ARGS(struct jet),
	TS_INSERTION_RATE_ARGS(struct jet),
	TS_REAL("time", struct jet, duration, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "time",
		.help = "time after which the jet ends; with it nparticles and mass may be left out"),
	TS_WORD("insert_every", struct jet, base.every_word, .fallback = "1",
		.help = "steps between insertions; all particles that left since the last one are inserted "
			"where they have flown meanwhile"),
	TS_BOOL("verbose", struct jet, base.verbose, .fallback = "no",
		.help = "print each insertion to the log"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_INSERTION_SAVED(struct jet),
	TS_SAVE_F64(struct jet, owed),
	TS_SAVE_F64(struct jet, age),
	TS_SAVE_F64(struct jet, span),
	TS_SAVE_F64(struct jet, energy),
	TS_SAVE_I64(struct jet, steps_left),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_insert_jet)
const struct ts_style ts_fix_insert_jet = {
	.name = "insert/jet",
	.kind = TS_KIND_FIX,
	.summary = "Inserts a jet of particles from a round nozzle",
	.doc = "Particles leave a nozzle, a disc or a ring at `position` across `direction`, at points that "
	       "are uniformly distributed over the opening. Sizes are drawn from the distribution one by "
	       "one.\n\n"
	       "The rate is exact: a particle leaves when the mass (or number) that the rate has delivered "
	       "exceeds that of the particles before it by half of a mean particle. So the inserted mass "
	       "never differs from massrate times time by more than the largest particle, and particles "
	       "leave evenly spaced in time, many in a step or one in many steps. Each is inserted at the "
	       "end of the step at x + v t, where t is the time since it left the nozzle. With insert_every "
	       "N > 1 t is up to N steps: forces do not act until then, and the distance v N dt from the "
	       "nozzle must be free of walls: the run stops if a particle has met one on its way for more "
	       "than a step, or a wall with `impact exact` at all. (Region walls that move are not looked "
	       "at, meshes that rotate are taken to be at rest.) Since the contact list is only rebuilt when "
	       "particles are inserted, this is cheaper where particles interact.\n\n"
	       "Forces of the step act on a new particle for the second half of the step, as in the other "
	       "fixes insert/..., instead of for t, which is half a step on average.\n\n"
	       "`cone uniform A`: directions are uniformly distributed over the solid angle within A of the "
	       "axis. `cone gaussian S`: the density per solid angle at the angle t from the axis is "
	       "proportional to exp(-(t/S)^2/2), truncated at 3 S. `cone linear A`: tan t = (r/R) tan A at "
	       "the distance r from the axis, R the outer radius; the paths of particles start from one "
	       "apex. Speed and direction are independent; both distributions are those of the particles "
	       "that leave (of the flux).\n\n"
	       "With overlapcheck yes a particle that overlaps another one is moved to another point of the "
	       "opening, at most maxattempt times; if none is free it waits, without loss of mass, and a "
	       "warning is given. With overlapcheck no nothing is searched: for dilute jets whose particles "
	       "do not interact, without pair_style, where it is cheaper.\n\n"
	       "The jet ends after `time`, or when the number of particles nparticles or the mass, to half a "
	       "mean particle, is reached. -explain prints the volume fraction at the nozzle and the mean "
	       "free path; if that is long compared with the scene, no pair_style is needed.",
	.example = "fix dust all particletemplate/sphere 15485863 atom_type 1 density constant 2900 radius "
		   "lognormal 11.024e-6 0.5 volume_limit 1e-18\n"
		   "fix mix all particledistribution/discrete 32452843 1 dust 1.0\n"
		   "fix jet all insert/jet seed 32452867 distributiontemplate mix position 0 0 0.01 "
		   "direction 0 0 -1 diameter 1.5e-3 speed gaussian 105 5 cone gaussian 2 massrate 3.33e-5 "
		   "time 1e-3 overlapcheck no",
	.args = args,
	.ranks = TS_RANKS_STEPS | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = inserts_whole,
	.state_size = sizeof(struct jet),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = check,
		  [TS_STAGE_PRE_EXCHANGE] = pre_exchange,
		  [TS_STAGE_SETUP] = setup },
	.plan = plan,
	.fini = fini,
};
