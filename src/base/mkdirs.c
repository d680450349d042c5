#include "base/mkdirs.h"

#include <errno.h>
#include <string.h>

#include "base/banned.h"

static int make_one(struct ts_files *files, const char *path)
{
	struct stat info;

	if (ts_files_make_folder(files, path) == 0)
		return 0;
	return errno == EEXIST && ts_files_stat(files, path, &info) == 0 && S_ISDIR(info.st_mode) ? 0 : -1;
}

int ts_mkdirs(struct ts_files *files, const char *path)
{
	struct ts_str part = { 0 };
	int result = 0;

	for (const char *c = path; *c && result == 0; c++) {
		if (*c == '/' && c > path)
			result = make_one(files, ts_str_text(&part));
		if (result != 0 && errno == EACCES && ts_files_closed(files))
			result = 0; /* parents of an admitted folder may be inaccessible */
		ts_str_add_n(&part, c, 1);
	}
	if (part.failed)
		errno = ENOMEM;
	if (result == 0)
		result = part.failed ? -1 : make_one(files, ts_str_text(&part));
	ts_str_release(&part);
	return result;
}

int ts_mkdirs_for(struct ts_files *files, const char *file)
{
	const char *slash = strrchr(file, '/');
	struct ts_str folder = { 0 };
	int result;

	if (!slash || slash == file)
		return 0;
	ts_str_add_n(&folder, file, (size_t)(slash - file));
	if (folder.failed)
		errno = ENOMEM;
	result = folder.failed ? -1 : ts_mkdirs(files, ts_str_text(&folder));
	ts_str_release(&folder);
	return result;
}

bool ts_mkdirs_blocked(struct ts_files *files, const char *file, char *by, size_t room)
{
	size_t n = strlen(file);
	struct stat info;

	for (;;) {
		while (n && file[n - 1] != '/')
			n--;
		while (n > 1 && file[n - 1] == '/')
			n--;
		if (n >= room)
			return false;
		memcpy(by, n ? file : ".", n ? n : 1);
		by[n ? n : 1] = '\0';
		if (ts_files_stat(files, by, &info) == 0)
			return !S_ISDIR(info.st_mode) || !ts_files_may_make_in(files, by);
		if (ts_files_closed(files)) /* parents of an admitted folder may be inaccessible */
			return false;
		if (!n || n == 1)
			return true;
	}
}
