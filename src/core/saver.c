#include "core/saver.h"

#include "core/sim.h"

#include "base/banned.h"

enum ts_status ts_saver_act(struct tsim *sim)
{
	if (!sim->save || !sim->saver)
		return TS_OK;
	sim->save = 0;
	return sim->saver->save(sim->saver, sim);
}
