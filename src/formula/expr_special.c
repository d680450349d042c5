/* Functions of words: properties of the script, the simulation and the program. */
#include <ctype.h>
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/utsname.h>

#include "core/group.h"
#include "core/unsupported_names.h"
#include "formula/expr.h"

#include "base/banned.h"

/* The present value of a file variable, which then advances to the next; if there is none it is deleted,
 * as by the command `next`. */
static enum ts_status eval_next(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	const struct ts_word *word = &words.word[0];
	struct ts_variable *variable;
	struct ts_table table = { 0 };
	bool exhausted = false;

	e->formulas->drawn++;
	TS_TRY(ts_variable_require(e->formulas, word->text, &word->place, &variable));
	if (variable->style == &ts_var_file)
		TS_TRY(ts_variable_number(e->formulas, variable, &word->place, &out->scalar));
	else if (variable->style == &ts_var_atomfile && e->kind == TS_FORMULA_PERATOM)
		TS_TRY(ts_expr_take_table(e, ts_variable_peratom(e->formulas, variable, &word->place, &table),
					  &table, out));
	else
		return ts_fail(&e->sim->error, TS_STATE, &word->place,
			       "next() needs a variable of style file or, in formulas of particles, "
			       "atomfile; '%s' is of style %s",
			       word->text, variable->style->name);
	if (e->sim->reading.probing)
		return TS_OK;
	variable->in_run |= e->sim->run.inside;
	TS_TRY(ts_variable_next(e->formulas, variable, &word->place, &exhausted));
	if (exhausted)
		ts_variable_delete(e->formulas, variable);
	return TS_OK;
}

static enum ts_status eval_is_file(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	struct ts_files *files = &e->sim->files;
	struct stat info;

	out->scalar = ts_files_stat(files, words.word[0].text, &info) == 0;
	if (!out->scalar && files->closed && errno == EACCES)
		return ts_fail(&e->sim->error, TS_STATE, &words.word[0].place, "is_file(%s): %s",
			       words.word[0].text, ts_files_why(files));
	return TS_OK;
}

/* Whether the name of the operating system begins with the word (LAMMPS has a regular expression, ^Linux). */
static enum ts_status eval_is_os(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	const char *word = words.word[0].text;
	struct utsname name;
	size_t k = 0;

	word += *word == '^';
	if (uname(&name) < 0)
		return ts_fail(&e->sim->error, TS_IO, &words.word[0].place,
			       "cannot read the name of the operating system");
	while (word[k] && tolower((unsigned char)word[k]) == tolower((unsigned char)name.sysname[k]))
		k++;
	out->scalar = word[k] == '\0';
	return TS_OK;
}

/* Categories of LAMMPS that are always empty here. */
static bool is_lammps_category(const char *category)
{
	static const char *const names[] = { "package",	  "newton",   "comm",	    "min_style", "run_style",
					     "integrate", "minimize", "atom_style", "atom",	 "angle",
					     "dihedral",  "improper", "kspace",	    "feature",	 "molecule" };

	for (size_t k = 0; k < sizeof names / sizeof *names; k++)
		if (ts_streq(names[k], category))
			return true;
	return false;
}

static enum ts_status find_kind(struct ts_expr *e, const struct ts_word *word, enum ts_kind *kind)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	if (ts_kind_find(word->text, kind))
		return TS_OK;
	for (int k = 0; k < TS_NKIND; k++)
		ts_suggest_try(&suggest, ts_kind_name((enum ts_kind)k));
	return ts_fail(&e->sim->error, TS_UNKNOWN, &word->place, "unknown category '%s'%s", word->text,
		       ts_suggest_text(&suggest));
}

static enum ts_status eval_is_defined(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	const char *category = words.word[0].text, *id = words.word[1].text;
	enum ts_kind kind;

	if (ts_streq(category, "variable")) {
		out->scalar = ts_variable_find(e->formulas, id) != NULL;
	} else if (ts_streq(category, "group")) {
		out->scalar = ts_group_exists(e->sim, id);
	} else if (!is_lammps_category(category)) {
		TS_TRY(find_kind(e, &words.word[0], &kind));
		out->scalar = ts_sim_find(e->sim, kind, id) != NULL;
	}
	return TS_OK;
}

static enum ts_status eval_is_available(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	enum ts_kind kind = TS_KIND_COMMAND;

	if (is_lammps_category(words.word[0].text))
		return TS_OK;
	TS_TRY(find_kind(e, &words.word[0], &kind));
	out->scalar = ts_style_find(e->sim->tables, kind, words.word[1].text) != NULL;
	return TS_OK;
}

/* In LAMMPS the second word of category pair is a property. All pair styles here act between two particles, without
 * corrections of a cutoff and without r-RESPA; their forces are known pair by pair, as by single() of LAMMPS. */
static bool is_property_of_pairs(const char *word)
{
	static const char *const names[] = { "single", "respa", "manybody", "tail", "shift" };

	for (size_t k = 0; k < sizeof names / sizeof *names; k++)
		if (ts_streq(names[k], word))
			return true;
	return false;
}

/* Whether a live instance is of that style. */
static enum ts_status eval_is_active(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	enum ts_kind kind = TS_KIND_FIX;
	const struct ts_word *name = &words.word[1];
	const struct ts_instances *all;
	const struct ts_style *style;

	if (is_lammps_category(words.word[0].text))
		return TS_OK;
	TS_TRY(find_kind(e, &words.word[0], &kind));
	all = &e->sim->instances[kind];
	if (kind == TS_KIND_PAIR && is_property_of_pairs(name->text)) {
		out->scalar = all->n && ts_streq(name->text, "single");
		return TS_OK;
	}
	if (ts_unsupported_find(kind, name->text))
		return TS_OK;
	TS_TRY(ts_style_require(e->sim, kind, name, &style));
	for (size_t k = 0; k < all->n; k++)
		if (all->item[k]->style == style)
			out->scalar = 1;
	return TS_OK;
}

static double setting_dimension(const struct tsim *sim)
{
	return sim->dimension;
}

static double setting_box_exist(const struct tsim *sim)
{
	return ts_sim_has_box(sim);
}

static double setting_threads(const struct tsim *sim)
{
	return sim->threads;
}

static double setting_one(const struct tsim *sim)
{
	(void)sim;
	return 1;
}

static double setting_zero(const struct tsim *sim)
{
	(void)sim;
	return 0;
}

static const struct {
	const char *name;
	double (*get)(const struct tsim *sim);
} settings[] = {
	{ "dimension", setting_dimension }, { "box_exist", setting_box_exist },
	{ "nthreads", setting_threads },    { "world_size", setting_one },
	{ "world_rank", setting_zero },	    { "universe_size", setting_one },
	{ "universe_rank", setting_zero },  { "triclinic", setting_zero },
	{ "newton_bond", setting_zero },    { "newton_pair", setting_zero },
};

static enum ts_status eval_extract_setting(struct ts_expr *e, struct ts_words words, struct ts_operand *out)
{
	const struct ts_word *word = &words.word[0];
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (size_t k = 0; k < sizeof settings / sizeof *settings; k++) {
		ts_suggest_try(&suggest, settings[k].name);
		if (ts_streq(settings[k].name, word->text)) {
			out->scalar = settings[k].get(e->sim);
			return TS_OK;
		}
	}
	return ts_fail(&e->sim->error, TS_UNKNOWN, &word->place, "unknown setting '%s'%s", word->text,
		       ts_suggest_text(&suggest));
}

#define ASK(name_, arguments_, n, f, help_)                                                             \
	{                                                                                               \
		.name = (name_), .arguments = (arguments_), .help = (help_), .least = (n), .most = (n), \
		.words = (f)                                                                            \
	}

const struct ts_expr_function ts_special_functions[] = {
	ASK("next", "variable", 1, eval_next,
	    "present value of a variable of style file or atomfile, which then advances to the next"),
	ASK("is_file", "path", 1, eval_is_file, "1 if a file of that name exists"),
	ASK("is_os", "name", 1, eval_is_os, "1 if the name of the operating system begins with this word"),
	ASK("is_defined", "category,id", 2, eval_is_defined,
	    "1 if a variable, group, region, compute, fix or dump of that id exists"),
	ASK("is_active", "category,style", 2, eval_is_active,
	    "1 if a fix, compute, pair, ... of that style is defined; of category pair also the properties "
	    "of LAMMPS: single is 1 if there is a pair style, respa, manybody, tail and shift are 0"),
	ASK("is_available", "category,style", 2, eval_is_available,
	    "1 if tsim has a command, fix, pair, ... of that name"),
	ASK("extract_setting", "name", 1, eval_extract_setting,
	    "one of dimension, box_exist, nthreads, world_size, world_rank, universe_size, universe_rank, "
	    "triclinic, newton_bond, newton_pair"),
	{ .name = NULL },
};
