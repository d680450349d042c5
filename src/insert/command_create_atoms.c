/* Command create_atoms: creates particles on a lattice, at random positions, or a single one. */
#include "base/axes.h"
#include "core/sim.h"

#include <math.h>
#include <stdio.h>

#include "base/clock.h"
#include "box/domain.h"
#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "geom/pointhash.h"
#include "insert/memory_check.h"
#include "insert/sites.h"
#include "math/rng.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { BOX, REGION, SINGLE, RANDOM, MESH };
enum { STOP_INTERVAL = 1024 }; /* trial positions between checks for a request to stop */

struct state {
	int64_t type;
	int mode, units;
	struct ts_instance *region;
	double x[3];
	int64_t count, seed, most_tries;
	double distance; /* smallest distance of centres; NaN: not given */
	struct ts_words basis, ratio, subset, set, mesh, molecule, rotate;
	const char *variable; /* NULL: none */
	bool remap;
};

/* Parses n words of a keyword, from the k-th on. */
static enum ts_status parse_keyword(struct tsim *sim, const char *what, const struct ts_arg *rows,
				    struct ts_words words, size_t k, size_t n, const struct ts_place *where,
				    struct ts_arena *arena, void *out)
{
	struct ts_words part = ts_words_from(words, k);

	if (part.n > n)
		part.n = n;
	return ts_args_parse(sim, what, rows, part, where, arena, out);
}

/* ---- positions */

static enum ts_status place_single(struct tsim *sim, const struct state *s, struct ts_sites *to,
				   const struct ts_place *where)
{
	const struct ts_box *box = &sim->domain->box;
	double x[3];
	int32_t turns = 0;

	ts_domain_units_said(sim, s->units, where);
	for (int d = 0; d < 3; d++) {
		x[d] = ts_domain_scale(sim, s->units, d) * s->x[d];
		if (s->remap && ts_box_periodic(box, d))
			ts_box_wrap(box, d, &x[d], &turns);
	}
	if (ts_sites_in_box(sim, x))
		return ts_sites_add(sim, to, x, (int)s->type);
	ts_warn(&sim->log, where, "(%g %g %g) lies outside the box: no particle is created", x[0], x[1],
		x[2]);
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

/* Draws positions uniformly in the region until one is accepted. The random stream of the k-th particle
 * depends on seed and k only. *placed is false if all tries failed. */
static enum ts_status place_one_at_random(struct tsim *sim, const struct state *s, struct ts_pointhash *hash,
					  struct ts_rng rng, struct ts_sites *to, bool *placed)
{
	const struct ts_box *box = &sim->domain->box;
	double lo[3], hi[3], x[3];

	ts_sites_limits(sim, s->region, lo, hi);
	*placed = false;
	for (int64_t try = 0; try < s->most_tries && !(sim->requests.stop && try % STOP_INTERVAL == 0);
	     try++) {
		for (int d = 0; d < 3; d++)
			x[d] = lo[d] + (hi[d] - lo[d]) * ts_rng_uniform(&rng);
		if (sim->dimension == 2)
			x[2] = 0;
		if (!ts_sites_in_box(sim, x) || (s->region && !ts_region_contains(s->region, x)))
			continue;
		if (hash->cell > 0 && ts_pointhash_near_periodic(hash, box, x, s->distance))
			continue;
		if (hash->cell > 0 && ts_pointhash_add(hash, x) != TS_OK)
			return ts_nomem(&sim->error);
		*placed = true;
		return ts_sites_add(sim, to, x, (int)s->type);
	}
	return TS_OK;
}

static void print_progress(struct tsim *sim, int64_t done, int64_t placed, int64_t count, double *next)
{
	char text[128];

	if (!sim->log.progress || ts_clock() < *next)
		return;
	*next = ts_clock() + 0.2;
	snprintf(text, sizeof text, "create_atoms: %lld of %lld tried, %lld placed", (long long)done,
		 (long long)count, (long long)placed);
	ts_log_progress(&sim->log, text);
}

static enum ts_status place_at_random(struct tsim *sim, const struct state *s, struct ts_sites *to,
				      const struct ts_place *where)
{
	struct ts_pointhash hash = { 0 };
	enum ts_status status = TS_OK;
	int64_t missing = 0, first;
	size_t end;
	double next = ts_clock() + 1;

	if (s->distance > 0) {
		status = ts_pointhash_start(&hash, s->distance) == TS_OK ? add_existing(sim, &hash)
									 : ts_nomem(&sim->error);
	}
	first = (int64_t)ts_sites_first(to, (size_t)s->count, &end);
	for (int64_t k = first; k < (int64_t)end && status == TS_OK; k++) {
		const int64_t tried = k + 1 - first;
		bool placed = false;

		status = place_one_at_random(sim, s, &hash, ts_rng_start((uint64_t)s->seed, (uint64_t)k), to,
					     &placed);
		missing += !placed;
		print_progress(sim, tried, tried - missing, s->count, &next);
		if (status == TS_OK && sim->requests.stop && tried < s->count)
			status = ts_fail(&sim->error, TS_STOPPED, where,
					 "stopped on request: %lld of %lld particles had been placed, none "
					 "is made",
					 (long long)(tried - missing), (long long)s->count);
	}
	ts_log_progress(&sim->log, "");
	ts_pointhash_release(&hash);
	if (to->parts)
		ts_ranks_sums(sim, &missing, 1);
	if (status == TS_OK && missing)
		ts_warn(&sim->log, where, "only %lld of %lld particles could be placed, with %lld tries each",
			(long long)(s->count - missing), (long long)s->count, (long long)s->most_tries);
	return status;
}

/* ---- on a lattice: types by basis point, subsets of the points, points selected by a formula */

struct basis_type {
	int64_t point, type;
};

static const struct ts_arg basis_rows[] = {
	TS_INT("M", struct basis_type, point, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "basis point of the unit cell, counted from 1"),
	TS_INT("itype", struct basis_type, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "type of the particles at this point"),
	TS_ARGS_END,
};

static enum ts_status read_basis(struct tsim *sim, const struct state *s, const struct ts_place *where,
				 struct ts_arena *arena, int *type)
{
	size_t nbasis = sim->domain->lattice.nbasis;

	for (size_t k = 0; k < nbasis; k++)
		type[k] = (int)s->type;
	for (size_t k = 0; k < s->basis.n; k += 2) {
		struct basis_type b = { 0 };

		TS_TRY(parse_keyword(sim, "create_atoms: basis", basis_rows, s->basis, k, 2, where, arena,
				     &b));
		if (b.point > (int64_t)nbasis || b.type > sim->particles->ntypes)
			return ts_fail(&sim->error, TS_RANGE, &s->basis.word[k].place,
				       "create_atoms: basis %lld %lld: the unit cell has %zu points, and "
				       "types go from 1 to %d",
				       (long long)b.point, (long long)b.type, nbasis, sim->particles->ntypes);
		type[b.point - 1] = (int)b.type;
	}
	return TS_OK;
}

struct subset {
	double ratio;
	int64_t count, seed;
};

static const struct ts_arg ratio_rows[] = {
	TS_REAL("fraction", struct subset, ratio, .flags = TS_POSITIONAL, .range = TS_FRACTION,
		.help = "fraction of the lattice points that are filled"),
	TS_INT("seed", struct subset, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random selection"),
	TS_ARGS_END,
};

static const struct ts_arg subset_rows[] = {
	TS_INT("count", struct subset, count, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "number of lattice points that are filled"),
	TS_INT("seed", struct subset, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random selection"),
	TS_ARGS_END,
};

static enum ts_status select_subset(struct tsim *sim, const struct state *s, struct ts_sites *sites,
				    const struct ts_place *where, struct ts_arena *arena)
{
	struct subset subset = { 0 };

	if (s->ratio.n && s->subset.n)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "create_atoms: ratio and subset exclude each other");
	if (s->ratio.n) {
		TS_TRY(parse_keyword(sim, "create_atoms: ratio", ratio_rows, s->ratio, 0, s->ratio.n, where,
				     arena, &subset));
		subset.count = (int64_t)(subset.ratio * (double)sites->n);
	} else if (s->subset.n) {
		TS_TRY(parse_keyword(sim, "create_atoms: subset", subset_rows, s->subset, 0, s->subset.n,
				     where, arena, &subset));
		if ((size_t)subset.count > sites->n)
			return ts_fail(&sim->error, TS_RANGE, &s->subset.word[0].place,
				       "create_atoms: subset asks for %lld of %zu lattice points",
				       (long long)subset.count, sites->n);
	} else {
		return TS_OK;
	}
	return ts_sites_choose(sim, sites, (size_t)subset.count, (uint64_t)subset.seed);
}

struct coordinate_variable {
	int dim;
	const char *name;
};

static const struct ts_arg setting_rows[] = {
	TS_ENUM("dim", struct coordinate_variable, dim, ts_axis_names, .flags = TS_POSITIONAL,
		.help = "coordinate"),
	TS_WORD("name", struct coordinate_variable, name, .flags = TS_POSITIONAL,
		.help = "internal-style variable that is set to it"),
	TS_ARGS_END,
};

/* Keeps the sites where the variable is not 0. */
static enum ts_status filter_by_variable(struct tsim *sim, const struct state *s, struct ts_sites *sites,
					 const struct ts_place *where, struct ts_arena *arena)
{
	const char *name[3] = { NULL, NULL, NULL };
	size_t kept = 0;

	if (!s->variable && s->set.n)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "create_atoms: set x|y|z is of use together with var only");
	for (size_t k = 0; k < s->set.n; k += 2) {
		struct coordinate_variable one = { 0 };

		TS_TRY(parse_keyword(sim, "create_atoms: set", setting_rows, s->set, k, 2, where, arena,
				     &one));
		name[one.dim] = one.name;
	}
	for (size_t k = 0; k < sites->n && s->variable; k++) {
		double wanted;

		for (int d = 0; d < 3; d++)
			if (name[d])
				TS_TRY(sim->script_api->set(sim->script_api_data, name[d], where,
							    sites->site[k].x[d]));
		TS_TRY(sim->script_api->scalar(sim->script_api_data, s->variable, where, &wanted));
		if (wanted != 0)
			sites->site[kept++] = sites->site[k];
	}
	if (s->variable)
		sites->n = kept;
	return TS_OK;
}

static enum ts_status place_on_lattice(struct tsim *sim, const struct state *s, struct ts_sites *to,
				       const struct ts_place *where)
{
	struct ts_arena arena = { 0 };
	int *type = ts_arena_alloc(&arena, sim->domain->lattice.nbasis + 1, sizeof *type);
	enum ts_status status = type ? TS_OK : ts_nomem(&sim->error);

	if (!sim->domain->lattice.nbasis)
		status = ts_fail(&sim->error, TS_STATE, where,
				 "create_atoms needs lattice points: use the lattice command first");
	if (status == TS_OK)
		status = read_basis(sim, s, where, &arena, type);
	if (status == TS_OK)
		status = ts_sites_on_lattice(sim, s->region, type, where, to);
	if (status == TS_OK)
		status = filter_by_variable(sim, s, to, where, &arena);
	if (status == TS_OK)
		status = select_subset(sim, s, to, where, &arena);
	ts_arena_release(&arena);
	return status;
}

/* ---- particles */

/* Logs large amounts. */
static enum ts_status check_memory(struct tsim *sim, const struct state *s, double n,
				   const struct ts_place *where)
{
	static const double MUCH = 1e9;
	size_t hash = s->mode == RANDOM && s->distance > 0 ? 4 * sizeof(double) + 2 * sizeof(int32_t) : 0;
	double bytes;

	TS_TRY(ts_memory_check(sim, "create_atoms", n, sizeof(struct ts_site) + hash, where, &bytes));
	if (bytes > MUCH)
		ts_log(&sim->log, "create_atoms: %.10g particles take %.3g GB\n", n, bytes / 1e9);
	return TS_OK;
}

/* all: of all ranks, of which this one makes those of `from`. */
static enum ts_status create_particles(struct tsim *sim, const struct ts_sites *from, size_t all)
{
	struct ts_particles *p = sim->particles;
	size_t first;

	TS_TRY(ts_particles_add_some(sim, from->n, all, &first));
	for (size_t k = 0; k < from->n; k++) {
		const struct ts_site *site = &from->site[k];
		double mass = p->type_mass[site->type];

		for (int d = 0; d < 3; d++)
			p->x[first + k][d] = site->x[d];
		p->tag[first + k] = p->max_tag - (int32_t)all + 1 + site->number;
		p->type[first + k] = site->type;
		if (mass > 0)
			p->mass[first + k] = mass;
		p->imass[first + k] = 1 / p->mass[first + k];
	}
	ts_log(&sim->log, "Created %zu atoms\n", all);
	return sim->division ? ts_division_made(sim) : TS_OK;
}

static enum ts_status check_arguments(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	bool lattice = s->mode == BOX || s->mode == REGION;

	if (s->type > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "create_atoms: there is no type %lld, types go from 1 to %d",
			       (long long)s->type, sim->particles->ntypes);
	if (s->mode == MESH)
		return ts_fail(&sim->error, TS_STATE, where, "create_atoms mesh is not supported");
	if (s->molecule.n || s->rotate.n)
		return ts_fail(&sim->error, TS_STATE, where,
			       "create_atoms: molecules are not supported; make particles and bond them with "
			       "create_bonds");
	if (!lattice && (s->basis.n || s->ratio.n || s->subset.n || s->variable || s->set.n))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "create_atoms: basis, ratio, subset, var and set are for box and region");
	return TS_OK;
}

static enum ts_status check_and_place_at_random(struct tsim *sim, const struct state *s, struct ts_sites *to,
						const struct ts_place *where)
{
	TS_TRY(check_memory(sim, s, (double)s->count / (to->parts ? to->parts : 1), where));
	return place_at_random(sim, s, to, where);
}

/* Whether positions depend on those of present particles. */
static bool looks_at_present(const struct state *s)
{
	return s->mode == RANDOM && s->distance > 0;
}

/* Whether each position is found without the others, so that each of several ranks finds a part of them. */
static bool is_each_alone(const struct state *s)
{
	return s->mode == RANDOM ? !(s->distance > 0)
				 : s->mode != SINGLE && !s->variable && !s->ratio.n && !s->subset.n;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_sites to = { 0 };
	enum ts_status status;
	size_t all;

	TS_TRY(check_arguments(sim, s, where));
	if (looks_at_present(s))
		TS_TRY(ts_ranks_unite(sim));
	TS_TRY(ts_region_update(s->region, sim));
	if (is_each_alone(s) && ts_division_can_make(sim)) {
		to.part = sim->world->rank;
		to.parts = sim->world->n;
	}
	if (s->mode == SINGLE)
		status = place_single(sim, s, &to, where);
	else if (s->mode == RANDOM)
		status = check_and_place_at_random(sim, s, &to, where);
	else
		status = place_on_lattice(sim, s, &to, where);
	if (status == TS_OK)
		status = ts_sites_divide(sim, &to, &all);
	if (status == TS_OK && s->mode != RANDOM)
		status = check_memory(sim, s, (double)to.n, where);
	if (status == TS_OK)
		status = create_particles(sim, &to, all);
	ts_sites_release(&to);
	return status;
}

static const struct ts_arg region_args[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "region whose lattice points are filled"),
	TS_ARGS_END,
};

static const struct ts_arg single_args[] = {
	TS_VEC3("position", struct state, x, .flags = TS_POSITIONAL, .unit = "length",
		.help = "position of the center"),
	TS_BOOL("remap", struct state, remap, .fallback = "no",
		.help = "wrap a position outside a periodic box into it"),
	TS_ARGS_END,
};

static const struct ts_arg random_args[] = {
	TS_INT("count", struct state, count, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0, .hi = 1e9,
	       .help = "number of particles"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers"),
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL | TS_NULLABLE,
		  .help = "region of the positions; NULL: the whole box"),
	TS_REAL("overlap", struct state, distance, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "length",
		.help = "smallest distance between centers of new and of present particles"),
	TS_INT("maxtry", struct state, most_tries, .fallback = "1000", .range = TS_POSITIVE,
	       .help = "trial positions per particle"),
	TS_ARGS_END,
};

static const struct ts_arg mesh_args[] = {
	TS_REST("file", struct state, mesh, .help = "not supported"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[BOX] = { "box", "on all lattice points in the box", NULL },
	[REGION] = { "region", "on all lattice points in a region", region_args },
	[SINGLE] = { "single", "one particle", single_args },
	[RANDOM] = { "random", "at random positions", random_args },
	[MESH] = { "mesh", "on a surface: not supported", mesh_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_INT("type", struct state, type, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "particle type"),
	TS_MODE("style", struct state, mode, modes, .help = "where particles are created"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "whether the position of a single particle is in lattice spacings or in units of "
			"length"),
	TS_SOME_KEYWORD("basis", struct state, basis, TS_REPEAT,
			.help = "M itype: particles at basis point M of the unit cell have this type; may be "
				"repeated"),
	TS_SOME_KEYWORD("ratio", struct state, ratio, 0,
			.help = "fraction seed: fill only this fraction of the lattice points, selected at "
				"random"),
	TS_SOME_KEYWORD("subset", struct state, subset, 0,
			.help = "count seed: fill only this number of lattice points, selected at random"),
	TS_WORD("var", struct state, variable, .flags = TS_OPTIONAL,
		.help = "equal-style variable; lattice points where it is 0 are not filled"),
	TS_SOME_KEYWORD("set", struct state, set, TS_REPEAT,
			.help = "x|y|z name: internal-style variable that is set to the coordinate before "
				"var is evaluated; may be repeated"),
	TS_SOME_KEYWORD("mol", struct state, molecule, 0, .help = "not supported"),
	TS_SOME_KEYWORD("rotate", struct state, rotate, 0, .help = "not supported"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_create_atoms)
const struct ts_command_style ts_command_create_atoms = {
	.style = {
		.name = "create_atoms",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_ROWS,
		.summary = "Creates particles",
		.doc = "Creates particles at rest, with diameter 1 and density 1, or the mass given by\n"
		       "the mass command; use `set` to change these. Atom IDs continue from the largest\n"
		       "one in use; on a lattice in the order z, y, x of unit cells, then of the basis\n"
		       "points.\n\n"
		       "Positions lie in the box if lo <= x < hi. Lattice points closer than 2e-6 box\n"
		       "lengths to the upper periodic face are skipped, since they coincide with points\n"
		       "at the lower face.\n\n"
		       "var and set select lattice points by a formula: for example `variable v equal\n"
		       "\"v_xx^2+v_yy^2<4\"` with internal-style variables xx and yy, and `var v set x xx\n"
		       "set y yy`.\n\n"
		       "random draws the trial positions of the k-th particle from a random stream that\n"
		       "depends on seed and k only. With overlap it rejects positions too close to\n"
		       "another particle; this fills about a third of the volume at most.\n\n"
		       "If the particles need more than 1 GB of memory, this is printed before it is\n"
		       "allocated. It is an error if they need more than the machine has or the process\n"
		       "may use.",
		.example = "create_atoms 1 box\n"
			   "create_atoms 1 region bed basis 2 3 ratio 0.5 7919\n"
			   "create_atoms 1 single 0.5 0.5 0.9 units box\n"
			   "create_atoms 1 random 3000 86028157 bed overlap 0.011 maxtry 5000",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
