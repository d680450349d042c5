/* Files of a series: "rock.*.dump" stands for those that have a number, the step, at the place of the `*`. */
#ifndef TS_IO_SERIES_H
#define TS_IO_SERIES_H

#include "base/files.h"
#include "base/str.h"

struct ts_series_file {
	int64_t step;
	char *path;
};

/* Zero-initialise. */
struct ts_series {
	struct ts_series_file *file; /* by their numbers */
	size_t n, capacity;
};

/* `*` counts in the last part of the path only. Without `*` the path itself, whether there is such a file
 * or not. */
bool ts_series_is(const char *pattern);
/* TS_OK or TS_NOMEM */
enum ts_status ts_series_find(struct ts_files *files, const char *pattern, struct ts_series *out);
void ts_series_release(struct ts_series *series);

#endif
