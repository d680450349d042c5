#include "particle/first_size.h"

#include "particle/columns.h"

#include "base/banned.h"

enum ts_status ts_first_size_start(struct tsim *sim, const struct ts_instance *self, size_t *column)
{
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "fix %s %s", self->style->name, self->id);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), TS_FIRST_WIDTH, TS_COL_RESULT,
						       column);
	ts_str_release(&name);
	TS_TRY(status);
	for (size_t i = 0; i < sim->particles->n; i++) /* left by a former fix of this name */
		ts_first_size(sim, *column, i)[TS_FIRST_KNOWN] = 0;
	return TS_OK;
}

void ts_first_size_note(const struct tsim *sim, size_t column, size_t i)
{
	double *first = ts_first_size(sim, column, i);

	if (first[TS_FIRST_KNOWN] > 0)
		return;
	first[TS_FIRST_RADIUS] = sim->particles->radius[i];
	first[TS_FIRST_MASS] = sim->particles->mass[i];
	first[TS_FIRST_KNOWN] = 1;
}
