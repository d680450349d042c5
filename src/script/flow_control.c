/* Flow of control: commands label, jump, next, include, quit, clear. */
#include "core/life.h"
#include "script/check.h"
#include "script/internal.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_clear)
TS_STYLE(command, ts_command_style, ts_command_include)
TS_STYLE(command, ts_command_style, ts_command_jump)
TS_STYLE(command, ts_command_style, ts_command_label)
TS_STYLE(command, ts_command_style, ts_command_next)
TS_STYLE(command, ts_command_style, ts_command_quit)

struct jump {
	const char *file, *label;
};

static const struct ts_arg jump_args[] = {
	TS_WORD("file", struct jump, file, .flags = TS_POSITIONAL,
		.help = "script to continue with; SELF: the present one from its first line"),
	TS_WORD("label", struct jump, label, .flags = TS_POSITIONAL | TS_OPTIONAL,
		.help = "skip all lines up to this label"),
	TS_ARGS_END
};

static enum ts_status run_jump(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct jump *jump = state;
	struct ts_script *script;
	struct ts_source source;
	bool follow;

	TS_TRY(ts_script_of(sim, where, &script));
	if (script->skip_jump) {
		script->skip_jump = false;
		ts_check_leave_loop(script, where);
		return TS_OK;
	}
	if (!script->source)
		return ts_fail(&sim->error, TS_STATE, where, "there is no script to jump in");
	TS_TRY(ts_check_jump(script, where, jump->file, jump->label, &follow));
	if (!follow)
		return TS_OK;
	if (ts_streq(jump->file, "SELF") && script->source->stream && !script->source->owns_stream)
		return ts_fail(&sim->error, TS_STATE, ts_script_place(script, 1, where),
			       "a script on standard input cannot go back to an earlier line; start it with "
			       "-in FILE");
	if (ts_streq(jump->file, "SELF")) {
		ts_source_rewind(script->source);
		if (jump->label && ts_source_seek_label(script->source, jump->label))
			return TS_OK;
	} else {
		TS_TRY(ts_source_open(&source, sim, jump->file, ts_script_place(script, 1, where)));
		TS_TRY(ts_script_store_text(script, script->source));
		source.outer = script->source->outer;
		ts_source_close(script->source);
		*script->source = source;
	}
	if (!jump->label)
		return TS_OK;
	script->label = ts_pool_get(sim->pool, jump->label);
	script->label_place = *ts_script_place(script, 2, where);
	return script->label ? TS_OK : ts_nomem(&sim->error);
}

const struct ts_command_style ts_command_jump = {
	.style = {
		.name = "jump",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "continues with another line or script",
		.doc = "Execution continues with the first line of the file, or with the line behind the "
		       "label. Lines that are skipped are neither substituted nor checked. The first jump "
		       "after a `next` that has found no further value does nothing, which ends a loop. A "
		       "script that is read from standard input cannot jump to SELF.",
		.example = "variable n loop 3\nlabel again\nprint \"round $n\"\nnext n\njump SELF again",
		.args = jump_args,
		.state_size = sizeof(struct jump),
	},
	.run = run_jump,
};

struct name {
	const char *name;
};

static const struct ts_arg label_args[] = {
	TS_WORD("name", struct name, name, .flags = TS_POSITIONAL, .help = "name for `jump`"), TS_ARGS_END
};

static enum ts_status run_label(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct name *label = state;
	struct ts_script *script;

	TS_TRY(ts_script_of(sim, where, &script));
	return script->source ? ts_source_add_label(script->source, sim, label->name) : TS_OK;
}

const struct ts_command_style ts_command_label = {
	.style = {
		.name = "label",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "marks a line for jump",
		.doc = "The command itself has no effect.",
		.example = "label again",
		.args = label_args,
		.state_size = sizeof(struct name),
	},
	.run = run_label,
};

struct next {
	struct ts_words names;
};

static const struct ts_arg next_args[] = {
	TS_REST("variables", struct next, names,
		.help = "variables of style index, loop, universe, uloop, file or atomfile"),
	TS_ARGS_END
};

static enum ts_status run_next(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct next *next = state;
	struct ts_script *script;
	struct ts_variable *variable;
	bool exhausted;

	TS_TRY(ts_script_of(sim, where, &script));
	for (size_t k = 0; k < next->names.n; k++) {
		const struct ts_word *name = &next->names.word[k];

		TS_TRY(ts_variable_require(&script->formulas, name->text, &name->place, &variable));
		TS_TRY(ts_variable_next(&script->formulas, variable, &name->place, &exhausted));
		if (!exhausted)
			continue;
		script->skip_jump = true;
		ts_variable_delete(&script->formulas, variable);
	}
	ts_check_record_next(script, next->names);
	return TS_OK;
}

const struct ts_command_style ts_command_next = {
	.style = {
		.name = "next",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "advances index, loop and file variables to their next value",
		.doc = "A variable that has no further value is deleted, and the next `jump` does nothing. "
		       "Several variables are advanced together.",
		.example = "next n\nnext n rock",
		.args = next_args,
		.state_size = sizeof(struct next),
	},
	.run = run_next,
};

static const struct ts_arg include_args[] = {
	TS_WORD("file", struct name, name, .flags = TS_POSITIONAL, .help = "script to run"), TS_ARGS_END
};

static enum ts_status run_include(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct name *file = state;
	struct ts_script *script;

	TS_TRY(ts_script_of(sim, where, &script));
	if (script->branches)
		return ts_fail(&sim->error, TS_STATE, where,
			       "include is not allowed within an if; use jump, or set a variable to the "
			       "file's name and include it in a line of its own");
	return ts_script_include(script, file->name, ts_script_place(script, 1, where));
}

const struct ts_command_style ts_command_include = {
	.style = {
		.name = "include",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "executes another script, then continues here",
		.doc = "A relative name that is not found in the working folder is looked for in the folder "
		       "of the script with this command. The other script shares all variables. Its jumps "
		       "stay inside of it. Includes can be nested 50 deep. Not allowed within `if`.",
		.example = "include materials.in",
		.args = include_args,
		.state_size = sizeof(struct name),
	},
	.run = run_include,
};

struct quit {
	int64_t status;
};

static const struct ts_arg quit_args[] = { TS_INT("status", struct quit, status, .flags = TS_POSITIONAL,
						  .range = TS_WITHIN, .lo = 0, .hi = 255, .fallback = "0",
						  .help = "exit status of the program"),
					   TS_ARGS_END };

static enum ts_status run_quit(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct quit *quit = state;
	struct ts_script *script;

	TS_TRY(ts_script_of(sim, where, &script));
	script->quit = true;
	script->quit_status = (int)quit->status;
	return TS_OK;
}

const struct ts_command_style ts_command_quit = {
	.style = {
		.name = "quit",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "ends the script",
		.doc = "All scripts that include this one end, too; all files are closed.",
		.example = "if \"${broken} > 0\" then \"quit 3\"",
		.args = quit_args,
		.state_size = sizeof(struct quit),
	},
	.run = run_quit,
};

static enum ts_status run_clear(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)state, (void)where;
	return ts_sim_clear(sim);
}

const struct ts_command_style ts_command_clear = {
	.style = {
		.name = "clear",
		.kind = TS_KIND_COMMAND,
		.summary = "deletes the simulation, but not the variables",
		.doc = "Box, particles and all styles are deleted, and settings and the step counter are "
		       "reset to those at the start of the program; variables, working folder and log file "
		       "are kept.",
		.example = "clear",
	},
	.run = run_clear,
};
