#include "base/mkdirs.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "base/str.h"

#include "base/banned.h"

static int make_one(const char *path)
{
	struct stat info;

	if (mkdir(path, 0777) == 0)
		return 0;
	return errno == EEXIST && stat(path, &info) == 0 && S_ISDIR(info.st_mode) ? 0 : -1;
}

int ts_mkdirs(const char *path)
{
	struct ts_str part = { 0 };
	int result = 0;

	for (const char *c = path; *c && result == 0; c++) {
		if (*c == '/' && c > path)
			result = make_one(ts_str_text(&part));
		ts_str_add_n(&part, c, 1);
	}
	if (part.failed)
		errno = ENOMEM;
	if (result == 0)
		result = part.failed ? -1 : make_one(ts_str_text(&part));
	ts_str_release(&part);
	return result;
}

int ts_mkdirs_for(const char *file)
{
	const char *slash = strrchr(file, '/');
	struct ts_str folder = { 0 };
	int result;

	if (!slash || slash == file)
		return 0;
	ts_str_add_n(&folder, file, (size_t)(slash - file));
	if (folder.failed)
		errno = ENOMEM;
	result = folder.failed ? -1 : ts_mkdirs(ts_str_text(&folder));
	ts_str_release(&folder);
	return result;
}
