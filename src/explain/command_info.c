/* Command info: prints the current state. */
#include <inttypes.h>
#include <time.h>

#include "base/clock.h"
#include "bond/bonds.h"
#include "box/domain.h"
#include "core/group.h"
#include "core/units.h"
#include "io/textfile.h"
#include "neigh/neigh.h"
#include "particle/particles.h"

#include "base/banned.h"

struct info {
	struct ts_words words; /* subjects as given */
};

static void print_system(struct tsim *sim, struct ts_str *out)
{
	static const char letter[] = "pfsm"; /* in the order of enum ts_face */
	const struct ts_box *box = &sim->domain->box;
	const struct ts_particles *p = sim->particles;

	ts_str_addf(out, "System:\n  units %s, %d dimensions, step %" PRId64 ", time %g, time step %g\n",
		    ts_units_name(sim->units), sim->dimension, sim->clock.step, ts_sim_time(sim),
		    sim->clock.dt);
	if (!ts_sim_has_box(sim)) {
		ts_str_addf(out, "  no simulation box\n");
		return;
	}
	ts_str_addf(out, "  box (%g %g %g) to (%g %g %g), faces", box->lo[0], box->lo[1], box->lo[2],
		    box->hi[0], box->hi[1], box->hi[2]);
	for (int d = 0; d < 3; d++)
		ts_str_addf(out, " %c%c", letter[box->face[d][0]], letter[box->face[d][1]]);
	ts_str_addf(out, "\n  %zu particles of %d types, %zu bonds of %d types, %" PRId64 " lost\n", p->n,
		    p->ntypes, sim->bonds->n, sim->bonds->ntypes, p->lost);
}

static void print_groups(struct tsim *sim, struct ts_str *out)
{
	const struct ts_particles *p = sim->particles;

	ts_str_addf(out, "Groups:\n");
	for (int bit = 0; bit < TS_MAX_GROUPS; bit++) {
		size_t count = 0;

		if (!ts_group_name(sim, bit))
			continue;
		for (size_t i = 0; i < p->n; i++)
			count += ts_in_group(p, i, bit);
		ts_str_addf(out, "  %s, %s, %zu particles\n", ts_group_name(sim, bit),
			    p->dynamic[bit].every ? "dynamic" : "static", count);
	}
}

/* Lists instances: "  fall, gravity, group all, in.script:7". */
static void print_instances(struct tsim *sim, struct ts_str *out, const char *title, enum ts_kind kind)
{
	const struct ts_instances *all = &sim->instances[kind];

	ts_str_addf(out, "%s:\n", title);
	for (size_t k = 0; k < all->n; k++) {
		const struct ts_instance *inst = all->item[k];

		ts_str_addf(out, "  %s%s%s", inst->id, *inst->id ? ", " : "", inst->style->name);
		if (kind == TS_KIND_FIX || kind == TS_KIND_COMPUTE || kind == TS_KIND_DUMP)
			ts_str_addf(out, ", group %s", ts_group_name(sim, inst->group));
		if (inst->where.file && inst->where.line)
			ts_str_addf(out, ", %s:%d", inst->where.file, inst->where.line);
		ts_str_addf(out, "\n");
	}
}

static void print_computes(struct tsim *sim, struct ts_str *out)
{
	print_instances(sim, out, "Computes", TS_KIND_COMPUTE);
}

static void print_dumps(struct tsim *sim, struct ts_str *out)
{
	print_instances(sim, out, "Dumps", TS_KIND_DUMP);
}

static void print_fixes(struct tsim *sim, struct ts_str *out)
{
	print_instances(sim, out, "Fixes", TS_KIND_FIX);
}

static void print_regions(struct tsim *sim, struct ts_str *out)
{
	print_instances(sim, out, "Regions", TS_KIND_REGION);
}

static void print_interaction_styles(struct tsim *sim, struct ts_str *out)
{
	print_instances(sim, out, "Pair style", TS_KIND_PAIR);
	print_instances(sim, out, "Bond style", TS_KIND_BOND);
	print_instances(sim, out, "Flow style", TS_KIND_FLOW);
	print_instances(sim, out, "Pressure style", TS_KIND_PRESSURE);
	print_instances(sim, out, "Automaton style", TS_KIND_AUTOMATON);
}

static void print_memory(struct tsim *sim, struct ts_str *out)
{
	const struct ts_particles *p = sim->particles;
	double bytes = 0;

	for (size_t k = 0; k < p->ncolumns; k++)
		if (p->column[k].active)
			bytes += (double)(p->capacity * p->column[k].width * p->column[k].element);
	ts_str_addf(out, "Memory:\n  particles %.3g Mbytes, candidate pairs %zu\n", bytes / 1048576,
		    sim->neigh->contacts.n);
}

static void print_communication(struct tsim *sim, struct ts_str *out)
{
	ts_str_addf(out, "Communication:\n  1 process, %d threads, %zu ghosts, skin %g\n", sim->threads,
		    sim->particles->nghost, sim->neigh->skin);
}

static enum ts_status print_variables(struct tsim *sim, struct ts_str *out)
{
	ts_str_add(out, "Variables:\n");
	return sim->script_api ? sim->script_api->list_variables(sim->script_api_data, out) : TS_OK;
}

static void print_times(struct tsim *sim, struct ts_str *out)
{
	double wall = sim->run.inside ? ts_clock() - sim->clock.wall_start : 0;

	ts_str_addf(out, "Times:\n  CPU time %.3f s, %.3f s since the start of the run\n",
		    (double)clock() / CLOCKS_PER_SEC, wall);
}

static void print_configuration(struct tsim *sim, struct ts_str *out)
{
	(void)sim;
	ts_str_addf(out, "Configuration:\n  tsim %s, %s, 32-bit particle IDs, 64-bit step numbers\n",
		    PACKAGE_VERSION,
#ifdef _OPENMP
		    "threads by OpenMP"
#else
		    "without threads"
#endif
	);
}

static void print_accelerators(struct tsim *sim, struct ts_str *out)
{
	(void)sim;
	ts_str_add(out, "Accelerators: none\n");
}

static void print_transforms(struct tsim *sim, struct ts_str *out)
{
	(void)sim;
	ts_str_add(out, "Fourier transforms: none\n");
}

/* Lists the styles of one kind, or of all (TS_NKIND). */
static void print_style_list(const struct tsim *sim, struct ts_str *out, enum ts_kind only)
{
	enum ts_kind kind = TS_NKIND;

	ts_str_add(out, "Styles:");
	for (const struct ts_style *const *s = sim->tables->styles; *s; s++) {
		if (only != TS_NKIND && (*s)->kind != only)
			continue;
		if ((*s)->kind != kind)
			ts_str_addf(out, "\n  %s:", ts_kind_name((*s)->kind));
		kind = (*s)->kind;
		ts_str_addf(out, " %s", (*s)->name);
	}
	ts_str_add(out, "\n");
}

struct subject {
	const char *name;
	void (*print)(struct tsim *sim, struct ts_str *out);
	bool in_all; /* printed by `info all` */
};

static const struct subject subjects[] = {
	{ "system", print_system, true },
	{ "communication", print_communication, true },
	{ "memory", print_memory, true },
	{ "groups", print_groups, true },
	{ "regions", print_regions, true },
	{ "computes", print_computes, true },
	{ "fixes", print_fixes, true },
	{ "dumps", print_dumps, true },
	{ "coeffs", print_interaction_styles, true },
	{ "time", print_times, true },
	{ "configuration", print_configuration, true },
	{ "config", print_configuration, false },
	{ "accelerator", print_accelerators, false },
	{ "fft", print_transforms, false },
};
enum { NSUBJECTS = sizeof subjects / sizeof *subjects };

static enum ts_status refuse_subject(struct tsim *sim, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (int k = 0; k < NSUBJECTS; k++)
		ts_suggest_try(&suggest, subjects[k].name);
	ts_suggest_try(&suggest, "variables");
	ts_suggest_try(&suggest, "styles");
	ts_suggest_try(&suggest, "out");
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "info: unknown subject '%s'%s", word->text,
		       ts_suggest_text(&suggest));
}

static enum ts_status print_subject(struct tsim *sim, const struct ts_word *word, struct ts_str *out)
{
	bool all = ts_streq(word->text, "all"), named = ts_streq(word->text, "variables");
	bool found = all || named;

	for (int k = 0; k < NSUBJECTS; k++) {
		bool this = ts_streq(word->text, subjects[k].name);

		if (this || (all && subjects[k].in_all))
			subjects[k].print(sim, out);
		found |= this;
	}
	if (all || named)
		TS_TRY(print_variables(sim, out));
	return found ? TS_OK : refuse_subject(sim, word);
}

/* styles, styles all, styles KIND; returns the number of words used. */
static size_t print_styles(const struct tsim *sim, struct ts_words words, struct ts_str *out)
{
	int kind = 0;

	while (words.n > 1 && kind < TS_NKIND &&
	       !ts_streq(words.word[1].text, ts_kind_name((enum ts_kind)kind)))
		kind++;
	if (words.n < 2)
		kind = TS_NKIND;
	print_style_list(sim, out, (enum ts_kind)kind);
	return kind < TS_NKIND || (words.n > 1 && ts_streq(words.word[1].text, "all")) ? 2 : 1;
}

/* Destination of the output. */
struct target {
	const struct ts_word *file; /* NULL: the log */
	bool append;
};

/* out log|screen, out append FILE, out overwrite FILE; returns the number of words used, 0: wrong words. */
static size_t read_target(struct ts_words words, struct target *target)
{
	const char *mode = words.n > 1 ? words.word[1].text : "";

	*target = (struct target){ .append = ts_streq(mode, "append") };
	if (ts_streq(mode, "log") || ts_streq(mode, "screen"))
		return 2;
	if (words.n < 3 || !(target->append || ts_streq(mode, "overwrite")))
		return 0;
	target->file = &words.word[2];
	return 3;
}

static enum ts_status write_text(struct tsim *sim, const struct target *target, const struct ts_str *text)
{
	struct ts_textfile file = { 0 };
	enum ts_status status, closed;

	if (text->failed)
		return ts_nomem(&sim->error);
	if (!target->file) {
		ts_log(&sim->log, "%s", ts_str_text(text));
		return TS_OK;
	}
	if (sim->script_api)
		TS_TRY(sim->script_api->would_write(sim->script_api_data, &target->file->place, "info",
						    target->file->text));
	TS_TRY(ts_textfile_open(&file, sim, &target->file->place, target->file->text, target->append));
	status = ts_textfile_write(&file, ts_str_text(text), text->length);
	closed = ts_textfile_close(&file);
	return status != TS_OK ? status : closed;
}

static enum ts_status print_subjects(struct tsim *sim, struct ts_words words, struct target *target,
				     struct ts_str *out)
{
	for (size_t used; words.n; words = ts_words_from(words, used)) {
		const struct ts_word *word = words.word;

		used = 1;
		if (ts_streq(word->text, "styles"))
			used = print_styles(sim, words, out);
		else if (ts_streq(word->text, "out"))
			used = read_target(words, target);
		else
			TS_TRY(print_subject(sim, word, out));
		if (!used)
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "info: expected out log, out screen, out append FILE or out overwrite "
				       "FILE");
	}
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct info *c = state;
	struct target target = { 0 };
	struct ts_str text = { 0 };
	enum ts_status status = print_subjects(sim, c->words, &target, &text);

	(void)where;
	if (status == TS_OK)
		status = write_text(sim, &target, &text);
	ts_str_release(&text);
	return status;
}

static const struct ts_arg args[] = {
	TS_REST("subjects", struct info, words,
		.help = "all, or system, communication, memory, groups, regions, computes, fixes, dumps, "
			"coeffs, variables, time, configuration, accelerator, fft, styles [KIND]; out log, "
			"out append FILE or out overwrite FILE: destination"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_info)
const struct ts_command_style ts_command_info = {
	.style = {
		.name = "info",
		.kind = TS_KIND_COMMAND,
		.summary = "Prints the current state of the simulation",
		.doc = "Prints the current state to the log: box and particles, groups, regions, computes, "
		       "fixes, dumps and variables with the lines of the script that defined them, the pair "
		       "and bond styles. all does not include styles, the list of everything a script can "
		       "name, or of one kind (styles fix).",
		.example = "info system groups\ninfo all out overwrite state.txt\ninfo styles compute",
		.args = args,
		.state_size = sizeof(struct info),
	},
	.run = run,
};
