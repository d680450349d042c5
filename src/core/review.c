#include "core/review.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/hash.h"
#include "core/sim.h"

#include "base/banned.h"

/* Overlaps under load are rarely more than 1 % of the radius. */
const double ts_review_depth = 0.05;

static int find_check(const struct tsim *sim, const char *name)
{
	for (int k = 0; k < TS_REVIEW_MOST && sim->tables->checks[k].name; k++)
		if (ts_streq(sim->tables->checks[k].name, name))
			return k;
	return -1;
}

bool ts_review_set(struct tsim *sim, const char *name, enum ts_review_answer answer)
{
	int only = name ? find_check(sim, name) : -1;

	if (name && only < 0)
		return false;
	for (int k = 0; k < TS_REVIEW_MOST; k++)
		if (!name || k == only)
			sim->review.answer[k] = (uint8_t)answer;
	return true;
}

void ts_review_release(struct ts_review *review)
{
	ts_free(review->reported);
	*review = (struct ts_review){ 0 };
}

/* ---- findings ---- */

static uint64_t cause_of(uint64_t scene, const char *check, const struct ts_place *where, const char *format)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_add(&hash, &scene, sizeof scene);
	ts_hash_text(&hash, check);
	ts_hash_text(&hash, where && where->file ? where->file : "");
	ts_hash_add(&hash, where ? &where->line : &(int){ 0 }, sizeof where->line);
	ts_hash_text(&hash, format);
	return ts_hash_value(&hash);
}

/* The same line may clear several scenes in a loop: these are one. */
void ts_review_begin_scene(struct tsim *sim)
{
	sim->review.scene = cause_of(0, "clear", ts_sim_word(sim, 0, NULL), "");
}

static bool is_reported(const struct ts_review *r, uint64_t cause)
{
	for (size_t k = 0; k < r->nreported; k++)
		if (r->reported[k] == cause)
			return true;
	return false;
}

/* Records a finding; *new: it has not been reported before. */
static enum ts_status record_finding(struct tsim *sim, uint64_t cause, bool *new)
{
	struct ts_review *r = &sim->review;

	*new = !is_reported(r, cause);
	if (!*new)
		return TS_OK;
	if (TS_GROW(r->reported, r->reported_capacity, r->nreported + 1) != TS_OK)
		return ts_nomem(&sim->error);
	r->reported[r->nreported++] = cause;
	return TS_OK;
}

enum ts_status ts_review_report(struct tsim *sim, const char *check, const struct ts_place *where,
				const char *format, ...)
{
	uint64_t cause = cause_of(sim->review.scene, check, where, format);
	int k = find_check(sim, check);
	char text[900];
	va_list args;
	bool new = true;

	if (k < 0 || sim->review.answer[k] == TS_REVIEW_OFF)
		return TS_OK;
	if (!where)
		where = ts_sim_word(sim, 0, NULL);
	if (sim->review.silent) {
		sim->review.found |=
			sim->review.answer[k] == TS_REVIEW_ERROR || !is_reported(&sim->review, cause);
		return TS_OK;
	}
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	TS_TRY(record_finding(sim, cause, &new));
	if (sim->review.answer[k] == TS_REVIEW_ERROR && (new || !sim->reading.check))
		return ts_fail_at(&sim->error, TS_STATE, where, check, 0, "%s (review: %s)", text, check);
	if (new)
		ts_warn(&sim->log, where, "%s (review: %s)", text, check);
	return TS_OK;
}

/* ---- the review ---- */

/* Calls the reviews of all styles, or of those with these flags. */
static enum ts_status review_styles(struct tsim *sim, unsigned with)
{
	for (int kind = 0; kind < TS_NKIND; kind++) {
		const struct ts_instances *list = &sim->instances[kind];

		for (size_t k = 0; k < list->n; k++) {
			struct ts_instance *inst = list->item[k];

			if (inst->style->review && (inst->style->ranks & with) == with)
				TS_TRY(ts_sim_defer_error(sim, inst->style->review(inst, sim)));
		}
	}
	return TS_OK;
}

/* A run that resumes is not reviewed again. */
static bool is_due(const struct tsim *sim)
{
	return !(sim->run.resuming && sim->review.made) && !sim->review.doubtful;
}

enum ts_status ts_review_search(struct tsim *sim, int64_t steps, bool contacts)
{
	struct ts_review *r = &sim->review;
	enum ts_status status = TS_OK;

	if (!is_due(sim))
		return TS_OK;
	r->steps = steps;
	r->silent = true;
	for (int k = 0; sim->tables->checks[k].name && status == TS_OK; k++) {
		const struct ts_review_check *check = &sim->tables->checks[k];

		if (check->run && check->contacts == contacts && r->answer[k] != TS_REVIEW_OFF)
			status = check->run(sim);
	}
	if (status == TS_OK && !contacts)
		status = review_styles(sim, TS_RANKS_REVIEW);
	r->silent = false;
	return status;
}

enum ts_status ts_review_scene(struct tsim *sim, int64_t steps)
{
	struct ts_review *r = &sim->review;

	if (!is_due(sim))
		return TS_OK;
	r->steps = steps;
	for (int k = 0; sim->tables->checks[k].name; k++)
		if (sim->tables->checks[k].run && r->answer[k] != TS_REVIEW_OFF)
			TS_TRY(ts_sim_defer_error(sim, sim->tables->checks[k].run(sim)));
	TS_TRY(review_styles(sim, 0));
	r->made = true;
	r->stale = r->stale || (sim->reading.explain && steps > 0);
	return TS_OK;
}
