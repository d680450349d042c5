/* The record of settings in the log file: resolved values, and which of them are defaults. */
#ifndef TS_CORE_SETTINGS_H
#define TS_CORE_SETTINGS_H

#include "core/sim.h"

/* Writes "# fix gravity: magnitude 9.81 ...; by default: every 1" if any argument has its default. */
void ts_settings_log(struct tsim *sim, const char *what, const struct ts_arg *rows, const void *base,
		     struct ts_words words);
/* Writes the settings of the simulation and its systems if they have changed since the last run. */
void ts_settings_log_run(struct tsim *sim);

/* Appends one setting: " name text", and " (default)" if it is. */
void ts_setting(struct ts_str *out, bool is_default, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

#endif
