/* The common part of the commands `fix` and `compute`: ID GROUP STYLE arguments. */
#ifndef TS_CORE_DEFINITION_H
#define TS_CORE_DEFINITION_H

#include "core/sim.h"

struct ts_definition {
	const char *id;
	int group;
	struct ts_words line; /* style and its arguments */
	size_t passed;	      /* words behind the style that belong to the command, not to the style */
};
#define TS_DEFINITION_ARGS(group_help, line_help)                                            \
	TS_WORD("id", struct ts_definition, id, .flags = TS_POSITIONAL, .help = "its name"), \
		TS_GROUP("group", struct ts_definition, group, .flags = TS_POSITIONAL,       \
			 .help = (group_help)),                                              \
		TS_REST("style", struct ts_definition, line, .help = (line_help))

/* Creates the instance that a command `fix` or `compute` defines. */
enum ts_status ts_define(struct tsim *sim, enum ts_kind kind, const struct ts_definition *made);

#endif
