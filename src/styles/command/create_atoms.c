/* Command create_atoms: makes particles, on a lattice, at random or one. */
#include "core/sim.h"

#include <math.h>

#include "geom/pointhash.h"
#include "math/rng.h"
#include "particles/domain.h"
#include "particles/lattice.h"
#include "particles/particles.h"
#include "particles/region.h"

#include "base/banned.h"

enum { BOX, REGION, SINGLE, RANDOM };

struct state {
	int64_t type;
	int mode, units;
	struct ts_instance *region;
	double x[3];
	int64_t count, seed, most_tries;
	double distance; /* NaN: none asked for */
};

/* Positions before they become particles. */
struct positions {
	double (*x)[3];
	size_t n, capacity;
};

static enum ts_status add(struct tsim *sim, struct positions *to, const double x[3])
{
	if (TS_GROW(to->x, to->capacity, to->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (int d = 0; d < 3; d++)
		to->x[to->n][d] = x[d];
	to->n++;
	return TS_OK;
}

/* In the box; the upper periodic face is the lower one again. */
static bool in_box(const struct ts_box *box, const double x[3])
{
	for (int d = 0; d < 3; d++) {
		double slack = ts_box_periodic(box, d) ? 1e-12 * ts_box_length(box, d) : 0;

		if (x[d] < box->lo[d] || x[d] > box->hi[d] ||
		    (slack > 0 && x[d] >= box->hi[d] - slack))
			return false;
	}
	return true;
}

/* Box around what can be filled. */
static void limits(const struct tsim *sim, const struct state *s, double lo[3], double hi[3])
{
	const struct ts_box *box = &sim->domain->box;
	double a[3] = { -INFINITY, -INFINITY, -INFINITY }, b[3] = { INFINITY, INFINITY, INFINITY };

	if (s->region)
		ts_region_bounds(s->region, a, b);
	for (int d = 0; d < 3; d++) {
		lo[d] = fmax(box->lo[d], a[d]);
		hi[d] = fmin(box->hi[d], b[d]);
	}
}

static enum ts_status fill_cell(struct tsim *sim, const struct state *s, const struct ts_lattice *l,
				const long cell[3], struct positions *to)
{
	for (int b = 0; b < l->nbasis; b++) {
		double x[3];

		for (int d = 0; d < 3; d++)
			x[d] = ((double)cell[d] + l->basis[b][d]) * l->cell[d] *
			       sim->domain->lattice;
		if (in_box(&sim->domain->box, x) &&
		    (!s->region || ts_region_contains(s->region, x)))
			TS_TRY(add(sim, to, x));
	}
	return TS_OK;
}

static enum ts_status on_lattice(struct tsim *sim, const struct state *s, struct positions *to,
				 const struct ts_place *where)
{
	const struct ts_lattice *l = ts_lattice_get(sim->domain->lattice_style);
	double lo[3], hi[3], cells = 1;
	long first[3], last[3], c[3];

	if (!l)
		return ts_fail(&sim->error, TS_STATE, where,
			       "create_atoms needs lattice points: use the lattice command first");
	limits(sim, s, lo, hi);
	for (int d = 0; d < 3; d++) {
		double edge = l->cell[d] * sim->domain->lattice;
		double a = floor(lo[d] / edge) - 1, b = ceil(hi[d] / edge) + 1;

		if (d >= l->dimension)
			a = b = 0;
		cells *= fmax(0, b - a + 1);
		if (cells > 1e9 || fabs(a) > 1e15 || fabs(b) > 1e15)
			return ts_fail(&sim->error, TS_RANGE, where,
				       "create_atoms: the lattice has more than 1e9 cells here");
		first[d] = (long)a;
		last[d] = (long)b;
	}
	for (c[2] = first[2]; c[2] <= last[2]; c[2]++)
		for (c[1] = first[1]; c[1] <= last[1]; c[1]++)
			for (c[0] = first[0]; c[0] <= last[0]; c[0]++)
				TS_TRY(fill_cell(sim, s, l, c, to));
	return TS_OK;
}

static enum ts_status single(struct tsim *sim, const struct state *s, struct positions *to,
			     const struct ts_place *where)
{
	double scale = s->units == 0 ? sim->domain->lattice : 1, x[3];

	for (int d = 0; d < 3; d++)
		x[d] = scale * s->x[d];
	if (in_box(&sim->domain->box, x))
		return add(sim, to, x);
	ts_warn(&sim->log, where, "(%g %g %g) lies outside the box: no particle is created", x[0],
		x[1], x[2]);
	return TS_OK;
}

static enum ts_status add_existing(struct tsim *sim, struct ts_pointhash *hash)
{
	const struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		if (ts_pointhash_add(hash, p->x[i]) != TS_OK)
			return ts_nomem(&sim->error);
	return TS_OK;
}

/* One position uniform in the region; the k-th particle has a random stream of its own, so what is
 * drawn for it depends on the seed and k only. False: all tries failed. */
static enum ts_status place_one(struct tsim *sim, const struct state *s, struct ts_pointhash *hash,
				struct ts_rng rng, struct positions *to, bool *placed)
{
	const struct ts_box *box = &sim->domain->box;
	double lo[3], hi[3], x[3];

	limits(sim, s, lo, hi);
	*placed = false;
	for (int64_t try = 0; try < s->most_tries; try++) {
		for (int d = 0; d < 3; d++)
			x[d] = lo[d] + (hi[d] - lo[d]) * ts_rng_uniform(&rng);
		if (sim->dimension == 2)
			x[2] = 0;
		if (!in_box(box, x) || (s->region && !ts_region_contains(s->region, x)))
			continue;
		if (hash->cell > 0 && ts_pointhash_near_periodic(hash, box, x, s->distance))
			continue;
		if (hash->cell > 0 && ts_pointhash_add(hash, x) != TS_OK)
			return ts_nomem(&sim->error);
		*placed = true;
		return add(sim, to, x);
	}
	return TS_OK;
}

static enum ts_status at_random(struct tsim *sim, const struct state *s, struct positions *to,
				const struct ts_place *where)
{
	struct ts_pointhash hash = { 0 };
	enum ts_status status = TS_OK;
	int64_t missing = 0;

	if (s->distance > 0) {
		status = ts_pointhash_start(&hash, s->distance) == TS_OK ? add_existing(sim, &hash)
									 : ts_nomem(&sim->error);
	}
	for (int64_t k = 0; k < s->count && status == TS_OK; k++) {
		bool placed = false;

		status = place_one(sim, s, &hash, ts_rng_start((uint64_t)s->seed, (uint64_t)k), to,
				   &placed);
		missing += !placed;
	}
	ts_pointhash_release(&hash);
	if (status == TS_OK && missing)
		ts_warn(&sim->log, where,
			"only %lld of %lld particles could be placed, with %lld tries each",
			(long long)(s->count - missing), (long long)s->count,
			(long long)s->most_tries);
	return status;
}

static enum ts_status make(struct tsim *sim, const struct state *s, const struct positions *from)
{
	struct ts_particles *p = sim->particles;
	double mass = p->type_mass[s->type];
	size_t first;

	TS_TRY(ts_particles_add(sim, from->n, &first));
	for (size_t k = 0; k < from->n; k++) {
		for (int d = 0; d < 3; d++)
			p->x[first + k][d] = from->x[k][d];
		p->type[first + k] = (int32_t)s->type;
		if (mass > 0)
			p->mass[first + k] = mass;
		p->imass[first + k] = 1 / p->mass[first + k];
	}
	ts_log(&sim->log, "Created %zu atoms\n", from->n);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct positions to = { 0 };
	enum ts_status status;

	if (s->type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "create_atoms: there is no type %lld, types go from 1 to %d",
			       (long long)s->type, sim->particles->ntypes);
	if (s->mode == SINGLE)
		status = single(sim, s, &to, where);
	else if (s->mode == RANDOM)
		status = at_random(sim, s, &to, where);
	else
		status = on_lattice(sim, s, &to, where);
	if (status == TS_OK)
		status = make(sim, s, &to);
	ts_free(to.x);
	return status;
}

static const struct ts_arg region_args[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "where lattice points are filled"),
	TS_ARGS_END,
};

static const struct ts_arg single_args[] = {
	TS_VEC3("position", struct state, x, .flags = TS_POSITIONAL, .unit = "length",
		.help = "the center"),
	TS_ARGS_END,
};

static const struct ts_arg random_args[] = {
	TS_INT("count", struct state, count, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 1e9, .help = "number of particles"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL | TS_NULLABLE,
		  .help = "where they are placed; NULL: in the whole box"),
	TS_REAL("overlap", struct state, distance, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "least distance between centers, old and new"),
	TS_INT("maxtry", struct state, most_tries, .fallback = "1000", .range = TS_POSITIVE,
	       .help = "tries for each particle before it is given up"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[BOX] = { "box", "on all lattice points in the box", NULL },
	[REGION] = { "region", "on all lattice points in a region", region_args },
	[SINGLE] = { "single", "one particle", single_args },
	[RANDOM] = { "random", "at random positions", random_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_INT("type", struct state, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "their type"),
	TS_MODE("style", struct state, mode, modes, .help = "where they stand"),
	TS_ENUM("units", struct state, units, ts_region_units, .fallback = "lattice",
		.help = "whether the position of a single one is in lattice spacings or as it is"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_create_atoms)
const struct ts_command_style ts_command_create_atoms = {
	.style = {
		.name = "create_atoms",
		.kind = TS_KIND_COMMAND,
		.summary = "Makes particles",
		.doc = "New particles are at rest, with diameter 1 and density 1 or the mass given by the mass\n"
		       "command; use set to change them. random draws the tries for its k-th particle from a\n"
		       "random stream of its own, keyed by seed and k, and with overlap rejects positions that\n"
		       "are too near to a particle. That fills space up to about a third.",
		.example = "create_atoms 1 box\n"
			   "create_atoms 1 single 0.5 0.5 0.9 units box\n"
			   "create_atoms 1 random 3000 86028157 bed overlap 0.011 maxtry 5000",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
