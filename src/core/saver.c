#include "core/saver.h"

#include "core/sim.h"

#include "base/banned.h"

enum ts_status ts_saver_save(struct tsim *sim)
{
	if (!sim->requests.save || !sim->requests.saver)
		return TS_OK;
	sim->requests.save = 0;
	return sim->requests.saver->save(sim->requests.saver, sim);
}
