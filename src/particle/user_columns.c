#include "particle/user_columns.h"

#include <string.h>

#include "base/banned.h"

enum ts_status ts_user_columns_of(struct tsim *sim, const struct ts_word *id, const char *what,
				  const struct ts_user_columns **out)
{
	struct ts_instance *fix;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, id, &fix));
	*out = fix->state;
	if (ts_streq(fix->style->name, "property/atom"))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &id->place, "%s: fix %s is of style %s, expected property/atom",
		       what, id->text, fix->style->name);
}

void ts_user_columns_get(const struct ts_particles *p, const struct ts_user_columns *columns, size_t i,
			 double *value)
{
	for (size_t k = 0; k < columns->n; k++) {
		const struct ts_column *c = &p->column[columns->column[k]];

		memcpy(value, (const double *)c->data + i * c->width, c->width * sizeof *value);
		value += c->width;
	}
}

void ts_user_columns_set(struct ts_particles *p, const struct ts_user_columns *columns, size_t i,
			 const double *value)
{
	for (size_t k = 0; k < columns->n; k++) {
		const struct ts_column *c = &p->column[columns->column[k]];

		memcpy((double *)c->data + i * c->width, value, c->width * sizeof *value);
		value += c->width;
	}
}
