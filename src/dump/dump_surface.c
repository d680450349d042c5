#include "dump/dump_surface.h"

#include <stdio.h>

#include "base/banned.h"

enum ts_status ts_dump_surface_find(struct ts_instance *self, struct tsim *sim,
				    ts_dump_surface_writes_fn *writes, struct ts_dump_surface_inputs *in)
{
	char what[64];

	if (!in->names.n)
		return TS_OK;
	snprintf(what, sizeof what, "dump %s", self->style->name);
	TS_TRY(ts_ref_list_init(sim, what, &self->arena, in->names, TS_WANT(SURFACE), &in->list));
	for (size_t k = 0; k < in->list.n; k++) {
		const struct ts_instance *by = ts_dump_surface_of(in, k);

		if (!writes(self, by))
			return ts_fail(&sim->error, TS_STATE, &in->list.item[k].where,
				       "%s: '%s' is about a %s that this dump does not write: %s", what,
				       in->list.item[k].name, by->style->family, by->id);
	}
	return TS_OK;
}

const struct ts_instance *ts_dump_surface_of(const struct ts_dump_surface_inputs *in, size_t k)
{
	const struct ts_instance *inst = in->list.item[k].ref.inst;

	return inst->style->surface(inst);
}

enum ts_status ts_dump_surface_eval(struct tsim *sim, struct ts_dump_surface_inputs *in, size_t k,
				    size_t elements)
{
	const struct ts_ref_input *input = &in->list.item[k];

	TS_TRY(ts_ref_input_eval(sim, input, &in->values));
	if (in->values.rows != elements)
		return ts_fail(&sim->error, TS_STATE, &input->where,
			       "'%s' has %zu rows, but surface %s has %zu elements", input->name,
			       in->values.rows, ts_dump_surface_of(in, k)->id, elements);
	return TS_OK;
}

void ts_dump_surface_release(struct ts_dump_surface_inputs *in)
{
	ts_ref_list_release(&in->list);
	ts_table_release(&in->values);
}
