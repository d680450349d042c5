#include "crosscheck/folder.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/mkdirs.h"
#include "base/sort.h"

#include "base/banned.h"

enum { COPY_BYTES = 1 << 16, DEEPEST = 30 };

static enum ts_status fail_errno(struct ts_error *err, const char *what, const char *path)
{
	int code = errno;

	return ts_fail(err, TS_IO, NULL, "cannot %s '%s': %s", what, path, strerror(code));
}

static bool is_folder(const char *path)
{
	struct stat info;

	return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

enum ts_status ts_folder_make(const char *path, struct ts_error *err)
{
	return ts_mkdirs(NULL, path) == 0 ? TS_OK : fail_errno(err, "create the folder", path);
}

enum ts_status ts_folder_new(const char *path, struct ts_error *err)
{
	if (is_folder(path))
		return ts_fail(err, TS_STATE, NULL, "folder '%s' exists; a new folder is required", path);
	return ts_folder_make(path, err);
}

enum ts_status ts_folder_scratch(struct ts_str *path, struct ts_error *err)
{
	const char *parent = getenv("TMPDIR");

	ts_str_clear(path);
	ts_str_addf(path, "%s/tsim-crosscheck-XXXXXX", parent && *parent ? parent : "/tmp");
	if (path->failed)
		return ts_nomem(err);
	return mkdtemp(path->text) ? TS_OK : fail_errno(err, "create the folder", path->text);
}

static bool copy_bytes(FILE *from, FILE *to)
{
	char bytes[COPY_BYTES];
	size_t n;

	do {
		n = fread(bytes, 1, sizeof bytes, from);
		if (fwrite(bytes, 1, n, to) != n)
			return false;
	} while (n == sizeof bytes);
	return !ferror(from);
}

enum ts_status ts_folder_copy(const char *from, const char *to, int64_t date, struct ts_error *err)
{
	struct timespec times[2] = { { .tv_sec = date }, { .tv_sec = date } };
	const char *slash = strrchr(to, '/');
	char *folder = ts_strdup(to);
	FILE *in, *out;
	bool good;

	if (!folder)
		return ts_nomem(err);
	folder[slash ? slash - to : 0] = '\0';
	if (folder[0] && ts_folder_make(folder, err) != TS_OK) {
		ts_free(folder);
		return err->status;
	}
	ts_free(folder);
	in = ts_files_open(NULL, from, "r");
	if (!in)
		return fail_errno(err, "read", from);
	out = ts_files_open(NULL, to, "w");
	good = out && copy_bytes(in, out);
	good &= out && fclose(out) == 0;
	fclose(in);
	return good && utimensat(AT_FDCWD, to, times, 0) == 0 ? TS_OK : fail_errno(err, "write", to);
}

static bool is_dots(const char *name)
{
	return ts_streq(name, ".") || ts_streq(name, "..");
}

/* Everything that is not a folder is unlinked; links are not followed. */
static void remove_tree(const char *path, int depth)
{
	DIR *folder = opendir(path);
	struct dirent *entry;

	while (folder && depth < DEEPEST && (entry = readdir(folder))) {
		struct ts_str name = { 0 };
		struct stat info;

		if (is_dots(entry->d_name))
			continue;
		ts_str_addf(&name, "%s/%s", path, entry->d_name);
		if (!name.failed && lstat(name.text, &info) == 0) {
			if (S_ISDIR(info.st_mode))
				remove_tree(name.text, depth + 1);
			else
				unlink(name.text);
		}
		ts_str_release(&name);
	}
	if (folder)
		closedir(folder);
	rmdir(path);
}

void ts_folder_remove(const char *path)
{
	remove_tree(path, 0);
}

/* Alphabetical, but "dump9" before "dump10". */
static int compare_names(const void *a, const void *b)
{
	const char *x = *(const char *const *)a, *y = *(const char *const *)b;

	while (*x && *y) {
		if (isdigit((unsigned char)*x) && isdigit((unsigned char)*y)) {
			size_t n, m;

			x += strspn(x, "0");
			y += strspn(y, "0");
			n = strspn(x, "0123456789");
			m = strspn(y, "0123456789");
			if (n != m)
				return n < m ? -1 : 1;
			for (; n; n--, x++, y++)
				if (*x != *y)
					return *x < *y ? -1 : 1;
			continue;
		}
		if (*x != *y)
			return *x < *y ? -1 : 1;
		x++;
		y++;
	}
	return (*x != '\0') - (*y != '\0');
}

struct search {
	const char *root;
	int64_t except;
	struct ts_listing *out;
	struct ts_pool *pool;
	struct ts_error *err;
};

static enum ts_status search_folder(const struct search *s, const char *inner, int depth);

/* Adds an entry of a folder to the list; `name` is relative to the root. */
static enum ts_status add_entry(const struct search *s, const char *name, int depth)
{
	struct ts_str path = { 0 };
	struct stat info;
	const char *kept;
	bool there;

	ts_str_addf(&path, "%s/%s", s->root, name);
	there = !path.failed && lstat(path.text, &info) == 0;
	ts_str_release(&path);
	if (there && S_ISDIR(info.st_mode))
		return depth < DEEPEST ? search_folder(s, name, depth + 1) : TS_OK;
	if (!there || !S_ISREG(info.st_mode) || info.st_mtim.tv_sec == s->except)
		return TS_OK;
	kept = ts_pool_get(s->pool, name);
	if (!kept || TS_GROW(s->out->name, s->out->capacity, s->out->n + 1) != TS_OK)
		return ts_nomem(s->err);
	s->out->name[s->out->n++] = kept;
	return TS_OK;
}

static enum ts_status search_folder(const struct search *s, const char *inner, int depth)
{
	struct ts_str name = { 0 };
	struct dirent *entry;
	enum ts_status status = TS_OK;
	DIR *folder;

	ts_str_addf(&name, "%s/%s", s->root, inner);
	folder = name.failed ? NULL : opendir(name.text);
	while (folder && status == TS_OK && (entry = readdir(folder))) {
		if (is_dots(entry->d_name))
			continue;
		ts_str_clear(&name);
		ts_str_addf(&name, "%s%s%s", inner, *inner ? "/" : "", entry->d_name);
		status = name.failed ? ts_nomem(s->err) : add_entry(s, ts_str_text(&name), depth);
	}
	if (folder)
		closedir(folder);
	ts_str_release(&name);
	return status;
}

enum ts_status ts_folder_list(const char *path, int64_t except, struct ts_listing *out, struct ts_pool *pool,
			      struct ts_error *err)
{
	struct search s = { path, except, out, pool, err };

	TS_TRY(search_folder(&s, "", 0));
	ts_sort(out->name, out->n, sizeof *out->name, compare_names);
	return TS_OK;
}
