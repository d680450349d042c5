/* A script of a study: which of the variables it uses, and which version of it was run. */
#ifndef TS_STUDY_STUDY_SCRIPT_H
#define TS_STUDY_STUDY_SCRIPT_H

#include "core/sim.h"

struct ts_study_script {
	const char *path;
	char version
		[20]; /* hash of the words of the script and of the files that it includes by their names */
	struct ts_str text;    /* all words */
	const char **variable; /* [variables]: names that its lines `variable NAME ...` define */
	size_t variables, capacity;
};

/* Reads the script. Names live as long as the arena. */
enum ts_status ts_study_script_read(struct ts_study_script *script, const char *path, struct tsim *sim,
				    struct ts_arena *arena);
/* Whether the name of a variable stands somewhere in the script: NAME, v_NAME, or $x for a single letter. */
bool ts_study_script_mentions(const struct ts_study_script *script, const char *name);
/* Appends ": did you mean ...", or the variables of the script. */
void ts_study_script_suggest(const struct ts_study_script *script, const char *name, struct ts_str *out);
void ts_study_script_release(struct ts_study_script *script);

#endif
