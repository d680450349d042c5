/* The input files of a script: every file and folder that it mentions. They are copied to a folder in which
 * the script can run without changing the user's files. */
#ifndef TS_CROSSCHECK_INPUTS_H
#define TS_CROSSCHECK_INPUTS_H

#include "base/map.h"
#include "base/words.h"

struct ts_inputs {
	struct ts_error *err;
	struct ts_pool *pool;
	const char **file, **folder; /* relative to the working directory of the script */
	size_t files, folders, file_capacity, folder_capacity;
	int up; /* largest number of leading "../" in them */
	struct ts_map seen;
	struct ts_meanings *meanings; /* updated by the commands of the script; NULL: not needed */
	const char **word;	      /* words of the present command, which may extend over several lines */
	size_t words, word_capacity;
};

/* Searches the script, the files that it includes, and the values of variables (-var) for words that are
 * names of files, or may be, with `*` in place of unknown variables. `vars`: -var NAME VALUE ... */
enum ts_status ts_inputs_find(struct ts_inputs *in, const char *script, struct ts_words vars);
void ts_inputs_release(struct ts_inputs *in);

/* Copies the input files to a folder in `root`; *place is the working directory for the script. All copies
 * have the modification time TS_INPUT_DATE (s), which distinguishes them from files that a program writes. */
enum { TS_INPUT_DATE = 86400 };
enum ts_status ts_inputs_copy(struct ts_inputs *in, const char *root, struct ts_str *place);

#endif
