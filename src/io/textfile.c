#include "io/textfile.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/mkdirs.h"

#include "base/banned.h"

/* Bytes. MOST_HELD: largest text between two flushes that is written in one piece; PIECE: of files that are replaced as a
 * whole. MEMBER: text after which a .gz file begins a new member. LARGEST_PART: what zlib takes in one call. ROOM: output
 * buffer of zlib. */
enum { MOST_HELD = 1 << 24, PIECE = 1 << 18, MEMBER = 1 << 20, LARGEST_PART = 1 << 30, ROOM = 1 << 16 };

static void reset_textfile(struct ts_textfile *file)
{
	if (file->gz)
		deflateEnd(file->gz);
	ts_replace_abandon(&file->replace);
	ts_free(file->gz);
	ts_str_release(&file->held);
	ts_free(file->path);
	*file = (struct ts_textfile){ 0 };
}

/* ---- appending to a file of a run that was killed */

/* Ends an incomplete last line. The mark " ..." is one word more than a row of a dump has, so that readers
 * do not take a number that was cut off for a complete one. */
static void end_incomplete_line(struct ts_textfile *file, const char *path)
{
	FILE *old = ts_files_open(file->files, path, "r");

	if (old && fseek(old, -1, SEEK_END) == 0 && getc(old) != '\n')
		ts_str_add(&file->held, " ...\n");
	if (old)
		fclose(old);
}

/* Cuts off an incomplete last line of a table, in which a mark would count as a value. */
static void cut_incomplete_line(struct ts_textfile *file, const char *path)
{
	FILE *old = ts_files_open(file->files, path, "r");
	int64_t end = file->whole;

	while (old && end > 0 && fseek(old, (long)end - 1, SEEK_SET) == 0 && getc(old) != '\n')
		end--;
	if (old)
		fclose(old);
	if (end == file->whole)
		return;
	if (ftruncate(fileno(file->file), (off_t)end) != 0)
		errno = 0; /* the line stays; of several processes only the first one has the file */
	file->whole = ts_files_length(file->files, file->file);
}

/* Appending to a .gz file is refused if its compressed data are cut off. */
static enum ts_status check_gz(struct ts_textfile *file, const char *path)
{
	gzFile old = ts_files_open_gz(file->files, path);
	char bytes[1 << 14];
	int got = 1, code = Z_OK;

	while (old && got > 0)
		got = gzread(old, bytes, sizeof bytes);
	if (old)
		gzerror(old, &code);
	if (old)
		gzclose(old);
	if (code == Z_OK || code == Z_STREAM_END)
		return TS_OK;
	return ts_fail(file->err, TS_DAMAGED, &file->where,
		       "cannot append to '%s': its compressed data are cut off, as by a run that was killed, "
		       "and appended text could not be uncompressed; write to another file (rerun takes "
		       "several), or repair it: zcat %s | gzip >NEW",
		       path, path);
}

/* ---- opening */

static enum ts_status begin_gz(struct ts_textfile *file)
{
	z_stream *gz = ts_alloc(1, sizeof *gz);

	if (gz &&
	    deflateInit2(gz, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK) {
		file->gz = gz;
		return TS_OK;
	}
	ts_free(gz);
	return ts_nomem(file->err);
}

/* Whether the file is none yet, or one that may be replaced by another: a symbolic link stays. */
static bool replaceable(struct ts_textfile *file, const char *path)
{
	struct stat info;

	if (ts_files_stat(file->files, path, &info) != 0)
		return errno == ENOENT && !ts_files_is_link(file->files, path);
	return S_ISREG(info.st_mode) && info.st_nlink == 1 && info.st_mode & S_IWUSR &&
	       !ts_files_is_link(file->files, path);
}

static enum ts_status open_replacing(struct ts_textfile *file, struct tsim *sim, const char *path)
{
	TS_TRY(ts_replace_begin(&file->replace, sim, &file->where, path));
	file->file = file->replace.file;
	file->whole = -1;
	setvbuf(file->file, NULL, _IONBF, 0);
	return TS_OK;
}

static enum ts_status open_stream(struct ts_textfile *file, const struct tsim *sim, const char *path,
				  bool append)
{
	file->file = sim->reading.explain ? ts_files_open_null()
					  : ts_files_open(file->files, path, append ? "a" : "w");
	if (!file->file)
		return errno ? ts_textfile_write_failed(file->err, file->files, &file->where, path)
			     : ts_nomem(file->err);
	setvbuf(file->file, NULL, _IONBF, 0);
	file->whole = ts_files_length(sim->reading.explain ? NULL : file->files, file->file);
	if (file->gz && append && file->whole > 0)
		return check_gz(file, path);
	if (append && file->whole > 0 && ts_ends_with(path, ".csv"))
		cut_incomplete_line(file, path);
	else if (append && file->whole > 0)
		end_incomplete_line(file, path);
	return TS_OK;
}

enum how { REPLACE, APPEND, WHOLE };

static enum ts_status open_file(struct ts_textfile *file, struct tsim *sim, const struct ts_place *where,
				const char *path, enum how how)
{
	enum ts_status status = TS_OK;

	ts_textfile_close(file);
	file->err = &sim->error;
	file->files = &sim->files;
	file->where = where ? *where : (struct ts_place){ 0 };
	file->path = ts_strdup(path);
	if (!file->path)
		return ts_nomem(&sim->error);
	if (!sim->reading.explain)
		ts_mkdirs_for(file->files, path); /* an error shows when the file is opened */
	if (ts_ends_with(path, ".gz"))
		status = begin_gz(file);
	errno = 0;
	if (status == TS_OK && how == WHOLE && !sim->reading.explain && replaceable(file, path))
		status = open_replacing(file, sim, path);
	else if (status == TS_OK)
		status = open_stream(file, sim, path, how == APPEND);
	if (status != TS_OK) {
		if (file->file && !file->replace.file)
			fclose(file->file);
		reset_textfile(file);
	}
	return status;
}

enum ts_status ts_textfile_choose(struct ts_error *err, const struct ts_place *where, const char *style,
				  const char *file, const char *append)
{
	if (!file || !append)
		return TS_OK;
	return ts_fail(err, TS_SYNTAX, where, "fix %s: expected either file or append, found both", style);
}

enum ts_status ts_textfile_open(struct ts_textfile *file, struct tsim *sim, const struct ts_place *where,
				const char *path, bool append)
{
	return open_file(file, sim, where, path, append ? APPEND : REPLACE);
}

enum ts_status ts_textfile_open_whole(struct ts_textfile *file, struct tsim *sim,
				      const struct ts_place *where, const char *path)
{
	return open_file(file, sim, where, path, WHOLE);
}

bool ts_textfile_is_open(const struct ts_textfile *file)
{
	return file->file;
}

/* ---- writing */

/* Truncates the file to its length at the last flush and reports the error. */
static enum ts_status undo_failed_write(struct ts_textfile *file)
{
	int code = errno;

	if (file->whole >= 0 && ftruncate(fileno(file->file), (off_t)file->whole) != 0)
		file->whole = -1;
	ts_str_clear(&file->held);
	errno = code;
	ts_fail(file->err, TS_IO, &file->where, "writing '%s' failed: %s", file->path,
		code ? ts_files_why(file->files) : "unknown reason");
	if (file->replace.file) { /* nothing may take the place of the file any more */
		ts_replace_abandon(&file->replace);
		file->file = NULL;
	}
	return TS_IO;
}

static enum ts_status write_held(struct ts_textfile *file)
{
	size_t n = file->held.length;

	if (file->held.failed)
		return ts_nomem(file->err);
	errno = 0;
	if (n && fwrite(file->held.text, 1, n, file->file) != n)
		return undo_failed_write(file);
	ts_str_clear(&file->held);
	if (n > MOST_HELD) /* free large buffers */
		ts_str_release(&file->held);
	return TS_OK;
}

/* Appends n compressed bytes to what is held. */
static enum ts_status compress_part(struct ts_textfile *file, const char *bytes, unsigned n, int flush)
{
	z_stream *gz = file->gz;
	char room[ROOM];

	gz->next_in = (z_const Bytef *)(uintptr_t)bytes;
	gz->avail_in = n;
	do {
		gz->next_out = (Bytef *)room;
		gz->avail_out = ROOM;
		if (deflate(gz, flush) == Z_STREAM_ERROR)
			return ts_fail(file->err, TS_IO, &file->where, "compressing '%s' failed", file->path);
		ts_str_add_n(&file->held, room, ROOM - gz->avail_out);
	} while (gz->avail_out == 0);
	return TS_OK;
}

enum ts_status ts_textfile_write(struct ts_textfile *file, const char *bytes, size_t n)
{
	file->member += file->gz ? n : 0;
	while (n) {
		size_t part = n < LARGEST_PART ? n : LARGEST_PART;

		if (file->gz)
			TS_TRY(compress_part(file, bytes, (unsigned)part, Z_NO_FLUSH));
		else
			ts_str_add_n(&file->held, bytes, part);
		if (file->held.length > (file->replace.file ? PIECE : MOST_HELD))
			TS_TRY(write_held(file));
		bytes += part;
		n -= part;
	}
	return file->held.failed ? ts_nomem(file->err) : TS_OK;
}

enum ts_status ts_textfile_printf(struct ts_textfile *file, const char *format, ...)
{
	struct ts_str text = { 0 };
	enum ts_status status;
	va_list args;

	va_start(args, format);
	ts_str_vaddf(&text, format, args);
	va_end(args);
	status = text.failed ? ts_nomem(file->err) : ts_textfile_write(file, ts_str_text(&text), text.length);
	ts_str_release(&text);
	return status;
}

/* Flushes zlib. A member of at least MEMBER bytes is ended, so that later damage of the file does not
 * affect it. */
static enum ts_status flush_gz(struct ts_textfile *file, bool close)
{
	if (!file->member)
		return TS_OK;
	close |= file->member >= MEMBER;
	TS_TRY(compress_part(file, "", 0, close ? Z_FINISH : Z_SYNC_FLUSH));
	if (close) {
		file->member = 0;
		deflateReset(file->gz);
	}
	return TS_OK;
}

enum ts_status ts_textfile_flush(struct ts_textfile *file)
{
	struct stat info;

	if (!file->file)
		return TS_OK;
	if (file->gz)
		TS_TRY(flush_gz(file, false));
	TS_TRY(write_held(file));
	if (file->whole >= 0 && fstat(fileno(file->file), &info) == 0)
		file->whole = info.st_size;
	return TS_OK;
}

enum ts_status ts_textfile_close(struct ts_textfile *file)
{
	enum ts_status status = TS_OK;

	if (!file->file) {
		reset_textfile(file);
		return TS_OK;
	}
	if (file->gz)
		status = flush_gz(file, true);
	if (status == TS_OK)
		status = write_held(file);
	errno = 0;
	if (file->replace.file) {
		if (status == TS_OK)
			status = ts_replace_commit(&file->replace, false);
	} else if (file->file && fclose(file->file) != 0 && status == TS_OK) {
		file->whole = -1;
		status = undo_failed_write(file);
	}
	reset_textfile(file);
	return status;
}
