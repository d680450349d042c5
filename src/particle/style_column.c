#include "particle/style_column.h"

#include "particle/columns.h"

#include "base/banned.h"

/* Whether the script has a fix property/atom of this name. */
static bool is_user_column(const struct tsim *sim, const char *name)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (ts_streq(fixes->item[k]->style->name, "property/atom") &&
		    ts_streq(fixes->item[k]->words.word[0].text, name))
			return true;
	return false;
}

enum ts_status ts_particles_style_column(struct tsim *sim, const char *name, size_t width, unsigned flags,
					 double initial, size_t *column)
{
	struct ts_particles *p = sim->particles;
	double first[3] = { initial, initial, initial };
	size_t known = p->ncolumns;

	TS_TRY(ts_particles_add_column(sim, name, width, flags, column));
	p->column[*column].flags |= flags;
	if (is_user_column(sim, name))
		return TS_OK;
	TS_TRY(ts_particles_column_initial(sim, *column, first));
	if (*column == known)
		ts_particles_fill_initial(&p->column[*column], 0, p->n);
	return TS_OK;
}
