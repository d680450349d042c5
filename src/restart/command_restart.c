/* Command restart: writes restart files every N steps during runs. */
#include "core/life.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int64_t every;
	struct ts_words files;
};

static enum ts_status delete_dump(struct tsim *sim, const struct ts_word *id)
{
	const struct ts_instance *dump = ts_sim_find(sim, TS_KIND_DUMP, id->text);

	if (dump && !ts_streq(dump->style->name, "restart"))
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "restart: there is a dump with the ID '%s' (%s, %s:%d), which this command "
			       "needs: give that dump another one",
			       id->text, dump->style->name, TS_FILE_AND_LINE(dump->where));
	return dump ? ts_sim_destroy(sim, TS_KIND_DUMP, id) : TS_OK;
}

static enum ts_status define_dump(struct tsim *sim, const struct ts_word *id, const struct ts_word *word,
				  size_t n)
{
	struct ts_word style_name = { .text = "restart", .place = id->place };
	const struct ts_style *style;

	TS_TRY(ts_style_require(sim, TS_KIND_DUMP, &style_name, &style));
	return ts_sim_create(sim, TS_KIND_DUMP, style, id->text, 0, (struct ts_words){ word, n }, &id->place,
			     NULL);
}

/* A series of files and two that alternate do not replace each other. */
static struct ts_word id_of(size_t files, const struct ts_place *where)
{
	return (struct ts_word){ .text = files == 2 ? "restart2" : "restart", .place = *where };
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_word id = id_of(s->files.n, where);
	struct ts_word word[3];
	struct ts_str series = { 0 };
	enum ts_status status;
	char every[24];

	for (size_t files = 1; files <= 2; files++) {
		const struct ts_word old = id_of(files, where);

		if (s->every == 0 || files == s->files.n)
			TS_TRY(delete_dump(sim, &old));
	}
	if (s->every == 0)
		return TS_OK;
	if (s->files.n < 1 || s->files.n > 2)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "restart: expected one or two file names, found %zu", s->files.n);
	snprintf(every, sizeof every, "%lld", (long long)s->every);
	word[0] = (struct ts_word){ .text = every, .place = *where };
	for (size_t k = 0; k < s->files.n; k++)
		word[k + 1] = s->files.word[k];
	if (s->files.n == 1 && !strchr(word[1].text, '*')) {
		ts_str_addf(&series, "%s.*", word[1].text);
		if (series.failed)
			return ts_nomem(&sim->error);
		word[1].text = ts_str_text(&series);
	}
	status = define_dump(sim, &id, word, s->files.n + 1);
	ts_str_release(&series);
	return status;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "steps between files; 0: none"),
	{ .name = "files",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL,
	  .offset = TS_FIELD(struct state, files, struct ts_words *),
	  .help = "one name, in which `*` stands for the step (without a `*` the step is appended); or two "
		  "names to be written alternately" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_restart)
const struct ts_command_style ts_command_restart = {
	.style = {
		.name = "restart",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Writes restart files every N steps during runs",
		.doc = "Defines a dump of style restart with the ID restart, or restart2 with two names, which "
		       "writes its files after all other outputs of the step. A second line with as many names "
		       "replaces the first one; `restart 0` ends both. Files are written under a temporary name and renamed, so "
		       "that a file is complete at any time. To write the same file repeatedly use dump style "
		       "restart.\n\n"
		       "A run that was killed has often gone on behind its last restart file. Rows and frames of these steps are "
		       "written again by the continued run: where it appends to a file that has them, a warning says so; "
		       "dump h5md replaces them.",
		.example = "restart 10000 a.restart b.restart\n"
			   "restart 50000 post/rock.*.restart\n"
			   "restart 0",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
