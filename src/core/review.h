/* The review of the scene: before the first step of a run, checks search for settings that are allowed but
 * most often a mistake.
 *
 * Each check is a function and a line of the table in review/table.c; styles have the slot `review` for
 * checks of their own. A finding is reported once, as a warning; the command `review` makes it an error or
 * switches the check off. Checks change nothing, and iterate over the particles at most once. A run that
 * resumes is not reviewed again. */
#ifndef TS_CORE_REVIEW_H
#define TS_CORE_REVIEW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

struct tsim;

struct ts_review_check {
	const char *name;			 /* for the command `review`; findings end with it */
	const char *summary;			 /* what it finds: for the manual */
	enum ts_status (*run)(struct tsim *sim); /* NULL: the check is in the slot `review` of styles */
	/* It reads contacts, and finds something if, and only if, it does so in the contacts of some particle. */
	bool contacts;
};

enum ts_review_answer { TS_REVIEW_WARN, TS_REVIEW_ERROR, TS_REVIEW_OFF };
enum { TS_REVIEW_MOST = 32 }; /* checks */

/* Part of struct tsim. */
struct ts_review {
	uint8_t answer[TS_REVIEW_MOST]; /* enum ts_review_answer of each check of the table */
	uint64_t *reported;		/* hashes (check, place) of the findings reported so far */
	size_t nreported, reported_capacity;
	uint64_t scene; /* hash of the place of the last `clear`: findings in another scene are others */
	bool made;	/* a run has been reviewed */
	bool stale;	/* -check, -explain: a run before this one was not stepped */
	bool doubtful;	/* -check: a line has failed, so that the scene is not the one intended; no review */
	int64_t steps;	/* of the run that begins */
	bool silent;	/* nothing is reported: a finding sets `found` */
	bool found;
};

/* Reviews the scene before the first step of a run of `steps` steps. */
enum ts_status ts_review_scene(struct tsim *sim, int64_t steps);
/* Executes the checks that read contacts, or those that do not, without those of styles, and sets review.found if the review
 * would say anything. */
enum ts_status ts_review_search(struct tsim *sim, int64_t steps, bool contacts);
/* Sets what a finding of the check does; name NULL: of all checks; false: there is no check of that name. */
bool ts_review_set(struct tsim *sim, const char *name, enum ts_review_answer answer);
/* Called by the command clear. */
void ts_review_begin_scene(struct tsim *sim);
void ts_review_release(struct ts_review *review);

/* Smallest overlap / smaller radius that is a finding. */
extern const double ts_review_depth;

/* Reports a finding, whose text says what was found, with numbers, and what to do. One finding of each
 * check is reported at each place; place NULL: it concerns the whole scene, and the place is the run
 * command. */
enum ts_status ts_review_report(struct tsim *sim, const char *check, const struct ts_place *where,
				const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif
