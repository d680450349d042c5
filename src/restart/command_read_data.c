/* Command read_data: reads box and particles from a data file. */
#include <inttypes.h>
#include <math.h>
#include <sys/stat.h>

#include "bond/bond_reference.h"
#include "bond/bonds.h"
#include "box/domain.h"
#include "core/life.h"
#include "core/ranks.h"
#include "neigh/coincide.h"
#include "particle/division.h"
#include "particle/identity.h"
#include "particle/molecule.h"
#include "particle/user_columns.h"
#include "restart/data.h"

#include "base/banned.h"

enum { NUNUSED = 8 }; /* keywords of LAMMPS that reserve memory: no effect */

struct read_data {
	const char *file, *group;
	struct ts_words add, offset, fix;
	struct ts_data_options options;
	bool nocoeff;
	int64_t unused[NUNUSED];
};

static enum ts_status read_add(struct tsim *sim, struct read_data *c, const struct ts_place *where)
{
	const char *how = c->add.n > 1 ? c->add.word[1].text : "merge";
	struct ts_suggest suggest = ts_suggest_start(how);

	if (!c->add.n && sim->has_box)
		return ts_conflict(&sim->error, where,
				   "there is a simulation box already: use `add append` or `add merge`");
	if (!c->add.n)
		return TS_OK;
	if (c->add.n > 2)
		return ts_fail(&sim->error, TS_SYNTAX, &c->add.word[2].place,
			       "read_data: add takes one word, found '%s' after it", c->add.word[2].text);
	c->options.keep_box = c->add.n == 1;
	if (ts_streq(how, "append")) {
		c->options.add = TS_DATA_APPEND;
		return TS_OK;
	}
	c->options.add = TS_DATA_MERGE;
	if (ts_streq(how, "merge"))
		return TS_OK;
	if (ts_parse_int(how, &c->options.tag_offset) && c->options.tag_offset >= 0)
		return TS_OK;
	ts_suggest_try(&suggest, "append");
	ts_suggest_try(&suggest, "merge");
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "read_data: add is '%s', expected append, merge or a number that is added to the ids "
		       "of the file%s",
		       how, ts_suggest_text(&suggest));
}

/* offset TYPE BOND [ANGLE DIHEDRAL IMPROPER] */
static enum ts_status read_offset(struct tsim *sim, struct read_data *c)
{
	int64_t value;

	for (size_t k = 0; k < c->offset.n; k++) {
		const struct ts_word *word = &c->offset.word[k];

		if (k == 5 || !ts_parse_int(word->text, &value) || value < -10000 || value > 10000)
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "read_data: offset is '%s', expected up to five integers from -10000 "
				       "to 10000",
				       word->text);
		if (k < 2)
			*(k ? &c->options.bond_type_offset : &c->options.type_offset) = value;
	}
	return TS_OK;
}

/* Reads the file, or this rank's part of it. */
static enum ts_status read_file(struct tsim *sim, const struct read_data *c, const struct ts_place *where,
				struct ts_data *data)
{
	const char *style = sim->particles->atom_style;
	struct ts_lines lines = { 0 };
	enum ts_status status;

	TS_TRY(ts_lines_open_along(&lines, &sim->files, &sim->error, sim->pool, where, c->file));
	status = ts_data_read(sim, &lines, style ? style : "sphere", data);
	ts_lines_close(&lines);
	return status;
}

/* Whether each of several ranks can read a part of the file, which can be read again. */
static bool can_read_parts(struct tsim *sim, const struct read_data *c)
{
	struct stat info;

	return !c->add.n && !c->fix.n && ts_division_can_make(sim) && !sim->run.made &&
	       ts_files_stat(&sim->files, c->file, &info) == 0 && S_ISREG(info.st_mode);
}

/* Whether it is an error in the text of the file. */
static bool is_mistake(enum ts_status status)
{
	return status == TS_SYNTAX || status == TS_RANGE || status == TS_DAMAGED || status == TS_UNKNOWN;
}

/* Each of several ranks reads a part. Where that finds an error, all read all of it, and all find the first one. */
static enum ts_status read_parts(struct tsim *sim, const struct read_data *c, const struct ts_place *where,
				 struct ts_data *data)
{
	enum ts_status status;
	bool ok = true;

	data->part = sim->world->rank;
	data->parts = sim->world->n;
	status = read_file(sim, c, where, data);
	if (status == TS_OK && data->parts)
		status = ts_data_join(sim, data, &c->options, &ok);
	if ((status == TS_OK && ok) || (status != TS_OK && !is_mistake(status)))
		return status;
	ts_error_clear(&sim->error);
	ts_data_release(data);
	return read_file(sim, c, where, data);
}

/* Whether the molecule ids of the file say something: one for all bonded particles does not. */
static bool has_molecules(const struct tsim *sim, const struct ts_data *data)
{
	int64_t sum[2] = { data->molecule[1], data->has_molecules }; /* molecule[1] is 0 without */
	int64_t several = data->molecule[0] != data->molecule[1];

	if (data->parts)
		ts_ranks_sums(sim, sum, 2);
	several |= data->has_molecules && data->molecule[1] * sum[1] != sum[0];
	if (data->parts)
		ts_ranks_sums(sim, &several, 1);
	return several || (sum[0] != 0 && data->nbonds == 0);
}

/* As with LAMMPS' atom styles with molecules: particles have a column `mol`. */
static enum ts_status make_molecules(struct tsim *sim, const struct ts_data *data,
				     const struct ts_place *where)
{
	static const char line[] = "fix molecules all property/atom mol writedata no";

	if (!has_molecules(sim, data) || ts_particles_molecules(sim->particles))
		return TS_OK;
	return sim->script_api->execute(sim->script_api_data, line, where);
}

static enum ts_status refuse_repeated(struct tsim *sim, const struct ts_data *data)
{
	const struct ts_bonds *b = sim->bonds;
	const struct ts_place file = { .file = data->file };

	for (size_t k = 1; k < b->n; k++)
		if (b->tag[k][0] == b->tag[k - 1][0] && b->tag[k][1] == b->tag[k - 1][1])
			return ts_fail(&sim->error, TS_DAMAGED, &file,
				       "section Bonds: particles %d and %d are bonded twice", b->tag[k][0],
				       b->tag[k][1]);
	return TS_OK;
}

/* Data files have no bond lengths: the equilibrium length is the current distance. */
static enum ts_status make_bonds(struct tsim *sim, const struct ts_data *data,
				 const struct ts_data_options *o)
{
	struct ts_bonds *b = sim->bonds;
	int64_t ntypes = data->nbond_types + o->bond_type_offset + o->extra_bond_types;
	struct ts_identities map;

	if (ntypes > b->ntypes)
		b->ntypes = (int)ntypes;
	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < data->nbond; k++) {
		const struct ts_data_bond *from = &data->bond[k];
		struct ts_place place = { .file = data->file, .line = from->line };
		int32_t i = (int32_t)(from->tag[0] + o->tag_offset);
		int32_t j = (int32_t)(from->tag[1] + o->tag_offset);
		int64_t type = from->type + o->bond_type_offset;
		double d[3], length;
		size_t row[2];

		if (type < 1)
			return ts_fail(&sim->error, TS_RANGE, &place,
				       "type %d of the bond with its offset is %lld", from->type,
				       (long long)type);
		row[0] = (size_t)ts_identity_row(&map, i);
		row[1] = (size_t)ts_identity_row(&map, j);
		length = ts_bond_separation(sim, row[0], row[1], d);
		TS_TRY(ts_coincide_bond(sim, &place, row[0], row[1], length));
		TS_TRY(ts_bonds_add(sim, i, j, (int)type, length));
	}
	ts_bonds_sort(b);
	TS_TRY(refuse_repeated(sim, data));
	return ts_bond_reference_complete(sim);
}

static enum ts_status apply_data(struct tsim *sim, struct read_data *c, struct ts_data *data)
{
	struct ts_data_options *o = &c->options;

	ts_data_append(sim, o);
	if (!data->parts) /* else it has been checked */
		TS_TRY(ts_data_check(sim, data, o));
	TS_TRY(ts_data_apply(sim, data, o));
	ts_log(&sim->log,
	       "  orthogonal box = (%g %g %g) to (%g %g %g)\n  reading atoms ...\n  %" PRId64 " atoms\n",
	       sim->domain->box.lo[0], sim->domain->box.lo[1], sim->domain->box.lo[2], sim->domain->box.hi[0],
	       sim->domain->box.hi[1], sim->domain->box.hi[2], data->natoms);
	if (data->moving)
		ts_log(&sim->log, "  reading velocities ...\n  %" PRId64 " velocities\n", data->natoms);
	if (data->nbond_types)
		TS_TRY(make_bonds(sim, data, o));
	if (data->nbond)
		ts_log(&sim->log, "  reading bonds ...\n  %zu bonds\n", data->nbond);
	for (size_t k = 0; !c->nocoeff && k < data->ncoeff; k++)
		TS_TRY(ts_sim_command(sim, data->coeff[k].words));
	return TS_OK;
}

/* Registers the sections of the keyword `fix` before the file is read. */
static enum ts_status register_sections(struct tsim *sim, struct read_data *c, struct ts_data *data)
{
	const struct ts_words words = c->fix;

	if (words.n % 3)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "read_data: fix takes the name of a fix, a text of the header or NULL, and "
			       "the title of a section");
	data->section = ts_arena_alloc(&data->arena, words.n / 3 + 1, sizeof *data->section);
	if (!data->section)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < words.n; k += 3) {
		const char *header = words.word[k + 1].text;
		const struct ts_user_columns *columns;

		TS_TRY(ts_user_columns_of(sim, &words.word[k], "read_data", &columns));
		data->section[k / 3] =
			(struct ts_data_section){ .title = words.word[k + 2].text,
						  .header = ts_streq(header, "NULL") ? NULL : header,
						  .width = columns->width };
		data->nsections++;
	}
	return TS_OK;
}

/* Molecules above 0, if they are among the columns, get the offset. */
static void set_columns(struct ts_particles *p, const struct ts_user_columns *columns, size_t row,
			const double *numbers, double molecule_offset)
{
	double *molecule = ts_particles_molecules_to_set(p), before = molecule ? molecule[row] : 0;

	ts_user_columns_set(p, columns, row, numbers);
	if (molecule && molecule[row] > 0 && molecule[row] != before)
		molecule[row] += molecule_offset;
}

/* Assigns the numbers of these sections to the columns of the fixes property/atom. */
static enum ts_status assign_sections(struct tsim *sim, struct read_data *c, const struct ts_data *data)
{
	struct ts_identities map;

	TS_TRY(ts_identities(sim, false, &map));
	for (size_t k = 0; k < data->nsections; k++) {
		const struct ts_data_section *s = &data->section[k];
		const struct ts_user_columns *columns;

		TS_TRY(ts_user_columns_of(sim, &c->fix.word[3 * k], "read_data", &columns));
		for (size_t j = 0; j < s->n; j++) {
			const double *line = s->value + j * (s->width + 1);
			int32_t tag = (int32_t)(line[0] + (double)c->options.tag_offset);

			set_columns(sim->particles, columns, (size_t)ts_identity_row(&map, tag), line + 1,
				    c->options.molecule_offset);
		}
		ts_log(&sim->log, "  reading %s ...\n  %zu lines\n", s->title, s->n);
	}
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct read_data *c = state;
	struct ts_data data = { 0 };
	enum ts_status status;

	TS_TRY(read_add(sim, c, where));
	TS_TRY(read_offset(sim, c));
	if (c->group)
		TS_TRY(ts_group_make(sim, c->group, where, &c->options.group));
	ts_log(&sim->log, "Reading data file ...\n");
	status = register_sections(sim, c, &data);
	if (status == TS_OK)
		status = can_read_parts(sim, c) ? read_parts(sim, c, where, &data)
						: read_file(sim, c, where, &data);
	if (status == TS_OK)
		status = make_molecules(sim, &data, where);
	if (status == TS_OK)
		status = apply_data(sim, c, &data);
	if (status == TS_OK && data.nsections)
		status = assign_sections(sim, c, &data);
	ts_data_release(&data);
	return status;
}

#define UNUSED(name, k)                                                                           \
	TS_INT(name, struct read_data, unused[k], .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE, \
	       .help = "no effect: memory is allocated as needed, and there are only bonds")

static const struct ts_arg args[] = {
	TS_WORD("file", struct read_data, file, .flags = TS_POSITIONAL,
		.help = "name of the file; it may be compressed with gzip"),
	TS_SOME_KEYWORD("add", struct read_data, add, TS_NAMED,
			.help = "add to existing particles: append (ids and molecules follow the largest "
				"existing ones), merge (ids as in the file), a number that is added to the "
				"ids, or nothing: "
				"as merge, and the box does not change"),
	{ .name = "offset",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL | TS_TO_KEYWORD,
	  .offset = TS_FIELD(struct read_data, offset, struct ts_words *),
	  .help = "numbers added to the types of particles and of bonds; three more have no effect" },
	TS_VEC3("shift", struct read_data, options.shift, .fallback = "0 0 0", .unit = "length",
		.help = "added to all positions and to the bounds of the box"),
	TS_WORD("group", struct read_data, group, .flags = TS_OPTIONAL,
		.help = "group to which the particles are added; it is created if necessary"),
	TS_FLAG("nocoeff", struct read_data, nocoeff, .help = "ignore pair and bond coefficients"),
	TS_INT("extra/atom/types", struct read_data, options.extra_types, .fallback = "0", .range = TS_WITHIN,
	       .lo = 0, .hi = 10000, .help = "number of particle types in addition to those of the file"),
	TS_INT("extra/bond/types", struct read_data, options.extra_bond_types, .fallback = "0",
	       .range = TS_WITHIN, .lo = 0, .hi = 10000,
	       .help = "number of bond types in addition to those of the file"),
	UNUSED("extra/angle/types", 0),
	UNUSED("extra/dihedral/types", 1),
	UNUSED("extra/improper/types", 2),
	UNUSED("extra/bond/per/atom", 3),
	UNUSED("extra/angle/per/atom", 4),
	UNUSED("extra/dihedral/per/atom", 5),
	UNUSED("extra/improper/per/atom", 6),
	UNUSED("extra/special/per/atom", 7),
	TS_SOME_KEYWORD("fix", struct read_data, fix, TS_REPEAT,
			.help = "ID of a fix property/atom, NULL or a text that marks header lines to be "
				"ignored, and the title of the section with its numbers; may be repeated"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_read_data)
const struct ts_command_style ts_command_read_data = {
	.style = {
		.name = "read_data",
		.kind = TS_KIND_COMMAND,
		.summary = "Reads a box and particles from a data file",
		.doc = "Reads a data file in the format of LAMMPS and LIGGGHTS: a title line, a header (`N "
		       "atoms`, `N atom types`, `N bonds`, `N bond types`, `LO HI xlo xhi` ...), then "
		       "sections in any order, except that Atoms comes before Velocities and Bonds: Atoms "
		       "(id type diameter density x y z [ix iy iz] for atom_style sphere and granular; a "
		       "comment such as `Atoms # bpm/sphere` selects another style: atomic, bond, "
		       "molecular, bpm/sphere, hybrid), Velocities (id vx vy vz omegax omegay omegaz), "
		       "Bonds (number type id id), Masses (type mass), Pair Coeffs, PairIJ Coeffs and Bond "
		       "Coeffs, whose lines are those of pair_coeff and bond_coeff. If molecule ids differ, "
		       "or there are no bonds, `fix molecules all property/atom mol` is defined to keep "
		       "them, unless there is a column mol already. The mass of a particle is its density "
		       "times 4/3 pi R^3. The equilibrium length of a bond is the current distance of its "
		       "particles. Positions are wrapped into periodic boxes; positions outside a fixed "
		       "face are an error. If the file has an error, nothing is changed.\n\n"
		       "`fix ID NULL TITLE`: the section TITLE holds the numbers of fix property/atom ID; "
		       "each line has a particle id and the numbers in the order of the fix, one line for "
		       "each particle.",
		.example = "read_data bed.data\n"
			   "read_data rock.data.gz add append shift 0 0 0.25 group rock\n"
			   "read_data clumps.data fix marks NULL Molecules",
		.args = args,
		.state_size = sizeof(struct read_data),
	},
	.run = run,
};
