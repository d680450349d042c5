/* Errors of files that cannot be opened or written. */
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "base/mkdirs.h"
#include "io/textfile.h"

#include "base/banned.h"

/* For files to be read: names a missing folder. In a sandbox ts_files_why gives the reason. */
enum ts_status ts_textfile_open_failed(struct ts_error *err, struct ts_files *files,
				       const struct ts_place *where, const char *path)
{
	int code = errno;
	const char *slash = strrchr(path, '/');
	struct stat info;
	char folder[256] = "";

	if (slash && slash > path && (size_t)(slash - path) < sizeof folder)
		memcpy(folder, path, (size_t)(slash - path));
	if (code == ENOENT && folder[0] && !ts_files_closed(files) &&
	    ts_files_stat(files, folder, &info) != 0)
		return ts_fail(err, TS_IO, where, "cannot open '%s': there is no folder '%s'", path, folder);
	errno = code;
	return ts_fail(err, TS_IO, where, "cannot open '%s': %s", path, ts_files_why(files));
}

enum ts_status ts_textfile_write_failed(struct ts_error *err, struct ts_files *files,
					const struct ts_place *where, const char *path)
{
	int code = errno;
	char folder[256];

	if (!ts_files_closed(files) && ts_mkdirs_blocked(files, path, folder, sizeof folder))
		return ts_fail(err, TS_IO, where,
			       "cannot write '%s': '%s' is no folder that one can be made in", path, folder);
	errno = code;
	return ts_fail(err, TS_IO, where, "cannot write '%s': %s", path, ts_files_why(files));
}
