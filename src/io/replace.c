#include "io/replace.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/mkdirs.h"
#include "io/textfile.h"

#include "base/banned.h"

static enum ts_status report_write_error(struct ts_replace *r)
{
	int code = errno;
	enum ts_status status =
		ts_fail(&r->sim->error, TS_IO, &r->where, "writing '%s' failed: %s", ts_str_text(&r->path),
			code ? ts_files_why(&r->sim->files) : "unknown reason");

	ts_replace_abandon(r);
	return status;
}

/* Renaming to a device or a pipe would replace it by a regular file. */
static bool is_replaceable(struct ts_files *files, const char *path)
{
	struct stat there;

	return ts_files_stat(files, path, &there) != 0 || S_ISREG(there.st_mode);
}

/* The folder of a path. */
static enum ts_status folder_of(const char *path, struct ts_str *out)
{
	const char *slash = strrchr(path, '/');

	if (slash)
		ts_str_add_n(out, path, slash == path ? 1 : (size_t)(slash - path));
	else
		ts_str_add(out, ".");
	return out->failed ? TS_NOMEM : TS_OK;
}

/* Whether an entry is NAME.tmp.PROCESS.RANDOM of a process that has ended. Processes of other machines are
 * unknown here, but their files have been written to recently. */
static bool is_stale(int folder, const char *name, const char *entry)
{
	enum { IDLE = 600 }; /* seconds */
	size_t n = strlen(name);
	struct stat info;
	char digits[16] = "";
	int64_t process;
	size_t m;

	if (strncmp(entry, name, n) != 0 || strncmp(entry + n, ".tmp.", 5) != 0)
		return false;
	m = strspn(entry + n + 5, "0123456789");
	if (m >= sizeof digits || strspn(entry + n + 5 + m, ".0123456789abcdef") < strlen(entry + n + 5 + m))
		return false;
	memcpy(digits, entry + n + 5, m);
	if (!ts_parse_int(digits, &process) || process < 1 || process > INT32_MAX)
		return false;
	return kill((pid_t)process, 0) != 0 && errno == ESRCH &&
	       fstatat(folder, entry, &info, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(info.st_mode) &&
	       difftime(time(NULL), info.st_mtime) > IDLE;
}

static void remove_stale(struct ts_files *files, const char *path)
{
	const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
	struct ts_str folder = { 0 };
	struct dirent *entry;
	DIR *list;

	list = folder_of(path, &folder) == TS_OK ? ts_files_list(files, ts_str_text(&folder)) : NULL;
	while (list && (entry = readdir(list)))
		if (is_stale(dirfd(list), name, entry->d_name))
			unlinkat(dirfd(list), entry->d_name, 0);
	if (list)
		closedir(list);
	ts_str_release(&folder);
}

enum ts_status ts_replace_begin(struct ts_replace *r, struct tsim *sim, const struct ts_place *where,
				const char *path)
{
	uint64_t random = 0;

	ts_replace_abandon(r);
	r->sim = sim;
	r->where = where ? *where : (struct ts_place){ 0 };
	if (sim->reading.explain) {
		r->file = ts_files_open_null();
		return r->file ? TS_OK
			       : ts_textfile_open_failed(&sim->error, &sim->files, where, "/dev/null");
	}
	if (!is_replaceable(&sim->files, path))
		return ts_fail(&sim->error, TS_IO, where, "cannot write '%s': it is not a regular file",
			       path);
	remove_stale(&sim->files, path);
	ts_str_add(&r->path, path);
	if (getrandom(&random, sizeof random, GRND_NONBLOCK) < 0)
		random = (uint64_t)(ts_clock() * 1e9);
	ts_str_addf(&r->temporary, "%s.tmp.%ld.%016" PRIx64, path, (long)getpid(), random);
	if (r->path.failed || r->temporary.failed) {
		ts_replace_abandon(r);
		return ts_nomem(&sim->error);
	}
	ts_mkdirs_for(&sim->files, path); /* an error shows when the file is opened */
	/* "x": a new file, never through an existing symbolic link */
	r->file = ts_files_open(&sim->files, ts_str_text(&r->temporary), "wx");
	if (!r->file) {
		enum ts_status status = ts_textfile_write_failed(&sim->error, &sim->files, where, path);

		ts_replace_abandon(r);
		return status;
	}
	return TS_OK;
}

enum ts_status ts_replace_write(struct ts_replace *r, const void *bytes, size_t n)
{
	errno = 0;
	return fwrite(bytes, 1, n, r->file) == n ? TS_OK : report_write_error(r);
}

/* The new name is durable once the folder is on the disk. Not all file systems support this: errors are
 * ignored. */
static void sync_folder(struct ts_files *files, const char *path)
{
	struct ts_str folder = { 0 };

	if (folder_of(path, &folder) == TS_OK)
		ts_files_sync_folder(files, ts_str_text(&folder));
	ts_str_release(&folder);
}

enum ts_status ts_replace_commit(struct ts_replace *r, bool durable)
{
	FILE *file = r->file;
	bool nowhere = !r->temporary.length;

	errno = 0;
	if (fflush(file) != 0 ||
	    (durable && !nowhere && ts_files_sync(&r->sim->files, ts_str_text(&r->temporary), file) != 0))
		return report_write_error(r);
	r->file = NULL;
	if (fclose(file) != 0 || (!nowhere && ts_files_move(&r->sim->files, ts_str_text(&r->temporary),
							    ts_str_text(&r->path)) != 0)) {
		report_write_error(r);
		return TS_IO;
	}
	ts_str_clear(&r->temporary);
	if (durable && !nowhere)
		sync_folder(&r->sim->files, ts_str_text(&r->path));
	ts_replace_abandon(r);
	return TS_OK;
}

void ts_replace_abandon(struct ts_replace *r)
{
	if (r->file)
		fclose(r->file);
	if (r->temporary.length)
		ts_files_remove(&r->sim->files, ts_str_text(&r->temporary));
	ts_str_release(&r->path);
	ts_str_release(&r->temporary);
	*r = (struct ts_replace){ 0 };
}
