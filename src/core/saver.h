/* Saving the state on request, from a signal handler, while a script goes on. */
#ifndef TS_CORE_SAVER_H
#define TS_CORE_SAVER_H

#include "base/status.h"

struct tsim;

struct ts_saver {
	enum ts_status (*save)(struct ts_saver *self, struct tsim *sim);
};

/* After a step or a command: writes a restart file if sim->requests.save is set and there is a saver. */
enum ts_status ts_saver_save(struct tsim *sim);

#endif
