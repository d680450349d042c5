#include "base/files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/files_peers.h"
#include "base/script_folders.h"

#include "base/banned.h"

enum { ENTRY_BYTES = 4096 }; /* disk space charged for a new directory entry */

struct ts_files_own {
	dev_t device;
	ino_t number;
};

bool ts_files_closed(const struct ts_files *files)
{
	return files && files->closed;
}

/* ---- names */

bool ts_files_below(const char *path, const char *folder)
{
	size_t n = strlen(folder);

	return strncmp(path, folder, n) == 0 && (!path[n] || path[n] == '/' || ts_streq(folder, "/"));
}

static int fail_nomem(void)
{
	errno = ENOMEM;
	return -1;
}

static int resolve_real(const char *path, struct ts_str *out)
{
	char real[PATH_MAX];

	if (!realpath(*path ? path : ".", real))
		return -1;
	ts_str_clear(out);
	ts_str_add(out, real);
	return out->failed ? fail_nomem() : 0;
}

/* Splits a path into the folder and the last name. */
static void split_path(const char *path, struct ts_str *folder, struct ts_str *name)
{
	size_t n = strlen(path), at;

	while (n > 1 && path[n - 1] == '/')
		n--;
	at = n;
	while (at && path[at - 1] != '/')
		at--;
	ts_str_add_n(name, path + at, n - at);
	ts_str_add_n(folder, path, at);
	if (!at)
		ts_str_add(folder, ".");
}

static int resolve_missing(const char *path, struct ts_str *out)
{
	struct ts_str folder = { 0 }, name = { 0 };
	struct stat info;
	int result = -1;

	split_path(path, &folder, &name);
	if (folder.failed || name.failed)
		fail_nomem();
	else if (lstat(path, &info) == 0)
		errno = ELOOP; /* a dangling link */
	else if (ts_streq(ts_str_text(&name), "..") || !name.length)
		errno = ENOENT;
	else
		result = ts_files_resolve(ts_str_text(&folder), out);
	if (result == 0 && !ts_streq(ts_str_text(&name), "."))
		ts_str_addf(out, "%s%s", ts_streq(ts_str_text(out), "/") ? "" : "/", ts_str_text(&name));
	ts_str_release(&folder);
	ts_str_release(&name);
	return result == 0 && out->failed ? fail_nomem() : result;
}

int ts_files_resolve(const char *path, struct ts_str *out)
{
	if (resolve_real(path, out) == 0)
		return 0;
	return errno == ENOENT ? resolve_missing(path, out) : -1;
}

int ts_files_resolve_name(const char *path, struct ts_str *out)
{
	struct ts_str folder = { 0 }, name = { 0 };
	const char *last;
	int result;

	split_path(path, &folder, &name);
	last = ts_str_text(&name);
	if (folder.failed || name.failed)
		result = fail_nomem();
	else if (!*last || ts_streq(last, ".") || ts_streq(last, ".."))
		result = ts_files_resolve(path, out);
	else if ((result = ts_files_resolve(ts_str_text(&folder), out)) == 0)
		ts_str_addf(out, "%s%s", ts_streq(ts_str_text(out), "/") ? "" : "/", last);
	ts_str_release(&folder);
	ts_str_release(&name);
	return result == 0 && out->failed ? fail_nomem() : result;
}

/* ---- access control */

static void clear_reason(struct ts_files *files)
{
	if (files)
		files->why[0] = '\0';
}

static int refuse(struct ts_files *files, const char *reason)
{
	snprintf(files->why, sizeof files->why, "%s", reason);
	errno = EACCES;
	return -1;
}

const char *ts_files_why(const struct ts_files *files)
{
	if (ts_files_closed(files) && errno == EDQUOT)
		return "the script has written all that -sandbox allows (-sandbox disk)";
	return ts_files_closed(files) && errno == EACCES && files->why[0] ? files->why : strerror(errno);
}

static int refuse_path(struct ts_files *files, bool writes)
{
	struct ts_str text = { 0 };
	const char *between = " ";

	ts_str_addf(&text, "with -sandbox a script %s only below", writes ? "writes" : "reads");
	for (int k = 0; k < files->n; k++) {
		if (files->root[k].writes != writes)
			continue;
		ts_str_addf(&text, "%s'%s'", between, files->root[k].path);
		between = " and ";
	}
	ts_str_add(&text, writes ? "" : ", and what it has written itself");
	refuse(files, ts_str_text(&text));
	ts_str_release(&text);
	return -1;
}

static const struct ts_files_root *find_root(const struct ts_files *files, const char *path, bool writes)
{
	for (int k = 0; k < files->n; k++)
		if (files->root[k].writes == writes && ts_files_below(path, files->root[k].path))
			return &files->root[k];
	return NULL;
}

/* Opens the folder of a resolved path, component by component from the root, without following links:
 * so nobody can insert a link after the path was resolved. *name: last component; "." if the path is
 * the root itself. */
static int open_folder_of(const struct ts_files_root *root, const char *path, const char **name)
{
	const char *rest = path + strlen(root->path);
	int at = fcntl(root->folder, F_DUPFD_CLOEXEC, 0), next;
	char part[NAME_MAX + 1];

	*name = ".";
	while (at >= 0) {
		size_t n;

		rest += strspn(rest, "/");
		n = strcspn(rest, "/");
		if (!rest[n]) {
			*name = *rest ? rest : ".";
			return at;
		}
		if (n > NAME_MAX) {
			errno = ENAMETOOLONG;
			next = -1;
		} else {
			memcpy(part, rest, n);
			part[n] = '\0';
			next = openat(at, part, O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
		}
		close(at);
		at = next;
		rest += n;
	}
	return -1;
}

enum access { ACCESS_READ, ACCESS_WRITE, ACCESS_STAT }; /* stat is allowed wherever reading or writing is */

/* Open folder and name for an operation. */
struct entry {
	int folder;
	const char *name;
	struct ts_str path;
	bool read_root;
};

static int entry_open(struct ts_files *files, const char *path, bool follow, enum access access,
		      struct entry *e)
{
	const struct ts_files_root *root;

	*e = (struct entry){ .folder = -1 };
	clear_reason(files);
	if ((follow ? ts_files_resolve : ts_files_resolve_name)(path, &e->path) != 0)
		return -1;
	root = find_root(files, ts_str_text(&e->path), access == ACCESS_WRITE);
	e->read_root = root && !root->writes;
	if (!root && access != ACCESS_WRITE) /* folders for writing may be inspected, and own files read */
		root = find_root(files, ts_str_text(&e->path), true);
	if (!root)
		return refuse_path(files, access == ACCESS_WRITE);
	e->folder = open_folder_of(root, ts_str_text(&e->path), &e->name);
	return e->folder < 0 ? -1 : 0;
}

static int entry_close(struct entry *e, int result)
{
	int code = errno;

	if (e->folder >= 0)
		close(e->folder);
	ts_str_release(&e->path);
	errno = code;
	return result;
}

/* ---- accounting of writes */

/* Charges written bytes; fails when the limit is reached. */
static int charge_bytes(struct ts_files *files, int64_t bytes)
{
	if (bytes > files->most - files->written) {
		errno = EDQUOT;
		return -1;
	}
	files->written += bytes;
	return 0;
}

static bool is_own(const struct ts_files *files, const struct stat *info)
{
	for (size_t k = 0; k < files->nown; k++)
		if (files->own[k].device == info->st_dev && files->own[k].number == info->st_ino)
			return true;
	return false;
}

static int record_own(struct ts_files *files, const struct stat *info)
{
	if (is_own(files, info))
		return 0;
	if (TS_GROW(files->own, files->own_capacity, files->nown + 1) != TS_OK)
		return fail_nomem();
	files->own[files->nown++] = (struct ts_files_own){ info->st_dev, info->st_ino };
	return 0;
}

/* Refuses hard links, which may lie anywhere, and anything but plain files. */
static int check_plain_file(struct ts_files *files, int descriptor, struct stat *info)
{
	if (fstat(descriptor, info) != 0)
		return -1;
	if (S_ISDIR(info->st_mode)) {
		errno = EISDIR;
		return -1;
	}
	if (!S_ISREG(info->st_mode))
		return refuse(files, "with -sandbox a script opens plain files only");
	if (info->st_nlink > 1)
		return refuse(files, "the file has other names (hard links), which may lie anywhere; with "
				     "-sandbox a script does not open it");
	return 0;
}

struct stream {
	struct ts_files *files;
	int descriptor;
};

static ssize_t stream_write(void *cookie, const char *bytes, size_t n)
{
	struct stream *s = cookie;
	size_t done = 0;

	if (charge_bytes(s->files, (int64_t)n) != 0)
		return 0;
	while (done < n) {
		ssize_t got = write(s->descriptor, bytes + done, n - done);

		if (got < 0 && errno == EINTR)
			continue;
		if (got <= 0)
			break;
		done += (size_t)got;
	}
	return (ssize_t)done;
}

static int stream_close(void *cookie)
{
	struct stream *s = cookie;
	int result = close(s->descriptor);

	ts_free(s);
	return result;
}

static FILE *open_counted_stream(struct ts_files *files, int descriptor)
{
	static const cookie_io_functions_t functions = { .write = stream_write, .close = stream_close };
	struct stream *s = ts_alloc(1, sizeof *s);
	FILE *file = NULL;

	if (s) {
		*s = (struct stream){ files, descriptor };
		file = fopencookie(s, "w", functions);
	}
	if (!file) {
		ts_free(s);
		close(descriptor);
		errno = ENOMEM;
	}
	return file;
}

static int open_to_write(struct ts_files *files, const struct entry *e, const char *mode)
{
	int flags = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | (mode[0] == 'a' ? O_APPEND : 0);
	bool anew = mode[0] == 'w';
	struct stat info;
	int descriptor = strchr(mode, 'x') ? -1 : openat(e->folder, e->name, flags);

	if (strchr(mode, 'x') || (descriptor < 0 && errno == ENOENT)) {
		if (charge_bytes(files, ENTRY_BYTES) != 0)
			return -1;
		descriptor = openat(e->folder, e->name, flags | O_CREAT | O_EXCL, 0666);
		anew = true;
	}
	if (descriptor < 0)
		return -1;
	if (check_plain_file(files, descriptor, &info) == 0 &&
	    (mode[0] != 'w' || ftruncate(descriptor, 0) == 0) && (!anew || record_own(files, &info) == 0))
		return descriptor;
	close(descriptor);
	return -1;
}

static int open_to_read(struct ts_files *files, const struct entry *e)
{
	int descriptor = openat(e->folder, e->name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
	struct stat info;

	if (descriptor < 0)
		return -1;
	if (check_plain_file(files, descriptor, &info) == 0 &&
	    (e->read_root || is_own(files, &info) || refuse_path(files, false) == 0))
		return descriptor;
	close(descriptor);
	return -1;
}

/* ---- operations */

/* Opens a file in the sandbox; -1 and errno. */
static int open_within(struct ts_files *files, const char *path, const char *mode)
{
	bool writes = mode[0] != 'r';
	struct entry e;
	int result = entry_open(files, path, !strchr(mode, 'x'), writes ? ACCESS_WRITE : ACCESS_READ, &e);

	if (result == 0)
		result = writes ? open_to_write(files, &e, mode) : open_to_read(files, &e);
	return entry_close(&e, result);
}

FILE *ts_files_open(struct ts_files *files, const char *path, const char *mode)
{
	FILE *file;
	int descriptor;

	if (ts_peers(files))
		return ts_peers_open(files->peers, path, mode);
	if (!ts_files_closed(files))
		return fopen(path, mode);
	if (mode[0] != 'r' && ts_streq(path, "/dev/null"))
		return ts_files_open_null();
	descriptor = open_within(files, path, mode);
	if (descriptor < 0)
		return NULL;
	if (mode[0] != 'r')
		return open_counted_stream(files, descriptor);
	file = fdopen(descriptor, "r");
	if (!file)
		close(descriptor);
	return file;
}

FILE *ts_files_open_along(struct ts_files *files, const char *path)
{
	return ts_peers(files) ? ts_peers_open_along(files->peers, path) : ts_files_open(files, path, "r");
}

bool ts_files_stopped(const struct ts_files *files)
{
	return files && files->stop && *files->stop;
}

bool ts_files_shared(const struct ts_files *files)
{
	return ts_peers(files);
}

void *ts_files_open_gz(struct ts_files *files, const char *path)
{
	gzFile file;
	int descriptor;

	if (!ts_peers(files) && !ts_files_closed(files))
		return gzopen(path, "rb");
	descriptor =
		ts_peers(files) ? ts_peers_descriptor(files->peers, path) : open_within(files, path, "r");
	if (descriptor < 0)
		return NULL;
	file = gzdopen(descriptor, "rb");
	if (!file)
		close(descriptor);
	return file;
}

void *ts_files_open_gz_of(struct ts_files *files, const char *path, const char *script)
{
	struct ts_str beside = { 0 };
	void *file = ts_files_open_gz(files, path);

	if (!file && errno == ENOENT && script && ts_files_beside(files, &beside, script, path) &&
	    !beside.failed) {
		file = ts_files_open_gz(files, ts_str_text(&beside));
		if (!file)
			errno = ENOENT;
	}
	ts_str_release(&beside);
	return file;
}

FILE *ts_files_open_null(void)
{
	return fopen("/dev/null", "w");
}

void *ts_files_list(struct ts_files *files, const char *folder)
{
	struct entry e;
	DIR *list = NULL;
	int descriptor;

	if (ts_peers(files)) /* after what the first one has written so far */
		ts_peers_agree(files->peers, "list", 0);
	if (!ts_files_closed(files))
		return opendir(folder);
	descriptor = entry_open(files, folder, true, ACCESS_STAT, &e);
	if (descriptor == 0)
		descriptor = openat(e.folder, e.name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
	entry_close(&e, 0);
	if (descriptor >= 0)
		list = fdopendir(descriptor);
	if (descriptor >= 0 && !list)
		close(descriptor);
	return list;
}

int ts_files_stat(struct ts_files *files, const char *path, struct stat *out)
{
	struct entry e;
	int result;

	if (ts_peers(files))
		return ts_peers_stat(files->peers, path, out);
	if (!ts_files_closed(files))
		return stat(path, out);
	result = entry_open(files, path, true, ACCESS_STAT, &e);
	if (result == 0)
		result = fstatat(e.folder, e.name, out, AT_SYMLINK_NOFOLLOW);
	return entry_close(&e, result);
}

static bool is_link(const char *path)
{
	struct ts_str name = { 0 }, target = { 0 };
	bool is = ts_files_resolve_name(path, &name) != 0 || ts_files_resolve(path, &target) != 0 ||
		  !ts_streq(ts_str_text(&name), ts_str_text(&target));

	ts_str_release(&name);
	ts_str_release(&target);
	return is;
}

bool ts_files_is_link(const struct ts_files *files, const char *path)
{
	if (ts_peers(
		    files)) /* another one may look at the path when the first one is about to make the file */
		return ts_peers_agree(files->peers, "is_link", files->peers->first && is_link(path)) != 0;
	return is_link(path);
}

int64_t ts_files_length(const struct ts_files *files, FILE *file)
{
	struct stat info;
	int64_t length = -1;
	int descriptor = fileno(file);

	if (descriptor >= 0 && fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode))
		length = info.st_size;
	if (ts_peers(files))
		ts_peers_agree_on(files->peers, "length", 0, &length, sizeof length);
	return length;
}

bool ts_files_may_make_in(const struct ts_files *files, const char *folder)
{
	if (ts_peers(files))
		return ts_peers_agree(files->peers, "access", access(folder, W_OK | X_OK)) == 0;
	return ts_files_closed(files) || access(folder, W_OK | X_OK) == 0;
}

int ts_files_make_folder(struct ts_files *files, const char *path)
{
	struct entry e;
	int result;

	if (ts_peers(files))
		return ts_peers_agree(files->peers, "mkdir", files->peers->first ? mkdir(path, 0777) : 0);
	if (!ts_files_closed(files))
		return mkdir(path, 0777);
	result = entry_open(files, path, false, ACCESS_WRITE, &e);
	if (result == 0)
		result = charge_bytes(files, ENTRY_BYTES);
	if (result == 0)
		result = mkdirat(e.folder, e.name, 0777);
	return entry_close(&e, result);
}

static int unlink_entry(struct ts_files *files, const char *path, int flags)
{
	struct entry e;
	int result = entry_open(files, path, false, ACCESS_WRITE, &e);

	if (result == 0)
		result = unlinkat(e.folder, e.name, flags);
	return entry_close(&e, result);
}

int ts_files_remove(struct ts_files *files, const char *path)
{
	if (ts_peers(files))
		return ts_peers_agree(files->peers, "unlink", files->peers->first ? unlink(path) : 0);
	return ts_files_closed(files) ? unlink_entry(files, path, 0) : unlink(path);
}

int ts_files_remove_folder(struct ts_files *files, const char *path)
{
	if (ts_peers(files))
		return ts_peers_agree(files->peers, "rmdir", files->peers->first ? rmdir(path) : 0);
	return ts_files_closed(files) ? unlink_entry(files, path, AT_REMOVEDIR) : rmdir(path);
}

int ts_files_move(struct ts_files *files, const char *from, const char *to)
{
	struct entry old, new;
	int result;

	if (ts_peers(files))
		return ts_peers_agree(files->peers, "rename", files->peers->first ? rename(from, to) : 0);
	if (!ts_files_closed(files))
		return rename(from, to);
	result = entry_open(files, from, false, ACCESS_WRITE, &old);
	if (result != 0)
		return entry_close(&old, result);
	result = entry_open(files, to, false, ACCESS_WRITE, &new);
	if (result == 0)
		result = renameat(old.folder, old.name, new.folder, new.name);
	result = entry_close(&new, result);
	return entry_close(&old, result);
}

int ts_files_chdir(struct ts_files *files, const char *folder)
{
	struct entry e;
	int result, at = -1;

	ts_files_keep_script_folders(files);
	if (!ts_files_closed(files)) {
		result = chdir(folder);
		return ts_peers(files) ? ts_peers_agree(files->peers, "chdir", result) : result;
	}
	result = entry_open(files, folder, true, ACCESS_STAT, &e);
	if (result == 0)
		result = at = openat(e.folder, e.name, O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
	if (result >= 0)
		result = fchdir(at);
	result = entry_close(&e, result);
	if (at >= 0)
		close(at);
	return result;
}

/* The file is synchronised by its path, as a stream in the sandbox has no descriptor. */
int ts_files_sync(struct ts_files *files, const char *path, FILE *file)
{
	int descriptor, result;

	if (ts_peers(files))
		return ts_peers_agree(files->peers, "fsync", files->peers->first ? fsync(fileno(file)) : 0);
	if (!ts_files_closed(files))
		return fsync(fileno(file));
	descriptor = open_within(files, path, "r");
	result = descriptor < 0 ? -1 : fsync(descriptor);
	if (descriptor >= 0)
		close(descriptor);
	return result;
}

int ts_files_sync_folder(struct ts_files *files, const char *folder)
{
	DIR *list = ts_files_list(files, folder);
	int result = list ? fsync(dirfd(list)) : -1;

	if (list)
		closedir(list);
	return ts_peers(files) ? ts_peers_agree(files->peers, "fsync folder", result) : result;
}

double ts_files_free_space(struct ts_files *files, const char *path)
{
	struct stat info;
	struct statvfs fs;
	int result;

	if (ts_files_closed(files) && ts_files_stat(files, path, &info) != 0)
		return -1;
	result = statvfs(path, &fs);
	if (ts_peers(files))
		result = ts_peers_agree_on(files->peers, "statvfs", result, &fs, sizeof fs);
	return result == 0 ? (double)fs.f_frsize * (double)fs.f_bavail : -1;
}

/* ---- set-up and release */

int ts_files_admit(struct ts_files *files, const char *folder, bool writes)
{
	struct ts_files_root *root = &files->root[files->n];
	struct ts_str path = { 0 };

	if (files->n == TS_MOST_FOLDERS) {
		errno = ENFILE;
		return -1;
	}
	if (resolve_real(folder, &path) != 0) {
		ts_str_release(&path);
		return -1;
	}
	*root = (struct ts_files_root){ ts_strdup(ts_str_text(&path)), -1, writes };
	ts_str_release(&path);
	if (!root->path)
		return fail_nomem();
	root->folder = open(root->path, O_PATH | O_DIRECTORY | O_CLOEXEC);
	if (root->folder < 0) {
		ts_free(root->path);
		return -1;
	}
	files->n++;
	return 0;
}

void ts_files_close(struct ts_files *files, int64_t most_bytes)
{
	files->most = most_bytes;
	files->closed = true;
}

void ts_files_release(struct ts_files *files)
{
	for (int k = 0; k < files->n; k++) {
		close(files->root[k].folder);
		ts_free(files->root[k].path);
	}
	ts_free(files->own);
	ts_files_forget_scripts(files);
	*files = (struct ts_files){ 0 };
}
