/* Command write_dump: writes one snapshot. */
#include "core/life.h"
#include "core/written_files.h"
#include "dump/dump.h"

#include <string.h>

#include "base/banned.h"

struct state {
	int group;
	struct ts_words rest, modify;
};

/* Arguments of a dump of the same style with a frame at every step. */
static enum ts_status make_dump_words(struct tsim *sim, struct ts_arena *arena, struct ts_words rest,
				      struct ts_words *out)
{
	struct ts_word *word = ts_arena_alloc(arena, rest.n, sizeof *word);

	if (!word)
		return ts_nomem(&sim->error);
	for (size_t k = 1; k < rest.n; k++)
		word[k] = rest.word[k];
	word[0] = (struct ts_word){ .text = "1", .place = rest.word[0].place };
	*out = (struct ts_words){ word, rest.n };
	return TS_OK;
}

/* -check and -explain write nothing, but find values that are not known. */
static enum ts_status evaluate_columns(struct tsim *sim, struct ts_instance *dump)
{
	struct ts_dump_common *d = dump->state;

	for (size_t k = 0; k < d->ncolumns; k++)
		TS_TRY(ts_dump_evaluate(&d->column[k], sim));
	return TS_OK;
}

static enum ts_status write_snapshot(struct tsim *sim, const struct state *s, struct ts_arena *arena,
				     const struct ts_place *where)
{
	const struct ts_word id = { .text = "write_dump", .place = *where };
	const struct ts_style *style;
	struct ts_words words;
	struct ts_instance *dump;
	struct ts_dump_common *common;
	struct ts_error error;
	enum ts_status status;

	TS_TRY(ts_style_require(sim, TS_KIND_DUMP, &s->rest.word[0], &style));
	if (s->rest.n > 1 &&
	    !strchr(s->rest.word[1].text, '*')) /* files of single frames may be written again */
		TS_TRY(ts_written_files_allow(sim, "write_dump", s->rest.word[1].text,
					      &s->rest.word[1].place));
	TS_TRY(make_dump_words(sim, arena, s->rest, &words));
	TS_TRY(ts_sim_create(sim, TS_KIND_DUMP, style, id.text, s->group, words, where, &dump));
	status = ts_dump_modify_words(sim, "write_dump modify", dump, s->modify, arena, where);
	common = dump->state;
	common->single = !common->append;
	common->once = true;
	if (status == TS_OK)
		status = sim->reading.explain ? evaluate_columns(sim, dump)
					      : dump->style->hook[TS_STAGE_OUTPUT](dump, sim);
	if (status == TS_OK)
		return ts_sim_destroy(sim, TS_KIND_DUMP, &id);
	error = sim->error;
	ts_sim_destroy(sim, TS_KIND_DUMP, &id);
	sim->error = error; /* the first one */
	return status;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_arena arena = { 0 };
	enum ts_status status = write_snapshot(sim, s, &arena, where);

	ts_arena_release(&arena);
	return status;
}

static const struct ts_arg args[] = {
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL, .help = "particles to write"),
	TS_LIST("style", struct state, rest, .help = "style of dump, file, columns"),
	TS_REST_KEYWORD("modify", struct state, modify,
			.help = "last keyword, followed by keywords of dump_modify"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_dump)
const struct ts_command_style ts_command_write_dump = {
	.style = {
		.name = "write_dump",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes one snapshot",
		.doc = "Writes one snapshot of the current state. Arguments are those of the command dump "
		       "without ID and interval. Forces are those of the last step.",
		.example = "write_dump all custom post/rock.dump id type x y z radius\n"
			   "write_dump all atom post/rock.*.dump modify scale no sort id pad 8",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
