/* Command delete_atoms: deletes particles. */
#include "core/sim.h"

#include <inttypes.h>

#include "box/domain.h"
#include "core/group.h"
#include "core/ranks_pause.h"
#include "geom/pointhash.h"
#include "group/group_dynamic.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/draw.h"
#include "particle/identity.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { GROUP, REGION, OVERLAP, POROSITY, RANDOM, VARIABLE };

struct state {
	int mode, group, other;
	struct ts_instance *region;
	double cutoff;
	struct ts_words porosity;
	int part; /* of mode RANDOM: enum part */
	double amount;
	bool exact, compress, bond, molecule;
	int64_t seed;
	const char *variable;
};
enum part { FRACTION, COUNT };

/* Particles that delete_atoms overlap compares with those of `other` that are kept: of `other` alone, of both groups, of
 * `group` alone. */
enum part_of { OTHER_ALONE, BOTH, GROUP_ALONE };

static enum ts_status mark_overlaps_of(struct tsim *sim, const struct state *s, enum part_of part,
				       const struct ts_identities *map, struct ts_pointhash *hash,
				       unsigned char *flag)
{
	struct ts_particles *p = sim->particles;

	for (size_t k = 0; k < map->n; k++) {
		size_t i = (size_t)map->row[k];
		bool in_group = ts_in_group(p, i, s->group), in_other = ts_in_group(p, i, s->other);

		if (in_group != (part != OTHER_ALONE) || in_other != (part != GROUP_ALONE))
			continue;
		if (in_group)
			flag[i] = ts_pointhash_near_periodic(hash, &sim->domain->box, p->x[i], s->cutoff);
		if (!flag[i] && in_other && ts_pointhash_add(hash, p->x[i]) != TS_OK)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

/* Marks a particle of `group` if the distance to a particle of `other` that is kept is below the cutoff. Particles are
 * processed in the order of their tags, so that the result does not depend on the order in memory; those of `group` alone
 * come last, when it is known which of `other` are kept. */
static enum ts_status mark_overlaps(struct tsim *sim, const struct state *s, struct ts_pointhash *hash,
				    unsigned char *flag)
{
	struct ts_identities map;

	TS_TRY(ts_identities(sim, true, &map));
	for (int part = OTHER_ALONE; part <= GROUP_ALONE; part++)
		TS_TRY(mark_overlaps_of(sim, s, (enum part_of)part, &map, hash, flag));
	return TS_OK;
}

/* [GROUP] REGION FRACTION SEED: each particle is deleted with the probability FRACTION. */
static enum ts_status read_porosity(struct tsim *sim, struct state *s)
{
	struct ts_words w = s->porosity;

	s->group = 0;
	if (w.n == 4)
		TS_TRY(ts_group_require(sim, &w.word[0], &s->group));
	if (w.n == 4)
		w = ts_words_from(w, 1);
	if (w.n != 3)
		return ts_fail(&sim->error, TS_SYNTAX, &s->porosity.word[0].place,
			       "delete_atoms porosity: expected [GROUP] REGION FRACTION SEED");
	s->region = NULL;
	if (!ts_streq(w.word[0].text, "NULL"))
		TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &w.word[0], &s->region));
	if (!ts_parse_real(w.word[1].text, &s->amount) || s->amount < 0 || s->amount > 1)
		return ts_fail(&sim->error, TS_RANGE, &w.word[1].place,
			       "delete_atoms porosity: '%s' is not a fraction from 0 to 1", w.word[1].text);
	if (!ts_parse_int(w.word[2].text, &s->seed) || s->seed < 1)
		return ts_fail(&sim->error, TS_RANGE, &w.word[2].place,
			       "delete_atoms porosity: '%s' is not a seed, an integer > 0", w.word[2].text);
	return TS_OK;
}

/* How many of the n candidates, in random order, are deleted. */
static enum ts_status count_to_delete(struct tsim *sim, const struct state *s, const struct ts_draw *draw,
				      size_t n, const struct ts_place *where, size_t *out)
{
	bool count = s->mode == RANDOM && s->part == COUNT;

	if (count && s->amount > (double)n && s->exact)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "delete_atoms random: %.0f are to go, but there are only %zu", s->amount, n);
	if (count)
		*out = s->amount < (double)n ? (size_t)s->amount : n;
	else if (s->mode == RANDOM && s->exact)
		*out = ts_draw_part(n, s->amount);
	else
		*out = ts_draw_below(draw, n, s->amount);
	return TS_OK;
}

/* flag[] first selects the candidates for ts_draw; those that are kept are then reset. */
static enum ts_status mark_random(struct tsim *sim, const struct state *s, unsigned char *flag,
				  const struct ts_place *where)
{
	const struct ts_particles *p = sim->particles;
	struct ts_draw *draw;
	size_t n, ndeleted = 0;
	enum ts_status status;

	for (size_t i = 0; i < p->n; i++)
		flag[i] =
			ts_in_group(p, i, s->group) && (!s->region || ts_region_contains(s->region, p->x[i]));
	TS_TRY(ts_draw(sim, flag, s->seed, &draw, &n));
	status = count_to_delete(sim, s, draw, n, where, &ndeleted);
	for (size_t k = ndeleted; status == TS_OK && k < n; k++)
		flag[draw[k].row] = 0;
	ts_free(draw);
	return status;
}

static enum ts_status mark_variable(struct tsim *sim, const struct state *s, unsigned char *flag,
				    const struct ts_place *where)
{
	struct ts_table value = { 0 };
	enum ts_status status = ts_group_variable(sim, s->variable, where, &value);

	for (size_t i = 0; status == TS_OK && i < sim->particles->n; i++)
		flag[i] = value.data[i] != 0;
	ts_table_release(&value);
	return status;
}

static enum ts_status mark_deleted(struct tsim *sim, const struct state *s, unsigned char *flag,
				   const struct ts_place *where)
{
	const struct ts_particles *p = sim->particles;
	struct ts_pointhash hash;
	enum ts_status status;

	TS_TRY(ts_region_update(s->region, sim));
	if (s->mode == POROSITY || s->mode == RANDOM)
		return mark_random(sim, s, flag, where);
	if (s->mode == VARIABLE)
		return mark_variable(sim, s, flag, where);
	if (s->mode == OVERLAP) {
		if (ts_pointhash_start(&hash, s->cutoff) != TS_OK)
			return ts_nomem(&sim->error);
		status = mark_overlaps(sim, s, &hash, flag);
		ts_pointhash_release(&hash);
		return status;
	}
	for (size_t i = 0; i < p->n; i++)
		flag[i] = s->mode == GROUP ? ts_in_group(p, i, s->group)
					   : ts_region_contains(s->region, p->x[i]);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct state *s = state;
	struct ts_particles *p = sim->particles;
	int64_t number[2] = { 0 }; /* of particles: deleted, left */
	size_t before;
	unsigned char *flag;
	enum ts_status status;

	if (s->mode != GROUP && s->mode != REGION)
		TS_TRY(ts_ranks_unite(sim));
	TS_TRY(ts_region_update(s->region, sim));
	if (s->mode == POROSITY)
		TS_TRY(read_porosity(sim, s));
	if (s->mode == RANDOM && s->part == FRACTION && s->amount > 1)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "delete_atoms random: %g is not a fraction from 0 to 1", s->amount);
	before = p->n;
	flag = ts_alloc(p->n, 1);
	if (!flag)
		return ts_nomem(&sim->error);
	status = mark_deleted(sim, s, flag, where);
	if (status == TS_OK)
		status = ts_particles_delete(sim, flag);
	ts_free(flag);
	if (status != TS_OK)
		return status;
	number[0] = ts_division_sum(sim, (int64_t)(before - p->n));
	number[1] = ts_division_sum(sim, (int64_t)p->n);
	ts_log(&sim->log, "Deleted %" PRId64 " atoms, new total = %" PRId64 "\n", number[0], number[1]);
	return TS_OK;
}

static const struct ts_arg group_args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "particles that are deleted"),
	TS_ARGS_END,
};

static const struct ts_arg region_args[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "region in which particles are deleted"),
	TS_ARGS_END,
};

static const struct ts_arg overlap_args[] = {
	TS_REAL("cutoff", struct state, cutoff, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "length", .help = "distance between centers below which one particle is deleted"),
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "group of which particles may be deleted"),
	TS_GROUP("other", struct state, other, .flags = TS_POSITIONAL,
		 .help = "group to which the distance is measured"),
	TS_ARGS_END,
};

static const struct ts_arg porosity_args[] = {
	TS_LIST("what", struct state, porosity,
		.help = "[GROUP] REGION FRACTION SEED; the region may be NULL"),
	TS_ARGS_END,
};

static const char *const parts[] = { "fraction", "count", NULL };
static const struct ts_arg random_args[] = {
	TS_ENUM("part", struct state, part, parts, .flags = TS_POSITIONAL,
		.help = "whether amount is a fraction or a number"),
	TS_REAL("amount", struct state, amount, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.help = "fraction of the particles, or number of particles"),
	TS_BOOL("exact", struct state, exact, .flags = TS_POSITIONAL,
		.help = "fraction: yes deletes exactly this fraction, no deletes each particle with this "
			"probability; count: yes is an error if there are fewer particles"),
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "group of which particles may be deleted"),
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL | TS_NULLABLE,
		  .help = "region in which particles may be deleted; NULL: everywhere"),
	TS_INT("seed", struct state, seed, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
	       .help = "seed of the random numbers, which are functions of seed and atom ID"),
	TS_ARGS_END,
};

static const struct ts_arg variable_args[] = {
	TS_REF("variable", struct state, variable, .flags = TS_POSITIONAL,
	       .help = "an atom-style variable, NAME or v_NAME: particles for which it is not 0 are deleted"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[GROUP] = { "group", "all particles of a group", group_args },
	[REGION] = { "region", "all particles whose centers lie in a region", region_args },
	[OVERLAP] = { "overlap", "particles that are too close to others", overlap_args },
	[POROSITY] = { "porosity", "a random fraction of the particles in a region", porosity_args },
	[RANDOM] = { "random", "a random fraction or number of particles", random_args },
	[VARIABLE] = { "variable", "particles selected by a variable", variable_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, mode, modes, .help = "which particles are removed"),
	TS_BOOL("compress", struct state, compress, .fallback = "no",
		.help = "no effect: atom IDs are kept and never reused"),
	TS_BOOL("bond", struct state, bond, .fallback = "yes",
		.help = "no effect: bonds of deleted particles are always deleted"),
	TS_BOOL("mol", struct state, molecule, .fallback = "no",
		.help = "no effect: only the particles selected are deleted, not their molecules"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_delete_atoms)
const struct ts_command_style ts_command_delete_atoms = {
	.style = {
		.name = "delete_atoms",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_ROWS,
		.summary = "Deletes particles",
		.doc = "Deletes the selected particles and their bonds. Particles keep their atom IDs,\n"
		       "and IDs of deleted particles are not used again.\n\n"
		       "overlap processes the particles in the order of their atom IDs. Of two particles\n"
		       "that belong to both groups and are closer than the cutoff, the one with the\n"
		       "smaller ID is kept. Particles of the first group alone are compared with those\n"
		       "of the second group that are left.",
		.example = "delete_atoms group loose\n"
			   "delete_atoms region hole\n"
			   "delete_atoms overlap 0.001 all all\n"
			   "delete_atoms porosity bed 0.25 86028157",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
