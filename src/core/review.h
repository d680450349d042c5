/* The review of the scene: before the first step of a run, checks look for what is allowed but most
 * often a mistake.
 *
 * Each check is a function and a line of the table in review/table.c; styles that know more of
 * themselves have the slot `review`. A finding is told once, as a warning; the command `review`
 * makes it an error or leaves the check out. Checks change nothing, and go through the particles
 * once at most: they come when a run begins, and not when it only goes on. */
#ifndef TS_CORE_REVIEW_H
#define TS_CORE_REVIEW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct tsim;

struct ts_review_check {
	const char *name;    /* as the command `review` takes it, and as findings end with */
	const char *summary; /* what it finds: for the manual */
	enum ts_status (*look)(struct tsim *sim); /* NULL: styles tell it */
};

enum ts_review_answer { TS_REVIEW_WARN, TS_REVIEW_ERROR, TS_REVIEW_OFF };
enum { TS_REVIEW_MOST = 32 }; /* checks */

/* Part of struct tsim. */
struct ts_review {
	uint8_t answer[TS_REVIEW_MOST]; /* enum ts_review_answer of each check of the table */
	uint64_t *told;			/* findings so far, by check and place */
	size_t ntold, told_capacity;
	bool made;     /* there has been one */
	bool stale;    /* -check, -explain: a run before this one was not stepped */
	bool doubtful; /* -check: a line has failed, so that the scene is not what was meant */
	int64_t steps; /* of the run that begins */
};

/* Before the first step of a run of so many steps. */
enum ts_status ts_review_scene(struct tsim *sim, int64_t steps);
/* Sets the answer of the check of that name, NULL: of all; false: there is none of that name. */
bool ts_review_set(struct tsim *sim, const char *name, enum ts_review_answer answer);
void ts_review_release(struct ts_review *review);

/* A finding: a number, where, and what to do. Of the same check at the same place it is told once;
 * place NULL: it is about the whole scene, and shown at the run. */
enum ts_status ts_review_report(struct tsim *sim, const char *check, const struct ts_place *where,
				const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif
