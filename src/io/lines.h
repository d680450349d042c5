/* Input of text, line by line: from a file, compressed with gzip or not, or from memory.
 * base/input_limit.h limits the length of lines and the uncompressed size of files. Error messages name
 * file, line and column. */
#ifndef TS_IO_LINES_H
#define TS_IO_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "base/files.h"
#include "base/words.h"

struct ts_pool;

/* Zero-initialise. */
struct ts_lines {
	struct ts_error *err;
	struct ts_pool *pool; /* for file names and lines in messages */
	const char *file;     /* name, in the pool */
	void *gz;	      /* gzFile; NULL: from memory, or along */
	FILE *along;	      /* of which no process has a copy; NULL: from memory, or gz */
	struct ts_files *files;
	double most_unfolded; /* limit of `unfolded` in bytes, base/input_limit.h */
	size_t longest;	      /* limit of the length of a line in bytes */
	double unfolded;      /* uncompressed bytes; the caller may set it to 0 */
	bool commas;	      /* separate words like blanks; the caller may set it */
	bool may_be_torn;     /* a compressed file that is cut off is read up to its end, without an error */
	bool torn;	      /* it was cut off */
	const char *chunk;    /* bytes that are not yet split into lines: chunk[at] .. chunk[end - 1] */
	char *buffer;
	size_t at, end;
	/* the current line */
	int number;
	bool ended; /* by a line feed; false: by the end of the file */
	char *line;
	size_t length, capacity;
	char **word; /* [nwords] separated by blanks, without the comment */
	size_t nwords, word_capacity;
	const char *comment; /* text after `#` without leading blanks; "": none */
	char *hash;	     /* position of the `#`; NULL: none */
};

/* Opens a file; `where` is the line of the script that names it. */
enum ts_status ts_lines_open(struct ts_lines *l, struct ts_files *files, struct ts_error *err,
			     struct ts_pool *pool, const struct ts_place *where, const char *path);
/* The same for a large file that several processes read together, in pieces that each of them gets: they all read the same lines
 * up to the same one. Of a pipe, and of a compressed file, each has a copy. */
enum ts_status ts_lines_open_along(struct ts_lines *l, struct ts_files *files, struct ts_error *err,
				   struct ts_pool *pool, const struct ts_place *where, const char *path);
/* Reads from memory; `name` stands for the file in messages. The bytes must exist until ts_lines_close. */
enum ts_status ts_lines_memory(struct ts_lines *l, struct ts_error *err, struct ts_pool *pool,
			       const char *name, const char *bytes, size_t n);
void ts_lines_close(struct ts_lines *l);

/* Reads the next line and splits it into words; *more is false at the end of the file. */
enum ts_status ts_lines_next(struct ts_lines *l, bool *more);
/* The same, skipping lines without words. */
enum ts_status ts_lines_next_filled(struct ts_lines *l, bool *more);

/* Passes the next line with words, as one that another process reads: it is not split, so that nwords is 0, unless it begins with a
 * letter. */
enum ts_status ts_lines_pass_filled(struct ts_lines *l, bool *more);

/* Place of word k for messages; the whole line if there is no such word. */
struct ts_place ts_lines_place(struct ts_lines *l, size_t k);
#define ts_lines_fail(l, code, k, ...) \
	ts_fail((l)->err, code, (struct ts_place[]){ ts_lines_place(l, k) }, __VA_ARGS__)

/* Word k as a number; `what` names it in the error message. */
enum ts_status ts_lines_real(struct ts_lines *l, size_t k, const char *what, double *out);
enum ts_status ts_lines_int(struct ts_lines *l, size_t k, const char *what, int64_t lo, int64_t hi,
			    int64_t *out);
/* Whether the words from k on equal those of `text`, which are separated by single blanks. */
bool ts_lines_match(const struct ts_lines *l, size_t k, const char *text);

#endif
