/* Fix pour: inserts particles that fall into a region, as in LAMMPS.
 *
 * The random numbers, and the order in which they are drawn, are those of LAMMPS: the same seed gives the
 * same particles at the same positions. */
#include <math.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "force/gravity.h"
#include "insert/insertion.h"
#include "math/vec3.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "region/region.h"

#include "base/banned.h"

enum { ONE, RANGE, POLY };
enum { MOLECULES = 4 };
static const char *const molecule_words[MOLECULES] = { "mol", "molfrac", "rigid", "shake" };

struct pour {
	struct ts_insertion base;
	int64_t n;
	struct ts_instance *region;
	struct ts_words diameter_words, density_words, fill_words, velocity_words;
	struct ts_words refused[MOLECULES];
	int numbering;
	bool ignore;
	double rate; /* velocity of the region, upwards */

	/* set in init */
	int up;		     /* vertical dimension: 2, in two dimensions 1 */
	double lo[3], hi[3]; /* bounds of the region */
	int spread;	     /* distribution of diameters */
	double diameter[2];  /* the diameter; or the smallest and the largest */
	int64_t nsizes;
	struct ts_words sizes; /* diameter, fraction, diameter, fraction ... */
	double density[2], fraction;
	double sideways[2][2], along; /* velocities: smallest and largest in x and y; vertical at the top */
	int64_t each;		      /* particles per insertion */
	bool told;		      /* the log has the plan */

	double risen; /* saved: displacement of the region */
};

/* ---- arguments ---- */

#define PAIR_ROWS(what, field, unit_)                                                                     \
	TS_REAL("lo", struct pour, field[0], .flags = TS_POSITIONAL, .unit = unit_, .range = TS_POSITIVE, \
		.help = "least " what),                                                                   \
		TS_REAL("hi", struct pour, field[1], .flags = TS_POSITIONAL, .unit = unit_,               \
			.range = TS_POSITIVE, .help = "largest " what)

static const struct ts_arg one_rows[] = {
	TS_REAL("D", struct pour, diameter[0], .flags = TS_POSITIONAL, .unit = "length", .range = TS_POSITIVE,
		.help = "diameter"),
	TS_ARGS_END,
};
static const struct ts_arg range_rows[] = { PAIR_ROWS("diameter", diameter, "length"), TS_ARGS_END };
static const struct ts_arg poly_rows[] = {
	TS_INT("N", struct pour, nsizes, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "total number of particles"),
	TS_REST("sizes", struct pour, sizes, .help = "diameter and fraction of the number, N times"),
	TS_ARGS_END,
};
static const struct ts_mode spreads[] = {
	[ONE] = { "one", "the same for all", one_rows },
	[RANGE] = { "range", "uniform between two diameters", range_rows },
	[POLY] = { "poly", "a set of diameters", poly_rows },
	{ .name = NULL },
};
static const struct ts_arg diameter_rows[] = {
	TS_MODE("spread", struct pour, spread, spreads, .help = "distribution"),
	TS_ARGS_END,
};
static const struct ts_arg density_rows[] = { PAIR_ROWS("density", density, "mass/volume"), TS_ARGS_END };
static const struct ts_arg fill_rows[] = {
	TS_REAL("fraction", struct pour, fraction, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1e-12,
		.hi = 1, .unit = "", .help = "fraction of the volume of the region"),
	TS_INT("attempts", struct pour, base.maxattempt, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "average number of trial positions per particle"),
	TS_ARGS_END,
};
#define SIDEWAYS(name, k, side)                                                                   \
	TS_REAL(name, struct pour, sideways[k][side], .flags = TS_POSITIONAL, .unit = "velocity", \
		.help = "horizontal velocity")
static const struct ts_arg velocity_rows[] = {
	SIDEWAYS("vxlo", 0, 0),
	SIDEWAYS("vxhi", 0, 1),
	SIDEWAYS("vylo", 1, 0),
	SIDEWAYS("vyhi", 1, 1),
	TS_REAL("vz", struct pour, along, .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "vertical velocity at the top"),
	TS_ARGS_END,
};
static const struct ts_arg velocity_rows_2d[] = {
	SIDEWAYS("vxlo", 0, 0),
	SIDEWAYS("vxhi", 0, 1),
	TS_REAL("vy", struct pour, along, .flags = TS_POSITIONAL, .unit = "velocity",
		.help = "vertical velocity at the top"),
	TS_ARGS_END,
};

static enum ts_status parse_keyword(struct ts_instance *self, struct tsim *sim, const char *keyword,
				    const struct ts_arg *rows, struct ts_words words)
{
	char what[32];

	if (!words.n)
		return TS_OK;
	snprintf(what, sizeof what, "fix pour: %s", keyword);
	return ts_args_parse(sim, what, rows, words, &words.word[0].place, &self->arena, self->state);
}

/* Reads the k-th diameter of `poly` and its fraction. */
static bool read_size(const struct pour *s, int64_t k, double *diameter, double *share)
{
	const struct ts_word *word = s->sizes.word + 2 * k;

	return ts_parse_real(word[0].text, diameter) && *diameter > 0 && ts_parse_real(word[1].text, share) &&
	       *share >= 0;
}

static enum ts_status check_sizes(struct ts_instance *self, struct tsim *sim)
{
	const struct pour *s = self->state;
	double diameter, share, sum = 0;

	if (s->spread == RANGE && s->diameter[0] > s->diameter[1])
		return ts_fail(&sim->error, TS_RANGE, &s->diameter_words.word[1].place,
			       "fix pour: diam range goes from %g to %g, expected the smaller first",
			       s->diameter[0], s->diameter[1]);
	if (s->spread != POLY)
		return TS_OK;
	if ((int64_t)s->sizes.n != 2 * s->nsizes)
		return ts_fail(&sim->error, TS_SYNTAX, &s->diameter_words.word[1].place,
			       "fix pour: diam poly %lld is followed by so many diameters, each with its "
			       "share, found %zu words",
			       (long long)s->nsizes, s->sizes.n);
	for (int64_t k = 0; k < s->nsizes; k++) {
		if (!read_size(s, k, &diameter, &share))
			return ts_fail(&sim->error, TS_RANGE, &s->sizes.word[2 * k].place,
				       "fix pour: diam poly: expected a diameter > 0 and a share >= 0, found "
				       "'%s %s'",
				       s->sizes.word[2 * k].text, s->sizes.word[2 * k + 1].text);
		sum += share;
	}
	if (fabs(sum - 1) <= 1e-3)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &s->sizes.word[1].place,
		       "fix pour: the shares of diam poly add up to %g, expected 1", sum);
}

static enum ts_status refuse_molecules(struct ts_instance *self, struct tsim *sim)
{
	const struct pour *s = self->state;

	for (int k = 0; k < MOLECULES; k++)
		if (s->refused[k].n)
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, molecule_words[k]),
				       "fix pour: '%s' is not supported: molecules are clumps here, poured "
				       "by fix insert/stream from fix particletemplate/multisphere",
				       molecule_words[k]);
	return TS_OK;
}

static enum ts_status read_words(struct ts_instance *self, struct tsim *sim)
{
	struct pour *s = self->state;
	bool flat = sim->dimension == 2;

	s->spread = ONE;
	s->diameter[0] = s->density[0] = s->density[1] = 1;
	s->fraction = 0.25;
	s->base.maxattempt = 50;
	TS_TRY(refuse_molecules(self, sim));
	TS_TRY(parse_keyword(self, sim, "diam", diameter_rows, s->diameter_words));
	TS_TRY(parse_keyword(self, sim, "dens", density_rows, s->density_words));
	TS_TRY(parse_keyword(self, sim, "vol", fill_rows, s->fill_words));
	TS_TRY(parse_keyword(self, sim, "vel", flat ? velocity_rows_2d : velocity_rows, s->velocity_words));
	if (s->density[0] > s->density[1])
		return ts_fail(&sim->error, TS_RANGE, &s->density_words.word[0].place,
			       "fix pour: dens goes from %g to %g, expected the smaller first", s->density[0],
			       s->density[1]);
	return check_sizes(self, sim);
}

/* ---- particles ---- */

static double min_diameter(const struct pour *s)
{
	double least = s->diameter[0], one, share;

	for (int64_t k = 0; s->spread == POLY && k < s->nsizes; k++)
		if (read_size(s, k, &one, &share))
			least = k ? fmin(least, one) : one;
	return least;
}

/* Volume per particle by which their number is computed: of `range` the largest, of `poly` the mean. */
static double counted_volume(const struct pour *s, const struct tsim *sim)
{
	double sum = 0, one, share;

	if (s->spread != POLY)
		return ts_particle_volume(sim, 0.5 * s->diameter[s->spread == RANGE]);
	for (int64_t k = 0; k < s->nsizes; k++)
		if (read_size(s, k, &one, &share))
			sum += share * ts_particle_volume(sim, 0.5 * one);
	return sum;
}

static double box_volume(const struct pour *s, int dimensions)
{
	double volume = 1;

	for (int d = 0; d < dimensions; d++)
		volume *= s->hi[d] - s->lo[d];
	return volume;
}

static bool is_block(const struct pour *s)
{
	return ts_region_volume(s->region) == box_volume(s, 3);
}

/* Whether the cross section touches all lateral bounds at the top and the bottom: a block or an upright
 * cylinder. In other shapes heights would be drawn where the region is narrow. */
static bool is_upright(const struct pour *s)
{
	const double *edge[2] = { s->lo, s->hi };

	for (int k = 0; k < 8; k++) {
		int side = k & 1, across = k >> 1 & 1, end = k >> 2;
		double x[3];

		for (int d = 0; d < 3; d++)
			x[d] = 0.5 * (s->lo[d] + s->hi[d]);
		x[across] += (1 - 1e-9) * (edge[side][across] - x[across]);
		x[2] += (1 - 1e-9) * (edge[end][2] - x[2]);
		if (!ts_region_contains(s->region, x))
			return false;
	}
	return true;
}

/* Volume of the region as in LAMMPS: a block thinner than 1 in y, in any units, counts as if it were 1
 * thick. */
static double region_room(const struct pour *s)
{
	double thickness = s->hi[1] - s->lo[1];

	if (s->up == 1)
		return box_volume(s, 2);
	if (is_block(s) && thickness < 1)
		return box_volume(s, 3) / thickness;
	return ts_region_volume(s->region);
}

/* ---- gravity ---- */

/* Finds the acceleration of gravity, which must be along -z, in two dimensions along -y. */
static enum ts_status find_gravity(struct ts_instance *self, struct tsim *sim, double *out)
{
	const struct pour *s = self->state;
	size_t k = 0;
	const struct ts_instance *fix = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_GRAVITY, &k);
	const struct ts_gravity *gravity = fix ? fix->state : NULL;

	if (!fix)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix pour needs fix gravity before it: particles are poured again when those "
			       "before have fallen out of the region");
	if (gravity->magnitude.variable || gravity->turns)
		return ts_fail(&sim->error, TS_STATE, &fix->where,
			       "fix pour needs a constant fix gravity, found %s",
			       gravity->turns ? "variables for its direction" : gravity->magnitude.variable);
	*out = gravity->magnitude.value;
	if (*out > 0 && gravity->direction[s->up] < -1 + 1e-3)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &fix->where, "fix pour needs gravity along -%c", 'x' + s->up);
}

/* Steps that a particle needs to fall from the top to the bottom of the region, which moves with `rate`. */
static int64_t steps_between(const struct pour *s, const struct tsim *sim, double g)
{
	double v = s->along - s->rate, height = s->hi[s->up] - s->lo[s->up];

	return (int64_t)fmin((v + sqrt(v * v + 2 * g * height)) / g / sim->clock.dt + 0.5, 1e15);
}

/* ---- region ---- */

static enum ts_status check_region(struct ts_instance *self, struct tsim *sim)
{
	struct pour *s = self->state;
	const struct ts_region *r = s->region->state;
	const struct ts_box *box = &sim->domain->box;
	const struct ts_place *where = ts_instance_word(self, s->region->id);

	TS_TRY(ts_region_update(s->region, sim));
	if (r->moves || r->side == 1)
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix pour: region %s %s; expected one that stands still, side in",
			       s->region->id, r->moves ? "moves" : "has side out");
	ts_region_bounds(s->region, s->lo, s->hi);
	for (int d = 0; d <= s->up; d++)
		if (!(s->lo[d] >= box->lo[d] && s->hi[d] <= box->hi[d]))
			return ts_fail(&sim->error, TS_RANGE, where,
				       "fix pour: region %s reaches from %c = %g to %g, beyond the box from "
				       "%g to %g",
				       s->region->id, 'x' + d, s->lo[d], s->hi[d], box->lo[d], box->hi[d]);
	if (!(region_room(s) > 0) || !(s->up == 1 ? is_block(s) : is_upright(s)))
		return ts_fail(&sim->error, TS_STATE, where,
			       "fix pour: region %s is of style %s, expected %s", s->region->id,
			       s->region->style->name,
			       s->up == 1 ? "a block" : "a block or a cylinder along z");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct pour *s = self->state;
	bool first = s->base.random.state == 0;
	double g;

	s->up = sim->dimension == 2 ? 1 : 2;
	if (first) {
		TS_TRY(read_words(self, sim));
		TS_TRY(check_region(self, sim));
		s->base.random = ts_minstd_start(s->base.seed);
		for (int k = 0; k < 30; k++) /* LAMMPS skips the first 30 numbers */
			ts_minstd_uniform(&s->base.random);
		s->base.wait = 1;
	}
	TS_TRY(find_gravity(self, sim, &g));
	if (s->base.own.type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &self->words.word[1].place,
			       "fix pour: particle type %lld does not exist, create_box made %d",
			       (long long)s->base.own.type, sim->particles->ntypes);
	s->base.own.least = 0.5 * min_diameter(s);
	s->base.own.lightest = s->density[0] * ts_particle_volume(sim, s->base.own.least);
	s->each = (int64_t)fmin(s->fraction * region_room(s) / counted_volume(s, sim), 1e15);
	if (first)
		s->base.every = steps_between(s, sim, g);
	if (s->each < 1)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix pour: no particle fits, for `vol` asks for %g of the region's volume %g, "
			       "and a particle has %g",
			       s->fraction, region_room(s), counted_volume(s, sim));
	return TS_OK;
}

/* ---- insertion ---- */

static double draw_between(struct ts_minstd *random, const double range[2])
{
	return range[0] + ts_minstd_uniform(random) * (range[1] - range[0]);
}

static double draw_diameter(struct pour *s)
{
	double diameter = s->diameter[0], share, lot;

	if (s->spread == ONE)
		return diameter;
	if (s->spread == RANGE)
		return draw_between(&s->base.random, s->diameter);
	lot = ts_minstd_uniform(&s->base.random);
	for (int64_t k = 0; k < s->nsizes; k++) {
		if (read_size(s, k, &diameter, &share) && lot < share)
			break;
		lot -= share;
	}
	return diameter;
}

/* Draws height and diameter; heights are distributed as in a stream that falls from the top: h = top -
 * u^2 H. */
static void draw_height_and_diameter(struct pour *s, struct ts_new_particle *one)
{
	double u = ts_minstd_uniform(&s->base.random), top = s->hi[s->up];

	*one = (struct ts_new_particle){ .type = (int32_t)s->base.own.type, .placed = true };
	one->x[s->up] = top - u * u * (top - s->lo[s->up]) + s->risen;
	one->radius = 0.5 * draw_diameter(s);
}

/* Draws the horizontal position within the bounds, until it lies in the region. */
static void draw_horizontal_position(struct pour *s, struct ts_new_particle *one)
{
	enum { MOST = 100000 };
	double x[3] = { 0, 0, one->x[2] - s->risen };

	for (int k = 0; k < MOST; k++) {
		for (int d = 0; d < s->up; d++)
			one->x[d] = x[d] =
				s->lo[d] + ts_minstd_uniform(&s->base.random) * (s->hi[d] - s->lo[d]);
		if (s->up == 1 || ts_region_contains(s->region, x))
			break;
	}
}

static void draw_velocity_and_density(struct pour *s, double g, struct ts_new_particle *one)
{
	double fallen = s->hi[s->up] + s->risen - one->x[s->up];

	for (int d = 0; d < s->up; d++)
		one->v[d] = draw_between(&s->base.random, s->sideways[d]);
	one->v[s->up] = -sqrt(s->along * s->along + 2 * g * fallen);
	one->density = draw_between(&s->base.random, s->density);
}

/* Tries each particle until it is placed; the limit of trial positions is common to all. */
static enum ts_status place_particles(struct pour *s, struct tsim *sim, double g,
				      struct ts_spherehash *occupied)
{
	struct ts_new_particles *list = &s->base.list;
	int64_t tries = (int64_t)list->n * s->base.maxattempt;

	for (size_t k = 0; k < list->n && tries > 0; k++) {
		struct ts_new_particle one;

		draw_height_and_diameter(s, &one);
		do
			draw_horizontal_position(s, &one);
		while (ts_insertion_overlaps(sim, occupied, &one) && --tries > 0);
		if (!tries)
			break;
		tries--;
		draw_velocity_and_density(s, g, &one);
		TS_TRY(ts_insertion_hash_add(sim, occupied, &one));
		list->item[k] = one;
	}
	return TS_OK;
}

/* Where particles are placed: the region as it has risen. */
static void find_space(const struct pour *s, double lo[3], double hi[3])
{
	ts_scale(1, s->lo, lo);
	ts_scale(1, s->hi, hi);
	lo[s->up] += s->risen;
	hi[s->up] += s->risen;
	if (s->up == 1)
		lo[2] = hi[2] = 0;
}

static double largest_radius(const struct pour *s)
{
	double most = 0.5 * s->diameter[s->spread == RANGE], one, share;

	for (int64_t k = 0; s->spread == POLY && k < s->nsizes; k++)
		if (read_size(s, k, &one, &share))
			most = fmax(most, 0.5 * one);
	return most;
}

static enum ts_status pour_particles(struct ts_instance *self, struct tsim *sim, double g)
{
	struct pour *s = self->state;
	struct ts_new_particles *list = &s->base.list;
	struct ts_spherehash occupied = { 0 };
	int64_t left = s->n - s->base.inserted;
	double lo[3], hi[3];
	enum ts_status status;

	list->n = 0;
	if (TS_GROW(list->item, list->capacity, (size_t)(left < s->each ? left : s->each)) != TS_OK)
		return ts_nomem(&sim->error);
	list->n = (size_t)(left < s->each ? left : s->each);
	for (size_t k = 0; k < list->n; k++)
		list->item[k] = (struct ts_new_particle){ .placed = false };
	find_space(s, lo, hi);
	status = ts_insertion_hash_near(sim, &occupied, lo, hi, largest_radius(s));
	if (status == TS_OK)
		status = place_particles(s, sim, g, &occupied);
	ts_spherehash_release(&occupied);
	return status;
}

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct pour *s = self->state;
	size_t from;
	double g = 0;

	if (!s->base.due)
		return TS_OK;
	TS_TRY(find_gravity(self, sim, &g));
	TS_TRY(pour_particles(self, sim, g));
	TS_TRY(ts_insertion_make(self, sim, &from));
	s->risen += (double)s->base.every * sim->clock.dt * s->rate;
	ts_insertion_next(self);
	if (s->base.inserted >= s->n)
		s->base.wait = 0;
	return TS_OK;
}

static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	struct pour *s = self->state;
	int64_t events = (s->n - s->base.inserted + s->each - 1) / s->each, now;
	double g;

	if (s->told || events < 1)
		return TS_OK;
	s->told = true;
	TS_TRY(find_gravity(self, sim, &g));
	now = steps_between(s, sim, g);
	if (now != s->base.every && ts_ranks_first(sim))
		ts_warn(&sim->log, &self->where,
			"fix pour %s: particles need %lld steps to leave the region, but with time step and "
			"gravity as they were here it took %lld, and so often they come; define it after "
			"them",
			self->id, (long long)now, (long long)s->base.every);
	if (s->base.every < 1)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix pour: particles would leave the region within a step; it is %g high, the "
			       "time step is %g",
			       s->hi[s->up] - s->lo[s->up], sim->clock.dt);
	ts_log(&sim->log, "Particle insertion: %lld every %lld steps, %lld by step %lld\n",
	       (long long)s->each, (long long)s->base.every, (long long)s->n,
	       (long long)(sim->clock.step + s->base.wait + (events - 1) * s->base.every));
	return TS_OK;
}

static enum ts_status eval_number(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	out->data[0] = (double)((const struct pour *)self->state)->base.inserted;
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "inserted", "", "number of particles inserted so far", TS_SCALAR, 1, NULL, eval_number },
	{ .name = NULL },
};

static const char *const numberings[] = { "max", "next", NULL };
#define REFUSED(name, k)                                  \
	TS_SOME_KEYWORD(name, struct pour, refused[k], 0, \
			.help = "not supported: for clumps see fix insert/stream")

static const struct ts_arg args[] = {
	TS_INT("N", struct pour, n, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "how many particles in all"),
	TS_INT("type", struct pour, base.own.type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "particle type"),
	TS_INT("seed", struct pour, base.seed, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 2147483646, .help = "seed of the random numbers"),
	TS_REGION("region", struct pour, region, .help = "region in which particles are inserted"),
	TS_SOME_KEYWORD("diam", struct pour, diameter_words, 0, .unit = "length",
			.help = "one D | range Dlo Dhi | poly N D1 P1 D2 P2 ...: diameters; for poly each "
				"with its fraction of the number; default one 1.0"),
	TS_SOME_KEYWORD("dens", struct pour, density_words, 0, .unit = "mass/volume",
			.help = "lo hi: densities, uniformly distributed; default 1.0 1.0"),
	TS_SOME_KEYWORD("vol", struct pour, fill_words, 0,
			.help = "fraction attempts: fraction of the region that an insertion fills, and "
				"average number of trial positions per particle; default 0.25 50"),
	TS_REAL("rate", struct pour, rate, .fallback = "0", .unit = "velocity",
		.help = "velocity of the region, upwards"),
	TS_SOME_KEYWORD("vel", struct pour, velocity_words, 0, .unit = "velocity",
			.help = "vxlo vxhi vylo vyhi vz, in two dimensions vxlo vxhi vy: horizontal "
				"velocities, uniformly distributed, and vertical velocity at the top of the "
				"region; default 0"),
	TS_ENUM("id", struct pour, numbering, numberings, .fallback = "max",
		.help = "no effect: a new particle always gets a new atom ID"),
	TS_FLAG("ignore", struct pour, ignore, .help = "no effect: there are no line and triangle particles"),
	REFUSED("mol", 0),
	REFUSED("molfrac", 1),
	REFUSED("rigid", 2),
	REFUSED("shake", 3),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct pour, base.wait),	 TS_SAVE_I64(struct pour, base.every),
	TS_SAVE_I64(struct pour, base.inserted), TS_SAVE_F64(struct pour, base.mass),
	TS_SAVE_F64(struct pour, risen),	 TS_SAVED_ROWS_END,
};

static const char doc[] =
	"From the next step on particles are inserted at random positions in a region, without overlaps, as "
	"in a falling stream: with u uniform in (0, 1), the height is that of the top minus u^2 h, where h "
	"is the height of the region, and the vertical velocity at the depth d is -sqrt(v^2 + 2 g d), where "
	"v is the velocity at the top.\n\n"
	"The next insertion is due when the particles have fallen out of the region, after the time (w + "
	"sqrt(w^2 + 2 g h))/g with w = v - rate, until N particles are inserted. As in LAMMPS, this is "
	"converted to a number of steps when the fix is defined; a warning is given if time step or gravity "
	"change. An insertion has fraction*V/V_1 particles, rounded down, with the volume V of the region "
	"and V_1 of a particle (for `range` of the largest, for `poly` the mean). Particles for which no "
	"position is found are inserted later.\n\n"
	"As in LAMMPS, V of a block less than 1 thick in y is computed as if it were 1 thick, in any units; "
	"the positions are those of LAMMPS, too. Fix gravity must act along -z, in two dimensions along -y. "
	"The region must have side in and must not move, except by `rate`; it is a block, or in three "
	"dimensions a cylinder along z.\n\n"
	"f_ID is the number of particles inserted so far.";

TS_STYLE(fix, ts_style, ts_fix_pour)
const struct ts_style ts_fix_pour = {
	.name = "pour",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_insertion_whole_due,
	.summary = "Pours particles into a region, as in LAMMPS",
	.doc = doc,
	.example = "fix rain all pour 3000 1 300719 region slab vol 0.13 50 diam range 0.004 0.006 dens 2500 "
		   "2500",
	.args = args,
	.family = TS_FAMILY_PROSPECT,
	.state_size = sizeof(struct pour),
	.saved = saved,
	.archive = ts_insertion_archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = ts_insertion_check,
		  [TS_STAGE_PRE_EXCHANGE] = pre_exchange,
		  [TS_STAGE_SETUP] = setup },
	.fini = ts_insertion_fini,
};
