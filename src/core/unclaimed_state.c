#include "core/unclaimed_state.h"

#include <ctype.h>
#include <string.h>

#include "base/str.h"
#include "core/arg_change.h"
#include "core/group.h"
#include "core/sim.h"

#include "base/banned.h"

struct ts_unclaimed {
	struct ts_unclaimed *next;
	enum ts_kind kind;
	const char *style, *id, *group; /* owned by sim->pool */
	unsigned char *bytes;
	size_t n;
	bool reported;
};

static void unclaimed_free(struct ts_unclaimed *p)
{
	ts_free(p->bytes);
	ts_free(p);
}

enum ts_status ts_unclaimed_add(struct tsim *sim, enum ts_kind kind, const char *style, const char *id,
				const char *group, const unsigned char *bytes, size_t n)
{
	struct ts_unclaimed *p = ts_alloc(1, sizeof *p);

	if (!p)
		return ts_nomem(&sim->error);
	p->kind = kind;
	p->style = ts_pool_get(sim->pool, style);
	p->id = ts_pool_get(sim->pool, id);
	p->group = ts_pool_get(sim->pool, group);
	p->bytes = ts_alloc(n, 1);
	p->n = n;
	if (!p->style || !p->id || !p->group || !p->bytes) {
		unclaimed_free(p);
		return ts_nomem(&sim->error);
	}
	memcpy(p->bytes, bytes, n);
	p->next = sim->unclaimed;
	sim->unclaimed = p;
	return TS_OK;
}

/* Field of the arguments, before the state of a style. Files of version 1 do not have it. */
static const char arguments_field[] = "/arguments";
/* Of pair and bond styles: style and arguments as written, one a line, from which it can be made again. */
static const char words_field[] = "/words";

static bool is_made_again(enum ts_kind kind)
{
	return kind == TS_KIND_PAIR || kind == TS_KIND_BOND;
}

static enum ts_status write_words(struct tsim *sim, const struct ts_instance *inst,
				  struct ts_archive *archive)
{
	struct ts_str lines = { 0 };
	const char *text;
	enum ts_status status;

	ts_str_add(&lines, inst->style->name);
	for (size_t k = 0; k < inst->words.n; k++)
		ts_str_addf(&lines, "\n%s", inst->words.word[k].text);
	text = ts_str_text(&lines);
	status = lines.failed ? ts_nomem(&sim->error) : ts_archive_string(archive, words_field, &text);
	ts_str_release(&lines);
	return status;
}

enum ts_status ts_unclaimed_write(struct tsim *sim, struct ts_instance *inst, struct ts_archive *archive)
{
	struct ts_str lines = { 0 };
	const char *text;
	enum ts_status status = TS_OK;

	ts_args_lines(sim, inst->style->args, inst->state, &lines);
	text = ts_str_text(&lines);
	if (lines.failed)
		status = ts_nomem(&sim->error);
	else if (inst->style->kind != TS_KIND_DUMP) /* state of a dump is valid with other arguments, too */
		status = ts_archive_string(archive, arguments_field, &text);
	ts_str_release(&lines);
	if (status == TS_OK && is_made_again(inst->style->kind))
		status = write_words(sim, inst, archive);
	return status == TS_OK ? ts_archive_instance(archive, inst, sim) : status;
}

static enum ts_status check_arguments(struct tsim *sim, struct ts_instance *inst, const char *what,
				      struct ts_archive *archive, struct ts_words args)
{
	struct ts_str changes = { 0 };
	const char *lines;
	enum ts_status status;

	if (!ts_archive_has(archive, arguments_field))
		return TS_OK;
	TS_TRY(ts_archive_string(archive, arguments_field, &lines));
	status = ts_args_changes(sim, inst, what, lines, args, &changes);
	if (status == TS_OK && changes.length)
		ts_log(&sim->log, "%s, changed since the restart file: %s\n", what, ts_str_text(&changes));
	ts_str_release(&changes);
	return status;
}

static enum ts_status restore_instance(struct tsim *sim, struct ts_instance *inst,
				       const struct ts_unclaimed *p, const char *what, struct ts_words args)
{
	struct ts_archive *archive = ts_archive_new(sim, false);
	const char *kind = ts_kind_name(p->kind);
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = ts_archive_from(archive, p->bytes, p->n);
	if (status == TS_OK)
		status = check_arguments(sim, inst, what, archive, args);
	if (status == TS_OK)
		status = ts_archive_instance(archive, inst, sim);
	ts_archive_free(archive);
	if (status == TS_OK)
		ts_log(&sim->log, "Resetting global state of %c%s %s%sStyle %s from restart file info\n",
		       toupper((unsigned char)kind[0]), kind + 1, p->id, *p->id ? " " : "", p->style);
	return status;
}

/* State of a fix or compute is valid only for the same style and group. A dump saves only its frame
 * counter, and pair, bond and flow have no id: the script may replace them by other styles. */
static enum ts_status check_identity(struct tsim *sim, const struct ts_instance *inst,
				     const struct ts_unclaimed *p, const char *what)
{
	static const char hint[] = "the saved state is valid only with that; use it again, or give another "
				   "id to start without that state";
	const char *group = ts_group_name(sim, inst->group);

	if (p->kind != TS_KIND_FIX && p->kind != TS_KIND_COMPUTE)
		return TS_OK;
	if (ts_style_find(sim->tables, p->kind, p->style) != inst->style)
		return ts_fail(&sim->error, TS_STATE, &inst->where,
			       "%s: in the restart file this id is of style %s, and %s", what, p->style,
			       hint);
	if (!ts_streq(p->group, group))
		return ts_fail(&sim->error, TS_STATE, &inst->where,
			       "%s: its group is '%s' here but '%s' in the restart file, and %s", what, group,
			       p->group, hint);
	return TS_OK;
}

bool ts_unclaimed_exists(const struct tsim *sim, const struct ts_instance *inst)
{
	for (const struct ts_unclaimed *p = sim->unclaimed; p; p = p->next)
		if (p->kind == inst->style->kind && ts_streq(p->id, inst->id))
			return true;
	return false;
}

enum ts_status ts_unclaimed_apply(struct tsim *sim, struct ts_instance *inst, struct ts_words args)
{
	struct ts_unclaimed **p = &sim->unclaimed, *found;
	enum ts_status status;
	char what[256];

	while (*p && ((*p)->kind != inst->style->kind || !ts_streq((*p)->id, inst->id)))
		p = &(*p)->next;
	found = *p;
	if (!found)
		return TS_OK;
	snprintf(what, sizeof what, "%s %s%s(%s)", ts_kind_name(found->kind), inst->id, *inst->id ? " " : "",
		 inst->style->name);
	TS_TRY(check_identity(sim, inst, found, what));
	if (ts_style_find(sim->tables, found->kind, found->style) != inst->style) {
		ts_log(&sim->log, "%s, changed since the restart file: it was of style %s\n", what,
		       found->style);
		return TS_OK;
	}
	status = restore_instance(sim, inst, found, what, args);
	*p = found->next;
	unclaimed_free(found);
	return status;
}

enum ts_status ts_unclaimed_apply_earlier(struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		TS_TRY(ts_unclaimed_apply(sim, fixes->item[k], fixes->item[k]->words));
	return TS_OK;
}

bool ts_unclaimed_is_model(enum ts_kind kind)
{
	return kind == TS_KIND_PAIR || kind == TS_KIND_BOND || kind == TS_KIND_FLOW;
}

void ts_unclaimed_waive(struct tsim *sim, enum ts_kind kind)
{
	for (struct ts_unclaimed *p = sim->unclaimed; p; p = p->next)
		if (p->kind == kind)
			p->reported = true;
}

static bool is_defined(const struct tsim *sim, enum ts_kind kind)
{
	return sim->instances[kind].n > 0;
}

/* Reads the words of the style; nothing is added if the file is of an older version. */
static enum ts_status read_words(struct tsim *sim, const struct ts_unclaimed *p, struct ts_str *lines)
{
	struct ts_archive *archive = ts_archive_new(sim, false);
	const char *text;
	enum ts_status status;

	if (!archive)
		return ts_nomem(&sim->error);
	status = ts_archive_from(archive, p->bytes, p->n);
	if (status == TS_OK && ts_archive_has(archive, words_field)) {
		status = ts_archive_string(archive, words_field, &text);
		if (status == TS_OK)
			ts_str_add(lines, text);
	}
	ts_archive_free(archive);
	return lines->failed ? ts_nomem(&sim->error) : status;
}

enum ts_status ts_unclaimed_model(struct tsim *sim, enum ts_kind *kind, struct ts_str *lines)
{
	ts_str_clear(lines);
	for (struct ts_unclaimed *p = sim->unclaimed; p; p = p->next) {
		if (p->reported || !ts_unclaimed_is_model(p->kind) || is_defined(sim, p->kind))
			continue;
		p->reported = true;
		*kind = p->kind;
		if (is_made_again(p->kind))
			TS_TRY(read_words(sim, p, lines));
		if (lines->length)
			return TS_OK;
		ts_warn(&sim->log, NULL,
			"the restart file was written with %s_style %s, which is not defined again: this "
			"run is without it",
			ts_kind_name(p->kind), p->style);
	}
	return TS_OK;
}

void ts_unclaimed_report(struct tsim *sim)
{
	const char *before = "Saved in the restart file, but not defined again so far: ";

	for (struct ts_unclaimed *p = sim->unclaimed; p; p = p->next) {
		if (p->reported || (p->kind != TS_KIND_FIX && p->kind != TS_KIND_COMPUTE))
			continue;
		p->reported = true;
		ts_log(&sim->log, "%s%s %s (%s)", before, ts_kind_name(p->kind), p->id, p->style);
		before = ", ";
	}
	if (*before == ',')
		ts_log(&sim->log, "\n");
}

void ts_unclaimed_free(struct tsim *sim)
{
	while (sim->unclaimed) {
		struct ts_unclaimed *p = sim->unclaimed;

		sim->unclaimed = p->next;
		unclaimed_free(p);
	}
}
