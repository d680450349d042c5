/* Output streams for text, compressed where the name ends in .gz. What is written between two flushes goes
 * to the system in one piece unless it is large, and if it does not fit on the disk the file ends before
 * it: a frame of a dump is there or not. A .gz file is flushed in the same way, so that what a killed run
 * leaves can be unpacked up to its last whole frame. Every failed write is reported. */
#ifndef TS_IO_TEXTFILE_H
#define TS_IO_TEXTFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/status.h"
#include "core/sim.h"

/* Zero-initialise. */
struct ts_textfile {
	FILE *file;	    /* not buffered */
	void *gz;	    /* z_stream, where the name ends in .gz */
	struct ts_str held; /* what waits for the next flush, as it will be in the file */
	int64_t whole;	    /* length of the file at the last flush; -1: not known */
	size_t member;	    /* bytes of text in this member of a .gz file */
	char *path;
	struct ts_error *err;
	struct ts_files *files;
	struct ts_place where; /* blamed for later errors */
};

/* Writes anew or appends. Makes the folders that lead to it. With -explain all goes nowhere. */
enum ts_status ts_textfile_open(struct ts_textfile *file, struct tsim *sim, const struct ts_place *where,
				const char *path, bool append);
bool ts_textfile_is_open(const struct ts_textfile *file);
enum ts_status ts_textfile_write(struct ts_textfile *file, const char *bytes, size_t n);
enum ts_status ts_textfile_printf(struct ts_textfile *file, const char *format, ...)
	__attribute__((format(printf, 2, 3)));
/* Hands all written so far to the system: it survives the end of this process, however it comes. A file
 * ends with what was flushed last. */
enum ts_status ts_textfile_flush(struct ts_textfile *file);
enum ts_status ts_textfile_close(struct ts_textfile *file);

/* "cannot write PATH: reason", and of a file that is read; they tell what is wrong with the folder. Use
 * errno. */
enum ts_status ts_write_failed(struct ts_error *err, struct ts_files *files, const struct ts_place *where,
			       const char *path);
enum ts_status ts_open_failed(struct ts_error *err, struct ts_files *files, const struct ts_place *where,
			      const char *path);

/* The path with each `*` replaced by the step, filled with zeros to `pad` digits. */
void ts_step_path(struct ts_str *out, const char *path, long long step, int pad);

#endif
