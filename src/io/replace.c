#include "io/replace.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/textfile.h"

#include "base/banned.h"

static enum ts_status failed(struct ts_replace *r)
{
	int code = errno;
	enum ts_status status =
		ts_fail(r->err, TS_IO, &r->where, "writing '%s' failed: %s", ts_str_text(&r->path),
			code ? strerror(code) : "unknown reason");

	ts_replace_abandon(r);
	return status;
}

/* Renaming onto a device or a pipe would put a plain file in its place. */
static bool replaceable(const char *path)
{
	struct stat there;

	return stat(path, &there) != 0 || S_ISREG(there.st_mode);
}

enum ts_status ts_replace_begin(struct ts_replace *r, struct ts_error *err,
				const struct ts_place *where, const char *path)
{
	ts_replace_abandon(r);
	if (!replaceable(path))
		return ts_fail(err, TS_IO, where, "cannot write '%s': it is not a plain file",
			       path);
	r->err = err;
	r->where = where ? *where : (struct ts_place){ 0 };
	ts_str_add(&r->path, path);
	ts_str_addf(&r->temporary, "%s.tmp.%ld", path, (long)getpid());
	if (r->path.failed || r->temporary.failed) {
		ts_replace_abandon(r);
		return ts_nomem(err);
	}
	r->file = fopen(ts_str_text(&r->temporary), "wb");
	if (!r->file) {
		enum ts_status status = ts_open_failed(err, where, path);

		ts_replace_abandon(r);
		return status;
	}
	return TS_OK;
}

enum ts_status ts_replace_write(struct ts_replace *r, const void *bytes, size_t n)
{
	errno = 0;
	return fwrite(bytes, 1, n, r->file) == n ? TS_OK : failed(r);
}

enum ts_status ts_replace_commit(struct ts_replace *r, bool durable)
{
	FILE *file = r->file;

	errno = 0;
	if (fflush(file) != 0 || (durable && fsync(fileno(file)) != 0))
		return failed(r);
	r->file = NULL;
	if (fclose(file) != 0 || rename(ts_str_text(&r->temporary), ts_str_text(&r->path)) != 0) {
		failed(r);
		return TS_IO;
	}
	ts_str_clear(&r->temporary);
	ts_replace_abandon(r);
	return TS_OK;
}

void ts_replace_abandon(struct ts_replace *r)
{
	if (r->file)
		fclose(r->file);
	if (r->temporary.length)
		unlink(ts_str_text(&r->temporary));
	ts_str_release(&r->path);
	ts_str_release(&r->temporary);
	*r = (struct ts_replace){ 0 };
}
