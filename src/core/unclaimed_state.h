/* Unclaimed state: state of styles read from a restart file, kept until the script defines the style
 * again. */
#ifndef TS_CORE_UNCLAIMED_STATE_H
#define TS_CORE_UNCLAIMED_STATE_H

#include "core/style.h"

/* Keeps a copy of the block for the style of this kind, name and id. */
enum ts_status ts_unclaimed_add(struct tsim *sim, enum ts_kind kind, const char *style, const char *id,
				const char *group, const unsigned char *bytes, size_t n);
/* Restores the state of a new instance, made from `args`, if some waits for it, and says so in the
 * log. A fix or compute of another style or group, or with another TS_STATEFUL argument, is refused. */
enum ts_status ts_unclaimed_apply(struct tsim *sim, struct ts_instance *inst, struct ts_words args);

/* Does state wait for this style? Then what it would start with is not to be made up. */
bool ts_unclaimed_exists(const struct tsim *sim, const struct ts_instance *inst);

/* An instance for a restart file: its arguments as they are now, then its state. */
enum ts_status ts_unclaimed_write(struct tsim *sim, struct ts_instance *inst, struct ts_archive *archive);
/* Says once in the log which fixes and computes of the restart file the script has not defined again. */
void ts_unclaimed_report(struct tsim *sim);
void ts_unclaimed_free(struct tsim *sim);

#endif
