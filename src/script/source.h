/* Where script lines come from: a file, a stream such as standard input, or a string. */
#ifndef TS_SCRIPT_SOURCE_H
#define TS_SCRIPT_SOURCE_H

#include <stdbool.h>
#include <stdio.h>

#include "script/line.h"

struct tsim;

/* What was read is kept, so that `jump SELF` works on a pipe too. */
struct ts_source {
	const char *name; /* in the string pool */
	struct ts_str text;
	size_t at; /* position of the next line */
	int line;  /* its number minus one */
	FILE *stream;
	bool owns_stream;
};

enum ts_status ts_source_open(struct ts_source *source, struct tsim *sim, const char *path,
			      const struct ts_place *where);
enum ts_status ts_source_stream(struct ts_source *source, struct tsim *sim, FILE *stream,
				const char *name);
enum ts_status ts_source_string(struct ts_source *source, struct tsim *sim, const char *text,
				const char *name);
void ts_source_rewind(struct ts_source *source);
void ts_source_close(struct ts_source *source);

/* The next logical line, as written; *end: there is none. */
enum ts_status ts_source_line(struct ts_source *source, struct tsim *sim, struct ts_line *line,
			      bool *end);

#endif
