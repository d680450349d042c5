/* Command partition: lines for some of several simultaneous simulations, of which tsim has one, number 1. */
#include <string.h>

#include "script/internal.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_partition)

struct partition {
	bool included;
	const char *range;
	struct ts_words command;
};

static const struct ts_arg args[] = {
	TS_BOOL("which", struct partition, included, .flags = TS_POSITIONAL,
		.help = "yes: partitions of the range execute the command; no: those outside of it"),
	TS_WORD("range", struct partition, range, .flags = TS_POSITIONAL,
		.help = "numbers of partitions, N, N*, *M or N*M; there is one, number 1"),
	TS_REST("command", struct partition, command, .help = "command and its arguments"), TS_ARGS_END
};

/* Whether the range includes partition 1. */
static enum ts_status includes_first(struct tsim *sim, const char *range, const struct ts_place *where,
				     bool *out)
{
	struct ts_str low = { 0 };
	const char *star = strchr(range, '*'), *high = star ? star + 1 : range;
	int64_t first = 1, last = INT64_MAX;
	bool good;

	ts_str_add_n(&low, range, star ? (size_t)(star - range) : strlen(range));
	good = !low.length || ts_parse_int(ts_str_text(&low), &first);
	good &= !*high || ts_parse_int(high, &last);
	good &= star || low.length;
	ts_str_release(&low);
	*out = first <= 1 && last >= 1;
	if (good && first >= 1 && last >= first)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "expected numbers of partitions such as 2, 1* or 2*4, found '%s'", range);
}

static enum ts_status run_partition(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct partition *partition = state;
	struct ts_script *script;
	bool first = false;

	TS_TRY(ts_script_of(sim, where, &script));
	TS_TRY(includes_first(sim, partition->range, ts_script_place(script, 2, where), &first));
	if (first != partition->included)
		return TS_OK;
	return ts_script_run_words(script, partition->command);
}

const struct ts_command_style ts_command_partition = {
	.style = {
		.name = "partition",
		.kind = TS_KIND_COMMAND,
		.summary = "executes a command in some of several partitions",
		.doc = "LIGGGHTS and LAMMPS can run several simulations at the same time, in partitions; tsim "
		       "has one, number 1. The command is executed if the range includes (yes) or does not "
		       "include (no) that number.",
		.example = "partition yes 1 print \"the first\"",
		.args = args,
		.state_size = sizeof(struct partition),
	},
	.run = run_partition,
};
