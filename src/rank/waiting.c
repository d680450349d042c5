#include "rank/waiting.h"

#include <sched.h>
#include <stddef.h>
#include <strings.h>
#include <time.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "base/clock.h"

#include "base/banned.h"

/* A wait is long after LONG s. If others have had the processor for TAKEN s when it was offered, they compute: for the next
 * SHARED s no more is asked. */
static const double LONG = 1e-3, TAKEN = 1e-4, SHARED = 2e-2;
static const struct timespec NAP = { 0, 30000 }; /* ns */

struct ts_waiting ts_waiting_policy(const char *word)
{
	return (struct ts_waiting){ .passive = word && strcasecmp(word, "passive") == 0 };
}

void ts_waiting_be_exact(const struct ts_waiting *w)
{
#ifdef PR_SET_TIMERSLACK
	if (w->passive)
		prctl(PR_SET_TIMERSLACK, 1);
#else
	(void)w;
#endif
}

void ts_waiting_offer(struct ts_waiting *w, bool first)
{
	double now;

	if (!w->passive) {
		sched_yield();
		return;
	}
	now = ts_clock();
	if (first)
		w->begun = now;
	if (now < w->shared_until || now - w->begun > LONG) {
		nanosleep(&NAP, NULL);
		return;
	}
	sched_yield();
	if (ts_clock() - now > TAKEN)
		w->shared_until = now + SHARED;
}
