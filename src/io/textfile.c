#include "io/textfile.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>
#include <zlib.h>

#include "base/banned.h"

enum { LONGEST_WRITE = 1 << 30 }; /* gzwrite takes an unsigned int */

enum ts_status ts_open_failed(struct ts_error *err, const struct ts_place *where, const char *path)
{
	int code = errno;
	const char *slash = strrchr(path, '/');

	if (code == ENOENT && slash && slash > path)
		return ts_fail(err, TS_IO, where,
			       "cannot open '%s': there is no folder '%.*s'; create it with: shell "
			       "mkdir %.*s",
			       path, (int)(slash - path), path, (int)(slash - path), path);
	return ts_fail(err, TS_IO, where, "cannot open '%s': %s", path, strerror(code));
}

enum ts_status ts_textfile_open(struct ts_textfile *file, struct tsim *sim,
				const struct ts_place *where, const char *path, bool append)
{
	const char *target = sim->explain ? "/dev/null" : path;
	bool gz = ts_ends_with(path, ".gz");

	ts_textfile_close(file);
	file->err = &sim->error;
	file->where = where ? *where : (struct ts_place){ 0 };
	file->path = ts_strdup(path);
	if (!file->path)
		return ts_nomem(&sim->error);
	errno = 0;
	if (gz)
		file->gz = gzopen(target, append ? "ab" : "wb");
	else
		file->plain = fopen(target, append ? "a" : "w");
	if (ts_textfile_is_open(file))
		return TS_OK;
	ts_free(file->path);
	file->path = NULL;
	return errno ? ts_open_failed(&sim->error, where, path) : ts_nomem(&sim->error);
}

bool ts_textfile_is_open(const struct ts_textfile *file)
{
	return file->plain || file->gz;
}

static enum ts_status write_failed(struct ts_textfile *file)
{
	int code = errno;

	return ts_fail(file->err, TS_IO, &file->where, "writing '%s' failed: %s", file->path,
		       code ? strerror(code) : "unknown reason");
}

enum ts_status ts_textfile_write(struct ts_textfile *file, const char *bytes, size_t n)
{
	errno = 0;
	if (file->plain)
		return fwrite(bytes, 1, n, file->plain) == n ? TS_OK : write_failed(file);
	while (n) {
		unsigned part = n < LONGEST_WRITE ? (unsigned)n : LONGEST_WRITE;

		if (gzwrite(file->gz, bytes, part) != (int)part)
			return write_failed(file);
		bytes += part;
		n -= part;
	}
	return TS_OK;
}

enum ts_status ts_textfile_printf(struct ts_textfile *file, const char *format, ...)
{
	struct ts_str text = { 0 };
	enum ts_status status;
	va_list args;

	va_start(args, format);
	ts_str_vaddf(&text, format, args);
	va_end(args);
	status = text.failed ? ts_nomem(file->err)
			     : ts_textfile_write(file, ts_str_text(&text), text.length);
	ts_str_release(&text);
	return status;
}

enum ts_status ts_textfile_flush(struct ts_textfile *file)
{
	errno = 0;
	if (file->plain && fflush(file->plain) != 0)
		return write_failed(file);
	if (file->gz && gzflush(file->gz, Z_SYNC_FLUSH) != Z_OK)
		return write_failed(file);
	return TS_OK;
}

enum ts_status ts_textfile_close(struct ts_textfile *file)
{
	enum ts_status status = TS_OK;

	errno = 0;
	if (file->plain && fclose(file->plain) != 0)
		status = write_failed(file);
	if (file->gz && gzclose(file->gz) != Z_OK)
		status = write_failed(file);
	ts_free(file->path);
	*file = (struct ts_textfile){ 0 };
	return status;
}

void ts_step_path(struct ts_str *out, const char *path, long long step, int pad)
{
	ts_str_clear(out);
	for (const char *star; (star = strchr(path, '*')); path = star + 1) {
		ts_str_add_n(out, path, (size_t)(star - path));
		ts_str_addf(out, "%0*lld", pad, step);
	}
	ts_str_add(out, path);
}
