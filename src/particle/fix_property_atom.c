/* Fix property/atom: user-defined properties of particles. */
#include "core/sim.h"

#include <string.h>

#include "particle/columns.h"
#include "particle/user_columns.h"

#include "base/banned.h"

/* components of a vector, names per fix */
enum { MOST = TS_MOST_USER_COLUMNS };

struct state {
	struct ts_user_columns columns;
	struct ts_words words;
	bool ghost, write_data; /* keywords of LAMMPS */
	bool keep;		/* write to restart files */
	double initial[MOST];	/* values of new particles, in the syntax of LIGGGHTS */
};

static bool is_yes_or_no(const struct ts_word *word)
{
	return ts_streq(word->text, "yes") || ts_streq(word->text, "no");
}

/* LIGGGHTS: NAME scalar|vector|vector_one_entry restart ghost reverse value ... */
static const char *const shapes[] = { "scalar", "vector", "vector_one_entry", NULL };
static bool is_liggghts(const struct state *s)
{
	bool is = s->words.n > 2 && is_yes_or_no(&s->words.word[2]);

	for (int k = 0; shapes[k]; k++)
		is |= s->words.n > 1 && ts_streq(s->words.word[1].text, shapes[k]);
	return is;
}

static enum ts_status read_flag(struct tsim *sim, const struct ts_word *word, bool *out)
{
	*out = ts_streq(word->text, "yes");
	if (*out || ts_streq(word->text, "no"))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "fix property/atom: found '%s', expected yes or no: NAME scalar|vector restart ghost "
		       "reverse value ...",
		       word->text);
}

static enum ts_status add_column(struct ts_instance *self, struct tsim *sim, const struct ts_word *name,
				 const char *column, size_t width)
{
	struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	unsigned flags = TS_COL_NAMED | (s->ghost ? TS_COL_BORDER | TS_COL_FORWARD : 0);
	size_t known = p->ncolumns;

	if (s->columns.n == MOST)
		return ts_fail(&sim->error, TS_RANGE, &name->place, "fix property/atom: at most %d names",
			       MOST);
	TS_TRY(ts_particles_add_column(sim, column, width, flags, &s->columns.column[s->columns.n]));
	if (s->columns.column[s->columns.n] < TS_NCOLUMN_BUILTIN ||
	    (p->ncolumns == known && p->column[s->columns.column[s->columns.n]].width != width))
		return ts_fail(&sim->error, TS_STATE, &name->place,
			       "fix property/atom: '%s' has a meaning already", column);
	s->columns.width += width;
	s->columns.n++;
	return TS_OK;
}

static enum ts_status read_liggghts(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_word *word = s->words.word;
	bool vector = ts_streq(word[1].text, "vector"), reverse, known = false;
	size_t values = s->words.n > 5 ? s->words.n - 5 : 0;

	for (int k = 0; shapes[k]; k++)
		known |= ts_streq(word[1].text, shapes[k]);
	if (!known)
		return ts_fail(&sim->error, TS_SYNTAX, &word[1].place,
			       "fix property/atom: found '%s', expected scalar, vector or vector_one_entry",
			       word[1].text);
	if (!values || values > MOST || (!vector && values != 1))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix property/atom: expected NAME %s restart ghost reverse and %s",
			       word[1].text, vector ? "1 to 64 values" : "one value");
	TS_TRY(read_flag(sim, &word[2], &s->keep));
	TS_TRY(read_flag(sim, &word[3], &s->ghost));
	TS_TRY(read_flag(sim, &word[4], &reverse));
	for (size_t k = 0; k < values; k++)
		if (!ts_streq(word[5 + k].text, "none") && /* none: 0 */
		    !ts_parse_real(word[5 + k].text, &s->initial[k]))
			return ts_fail(&sim->error, TS_SYNTAX, &word[5 + k].place,
				       "fix property/atom: '%s' is not a number", word[5 + k].text);
	TS_TRY(add_column(self, sim, &word[0], word[0].text, values));
	return ts_particles_column_initial(sim, s->columns.column[0], s->initial);
}

/* LAMMPS: mol q rmass temperature heatflow, i_NAME d_NAME, i2_NAME n d2_NAME n */
static enum ts_status read_lammps(struct ts_instance *self, struct tsim *sim)
{
	static const char *const known[] = { "mol", "q", "temperature", "heatflow" };
	struct state *s = self->state;

	s->keep = true;
	for (size_t k = 0; k < s->words.n; k++) {
		const struct ts_word *word = &s->words.word[k];
		const char *name = word->text;
		bool several = strncmp(name, "i2_", 3) == 0 || strncmp(name, "d2_", 3) == 0;
		bool one = strncmp(name, "i_", 2) == 0 || strncmp(name, "d_", 2) == 0;
		int64_t width = 1;

		if (ts_streq(name, "rmass")) /* always present */
			continue;
		for (size_t j = 0; j < sizeof known / sizeof *known; j++)
			one |= ts_streq(name, known[j]);
		if (!several && !one)
			return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
				       "fix property/atom: found '%s', expected mol, q, rmass, i_NAME, "
				       "d_NAME, i2_NAME N or d2_NAME N, or NAME scalar|vector restart ghost "
				       "reverse value ...",
				       name);
		if (several && (k + 1 == s->words.n || !ts_parse_int(s->words.word[++k].text, &width) ||
				width < 1 || width > MOST))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "fix property/atom: %s is followed by the number of its columns",
				       name);
		TS_TRY(add_column(self, sim, word, name, (size_t)width));
	}
	return TS_OK;
}

/* Title of the section in data files, as in LAMMPS. */
static const char *section_title(const struct ts_instance *self)
{
	const struct state *s = self->state;

	if (!s->write_data || is_liggghts(s))
		return NULL;
	if (s->words.n == 1 && ts_streq(s->words.word[0].text, "mol"))
		return "Molecules";
	if (s->words.n == 1 && ts_streq(s->words.word[0].text, "q"))
		return "Charges";
	return self->id;
}

/* Sets the columns of all particles to their initial values. */
static void fill_initial(const struct state *s, struct ts_particles *p)
{
	for (size_t k = 0; k < s->columns.n; k++) {
		struct ts_column *c = &p->column[s->columns.column[k]];

		if (p->n)
			memset(c->data, 0, p->n * c->width * c->element);
		ts_particles_fill_initial(c, 0, p->n);
	}
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->columns.width)
		return TS_OK;
	TS_TRY(is_liggghts(s) ? read_liggghts(self, sim) : read_lammps(self, sim));
	s->columns.title = section_title(self);
	fill_initial(s, sim->particles);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct state *s = self->state;

	for (size_t k = 0; s->keep && k < s->columns.n; k++)
		TS_TRY(ts_particles_archive_column(a, sim, sim->particles->column[s->columns.column[k]].name,
						   s->columns.column[k]));
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_user_columns *columns = &((const struct state *)self->state)->columns;

	TS_TRY(ts_table_resize(out, sim->particles->n, columns->width));
	for (size_t i = 0; i < sim->particles->n; i++)
		ts_user_columns_get(sim->particles, columns, i, out->data + i * columns->width);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_LIST_STATEFUL("names", struct state, words,
			 .help = "NAME scalar|vector|vector_one_entry, yes or no for restart files, for "
				 "ghosts and for reverse (no effect), then the initial values, none for 0; "
				 "or mol, q, rmass, i_NAME, d_NAME, i2_NAME N, d2_NAME N"),
	TS_BOOL("ghost", struct state, ghost, .fallback = "no",
		.help = "periodic images (ghosts) have the values, too"),
	TS_BOOL("writedata", struct state, write_data, .fallback = "yes",
		.help = "in the syntax of LAMMPS: write_data writes a section Molecules (mol alone), Charges "
			"(q alone) or one named by the ID of the fix"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ .name = "property",
	  .unit = "",
	  .help = "the values, one column per component",
	  .shape = TS_PERATOM,
	  .eval = eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_property_atom)
const struct ts_style ts_fix_property_atom = {
	.name = "property/atom",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Adds user-defined properties to particles",
	.doc = "Adds properties to all particles, whatever the group of the fix. In the syntax of LIGGGHTS "
	       "(NAME scalar ...) particles start with the given values, also those inserted later; in the "
	       "syntax of LAMMPS (d_NAME ...) they start with 0. `set ... property/atom NAME value` assigns "
	       "values; f_ID reads them. The names can also be used directly in formulas, computes and "
	       "dumps.\n\n"
	       "The fix may be defined before the simulation box.",
	.example = "fix age all property/atom age scalar yes no no 0.0\n"
		   "set region top property/atom age 2.385\n"
		   "fix marks all property/atom i_mark d2_spot 3",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = archive,
	.values = values,
	.boxless = true,
	.init = init,
};
