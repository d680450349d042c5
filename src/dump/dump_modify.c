/* Applies the keywords of dump_modify and of `write_dump ... modify`. */
#include <math.h>
#include <string.h>

#include "dump/dump_modify.h"
#include "io/csv.h"

#include "base/banned.h"

const char *const ts_dump_answers[] = { "no", "yes", NULL };
const char *const ts_dump_compressors[] = { "none", "zlib", "lz4", NULL };

static enum ts_status copy_name(struct tsim *sim, struct ts_instance *dump, const char *text,
				const char **out)
{
	*out = ts_arena_strdup(&dump->arena, text);
	return *out ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status set_every(struct tsim *sim, struct ts_instance *dump, const struct ts_number *every,
				const struct ts_place *where)
{
	struct ts_dump_common *d = dump->state;

	if (every->null)
		return TS_OK;
	d->variable = NULL;
	TS_TRY(ts_number_check(sim, every, where));
	if (every->variable)
		return copy_name(sim, dump, every->variable, &d->variable);
	if (every->value != floor(every->value) || every->value > 9e15)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "dump_modify: every is %g, expected an integer > 0 or v_name", every->value);
	d->every = dump->every = (int64_t)every->value;
	return TS_OK;
}

static enum ts_status set_sort(struct tsim *sim, struct ts_dump_common *d, const char *sort,
			       const struct ts_place *where)
{
	int64_t column = 0;

	if (!sort)
		return TS_OK;
	d->unsorted = ts_streq(sort, "off");
	d->sort_by = 0;
	if (d->unsorted || ts_streq(sort, "id"))
		return TS_OK;
	if (!ts_parse_int(sort, &column) || column == 0 || column > (int64_t)d->ncolumns ||
	    -column > (int64_t)d->ncolumns)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "dump_modify: sort is '%s', expected id, off, or N or -N with the number of a "
			       "column from 1 to %zu",
			       sort, d->ncolumns);
	d->sort_by = column;
	return TS_OK;
}

static enum ts_status set_region(struct tsim *sim, struct ts_instance *dump, const char *region,
				 const struct ts_place *where)
{
	struct ts_dump_common *d = dump->state;
	const struct ts_word id = { .text = region, .place = *where };
	struct ts_instance *found;

	if (ts_streq(region, "none")) {
		d->region = NULL;
		return TS_OK;
	}
	TS_TRY(ts_sim_require(sim, TS_KIND_REGION, &id, &found));
	return copy_name(sim, dump, region, &d->region);
}

static enum ts_status set_refresh(struct tsim *sim, struct ts_instance *dump, const char *refresh,
				  const struct ts_place *where)
{
	struct ts_dump_common *d = dump->state;
	bool prefixed = strncmp(refresh, "c_", 2) == 0;
	const struct ts_word id = { .text = refresh + (prefixed ? 2 : 0),
				    .place = *ts_sim_word_of(sim, refresh, where) };
	struct ts_instance *found;

	TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &id, &found));
	if (!found->style->refresh)
		return ts_fail(&sim->error, TS_RANGE, &id.place,
			       "dump_modify: compute %s has no reference state to refresh; displace/atom has",
			       found->style->name);
	return copy_name(sim, dump, id.text, &d->refresh);
}

static enum ts_status set_maxfiles(struct tsim *sim, struct ts_dump_common *d, int64_t most,
				   const struct ts_place *where)
{
	if (most == 0 || (most > 0 && !strchr(d->file, '*')))
		return ts_fail(&sim->error, TS_RANGE, where,
			       "dump_modify: maxfiles %lld: expected a number > 0 for a dump whose file has "
			       "a `*`, or -1",
			       (long long)most);
	for (int64_t k = 0; k < d->nold; k++)
		ts_free(d->old[k]);
	ts_free(d->old);
	d->old = NULL;
	d->nold = 0;
	if (most < 0)
		return TS_OK;
	d->old = ts_alloc((size_t)most, sizeof *d->old);
	if (!d->old)
		return ts_nomem(&sim->error);
	d->nold = most;
	return TS_OK;
}

static void set_answer(bool *to, int answer)
{
	if (answer >= 0)
		*to = answer != 0;
}

static void set_answers(struct ts_dump_common *d, const struct ts_dump_changes *c)
{
	set_answer(&d->first, c->first);
	set_answer(&d->append, c->append);
	set_answer(&d->time, c->time);
	set_answer(&d->units, c->units);
	set_answer(&d->binary, c->binary);
	set_answer(&d->image, c->image);
	if (c->header >= 0)
		d->headless = !c->header;
	if (c->scale >= 0)
		d->plain = !c->scale;
	if (c->pad != INT64_MIN)
		d->pad = c->pad;
	if (c->delay != INT64_MIN)
		d->delay = c->delay;
}

/* LIGGGHTS, too, warns of keywords that do not change the frames of a dump. */
static void warn_without_effect(struct tsim *sim, const struct ts_instance *dump,
				const struct ts_dump_changes *c, const struct ts_place *where)
{
	const char *words = dump->style->dump_words ? dump->style->dump_words : "";
	const bool csv = ts_csv_is(((const struct ts_dump_common *)dump->state)->file);
	const struct {
		const char *word;
		bool given;
	} keyword[] = {
		{ "append", c->append > 0 },
		{ "binary", c->binary > 0 },
		{ "element", c->element.n },
		{ "format", c->format.n },
		{ "header", c->header == 0 },
		{ "image", c->image > 0 },
		{ "label", c->label },
		{ "refresh", c->refresh },
		{ "region", c->region },
		{ "scale", c->scale == 0 },
		{ "sort", c->sort && !ts_streq(c->sort, "id") },
		{ "thresh", c->thresh.n },
		{ "time", c->time > 0 },
		{ "units", c->units > 0 },
	};

	for (size_t k = 0; k < sizeof keyword / sizeof *keyword; k++)
		if (keyword[k].given && !ts_has_word(words, keyword[k].word))
			ts_warn(&sim->log, ts_sim_word_of(sim, keyword[k].word, where),
				"dump_modify: %s has no effect on dump %s", keyword[k].word,
				dump->style->name);
		else if (keyword[k].given && csv && ts_has_word("label units", keyword[k].word))
			ts_warn(&sim->log, ts_sim_word_of(sim, keyword[k].word, where),
				"dump_modify: %s has no effect on comma-separated values", keyword[k].word);
}

/* Keywords of the style itself. */
static enum ts_status modify_picture(struct tsim *sim, struct ts_instance *dump, struct ts_words words)
{
	size_t used;

	for (; words.n; words = ts_words_from(words, used)) {
		used = 0;
		if (dump->style->modify)
			TS_TRY(dump->style->modify(dump, sim, words, &used));
		if (used)
			continue;
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       dump->style->modify
				       ? "dump_modify: unexpected '%s'; dump %s has no such keyword, or the "
					 "keyword before it has fewer words"
				       : "dump_modify: %s is for pictures, which dump %s does not make",
			       words.word[0].text, dump->style->name);
	}
	return TS_OK;
}

enum ts_status ts_dump_modify(struct tsim *sim, struct ts_instance *dump, const struct ts_dump_changes *c,
			      const struct ts_place *where)
{
	struct ts_dump_common *d = dump->state;

	warn_without_effect(sim, dump, c, where);
	set_answers(d, c);
	if (c->element.n && ts_words_copy(&dump->arena, c->element, &d->element) != TS_OK)
		return ts_nomem(&sim->error);
	TS_TRY(modify_picture(sim, dump, c->picture));
	if (dump->style->init) /* `image` and `scale` change the columns */
		TS_TRY(dump->style->init(dump, sim));
	TS_TRY(set_every(sim, dump, &c->every, where));
	TS_TRY(set_sort(sim, d, c->sort, where));
	if (c->label)
		TS_TRY(copy_name(sim, dump, c->label, &d->label));
	if (c->region)
		TS_TRY(set_region(sim, dump, c->region, where));
	if (c->refresh)
		TS_TRY(set_refresh(sim, dump, c->refresh, where));
	if (c->maxfiles != INT64_MIN)
		TS_TRY(set_maxfiles(sim, d, c->maxfiles, where));
	TS_TRY(ts_dump_set_thresholds(dump, sim, c->thresh));
	TS_TRY(ts_formats_change(&d->formats, &sim->error, &dump->arena, "dump_modify", c->format,
				 d->ncolumns));
	return dump->style->init ? dump->style->init(dump, sim) : TS_OK;
}

struct modify {
	struct ts_dump_changes changes;
};
static const struct ts_arg modify_rows[] = { TS_DUMP_MODIFY_ROWS(struct modify), TS_ARGS_END };

enum ts_status ts_dump_modify_words(struct tsim *sim, const char *what, struct ts_instance *dump,
				    struct ts_words words, struct ts_arena *arena,
				    const struct ts_place *where)
{
	struct modify m = { 0 };

	TS_TRY(ts_args_parse(sim, what, modify_rows, words, where, arena, &m));
	return ts_dump_modify(sim, dump, &m.changes, where);
}
