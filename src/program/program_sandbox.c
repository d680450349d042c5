/* -sandbox: restrictions for untrusted scripts. */
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/input_limit.h"
#include "base/sandbox.h"
#include "core/arg.h"
#include "program/program.h"

#include "base/banned.h"

struct options {
	double memory, time, disk;
	bool kernel;
};

static const struct ts_arg rows[] = {
	TS_REAL("memory", struct options, memory, .fallback = "8", .range = TS_WITHIN, .lo = 0.1, .hi = 1e6,
		.unit = "GB", .help = "address space of the program; beyond it memory cannot be allocated"),
	TS_REAL("time", struct options, time, .fallback = "86400", .range = TS_WITHIN, .lo = 1, .hi = 1e9,
		.unit = "s",
		.help = "processor time of all threads; after it the state is saved and the run ends"),
	TS_REAL("disk", struct options, disk, .fallback = "10", .range = TS_WITHIN, .lo = 1e-6, .hi = 1e6,
		.unit = "GB",
		.help = "bytes that are written in all, what is written over or removed later included; a "
			"file or folder by itself counts as 4096"),
	TS_BOOL("kernel", struct options, kernel, .fallback = "yes",
		.help = "no: do without what the kernel enforces, as where it has neither Landlock nor "
			"seccomp"),
	TS_ARGS_END,
};

/* Refuses options that would evade the restrictions. */
static int refuse_conflicts(const struct ts_setup *setup)
{
	const char *other = setup->programs	  ? "-shell yes"
			    : setup->crosscheck.n ? "-crosscheck"
			    : setup->advised	  ? "-advise"
						  : NULL;

	return other ? ts_program_usage_error("-sandbox and %s cannot be given together: %s starts processes",
					      other, other)
		     : 0;
}

static int admit_failed(const char *folder)
{
	return ts_program_usage_error("-sandbox: cannot open the folder '%s': %s", folder, strerror(errno));
}

/* Permits reading below the folder of the script, with links resolved. */
static int admit_script(struct ts_files *files, const char *input)
{
	char path[PATH_MAX], *slash;

	if (!input)
		return ts_files_admit(files, ".", false) == 0 ? 0 : admit_failed(".");
	if (!realpath(input, path))
		return ts_program_usage_error("cannot open script '%s': %s", input, strerror(errno));
	slash = strrchr(path, '/');
	slash[slash == path] = '\0';
	return ts_files_admit(files, path, false) == 0 ? 0 : admit_failed(path);
}

static int admit_all(struct ts_files *files, const char *input)
{
	const char *potentials = getenv("TSIM_POTENTIALS");
	int status = admit_script(files, input);

	if (!status && potentials && ts_files_admit(files, potentials, false) != 0)
		status = admit_failed(potentials);
	if (!status && ts_files_admit(files, TS_POTENTIALS, false) != 0 && errno != ENOENT &&
	    errno != ENOTDIR)
		status = admit_failed(TS_POTENTIALS);
	if (!status && ts_files_admit(files, ".", true) != 0)
		status = admit_failed(".");
	return status;
}

/* Clears the environment but for these variables, whose values are permitted. */
static int clear_environment(void)
{
	static const char *const names[] = { "TSIM_POTENTIALS", TS_INPUT_LIMIT };
	char kept[2][PATH_MAX] = { "", "" };
	bool bad;

	for (int k = 0; k < 2; k++) {
		const char *value = getenv(names[k]);

		if (value && strlen(value) < sizeof kept[k])
			memcpy(kept[k], value, strlen(value) + 1);
	}
	bad = clearenv() != 0;
	for (int k = 0; k < 2; k++)
		bad |= *kept[k] && setenv(names[k], kept[k], 1) != 0;
	if (bad)
		return ts_program_usage_error("-sandbox: cannot empty the environment: %s%s", strerror(errno),
					      "");
	return 0;
}

static void report_limits(const struct ts_files *files, const struct options *o, int paths, bool calls,
			  struct ts_str *out)
{
	ts_str_add(out, "sandbox: reads below");
	for (int k = 0; k < files->n; k++)
		if (!files->root[k].writes)
			ts_str_addf(out, "%s '%s'", k ? "," : "", files->root[k].path);
	ts_str_addf(out, "; writes below '%s'; at most %.6g GB of memory, %.6g s, %.6g GB of files\n",
		    files->root[files->n - 1].path, o->memory, o->time, o->disk);
	if (paths)
		ts_str_addf(out,
			    "sandbox: files are kept by the kernel (Landlock %d) and by tsim, which resolves "
			    "and checks each path\n",
			    paths);
	else
		ts_str_addf(out,
			    "sandbox: files are kept by tsim alone, which resolves and checks each path: "
			    "%s\n",
			    o->kernel ? "this kernel has no Landlock" : "kernel no");
	ts_str_addf(out, "sandbox: processes and sockets are kept away by %s\n",
		    calls ? "the kernel (seccomp) and by tsim" : "tsim alone");
}

static int restrict_process(struct tsim *sim, const struct ts_setup *setup, const struct options *o,
			    struct ts_str *said)
{
	const struct ts_sandbox_limits limits = { 1e9 * o->memory, o->time, 1e9 * o->disk };
	int status = admit_all(&sim->files, setup->input), paths;
	bool calls;

	if (!status)
		status = clear_environment();
	if (status)
		return status;
	ts_files_close(&sim->files, (int64_t)(1e9 * o->disk));
	if (ts_sandbox_limit(&limits) != 0)
		return ts_program_usage_error("-sandbox: cannot set the limits: %s%s", strerror(errno), "");
	paths = o->kernel ? ts_sandbox_paths(&sim->files) : 0;
	calls = o->kernel && ts_sandbox_calls(setup->explain);
	report_limits(&sim->files, o, paths, calls, said);
	return 0;
}

int ts_program_sandbox(struct tsim *sim, const struct ts_setup *setup, struct ts_str *said)
{
	const struct ts_words words = { setup->sandbox.word, setup->sandbox.n };
	struct ts_place where = { .file = "-sandbox" };
	struct ts_arena arena = { 0 };
	struct options o = { 0 };
	int status = refuse_conflicts(setup);

	if (!status && ts_args_parse(sim, "-sandbox", rows, words, &where, &arena, &o) != TS_OK) {
		fputs(sim->error.message, stderr);
		fputs("\n", stderr);
		ts_error_clear(&sim->error);
		status = TS_EXIT_USAGE;
	}
	if (!status)
		status = restrict_process(sim, setup, &o, said);
	ts_arena_release(&arena);
	return status;
}

void ts_program_sandbox_help(struct ts_str *out)
{
	for (const struct ts_arg *row = rows; row->type != TS_ARG_END; row++) {
		struct ts_str synopsis = { 0 };

		ts_arg_synopsis(row, &synopsis);
		ts_str_addf(out, "  %-22s %s (%s)\n", ts_str_text(&synopsis), row->help, row->fallback);
		out->failed |= synopsis.failed;
		ts_str_release(&synopsis);
	}
	ts_str_add(out, "The script reads only below its own folder and the installed potentials, and what "
			"it has written itself;\n"
			"it writes only below the folder that tsim was started in. It does not see or change "
			"the environment and\n"
			"starts no processes. doc/language.md says exactly what holds.\n");
}
