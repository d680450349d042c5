/* Series of files: in "rock.*.dump" the `*` stands for a number, the step. */
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
	struct ts_series_file *file; /* [n] sorted by step */
	size_t n, capacity;
};

/* Whether the last component of the path has a `*`. */
bool ts_series_is(const char *pattern);
/* Finds the files of the series; without a `*` the result is the path itself, whether the file exists or not.
 * Returns TS_OK or TS_NOMEM. */
enum ts_status ts_series_find(struct ts_files *files, const char *pattern, struct ts_series *out);
void ts_series_release(struct ts_series *series);

/* *out: the path with each `*` replaced by the step, with leading zeros to `pad` digits. */
void ts_series_path(struct ts_str *out, const char *path, long long step, int pad);

#endif
