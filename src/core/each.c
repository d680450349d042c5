#include "core/each.h"

#include "core/sim.h"

#include "base/banned.h"

enum ts_status ts_each_now(struct tsim *sim, const struct ts_number *number,
			   const struct ts_place *where, struct ts_each *each)
{
	each->list = NULL;
	if (!number->variable || !sim->host->is_peratom(sim->host_data, number->variable))
		return ts_number_now(sim, number, where, &each->value);
	TS_TRY(sim->host->peratom(sim->host_data, number->variable, where, &each->table));
	each->list = each->table.data;
	return TS_OK;
}
