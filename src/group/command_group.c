/* Command group: assigns particles to groups. */
#include "base/sort.h"
#include "core/sim.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/group.h"
#include "core/ranks_pause.h"
#include "core/uses.h"
#include "group/group_dynamic.h"
#include "neigh/neigh.h"
#include "particle/division.h"
#include "particle/molecule.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum {
	TYPE,
	ID,
	REGION,
	UNION,
	SUBTRACT,
	INTERSECT,
	VARIABLE,
	EMPTY,
	INITIALIZE,
	CLEAR,
	DELETE,
	DYNAMIC,
	STATIC,
	INCLUDE,
	MOLECULE
};

struct state {
	const char *id;
	int mode;
	struct ts_words rest;
	struct ts_instance *region;
	const char *variable;
	int parent, of;
	int64_t every;
};

static void add_member(struct ts_particles *p, size_t i, int bit)
{
	p->mask[i] |= 1u << bit;
}

/* Reads "3", "3:8" or "3:8:2": first, last, step. */
static bool read_range(const char *text, int64_t range[3])
{
	char part[3][24] = { "", "", "1" };
	int n = 0;
	size_t length;

	for (;; text += length + 1) {
		length = strcspn(text, ":");
		if (n == 3 || length >= sizeof part[n])
			return false;
		memcpy(part[n], text, length);
		part[n++][length] = '\0';
		if (!text[length])
			break;
	}
	if (!ts_parse_int(part[0], &range[0]) || !ts_parse_int(part[2], &range[2]))
		return false;
	range[1] = range[0];
	return (n == 1 || ts_parse_int(part[1], &range[1])) && range[2] > 0;
}

static bool compare_number(int op, int64_t value, int64_t a, int64_t b)
{
	switch (op) {
	case 0:
		return value < a;
	case 1:
		return value > a;
	case 2:
		return value <= a;
	case 3:
		return value >= a;
	case 4:
		return value == a;
	case 5:
		return value != a;
	default:
		return value >= a && value <= b;
	}
}

/* Adds particles by type, tag or molecule number: "< 10", "<> 3 8", or a list of numbers and ranges. */
static enum ts_status add_numbers(struct tsim *sim, struct ts_words words, const int32_t *number, int bit)
{
	static const char *const operators[] = { "<", ">", "<=", ">=", "==", "!=", "<>", NULL };
	struct ts_particles *p = sim->particles;
	int64_t r[3] = { 0 };
	int op = 0;

	while (operators[op] && !ts_streq(words.word[0].text, operators[op]))
		op++;
	if (operators[op]) {
		size_t need = op == 6 ? 3 : 2;

		if (words.n != need || !ts_parse_int(words.word[1].text, &r[0]) ||
		    (need == 3 && !ts_parse_int(words.word[2].text, &r[1])))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
				       "group: expected %zu integer%s after '%s'", need - 1,
				       need == 3 ? "s" : "", operators[op]);
		for (size_t i = 0; i < p->n; i++)
			if (compare_number(op, number[i], r[0], r[1]))
				add_member(p, i, bit);
		return TS_OK;
	}
	for (size_t k = 0; k < words.n; k++) {
		if (!read_range(words.word[k].text, r))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[k].place,
				       "group: '%s' is not a number n or a range n:m or n:m:step",
				       words.word[k].text);
		for (size_t i = 0; i < p->n; i++)
			if (number[i] >= r[0] && number[i] <= r[1] && (number[i] - r[0]) % r[2] == 0)
				add_member(p, i, bit);
	}
	return TS_OK;
}

/* Adds the union, the intersection, or the first group without the others. The group itself may be one of
 * them. */
static enum ts_status combine_groups(struct tsim *sim, struct ts_words words, int mode, int bit)
{
	struct ts_particles *p = sim->particles;
	uint32_t first = 0, others = 0;

	for (size_t k = 0; k < words.n; k++) {
		int other;

		TS_TRY(ts_group_require(sim, &words.word[k], &other));
		*(k ? &others : &first) |= 1u << other;
	}
	for (size_t i = 0; i < p->n; i++) {
		uint32_t mask = p->mask[i];
		bool in = mode == UNION	      ? (mask & (first | others)) != 0
			  : mode == INTERSECT ? (mask & (first | others)) == (first | others)
					      : (mask & first) && !(mask & others);

		if (in)
			add_member(p, i, bit);
	}
	return TS_OK;
}

static enum ts_status add_where_variable(struct tsim *sim, const struct state *s, int bit,
					 const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	struct ts_table value = { 0 };
	enum ts_status status = ts_group_variable(sim, s->variable, where, &value);

	for (size_t i = 0; status == TS_OK && i < p->n; i++)
		if (value.data[i] != 0)
			add_member(p, i, bit);
	ts_table_release(&value);
	return status;
}

/* Makes the group dynamic, with members of the parent group. */
static enum ts_status make_dynamic(struct tsim *sim, const struct state *s, int bit,
				   const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;
	struct ts_dynamic_group *g = &p->dynamic[bit];
	struct ts_table value = { 0 };

	if (s->parent == bit || p->dynamic[s->parent].every)
		return ts_fail(&sim->error, TS_STATE, where, "group %s: its parent group %s is %s", s->id,
			       ts_group_name(sim, s->parent), s->parent == bit ? "itself" : "dynamic too");
	if (s->variable) { /* reports errors at this line of the script */
		TS_TRY(ts_group_variable(sim, s->variable, where, &value));
		ts_table_release(&value);
	}
	*g = (struct ts_dynamic_group){ .every = s->every,
					.parent = s->parent,
					.region = s->region ? ts_pool_get(sim->pool, s->region->id) : NULL,
					.variable =
						s->variable ? ts_pool_get(sim->pool, s->variable) : NULL };
	if ((s->region && !g->region) || (s->variable && !g->variable))
		return ts_nomem(&sim->error);
	return ts_group_choose(sim, bit);
}

static void remove_members(struct ts_particles *p, int bit)
{
	for (size_t i = 0; i < p->n; i++)
		p->mask[i] &= ~(1u << bit);
}

static enum ts_status delete_group(struct tsim *sim, const struct state *s, const struct ts_place *where)
{
	const struct ts_word word = { .text = s->id, .place = *where };
	const struct ts_instance *user;
	int bit;

	TS_TRY(ts_group_require(sim, &word, &bit));
	user = ts_uses_group(sim, bit);
	if (user)
		return ts_conflict(&sim->error, where, "group '%s' is in use by %s %s (%s:%d)", s->id,
				   ts_kind_name(user->style->kind), user->id, TS_FILE_AND_LINE(user->where));
	for (int child = 1; child < TS_MAX_GROUPS; child++)
		if (sim->particles->dynamic[child].every && sim->particles->dynamic[child].parent == bit)
			return ts_conflict(&sim->error, where,
					   "group '%s' is the parent of the dynamic group '%s'", s->id,
					   ts_group_name(sim, child));
	if (ts_neigh_uses_group(sim->neigh, bit))
		return ts_conflict(&sim->error, where, "group '%s' is used by neigh_modify", s->id);
	remove_members(sim->particles, bit);
	sim->particles->dynamic[bit].every = 0;
	sim->groups.name[bit] = NULL;
	return TS_OK;
}

static int compare_numbers(const void *a, const void *b)
{
	int32_t i = *(const int32_t *)a, j = *(const int32_t *)b;

	return (i > j) - (i < j);
}

/* Adds all particles of the molecules of members; numbers_of_members: memory for n numbers. */
static void include_molecules(struct ts_particles *p, const int32_t *molecule, int32_t *numbers_of_members,
			      int bit)
{
	size_t n = 0;

	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, bit))
			numbers_of_members[n++] = molecule[i];
	ts_sort(numbers_of_members, n, sizeof *numbers_of_members, compare_numbers);
	for (size_t i = 0; n && i < p->n; i++)
		if (bsearch(&molecule[i], numbers_of_members, n, sizeof *numbers_of_members, compare_numbers))
			add_member(p, i, bit);
}

static enum ts_status add_molecules(struct tsim *sim, const struct state *s, int bit)
{
	struct ts_particles *p = sim->particles;
	const double *from = ts_particles_molecules(p);
	int32_t *molecule = ts_alloc(2 * p->n, sizeof *molecule);
	enum ts_status status = TS_OK;

	if (!molecule)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		molecule[i] = (int32_t)fmax(INT32_MIN, fmin(from[i], INT32_MAX));
	if (s->mode == INCLUDE)
		include_molecules(p, molecule, molecule + p->n, bit);
	else
		status = add_numbers(sim, s->rest, molecule, bit);
	ts_free(molecule);
	return status;
}

static enum ts_status assign_members(struct tsim *sim, const struct state *s, int bit,
				     const struct ts_place *where)
{
	struct ts_particles *p = sim->particles;

	switch (s->mode) {
	case TYPE:
		return add_numbers(sim, s->rest, p->type, bit);
	case ID:
		return add_numbers(sim, s->rest, p->tag, bit);
	case REGION:
		TS_TRY(ts_region_update(s->region, sim));
		for (size_t i = 0; i < p->n; i++)
			if (ts_region_contains(s->region, p->x[i]))
				add_member(p, i, bit);
		return TS_OK;
	case UNION:
	case SUBTRACT:
	case INTERSECT:
		return combine_groups(sim, s->rest, s->mode, bit);
	case MOLECULE:
	case INCLUDE:
		return add_molecules(sim, s, bit);
	case VARIABLE:
		return add_where_variable(sim, s, bit, where);
	case CLEAR:
		remove_members(p, bit);
		return TS_OK;
	case DYNAMIC:
		return make_dynamic(sim, s, bit, where);
	case STATIC:
		p->dynamic[bit].every = 0;
		return TS_OK;
	default:
		return TS_OK;
	}
}

/* Whether the members depend on other particles, or may do so by a formula. */
static bool reads_others(const struct state *s)
{
	return s->mode == MOLECULE || s->mode == INCLUDE || s->mode == VARIABLE || s->mode == DYNAMIC;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_particles *p = sim->particles;
	int64_t count = 0;
	int bit;

	if (ts_streq(s->id, "all"))
		return ts_fail(&sim->error, TS_STATE, where,
			       "group all always has all particles and cannot be changed");
	if (reads_others(s))
		TS_TRY(ts_ranks_unite(sim));
	if (s->mode == DELETE)
		return delete_group(sim, s, where);
	if (s->mode == INCLUDE || s->mode == MOLECULE)
		TS_TRY(ts_particles_need_molecules(sim, "group", where));
	bit = ts_group_find(sim, s->id);
	if (bit >= 0 && p->dynamic[bit].every && s->mode != DYNAMIC && s->mode != STATIC)
		return ts_fail(&sim->error, TS_STATE, where,
			       "group '%s' is dynamic and changes by itself: `group %s static` ends that",
			       s->id, s->id);
	TS_TRY(ts_group_make(sim, s->id, where, &bit));
	TS_TRY(assign_members(sim, s, bit, where));
	for (size_t i = 0; i < p->n; i++)
		count += ts_in_group(p, i, bit);
	ts_log(&sim->log, "%" PRId64 " atoms in group %s\n", ts_division_sum(sim, count), s->id);
	return TS_OK;
}

static const struct ts_arg numbers[] = {
	TS_REST("numbers", struct state, rest,
		.help = "n, ranges n:m or n:m:step, or one of < > <= >= == != n, or <> n m"),
	TS_ARGS_END,
};

static const struct ts_arg groups[] = {
	TS_REST("groups", struct state, rest, .help = "names of groups"),
	TS_ARGS_END,
};

static const struct ts_arg region[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "region in which the centers lie"),
	TS_ARGS_END,
};

static const struct ts_arg variable[] = {
	TS_REF("variable", struct state, variable, .flags = TS_POSITIONAL,
	       .help = "an atom-style variable, NAME or v_NAME: particles for which it is not 0 are added"),
	TS_ARGS_END,
};

static const char *const include_words[] = { "molecule", NULL };
static const struct ts_arg includes[] = {
	TS_ENUM("molecule", struct state, of, include_words, .flags = TS_POSITIONAL,
		.help = "add all particles of the molecules (fix property/atom mol) to which members belong"),
	TS_ARGS_END,
};

static const struct ts_arg dynamic[] = {
	TS_GROUP("parent", struct state, parent, .flags = TS_POSITIONAL,
		 .help = "group whose members can be members; it must not be dynamic"),
	TS_REGION("region", struct state, region, .flags = TS_OPTIONAL,
		  .help = "region in which members are"),
	TS_REF("var", struct state, variable, .flags = TS_OPTIONAL,
	       .help = "an atom-style variable, NAME or v_NAME, that is not 0 for members"),
	TS_INT("every", struct state, every, .fallback = "1", .range = TS_POSITIVE, .unit = "steps",
	       .help = "members are assigned again in steps that are multiples of this number"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[TYPE] = { "type", "particles of these types", numbers },
	[ID] = { "id", "particles with these atom IDs", numbers },
	[REGION] = { "region", "particles in a region at present", region },
	[UNION] = { "union", "members of any of the groups", groups },
	[SUBTRACT] = { "subtract", "members of the first group and of none of the others", groups },
	[INTERSECT] = { "intersect", "members of all of the groups", groups },
	[VARIABLE] = { "variable", "particles for which a variable is not 0", variable },
	[EMPTY] = { "empty", "a group without members, if it does not exist yet", NULL },
	[INITIALIZE] = { "initialize", "the same as empty", NULL },
	[CLEAR] = { "clear", "remove all members", NULL },
	[DELETE] = { "delete", "delete the group", NULL },
	[DYNAMIC] = { "dynamic", "members are assigned again during runs", dynamic },
	[STATIC] = { "static", "a dynamic group becomes static with its present members", NULL },
	[INCLUDE] = { "include", "add particles of the same molecules as members", includes },
	[MOLECULE] = { "molecule", "particles of these molecules (fix property/atom mol)", numbers },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "name of the group"),
	TS_MODE("style", struct state, mode, modes, .help = "which particles are added"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_group)
const struct ts_command_style ts_command_group = {
	.style = {
		.name = "group",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_ROWS,
		.summary = "Assigns particles to a group",
		.doc = "Adds the particles that fulfil the condition at present to those already in the\n"
		       "group. Particles that are created later are not added. There can be 31 groups\n"
		       "besides all.\n\n"
		       "The members of a dynamic group are assigned again when a run starts, unless it\n"
		       "resumes the previous run without changes, and in each step that is a multiple of\n"
		       "every, after positions have been integrated.",
		.example = "group wall type 2\n"
			   "group left id <= 100\n"
			   "group bottom region lower\n"
			   "group free subtract all wall\n"
			   "group fast dynamic free var v_fast every 100",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
