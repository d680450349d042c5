/* Columns of section Atoms of a data file for each atom style. */
#include "restart/data.h"

#include <string.h>

#include "base/banned.h"

const char *const ts_data_column_names[TS_NDATA_COLUMN] = { "id",      "type", "molecule", "diameter",
							    "density", "x",    "y",	   "z" };

struct layout {
	const char *style;
	const char *columns; /* letters: i id, t type, m molecule, d diameter, r density, x position */
	const char *extra;   /* columns that it adds to a hybrid style */
};

static const struct layout layouts[] = {
	{ "sphere", "itdrx", "dr" },	   { "granular", "itdrx", "dr" }, { "atomic", "itx", "" },
	{ "bond", "imtx", "m" },	   { "molecular", "imtx", "m" },  { "bond/gran", "imtx", "m" },
	{ "bpm/sphere", "imtdrx", "mdr" },
};

/* The suffix /omp is ignored. */
static const struct layout *find_layout(const char *style, size_t n)
{
	static const char omp[] = "/omp";
	size_t ending = strlen(omp);

	if (n > ending && strncmp(style + n - ending, omp, ending) == 0)
		n -= ending;
	for (size_t k = 0; k < sizeof layouts / sizeof *layouts; k++)
		if (strlen(layouts[k].style) == n && strncmp(layouts[k].style, style, n) == 0)
			return &layouts[k];
	return NULL;
}

static void add_column(struct ts_data_layout *out, int column)
{
	for (size_t k = 0; k < out->n; k++)
		if (out->column[k] == column)
			return;
	out->column[out->n++] = column;
	out->sized |= column == TS_DATA_DIAMETER;
}

static void add_letters(struct ts_data_layout *out, const char *letters)
{
	static const char order[] = "itmdrxyz"; /* of enum ts_data_column */

	for (; *letters; letters++) {
		add_column(out, (int)(strchr(order, *letters) - order));
		if (*letters == 'x') {
			add_column(out, TS_DATA_Y);
			add_column(out, TS_DATA_Z);
		}
	}
}

bool ts_data_layout(const char *style, struct ts_data_layout *out)
{
	size_t n = strcspn(style, " ");
	const struct layout *l = find_layout(style, n);

	*out = (struct ts_data_layout){ 0 };
	if (l) {
		add_letters(out, l->columns);
		return true;
	}
	if (n != 6 || strncmp(style, "hybrid", n) != 0 || !style[n])
		return false;
	add_letters(out, "itx");
	for (style += n + 1; *style;
	     style += n + (style[n] == ' ')) { /* arguments of sub-styles are ignored */
		n = strcspn(style, " ");
		l = find_layout(style, n);
		if (l)
			add_letters(out, l->extra);
	}
	return true;
}

enum ts_status ts_data_refuse_style(struct tsim *sim, const struct ts_word *word)
{
	static const char *const others[] = { "superquadric", "sph",  "sph/var", "ellipsoid", "line",
					      "tri",	      "body", "peri",	 "template",  "dipole",
					      "charge",	      "full", "angle",	 NULL };
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (size_t k = 0; others[k]; k++)
		if (ts_streq(word->text, others[k]))
			return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
				       "atom_style %s is known, but tsim does not have it: particles are "
				       "spheres",
				       word->text);
	if (ts_streq(word->text, "hybrid"))
		return ts_fail(&sim->error, TS_SYNTAX, &word->place,
			       "atom_style hybrid: expected styles behind it, such as sphere bond");
	for (size_t k = 0; k < sizeof layouts / sizeof *layouts; k++)
		ts_suggest_try(&suggest, layouts[k].style);
	ts_suggest_try(&suggest, "hybrid");
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "unknown atom style '%.60s'%s", word->text,
		       ts_suggest_text(&suggest));
}
