/* Input of text, line by line: from a file, compressed or not, or from memory. How long lines may be, and
 * to what a compressed file may unfold, says base/input_limit.h. Every complaint names file, line and
 * column. */
#ifndef TS_IO_LINES_H
#define TS_IO_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/files.h"
#include "base/words.h"

struct ts_pool;

/* Zero-initialise. */
struct ts_lines {
	struct ts_error *err;
	struct ts_pool *pool; /* for the texts of places */
	const char *file;     /* its name, in the pool */
	void *gz;	      /* gzFile; NULL: from memory */
	struct ts_files *files;
	double most_unfolded; /* base/input_limit.h */
	size_t longest;	      /* likewise, a line */
	double unfolded;      /* bytes, since the reader last set it to 0 */
	/* a compressed file that ends within its data is read as far as it goes */
	bool may_be_torn;
	bool torn;	   /* it was one */
	const char *chunk; /* read from the file and not yet cut into lines */
	char *buffer;
	size_t at, end;
	/* the present line */
	int number;
	bool ended; /* by a line feed, not by the file */
	char *line;
	size_t length, capacity;
	char **word; /* cut at blanks; a comment is no word */
	size_t nwords, word_capacity;
	const char *comment; /* what follows `#`, without blanks before it; "" */
	char *hash;	     /* where the `#` was; NULL: none */
};

enum ts_status ts_lines_open(struct ts_lines *l, struct ts_files *files, struct ts_error *err,
			     struct ts_pool *pool, const struct ts_place *where, const char *path);
/* `name` stands for the file in messages. The bytes must outlive the reading. */
enum ts_status ts_lines_memory(struct ts_lines *l, struct ts_error *err, struct ts_pool *pool,
			       const char *name, const char *bytes, size_t n);
void ts_lines_close(struct ts_lines *l);

/* The next line, cut into words; *more is false at the end of the file. */
enum ts_status ts_lines_next(struct ts_lines *l, bool *more);
/* The same, but lines without words are passed over. */
enum ts_status ts_lines_next_filled(struct ts_lines *l, bool *more);

/* Where word k stands; the whole line if there is no such word. */
struct ts_place ts_lines_place(struct ts_lines *l, size_t k);
#define ts_lines_fail(l, code, k, ...) \
	ts_fail((l)->err, code, (struct ts_place[]){ ts_lines_place(l, k) }, __VA_ARGS__)

/* Word k as a number; `what` names it in the complaint. */
enum ts_status ts_lines_real(struct ts_lines *l, size_t k, const char *what, double *out);
enum ts_status ts_lines_int(struct ts_lines *l, size_t k, const char *what, int64_t lo, int64_t hi,
			    int64_t *out);
/* Whether the words from k on are those of `text`, which is cut at single blanks. */
bool ts_lines_match(const struct ts_lines *l, size_t k, const char *text);

#endif
