#include "core/number_or_peratom.h"

#include "core/sim.h"

#include "base/banned.h"

enum ts_status ts_number_or_peratom_now(struct tsim *sim, const struct ts_number *number,
					const struct ts_place *where, struct ts_number_or_peratom *values)
{
	values->list = NULL;
	if (!number->variable || !sim->script_api->is_peratom(sim->script_api_data, number->variable))
		return ts_number_now(sim, number, where, &values->value);
	TS_TRY(sim->script_api->peratom(sim->script_api_data, number->variable, where, &values->table));
	values->list = values->table.data;
	return TS_OK;
}
