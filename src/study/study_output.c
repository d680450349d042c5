#include "study/study_output.h"

#include <stdio.h>
#include <string.h>

#include "io/lines.h"

#include "base/banned.h"

static enum ts_status open_output(struct ts_lines *l, struct tsim *sim, const char *path)
{
	return ts_lines_open(l, &sim->files, &sim->error, sim->pool, &(struct ts_place){ 0 }, path);
}

static void join_words(const struct ts_lines *l, struct ts_str *out)
{
	ts_str_clear(out);
	for (size_t k = 0; k < l->nwords; k++)
		ts_str_addf(out, "%s%s", k ? " " : "", l->word[k]);
}

enum ts_status ts_study_output_error(struct tsim *sim, const char *path, struct ts_str *message)
{
	struct ts_lines l = { 0 };
	struct ts_str line = { 0 };
	bool more = true, found = false;
	enum ts_status status = open_output(&l, sim, path);

	while (status == TS_OK && !found) {
		status = ts_lines_next_filled(&l, &more);
		if (status != TS_OK || !more)
			break;
		join_words(&l, &line);
		found = strstr(ts_str_text(&line), "error:") || strstr(ts_str_text(&line), "ERROR");
		if (!found && strstr(ts_str_text(&line), "warning:"))
			continue;
		ts_str_clear(message);
		ts_str_add(message, ts_str_text(&line));
	}
	ts_lines_close(&l);
	ts_str_release(&line);
	return status;
}

/* Whether the output has this line. */
static enum ts_status find_line(struct tsim *sim, const char *path, const char *wanted, bool *found)
{
	struct ts_lines l = { 0 };
	struct ts_str line = { 0 };
	bool more = true;
	enum ts_status status = open_output(&l, sim, path);

	*found = false;
	while (status == TS_OK && !*found) {
		status = ts_lines_next_filled(&l, &more);
		if (status != TS_OK || !more)
			break;
		join_words(&l, &line);
		*found = ts_streq(ts_str_text(&line), wanted);
	}
	ts_lines_close(&l);
	ts_str_release(&line);
	return status;
}

enum ts_status ts_study_output_unused(struct tsim *sim, const char *path, const char *variable, bool *unused)
{
	struct ts_str wanted = { 0 };
	enum ts_status status;

	ts_str_addf(&wanted, "warning: variable '%s' was set from outside, but the script does not use it",
		    variable);
	status = find_line(sim, path, ts_str_text(&wanted), unused);
	ts_str_release(&wanted);
	return status;
}

enum ts_status ts_study_output_writes(struct tsim *sim, const char *path, bool *writes)
{
	return find_line(sim, path, "what it would write or change:", writes);
}

static enum ts_status read_study_line(struct ts_study_runs *runs, const struct ts_lines *l,
				      struct ts_error *err)
{
	for (size_t k = 1; k < l->nwords; k++) {
		char *equal = strchr(l->word[k], '='), numbered[32];

		snprintf(numbered, sizeof numbered, "STUDY_%zu", k);
		if (equal && equal > l->word[k]) {
			*equal = '\0';
			TS_TRY(ts_study_runs_set_result(runs, l->word[k], equal + 1, err));
		} else {
			TS_TRY(ts_study_runs_set_result(runs, numbered, l->word[k], err));
		}
	}
	return TS_OK;
}

static enum ts_status read_results(struct ts_study_runs *runs, struct ts_lines *l)
{
	bool more = true;

	for (;;) {
		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more)
			return TS_OK;
		if (ts_streq(l->word[0], "STUDY"))
			TS_TRY(read_study_line(runs, l, l->err));
		if (!ts_streq(l->word[0], "RESULT") || l->nwords < 3)
			continue;
		TS_TRY(ts_study_runs_set_result(runs, l->word[1], l->word[2], l->err));
		runs->run[runs->n - 1].off += ts_streq(l->word[l->nwords - 1], "off");
	}
}

enum ts_status ts_study_output_read(struct ts_study_runs *runs, struct tsim *sim, const char *path)
{
	struct ts_study_run *run = &runs->run[runs->n - 1];
	struct ts_lines l = { 0 };
	struct ts_str message = { 0 };
	enum ts_status status = open_output(&l, sim, path);

	if (status == TS_OK)
		status = read_results(runs, &l);
	ts_lines_close(&l);
	if (status == TS_OK && run->status) {
		status = ts_study_output_error(sim, path, &message);
		if (status == TS_OK && run->status > 128)
			ts_str_addf(&message, "%sended by signal %d", message.length ? "; " : "",
				    run->status - 128);
		if (status == TS_OK && !(run->error = ts_arena_strdup(&runs->arena, ts_str_text(&message))))
			status = ts_nomem(&sim->error);
		ts_str_release(&message);
	}
	return status;
}
