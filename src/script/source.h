/* Source of script lines: a file, a stream such as standard input, or a string. */
#ifndef TS_SCRIPT_SOURCE_H
#define TS_SCRIPT_SOURCE_H

#include <stdbool.h>
#include <stdio.h>

#include "script/line.h"

struct tsim;

struct ts_source_label {
	const char *name;
	size_t at; /* offset of the line behind it, bytes */
	int line;  /* number of its line */
};

/* All text read is stored, so that `jump SELF` works with a pipe, too. */
struct ts_source {
	struct ts_source *outer; /* the script that has included this one, or NULL */
	const char *name;	 /* owned by sim->pool */
	struct ts_str text;
	size_t at; /* offset of the next line, bytes */
	int line;  /* number of lines before it */
	FILE *stream;
	bool owns_stream;
	struct ts_source_label *label; /* labels found so far, in the order of the file */
	size_t nlabels, label_capacity;
};

enum ts_status ts_source_open(struct ts_source *source, struct tsim *sim, const char *path,
			      const struct ts_place *where);
enum ts_status ts_source_stream(struct ts_source *source, struct tsim *sim, FILE *stream, const char *name);
enum ts_status ts_source_string(struct ts_source *source, struct tsim *sim, const char *text,
				const char *name);
void ts_source_rewind(struct ts_source *source);
/* Records that the line just read has this label. */
enum ts_status ts_source_add_label(struct ts_source *source, struct tsim *sim, const char *label);
/* Moves behind the label if it is known, else behind the last known label, from where lines must be
 * searched; returns whether it is known. */
bool ts_source_seek_label(struct ts_source *source, const char *label);
void ts_source_set_position(struct ts_source *source, size_t at, int line);
/* Reads the rest of the stream into `text`. */
enum ts_status ts_source_read_all(struct ts_source *source, struct tsim *sim);
void ts_source_close(struct ts_source *source);

/* The next logical line, before substitution; *end: there is none. */
enum ts_status ts_source_line(struct ts_source *source, struct tsim *sim, struct ts_line *line, bool *end);

#endif
