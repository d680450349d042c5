/* Command set: sets properties of particles. */
#include "core/sim.h"

#include <inttypes.h>
#include <math.h>

#include "bond/bonds.h"
#include "core/ranks.h"
#include "core/ranks_pause.h"
#include "particle/assign_words.h"
#include "particle/columns.h"
#include "particle/division.h"
#include "particle/identity.h"
#include "particle/molecule.h"
#include "particle/particles.h"
#include "particle/sphere_shape.h"
#include "region/region.h"

#include "base/banned.h"

enum { ATOM, TYPE, GROUP, REGION, MOLECULE };

/* Keywords with one number; they are applied in the order of the line. */
enum {
	TO_TYPE,
	DIAMETER,
	DENSITY,
	DENSITY_DISC,
	MASS,
	X,
	Y,
	Z,
	VX,
	VY,
	VZ,
	OMEGAX,
	OMEGAY,
	OMEGAZ,
	NPROPERTIES
};
/* Keywords with several words; they are applied after those with one number. */
enum { TYPE_FRACTION, TYPE_RATIO, TYPE_SUBSET, IMAGE, OMEGA, PROPERTY, NAMED, MOLECULES, BOND, NWORDS };

struct state {
	int mode, group;
	struct ts_types range;
	struct ts_instance *region;
	struct ts_number value[NPROPERTIES];
	struct ts_words words[NWORDS];
};

static const char *const names[NPROPERTIES] = { "type", "diameter", "density", "density/disc", "mass",
						"x",	"y",	    "z",       "vx",	       "vy",
						"vz",	"omegax",   "omegay",  "omegaz" };
static const char *const word_names[NWORDS] = { "type/fraction", "type/ratio", "type/subset",
						"image",	 "omega",      "property/atom",
						"named numbers", "mol",	       "bond" };

static bool is_selected(const struct tsim *sim, const struct state *s, size_t i)
{
	const struct ts_particles *p = sim->particles;
	double number = s->mode == ATOM	      ? p->tag[i]
			: s->mode == MOLECULE ? ts_particles_molecules(p)[i]
					      : p->type[i];

	if (s->mode == GROUP)
		return ts_in_group(p, i, s->group);
	if (s->mode == REGION)
		return ts_region_contains(s->region, p->x[i]);
	return number >= s->range.lo && (number <= s->range.hi || s->range.hi == 0);
}

static const char *expected_value(const struct ts_particles *p, int what, double value)
{
	if (!isfinite(value))
		return "a finite number";
	if (what >= DIAMETER && what <= MASS && !(value > 0))
		return "a number > 0";
	if (what == TO_TYPE && !(value >= 1 && value <= p->ntypes && value == floor(value)))
		return "a type, 1 or more and at most what create_box says";
	return NULL;
}

static void set_value(struct tsim *sim, size_t i, int what, double value)
{
	struct ts_particles *p = sim->particles;
	double density = p->mass[i] / ts_particle_volume(sim, p->radius[i]);

	switch (what) {
	case TO_TYPE:
		p->type[i] = (int32_t)value;
		break;
	case DIAMETER: /* at constant density */
		p->radius[i] = 0.5 * value;
		p->mass[i] = density * ts_particle_volume(sim, p->radius[i]);
		break;
	case DENSITY:
	case DENSITY_DISC:
		p->mass[i] = value * ts_particle_volume(sim, p->radius[i]);
		break;
	case MASS:
		p->mass[i] = value;
		break;
	case X:
	case Y:
	case Z:
		p->x[i][what - X] = value;
		break;
	case VX:
	case VY:
	case VZ:
		p->v[i][what - VX] = value;
		break;
	default:
		p->omega[i][what - OMEGAX] = value;
		break;
	}
}

/* The chosen particle of the least identity, of those of all ranks, that cannot have its value; SIZE_MAX: this rank has none
 * such. */
static size_t find_impossible(const struct tsim *sim, const unsigned char *chosen, int what,
			      const struct ts_table *table)
{
	const struct ts_particles *p = sim->particles;
	size_t first = SIZE_MAX;

	for (size_t i = 0; i < p->n; i++)
		if (chosen[i] && expected_value(p, what, table->data[i]) &&
		    (first == SIZE_MAX || p->tag[i] < p->tag[first]))
			first = i;
	if (sim->division) {
		double least = first == SIZE_MAX ? -INFINITY : -(double)p->tag[first];

		return ts_ranks_most(sim, least) == least && first != SIZE_MAX ? first : SIZE_MAX;
	}
	return first;
}

static enum ts_status set_number(struct tsim *sim, const struct state *s, const unsigned char *chosen,
				 int what, const struct ts_place *where, struct ts_table *table)
{
	struct ts_particles *p = sim->particles;
	bool grow = false;
	size_t bad;

	if (what == DENSITY_DISC && sim->dimension != 2)
		return ts_fail(&sim->error, TS_STATE, where,
			       "set: particles are discs only after `dimension 2`; use density");
	TS_TRY(ts_assign_values(sim, &s->value[what], where, table));
	bad = find_impossible(sim, chosen, what, table);
	if (bad != SIZE_MAX)
		return ts_fail(&sim->error, TS_RANGE, where,
			       "set: %s of particle %d would be %g, expected %s", names[what], p->tag[bad],
			       table->data[bad], expected_value(p, what, table->data[bad]));
	if (!sim->division && !s->value[what].variable && expected_value(p, what, s->value[what].value))
		return ts_fail(&sim->error, TS_RANGE, where, "set: %s is %g, expected %s", names[what],
			       s->value[what].value, expected_value(p, what, s->value[what].value));
	for (size_t i = 0; i < p->n; i++) {
		if (!chosen[i])
			continue;
		grow |= what == DIAMETER && 0.5 * table->data[i] > p->radius[i];
		set_value(sim, i, what, table->data[i]);
	}
	if (what == DIAMETER && ts_ranks_most(sim, grow) > 0)
		p->max_run_tag = 0; /* overlaps are no longer those that forces have made */
	return TS_OK;
}

/* The next keyword with one number after word *at of the line, or -1; *at becomes its position. */
static int next_number(const struct state *s, size_t *at)
{
	int next = -1;

	for (int what = 0; what < NPROPERTIES; what++)
		if (!s->value[what].null && s->value[what].at > *at &&
		    (next < 0 || s->value[what].at < s->value[next].at))
			next = what;
	if (next >= 0)
		*at = s->value[next].at;
	return next;
}

/* Sets the type of the bonds of which both particles are chosen. */
static enum ts_status set_bond(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
			       size_t *count)
{
	struct ts_bonds *b = sim->bonds;
	struct ts_identities map;
	int64_t type;

	if (words.n != 1 || !ts_parse_int(words.word[0].text, &type) || type < 1 || type > b->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &words.word[0].place,
			       "set: bond takes a type of bonds from 1 to %d", b->ntypes);
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = *count = 0; k < b->n; k++) {
		int32_t i = ts_identity_row(&map, b->tag[k][0]), j = ts_identity_row(&map, b->tag[k][1]);

		if (i < 0 || j < 0 || !chosen[i] || !chosen[j])
			continue;
		b->type[k] = (int32_t)type;
		++*count;
	}
	return TS_OK;
}

/* Sets the column of `fix property/atom mol`. */
static enum ts_status set_molecule(struct tsim *sim, struct ts_words words, const unsigned char *chosen,
				   size_t *count)
{
	struct ts_word name_and_value[2] = { { .text = "mol", .place = words.word[0].place }, words.word[0] };

	if (words.n != 1)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "set: mol takes one number or v_name");
	return ts_assign_properties(sim, (struct ts_words){ name_and_value, 2 }, chosen, count);
}

static enum ts_status set_words(struct tsim *sim, const struct state *s, const unsigned char *chosen,
				int what, size_t *count)
{
	switch (what) {
	case IMAGE:
		return ts_assign_image(sim, s->words[what], chosen, count);
	case OMEGA:
		return ts_assign_omega(sim, s->words[what], chosen, count);
	case PROPERTY:
	case NAMED:
		return ts_assign_properties(sim, s->words[what], chosen, count);
	case MOLECULES:
		return set_molecule(sim, s->words[what], chosen, count);
	case BOND:
		return set_bond(sim, s->words[what], chosen, count);
	default:
		return ts_assign_type(sim, (enum ts_part)(what - TYPE_FRACTION), s->words[what], chosen,
				      count);
	}
}

static void log_settings(struct tsim *sim, size_t count, const char *what)
{
	ts_log(&sim->log, "  %" PRId64 " settings made for %s\n", ts_division_sum(sim, (int64_t)count), what);
}

static enum ts_status apply_settings(struct tsim *sim, const struct state *s, const unsigned char *chosen,
				     size_t count, const struct ts_place *where)
{
	struct ts_table table = { 0 };
	enum ts_status status = TS_OK;
	size_t at = 0, changed = 0;

	for (int what; status == TS_OK && (what = next_number(s, &at)) >= 0;) {
		status = set_number(sim, s, chosen, what, where, &table);
		if (status == TS_OK)
			log_settings(sim, count, names[what]);
	}
	ts_table_release(&table);
	for (int what = 0; what < NWORDS && status == TS_OK; what++) {
		if (!s->words[what].n)
			continue;
		status = set_words(sim, s, chosen, what, &changed);
		if (status == TS_OK)
			log_settings(sim, changed, word_names[what]);
	}
	return status;
}

/* Whether what a particle gets depends on the others, or is not a number of the particle. */
static bool reads_others(const struct state *s)
{
	for (int what = 0; what < NWORDS; what++)
		if (s->words[what].n && what != IMAGE && what != OMEGA && what != TYPE_FRACTION)
			return true;
	return false;
}

static bool moves(const struct state *s)
{
	return !s->value[X].null || !s->value[Y].null || !s->value[Z].null || s->words[IMAGE].n;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_particles *p = sim->particles;
	unsigned char *chosen;
	enum ts_status status = TS_OK;
	size_t count = 0;

	if (s->mode == TYPE && (s->range.lo > p->ntypes || s->range.hi > p->ntypes))
		return ts_fail(&sim->error, TS_RANGE, where, "set: there are %d types of particles, found %d",
			       p->ntypes, s->range.hi ? s->range.hi : s->range.lo);
	if (reads_others(s) || ts_columns_have_bodies(p)) /* bodies follow their members */
		TS_TRY(ts_ranks_unite(sim));
	if (s->mode == MOLECULE)
		TS_TRY(ts_particles_need_molecules(sim, "set", where));
	TS_TRY(ts_region_update(s->region, sim));
	for (int what = OMEGAX; what <= OMEGAZ; what++)
		if (!s->value[what].null)
			TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA)));
	chosen = ts_alloc(p->n, 1);
	if (!chosen)
		return ts_nomem(&sim->error);
	for (size_t i = 0; i < p->n; i++)
		count += chosen[i] = is_selected(sim, s, i);
	status = apply_settings(sim, s, chosen, count, where);
	ts_free(chosen);
	ts_particles_inverse_mass(p);
	return status == TS_OK && moves(s) ? p->bodies_follow(sim, true, "set", where) : status;
}

static const struct ts_arg by_id[] = {
	TS_TYPES("ids", struct state, range, .flags = TS_POSITIONAL, .help = "atom IDs: n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_arg by_type[] = {
	TS_TYPES("types", struct state, range, .flags = TS_POSITIONAL, .help = "types: n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_arg by_group[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "a group"),
	TS_ARGS_END,
};

static const struct ts_arg by_region[] = {
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL, .help = "a region"),
	TS_ARGS_END,
};

static const struct ts_arg by_molecule[] = {
	TS_TYPES("molecules", struct state, range, .flags = TS_POSITIONAL,
		 .help = "molecules (fix property/atom mol): n, *, n*, *m or n*m"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[ATOM] = { "atom", "particles with these atom IDs", by_id },
	[TYPE] = { "type", "particles of these types", by_type },
	[GROUP] = { "group", "particles of a group", by_group },
	[REGION] = { "region", "particles whose centers lie in a region", by_region },
	[MOLECULE] = { "mol", "particles of these molecules", by_molecule },
	{ .name = NULL },
};

#define VALUE(name, what, unit_, help_) \
	TS_NUMBER(name, struct state, value[what], .flags = TS_OPTIONAL, .unit = unit_, .help = help_)

#define WORDS(name_, what, help_)                                                               \
	{                                                                                       \
		.name = name_, .type = TS_ARG_REST, .flags = TS_OPTIONAL | TS_TO_KEYWORD,       \
		.offset = TS_FIELD(struct state, words[what], struct ts_words *), .help = help_ \
	}

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, mode, modes, .help = "how particles are selected"),
	VALUE("type", TO_TYPE, "", "type"),
	VALUE("diameter", DIAMETER, "length", "diameter; the density is kept"),
	VALUE("density", DENSITY, "mass/volume", "density; the diameter is kept"),
	VALUE("density/disc", DENSITY_DISC, "mass/area",
	      "density of discs, mass / (pi R^2); the diameter is kept; needs dimension 2"),
	VALUE("mass", MASS, "mass", "mass; the diameter is kept"),
	VALUE("x", X, "length", "x of the center"),
	VALUE("y", Y, "length", "y of the center"),
	VALUE("z", Z, "length", "z of the center"),
	VALUE("vx", VX, "velocity", "x component of the velocity"),
	VALUE("vy", VY, "velocity", "y component of the velocity"),
	VALUE("vz", VZ, "velocity", "z component of the velocity"),
	VALUE("omegax", OMEGAX, "1/time", "x component of the angular velocity"),
	VALUE("omegay", OMEGAY, "1/time", "y component of the angular velocity"),
	VALUE("omegaz", OMEGAZ, "1/time", "z component of the angular velocity"),
	WORDS("omega", OMEGA, "angular velocity: three numbers or variables"),
	WORDS("image", IMAGE,
	      "image flags: three integers, or NULL to keep one; 0 if the box is not periodic in the "
	      "dimension"),
	WORDS("type/fraction", TYPE_FRACTION,
	      "type, fraction, seed: the type is set for each particle with this probability"),
	WORDS("type/ratio", TYPE_RATIO,
	      "type, fraction, seed: the type is set for exactly this fraction of the particles"),
	WORDS("type/subset", TYPE_SUBSET, "type, number, seed: the type is set for this number of particles"),
	TS_SOME_KEYWORD("property/atom", struct state, words[PROPERTY], TS_REPEAT,
			.help = "name of a property of a fix, and its numbers or v_NAMEs"),
	TS_SOME_KEYWORD("d_NAME", struct state, words[NAMED], TS_REPEAT | TS_NAMED,
			.help = "number or v_NAME, for the property d_NAME of fix property/atom; also "
				"d_NAME[k]"),
	TS_SOME_KEYWORD("i_NAME", struct state, words[NAMED], TS_REPEAT | TS_NAMED,
			.help = "as d_NAME for i_NAME, an integer"),
	TS_SOME_KEYWORD("d2_NAME", struct state, words[NAMED], TS_REPEAT | TS_NAMED,
			.help = "as d_NAME for one component d2_NAME[k]"),
	TS_SOME_KEYWORD("i2_NAME", struct state, words[NAMED], TS_REPEAT | TS_NAMED,
			.help = "as d_NAME for one component i2_NAME[k], an integer"),
	WORDS("mol", MOLECULES, "molecule number or v_NAME, for fix property/atom mol"),
	WORDS("bond", BOND, "bond type, for bonds between two selected particles"),
	TS_ARGS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "style type diameter density mass x y z vx vy vz" },
	{ "Rotation", "omega omegax omegay omegaz" },
	{ "Types at random", "type/fraction type/ratio type/subset" },
	{ "Properties of fix property/atom", "property/atom d_NAME i_NAME d2_NAME i2_NAME mol" },
	{ "Other", "density/disc image bond" },
	{ .words = NULL },
};

TS_STYLE(command, ts_command_style, ts_command_set)
const struct ts_command_style ts_command_set = {
	.style = {
		.name = "set",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_ROWS,
		.summary = "Sets properties of particles",
		.purpose = "Changes particles that exist: their size, density, velocity, type.",
		.doc = "Sets properties of the selected particles. A number may be v_NAME; an atom-style\n"
		       "variable gives each particle its own value.\n\n"
		       "Keywords with one number are applied from left to right: `diameter 2 mass 1`\n"
		       "results in mass 1; `mass 1 diameter 2` results in the mass of diameter 2 with\n"
		       "the density that mass 1 gave. Keywords that take several words are applied last.\n\n"
		       "Random selections are functions of seed and atom ID. They depend neither on the\n"
		       "number of threads nor on the order of particles.",
		.example = "set group all diameter 0.005 density 2500\n"
			   "set type 2 vz -1\n"
			   "set atom 1*10 diameter v_size\n"
			   "set group bed type/fraction 2 0.3 86028157\n"
			   "set type 1 d_age 2.385 i2_mark[2] 7",
		.args = args,
		.groups = groups,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
