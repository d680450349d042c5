/* The record of settings in the log file: what was resolved, and whether it was given or is a default. */
#ifndef TS_CORE_SETTINGS_H
#define TS_CORE_SETTINGS_H

#include "core/sim.h"

/* "# fix gravity: magnitude 9.81 ...; by default: every 1", if the line left anything to its default. */
void ts_settings_log(struct tsim *sim, const char *what, const struct ts_arg *rows, const void *base,
		     struct ts_words words);
/* Those of the simulation and its systems, when they are not as they were at the run before. */
void ts_settings_log_run(struct tsim *sim);

/* One setting: " name text", with a remark where it is the default. */
void ts_setting(struct ts_str *out, bool is_default, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

#endif
