/* State of variables in restart files: values of style once, and positions in files read during runs. */
#include <stdio.h>
#include <string.h>

#include "formula/formulas.h"

#include "base/banned.h"

static const char list_field[] = "variables";

/* Name of a field of one variable; `what` is style, text or number. */
static void field_name(char *to, size_t size, const char *what, const char *name)
{
	snprintf(to, size, "%s of %s", what, name);
}

static enum ts_status archive_one(struct ts_archive *archive, struct ts_variable_state *state)
{
	char field[160];

	field_name(field, sizeof field, "style", state->name);
	TS_TRY(ts_archive_string(archive, field, &state->style));
	field_name(field, sizeof field, "text", state->name);
	TS_TRY(ts_archive_string(archive, field, &state->text));
	field_name(field, sizeof field, "number", state->name);
	return ts_archive_fixed(archive, field, TS_SAVED_F64, &state->number, 1);
}

static bool is_saved(const struct ts_variable *variable, double *number)
{
	return variable->style->save && strlen(variable->name) < 128 &&
	       variable->style->save(variable, number);
}

static enum ts_status write_states(struct ts_formulas *formulas, struct ts_archive *archive)
{
	struct ts_str names = { 0 };
	const char *list;
	double number;
	enum ts_status status;

	ts_variables_compact(formulas);
	for (size_t k = 0; k < formulas->variables.n; k++)
		if (is_saved(formulas->variables.item[k], &number))
			ts_str_addf(&names, "%s ", formulas->variables.item[k]->name);
	list = ts_str_text(&names);
	status = names.failed ? ts_nomem(&formulas->sim->error)
			      : ts_archive_string(archive, list_field, &list);
	ts_str_release(&names);
	for (size_t k = 0; k < formulas->variables.n && status == TS_OK; k++) {
		const struct ts_variable *v = formulas->variables.item[k];
		struct ts_variable_state state = { v->style->name, v->name, "", 0 };

		if (!is_saved(v, &state.number))
			continue;
		state.text = v->values.word[0].text;
		status = archive_one(archive, &state);
	}
	return status;
}

static bool matches_variable(const struct ts_variable_state *state, const struct ts_variable *variable)
{
	return ts_streq(state->name, variable->name) && ts_streq(state->style, variable->style->name) &&
	       ts_streq(state->text, variable->values.word[0].text);
}

enum ts_status ts_variable_resume(struct ts_formulas *formulas, struct ts_variable *variable, bool *resumed)
{
	size_t k = (size_t)(uintptr_t)ts_map_get(&formulas->waiting_at, variable->name);

	*resumed = k && matches_variable(&formulas->waiting[k - 1], variable);
	if (!*resumed)
		return TS_OK;
	ts_map_remove(&formulas->waiting_at, variable->name);
	return variable->style->restore(formulas, variable, formulas->waiting[k - 1].number);
}

static enum ts_status read_state(struct ts_formulas *formulas, struct ts_archive *archive, const char *name)
{
	struct ts_variable_state state = { .name = name };
	struct ts_variable *variable = ts_variable_find(formulas, name);
	bool resumed;

	TS_TRY(archive_one(archive, &state));
	if (TS_GROW(formulas->waiting, formulas->waiting_capacity, formulas->nwaiting + 1) != TS_OK)
		return ts_nomem(&formulas->sim->error);
	formulas->waiting[formulas->nwaiting++] = state;
	if (ts_map_set(&formulas->waiting_at, name, (void *)(uintptr_t)formulas->nwaiting) != TS_OK)
		return ts_nomem(&formulas->sim->error);
	return variable && variable->style->restore ? ts_variable_resume(formulas, variable, &resumed)
						    : TS_OK;
}

static enum ts_status read_states(struct ts_formulas *formulas, struct ts_archive *archive)
{
	struct ts_arena arena = { 0 };
	struct ts_words names = { 0 };
	struct ts_place nowhere = { 0 };
	const char *list;
	enum ts_status status;

	formulas->nwaiting = 0;
	ts_map_release(&formulas->waiting_at);
	if (!ts_archive_has(archive, list_field))
		return TS_OK;
	TS_TRY(ts_archive_string(archive, list_field, &list));
	status = ts_words_split(&arena, list, &nowhere, &names) == TS_OK ? TS_OK
									 : ts_nomem(&formulas->sim->error);
	for (size_t k = 0; k < names.n && status == TS_OK; k++) {
		const char *name = ts_pool_get(formulas->sim->pool, names.word[k].text);

		status = name ? read_state(formulas, archive, name) : ts_nomem(&formulas->sim->error);
	}
	ts_arena_release(&arena);
	return status;
}

enum ts_status ts_variables_archive(struct ts_formulas *formulas, struct ts_archive *archive)
{
	return ts_archive_writing(archive) ? write_states(formulas, archive) : read_states(formulas, archive);
}
