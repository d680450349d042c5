/* What the readers of mesh files share: the bytes of a file, taken word by word or in binary. */
#ifndef TS_MESH_MESH_SCAN_H
#define TS_MESH_MESH_SCAN_H

#include <stdbool.h>

#include "mesh/mesh_read.h"

struct ts_scan {
	struct ts_error *err;
	struct ts_pool *pool; /* for the texts of places */
	const char *file;     /* its name, in the pool */
	const char *bytes;
	char *owned; /* the same, if the scan has to free them */
	size_t n, at;
	struct ts_files *files;
	bool comments; /* `#` hides the rest of a line */
	bool binary;   /* messages count bytes, not lines */
	/* the last word */
	const char *word;
	size_t length, line_start;
	int line; /* from 1 */
};

/* Zero-initialise. The whole file is read. */
enum ts_status ts_scan_open(struct ts_scan *s, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path);
enum ts_status ts_scan_memory(struct ts_scan *s, struct ts_error *err, struct ts_pool *pool, const char *name,
			      const char *bytes, size_t n);
void ts_scan_close(struct ts_scan *s);

/* TS_STOPPED if someone asked for it. */
enum ts_status ts_scan_go_on(struct ts_scan *s);
/* The next word, or false: at the end of the file; of the line, of which the end is not passed. */
bool ts_scan_word(struct ts_scan *s);
bool ts_scan_word_in_line(struct ts_scan *s);
/* The rest of the line without blanks around it, in the pool; NULL: out of memory. */
const char *ts_scan_rest(struct ts_scan *s);
/* Is the last word this one, in whatever case? */
bool ts_scan_is(const struct ts_scan *s, const char *text);

/* A message about the last word. */
struct ts_place ts_scan_place(const struct ts_scan *s);
#define ts_scan_fail(s, code, ...) \
	ts_fail((s)->err, code, (struct ts_place[]){ ts_scan_place(s) }, __VA_ARGS__)
/* A message about the file as a whole. */
#define ts_scan_refuse(s, code, ...) \
	ts_fail((s)->err, code, (struct ts_place[]){ { .file = (s)->file } }, __VA_ARGS__)
/* "'word'" or "the end of the file", for messages: what was found. */
struct ts_scan_found {
	char text[48];
};
struct ts_scan_found ts_scan_found(const struct ts_scan *s);

/* The last word as a number, or the next one; `what` names it in the complaint. */
enum ts_status ts_scan_this_real(struct ts_scan *s, const char *what, double *out);
enum ts_status ts_scan_real(struct ts_scan *s, const char *what, double *out);
enum ts_status ts_scan_this_int(struct ts_scan *s, const char *what, int64_t lo, int64_t hi, int64_t *out);
enum ts_status ts_scan_int(struct ts_scan *s, const char *what, int64_t lo, int64_t hi, int64_t *out);
/* The next word must be this one. */
enum ts_status ts_scan_expect(struct ts_scan *s, const char *text);

#endif
