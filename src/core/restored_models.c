#include "core/restored_models.h"

#include <string.h>

#include "core/life.h"
#include "core/unclaimed_state.h"

#include "base/banned.h"

/* Defines the style; `lines` are cut at their ends. */
static enum ts_status define_again(struct tsim *sim, enum ts_kind kind, struct ts_str *lines)
{
	const struct ts_place *at = ts_sim_word(sim, 0, NULL);
	const struct ts_place place = at ? *at : (struct ts_place){ 0 };
	struct ts_word *word = ts_alloc(lines->length + 1, sizeof *word);
	size_t n = 0;
	enum ts_status status;

	if (!word)
		return ts_nomem(&sim->error);
	for (char *line = lines->text, *end = line; end; line = end + 1) {
		end = strchr(line, '\n');
		if (end)
			*end = '\0';
		word[n++] = (struct ts_word){ .text = line, .place = place };
	}
	ts_log(&sim->log, "Restoring %s_style %s from the restart file\n", ts_kind_name(kind), word[0].text);
	status = ts_sim_choose(sim, kind, (struct ts_words){ word, n }, &place);
	ts_free(word);
	return status;
}

enum ts_status ts_restore_models(struct tsim *sim)
{
	struct ts_str lines = { 0 };
	enum ts_status status;
	enum ts_kind kind;

	do {
		status = ts_unclaimed_model(sim, &kind, &lines);
		if (status == TS_OK && lines.length)
			status = define_again(sim, kind, &lines);
	} while (status == TS_OK && lines.length);
	ts_str_release(&lines);
	TS_TRY(status);
	ts_unclaimed_report(sim);
	return TS_OK;
}
