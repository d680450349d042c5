#include "core/due_lists.h"

#include <stdio.h>
#include <string.h>

#include "base/name.h"

#include "base/banned.h"

enum {
	MOST = 256,	/* instances and variables that are followed; more than these: lists are read */
	MOST_NAME = 128 /* letters of the name of a variable or keyword */
};

struct search {
	const struct tsim *sim;
	const void *seen[MOST]; /* instances, words of variables */
	size_t n;
	bool found;
};

static void follow_text(void *data, const char *text);

/* Whether it has not been followed yet. */
static bool is_new(struct search *s, const void *what)
{
	for (size_t k = 0; k < s->n; k++)
		if (s->seen[k] == what)
			return false;
	if (s->n == MOST) {
		s->found = true;
		return false;
	}
	s->seen[s->n++] = what;
	return true;
}

static void follow_words(struct search *s, struct ts_words words)
{
	for (size_t k = 0; k < words.n && !s->found; k++)
		follow_text(s, words.word[k].text);
}

static void follow_instance(struct search *s, const struct ts_instance *inst)
{
	const struct ts_style *style = inst->style;

	if (!is_new(s, inst))
		return;
	s->found |= style->kind == TS_KIND_COMPUTE && !(style->ranks & TS_RANKS_PARTICLES);
	follow_words(s, inst->words);
	if (style->names)
		style->names(inst, follow_text, s);
}

static bool begins_with_name(const char *text, const char *name)
{
	const size_t n = strlen(name);

	return n && strncmp(text, name, n) == 0 && !ts_in_name(text[n]);
}

static void follow_instances(struct search *s, const char *text, enum ts_kind kind)
{
	const struct ts_instances *all = &s->sim->instances[kind];

	for (size_t k = 0; k < all->n && !s->found; k++)
		if (begins_with_name(text, all->item[k]->id))
			follow_instance(s, all->item[k]);
}

static void follow_variable(struct search *s, const char *name)
{
	const struct ts_script_api *api = s->sim->script_api;
	struct ts_words words;

	if (api && api->words_of_variable(s->sim->script_api_data, name, &words) && is_new(s, words.word))
		follow_words(s, words);
}

/* The output of a fix that needs all particles, as f_NAME. */
static void judge_fix(struct search *s, const char *text)
{
	const struct ts_instances *fixes = &s->sim->instances[TS_KIND_FIX];

	for (size_t k = 0; text[0] == 'f' && k < fixes->n; k++)
		if (begins_with_name(text + 2, fixes->item[k]->id))
			s->found |= fixes->item[k]->style->ranks & TS_RANKS_WHOLE &&
				    !(fixes->item[k]->style->ranks & TS_RANKS_PARTICLES);
}

/* Text that begins with a name behind a prefix, or is one. */
static void follow_name(struct search *s, const char *text)
{
	char name[MOST_NAME];
	size_t n = ts_name_length(text);

	s->found |= n >= sizeof name;
	if (!n || s->found)
		return;
	snprintf(name, sizeof name, "%.*s", (int)n, text);
	follow_instances(s, text, TS_KIND_COMPUTE);
	follow_instances(s, text, TS_KIND_FIX);
	follow_variable(s, name);
}

/* Text that begins with a word of a formula: a keyword, or the region of a function. */
static void follow_word(struct search *s, const char *text)
{
	const struct ts_tables *tables = s->sim->tables;

	for (const struct ts_system_style *const *t = tables->systems; *t; t++)
		for (const struct ts_keyword *k = (*t)->keywords; k && k->name; k++)
			s->found |= k->flags & TS_KEYWORD_LISTS && begins_with_name(text, k->name);
	follow_instances(s, text, TS_KIND_REGION);
}

static void follow_text(void *data, const char *text)
{
	struct search *s = data;

	follow_name(s, text); /* without a prefix: `chunk/atom` names computes so */
	for (size_t i = 0; text[i] && !s->found; i++) {
		char letter[2] = { text[i], '\0' };

		if (i && text[i - 1] == '$')
			follow_variable(s, letter); /* $x */
		if (i > 1 && text[i - 1] == '{' && text[i - 2] == '$')
			follow_name(s, &text[i]);
		if (i && ts_in_name(text[i - 1]))
			continue;
		follow_word(s, &text[i]);
		if (!strchr("cfv", text[i]) || text[i + 1] != '_')
			continue;
		judge_fix(s, &text[i]);
		follow_name(s, &text[i + 2]);
	}
}

/* What stands for thermo keywords. */
static void follow_standard(struct search *s)
{
	for (int k = 0; k < TS_NSTANDARD; k++)
		if (s->sim->standard[k])
			follow_text(s, s->sim->standard[k]);
}

static void follow_stage(struct search *s, const struct ts_plan *plan, enum ts_stage stage)
{
	for (size_t k = 0; k < plan->n[stage] && !s->found; k++) {
		const struct ts_instance *self = plan->actions[stage][k].self;

		if (self->style->ranks & TS_RANKS_WHOLE &&
		    (!self->style->due || self->style->due(self, s->sim)))
			follow_instance(s, self);
	}
}

/* Without any of these there is nothing to be named. */
static bool can_be_named(const struct tsim *sim)
{
	const struct ts_instances *computes = &sim->instances[TS_KIND_COMPUTE];

	if (sim->run.shows_lists)
		return true;
	for (size_t k = 0; k < computes->n; k++)
		if (!(computes->item[k]->style->ranks & TS_RANKS_PARTICLES))
			return true;
	return false;
}

/* Whether a fix maps positions at the end of a step: sums over contacts that were kept with the forces are those of other
 * positions. */
static bool moves_after_forces(const struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style->moves_by_time && fixes->item[k]->style->hook[TS_STAGE_END_OF_STEP])
			return true;
	return false;
}

bool ts_due_lists_named(const struct ts_plan *plan, const struct tsim *sim)
{
	struct search search = { .sim = sim };

	if (moves_after_forces(sim))
		return true;
	if (!can_be_named(sim))
		return false;
	if ((sim->recorder && sim->recorder->records(sim->recorder)) ||
	    sim->row_listener.call) /* may read anything */
		return true;
	follow_standard(&search);
	follow_stage(&search, plan, TS_STAGE_END_OF_STEP);
	follow_stage(&search, plan, TS_STAGE_OUTPUT);
	return search.found;
}
