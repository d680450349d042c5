/* Scanner for readers of mesh files: the bytes of a file, read word by word or in binary. */
#ifndef TS_MESH_MESH_SCAN_H
#define TS_MESH_MESH_SCAN_H

#include <stdbool.h>

#include "mesh/mesh_read.h"

struct ts_scan {
	struct ts_error *err;
	struct ts_pool *pool; /* owns the strings of places in messages */
	const char *file;     /* name of the file, in the pool */
	const char *bytes;    /* [n] */
	char *owned;	      /* the same, if the scanner must free them */
	size_t n, at;	      /* number of bytes; present position */
	struct ts_files *files;
	bool comments; /* `#` starts a comment up to the end of the line */
	bool binary;   /* messages give the position in bytes, not the line */
	/* the last word */
	const char *word;
	size_t length;	   /* bytes of the word; 0: none was found */
	size_t line_start; /* position of the first byte of the present line */
	int line;	   /* present line, from 1 */
};

/* Zero-initialise. Reads the whole file. */
enum ts_status ts_scan_open(struct ts_scan *s, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path);
enum ts_status ts_scan_memory(struct ts_scan *s, struct ts_error *err, struct ts_pool *pool, const char *name,
			      const char *bytes, size_t n);
void ts_scan_close(struct ts_scan *s);

/* Returns TS_STOPPED if a signal has requested a stop. */
enum ts_status ts_scan_check_stop(struct ts_scan *s);
/* Reads the next word of the file, or of the present line; false: there is none. ts_scan_word_in_line
 * stops before the end of the line. */
bool ts_scan_word(struct ts_scan *s);
bool ts_scan_word_in_line(struct ts_scan *s);
/* Reads the rest of the line and returns it, without blanks around it, in the pool; NULL: out of memory. */
const char *ts_scan_rest(struct ts_scan *s);
/* Whether the last word equals `text`, ignoring case. */
bool ts_scan_is(const struct ts_scan *s, const char *text);

/* Place of the last word, and a failure with a message there. */
struct ts_place ts_scan_place(const struct ts_scan *s);
#define ts_scan_fail(s, code, ...) \
	ts_fail((s)->err, code, (struct ts_place[]){ ts_scan_place(s) }, __VA_ARGS__)
/* A failure with a message about the file as a whole. */
#define ts_scan_refuse(s, code, ...) \
	ts_fail((s)->err, code, (struct ts_place[]){ { .file = (s)->file } }, __VA_ARGS__)
/* The last word for messages: "'word'" or "the end of the file". */
struct ts_scan_found {
	char text[48];
};
struct ts_scan_found ts_scan_found(const struct ts_scan *s);

/* Converts the last word (this) or the next one to a number; `what`: its name in error messages. */
enum ts_status ts_scan_this_real(struct ts_scan *s, const char *what, double *out);
enum ts_status ts_scan_real(struct ts_scan *s, const char *what, double *out);
enum ts_status ts_scan_this_int(struct ts_scan *s, const char *what, int64_t lo, int64_t hi, int64_t *out);
enum ts_status ts_scan_int(struct ts_scan *s, const char *what, int64_t lo, int64_t hi, int64_t *out);
/* Fails unless the next word equals `text`. */
enum ts_status ts_scan_expect(struct ts_scan *s, const char *text);

#endif
