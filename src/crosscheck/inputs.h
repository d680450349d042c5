/* What a script may read: every file and folder it mentions. Copies of them make a place where it can run
 * without touching anything of the user's. */
#ifndef TS_CROSSCHECK_INPUTS_H
#define TS_CROSSCHECK_INPUTS_H

#include "base/map.h"
#include "base/words.h"

struct ts_inputs {
	struct ts_error *err;
	struct ts_pool *pool;
	const char **file, **folder; /* relative to where the script is run */
	size_t files, folders, file_capacity, folder_capacity;
	int up; /* how far they lead above it: number of leading "../" */
	struct ts_map seen;
	struct ts_meanings *meanings; /* learns what the commands tell; NULL: nobody asks */
	const char **word;	      /* of the command at hand, which may go over several lines */
	size_t words, word_capacity;
};

/* The script, what it includes, and the values of the variables (-var) are searched for words that are, or
 * with `*` for the parts that variables fill in may be, names of files. `vars` is -var NAME VALUE ... */
enum ts_status ts_inputs_find(struct ts_inputs *in, const char *script, struct ts_words vars);
void ts_inputs_release(struct ts_inputs *in);

/* A folder in `root` that looks to the script like the present one; *place is where to run it. All copies
 * have the date TS_INPUT_DATE, by which they are told from what a program writes. */
enum { TS_INPUT_DATE = 86400 };
enum ts_status ts_inputs_copy(struct ts_inputs *in, const char *root, struct ts_str *place);

#endif
