/* Output streams for text, compressed if the name ends in .gz. The text between two flushes is written in
 * one piece unless it is larger than 16 MiB; if it does not fit on the disk, the file is truncated to its
 * length before: a frame of a dump is complete or missing. A file that is opened as a whole appears under its name when it
 * is closed, and only pieces of it are held. A .gz file is flushed in the same way, so that a
 * file of a killed run can be decompressed up to its last complete frame. All write errors are reported. */
#ifndef TS_IO_TEXTFILE_H
#define TS_IO_TEXTFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/status.h"
#include "core/sim.h"
#include "io/replace.h"

/* Zero-initialise. */
struct ts_textfile {
	FILE *file;	    /* unbuffered; NULL: not open */
	void *gz;	    /* z_stream of a .gz file; else NULL */
	struct ts_str held; /* bytes of the file that wait for the next flush, compressed in a .gz file */
	int64_t whole;	    /* length of the file at the last flush in bytes; -1: not known */
	size_t member;	    /* uncompressed bytes in the current member of a .gz file */
	struct ts_replace replace; /* of a file that is opened as a whole */
	char *path;
	struct ts_error *err;
	struct ts_files *files;
	struct ts_place where; /* line of the script, for messages */
};

/* Fails if a fix of this style is given both a file to replace and one to append to; NULL: not given. */
enum ts_status ts_textfile_choose(struct ts_error *err, const struct ts_place *where, const char *style,
				  const char *file, const char *append);
/* Opens a file to be replaced or appended to. Creates the folders of its path. With -explain the output is
 * discarded. */
enum ts_status ts_textfile_open(struct ts_textfile *file, struct tsim *sim, const struct ts_place *where,
				const char *path, bool append);
/* The same for a file that is written once: until it is closed it has another name, so that it is complete or missing
 * however large it is. What cannot be replaced, such as a device or a symbolic link, is written as by ts_textfile_open. */
enum ts_status ts_textfile_open_whole(struct ts_textfile *file, struct tsim *sim,
				      const struct ts_place *where, const char *path);
bool ts_textfile_is_open(const struct ts_textfile *file);
enum ts_status ts_textfile_write(struct ts_textfile *file, const char *bytes, size_t n);
enum ts_status ts_textfile_printf(struct ts_textfile *file, const char *format, ...)
	__attribute__((format(printf, 2, 3)));
/* Passes all text written so far to the operating system, so that it is kept if this process is killed. */
enum ts_status ts_textfile_flush(struct ts_textfile *file);
enum ts_status ts_textfile_close(struct ts_textfile *file);

/* Errors "cannot write PATH: reason" and "cannot open PATH: reason" from errno, which also tell what is
 * wrong with the folder. */
enum ts_status ts_textfile_write_failed(struct ts_error *err, struct ts_files *files,
					const struct ts_place *where, const char *path);
enum ts_status ts_textfile_open_failed(struct ts_error *err, struct ts_files *files,
				       const struct ts_place *where, const char *path);

#endif
