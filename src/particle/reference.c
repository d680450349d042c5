#include "particle/reference.h"

#include "particle/columns.h"

#include "base/banned.h"

enum { KNOWN = 3, WIDTH = 4 }; /* the vector, and 1 if it is stored */

double *ts_reference_of(const struct tsim *sim, const struct ts_reference *ref, size_t i)
{
	return (double *)sim->particles->column[ref->column].data + WIDTH * i;
}

void ts_reference_add(struct tsim *sim, const struct ts_reference *ref)
{
	for (size_t i = 0; i < sim->particles->n; i++) {
		double *row = ts_reference_of(sim, ref, i);

		if (row[KNOWN] > 0)
			continue;
		ref->now(ref->owner, sim, i, row);
		row[KNOWN] = 1;
	}
}

enum ts_status ts_reference_init(struct ts_instance *self, struct tsim *sim, struct ts_reference *ref,
				 ts_reference_fn *now)
{
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "%s %s %s", ts_kind_name(self->style->kind), self->style->name, self->id);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), WIDTH, TS_COL_RESULT,
						       &ref->column);
	ts_str_release(&name);
	if (status != TS_OK || ref->started)
		return status;
	ref->now = now;
	ref->owner = self;
	ref->started = true;
	/* a former compute of this name may have left its column */
	for (size_t i = 0; i < sim->particles->n; i++)
		ts_reference_of(sim, ref, i)[KNOWN] = 0;
	ts_reference_add(sim, ref);
	return TS_OK;
}

enum ts_status ts_reference_archive(struct ts_archive *archive, struct tsim *sim,
				    const struct ts_reference *ref)
{
	return ts_particles_archive_column(archive, sim, "reference", ref->column);
}
