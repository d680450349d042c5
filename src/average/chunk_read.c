/* Parses the arguments that define chunks. */
#include <math.h>
#include <string.h>

#include "average/chunk.h"
#include "base/axes.h"
#include "box/domain.h"
#include "particle/columns.h"
#include "particle/particles.h"

#include "base/banned.h"

const char *const ts_chunk_discards[] = { "default", "yes", "no", "mixed", NULL };
const char *const ts_chunk_units[] = { "lattice", "box", "reduced", NULL };
const char *const ts_chunk_numbers[] = { "default", "once", "every", NULL };
const char *const ts_chunk_id_words[] = { "every", "once", "nfreq", NULL };

#define AXIS_ROWS(k, suffix)                                                                            \
	TS_ENUM("dim" suffix, struct ts_chunks, axis[k].dim, ts_axis_names, .flags = TS_POSITIONAL,     \
		.help = "axis along which there are bins"),                                             \
		TS_WORD("origin" suffix, struct ts_chunks, axis[k].origin_word, .flags = TS_POSITIONAL, \
			.help = "where a bin starts: lower, center, upper or a coordinate"),            \
		TS_REAL("delta" suffix, struct ts_chunks, axis[k].delta, .flags = TS_POSITIONAL,        \
			.range = TS_POSITIVE, .unit = "length", .help = "width of the bins")
#define CENTRE(k, text) \
	TS_REAL(text, struct ts_chunks, centre[k], .flags = TS_POSITIONAL, .unit = "length", .help = "centre")
#define RADII                                                                                          \
	TS_REAL("rmin", struct ts_chunks, inner, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,     \
		.unit = "length", .help = "inner radius of the first shell"),                          \
		TS_REAL("rmax", struct ts_chunks, outer, .flags = TS_POSITIONAL, .range = TS_POSITIVE, \
			.unit = "length", .help = "outer radius of the last shell"),                   \
		TS_INT("nbin", struct ts_chunks, shells, .flags = TS_POSITIONAL, .range = TS_WITHIN,   \
		       .lo = 1, .hi = 1e6, .help = "number of shells")

static const struct ts_arg one_axis[] = { AXIS_ROWS(0, ""), TS_ARGS_END };
static const struct ts_arg two_axes[] = { AXIS_ROWS(0, "1"), AXIS_ROWS(1, "2"), TS_ARGS_END };
static const struct ts_arg three_axes[] = { AXIS_ROWS(0, "1"), AXIS_ROWS(1, "2"), AXIS_ROWS(2, "3"),
					    TS_ARGS_END };
static const struct ts_arg sphere[] = { CENTRE(0, "x"), CENTRE(1, "y"), CENTRE(2, "z"), RADII, TS_ARGS_END };
static const struct ts_arg cylinder[] = { AXIS_ROWS(0, ""), CENTRE(0, "c1"), CENTRE(1, "c2"), RADII,
					  TS_ARGS_END };

static const struct {
	const char *name;
	enum ts_chunk_style style;
	int axes;
	const struct ts_arg *rows;
} styles[] = {
	{ "bin/1d", TS_CHUNK_BINS, 1, one_axis },	    { "bin/2d", TS_CHUNK_BINS, 2, two_axes },
	{ "bin/3d", TS_CHUNK_BINS, 3, three_axes },	    { "bin/sphere", TS_CHUNK_SPHERE, 0, sphere },
	{ "bin/cylinder", TS_CHUNK_CYLINDER, 1, cylinder }, { "type", TS_CHUNK_TYPE, 0, NULL },
};
enum { NSTYLES = sizeof styles / sizeof *styles };

static enum ts_status refuse_word(struct tsim *sim, const struct ts_instance *self,
				  const struct ts_word *word, const char *why)
{
	return ts_fail(&sim->error, TS_SYNTAX, word ? &word->place : &self->where, "%s %s: %s",
		       ts_kind_name(self->style->kind), self->style->name, why);
}

/* The per-particle number whose integer part is the chunk. */
static const char *value_name(const struct ts_chunks *c)
{
	const char *word = c->words.word[0].text;

	return ts_streq(word, "molecule") ? "mol" : word;
}

static enum ts_status read_value(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	const struct ts_word *word = &c->words.word[0];
	struct ts_suggest suggest = ts_suggest_start(word->text);

	if (ts_streq(word->text, "molecule") ||
	    (strlen(word->text) > 2 && word->text[1] == '_' && strchr("cfv", word->text[0]))) {
		c->style = TS_CHUNK_VALUE;
		return TS_OK;
	}
	for (int k = 0; k < NSTYLES; k++)
		ts_suggest_try(&suggest, styles[k].name);
	ts_suggest_try(&suggest, "molecule");
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
		       "%s %s: unknown style of chunks '%s', expected a bin/..., type, molecule, "
		       "c_ID, f_ID or v_NAME%s",
		       ts_kind_name(self->style->kind), self->style->name, word->text,
		       ts_suggest_text(&suggest));
}

static enum ts_status read_style(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	struct ts_words rest = ts_words_from(c->words, 1);
	char what[96];

	for (int k = 0; k < NSTYLES; k++) {
		if (!ts_streq(c->words.word[0].text, styles[k].name))
			continue;
		c->style = styles[k].style;
		c->naxes = styles[k].axes;
		snprintf(what, sizeof what, "%s %s %s", ts_kind_name(self->style->kind), self->style->name,
			 styles[k].name);
		return ts_args_parse(sim, what, styles[k].rows, rest, &c->words.word[0].place, &self->arena,
				     c);
	}
	TS_TRY(read_value(self, sim, c));
	return rest.n ? refuse_word(sim, self, &rest.word[0], "the line should end or go on with a keyword")
		      : TS_OK;
}

/* Converts a length from the units of the keyword `units`. */
static double length_from_units(const struct tsim *sim, const struct ts_chunks *c, double given, int dim)
{
	if (c->units == TS_LENGTHS_REDUCED)
		return given * ts_box_length(&sim->domain->box, dim);
	return given * ts_domain_scale(sim, c->units == TS_LENGTHS_BOX, dim);
}

/* Converts a coordinate; reduced ones start at the lower face of the box. */
static double coordinate_from_units(const struct tsim *sim, const struct ts_chunks *c, double given, int dim)
{
	double at = length_from_units(sim, c, given, dim);

	return c->units == TS_LENGTHS_REDUCED ? sim->domain->box.lo[dim] + at : at;
}

static enum ts_status read_origin(struct ts_instance *self, struct tsim *sim, struct ts_chunk_axis *a)
{
	static const char *const words[] = { "lower", "center", "upper" };

	a->origin = TS_ORIGIN_VALUE;
	for (int k = 0; k < 3; k++)
		if (ts_streq(a->origin_word, words[k]))
			a->origin = (enum ts_chunk_origin)k;
	if (a->origin == TS_ORIGIN_VALUE && !ts_parse_real(a->origin_word, &a->at))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "%s %s: origin '%s' is not lower, center, upper or a coordinate",
			       ts_kind_name(self->style->kind), self->style->name, a->origin_word);
	return TS_OK;
}

static enum ts_status read_bounds(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	struct ts_words rest = c->bound_words;

	for (; rest.n; rest = ts_words_from(rest, 3)) {
		int dim = 0;

		while (ts_axis_names[dim] && !ts_streq(rest.word[0].text, ts_axis_names[dim]))
			dim++;
		if (rest.n < 3 || !ts_axis_names[dim])
			return refuse_word(sim, self, rest.word, "bound takes x, y or z and two bounds");
		for (int s = 0; s < 2; s++) {
			const struct ts_word *word = &rest.word[1 + s];
			struct ts_chunk_bound *side = &c->bound[dim][s];

			side->given = ts_parse_real(word->text, &side->at);
			if (!side->given && !ts_streq(word->text, s ? "upper" : "lower"))
				return refuse_word(sim, self, word,
						   s ? "expected a coordinate or upper"
						     : "expected a coordinate or lower");
		}
	}
	return TS_OK;
}

static bool has_bins_along(const struct ts_chunks *c, int dim)
{
	bool has = false;

	for (int k = 0; k < c->naxes; k++)
		has |= c->axis[k].dim == dim;
	return has;
}

static enum ts_status check_bounds(const struct ts_instance *self, struct tsim *sim,
				   const struct ts_chunks *c)
{
	for (int dim = 0; dim < 3; dim++) {
		const struct ts_chunk_bound *bound = c->bound[dim];

		if ((bound[0].given || bound[1].given) && !has_bins_along(c, dim))
			ts_warn(&sim->log, ts_instance_word(self, "bound"),
				"%s %s: bound %s has no effect: there are no bins along %s",
				ts_kind_name(self->style->kind), self->style->name, ts_axis_names[dim],
				ts_axis_names[dim]);
		if (bound[0].given && bound[1].given && !(bound[0].at < bound[1].at))
			return refuse_word(sim, self, c->bound_words.word,
					   "the upper bound must be larger than the lower one");
	}
	return TS_OK;
}

static enum ts_status read_limit(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	struct ts_words w = c->limit_words;
	bool bins = c->style != TS_CHUNK_TYPE && c->style != TS_CHUNK_VALUE;

	if (!w.n)
		return TS_OK;
	if (!ts_parse_int(w.word[0].text, &c->limit) || c->limit < 0 || c->limit > 1000000000)
		return refuse_word(sim, self, w.word, "limit takes 0, or a number and max or exact");
	if (c->limit == 0)
		return w.n == 1 ? TS_OK : refuse_word(sim, self, &w.word[1], "limit 0 takes no other word");
	if (w.n != 2 || (!ts_streq(w.word[1].text, "max") && !ts_streq(w.word[1].text, "exact")))
		return refuse_word(sim, self, w.word, "limit takes a number and max or exact");
	c->exact = ts_streq(w.word[1].text, "exact");
	if (bins && !c->compress)
		return refuse_word(sim, self, w.word, "a limit of the number of bins needs compress yes");
	return TS_OK;
}

static enum ts_status check_geometry(struct ts_instance *self, struct tsim *sim, const struct ts_chunks *c)
{
	for (int k = 0; k < c->naxes; k++)
		for (int j = 0; j < k; j++)
			if (c->axis[j].dim == c->axis[k].dim)
				return refuse_word(sim, self, c->words.word, "the same axis twice");
	if (sim->dimension == 2 && c->style == TS_CHUNK_CYLINDER && c->axis[0].dim != 2)
		return refuse_word(sim, self, c->words.word,
				   "in two dimensions the axis of a cylinder must be z");
	if (c->style != TS_CHUNK_SPHERE && c->style != TS_CHUNK_CYLINDER)
		return TS_OK;
	if (!(c->outer > c->inner))
		return refuse_word(sim, self, c->words.word, "rmax must be larger than rmin");
	return c->units == TS_LENGTHS_REDUCED
		       ? refuse_word(sim, self, c->words.word, "spheres and cylinders have no reduced units")
		       : TS_OK;
}

/* Converts centre and radii of spheres and cylinders to box units; they do not follow a changing box. */
static void scale_round_bins(const struct tsim *sim, struct ts_chunks *c)
{
	int along = c->style == TS_CHUNK_CYLINDER ? c->axis[0].dim : 3;

	/* c1 and c2 of a cylinder are along the two other axes, in the order x, y, z */
	for (int k = 0; k < (along < 3 ? 2 : 3); k++)
		c->centre[k] = coordinate_from_units(sim, c, c->centre[k], k + (k >= along));
	c->inner = length_from_units(sim, c, c->inner, 0);
	c->outer = length_from_units(sim, c, c->outer, 0);
}

static enum ts_status parse_definition(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	TS_TRY(read_style(self, sim, c));
	for (int k = 0; k < c->naxes; k++)
		TS_TRY(read_origin(self, sim, &c->axis[k]));
	TS_TRY(read_bounds(self, sim, c));
	TS_TRY(check_bounds(self, sim, c));
	TS_TRY(read_limit(self, sim, c));
	TS_TRY(check_geometry(self, sim, c));
	if (c->style == TS_CHUNK_SPHERE || c->style == TS_CHUNK_CYLINDER)
		scale_round_bins(sim, c);
	for (int dim = 0; dim < 3; dim++)
		for (int s = 0; s < 2; s++)
			c->bound[dim][s].at = coordinate_from_units(sim, c, c->bound[dim][s].at, dim);
	return TS_OK;
}

static enum ts_status add_chunk_column(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "chunks of %s %s", ts_kind_name(self->style->kind), self->id);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), 1, TS_COL_RESULT, &c->column);
	ts_str_release(&name);
	/* 0: not yet assigned; the column may still exist from a deleted style of the same id */
	for (size_t i = 0; status == TS_OK && !c->has_column && i < sim->particles->n; i++)
		((double *)sim->particles->column[c->column].data)[i] = 0;
	c->has_column = status == TS_OK;
	return status;
}

enum ts_status ts_chunks_init(struct ts_instance *self, struct tsim *sim, struct ts_chunks *c)
{
	char what[96];

	c->sim = sim;
	if (!c->started)
		TS_TRY(parse_definition(self, sim, c));
	c->started = 1;
	if (c->ids != TS_CHUNK_IDS_EVERY)
		TS_TRY(add_chunk_column(self, sim, c));
	if (c->style != TS_CHUNK_VALUE)
		return TS_OK;
	snprintf(what, sizeof what, "%s %s", ts_kind_name(self->style->kind), self->style->name);
	c->value.name = value_name(c);
	c->value.where = c->words.word[0].place;
	return ts_ref_input_resolve(sim, what, TS_WANT(PERATOM), &c->value);
}
